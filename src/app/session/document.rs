//! A document: a scene, the model it shows, and where both came from.

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
