//! The services of the system for a window. The counterpart for a web page is `page.rs`.

use crate::app::widgets::dialog::{FileKind, Picked};
use crate::document::ending;
use crate::link::encoded;
use eframe::egui::{Context, InputState, OpenUrl, ViewportCommand};
use log::{Level, LevelFilter, Log, Metadata, Record};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

/// True if this is a web page.
pub const PAGE: bool = false;

/// Prepares a frame; on the desktop there is nothing to do.
pub fn begin_frame(_: &Context) {}

/// Returns the files that were dropped on the window.
pub fn dropped(ctx: &Context) -> Vec<PathBuf> {
    let dropped = ctx.input(|input| input.raw.dropped_files.clone());
    let paths = dropped.iter().map(|file| file.path().to_path_buf());
    let mut paths: Vec<PathBuf> = paths.collect();
    if paths.len() > 1 {
        // A model finds its libraries itself.
        paths.retain(|path| ending(path).as_deref() != Some("mtl"));
    }
    paths
}

/// A logger that detects that neither the desktop nor zenity has a dialog; `rfd` reports that to its caller as a
/// cancelled dialog.
struct Listener {
    failed: AtomicBool,
}

/// The log target under which `rfd` reports, as an error, that its last way to a dialog has failed.
const LAST_WAY: &str = "rfd::backend::xdg_desktop_portal";

static LISTENER: Listener = Listener {
    failed: AtomicBool::new(false),
};

impl Log for Listener {
    fn enabled(&self, metadata: &Metadata<'_>) -> bool {
        metadata.level() == Level::Error && metadata.target() == LAST_WAY
    }

    fn log(&self, record: &Record<'_>) {
        if self.enabled(record.metadata()) {
            self.failed.store(true, Ordering::Relaxed);
        }
    }

    fn flush(&self) {}
}

/// Shows the desktop's own dialog for a file, to open it or to write it, and waits for the answer.
pub fn pick(opens: bool, kind: &FileKind) -> Picked {
    // Fails from the second time on, when the logger is already set.
    let _ = log::set_logger(&LISTENER);
    log::set_max_level(LevelFilter::Error);
    LISTENER.failed.store(false, Ordering::Relaxed);
    match shown(opens, kind) {
        Some(path) => Picked::File(path),
        None if LISTENER.failed.load(Ordering::Relaxed) => Picked::NoDialog,
        None => Picked::Nothing,
    }
}

fn shown(opens: bool, kind: &FileKind) -> Option<PathBuf> {
    let all = rfd::FileDialog::new();
    let dialog = if kind.endings.is_empty() {
        all
    } else {
        all.add_filter(kind.files, kind.endings)
    };
    if opens {
        dialog.pick_file()
    } else {
        dialog.set_file_name(kind.example).save_file()
    }
}

/// Returns whether touch replaces the mouse.
pub fn fingers(ctx: &Context) -> bool {
    ctx.input(InputState::has_touch_screen)
}

/// Returns whether the pointing device is known to be a finger before the first touch.
pub fn coarse() -> bool {
    false
}

/// Returns whether the wheel and swipes scroll a page around this window; on the desktop there is none.
pub fn page_scrolls() -> bool {
    false
}

/// Returns whether this is a page that was loaded again.
pub fn reloaded() -> bool {
    false
}

/// Returns the link and the place to which a browser went back; on the desktop there is none.
pub fn went() -> Option<(String, String)> {
    None
}

/// Does nothing: egui itself copies texts on the desktop.
pub fn copy(_: &Context) {}

/// Has the desktop open an address, in its browser or its mail program.
pub fn open_address(ctx: &Context, address: &str) {
    ctx.open_url(OpenUrl::new_tab(address));
}

/// Has the desktop show a folder in its file manager.
pub fn show_folder(ctx: &Context, folder: &Path) {
    let folder = folder.to_string_lossy().replace('\\', "/");
    let parts: Vec<_> = folder.split('/').map(encoded).collect();
    open_address(ctx, &format!("file://{}", parts.join("/")));
}

pub fn set_title(ctx: &Context, title: &str) {
    ctx.send_viewport_cmd(ViewportCommand::Title(title.to_owned()));
}

pub fn set_fullscreen(ctx: &Context, on: bool) {
    ctx.send_viewport_cmd(ViewportCommand::Fullscreen(on));
}

/// Finishes a frame, given whether leaving would lose work, the link of the current view, its place in the history of a
/// browser, and its picture as a file; on the desktop there is nothing to do.
pub fn end_frame(
    _: &Context,
    _unsaved: bool,
    _link: impl FnOnce() -> Option<String>,
    _place: String,
    _is_drawn: impl FnOnce() -> bool,
    _picture: impl FnOnce() -> Option<Vec<u8>>,
) {
}
