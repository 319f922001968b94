//! The integration tests, one binary: each module checks one part of the program from outside.

#[cfg(test)]
mod aircraft;
mod fmu;
mod tidy;
