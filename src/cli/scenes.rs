//! `shading-lab scenes`: the built-in scenes, a line each.

use super::output::{print, print_json};
use super::{Failure, presets};
use clap::Args;
use serde_json::json;

#[derive(Debug, Args)]
pub(super) struct Arguments {
    /// Prints JSON
    #[arg(long)]
    json: bool,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    if arguments.json {
        let scenes: Vec<_> = presets::ALL
            .iter()
            .map(|p| json!({ "name": p.name, "title": p.title, "description": p.description }))
            .collect();
        return print_json(&json!({ "scenes": scenes, "default": presets::DEFAULT }));
    }
    let width = presets::ALL.iter().map(|preset| preset.name.len()).max().unwrap_or(0);
    let lines: String =
        presets::ALL.iter().map(|preset| format!("{:width$}  {}\n", preset.name, preset.description)).collect();
    print(&lines)
}
