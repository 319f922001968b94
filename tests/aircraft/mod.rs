//! The aircraft file: the shipped jet expands to the recorded numbers, and bad files are told apart.

mod bad_files;
mod jet;
