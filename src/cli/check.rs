//! `shading-lab check`: whether a file is sound.

use super::output::{print, print_json};
use super::{Failure, load};
use clap::Args;
use serde_json::json;
use std::path::PathBuf;

#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// A scene file (.toml), a model (.obj) or a picture exported by this program (.png)
    file: PathBuf,
    /// Prints JSON
    #[arg(long)]
    json: bool,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let loaded = load(&arguments.file, &[])?;
    let (scene, model) = (&loaded.scene, loaded.model.as_deref());
    let file = arguments.file.display().to_string();
    if arguments.json {
        let model = model.map(|mesh| json!({ "faces": mesh.face_count(), "vertices": mesh.positions.len() }));
        return print_json(&json!({ "file": file, "valid": true, "lights": scene.lights.len(), "model": model }));
    }
    let model = model.map_or_else(String::new, |mesh| {
        format!(", a model of {} faces and {} vertices", mesh.face_count(), mesh.positions.len())
    });
    let plural = if scene.lights.len() == 1 { "light" } else { "lights" };
    print(&format!("{file}: sound: {} {plural}{model}\n", scene.lights.len()))
}
