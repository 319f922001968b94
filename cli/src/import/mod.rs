//! `flexair import`: aircraft of other programs as aircraft files.

use clap::{Args, Subcommand};

pub mod nastran;

/// Options of `flexair import`.
#[derive(Args)]
pub struct ImportOptions {
    #[command(subcommand)]
    from: From,
}

#[derive(Subcommand)]
enum From {
    /// A stick model in Nastran bulk data: beams, masses, rigid links, panels and control surfaces
    Nastran(nastran::NastranOptions),
}

/// How an import ended that wrote a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// All that describes the aircraft is in the file.
    Clean,
    /// Something is not, or is there differently, as the report says.
    WithReports,
}

/// Reads, writes, and says what it made of it.
pub fn run(options: &ImportOptions) -> Result<Outcome, nastran::Error> {
    match &options.from {
        From::Nastran(options) => nastran::run(options),
    }
}
