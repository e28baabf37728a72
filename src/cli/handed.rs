//! Hand-ins as the command line reads them, and what is written of them.

use super::input::{STDIN, is_stdin, stdin};
use super::output::{Failure, note, progress_bar};
use shading_lab::document::write_whole;
use shading_lab::lesson::{Class, Handed, Lesson, Unreadable, collect};
use shading_lab::text::text;
use std::path::{Path, PathBuf};

/// Reads and grades hand-ins, with a progress bar.
pub fn read(handed: &[Handed], lesson: Option<&Lesson>, pictures: bool) -> Class {
    let bar = progress_bar(handed.len() as u64, text!("cli-reading"));
    let mut progress = || bar.inc(1);
    collect(handed, lesson, pictures, &mut progress)
}

/// Says which files do not count though they are sound.
pub fn note_set_aside(class: &Class) {
    for Unreadable { file, why, .. } in &class.set_aside {
        note(&format!("{file}: {why}"));
    }
}

/// Reads a hand-in from a file or the standard input.
pub fn handed(path: &Path) -> Result<Handed, Failure> {
    let (path, bytes) = if is_stdin(path) {
        (PathBuf::from(STDIN), Some(stdin()?))
    } else {
        (path.to_owned(), None)
    };
    Ok(Handed { path, bytes })
}

/// Writes a text file, whole or not at all.
pub fn write_text(target: &Path, text: &str) -> Result<(), Failure> {
    Ok(write_whole(target, |out| out.write_all(text.as_bytes()))?)
}
