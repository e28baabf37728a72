//! The lessons of the course, in their order: the files of `assets/lessons`.

use super::Lesson;
use crate::text::{Language, language};

/// A lesson that comes with the program.
#[derive(Clone, Copy, Debug)]
pub struct BuiltIn {
    /// Lower-case words with hyphens.
    pub name: &'static str,
    /// Its file in each language.
    texts: [&'static str; 2],
}

impl BuiltIn {
    /// The lesson in the present language.
    pub fn lesson(&self) -> Lesson {
        self.lesson_in(language())
    }

    /// The text of its file in a language.
    pub fn source(&self, language: Language) -> &'static str {
        self.texts[language as usize]
    }

    /// The lesson in a language.
    pub fn lesson_in(&self, language: Language) -> Lesson {
        Lesson::read(self.source(language), None)
            .unwrap_or_else(|error| unreachable!("the tests read every lesson: {error}"))
    }
}

macro_rules! lessons {
    ($($name:literal)*) => {
        [$(BuiltIn {
            name: $name,
            texts: [
                include_str!(concat!("../../assets/lessons/en/", $name, ".md")),
                include_str!(concat!("../../assets/lessons/zh-Hant/", $name, ".md")),
            ],
        }),*]
    };
}

/// Every lesson, in the order of the course.
pub static LESSONS: [BuiltIn; 33] = lessons! {
    "what-is-shading"
    "light-sources"
    "ambient"
    "diffuse"
    "attenuation"
    "colour"
    "reflection-vector"
    "exponent"
    "reflectance"
    "half-vector"
    "whole-equation"
    "out-of-range"
    "transparency"
    "shadows"
    "ambient-constant"
    "physics-based"
    "tessellation"
    "flat-shading"
    "interpolated-shading"
    "vertex-normals"
    "gouraud"
    "scan-line"
    "mach-bands"
    "lost-highlight"
    "phong-shading"
    "silhouette"
    "perspective-distortion"
    "orientation"
    "shared-vertices"
    "unrepresentative-normals"
    "depth-cueing"
    "cost-and-error"
    "opengl"
};

/// The lesson of that name.
pub fn find(name: &str) -> Option<&'static BuiltIn> {
    LESSONS.iter().find(|lesson| lesson.name == name)
}
