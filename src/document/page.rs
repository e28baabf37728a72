//! The files of a web page: those given to it are kept by name while the page is open, and written ones are
//! downloaded.

use super::error::{LoadError, SaveError};
use crate::text::Message;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::io::{self, Cursor, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{Blob, HtmlAnchorElement, Url};

/// Time by which a download has been read, milliseconds.
const READ_WITHIN: i32 = 60_000;

thread_local! {
    static GIVEN: RefCell<BTreeMap<PathBuf, Arc<[u8]>>> = const { RefCell::new(BTreeMap::new()) };
}

/// Keeps a file given to the page, in place of one of that name.
pub fn give(path: PathBuf, content: Vec<u8>) {
    GIVEN.with_borrow_mut(|given| given.insert(path, content.into()));
}

/// Opens a file given to the page; returns it with its length in bytes.
pub fn open(path: &Path, expected: Message) -> Result<(Cursor<Arc<[u8]>>, u64), LoadError> {
    let content = GIVEN.with_borrow(|given| given.get(path).cloned());
    let content = content.ok_or_else(|| {
        LoadError::unreadable(path, expected, &io::Error::from(io::ErrorKind::NotFound))
    })?;
    let length = content.len() as u64;
    Ok((Cursor::new(content), length))
}

/// Downloads a file by `content`, under the last part of its path.
pub fn write_whole(
    path: &Path,
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), SaveError> {
    let mut bytes = Vec::new();
    let unwritable = |source| SaveError::Unwritable {
        path: path.to_owned(),
        source,
    };
    content(&mut bytes).map_err(unwritable)?;
    let name = path
        .file_name()
        .unwrap_or(path.as_os_str())
        .to_string_lossy();
    download(&name, &bytes).map_err(|error| unwritable(io::Error::other(format!("{error:?}"))))
}

/// Downloads several texts.
pub fn write_texts(files: &[(PathBuf, &str)]) -> Result<(), SaveError> {
    let mut files = files.iter();
    files.try_for_each(|(path, text)| write_whole(path, |out| out.write_all(text.as_bytes())))
}

/// Accepts any target, since a download can always be started.
pub fn check_target(_: &Path) -> Result<(), SaveError> {
    Ok(())
}

/// Saves by a link that is clicked for the user, the only way that every browser supports.
fn download(name: &str, bytes: &[u8]) -> Result<(), JsValue> {
    let document = web_sys::window()
        .and_then(|window| window.document())
        .ok_or(JsValue::NULL)?;
    let parts = js_sys::Array::of1(&js_sys::Uint8Array::from(bytes));
    let blob = Blob::new_with_u8_array_sequence(&parts)?;
    let url = Url::create_object_url_with_blob(&blob)?;
    let link: HtmlAnchorElement = document.create_element("a")?.unchecked_into();
    link.set_href(&url);
    link.set_download(name);
    link.click();
    // Some browsers read it only later.
    let forget = Closure::once_into_js(move || _ = Url::revoke_object_url(&url));
    let window = web_sys::window().ok_or(JsValue::NULL)?;
    window
        .set_timeout_with_callback_and_timeout_and_arguments_0(forget.unchecked_ref(), READ_WITHIN)
        .map(|_| ())
}
