//! The program: a window, or one command.

use std::process::ExitCode;

fn main() -> ExitCode {
    shading_lab::cli::main()
}
