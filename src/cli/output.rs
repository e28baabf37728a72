//! Results to stdout, progress to a terminal, and what ends a command early.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use shading_lab::document::{LoadError, SaveError};
use shading_lab::text::text;
use std::fmt::Display;
use std::io::{self, IsTerminal, Write};
use std::process::ExitCode;

/// Why a command did not do what it was asked for.
#[derive(Debug)]
pub enum Failure {
    /// The input is at fault; a line for each problem.
    Input(String),
    /// The input is sound, but it could not be done.
    Work(String),
    /// Nobody reads the output any more, which ends the work without fuss.
    Closed,
}

impl Failure {
    pub fn input(message: impl Display) -> Self {
        Self::Input(message.to_string())
    }

    pub fn work(message: impl Display) -> Self {
        Self::Work(message.to_string())
    }

    /// Writes the problems to stderr and chooses the exit status.
    pub fn report(&self) -> ExitCode {
        let (message, status) = match self {
            Self::Input(message) => (message, 2),
            Self::Work(message) => (message, 1),
            Self::Closed => return ExitCode::SUCCESS,
        };
        let lines: String = message
            .lines()
            .map(|line| text!("cli-error", message = line) + "\n")
            .collect();
        // Without stderr there is nowhere to say so.
        let _ = io::stderr().write_all(lines.as_bytes());
        ExitCode::from(status)
    }
}

impl From<LoadError> for Failure {
    fn from(error: LoadError) -> Self {
        Self::input(error)
    }
}

impl From<SaveError> for Failure {
    fn from(error: SaveError) -> Self {
        match &error {
            SaveError::Unwritable { source, .. } if source.kind() == io::ErrorKind::BrokenPipe => {
                Self::Closed
            }
            SaveError::Nothing { .. } => Self::input(error),
            _ => Self::work(error),
        }
    }
}

/// Writes `text` to stdout.
pub fn print(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    out.write_all(text.as_bytes())
        .and_then(|()| out.flush())
        .map_err(|error| match error.kind() {
            io::ErrorKind::BrokenPipe => Failure::Closed,
            _ => Failure::work(text!("cli-output-unwritable", error = error.to_string())),
        })
}

/// A bar on stderr, or nothing where that is no terminal.
pub fn progress_bar(total: u64, doing: &'static str) -> ProgressBar {
    let visible = io::stderr().is_terminal();
    let target = if visible {
        ProgressDrawTarget::stderr()
    } else {
        ProgressDrawTarget::hidden()
    };
    let bar = ProgressBar::with_draw_target(Some(total), target).with_message(doing);
    let style = ProgressStyle::with_template("{msg} {wide_bar} {percent} % {eta}");
    bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}
