//! The program: a window, or one command.

mod cli;

use std::process::ExitCode;

fn main() -> ExitCode {
    cli::run()
}
