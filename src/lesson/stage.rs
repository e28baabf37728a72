//! The scene of a step, and what is shown of it.

use super::LessonError;
use crate::document::{ending, load_named, load_scene, stays_here};
use crate::geometry::Mesh;
use crate::link::{Shown, VIEWS};
use crate::scene::{Compare, CompareView, Pane, Scene};
use crate::text::text;
use glam::DVec2;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The names of the overlays of the picture.
pub const OVERLAYS: [&str; 8] = [
    "vectors",
    "side-view",
    "lobe",
    "profile",
    "normals",
    "vertices",
    "vertex",
    "edges",
];

/// The scene of a step and its view. What it leaves open it takes over from the step before.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stage {
    /// A built-in scene or a file.
    pub scene: String,
    /// Settings as `--set` takes them, those of the steps before that go on first.
    pub set: Vec<String>,
    /// The number of lights.
    pub lights: Option<usize>,
    /// The panes of a comparison, each its settings with semicolons between.
    pub panes: Option<Vec<String>>,
    /// The view that opens, one of [`VIEWS`].
    pub view: Option<&'static str>,
    /// The probe: its offset from the middle of the picture to the right and down, in units of the shorter side.
    pub probe: Option<DVec2>,
    /// The ends of the profile's line, in the same units as `probe`.
    pub line: Option<[DVec2; 2]>,
    /// The overlays of the picture, some of [`OVERLAYS`].
    pub overlays: Vec<&'static str>,
    /// Controls by the last word of their keys, or by the whole key; `light` is where the light is.
    pub controls: Vec<String>,
    /// True if numbers are hidden until the question is answered.
    pub hide: bool,
    /// Its line in the file.
    pub line_number: u64,
}

/// The scene of a step, ready to be drawn.
#[derive(Clone, Debug)]
pub struct Staged {
    /// The scene, with the step's settings.
    pub scene: Scene,
    /// The mesh of an object of kind `obj`.
    pub model: Option<Arc<Mesh>>,
    /// The built-in scene or the file that it was made from.
    pub name: String,
    /// The file, if it is one.
    pub path: Option<PathBuf>,
    /// The settings that make that scene or file into the scene, as `--set` takes them.
    pub settings: Vec<String>,
    /// The view of it.
    pub shown: Shown,
}

impl Stage {
    /// The maximum length of a step's settings, with those that it takes over, in bytes.
    pub const MAX_SETTINGS: usize = 1 << 15;

    /// The farthest that a place may be from the middle of the picture, in units of its shorter side.
    pub const FARTHEST: f64 = 8.0;

    /// Loads the scene; files are looked for in `folder`.
    ///
    /// # Errors
    /// A scene that cannot be loaded, or settings that it does not have.
    pub fn load(&self, folder: Option<&Path>) -> Result<Staged, LessonError> {
        let wrong = |words: String| LessonError::one(self.line_number, words);
        let loaded = match folder {
            None if self.is_file() => return Err(wrong(text!("lesson-no-folder").to_owned())),
            Some(_) if !stays_here(&self.scene) => {
                return Err(wrong(text!("document-elsewhere").to_owned()));
            }
            Some(folder) if self.is_file() => load_scene(&folder.join(&self.scene)),
            _ => load_named(&self.scene),
        };
        let loaded = loaded.map_err(|error| wrong(error.to_string()))?;
        let mut scene = loaded.scene.clone();
        if let Some(count) = self.lights {
            scene.lights.resize(count, Default::default());
        }
        if let Some(panes) = &self.panes {
            scene.compare.panes = panes.iter().map(|pane| pane_of(pane)).collect();
            if scene.compare.view == CompareView::Single && !panes.is_empty() {
                scene.compare.view = CompareView::Panes;
            }
        }
        let scene = scene.with_overrides(&self.set);
        let scene = scene.map_err(|error| wrong(error.to_string()))?;
        if folder.is_none() && scene.object.path.is_some() {
            return Err(wrong(text!("lesson-no-folder").to_owned()));
        }
        Ok(Staged {
            settings: scene.settings_from(&loaded.scene),
            scene,
            model: loaded.model,
            name: loaded.name,
            path: loaded.path,
            shown: Shown {
                view: self.view,
                probe: self.probe,
                line: self.line,
                ..Shown::default()
            },
        })
    }

    /// Returns whether its scene is a file.
    pub fn is_file(&self) -> bool {
        let endings = ["toml", "obj", "png"];
        ending(Path::new(&self.scene)).is_some_and(|ending| endings.contains(&&*ending))
    }

    /// Returns whether loading it opens a file.
    pub(super) fn names_file(&self) -> bool {
        self.is_file() || self.set.iter().any(|setting| setting.contains("path"))
    }

    /// Checks what can be checked without loading anything.
    pub(super) fn check(&self) -> Result<(), String> {
        let far = |place: &DVec2| !place.to_array().iter().all(|x| x.abs() <= Self::FARTHEST);
        let places = self.probe.iter().chain(self.line.iter().flatten());
        if places.into_iter().any(far) {
            return Err(text!("lesson-far").to_owned());
        }
        if self.set.iter().map(String::len).sum::<usize>() > Self::MAX_SETTINGS {
            return Err(text!("lesson-long-settings", most = Self::MAX_SETTINGS));
        }
        if self.lights.is_some_and(|count| count > Scene::MAX_LIGHTS) {
            return Err(text!("lesson-lights", most = Scene::MAX_LIGHTS));
        }
        if self
            .panes
            .as_ref()
            .is_some_and(|panes| panes.len() > Compare::MAX_PANES)
        {
            return Err(text!("lesson-panes", most = Compare::MAX_PANES));
        }
        Ok(())
    }
}

fn pane_of(settings: &str) -> Pane {
    let mut pane = Pane::default();
    for setting in settings.split(';').map(str::trim) {
        match setting.strip_prefix("compare.name=") {
            Some(name) => name.clone_into(&mut pane.name),
            None if setting.is_empty() => {}
            None => pane.set.push(setting.to_owned()),
        }
    }
    pane
}

/// Finds the view of that name.
pub(super) fn view(name: &str) -> Option<&'static str> {
    VIEWS.into_iter().find(|view| *view == name)
}
