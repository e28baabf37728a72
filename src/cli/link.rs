//! `link`: a scene as a link, and as a QR code.

use super::input::{SceneArguments, output_ending_in};
use super::output::{Failure, check_picture_target, note, print, print_json};
use clap::Args;
use serde_json::json;
use shading_lab::document::{Loaded, check_target, save_drawing};
use shading_lab::figure::QrCode;
use shading_lab::link::{self, PAGE, Written};
use shading_lab::text::text;
use std::path::PathBuf;

/// Pixels per module in a picture.
const MODULE: f64 = 10.0;

#[derive(Args)]
pub struct Link {
    #[command(flatten)]
    scene: SceneArguments,
    #[arg(long, value_name = "BASE", value_parser = link::page)]
    url: Option<String>,
    #[arg(short, long, value_name = "FILE", value_parser = output_ending_in(&["png", "svg"], "cli-expected-qr"))]
    output: Option<PathBuf>,
    #[arg(long)]
    json: bool,
}

impl Link {
    /// Prints the link or writes its QR code; `earlier` and `page` are the arguments before the command.
    pub fn run(self, earlier: &[String], page: Option<String>) -> Result<(), Failure> {
        if let Some(target) = &self.output {
            check_target(target)?;
            check_picture_target(target)?;
        }
        let Loaded {
            scene,
            name,
            path,
            shown,
            ..
        } = self.scene.load(earlier)?;
        let page = self.url.or(page).unwrap_or_else(|| PAGE.to_owned());
        let origin = path.is_none().then_some(&*name);
        let Written { link, left_out } =
            link::write(&page, &scene, origin, &shown).map_err(Failure::input)?;
        if let Some(target) = &self.output {
            let length = link.len();
            let code = QrCode::new(&link)
                .ok_or_else(|| Failure::input(text!("cli-too-long-for-qr", length = length)))?;
            save_drawing(target, &code.drawing(MODULE), &link)?;
        }
        let model = left_out.map(|path| path.display().to_string());
        if self.json {
            let object = json!({ "link": link, "length": link.len(), "left_out": model });
            print_json(&format!("{object:#}\n"))?;
        } else if self.output.is_none() {
            print(&(link + "\n"))?;
        }
        if let Some(model) = model {
            let message = text!("link-model-stays", path = model);
            note(&message);
        }
        Ok(())
    }
}
