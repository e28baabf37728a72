//! A file that has a hidden name until it is whole, for systems where one without any name cannot be had.

use std::fs::{self, File, OpenOptions};
use std::io;
use std::path::{Path, PathBuf};

/// Hidden names that are tried; others are what killed programs have left behind.
const MOST_TRIES: u32 = 1000;

/// A file beside its target, which is removed unless it takes the target's place.
pub struct HiddenFile {
    /// Open for writing.
    pub file: File,
    hidden: PathBuf,
    target: PathBuf,
    finished: bool,
}

impl HiddenFile {
    /// Makes an empty file with the mode and the owner of its target, where that is there.
    ///
    /// # Errors
    /// A folder in which no file can be made.
    pub fn open(target: PathBuf) -> io::Result<Self> {
        let (file, hidden) = hidden_file(&target)?;
        let new = Self {
            file,
            hidden,
            target,
            finished: false,
        };
        if let Ok(before) = fs::metadata(&new.target) {
            // Only the superuser may give files away.
            #[cfg(unix)]
            {
                use std::os::unix::fs::{MetadataExt, fchown};
                let _ = fchown(&new.file, Some(before.uid()), Some(before.gid()));
            }
            new.file.set_permissions(before.permissions())?;
        }
        Ok(new)
    }

    /// Puts it in the place of its target.
    ///
    /// # Errors
    /// What the system says; the target is then as it was.
    pub fn finish(mut self) -> io::Result<()> {
        self.file.sync_all()?;
        fs::rename(&self.hidden, &self.target)?;
        self.finished = true;
        // Not every system lets a folder be synced; the file has its name all the same.
        let _ = File::open(folder_of(&self.target)).and_then(|folder| folder.sync_all());
        Ok(())
    }
}

impl Drop for HiddenFile {
    fn drop(&mut self) {
        if !self.finished {
            // It may be gone with its folder.
            let _ = fs::remove_file(&self.hidden);
        }
    }
}

/// Makes a file beside `target` whose name is eight bytes longer.
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
