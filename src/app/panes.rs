//! Panes in the window: which scene each shows, and where a change goes.
//!
//! A pane's scene is derived from the document's. The controls edit the active pane's, [`AppState::shown`]; what has changed
//! in it goes to the document, except for what the pane has of its own:
//!
//! ```text
//!   document ──┬────────────────────────→ pane 0     a key that a pane sets itself changes there alone,
//!              ├── shading.mode=exact ──→ pane 1     any other changes everywhere
//!              └── object.segments=64 ──→ pane 2
//! ```

mod captions;
mod place;

pub use captions::paint;
pub use place::{PanePlace, on_wipe, pane_at, places};

use crate::scene::Scene;
use crate::scene::parameter::Parameter;

/// Which pane is being worked on, and what the panes show.
#[derive(Debug, Default)]
pub struct Panes {
    /// The pane whose scene the controls show, from 0.
    pub active: usize,
    /// Whether changes concern that pane alone.
    pub own: bool,
    /// The document's scene that the others are derived from; the first pane shows it.
    pub(super) document: Scene,
    /// The scenes of the panes beside the first.
    pub(super) others: Vec<Scene>,
}

/// A parameter and the number of the light that it belongs to.
pub(super) type Change = (&'static Parameter, usize);

impl Panes {
    /// The scene that a pane shows.
    pub fn scene(&self, pane: usize) -> &Scene {
        pane.checked_sub(1).and_then(|index| self.others.get(index)).unwrap_or(&self.document)
    }

    /// What differs in a scene from what the active pane shows.
    pub(super) fn changes(&self, scene: &Scene) -> Vec<Change> {
        let before = self.scene(self.active);
        before.differences(scene).filter(|(parameter, _)| parameter.section() != "compare").collect()
    }
}
