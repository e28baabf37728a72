//! Hand-ins as the command line reads them.

use super::input::{called, is_stdin, stdin};
use super::output::{Failure, note, progress_bar};
use shading_lab::lesson::{Class, Handed, Lesson, Unreadable, collect};
use shading_lab::text::text;
use std::path::{Path, PathBuf};

/// Reads and grades hand-ins, with a progress bar.
pub fn read(files: &[PathBuf], lesson: Option<&Lesson>, pictures: bool) -> Result<Class, Failure> {
    let handed: Result<Vec<_>, Failure> = files.iter().map(|path| handed(path)).collect();
    let handed = handed?;
    let bar = progress_bar(handed.len() as u64, text!("cli-reading"));
    Ok(collect(&handed, lesson, pictures, &mut || bar.inc(1)))
}

/// Says which files do not count though they are sound.
pub fn note_set_aside(class: &Class) {
    for Unreadable { file, why, .. } in &class.set_aside {
        note(&format!("{file}: {why}"));
    }
}

/// Reads a hand-in from a file or the standard input.
fn handed(path: &Path) -> Result<Handed, Failure> {
    Ok(Handed {
        path: called(path).to_owned(),
        bytes: is_stdin(path).then(stdin).transpose()?,
    })
}
