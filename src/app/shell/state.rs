//! The state of the window, and the operations on several parts of it.

use crate::app::course::Course;
use crate::app::session::Session;
use crate::app::session::action::Requests;
use crate::app::session::appearance::ViewName;
use crate::app::session::document::{CoursePart, Document, Origin};
use crate::app::session::notice::Notice;
use crate::app::session::window::WindowState;
use crate::app::shell::dialog::Dialog;
use crate::text::text;
use std::path::PathBuf;

/// The state of the window: a session, its appearance, and the course. Each panel is a function of the parts
/// that it needs.
#[derive(Default)]
pub struct AppState {
    /// The open document, with its history.
    pub session: Session,
    /// The appearance and the state of the views.
    pub window: WindowState,
    /// The lessons, with the answers given.
    pub course: Course,
    /// The actions requested in this frame, by button, menu or key.
    pub requests: Requests,
    /// The open dialog.
    pub dialog: Option<Dialog>,
    /// The path from the desktop's own dialog, which has asked whether to replace the file.
    pub agreed: Option<PathBuf>,
    /// True if the desktop turned out to have no file dialog.
    pub no_dialog: bool,
    /// The decision whether to close the window.
    pub leaving: Leaving,
}

impl AppState {
    /// Shows another document, in the view that its scene names; undo returns to the current one. Returns
    /// whether the document is shown, see [`Session::replace`].
    pub fn open(&mut self, document: Document) -> bool {
        let changed = self.session.modified();
        let before = self.session.document().origin.name();
        if !self.replace(document) {
            return false;
        }
        if changed {
            let text = text!("opened-over", name = before);
            self.session.notice = Some(Notice::undoable(text));
        }
        let Document {
            scene,
            origin,
            part,
            ..
        } = self.session.document();
        self.window.welcome = false;
        if let Some(view) = ViewName::named(&scene.about.view) {
            self.window.show_view(view);
        }
        if let CoursePart::HandIn(_) = part {
            self.window.show_view(ViewName::Course);
        }
        if let Origin::File(path) = origin {
            self.window.appearance.remember(path);
        }
        true
    }

    /// Replaces the current document. Returns whether the new one is shown, see [`Session::replace`].
    pub fn replace(&mut self, document: Document) -> bool {
        let went = self.session.replace(document);
        if went {
            self.course.gliding = None;
            self.window.appearance.profile.begin();
            self.follow_document();
        }
        went
    }
}

/// A decision whether to close the window.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Leaving {
    #[default]
    No,
    OnceSaved,
    /// A decision to close, even with unsaved work.
    Now,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::presets;

    #[test]
    fn opening_a_built_in_scene_opens_its_view() {
        for preset in presets::ALL
            .iter()
            .filter(|preset| preset.name != presets::DEFAULT)
        {
            let mut state = AppState::default();
            state.open(Document::built_in(preset.name).expect("a built-in scene"));
            let opened = serde_json::to_value(state.window.appearance.view).expect("a word");
            assert_eq!(opened, preset.view(), "{}", preset.name);
        }
    }
}
