//! Undo and redo, one step per gesture.

use super::document::{Document, Origin};
use crate::text::text;
use std::collections::VecDeque;
use std::mem::replace;

/// Maximum number of steps that can be undone.
const DEPTH: usize = 200;
/// Maximum time between changes of the same parameter that form one step if the pointer is not pressed between them,
/// such as turns of the wheel or held keys. Seconds.
const PAUSE: f64 = 0.8;

/// The documents that undo and redo lead to.
#[derive(Debug, Default)]
pub struct History {
    past: VecDeque<Document>,
    future: Vec<Document>,
    settled: Document,
    /// The name and the time of the last change that later ones may join.
    last: Option<(String, f64)>,
}

impl History {
    /// Creates a history that begins with `document`.
    pub fn new(document: Document) -> Self {
        Self {
            settled: document,
            ..Self::default()
        }
    }

    /// Records the document at the end of a frame. While `held` (the pointer is down), changes accumulate; `time` is in
    /// seconds. Returns whether the document has begun a new step.
    pub fn observe(&mut self, document: &Document, held: bool, time: f64) -> bool {
        if held {
            self.last = None;
            return false;
        }
        if self.settled == *document {
            return false;
        }
        let change = change(&self.settled, document);
        let goes_on = self
            .last
            .as_ref()
            .is_some_and(|(name, when)| *name == change && time - when < PAUSE);
        let before = replace(&mut self.settled, document.clone());
        if !goes_on {
            self.past.push_back(before);
            if self.past.len() > DEPTH {
                self.past.pop_front();
            }
        }
        self.future.clear();
        self.last = Some((change, time));
        !goes_on
    }

    /// Undoes the last step.
    pub fn undo(&mut self, document: &mut Document) {
        self.observe(document, false, f64::INFINITY);
        if let Some(before) = self.past.pop_back() {
            *document = before.clone();
            self.future.push(replace(&mut self.settled, before));
            self.last = None;
        }
    }

    /// Redoes the last step that was undone.
    pub fn redo(&mut self, document: &mut Document) {
        if let Some(after) = self.future.pop() {
            *document = after.clone();
            self.past.push_back(replace(&mut self.settled, after));
            self.last = None;
        }
    }

    /// Returns whether undo or redo lead to a document of this origin.
    pub fn reaches(&self, origin: &Origin) -> bool {
        let steps = self.past.iter().chain(&self.future);
        steps
            .chain([&self.settled])
            .any(|document| document.origin == *origin)
    }

    /// Returns the name of the change that undo would revert.
    pub fn undoable(&self) -> Option<String> {
        self.past.back().map(|before| change(before, &self.settled))
    }

    /// Returns the name of the change that redo would repeat.
    pub fn redoable(&self) -> Option<String> {
        self.future.last().map(|after| change(&self.settled, after))
    }
}

/// Returns the name of the difference between two documents.
fn change(before: &Document, after: &Document) -> String {
    let same = before.origin == after.origin && before.part == after.part;
    if !same || before.model_differs(after) {
        return text!("change-opening").to_owned();
    }
    let (a, b) = (&before.scene, &after.scene);
    if a.lights.len() != b.lights.len() {
        return text!("change-lights").to_owned();
    }
    if a.compare.panes != b.compare.panes {
        return text!("change-panes").to_owned();
    }
    let mut differing = a.differences(b);
    let Some((first, index)) = differing.next() else {
        return text!("change-one").to_owned();
    };
    let mut others = differing.map(|(parameter, _)| parameter.section());
    match others.next() {
        None => first.full_name(index),
        Some(section) if section == first.section() && others.all(|other| other == section) => {
            section.replace('_', " ")
        }
        Some(_) => text!("change-several").to_owned(),
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

    /// Returns a history that has observed each n, with the pointer held or not, at a time; and the last document.
    fn seen(frames: impl IntoIterator<Item = (f64, bool, f64)>) -> (History, Document) {
        let (mut history, mut document) = (History::new(with_n(1.0)), with_n(1.0));
        for (n, held, time) in frames {
            document = with_n(n);
            history.observe(&document, held, time);
        }
        (history, document)
    }

    /// Returns the exponents that undoing leads to.
    fn undone((mut history, mut document): (History, Document)) -> Vec<f64> {
        let mut exponents = vec![];
        while history.undoable().is_some() {
            history.undo(&mut document);
            exponents.push(document.scene.material.n);
        }
        exponents
    }

    #[test]
    fn a_drag_is_one_step() {
        let drag = (2..50).map(|n| (f64::from(n), true, f64::from(n) * 0.01));
        let (mut history, mut document) = seen(drag.chain([(49.0, false, 1.0)]));
        assert_eq!(history.undoable().as_deref(), Some("n specular exponent"));
        history.undo(&mut document);
        assert_eq!((&document, history.undoable()), (&with_n(1.0), None));
        assert_eq!(history.redoable().as_deref(), Some("n specular exponent"));
        history.redo(&mut document);
        assert_eq!(document, with_n(49.0));
    }

    #[test]
    fn turns_of_the_wheel_are_one_step_until_a_pause_and_drags_are_not() {
        assert_eq!(
            undone(seen([
                (2.0, false, 0.0),
                (3.0, false, 0.5),
                (4.0, false, 3.0)
            ])),
            [3.0, 1.0]
        );
        assert_eq!(
            undone(seen([
                (2.0, false, 0.0),
                (2.0, true, 0.1),
                (3.0, false, 0.2)
            ])),
            [2.0, 1.0]
        );
    }

    #[test]
    fn a_change_after_undo_forgets_what_was_undone() {
        let (mut history, mut document) = seen([(2.0, false, 0.0)]);
        history.undo(&mut document);
        history.observe(&with_n(5.0), false, 9.0);
        assert_eq!(history.redoable(), None);
    }

    #[test]
    fn the_past_is_bounded() {
        let many = (2..1000).map(|n| (f64::from(n), false, f64::from(n) * 10.0));
        assert_eq!(undone(seen(many)).len(), DEPTH);
    }
}
