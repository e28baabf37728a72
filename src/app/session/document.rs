//! What is open: a scene, the model it shows, and where both came from; with undo and redo, one step a gesture.

use crate::document::{Loaded, open_picture};
use crate::geometry::Mesh;
use crate::lesson::{HandIn, HandInError, read_hand_in};
use crate::scene::Scene;
use crate::scene::presets::{self, Preset};
use crate::text::{Language, in_language, text};
use serde::{Deserialize, Serialize};
use std::collections::VecDeque;
use std::mem::replace;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A scene with its model.
#[derive(Clone, Debug, Default)]
pub struct Document {
    /// The scene.
    pub scene: Scene,
    /// The mesh of an object of kind `obj`.
    pub model: Option<Arc<Mesh>>,
    /// Where both came from.
    pub origin: Origin,
    /// What it is in the course.
    pub part: CoursePart,
}

/// What a document is in the course.
#[derive(Clone, Debug, Default)]
pub enum CoursePart {
    /// A scene like any other.
    #[default]
    None,
    /// The scene of a step of the lesson of this name.
    Step(String),
    /// The last picture of answers that were handed in; or why these do not count.
    HandIn(Arc<Result<HandIn, HandInError>>),
}

impl PartialEq for CoursePart {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::None, Self::None) => true,
            (Self::Step(a), Self::Step(b)) => a == b,
            (Self::HandIn(a), Self::HandIn(b)) => Arc::ptr_eq(a, b),
            _ => false,
        }
    }
}

/// Where a document came from.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Origin {
    /// The scene that the program starts with.
    #[default]
    New,
    /// A scene that comes with the program, by its name.
    BuiltIn(String),
    /// A file, or a picture with a scene inside.
    File(PathBuf),
}

impl From<Loaded> for Document {
    fn from(loaded: Loaded) -> Self {
        let Loaded {
            scene,
            model,
            name,
            path,
            ..
        } = loaded;
        Self {
            scene,
            model,
            origin: path.map_or(Origin::BuiltIn(name), Origin::File),
            part: CoursePart::None,
        }
        .with_hand_in()
    }
}

impl Document {
    /// The built-in scene of this name, if there is one.
    pub fn built_in(name: &str) -> Option<Self> {
        let scene = presets::find(name)?.scene();
        Some(Self {
            scene,
            origin: Origin::BuiltIn(name.to_owned()),
            ..Self::default()
        })
    }

    /// The same document with the answers that its picture holds, where it is one that was handed in.
    fn with_hand_in(mut self) -> Self {
        if let Origin::File(path) = &self.origin
            && let Ok(picture) = open_picture(path)
        {
            self.part = match read_hand_in(picture) {
                Err(HandInError::NoAnswers | HandInError::Picture(_)) => CoursePart::None,
                read => CoursePart::HandIn(Arc::new(read)),
            };
        }
        self
    }

    /// What its scene is called: its title, or the name of its file.
    pub fn title(&self) -> String {
        let title = self
            .preset()
            .map_or(&*self.scene.about.title, |preset| preset.title());
        if title.is_empty() {
            self.origin.name()
        } else {
            title.to_owned()
        }
    }

    /// What there is to see in its scene; may be empty.
    pub fn sentence(&self) -> &str {
        self.preset()
            .map_or(&*self.scene.about.sentence, |preset| preset.sentence())
    }

    /// The built-in scene that it comes from, whose words follow the language.
    fn preset(&self) -> Option<&'static Preset> {
        match &self.origin {
            Origin::BuiltIn(name) => presets::find(name),
            Origin::New => presets::find(presets::DEFAULT).filter(|preset| {
                let title = &self.scene.about.title;
                Language::ALL
                    .into_iter()
                    .any(|language| in_language(language, || preset.title()) == title)
            }),
            Origin::File(_) => None,
        }
    }

    /// The scene file that it was opened from or saved to.
    pub fn scene_file(&self) -> Option<PathBuf> {
        match &self.origin {
            Origin::File(path) if path.extension().is_some_and(|ending| ending == "toml") => {
                Some(path.clone())
            }
            _ => None,
        }
    }

    /// A name for a file with `ending` beside what is open.
    pub fn suggested(&self, ending: &str) -> String {
        let path = match &self.origin {
            Origin::File(path) => path.with_extension(ending),
            _ => PathBuf::from(self.origin.name()).with_extension(ending),
        };
        std::path::absolute(&path)
            .unwrap_or(path)
            .display()
            .to_string()
    }

    /// Whether the two show different models.
    pub fn model_differs(&self, other: &Self) -> bool {
        !same_model(self.model.as_ref(), other.model.as_ref())
    }

    /// Whether it came from this file.
    pub fn is_from(&self, file: &Path) -> bool {
        let absolute = |path: &Path| std::path::absolute(path).ok();
        matches!(&self.origin, Origin::File(path) if absolute(path) == absolute(file))
    }
}

impl Origin {
    /// What the window's title calls it: the name of the file or of the built-in scene.
    pub fn name(&self) -> String {
        match self {
            Self::New => "untitled".to_owned(),
            Self::BuiltIn(name) => name.clone(),
            Self::File(path) => path.file_name().map_or_else(
                || path.display().to_string(),
                |name| name.to_string_lossy().into_owned(),
            ),
        }
    }
}

/// Whether both are one model, or none.
pub fn same_model(a: Option<&Arc<Mesh>>, b: Option<&Arc<Mesh>>) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => Arc::ptr_eq(a, b),
        (a, b) => a.is_none() && b.is_none(),
    }
}

impl PartialEq for Document {
    fn eq(&self, other: &Self) -> bool {
        self.scene == other.scene
            && !self.model_differs(other)
            && self.origin == other.origin
            && self.part == other.part
    }
}

/// How many steps can be undone.
const DEPTH: usize = 200;
/// Changes of the same thing within this time, without a press of the pointer between them, are one step: turns of the
/// wheel, keys held down. Seconds.
const PAUSE: f64 = 0.8;

/// The documents that undo and redo lead to.
#[derive(Debug, Default)]
pub struct History {
    past: VecDeque<Document>,
    future: Vec<Document>,
    settled: Document,
    /// The name and the time of the last change that others may join.
    last: Option<(String, f64)>,
}

impl History {
    /// A history that begins with `document`.
    pub fn new(document: Document) -> Self {
        Self {
            settled: document,
            ..Self::default()
        }
    }

    /// Records what has become of the document by the end of a frame. While `held` (the pointer is down) changes
    /// gather; `time` is in seconds.
    pub fn observe(&mut self, document: &Document, held: bool, time: f64) {
        if held {
            self.last = None;
            return;
        }
        if self.settled == *document {
            return;
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
    }

    /// Takes the last step back.
    pub fn undo(&mut self, document: &mut Document) {
        self.observe(document, false, f64::INFINITY);
        if let Some(before) = self.past.pop_back() {
            *document = before.clone();
            self.future.push(replace(&mut self.settled, before));
            self.last = None;
        }
    }

    /// Takes the last step that was undone again.
    pub fn redo(&mut self, document: &mut Document) {
        if let Some(after) = self.future.pop() {
            *document = after.clone();
            self.past.push_back(replace(&mut self.settled, after));
            self.last = None;
        }
    }

    /// Whether undo or redo lead to a document of this origin.
    pub fn reaches(&self, origin: &Origin) -> bool {
        let steps = self.past.iter().chain(&self.future);
        steps
            .chain([&self.settled])
            .any(|document| document.origin == *origin)
    }

    /// What undo would take back.
    pub fn undoable(&self) -> Option<String> {
        self.past.back().map(|before| change(before, &self.settled))
    }

    /// What redo would do again.
    pub fn redoable(&self) -> Option<String> {
        self.future.last().map(|after| change(&self.settled, after))
    }
}

/// The name of what differs between two documents.
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

    /// A history that has seen each n, with the pointer held or not, at a time; and the last document.
    fn seen(frames: impl IntoIterator<Item = (f64, bool, f64)>) -> (History, Document) {
        let (mut history, mut document) = (History::new(with_n(1.0)), with_n(1.0));
        for (n, held, time) in frames {
            document = with_n(n);
            history.observe(&document, held, time);
        }
        (history, document)
    }

    /// The exponents that undoing leads to.
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
