//! The current scene as the target of a match: a lesson with a level for each coefficient to be found.

use crate::app::session::Session;
use crate::app::session::document::{Document, Origin};
use crate::lesson::{Lesson, value_of};
use crate::scene::{Scene, presets};
use crate::text::text;
use std::path::Path;

/// The beginning of the lesson's text.
const HEAD: &str = include_str!("target/head.md");
const LEVEL: &str = include_str!("target/level.md");
/// The parameters to be found, one more at each level, and their initial values.
const SOUGHT: [(&str, f64); 4] = [
    ("material.kd", 0.5),
    ("material.ks", 0.5),
    ("material.n", 12.0),
    ("material.ka", 0.3),
];

/// Creates a lesson that matches the current scene, if the scene can be named.
pub fn as_target(session: &Session) -> Option<Lesson> {
    let built_in = |name| Some((name, presets::find(name)?.scene()));
    let (name, base) = match &session.document().origin {
        Origin::BuiltIn(name) => built_in(name),
        Origin::New => built_in(presets::DEFAULT),
        Origin::File(path) => path
            .to_str()
            .map(|path| (path, session.saved().scene.clone())),
    }?;
    lesson_for(session.document(), name, &base)
}

/// Creates the lesson for a scene that has a name and was opened as `base`.
fn lesson_for(document: &Document, name: &str, base: &Scene) -> Option<Lesson> {
    let scene = &document.scene;
    let settings: Vec<String> = base
        .differences(scene)
        .filter(|(parameter, _)| !["compare", "about"].contains(&parameter.section()))
        .map(|(parameter, index)| {
            let value = parameter.setting(scene, index);
            format!("{}={value}", parameter.key(index))
        })
        .collect();
    let right: Vec<f64> = SOUGHT
        .iter()
        .map(|(key, _)| value_of(scene, key).ok())
        .collect::<Option<_>>()?;
    let title = text!("course-target-title", scene = document.title());
    let mut source = HEAD.replace("TITLE", &format!("{title:?}"));
    for level in 1..=SOUGHT.len() {
        let sought = &SOUGHT[..level];
        let mut set = settings.clone();
        for ((key, first), right) in SOUGHT.iter().zip(&right) {
            let free = sought.iter().any(|(sought, _)| sought == key);
            // Visibly different from the right value.
            let first = if (first - right).abs() > 0.2 * right.abs() {
                *first
            } else {
                right * 0.4
            };
            set.push(format!("{key}={}", if free { first } else { *right }));
        }
        let controls: Vec<&str> = sought.iter().map(|(key, _)| *key).collect();
        let target: Vec<String> = sought
            .iter()
            .zip(&right)
            .map(|((key, _), right)| format!("{key}={right}"))
            .collect();
        let title = text!("course-target-level", level = level);
        let ask = text!("course-target-ask", count = level);
        // The strings' Rust notation is valid TOML here: nothing in them needs an escape that only one
        // language has.
        let quoted = |strings: &dyn std::fmt::Debug| format!("{strings:?}");
        let level = LEVEL
            .replace("TITLE", &title)
            .replace("SCENE", &quoted(&name))
            .replace("LIGHTS", &scene.lights.len().to_string())
            .replace("FIRST", &quoted(&set))
            .replace("ASK", &quoted(&ask))
            .replace("CONTROLS", &quoted(&controls))
            .replace("RIGHT", &quoted(&target));
        source.push_str(&level);
    }
    // The path of a file is already complete.
    Lesson::read(&source, Some(Path::new(""))).ok()
}
