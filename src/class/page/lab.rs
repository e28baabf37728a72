//! The link to the program's own page, with the scene of a step.

use crate::lesson::{Element, Staged, element};
use crate::link::{Shown, write};
use crate::text::text;

/// The folder of the program's own page, as seen from the class's.
const FOLDER: &str = "lab/";

/// The link to a step's scene, or a sentence that says why there is none.
pub enum LabLink {
    To(String),
    Missing(&'static str),
}

impl LabLink {
    /// Returns the link. Where the page's files are not there, the script puts a sentence in its place.
    pub fn of(staged: &Staged) -> Self {
        let origin = staged.path.is_none().then_some(&*staged.name);
        // A view could show more than the step does.
        let shown = Shown {
            view: None,
            ..staged.shown.clone()
        };
        match write(FOLDER, &staged.scene, origin, &shown) {
            Ok(written) if written.left_out.is_none() => Self::To(written.link),
            _ => Self::Missing(text!("phone-no-model")),
        }
    }

    /// Returns the link as HTML, or the sentence.
    pub fn html(&self) -> Element {
        match self {
            Self::To(address) => {
                let link = element("a")
                    .class("lab")
                    .attribute("href", address)
                    .attribute("target", "_blank")
                    .attribute("rel", "noopener");
                element("p").with(link.with(text!("phone-lab")))
            }
            Self::Missing(why) => element("p").class("quiet").with(*why),
        }
    }
}
