//! The services of the browser for the window of a web page.

#[path = "page/mirror.rs"]
mod mirror;
#[path = "page/scripts.rs"]
mod scripts;

use crate::app::widgets::dialog::{FileKind, Picked};
use crate::app::widgets::theme;
use crate::document::{ending, give};
use crate::lesson::{are_there, take_texts};
use crate::text::{Language, chinese_text, language, set_chinese_font, set_chinese_text};
use eframe::egui::{Context, DroppedFile, InputState, OutputCommand};
use js_sys::{Array, ArrayBuffer, Function, Promise, Reflect, Uint8Array};
use std::cell::{Cell, RefCell};
use std::path::PathBuf;
use std::sync::Arc;
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{ClipboardEvent, Event, File, FileList, HtmlInputElement, PopStateEvent, Response};

/// True if this is a web page.
pub const PAGE: bool = true;
/// The files of the Chinese texts and font, beside the page.
const CHINESE_TEXT: &str = "chinese.txt";
const CHINESE_FONT: &str = "chinese.otf";
/// The file of the lessons, beside the page.
const LESSONS: &str = "lessons.txt";
/// Delay before lessons that did not arrive are requested again, seconds.
const LESSONS_PAUSE: f64 = 5.0;
/// The page's own object for scripts.
const OWN: &str = "shadingLab";
/// The function of [`OWN`] that returns the picture.
const PICTURE: &str = "picture";
/// The function of [`OWN`] that copies a text without a clipboard for scripts.
const COPY: &str = "copy";

thread_local! {
    /// The files that have arrived since the last frame.
    static ARRIVED: RefCell<Vec<PathBuf>> = const { RefCell::new(Vec::new()) };
    /// The file that was opened last.
    static OPENED: RefCell<Option<PathBuf>> = const { RefCell::new(None) };
    /// The context of the window, once it has drawn a frame.
    static CONTEXT: RefCell<Option<Context>> = const { RefCell::new(None) };
    static CHINESE_ASKED: Cell<bool> = const { Cell::new(false) };
    static SHOWN_IN: Cell<Option<Language>> = const { Cell::new(None) };
    /// The link of the current view, and its place.
    static SHOWN: RefCell<Option<(String, String)>> = const { RefCell::new(None) };
    /// The entry of its history to which the browser went, a link and a place.
    static WENT: RefCell<Option<(String, String)>> = const { RefCell::new(None) };
    static UNSAVED: Cell<bool> = const { Cell::new(false) };
    /// The time when the lessons were last requested, seconds.
    static LESSONS_ASKED: Cell<f64> = const { Cell::new(f64::NEG_INFINITY) };
    /// The callbacks of pending requests for the picture.
    static ASKED: RefCell<Vec<Function>> = const { RefCell::new(Vec::new()) };
}

/// Prepares a frame; the first one sets up the page.
pub fn begin_frame(ctx: &Context) {
    if CONTEXT.with_borrow(Option::is_none) {
        CONTEXT.set(Some(ctx.clone()));
        listen();
        offer(ctx);
        show("ready");
    }
}

fn document() -> Option<web_sys::Document> {
    web_sys::window()?.document()
}

/// Returns the page's own element.
fn root() -> Option<web_sys::Element> {
    document()?.document_element()
}

fn repaint() {
    CONTEXT.with_borrow(|ctx| ctx.iter().for_each(Context::request_repaint));
}

/// Returns whether the page's script has marked the page with this attribute.
pub fn has_mark(name: &str) -> bool {
    root().is_some_and(|root| root.has_attribute(name))
}

/// Tells the page what to show: the window, or a sentence.
pub fn show(what: &str) {
    if let Some(root) = root() {
        let _ = root.set_attribute("data-state", what);
    }
}

/// Returns the files that were dropped on the page, pasted or chosen, once their content is available.
pub fn dropped(ctx: &Context) -> Vec<PathBuf> {
    let dropped = ctx.input(|input| input.raw.dropped_files.clone());
    if !dropped.is_empty() {
        spawn_local(read_dropped(dropped));
    }
    let arrived = ARRIVED.take();
    let ends = |path: &PathBuf, with: &str| ending(path).as_deref() == Some(with);
    // Of a scene, its model and the model's libraries, the scene is opened, or else the model.
    let first = |with: &str| arrived.iter().find(|path| ends(path, with));
    let main = first("toml").or_else(|| first("obj")).or(arrived.first());
    // Libraries alone belong to the model that was given before them.
    let main = match main {
        Some(path) if ends(path, "mtl") => OPENED.with_borrow(Clone::clone),
        main => main.cloned(),
    };
    if main.is_some() {
        OPENED.set(main.clone());
    }
    main.into_iter().collect()
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
    repaint();
}

fn all(files: Option<FileList>) -> Vec<File> {
    let files = files.iter();
    files
        .flat_map(|list| (0..list.length()).filter_map(|index| list.get(index)))
        .collect()
}

/// Listens for pasted files, such as pictures (text is handled elsewhere), and has the browser ask before it leaves
/// unsaved work.
fn listen() {
    let leave = Closure::<dyn Fn(Event)>::new(|event: Event| {
        if UNSAVED.get() {
            event.prevent_default();
        }
    });
    let back = Closure::<dyn Fn(PopStateEvent)>::new(|event: PopStateEvent| go_back(&event));
    if let Some(window) = web_sys::window() {
        let _ =
            window.add_event_listener_with_callback("beforeunload", leave.as_ref().unchecked_ref());
        let _ = window.add_event_listener_with_callback("popstate", back.as_ref().unchecked_ref());
    }
    leave.forget();
    back.forget();
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

/// Shows the browser's dialog for files; the chosen ones arrive as [dropped] files.
pub fn pick(_opens: bool, kind: &FileKind) -> Picked {
    let input = document().and_then(|document| document.create_element("input").ok());
    let Some(input) = input else {
        return Picked::NoDialog;
    };
    let input: HtmlInputElement = input.unchecked_into();
    input.set_type("file");
    input.set_multiple(true);
    let mut endings: Vec<String> = kind.endings.iter().map(|e| format!(".{e}")).collect();
    if kind.endings.contains(&"obj") {
        endings.push(".mtl".to_owned());
    }
    input.set_accept(&endings.join(","));
    let chosen = {
        let input = input.clone();
        Closure::once_into_js(move || spawn_local(read_files(all(input.files()))))
    };
    input.set_onchange(Some(chosen.unchecked_ref()));
    input.click();
    Picked::Nothing
}

/// Returns whether touch replaces the mouse.
pub fn fingers(ctx: &Context) -> bool {
    ctx.input(InputState::has_touch_screen)
}

/// Returns whether the pointing device is a finger, as the page's script says.
pub fn coarse() -> bool {
    has_mark("data-coarse")
}

/// Returns whether the wheel and swipes scroll the page around this one: in a figure that nobody has clicked, as the page's
/// script says.
pub fn page_scrolls() -> bool {
    has_mark("data-embed") && !has_mark("data-used")
}

/// Returns whether an event is the window's own, so that the browser does nothing with it.
pub fn takes(event: &eframe::egui::Event) -> bool {
    use eframe::egui::Event;
    let scrolls = matches!(
        event,
        Event::MouseWheel { .. }
            | Event::Zoom(_)
            | Event::PointerMoved(_)
            | Event::PointerButton { pressed: true, .. }
    );
    !(scrolls && page_scrolls())
}

/// Returns whether this page was loaded again, as its script says.
pub fn reloaded() -> bool {
    has_mark("data-again")
}

/// Returns the link and the place to which the browser went back since the last frame.
pub fn went() -> Option<(String, String)> {
    WENT.take()
}

/// Copies texts by the page's own way where the browser has no clipboard for scripts, as on plain http. A browser that
/// refuses shows the text, to be copied by hand.
pub fn copy(ctx: &Context) {
    if web_sys::window().is_none_or(|window| window.is_secure_context()) {
        return;
    }
    let mut texts = Vec::new();
    ctx.output_mut(|output| {
        output.commands.retain(|command| match command {
            OutputCommand::CopyText(text) => {
                texts.push(text.clone());
                false
            }
            _ => true,
        });
    });
    for text in texts {
        if let Some(copy) = function(COPY) {
            let _ = copy.call1(&JsValue::NULL, &text.into());
        }
    }
}

/// Returns a function of [`OWN`].
fn function(name: &str) -> Option<Function> {
    let own = Reflect::get(&js_sys::global(), &OWN.into()).ok()?;
    Reflect::get(&own, &name.into()).ok()?.dyn_into().ok()
}

/// Opens an address in a tab of its own, which learns nothing of this one; opens a mail address in the mail program.
pub fn open_address(_: &Context, address: &str) {
    let letter = address
        .get(..7)
        .is_some_and(|start| start.eq_ignore_ascii_case("mailto:"));
    let tab = if letter { "_self" } else { "_blank" };
    if let Some(window) = web_sys::window() {
        // A browser that refuses opens nothing.
        let _ = window.open_with_url_and_target_and_features(address, tab, "noopener");
    }
}

/// Does nothing: a page knows no folder.
pub fn show_folder(_: &Context, _: &std::path::Path) {}

pub fn set_title(_: &Context, title: &str) {
    document()
        .iter()
        .for_each(|document| document.set_title(title));
}

/// Enters or leaves full screen. A browser that refuses leaves the page as it is.
pub fn set_fullscreen(_: &Context, on: bool) {
    let Some(document) = document() else { return };
    if !on {
        document.exit_fullscreen();
    } else if let Some(page) = document.document_element() {
        let _ = page.request_fullscreen();
    }
}

/// Finishes a frame: updates whether the browser asks before it leaves, and answers requests for the picture once that is drawn; in
/// another place, and when the window has come to rest, updates the address to the link of the current view, and the browser's
/// history to its place.
pub fn end_frame(
    ctx: &Context,
    unsaved: bool,
    link: impl FnOnce() -> Option<String>,
    place: String,
    is_drawn: impl FnOnce() -> bool,
    picture: impl FnOnce() -> Option<Vec<u8>>,
) {
    if SHOWN_IN.replace(Some(language())) != Some(language()) {
        want_letters(ctx);
    }
    UNSAVED.set(unsaved);
    want_lessons(ctx);
    // A lesson that the address names opens once its text has arrived.
    let opened = are_there() || !address_has("lesson=");
    let is_in = |(_, known): &(String, String)| *known == place;
    let moved = SHOWN.with_borrow(|shown| !shown.as_ref().is_some_and(is_in));
    if (moved || mirror::is_at_rest())
        && opened
        && !ctx.input(|input| input.pointer.any_down())
        && let Some(link) = link()
    {
        follow(&link, place);
    }
    if ASKED.with_borrow(Vec::is_empty) {
        return;
    }
    if is_drawn() {
        let asked = ASKED.take();
        let picture = picture().map_or(JsValue::NULL, |bytes| Uint8Array::from(&*bytes).into());
        for give in asked {
            let _ = give.call1(&JsValue::NULL, &picture);
        }
    } else {
        ctx.request_repaint();
    }
}

/// Shows a link as the page's address, if it differs from the previous one. The first link is not shown, since nothing
/// has changed yet. A page embedded in another keeps its original address.
///
/// Another lesson, step or drawer is an entry of its own in the browser's history, so that its button goes back to the one
/// before.
fn follow(link: &str, place: String) {
    let now = (link.to_owned(), place);
    let before = SHOWN.with_borrow_mut(|known| known.replace(now.clone()));
    if before.as_ref() == Some(&now) || has_mark("data-embed") {
        return;
    }
    let Some(Ok(history)) = web_sys::window().map(|window| window.history()) else {
        return;
    };
    let (link, place) = now;
    let entry = Array::of2(&(&*link).into(), &(&*place).into());
    // A browser that refuses shows the old address.
    let _ = match before {
        None => history.replace_state(&entry, ""),
        Some((_, old)) if old == place => history.replace_state_with_url(&entry, "", Some(&*link)),
        Some(_) => history.push_state_with_url(&entry, "", Some(&*link)),
    };
}

fn address_has(key: &str) -> bool {
    let search = web_sys::window().and_then(|window| window.location().search().ok());
    search.is_some_and(|search| search.contains(key))
}

/// Records the entry of its history to which the browser went.
fn go_back(event: &PopStateEvent) {
    let entry: Array = event.state().dyn_into().unwrap_or_default();
    let (link, place) = (entry.get(0).as_string(), entry.get(1).as_string());
    let Some(entry) = link.zip(place) else { return };
    // It is in the address already.
    SHOWN.set(Some(entry.clone()));
    WENT.set(Some(entry));
    repaint();
}

/// Gives scripts `shadingLab.picture()`, which returns a promise of the picture as a PNG with its scene inside, and the
/// other functions that they can call.
fn offer(ctx: &Context) {
    let picture = Closure::<dyn Fn() -> Promise>::new(|| {
        repaint();
        Promise::new(&mut |give, _| ASKED.with_borrow_mut(|asked| asked.push(give)))
    });
    let page = js_sys::global();
    if let Ok(own) = Reflect::get(&page, &OWN.into()) {
        let _ = Reflect::set(&own, &PICTURE.into(), &picture.into_js_value());
        scripts::offer(&own);
        mirror::offer(&own, ctx);
    }
}

/// Fetches the Chinese texts, unless they are there.
pub async fn fetch_chinese_text() -> Result<(), JsValue> {
    if chinese_text().is_empty() {
        let text = fetch(CHINESE_TEXT).await?;
        set_chinese_text(String::from_utf8_lossy(&text).into_owned());
    }
    Ok(())
}

/// Sets the page's language, and fetches the texts and the font for the current language, once.
fn want_letters(ctx: &Context) {
    if let Some(root) = root() {
        let _ = root.set_attribute("lang", language().tag());
    }
    if language() != Language::TraditionalChinese || CHINESE_ASKED.replace(true) {
        return;
    }
    let ctx = ctx.clone();
    spawn_local(async move {
        let text = fetch_chinese_text().await;
        ctx.request_repaint();
        let font = fetch(CHINESE_FONT).await.map(|font| {
            set_chinese_font(font);
            theme::install_fonts(&ctx);
            ctx.request_repaint();
        });
        // Until then text is English, or drawn by the browser. What was not there is tried again when the language is next chosen.
        CHINESE_ASKED.set(text.is_ok() && font.is_ok());
    });
}

/// Fetches the lessons, without delaying the first picture.
fn want_lessons(ctx: &Context) {
    let now = ctx.input(|input| input.time);
    if are_there() || now - LESSONS_ASKED.get() < LESSONS_PAUSE {
        return;
    }
    LESSONS_ASKED.set(now);
    let ctx = ctx.clone();
    spawn_local(async move {
        if let Ok(texts) = fetch(LESSONS).await {
            take_texts(&String::from_utf8_lossy(&texts));
            ctx.request_repaint();
        }
    });
}

/// Fetches a file beside the page, in the version that belongs to it.
async fn fetch(name: &str) -> Result<Vec<u8>, JsValue> {
    let window = web_sys::window().ok_or(JsValue::NULL)?;
    let version = root().and_then(|root| root.get_attribute("data-version"));
    let address = format!("{name}?{}", version.unwrap_or_default());
    let response: Response = JsFuture::from(window.fetch_with_str(&address))
        .await?
        .into();
    if !response.ok() {
        return Err(response.status().into());
    }
    let content: ArrayBuffer = JsFuture::from(response.array_buffer()?).await?.into();
    Ok(Uint8Array::new(&content).to_vec())
}
