//! Kept work of a web page, in the browser's local storage. A tab stores the name of its own entry in its session
//! storage, so that it finds its work again after a reload, and holds the browser's lock of that name while it is open.
//! Work that no tab holds, and that none has adopted or deleted, is offered to the next tab.

use crate::document::give;
use crate::text::text;
use js_sys::{Array, Function, Reflect};
use std::path::{Path, PathBuf};
use wasm_bindgen::{JsCast, JsValue};
use web_sys::Storage;

/// The prefix of entry names; a number and the extension follow.
const NAME: &str = "shading-lab-work-";
/// The key under which a tab stores the name of its own entry.
const OWN: &str = "shading-lab-own";
/// The page's own object.
const PAGE: &str = "shadingLab";
/// The names that other tabs held when the page was opened, put into [`PAGE`] by its script.
const HELD: &str = "held";
/// The function of [`PAGE`] that holds a name.
const HOLD: &str = "hold";

/// An entry for kept work.
pub struct Slot {
    pub path: PathBuf,
}

fn local() -> Option<Storage> {
    web_sys::window()?.local_storage().ok()?
}

/// Returns an entry for this tab, and the latest one that was left behind. Returns `None` if the browser stores
/// nothing.
pub fn find(_: &Path) -> Option<(Slot, Option<Slot>)> {
    let (storage, session) = (local()?, web_sys::window()?.session_storage().ok()??);
    let page = Reflect::get(&js_sys::global(), &PAGE.into()).unwrap_or_default();
    let of_page = |name: &str| Reflect::get(&page, &name.into()).unwrap_or_default();
    let hold: Option<Function> = of_page(HOLD).dyn_into().ok();
    let slot = |name: String| {
        if let Some(hold) = &hold {
            let _ = hold.call1(&JsValue::NULL, &(&*name).into());
        }
        Slot { path: name.into() }
    };
    let held: Array = of_page(HELD).dyn_into().unwrap_or_default();
    let held: Vec<String> = held.iter().filter_map(|name| name.as_string()).collect();
    let names = (0..storage.length().ok()?).filter_map(|index| storage.key(index).ok()?);
    let number = |name: &str| -> Option<u64> {
        name.strip_prefix(NAME)?.strip_suffix(".toml")?.parse().ok()
    };
    let own = session.get_item(OWN).ok().flatten();
    // Before a reload, this tab itself held its own.
    let free = |name: &String| own.as_ref() == Some(name) || !held.contains(name);
    let kept = names.filter(|name| number(name).is_some() && free(name));
    let left = kept.max_by_key(|name| (own.as_ref() == Some(name), number(name)));
    let name = format!("{NAME}{}.toml", js_sys::Date::now());
    session.set_item(OWN, &name).ok()?;
    Some((slot(name), left.map(slot)))
}

/// Returns the content of an entry, which can be opened under its name from then on.
pub fn read(path: &Path) -> String {
    let read = || local()?.get_item(path.to_str()?).ok()?;
    let text: String = read().unwrap_or_default();
    give(path.to_owned(), text.clone().into_bytes());
    text
}

/// Writes an entry.
///
/// # Errors
/// The browser does not store it.
pub fn write(path: &Path, text: &str) -> Result<(), String> {
    let written = || {
        let name = path.to_str()?;
        local()?.set_item(name, text).ok()?;
        // An adopted entry has another name than the one this tab began with.
        let session = web_sys::window()?.session_storage().ok()??;
        session.set_item(OWN, name).ok()
    };
    written().ok_or_else(|| text!("page-full").to_owned())
}

pub fn remove(path: &Path) -> Option<()> {
    local()?.remove_item(path.to_str()?).ok()
}
