//! What the system does for a window. A web page has its own, `page.rs`.

use super::dialog::FileKind;
use eframe::egui::{Context, InputState, OpenUrl, ViewportCommand};
use std::path::PathBuf;

/// Whether this is a web page.
pub const PAGE: bool = false;

/// Does what is to be done before a frame.
pub fn begin_frame(_: &Context) {}

/// The files that were dropped on the window.
pub fn dropped(ctx: &Context) -> Vec<PathBuf> {
    let dropped = ctx.input(|input| input.raw.dropped_files.clone());
    dropped
        .iter()
        .map(|file| file.path().to_path_buf())
        .collect()
}

/// Shows the desktop's own dialog for a file, to open it or to write it, and waits for the answer.
pub fn pick(opens: bool, kind: &FileKind) -> Option<PathBuf> {
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

/// Whether fingers do what elsewhere the mouse does.
pub fn fingers(ctx: &Context) -> bool {
    ctx.input(InputState::has_touch_screen)
}

/// Has the desktop open an address, in its browser or its program for letters.
pub fn open_address(ctx: &Context, address: &str) {
    ctx.open_url(OpenUrl::new_tab(address));
}

pub fn set_title(ctx: &Context, title: &str) {
    ctx.send_viewport_cmd(ViewportCommand::Title(title.to_owned()));
}

pub fn set_fullscreen(ctx: &Context, on: bool) {
    ctx.send_viewport_cmd(ViewportCommand::Fullscreen(on));
}

/// Does what is to be done after a frame, with whether there is unsaved work, the link of what is seen and its picture as a file.
pub fn end_frame(
    _: &Context,
    _unsaved: bool,
    _link: impl FnOnce() -> Option<String>,
    _picture: impl FnOnce() -> Option<Vec<u8>>,
) {
}
