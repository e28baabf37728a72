//! `scenes`: the built-in scenes.

use super::failure::Failure;
use super::output::{print, print_json};
use clap::Args;
use serde_json::json;
use shading_lab::scene::presets;

#[derive(Args)]
pub struct Scenes {
    /// Print one JSON object
    #[arg(long)]
    json: bool,
}

impl Scenes {
    pub fn run(self) -> Result<(), Failure> {
        if self.json {
            let scene = |preset: &presets::Preset| {
                let about = preset.about();
                json!({
                    "name": preset.name, "title": about.title, "topic": about.topic, "description": about.sentence,
                    "view": about.view,
                })
            };
            return print_json(&json!({"scenes": presets::ALL.iter().map(scene).collect::<Vec<_>>()}));
        }
        let width = presets::ALL.iter().map(|preset| preset.name.len()).max().unwrap_or(0);
        let line = |preset: &presets::Preset| format!("{:width$}  {}\n", preset.name, preset.about().sentence);
        print(&presets::ALL.iter().map(line).collect::<String>())
    }
}
