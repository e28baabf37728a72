//! Which text of the scene is looked at.

use super::super::paths::complete_path;
use std::path::Path;

/// Which text is looked at, and what is done with it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CodeForm {
    pub language: Language,
    /// Of a text in several parts, the one that is shown.
    pub part: usize,
    /// Where it is to be saved, while that is asked.
    pub path: Option<String>,
    /// What was last done, or why it was not.
    pub message: Option<String>,
}

impl CodeForm {
    /// Goes back from the question where to save; returns whether it was asked.
    pub fn step_back(&mut self) -> bool {
        self.path.take().is_some()
    }

    /// Gives a file without an ending the usual one.
    pub fn complete(&mut self) {
        if let Some(path) = self.path.as_mut().filter(|path| Path::new(path.trim()).extension().is_none()) {
            let usual = Path::new(self.language.suggestion()).extension().unwrap_or_default();
            complete_path(path, &usual.to_string_lossy(), &[]);
        }
    }
}

/// In whose words.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Language {
    #[default]
    Calls,
    Shaders,
    Program,
}

impl Language {
    pub const ALL: [Self; 3] = [Self::Calls, Self::Shaders, Self::Program];

    /// What its tab is called.
    pub fn title(self) -> &'static str {
        match self {
            Self::Calls => "OpenGL calls",
            Self::Shaders => "GLSL 330",
            Self::Program => "Whole program in C",
        }
    }

    /// What it is, in a sentence.
    pub fn what(self) -> &'static str {
        match self {
            Self::Calls => "Camera, lights and material as calls of fixed-function OpenGL, in C",
            Self::Shaders => "A vertex and a fragment shader that evaluate the equation where the shading mode does",
            Self::Program => "The calls and the polygons in a program that draws them off screen",
        }
    }

    /// A name for its file.
    pub fn suggestion(self) -> &'static str {
        match self {
            Self::Calls | Self::Program => "scene.c",
            Self::Shaders => "scene.vert",
        }
    }
}
