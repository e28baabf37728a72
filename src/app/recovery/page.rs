//! Kept work of a web page, in the browser's local storage. A tab keeps the name of its own in its session, so that it finds
//! its work again after it was loaded anew; what no tab has adopted or deleted is offered to the next.

use crate::document::give;
use crate::text::text;
use std::path::{Path, PathBuf};
use web_sys::Storage;

/// What the names begin with; a number and the ending follow.
const NAME: &str = "shading-lab-work-";
/// Where a tab keeps the name of its own.
const OWN: &str = "shading-lab-own";

/// An entry for kept work.
pub struct Slot {
    pub path: PathBuf,
}

fn local() -> Option<Storage> {
    web_sys::window()?.local_storage().ok()?
}

/// An entry for this tab, and the latest that there is. Nothing where the browser stores nothing.
pub fn find(_: &Path) -> Option<(Slot, Option<Slot>)> {
    let (storage, session) = (local()?, web_sys::window()?.session_storage().ok()??);
    let slot = |name: String| Slot { path: name.into() };
    let names = (0..storage.length().ok()?).filter_map(|index| storage.key(index).ok()?);
    let number = |name: &str| -> Option<u64> {
        name.strip_prefix(NAME)?.strip_suffix(".toml")?.parse().ok()
    };
    let kept = names.filter(|name| number(name).is_some());
    let own = session.get_item(OWN).ok().flatten();
    let left = kept.max_by_key(|name| (own.as_ref() == Some(name), number(name)));
    let name = format!("{NAME}{}.toml", js_sys::Date::now());
    session.set_item(OWN, &name).ok()?;
    Some((slot(name), left.map(slot)))
}

/// What an entry holds, which can be opened under its name from then on.
pub fn read(path: &Path) -> String {
    let read = || local()?.get_item(path.to_str()?).ok()?;
    let text: String = read().unwrap_or_default();
    give(path.to_owned(), text.clone().into_bytes());
    text
}

/// Writes it, or says why not.
pub fn write(path: &Path, text: &str) -> Result<(), String> {
    let written = || local()?.set_item(path.to_str()?, text).ok();
    written().ok_or_else(|| text!("page-full").to_owned())
}

pub fn remove(path: &Path) -> Option<()> {
    local()?.remove_item(path.to_str()?).ok()
}
