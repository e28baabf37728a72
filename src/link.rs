//! A scene as a link, and back: `?scene=highlight&set=material.n=50&view=profile`.
//!
//! A link names the built-in scene that needs the fewest settings, then each key that differs in the form of `--set`,
//! then the view of the scene. A scene that does not fit, such as one with polygons of its own, is stored whole after
//! `#scene=`, as the compressed text of its scene file. Reading a link gives exactly the scene that it was written
//! from. A link contains neither a model's file nor its path, and no link makes the program open a file.
//! `docs/links.md` has the keys.
//!
//! Everything here is a pure function of its arguments.

mod encoding;
mod read;
mod shown;
mod write;

pub use encoding::{base64, encoded};
pub use read::{is_link, read};
pub use shown::{Shown, VIEWS};
pub use write::{Written, write};

use crate::scene::Scene;
use crate::text::text;
use std::fmt;

/// Address of the page that opens links: none yet, so that links begin with their `?`.
pub const PAGE: &str = "";

/// Name in links of the scene in which every key has its default.
pub const DEFAULTS: &str = "defaults";

/// Longest address of a page, in bytes.
const MOST_PAGE: usize = 500;
/// Longest text from `?` to `#`, in bytes. Written ones are much shorter.
const MOST_QUERY: usize = 8 << 10;
/// Longest link, in bytes.
const MOST_LINK: usize = 2 << 20;
/// Longest scene file inside a link, in bytes. Larger ones are refused before they are unpacked.
pub const MOST_TEXT: usize = 1 << 20;
/// Longest link in readable form, in bytes: the length that browsers, servers and messengers all accept.
pub const MOST_READABLE: usize = 2000;

/// A link that has been read.
#[derive(Clone, Debug, PartialEq)]
pub struct Link {
    /// The scene, valid by [`Scene::validate`], without a model.
    pub scene: Scene,
    /// Name: that of the built-in scene that it is based on, if it is still nearly the same, or "link".
    pub name: String,
    /// View of the scene.
    pub shown: Shown,
}

/// The reason why a text is not a link to a scene: one or more problems. Displayed, each takes a line with the
/// position and the key.
#[derive(Clone, Debug, PartialEq)]
pub struct LinkError {
    /// The problems in the order of the link, at least one.
    pub problems: Vec<LinkProblem>,
}

/// One error in a link.
#[derive(Clone, Debug, PartialEq)]
pub struct LinkProblem {
    /// The key: one of the link's own, or of the scene.
    pub key: String,
    /// The character at which the key or its setting begins, counted from 1.
    pub position: usize,
    /// Description of the error, with the key.
    pub words: String,
}

impl std::error::Error for LinkError {}

impl fmt::Display for LinkError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, problem) in self.problems.iter().enumerate() {
            let words = problem.words.as_str();
            let line = text!("link-problem", position = problem.position, words = words);
            write!(f, "{}{line}", if i > 0 { "\n" } else { "" })?;
        }
        Ok(())
    }
}

/// The reason why a scene cannot be written as a link.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum WriteError {
    /// It has too many polygons.
    #[error("{}", text!("link-scene-too-large", limit = MOST_TEXT >> 10))]
    TooLarge,
    /// It is not a scene that could be read back.
    #[error("{0}")]
    Unsound(LinkError),
}

/// Returns the address of a page as the start of links: without the part after `?` or `#`.
///
/// # Errors
/// A sentence that describes the problem.
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
