//! Files written whole: without a name or beside their target first, then in its place.

use crate::export::Export;
use crate::picture::{PictureError, write_png};
use crate::render::Frame;
use crate::scene::Scene;
use atomic_write_file::AtomicWriteFile;
use std::fs::{self, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// Links that are followed one after the other, as many as Linux follows.
const MOST_LINKS: usize = 40;

/// Why a file could not be written. The target is then as it was before.
#[derive(Debug, thiserror::Error)]
pub enum SaveError {
    #[error("{}: {what}, expected {expected}", .path.display())]
    Target { path: PathBuf, what: &'static str, expected: &'static str },
    #[error("{}: cannot be written ({source})", .path.display())]
    Unwritable { path: PathBuf, source: io::Error },
    #[error("{}: {source}", .path.display())]
    Picture { path: PathBuf, source: PictureError },
    #[error("{}: there is nothing to draw", .path.display())]
    Nothing { path: PathBuf },
    #[error("{}: the figure is too large", .path.display())]
    TooLarge { path: PathBuf },
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

/// Writes a file by `content`: the old one stays as it is until the new one is whole and on the disk, and passes its mode
/// on. A link is followed; a device or a pipe is written to directly.
///
/// # Errors
/// A target that cannot be written, or what `content` reports; nothing is left behind then.
pub fn write_whole(
    path: &Path,
    content: impl FnOnce(&mut dyn Write) -> Result<(), WriteError>,
) -> Result<(), SaveError> {
    check_target(path)?;
    let written = if is_stdout(path) {
        fill(io::stdout().lock(), content)
    } else if fs::metadata(path).is_ok_and(|metadata| !metadata.is_file()) {
        let device = OpenOptions::new().write(true).open(path).map_err(WriteError::Io);
        device.and_then(|device| fill(device, content))
    } else {
        replace(&behind_links(path), content)
    };
    written.map_err(|error| error.of(path))
}

/// Where Linux and the BSDs keep the standard output. It may be a file that others write to as well, which must not be
/// replaced, or a socket, which cannot be opened.
fn is_stdout(path: &Path) -> bool {
    cfg!(unix) && path == Path::new("/dev/stdout")
}

fn replace(target: &Path, content: impl FnOnce(&mut dyn Write) -> Result<(), WriteError>) -> Result<(), WriteError> {
    let mut file = AtomicWriteFile::open(target).map_err(WriteError::Io)?;
    fill(&mut file, content)?;
    file.commit().map_err(WriteError::Io)
}

fn fill(target: impl Write, content: impl FnOnce(&mut dyn Write) -> Result<(), WriteError>) -> Result<(), WriteError> {
    let mut out = BufWriter::new(target);
    content(&mut out)?;
    out.flush().map_err(WriteError::Io)
}

/// The file that a link leads to, which need not exist.
fn behind_links(path: &Path) -> PathBuf {
    let mut target = path.to_owned();
    for _ in 0..MOST_LINKS {
        let Ok(next) = fs::read_link(&target) else { break };
        target = target.parent().unwrap_or(Path::new("")).join(next);
    }
    target
}

/// Whether `path` can be written at all, as far as can be told without writing: worth asking before long work.
///
/// # Errors
/// A folder that does not exist, a target that is a folder or is write-protected.
pub fn check_target(path: &Path) -> Result<(), SaveError> {
    let refused = |what, expected| Err(SaveError::Target { path: path.to_owned(), what, expected });
    if is_stdout(path) {
        return Ok(());
    }
    let error = match fs::metadata(path) {
        Ok(metadata) if metadata.is_dir() => return refused("a directory", "a file to write"),
        Ok(metadata) if metadata.permissions().readonly() => return refused("write-protected", "a file to write"),
        Ok(_) => return Ok(()),
        Err(error) => error,
    };
    let target = behind_links(path);
    if target.file_name().is_none() {
        return refused("not the name of a file", "a file to write");
    }
    match target.parent() {
        Some(folder) if !folder.as_os_str().is_empty() && !folder.is_dir() => {
            refused("its folder does not exist", "a file in an existing folder")
        }
        _ if error.kind() == io::ErrorKind::NotFound => Ok(()),
        // Links in a circle, for example, or a name that is too long.
        _ => Err(SaveError::Unwritable { path: path.to_owned(), source: error }),
    }
}
