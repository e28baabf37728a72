//! Files written whole: beside their target first, then renamed to it.

use crate::export::Export;
use crate::picture::{PictureError, write_png};
use crate::render::Frame;
use crate::scene::Scene;
use std::ffi::OsString;
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::process;
use std::sync::atomic::{AtomicU32, Ordering};

/// Why a file could not be written. The target is then as it was before.
#[derive(Debug, thiserror::Error)]
pub enum SaveError {
    #[error("{}: {what}, expected {expected}", .path.display())]
    Target { path: PathBuf, what: &'static str, expected: &'static str },
    #[error("{}: cannot be written ({source})", .path.display())]
    Unwritable { path: PathBuf, source: io::Error },
    #[error("{}: {source}", .path.display())]
    Picture { path: PathBuf, source: PictureError },
}

/// Writes a scene file. The path of a model at or below the file's folder is written relative to it.
///
/// # Errors
/// See [`SaveError`].
pub fn save_scene(path: &Path, scene: &Scene) -> Result<(), SaveError> {
    let mut portable = scene.clone();
    let folder = std::path::absolute(path).ok().and_then(|path| path.parent().map(Path::to_owned));
    if let (Some(model), Some(folder)) = (&mut portable.object.path, folder)
        && let Ok(relative) = model.strip_prefix(&folder)
    {
        *model = relative.to_owned();
    }
    write_whole(path, |out| out.write_all(portable.to_toml().as_bytes()).map_err(WriteError::Io))
}

/// Writes a picture as PNG with its scene inside; a model's path stays absolute.
///
/// # Errors
/// See [`SaveError`].
pub fn save_picture(path: &Path, frame: &Frame, scene: &Scene) -> Result<(), SaveError> {
    write_whole(path, |out| write_png(out, frame, Some(scene)).map_err(WriteError::Picture))
}

/// Writes a picture of no one scene as PNG.
///
/// # Errors
/// See [`SaveError`].
pub fn save_frame(path: &Path, frame: &Frame) -> Result<(), SaveError> {
    write_whole(path, |out| write_png(out, frame, None).map_err(WriteError::Picture))
}

/// Writes the parts of a scene's code, each to its [path](Export::path_of).
///
/// # Errors
/// See [`SaveError`]. That a path cannot be written is found before anything is.
pub fn save_code(target: &Path, export: &Export) -> Result<(), SaveError> {
    for part in &export.parts {
        check_target(&export.path_of(part, target))?;
    }
    for part in &export.parts {
        let text = part.text.as_bytes();
        write_whole(&export.path_of(part, target), |out| out.write_all(text).map_err(WriteError::Io))?;
    }
    Ok(())
}

/// What stopped a file's content.
#[derive(Debug)]
pub enum WriteError {
    Io(io::Error),
    Picture(PictureError),
}

impl WriteError {
    fn of(self, path: &Path) -> SaveError {
        let path = path.to_owned();
        match self {
            Self::Io(source) | Self::Picture(PictureError::Unwritten(png::EncodingError::IoError(source))) => {
                SaveError::Unwritable { path, source }
            }
            Self::Picture(source) => SaveError::Picture { path, source },
        }
    }
}

/// Writes a file by `content`: under another name in the same folder, which then takes the place of `path` at once. A
/// link is followed; a device or a pipe is written to directly.
///
/// # Errors
/// A target that cannot be written, or what `content` reports; nothing is left behind then.
pub fn write_whole(
    path: &Path,
    content: impl FnOnce(&mut dyn Write) -> Result<(), WriteError>,
) -> Result<(), SaveError> {
    check_target(path)?;
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let failed = |error: WriteError| error.of(path);
    if fs::metadata(&target).is_ok_and(|metadata| !metadata.is_file()) {
        let file = OpenOptions::new().write(true).open(&target).map_err(WriteError::Io).map_err(failed)?;
        return fill(file, content).map_err(failed);
    }
    let (file, beside) = create_beside(&target).map_err(WriteError::Io).map_err(failed)?;
    let written = fill(file, content).and_then(|()| fs::rename(&beside, &target).map_err(WriteError::Io));
    if written.is_err() {
        // The error at hand is the one to report.
        let _ = fs::remove_file(&beside);
    }
    written.map_err(failed)
}

fn fill(file: File, content: impl FnOnce(&mut dyn Write) -> Result<(), WriteError>) -> Result<(), WriteError> {
    let mut out = BufWriter::new(file);
    content(&mut out)?;
    out.flush().map_err(WriteError::Io)
}

/// A new file in the target's folder, hidden and with a name of its own.
fn create_beside(target: &Path) -> io::Result<(File, PathBuf)> {
    static COUNT: AtomicU32 = AtomicU32::new(0);
    let name = target.file_name().ok_or(io::ErrorKind::InvalidInput)?;
    loop {
        let mut hidden = OsString::from(".");
        hidden.push(name);
        hidden.push(format!(".{}-{}.part", process::id(), COUNT.fetch_add(1, Ordering::Relaxed)));
        let beside = target.with_file_name(hidden);
        match OpenOptions::new().write(true).create_new(true).open(&beside) {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
            result => return result.map(|file| (file, beside)),
        }
    }
}

/// Whether `path` can be written at all, as far as can be told without writing: worth asking before long work.
///
/// # Errors
/// A folder that does not exist, a target that is a folder or is write-protected.
pub fn check_target(path: &Path) -> Result<(), SaveError> {
    let refused = |what, expected| Err(SaveError::Target { path: path.to_owned(), what, expected });
    match fs::metadata(path) {
        Ok(metadata) if metadata.is_dir() => return refused("a directory", "a file to write"),
        Ok(metadata) if metadata.permissions().readonly() => return refused("write-protected", "a file to write"),
        Ok(_) => return Ok(()),
        Err(_) => {}
    }
    if path.file_name().is_none() {
        return refused("not the name of a file", "a file to write");
    }
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() && !folder.is_dir() => {
            refused("its folder does not exist", "a file in an existing folder")
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A folder of a test's own, removed at its end.
    struct Folder(PathBuf);

    impl Folder {
        fn new(name: &str) -> Self {
            let path = std::env::temp_dir().join(format!("shading-lab-save-{}-{name}", process::id()));
            fs::create_dir_all(&path).expect("a folder");
            Self(path)
        }

        fn names(&self) -> Vec<OsString> {
            let entries = fs::read_dir(&self.0).expect("a folder");
            entries.map(|entry| entry.expect("an entry").file_name()).collect()
        }
    }

    impl Drop for Folder {
        fn drop(&mut self) {
            let _ = fs::remove_dir_all(&self.0);
        }
    }

    #[test]
    fn a_file_is_replaced_whole() {
        let folder = Folder::new("whole");
        let target = folder.0.join("a.txt");
        for text in ["longer at first", "then short"] {
            write_whole(&target, |out| out.write_all(text.as_bytes()).map_err(WriteError::Io)).expect("written");
            assert_eq!(fs::read_to_string(&target).expect("a text"), text);
        }
        assert_eq!(folder.names(), ["a.txt"]);
    }

    #[test]
    fn content_that_fails_leaves_the_old_file_and_nothing_else() {
        let folder = Folder::new("fails");
        let target = folder.0.join("a.txt");
        fs::write(&target, "old").expect("a file");
        let error = write_whole(&target, |out| {
            out.write_all(&[b'x'; 100_000]).map_err(WriteError::Io)?;
            Err(WriteError::Io(io::Error::other("no more")))
        });
        assert!(matches!(error, Err(SaveError::Unwritable { .. })));
        assert_eq!(fs::read_to_string(&target).expect("a text"), "old");
        assert_eq!(folder.names(), ["a.txt"]);
    }

    #[test]
    fn targets_that_cannot_be_written_are_refused() {
        let folder = Folder::new("refused");
        for target in [folder.0.clone(), folder.0.join("no/such/a.txt"), PathBuf::from(""), PathBuf::from("/")] {
            let error = write_whole(&target, |_| unreachable!("nothing is written to {}", target.display()));
            assert!(matches!(error, Err(SaveError::Target { .. })), "{error:?}");
        }
        assert!(folder.names().is_empty());
    }

    #[cfg(unix)]
    #[test]
    fn a_link_is_followed_and_a_device_is_not_replaced() {
        let folder = Folder::new("links");
        let (target, link) = (folder.0.join("a.txt"), folder.0.join("link.txt"));
        fs::write(&target, "old").expect("a file");
        std::os::unix::fs::symlink(&target, &link).expect("a link");
        write_whole(&link, |out| out.write_all(b"new").map_err(WriteError::Io)).expect("written");
        assert_eq!(fs::read_to_string(&target).expect("a text"), "new");
        assert!(fs::symlink_metadata(&link).expect("a link").is_symlink());
        write_whole(Path::new("/dev/null"), |out| out.write_all(b"x").map_err(WriteError::Io)).expect("swallowed");
        assert!(!fs::metadata("/dev/null").expect("a device").is_file());
    }

    #[test]
    fn a_model_beside_the_scene_is_written_relative_and_another_absolute() {
        let folder = Folder::new("relative");
        let target = folder.0.join("s.toml");
        for (model, expected) in [
            (folder.0.join("models/a.obj"), PathBuf::from("models/a.obj")),
            (std::env::temp_dir().join("b.obj"), std::env::temp_dir().join("b.obj")),
        ] {
            let mut scene = Scene::default();
            scene.object.path = Some(model);
            save_scene(&target, &scene).expect("written");
            let text = fs::read_to_string(&target).expect("a text");
            assert_eq!(Scene::parse(&text, "").expect("sound").object.path, Some(expected));
        }
    }
}
