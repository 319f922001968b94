//! `flexair import`: aircraft of other programs as aircraft files.

use clap::{Args, Subcommand};

pub mod nastran;

use crate::outcome::Outcome;

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

/// Reads, writes, and says what it made of it.
pub fn run(options: &ImportOptions) -> Result<Outcome, nastran::Error> {
    match &options.from {
        From::Nastran(options) => nastran::run(options),
    }
}
