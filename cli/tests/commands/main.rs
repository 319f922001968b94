//! The command line from outside: the program is run as people run it.

#[cfg(test)]
mod before_work;
#[cfg(test)]
mod check;
#[cfg(test)]
mod closed_output;
#[cfg(test)]
mod continuous;
#[cfg(test)]
mod describe;
#[cfg(test)]
mod files;
#[cfg(test)]
mod fleet;
#[cfg(test)]
mod gltf;
#[cfg(test)]
mod gust;
#[cfg(test)]
mod import;
#[cfg(test)]
mod installed;
#[cfg(test)]
mod joints;
#[cfg(test)]
mod linearise;
#[cfg(test)]
mod loads;
#[cfg(test)]
mod new;
#[cfg(test)]
mod package;
#[cfg(test)]
mod simulate;
#[cfg(test)]
mod support;
#[cfg(test)]
mod sweep;
#[cfg(test)]
mod trim;
#[cfg(test)]
mod view;
