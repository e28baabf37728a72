//! What the browser does for the window of a web page.

use super::dialog::FileKind;
use super::theme;
use crate::document::give;
use crate::jobs;
use crate::text::{Language, language, set_chinese_font};
use eframe::egui::{Context, DroppedFile};
use js_sys::{ArrayBuffer, Uint8Array};
use std::cell::{Cell, RefCell};
use std::path::PathBuf;
use std::sync::Arc;
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{ClipboardEvent, File, FileList, HtmlInputElement, Response};

/// Whether this is a web page.
pub const PAGE: bool = true;
/// Beside the page.
const CHINESE_FONT: &str = "chinese.otf";

thread_local! {
    /// Files that have come in since the last frame.
    static ARRIVED: RefCell<Vec<PathBuf>> = const { RefCell::new(Vec::new()) };
    /// Of the window, once it has drawn a frame.
    static CONTEXT: RefCell<Option<Context>> = const { RefCell::new(None) };
    static FONT_ASKED: Cell<bool> = const { Cell::new(false) };
}

/// Does what is to be done before a frame.
pub fn begin_frame(ctx: &Context) {
    if CONTEXT.with_borrow(Option::is_none) {
        CONTEXT.set(Some(ctx.clone()));
        listen();
        show("ready");
    }
    jobs::step();
}

fn document() -> Option<web_sys::Document> {
    web_sys::window()?.document()
}

/// Tells the page what to show: the window, or a sentence.
pub fn show(what: &str) {
    if let Some(page) = document().and_then(|document| document.document_element()) {
        let _ = page.set_attribute("data-state", what);
    }
}

/// The files that were dropped on the page, pasted or chosen, once their content is there.
pub fn dropped(ctx: &Context) -> Vec<PathBuf> {
    let dropped = ctx.input(|input| input.raw.dropped_files.clone());
    if !dropped.is_empty() {
        spawn_local(read_dropped(dropped));
    }
    let mut arrived = ARRIVED.take();
    // Of a scene and its model, the scene is opened.
    if let Some(scene) = arrived
        .iter()
        .position(|path| path.extension().is_some_and(|ending| ending == "toml"))
    {
        arrived = vec![arrived.swap_remove(scene)];
    }
    arrived.truncate(1);
    arrived
}

async fn read_dropped(files: Vec<Arc<dyn DroppedFile + Send + Sync>>) {
    let mut read = Vec::new();
    for file in files {
        if let Ok(content) = file.bytes_async().await {
            read.push((file.path().to_owned(), content));
        }
    }
    arrive(read);
}

async fn read_files(files: Vec<File>) {
    let mut read = Vec::new();
    for file in files {
        if let Ok(content) = JsFuture::from(file.array_buffer()).await {
            read.push((file.name().into(), Uint8Array::new(&content).to_vec()));
        }
    }
    arrive(read);
}

fn arrive(files: Vec<(PathBuf, Vec<u8>)>) {
    for (path, content) in files {
        ARRIVED.with_borrow_mut(|arrived| arrived.push(path.clone()));
        give(path, content);
    }
    CONTEXT.with_borrow(|ctx| ctx.iter().for_each(Context::request_repaint));
}

fn all(files: Option<FileList>) -> Vec<File> {
    let files = files.iter();
    files
        .flat_map(|list| (0..list.length()).filter_map(|index| list.get(index)))
        .collect()
}

/// Takes pictures that are pasted; text goes another way.
fn listen() {
    let paste = Closure::<dyn Fn(ClipboardEvent)>::new(|event: ClipboardEvent| {
        let files = all(event.clipboard_data().and_then(|data| data.files()));
        if !files.is_empty() {
            event.prevent_default();
            spawn_local(read_files(files));
        }
    });
    if let Some(document) = document() {
        let _ = document.add_event_listener_with_callback("paste", paste.as_ref().unchecked_ref());
    }
    paste.forget();
}

/// Shows the browser's dialog for files; what is chosen comes as what is [dropped].
pub fn pick(_opens: bool, kind: &FileKind) -> Option<PathBuf> {
    let input: HtmlInputElement = document()?.create_element("input").ok()?.unchecked_into();
    input.set_type("file");
    input.set_multiple(true);
    let endings: Vec<String> = kind.endings.iter().map(|e| format!(".{e}")).collect();
    input.set_accept(&endings.join(","));
    let chosen = {
        let input = input.clone();
        Closure::once_into_js(move || spawn_local(read_files(all(input.files()))))
    };
    input.set_onchange(Some(chosen.unchecked_ref()));
    input.click();
    None
}

pub fn set_title(_: &Context, title: &str) {
    document()
        .iter()
        .for_each(|document| document.set_title(title));
}

/// A browser that refuses leaves the page as it is.
pub fn set_fullscreen(_: &Context, on: bool) {
    let Some(document) = document() else { return };
    if !on {
        document.exit_fullscreen();
    } else if let Some(page) = document.document_element() {
        let _ = page.request_fullscreen();
    }
}

/// Fetches the letters for the language of the moment, once.
pub fn want_letters(ctx: &Context) {
    if let Some(page) = document().and_then(|document| document.document_element()) {
        let _ = page.set_attribute("lang", language().tag());
    }
    if language() != Language::TraditionalChinese || FONT_ASKED.replace(true) {
        return;
    }
    let ctx = ctx.clone();
    spawn_local(async move {
        match fetch(CHINESE_FONT).await {
            Ok(font) => {
                set_chinese_font(font);
                theme::install_fonts(&ctx);
                ctx.request_repaint();
            }
            // Until then the browser draws the characters. The next choice of the language asks again.
            Err(_) => FONT_ASKED.set(false),
        }
    });
}

/// A file beside the page.
async fn fetch(name: &str) -> Result<Vec<u8>, JsValue> {
    let window = web_sys::window().ok_or(JsValue::NULL)?;
    let response: Response = JsFuture::from(window.fetch_with_str(name)).await?.into();
    if !response.ok() {
        return Err(response.status().into());
    }
    let content: ArrayBuffer = JsFuture::from(response.array_buffer()?).await?.into();
    Ok(Uint8Array::new(&content).to_vec())
}
