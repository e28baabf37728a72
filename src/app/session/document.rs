//! A document: a scene, its model, and the origin of both.

use crate::document::{Loaded, open_picture};
use crate::geometry::Mesh;
use crate::lesson::{HandIn, HandInError, read_hand_in};
use crate::scene::Scene;
use crate::scene::presets::{self, Preset};
use crate::text::{Language, in_language};
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A scene with its model.
#[derive(Clone, Debug, Default)]
pub struct Document {
    /// The scene.
    pub scene: Scene,
    /// The mesh of an object of kind `obj`.
    pub model: Option<Arc<Mesh>>,
    /// The origin of the scene and the model.
    pub origin: Origin,
    /// The role of the document in the course.
    pub part: CoursePart,
}

/// The role of a document in the course.
#[derive(Clone, Debug, Default)]
pub enum CoursePart {
    /// No role in the course.
    #[default]
    None,
    /// The scene of a step of the lesson of this name.
    Step(String),
    /// The last picture of handed-in answers; or why these are not valid.
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

/// The origin of a document.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Origin {
    /// The scene that the program starts with.
    #[default]
    New,
    /// A built-in scene, by its name.
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
    /// Returns the built-in scene of this name, if there is one.
    pub fn built_in(name: &str) -> Option<Self> {
        Some(Self::named(presets::find(name)?.scene(), name.to_owned()))
    }

    /// Creates a document of `scene`, which comes from the built-in scene of this name.
    pub(crate) fn named(scene: Scene, name: String) -> Self {
        Self {
            scene,
            origin: Origin::BuiltIn(name),
            ..Self::default()
        }
    }

    /// Returns whether it is a built-in scene, and no step of a lesson or hand-in.
    pub fn is_built_in(&self) -> bool {
        matches!(
            (&self.part, &self.origin),
            (CoursePart::None, Origin::BuiltIn(_))
        )
    }

    /// Adds the answers that the document's picture holds, if it was handed in.
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

    /// Returns the title of the scene, or the name of its file.
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

    /// Returns the sentence that describes the scene; may be empty.
    pub fn sentence(&self) -> &str {
        self.preset()
            .map_or(&*self.scene.about.sentence, |preset| preset.sentence())
    }

    /// Returns the built-in scene that the document comes from, whose texts follow the language.
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

    /// Returns the scene file that the document was opened from or saved to.
    pub fn scene_file(&self) -> Option<PathBuf> {
        match &self.origin {
            Origin::File(path) if path.extension().is_some_and(|ending| ending == "toml") => {
                Some(path.clone())
            }
            _ => None,
        }
    }

    /// Returns an absolute path with the extension `ending`, suggested for a new file beside the open one.
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

    /// Returns whether the documents show different models.
    pub fn model_differs(&self, other: &Self) -> bool {
        !same_model(self.model.as_ref(), other.model.as_ref())
    }

    /// Returns whether the document came from this file.
    pub fn is_from(&self, file: &Path) -> bool {
        let absolute = |path: &Path| std::path::absolute(path).ok();
        matches!(&self.origin, Origin::File(path) if absolute(path) == absolute(file))
    }
}

impl Origin {
    /// Returns the name in the window's title: that of the file or of the built-in scene.
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

/// Returns whether both are the same model, or both are `None`.
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
