//! Writing the record of a class: lines are appended, and synced together as fast as the disk can.
//!
//! A thread takes all lines that are waiting, writes them at once and syncs once; only then those who wait for them are told. So a class
//! that answers at the same moment costs as many syncs as the disk manages in that time, not one for each answer.

use super::tokens;
use crate::lesson::{ClassHead, ClassLine, ClassRecord, Lesson};
use crate::text::{in_language, language, text};
use std::fs::{File, OpenOptions, TryLockError};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::Path;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;
use tokio::sync::oneshot;

/// The size, in bytes, of the lines that are kept at most while nothing can be written.
const MOST_KEPT: usize = 4 << 20;

/// A signal that appended lines are on the disk, or the reason why they are not, in a sentence.
pub type Commit = oneshot::Receiver<Result<(), String>>;

struct Entry {
    lines: Vec<u8>,
    done: oneshot::Sender<Result<(), String>>,
}

/// The end of a record at which lines are appended.
#[derive(Debug)]
pub struct Recorder(Mutex<Option<(Sender<Entry>, JoinHandle<()>)>>);

impl Drop for Recorder {
    fn drop(&mut self) {
        self.close();
    }
}

impl Recorder {
    /// Starts to append to a file after `length` bytes of whole lines.
    fn start(file: File, length: u64) -> Self {
        let (queue, entries) = channel();
        let (language, writer) = (language(), Writer::new(file, length));
        let write = move || in_language(language, || writer.run(&entries));
        Self(Mutex::new(Some((queue, std::thread::spawn(write)))))
    }

    fn open(&self) -> MutexGuard<'_, Option<(Sender<Entry>, JoinHandle<()>)>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Appends lines. Without lines the commit tells when everything appended before is on the disk.
    pub fn append(&self, lines: &[ClassLine]) -> Commit {
        let mut text = String::new();
        for line in lines {
            // Every number in a line is finite, so that it can be written.
            text += &serde_json::to_string(line).unwrap_or_default();
            text.push('\n');
        }
        let (done, commit) = oneshot::channel();
        let lines = text.into_bytes();
        if let Some((queue, _)) = &*self.open() {
            // A record that is closed drops `done`, which the commit tells.
            let _ = queue.send(Entry { lines, done });
        }
        commit
    }

    /// Closes the record: all lines are on the disk, and the file is unlocked.
    pub fn close(&self) {
        if let Some((queue, thread)) = self.open().take() {
            // The writer ends with the queue.
            drop(queue);
            let _ = thread.join();
        }
    }
}

struct Writer {
    file: File,
    /// The length up to which the file is known to be whole.
    length: u64,
    /// Lines that could not be written yet.
    kept: Vec<u8>,
}

impl Writer {
    fn new(file: File, length: u64) -> Self {
        Self {
            file,
            length,
            kept: Vec::new(),
        }
    }

    fn run(mut self, entries: &Receiver<Entry>) {
        while let Ok(first) = entries.recv() {
            let mut waiting = Vec::new();
            for entry in std::iter::once(first).chain(entries.try_iter()) {
                if self.kept.len() <= MOST_KEPT {
                    self.kept.extend(entry.lines);
                }
                waiting.push(entry.done);
            }
            let written = self.write();
            let written =
                written.map_err(|error| text!("live-not-written", error = error.to_string()));
            for done in waiting {
                // Who no longer waits need not be told.
                let _ = done.send(written.clone());
            }
        }
    }

    /// Writes and syncs what is kept. On failure the file is cut back to what was whole, and the lines are tried again with the next.
    fn write(&mut self) -> io::Result<()> {
        let written = self.file.seek(SeekFrom::Start(self.length)).and_then(|_| {
            self.file.write_all(&self.kept)?;
            self.file.sync_data()
        });
        match written {
            Ok(()) => {
                self.length += self.kept.len() as u64;
                self.kept.clear();
            }
            // If this fails too, the next attempt writes over the same place.
            Err(_) => drop(self.file.set_len(self.length)),
        }
        written
    }
}

/// Opens the record of a class about a lesson, or begins one. It stays locked until the recorder is closed.
///
/// # Errors
/// A file that cannot be written, is in use by another class, or is none about this lesson; in a sentence.
pub fn open_record(
    path: &Path,
    lesson: &Lesson,
    seed: u64,
) -> Result<(Recorder, ClassRecord), String> {
    let file = path.display().to_string();
    let told = |error: io::Error| {
        text!(
            "live-record-unwritable",
            file = &*file,
            error = error.to_string()
        )
    };
    if path.exists() && !path.is_file() {
        return Err(text!("live-record-no-file", file = &*file));
    }
    let mut options = OpenOptions::new();
    options.read(true).write(true).create(true).truncate(false);
    // It holds the students' secrets.
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::mode(&mut options, 0o600);
    let mut opened = options.open(path).map_err(told)?;
    match opened.try_lock() {
        Err(TryLockError::WouldBlock) => return Err(text!("live-record-in-use", file = &*file)),
        // On file systems without locks nobody else is noticed.
        Err(TryLockError::Error(_)) | Ok(()) => {}
    }
    let mut bytes = Vec::new();
    let most = ClassRecord::MAX_BYTES + 1;
    (&mut opened)
        .take(most)
        .read_to_end(&mut bytes)
        .map_err(told)?;
    if !bytes.contains(&b'\n') && (bytes.is_empty() || ClassRecord::begins(&bytes)) {
        opened.set_len(0).map_err(told)?;
        return begin(opened, lesson, seed).map_err(told);
    }
    let record = ClassRecord::read(&bytes).and_then(|record| {
        if !record.head.is_of(lesson) || record.head.language != language() {
            let title = &*record.head.title;
            return Err(text!("live-record-other", title = title));
        }
        match tokens::is_code(&record.head.code) {
            true => Ok(record),
            false => Err(text!("class-changed").to_owned()),
        }
    });
    let record =
        record.map_err(|error| text!("live-record-unsound", file = &*file, error = error))?;
    opened.set_len(record.length).map_err(told)?;
    Ok((Recorder::start(opened, record.length), record))
}

/// Begins a record in an empty file.
fn begin(mut file: File, lesson: &Lesson, seed: u64) -> io::Result<(Recorder, ClassRecord)> {
    let code = tokens::code().map_err(io::Error::other)?;
    let head = ClassHead::new(lesson, seed, &code);
    let mut line = serde_json::to_vec(&ClassLine::Class(head.clone()))?;
    line.push(b'\n');
    file.rewind()?;
    file.write_all(&line)?;
    file.sync_all()?;
    let record = ClassRecord {
        head,
        students: Vec::new(),
        paces: Vec::new(),
        length: line.len() as u64,
    };
    Ok((Recorder::start(file, record.length), record))
}
