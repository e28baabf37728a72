//! What is open: a scene, the model it shows, and where both came from.

use crate::document::Loaded;
use crate::geometry::Mesh;
use crate::scene::Scene;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A scene with its model.
#[derive(Clone, Debug, Default)]
pub struct Document {
    pub scene: Scene,
    /// The mesh of an object of kind `obj`.
    pub model: Option<Arc<Mesh>>,
    pub origin: Origin,
}

/// Where a document came from.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Origin {
    /// The scene that the program starts with.
    #[default]
    New,
    /// A scene that comes with the program, by its name.
    BuiltIn(String),
    File(PathBuf),
}

impl From<Loaded> for Document {
    fn from(loaded: Loaded) -> Self {
        let Loaded { scene, model, name, path } = loaded;
        Self { scene, model, origin: path.map_or(Origin::BuiltIn(name), Origin::File) }
    }
}

impl Document {
    /// The scene file that it was opened from or saved to.
    pub fn scene_file(&self) -> Option<PathBuf> {
        match &self.origin {
            Origin::File(path) if path.extension().is_some_and(|ending| ending == "toml") => Some(path.clone()),
            _ => None,
        }
    }

    /// A name for a file with `ending` beside what is open.
    pub fn suggested(&self, ending: &str) -> String {
        let path = match &self.origin {
            Origin::File(path) => path.with_extension(ending),
            _ => PathBuf::from(self.name()).with_extension(ending),
        };
        std::path::absolute(&path).unwrap_or(path).display().to_string()
    }

    /// Whether the two show different models.
    pub fn model_differs(&self, other: &Self) -> bool {
        !same_model(self.model.as_ref(), other.model.as_ref())
    }

    /// What the title bar calls it.
    pub fn name(&self) -> String {
        self.origin.name()
    }

    /// Whether it came from this file.
    pub fn is_from(&self, file: &Path) -> bool {
        let absolute = |path: &Path| std::path::absolute(path).ok();
        matches!(&self.origin, Origin::File(path) if absolute(path) == absolute(file))
    }
}

impl Origin {
    pub fn name(&self) -> String {
        match self {
            Self::New => "untitled".to_owned(),
            Self::BuiltIn(name) => name.clone(),
            Self::File(path) => {
                path.file_name().map_or_else(|| path.display().to_string(), |name| name.to_string_lossy().into_owned())
            }
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
        self.scene == other.scene && !self.model_differs(other) && self.origin == other.origin
    }
}
