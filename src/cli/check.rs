//! `check`: whether a file can be opened, and what is wrong with it.

use super::failure::Failure;
use super::input::SceneArguments;
use super::output::print;
use clap::Args;
use std::path::PathBuf;

#[derive(Args)]
pub struct Check {
    /// A .toml, .obj or .png file, or a built-in scene's name
    #[arg(value_name = "FILE")]
    file: PathBuf,
    /// Override one key of the scene first
    #[arg(long, value_name = "KEY=VALUE", allow_hyphen_values = true)]
    set: Vec<String>,
}

impl Check {
    pub fn run(self, earlier: &[String]) -> Result<(), Failure> {
        let arguments = SceneArguments { source: Some(self.file), set: self.set, material: None };
        let loaded = arguments.load(earlier)?;
        let scene = &loaded.scene;
        let [width, height] = scene.image.size;
        let polygons = loaded.model.map(|model| format!(", {} polygons", model.starts.len().saturating_sub(1)));
        let lights = scene.lights.len();
        print(&format!(
            "{}: ok ({:?}{}, {lights} {}, {:?} shading, {width}×{height})\n",
            arguments.source.unwrap_or_default().display(),
            scene.object.kind,
            polygons.unwrap_or_default(),
            if lights == 1 { "light" } else { "lights" },
            scene.shading.mode,
        ))
    }
}
