//! Undo and redo: a bounded row of documents, one step a gesture.

use super::document::Document;
use std::collections::VecDeque;

/// How many steps can be undone.
const DEPTH: usize = 200;
/// Changes of the same thing within this time, without a press of the pointer between them, are one step: turns of the
/// wheel, keys held down. Seconds.
const PAUSE: f64 = 0.8;

/// The steps that can be undone and redone.
#[derive(Debug, Default)]
pub struct History {
    past: VecDeque<Step>,
    future: Vec<Step>,
    settled: Document,
    last: Option<(String, f64)>,
}

/// A document and the name of the change that left it.
#[derive(Debug)]
struct Step {
    document: Document,
    change: String,
}

impl History {
    /// A history that begins with `document`.
    pub fn new(document: Document) -> Self {
        Self { settled: document, ..Self::default() }
    }

    /// Records what has become of the document by the end of a frame. While `held` (the pointer is down) changes
    /// gather; `time` is in seconds. Returns whether a change is settled or waits to be.
    pub fn observe(&mut self, document: &Document, held: bool, time: f64) {
        if held {
            self.last = None;
            return;
        }
        if self.settled == *document {
            return;
        }
        let change = change(&self.settled, document);
        let goes_on = self.last.as_ref().is_some_and(|(name, when)| *name == change && time - when < PAUSE);
        let before = std::mem::replace(&mut self.settled, document.clone());
        if !goes_on {
            self.past.push_back(Step { document: before, change: change.clone() });
            if self.past.len() > DEPTH {
                self.past.pop_front();
            }
        }
        self.future.clear();
        self.last = Some((change, time));
    }

    /// Takes the last step back.
    pub fn undo(&mut self, document: &mut Document) {
        let unsettled = self.settled != *document;
        if unsettled {
            self.observe(&document.clone(), false, f64::INFINITY);
        }
        if let Some(step) = self.past.pop_back() {
            self.future.push(Step { document: std::mem::replace(document, step.document), change: step.change });
            self.settled = document.clone();
            self.last = None;
        }
    }

    /// Takes the last step that was undone again.
    pub fn redo(&mut self, document: &mut Document) {
        if let Some(step) = self.future.pop() {
            self.past.push_back(Step { document: std::mem::replace(document, step.document), change: step.change });
            self.settled = document.clone();
            self.last = None;
        }
    }

    /// What undo would take back.
    pub fn undoable(&self) -> Option<&str> {
        self.past.back().map(|step| step.change.as_str())
    }

    /// What redo would do again.
    pub fn redoable(&self) -> Option<&str> {
        self.future.last().map(|step| step.change.as_str())
    }
}

/// The name of what differs between two documents.
fn change(before: &Document, after: &Document) -> String {
    if before.origin != after.origin || before.model_differs(after) {
        return "opening".to_owned();
    }
    let (a, b) = (&before.scene, &after.scene);
    if a.lights.len() != b.lights.len() {
        return "lights".to_owned();
    }
    if a.compare.panes != b.compare.panes {
        return "panes".to_owned();
    }
    let mut differing = a.differences(b);
    let Some((first, index)) = differing.next() else { return "change".to_owned() };
    let mut others = differing.map(|(parameter, _)| parameter.section());
    match others.next() {
        None => first.full_name(index),
        Some(section) if section == first.section() && others.all(|other| other == section) => {
            section.replace('_', " ")
        }
        Some(_) => "several settings".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with_n(n: f64) -> Document {
        let mut document = Document::default();
        document.scene.material.n = n;
        document
    }

    #[test]
    fn a_drag_is_one_step() {
        let mut history = History::new(with_n(1.0));
        for n in 2..50 {
            history.observe(&with_n(f64::from(n)), true, f64::from(n) * 0.01);
        }
        let mut document = with_n(49.0);
        history.observe(&document, false, 1.0);
        assert_eq!(history.undoable(), Some("n specular exponent"));
        history.undo(&mut document);
        assert_eq!(document, with_n(1.0));
        assert_eq!(history.undoable(), None);
        history.redo(&mut document);
        assert_eq!(document, with_n(49.0));
    }

    #[test]
    fn turns_of_the_wheel_are_one_step_until_a_pause() {
        let mut history = History::new(with_n(1.0));
        history.observe(&with_n(2.0), false, 0.0);
        history.observe(&with_n(3.0), false, 0.5);
        history.observe(&with_n(4.0), false, 3.0);
        let mut document = with_n(4.0);
        history.undo(&mut document);
        assert_eq!(document, with_n(3.0));
        history.undo(&mut document);
        assert_eq!(document, with_n(1.0));
    }

    #[test]
    fn two_drags_are_two_steps_however_quick() {
        let mut history = History::new(with_n(1.0));
        history.observe(&with_n(2.0), false, 0.0);
        history.observe(&with_n(2.0), true, 0.1);
        history.observe(&with_n(3.0), false, 0.2);
        let mut document = with_n(3.0);
        history.undo(&mut document);
        assert_eq!(document, with_n(2.0));
    }

    #[test]
    fn a_change_after_undo_forgets_what_was_undone() {
        let mut history = History::new(with_n(1.0));
        let mut document = with_n(2.0);
        history.observe(&document, false, 0.0);
        history.undo(&mut document);
        history.observe(&with_n(5.0), false, 9.0);
        assert_eq!(history.redoable(), None);
    }

    #[test]
    fn the_past_is_bounded() {
        let mut history = History::new(with_n(0.0));
        for n in 1..1000 {
            history.observe(&with_n(f64::from(n)), false, f64::from(n) * 10.0);
        }
        assert_eq!(history.past.len(), DEPTH);
    }
}
