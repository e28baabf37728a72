//! What ends the program early, and with which status.

use crate::document::{LoadError, SaveError};
use crate::scene::SceneError;
use std::fmt::Display;
use std::io;
use std::process::ExitCode;

/// An error on its way to stderr.
#[derive(Debug)]
pub(super) enum Failure {
    /// Lines to print, and the exit status.
    Error { text: String, status: u8 },
    /// Whoever read our output has stopped; there is nobody to tell.
    Unread,
}

impl Failure {
    /// The input is at fault.
    pub fn input(error: &impl Display) -> Self {
        Self::Error { text: error.to_string(), status: 2 }
    }

    /// Something else failed.
    pub fn other(error: &impl Display) -> Self {
        Self::Error { text: error.to_string(), status: 1 }
    }

    /// Prints the error, a line for each problem.
    pub fn report(self) -> ExitCode {
        match self {
            Self::Unread => ExitCode::SUCCESS,
            Self::Error { text, status } => {
                for line in text.lines() {
                    eprintln!("error: {line}");
                }
                ExitCode::from(status)
            }
        }
    }
}

impl From<LoadError> for Failure {
    fn from(error: LoadError) -> Self {
        Self::input(&error)
    }
}

impl From<SceneError> for Failure {
    fn from(error: SceneError) -> Self {
        Self::input(&error)
    }
}

impl From<SaveError> for Failure {
    fn from(error: SaveError) -> Self {
        Self::other(&error)
    }
}

impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        if error.kind() == io::ErrorKind::BrokenPipe { Self::Unread } else { Self::other(&error) }
    }
}

/// Help and version are no errors; wrong arguments are bad input.
pub(super) fn usage(error: &clap::Error) -> Result<(), Failure> {
    if error.use_stderr() {
        let text = error.to_string();
        Err(Failure::Error { text: text.strip_prefix("error: ").unwrap_or(&text).replace("\n\n", "\n"), status: 2 })
    } else {
        error.print().map_err(Failure::from)
    }
}
