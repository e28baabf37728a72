//! The lessons of the course, in their order: the files of `assets/lessons`.

use super::Lesson;
use crate::text::{Language, language, text};

/// The chapters of the course, in their order.
pub const TOPICS: [&str; 5] = ["light", "reflection", "shading", "engine", "test"];

/// Returns the title of a chapter; a chapter of a lecturer's own is returned unchanged.
pub fn topic_name(topic: &str) -> &str {
    match topic {
        "light" => text!("class-topic-light"),
        "reflection" => text!("class-topic-reflection"),
        "shading" => text!("class-topic-shading"),
        "engine" => text!("class-topic-engine"),
        "test" => text!("class-topic-test"),
        other => other,
    }
}

/// A lesson that comes with the program.
#[derive(Clone, Copy, Debug)]
pub struct BuiltIn {
    /// The name: lower-case words with hyphens.
    pub name: &'static str,
    /// Its file in each language; a web page fetches them.
    #[cfg(not(target_arch = "wasm32"))]
    texts: [&'static str; 2],
}

impl BuiltIn {
    /// Returns the lesson in the current language.
    pub fn lesson(&self) -> Lesson {
        self.lesson_in(language())
    }

    /// Returns the text of its file in a language; on a web page empty until it [is there](are_there).
    #[cfg(not(target_arch = "wasm32"))]
    pub fn source(&self, language: Language) -> &'static str {
        self.texts[language as usize]
    }

    /// Returns the text of its file in a language, empty until it [is there](are_there).
    #[cfg(target_arch = "wasm32")]
    pub fn source(&self, language: Language) -> &'static str {
        let file = format!("{}/{}.md", language.tag(), self.name);
        let texts = TEXTS.get().and_then(|texts| texts.get(&file));
        texts.map_or("", String::as_str)
    }

    /// Returns the lesson in a language.
    pub fn lesson_in(&self, language: Language) -> Lesson {
        Lesson::read(self.source(language), None)
            .unwrap_or_else(|error| unreachable!("the tests read every lesson: {error}"))
    }
}

macro_rules! lessons {
    ($($name:literal)*) => {
        [$(BuiltIn {
            name: $name,
            #[cfg(not(target_arch = "wasm32"))]
            texts: [
                include_str!(concat!("../../assets/lessons/en/", $name, ".md")),
                include_str!(concat!("../../assets/lessons/zh-Hant/", $name, ".md")),
            ],
        }),*]
    };
}

/// Every lesson, in the order of the course, then the tests before and after it.
pub static LESSONS: [BuiltIn; 36] = lessons! {
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
    "write-the-equation"
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
    "inventory-a"
    "inventory-b"
};

/// Finds the lesson of that name.
pub fn find(name: &str) -> Option<&'static BuiltIn> {
    LESSONS.iter().find(|lesson| lesson.name == name)
}

/// Returns whether the lessons' texts are there: true except on a web page that has not fetched them yet.
pub fn are_there() -> bool {
    #[cfg(target_arch = "wasm32")]
    return TEXTS.get().is_some();
    #[cfg(not(target_arch = "wasm32"))]
    true
}

#[cfg(target_arch = "wasm32")]
static TEXTS: std::sync::OnceLock<std::collections::HashMap<String, String>> =
    std::sync::OnceLock::new();

/// Takes the texts that a page has fetched, once: each file after a record separator (U+001E) and its name.
#[cfg(target_arch = "wasm32")]
pub fn take_texts(files: &str) {
    let named = files
        .split('\u{1e}')
        .filter_map(|file| file.split_once('\n'));
    let named = named.map(|(name, text)| (name.to_owned(), text.to_owned()));
    let _ = TEXTS.set(named.collect());
}
