//! A file that has a hidden name until it is complete, for systems without nameless files.

use std::fs::{self, File, OpenOptions};
use std::io;
use std::path::{Path, PathBuf};

/// Maximum number of hidden names tried; the others are left over from killed programs.
const MOST_TRIES: u32 = 1000;

/// A file beside its target, removed unless it replaces the target.
pub struct HiddenFile {
    /// The file, open for writing.
    pub file: File,
    hidden: PathBuf,
    target: PathBuf,
    finished: bool,
}

impl HiddenFile {
    /// Creates an empty file with the mode and the owner of its target, if that exists.
    pub fn open(target: PathBuf) -> io::Result<Self> {
        let (file, hidden) = hidden_file(&target)?;
        let new = Self {
            file,
            hidden,
            target,
            finished: false,
        };
        if let Ok(before) = fs::metadata(&new.target) {
            // Only the superuser may change the owner.
            #[cfg(unix)]
            {
                use std::os::unix::fs::{MetadataExt, fchown};
                let _ = fchown(&new.file, Some(before.uid()), Some(before.gid()));
            }
            new.file.set_permissions(before.permissions())?;
        }
        Ok(new)
    }

    /// Replaces its target, which an error leaves unchanged.
    pub fn finish(mut self) -> io::Result<()> {
        self.file.sync_all()?;
        fs::rename(&self.hidden, &self.target)?;
        self.finished = true;
        // Not every system can sync a folder; the file has its name in any case.
        let _ = File::open(folder_of(&self.target)).and_then(|folder| folder.sync_all());
        Ok(())
    }
}

impl Drop for HiddenFile {
    fn drop(&mut self) {
        if !self.finished {
            // It may have been removed with its folder.
            let _ = fs::remove_file(&self.hidden);
        }
    }
}

/// Creates a file beside `target` whose name is eight bytes longer.
fn hidden_file(target: &Path) -> io::Result<(File, PathBuf)> {
    let name = target.file_name().unwrap_or_default();
    let mut taken = io::ErrorKind::AlreadyExists.into();
    for attempt in 0..MOST_TRIES {
        let mut hidden = std::ffi::OsString::from(".");
        hidden.push(name);
        let number = std::process::id().wrapping_add(attempt) % 1_000_000;
        hidden.push(format!(".{number:06}"));
        let path = target.with_file_name(hidden);
        match OpenOptions::new().write(true).create_new(true).open(&path) {
            Ok(file) => return Ok((file, path)),
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => taken = error,
            Err(error) => return Err(error),
        }
    }
    Err(taken)
}

fn folder_of(path: &Path) -> &Path {
    let folder = path
        .parent()
        .filter(|folder| !folder.as_os_str().is_empty());
    folder.unwrap_or(Path::new("."))
}
