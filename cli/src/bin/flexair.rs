//! The program `flexair`: the library's command line with the arguments that the shell gives.

use std::process::ExitCode;

use flexair::home::Home;

fn main() -> ExitCode {
    ExitCode::from(flexair::command(std::env::args_os(), &Home::of_program()))
}
