//! Errors of files, as sentences.

use crate::link::LinkError;
use crate::scene::SceneError;
use crate::text::{Message, excerpt, text};
use std::fmt::Display;
use std::io;
use std::path::{Path, PathBuf};

/// The expected content of a file.
pub(super) const SCENE_FILE: Message = Message("document-scene-file");
pub(super) const MODEL: Message = Message("document-model");
pub(super) const LIBRARY: Message = Message("document-library");
pub(super) const PICTURE: Message = Message("document-picture");

/// The reason why something could not be opened. Displayed, it names the file, and the line if there is one; several
/// problems take a line each.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum LoadError {
    /// An error in the text of the scene, or in an override.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// An error in the link.
    #[error(transparent)]
    Link(#[from] LinkError),
    /// An error of the file itself, with its line if the problem has one.
    #[error("{}:{} {problem}", shown(.path), .line.map(|line| format!("{line}:")).unwrap_or_default())]
    File {
        /// The file.
        path: PathBuf,
        /// Line, counted from 1; none where the problem concerns the whole file.
        line: Option<u64>,
        /// A sentence that describes the problem and the expectation.
        problem: String,
    },
}

/// Longest path that a system accepts, in bytes.
const MOST_PATH: usize = 4096;

/// Returns a path for a message: complete, as editors search for it, unless it is too long for a path.
fn shown(path: &Path) -> String {
    let text = path.display().to_string();
    if text.len() > MOST_PATH {
        excerpt(&text)
    } else {
        text
    }
}

impl LoadError {
    pub(super) fn file(path: &Path, problem: impl Display) -> Self {
        Self::File {
            path: path.to_owned(),
            line: None,
            problem: problem.to_string(),
        }
    }

    pub(super) fn unreadable(path: &Path, expected: Message, error: &io::Error) -> Self {
        let expected = expected.text();
        let problem = match error.kind() {
            io::ErrorKind::NotFound => text!("document-no-such-file", expected = expected),
            _ => {
                let error = error.to_string();
                text!("document-unreadable", error = error, expected = expected)
            }
        };
        Self::file(path, problem)
    }
}

/// The reason why a file could not be written. The target is then unchanged.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SaveError {
    /// The target cannot be written to, a folder, say; or a figure has more pixels than can be drawn.
    #[error("{}: {}", .path.display(), .problem.text())]
    Target {
        /// The target.
        path: PathBuf,
        /// The problem with it.
        problem: Message,
    },
    /// The system refused to write.
    #[error("{}: {}", .path.display(), text!("document-unwritable", error = .source.to_string()))]
    Unwritable {
        /// The target.
        path: PathBuf,
        /// The system's error.
        source: io::Error,
    },
    /// An answer that has no figure.
    #[error("{}: {}", .path.display(), text!("document-nothing-to-draw"))]
    Nothing {
        /// The target.
        path: PathBuf,
    },
}
