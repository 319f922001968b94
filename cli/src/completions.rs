//! `flexair completions`: what shells need to complete commands and options.

use clap::{Args, Command};
use clap_complete::Shell;
use flexible_aircraft_packaging::FileError;

use crate::terminal;

/// Options of `flexair completions`.
#[derive(Args)]
#[command(after_help = "Example: for bash, now and for later
  source <(flexair completions bash)
  flexair completions bash > ~/.local/share/bash-completion/completions/flexair")]
pub struct CompletionsOptions {
    /// Which shell
    #[arg(value_enum)]
    shell: Shell,
}

/// Prints the script for a command line.
pub fn run(options: &CompletionsOptions, mut command: Command) -> Result<(), FileError> {
    let (name, mut script) = (command.get_name().to_owned(), Vec::new());
    clap_complete::generate(options.shell, &mut command, name, &mut script);
    terminal::print(&String::from_utf8_lossy(&script))
}
