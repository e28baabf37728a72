//! A scene as a link, and back: `?scene=highlight&set=material.n=50&view=profile`.
//!
//! A link names the built-in scene that needs the fewest settings, then each key that differs as `--set` has it, then what is
//! shown of the scene. What does not fit, such as a scene's own polygons, goes as a whole into what follows `#scene=`: the
//! compressed text of its scene file. Reading a link gives the very scene that it was written from. A model's file does not
//! travel, nor does its path, and no link makes the program open a file. `docs/links.md` has the keys.
//!
//! Everything here is a pure function of its arguments.

mod encoding;
mod read;
mod shown;
mod write;

pub use encoding::base64;
pub use read::{is_link, read};
pub use shown::{Shown, VIEWS};
pub use write::{Written, write};

use crate::scene::{Scene, nearest};
use crate::text::text;
use std::fmt;

/// Where the page is that opens links: nowhere yet, so that links begin with their `?`.
pub const PAGE: &str = "";

/// The name, in links, of a scene in which every key has its default.
pub const DEFAULTS: &str = "defaults";

/// Longest address of a page, in bytes.
const MOST_PAGE: usize = 500;
/// Longest text from `?` to `#`, in bytes. Those that are written are much shorter.
const MOST_QUERY: usize = 8 << 10;
/// Longest link, in bytes.
const MOST_LINK: usize = 2 << 20;
/// Longest scene file inside a link, in bytes. What unpacks to more is refused before it is unpacked.
pub const MOST_TEXT: usize = 1 << 20;
/// The longest link that is written in the readable way, in bytes: what browsers, servers and messengers agree on.
pub const MOST_READABLE: usize = 2000;

/// A link that has been read.
#[derive(Clone, Debug, PartialEq)]
pub struct Link {
    /// As [`Scene::validate`] has it, without a model.
    pub scene: Scene,
    /// What to call it: the built-in scene that it names, if it is still about the same, or "link".
    pub name: String,
    /// What is shown of the scene.
    pub shown: Shown,
}

/// Why a text is not a link to a scene: one problem or more. Displayed, each takes a line with the place and the key.
#[derive(Clone, Debug, PartialEq)]
pub struct LinkError {
    /// At least one, in the order of the link.
    pub problems: Vec<LinkProblem>,
}

/// One thing that is wrong with a link.
#[derive(Clone, Debug, PartialEq)]
pub struct LinkProblem {
    /// The key: one of the link's own, or of the scene.
    pub key: String,
    /// The character at which the key or its setting begins, counted from 1.
    pub position: usize,
    /// What is wrong, with the key.
    pub words: String,
}

impl std::error::Error for LinkError {}

impl fmt::Display for LinkError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (
            i,
            LinkProblem {
                position, words, ..
            },
        ) in self.problems.iter().enumerate()
        {
            let line = text!("link-problem", position = *position, words = words.as_str());
            write!(f, "{}{line}", if i > 0 { "\n" } else { "" })?;
        }
        Ok(())
    }
}

/// Why a scene cannot be written as a link.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum WriteError {
    /// It has too many polygons.
    #[error("{}", text!("link-scene-too-large", limit = MOST_TEXT >> 10))]
    TooLarge,
    /// It is no scene that could be read again.
    #[error("{0}")]
    Unsound(LinkError),
}

/// The address of a page as links begin with it: without what follows `?` or `#`.
///
/// # Errors
/// What is wrong with it, in a sentence.
pub fn page(address: &str) -> Result<String, String> {
    let address = address.trim();
    let end = address.find(['?', '#']).unwrap_or(address.len());
    let page = &address[..end];
    let odd = |c: char| c.is_whitespace() || c.is_control() || "<>\"`\\^{|}".contains(c);
    let host = ["https://", "http://", "file://"]
        .into_iter()
        .find_map(|scheme| encoding::after(page, scheme));
    if page.len() > MOST_PAGE || page.contains(odd) || host.is_none_or(str::is_empty) {
        return Err(text!("link-no-page").to_owned());
    }
    Ok(page.to_owned())
}

/// A name among `known` that was probably meant, in words to append.
fn did_you_mean<'a>(name: &str, known: impl Iterator<Item = &'a str>) -> String {
    nearest(name, known)
        .map(|meant| text!("link-did-you-mean", name = meant))
        .unwrap_or_default()
}
