//! Which symbol of the equation is lit, with the control that it belongs to.

use crate::scene::Scene;
pub use crate::scene::Symbol;

/// Which symbol is lit. What the pointer is over this frame is shown the next, so that the order of painting does not
/// matter.
#[derive(Clone, Debug, Default)]
pub struct Lit {
    /// The symbol lit in this frame.
    pub now: Option<Symbol>,
    /// The symbol pointed at so far in this frame.
    pub next: Option<Symbol>,
    /// The symbol whose control is to come into view and take the keyboard.
    pub seek: Option<Symbol>,
    /// The scene whose values resetting returns to: the active pane's as opened.
    pub opened: Scene,
}

impl Lit {
    /// Ends a frame; true where what is lit has changed and another frame must show it.
    pub fn turn(&mut self) -> bool {
        let changed = self.now != self.next;
        self.now = self.next.take();
        changed
    }
}
