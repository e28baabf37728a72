//! The files of the system: read as they are, written completely or not at all.

mod hidden;

use super::error::{LoadError, SaveError};
use crate::text::{Message, text};
use atomic_write_file::AtomicWriteFile;
use hidden::HiddenFile;
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// Maximum number of links followed one after the other, as in Linux.
const MOST_LINKS: usize = 40;

/// Opens a regular file; returns it with its length in bytes.
pub fn open(path: &Path, expected: Message) -> Result<(File, u64), LoadError> {
    let unreadable = |error: io::Error| LoadError::unreadable(path, expected, &error);
    let metadata = fs::metadata(path).map_err(unreadable)?;
    if !metadata.is_file() {
        let expected = expected.text();
        let problem = if metadata.is_dir() {
            text!("document-directory-not-file", expected = expected)
        } else {
            text!("document-not-regular", expected = expected)
        };
        return Err(LoadError::file(path, problem));
    }
    Ok((File::open(path).map_err(unreadable)?, metadata.len()))
}

/// Writes a file by `content`: the old one stays until the new one is complete and on the disk, and passes its mode
/// on. A link is followed; a device or a pipe is written to directly. After an error nothing is left behind.
pub fn write_whole(
    path: &Path,
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), SaveError> {
    Unfinished::filled(path, content)?.finish(path)
}

/// Writes several texts like [`write_whole`]: no file is replaced before all of them are complete and on the disk.
pub fn write_texts(files: &[(PathBuf, &str)]) -> Result<(), SaveError> {
    let filled = |(path, text): &(PathBuf, &str)| {
        Unfinished::filled(path, |out| out.write_all(text.as_bytes()))
    };
    let unfinished = files.iter().map(filled).collect::<Result<Vec<_>, _>>()?;
    let mut whole = files.iter().zip(unfinished);
    whole.try_for_each(|((path, _), unfinished)| unfinished.finish(path))
}

/// A target being written, before it appears under its name.
enum Unfinished {
    /// A device, a pipe or the standard output: written bytes cannot be taken back.
    Direct(Box<dyn Write>),
    /// A file that on Linux has no name until it is complete.
    Whole(AtomicWriteFile),
    /// A file with a hidden name.
    Hidden(HiddenFile),
}

impl Unfinished {
    fn filled(
        path: &Path,
        content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
    ) -> Result<Self, SaveError> {
        check_target(path)?;
        let filled = Self::open(path).and_then(|mut new| new.fill(content).map(|()| new));
        filled.map_err(|error| unwritable(path, error))
    }

    fn open(path: &Path) -> io::Result<Self> {
        if is_stdout(path) {
            return Ok(Self::Direct(Box::new(io::stdout())));
        }
        if fs::metadata(path).is_ok_and(|metadata| !metadata.is_file()) {
            let device = OpenOptions::new().write(true).open(path)?;
            return Ok(Self::Direct(Box::new(device)));
        }
        let target = behind_links(path);
        // Linux names a file without a name through its entry there, and some containers have none.
        if cfg!(target_os = "linux") && !Path::new("/proc/self/fd").is_dir() {
            return HiddenFile::open(target).map(Self::Hidden);
        }
        AtomicWriteFile::open(target).map(Self::Whole)
    }

    /// Writes the content through to the disk, so that a full one is detected here.
    fn fill(&mut self, content: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
        match self {
            Self::Direct(device) => fill(device, content),
            Self::Whole(file) => fill(&mut *file, content).and_then(|()| file.sync_all()),
            Self::Hidden(hidden) => {
                fill(&hidden.file, content).and_then(|()| hidden.file.sync_all())
            }
        }
    }

    fn finish(self, path: &Path) -> Result<(), SaveError> {
        let finished = match self {
            Self::Direct(_) => Ok(()),
            Self::Whole(file) => file.commit(),
            Self::Hidden(hidden) => hidden.finish(),
        };
        finished.map_err(|error| unwritable(path, error))
    }
}

fn unwritable(path: &Path, source: io::Error) -> SaveError {
    SaveError::Unwritable {
        path: path.to_owned(),
        source,
    }
}

/// Path of the standard output on Linux and the BSDs, recognised everywhere. It may be a file that others write to as
/// well, which must not be replaced, or a socket, which cannot be opened.
pub const STDOUT: &str = "/dev/stdout";

fn is_stdout(path: &Path) -> bool {
    path == Path::new(STDOUT)
}

fn fill(
    target: impl Write,
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    let mut target = ErrorKeeper {
        target,
        failed: None,
    };
    let mut out = BufWriter::new(&mut target);
    let written = content(&mut out).and_then(|()| out.flush());
    // The rest is useless now, and would be written when the buffer is dropped.
    let _ = out.into_parts();
    written.map_err(|error| match target.failed {
        Some(kind) => io::Error::new(kind, error),
        None => error,
    })
}

/// A target that keeps the cause of its failure, since encoders wrap it in errors of their own.
struct ErrorKeeper<W> {
    target: W,
    failed: Option<io::ErrorKind>,
}

impl<W: Write> ErrorKeeper<W> {
    fn keep_error<T>(&mut self, result: io::Result<T>) -> io::Result<T> {
        result.inspect_err(|error| {
            let again = error.kind() == io::ErrorKind::Interrupted;
            self.failed = (!again).then(|| error.kind());
        })
    }
}

impl<W: Write> Write for ErrorKeeper<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.target.write(bytes);
        self.keep_error(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        let flushed = self.target.flush();
        self.keep_error(flushed)
    }
}

/// Returns the file that a link leads to, which need not exist.
fn behind_links(path: &Path) -> PathBuf {
    let mut target = path.to_owned();
    for _ in 0..MOST_LINKS {
        let Ok(next) = fs::read_link(&target) else {
            break;
        };
        target = target.parent().unwrap_or(Path::new("")).join(next);
    }
    target
}

/// Checks whether `path` can be written, as far as possible without writing: for use before long work.
///
/// # Errors
/// A folder that does not exist, a target that is a folder or is write-protected.
pub fn check_target(path: &Path) -> Result<(), SaveError> {
    let refused = |problem| {
        Err(SaveError::Target {
            path: path.to_owned(),
            problem: Message(problem),
        })
    };
    if is_stdout(path) {
        return Ok(());
    }
    let error = match fs::metadata(path) {
        Ok(metadata) if metadata.is_dir() => return refused("document-target-directory"),
        Ok(metadata) if metadata.permissions().readonly() => {
            return refused("document-target-protected");
        }
        Ok(_) => return Ok(()),
        Err(error) => error,
    };
    let target = behind_links(path);
    if target.file_name().is_none() {
        return refused("document-target-no-name");
    }
    match target.parent() {
        Some(folder) if !folder.as_os_str().is_empty() && !folder.is_dir() => {
            refused("document-target-no-folder")
        }
        _ if error.kind() == io::ErrorKind::NotFound => Ok(()),
        // For example a cycle of links, or a name that is too long.
        _ => Err(unwritable(path, error)),
    }
}
