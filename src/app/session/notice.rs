//! A message about the last action.

use super::action::Action;
use crate::app::system;
use std::path::Path;

/// A message about the last action, with what the window offers to do about it.
#[derive(Clone, Debug, Default)]
pub struct Notice {
    pub text: String,
    /// The action of the button beside the message.
    pub offer: Option<Action>,
    /// True once the change that the notice speaks of is a step of the history. After a further step, undo would take back
    /// something else.
    pub recorded: bool,
    /// The time at which it was first shown, in seconds; `None` before.
    pub since: Option<f64>,
}

impl Notice {
    /// Creates a notice about a file that was written, which offers to show its folder. A web page downloads its files and
    /// knows no folder.
    pub fn written(text: String, path: &Path) -> Self {
        let folder = path.parent().filter(|_| !system::PAGE);
        Self {
            text,
            offer: folder.map(|folder| Action::ShowFolder(folder.to_owned())),
            ..Self::default()
        }
    }

    /// Creates a notice about a change, which offers to undo it.
    pub fn undoable(text: impl Into<String>) -> Self {
        Self {
            text: text.into(),
            offer: Some(Action::Undo),
            ..Self::default()
        }
    }
}

impl From<String> for Notice {
    fn from(text: String) -> Self {
        Self {
            text,
            ..Self::default()
        }
    }
}

impl From<&str> for Notice {
    fn from(text: &str) -> Self {
        text.to_owned().into()
    }
}
