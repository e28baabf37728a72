//! Results on stdout, progress on a terminal, and the errors that end a command early.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressFinish, ProgressStyle};
use shading_lab::document::{LoadError, STDOUT, SaveError, write_whole};
use shading_lab::text::{escaped, escaped_json, text};
use std::fmt::Display;
use std::io::{self, IsTerminal, Write};
use std::path::Path;
use std::process::ExitCode;
use std::time::Duration;

/// Interval at which a bar shows that the work continues.
const TICK: Duration = Duration::from_millis(120);

/// The reason why a command failed.
#[derive(Debug)]
pub enum Failure {
    /// The input is at fault; one line for each problem.
    Input(String),
    /// The input is valid, but the work failed.
    Work(String),
    /// The reader has closed the output, which ends the work silently.
    Closed,
}

impl Failure {
    pub fn input(message: impl Display) -> Self {
        Self::Input(message.to_string())
    }

    pub fn work(message: impl Display) -> Self {
        Self::Work(message.to_string())
    }

    /// Writes the problems to stderr and returns the exit status.
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
        tell(&lines);
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

impl From<io::Error> for Failure {
    /// Converts an error of the standard output.
    fn from(error: io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::BrokenPipe => Self::Closed,
            _ => Self::work(text!("cli-output-unwritable", error = error.to_string())),
        }
    }
}

/// Writes text to stdout, with control characters escaped.
pub fn print(text: &str) -> Result<(), Failure> {
    written(&escaped(text))
}

/// Writes a JSON object to stdout, for programs, with control characters as JSON escapes.
pub fn print_json(json: &str) -> Result<(), Failure> {
    written(&escaped_json(json))
}

fn written(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    out.write_all(text.as_bytes())?;
    Ok(out.flush()?)
}

/// Writes a text file, whole or not at all.
pub fn write_text(target: &Path, text: &str) -> Result<(), Failure> {
    Ok(write_whole(target, |out| out.write_all(text.as_bytes()))?)
}

/// Writes help to stdout, with colours if the terminal has them.
pub fn print_help(help: &clap::Error) -> Result<(), Failure> {
    help.print()?;
    Ok(io::stdout().flush()?)
}

/// Writes a message for people to stderr, with control characters escaped.
fn tell(text: &str) {
    // If stderr fails, there is nowhere to report it.
    let _ = io::stderr().write_all(escaped(text).as_bytes());
}

/// Refuses to write a picture to a terminal, which would interpret its bytes as commands.
pub fn check_picture_target(path: &Path) -> Result<(), Failure> {
    if path == Path::new(STDOUT) && io::stdout().is_terminal() {
        return Err(Failure::input(text!("cli-picture-on-terminal")));
    }
    Ok(())
}

/// Writes a note to stderr, beside complete results.
pub fn note(message: &str) {
    tell(&(text!("cli-note", message = message) + "\n"));
}

/// Returns a progress bar on stderr until it is dropped, hidden if that is no terminal.
pub fn progress_bar(total: u64, doing: &'static str) -> ProgressBar {
    shown(Some(total), doing, "{msg} {wide_bar} {percent} % {eta}")
}

/// Returns a progress bar for work of unknown length.
pub fn spinner(doing: &'static str) -> ProgressBar {
    shown(None, doing, "{spinner} {msg} {elapsed}")
}

fn shown(total: Option<u64>, doing: &'static str, template: &str) -> ProgressBar {
    if !io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template(template);
    let bar = ProgressBar::with_draw_target(total, ProgressDrawTarget::stderr())
        .with_message(doing)
        .with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
        .with_finish(ProgressFinish::AndClear);
    bar.enable_steady_tick(TICK);
    bar
}

/// Returns the number of characters of the longest of some words, to align what follows them.
pub fn widest(words: impl Iterator<Item = impl AsRef<str>>) -> usize {
    words
        .map(|word| word.as_ref().chars().count())
        .max()
        .unwrap_or(0)
}

/// Returns the number of terminal columns that a text takes; Chinese characters take two.
pub fn columns(text: &str) -> usize {
    text.chars().map(|c| 1 + usize::from(is_wide(c))).sum()
}

pub fn is_wide(c: char) -> bool {
    matches!(c, '\u{1100}'..='\u{115f}' | '\u{2e80}'..='\u{a4cf}' | '\u{ac00}'..='\u{d7a3}' | '\u{f900}'..='\u{faff}'
        | '\u{fe30}'..='\u{fe6f}' | '\u{ff00}'..='\u{ff60}' | '\u{1f300}'..='\u{1faff}' | '\u{20000}'..='\u{3fffd}')
}
