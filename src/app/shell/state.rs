//! Everything that the window remembers, and what concerns several parts of it at once.

use crate::app::course::Course;
use crate::app::session::Session;
use crate::app::session::action::Requests;
use crate::app::session::appearance::ViewName;
use crate::app::session::document::{CoursePart, Document, Origin};
use crate::app::session::window::WindowState;
use crate::app::shell::dialog::Dialog;
use std::path::PathBuf;

/// The state of the window: a session, how it is looked at, and the course. Each panel is a function of the parts that it needs.
#[derive(Default)]
pub struct AppState {
    /// What is open.
    pub session: Session,
    /// How it is looked at.
    pub window: WindowState,
    /// The lessons, and what was answered.
    pub course: Course,
    /// What was asked for in this frame, by button, menu or key.
    pub requests: Requests,
    /// The dialog that is open.
    pub dialog: Option<Dialog>,
    /// The path that the desktop's own dialog gave, which has asked whether to replace the file.
    pub agreed: Option<PathBuf>,
    /// Whether the desktop turned out to have no dialog for files.
    pub no_dialog: bool,
    /// Whether the window is about to close, and what was asked about that.
    pub leaving: Leaving,
}

impl AppState {
    /// Shows another document, in the view that its scene names; the present one is a step of undo away. Returns whether it is shown,
    /// see [`Session::replace`].
    pub fn open(&mut self, document: Document) -> bool {
        if !self.replace(document) {
            return false;
        }
        let Document {
            scene,
            origin,
            part,
            ..
        } = self.session.document();
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

    /// Puts another document in the place of this one, see [`Session::replace`].
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

/// Whether the window is to close.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Leaving {
    #[default]
    No,
    OnceSaved,
    /// Whatever is unsaved.
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
