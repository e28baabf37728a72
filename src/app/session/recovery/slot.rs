//! Files for kept work. Each window holds the lock of a numbered file of its own, which the system releases when the
//! process ends, however it ends. A kept scene whose lock is free was left behind.

use crate::document::write_whole;
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};

/// Maximum number of windows that keep their work at the same time.
const MOST: usize = 100;

/// A file for kept work, locked by this process.
pub struct Slot {
    pub path: PathBuf,
    _lock: File,
}

/// Returns a free file in `folder`, and the latest of those left behind. Returns `None` if no file can be created
/// there.
pub fn find(folder: &Path) -> Option<(Slot, Option<Slot>)> {
    fs::create_dir_all(folder).ok()?;
    // `None` if another process holds the lock.
    let lock = |path: PathBuf| {
        let lock = File::options()
            .create(true)
            .append(true)
            .open(path.with_extension("lock"))
            .ok()?;
        lock.try_lock().ok()?;
        Some(Slot { path, _lock: lock })
    };
    let (mut own, mut left) = (None, None);
    for path in (0..MOST).map(|number| folder.join(format!("{number}.toml"))) {
        let when = fs::metadata(&path)
            .and_then(|metadata| metadata.modified())
            .ok();
        if when.is_none() && own.is_none() {
            own = lock(path);
        } else if let Some(when) =
            when.filter(|when| left.as_ref().is_none_or(|(latest, _)| when > latest))
        {
            left = lock(path).map(|slot| (when, slot)).or(left);
        }
    }
    Some((own?, left.map(|(_, slot)| slot)))
}

pub fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_default()
}

/// Writes the whole file, or leaves the earlier one.
///
/// # Errors
/// The file cannot be written.
pub fn write(path: &Path, text: &str) -> Result<(), String> {
    write_whole(path, |out| out.write_all(text.as_bytes())).map_err(|error| error.to_string())
}

pub fn remove(path: &Path) -> io::Result<()> {
    fs::remove_file(path)
}
