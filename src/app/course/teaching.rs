//! The live class that is taught from this window.

use crate::class::{Command, Live, Snapshot};
use crate::figure::QrCode;
use crate::lesson::Phase;

/// A class with what the lecturer has chosen to see of it.
pub struct Teaching {
    pub live: Live,
    /// The address as a code; none of one that is too long.
    pub code: Option<QrCode>,
    /// True if the address fills the view, for those who join.
    pub joining: bool,
    /// True if the right answer is drawn among those of the class before it is explained.
    pub right: bool,
    /// True if the list of students has their names.
    pub names: bool,
}

impl Teaching {
    /// Opens a class in the window.
    pub fn new(live: Live) -> Self {
        let code = QrCode::new(live.address());
        Self {
            live,
            code,
            joining: true,
            right: false,
            names: false,
        }
    }

    /// Returns what there is to see of the class.
    pub fn seen(&self) -> Snapshot {
        self.live.room().snapshot()
    }

    /// Returns whether a step, from 0, of the lesson with this name is explained to the class.
    pub fn explains(&self, lesson: &str, step: usize) -> bool {
        let pace = self.live.room().pace();
        let here = self.live.room().lesson().name == lesson && pace.step == step + 1;
        here && pace.phase == Phase::Explain
    }

    /// Returns what comes next.
    pub fn onward(seen: &Snapshot) -> Command {
        match seen.pace.phase {
            Phase::Ask => Command::ShowAnswers,
            Phase::Spread => Command::Explain,
            _ => Command::Next,
        }
    }

    /// Does what the lecturer asks for. Returns the step, from 0, if the class has gone to another one.
    pub fn perform(&mut self, command: Command) -> Option<usize> {
        let room = self.live.room();
        let before = room.pace().step;
        if !room.perform(command) {
            return None;
        }
        let after = room.pace().step;
        self.joining = false;
        if command == Command::AskAgain || after != before {
            self.right = false;
        }
        (after != before).then(|| after - 1)
    }
}
