//! The integration tests, one binary: each module checks one part of the program from outside.

#[cfg(test)]
mod aircraft;
#[cfg(test)]
mod fleet;
#[cfg(test)]
mod fmu;
#[cfg(test)]
mod support;
#[cfg(test)]
mod tidy;
#[cfg(test)]
mod verification;
