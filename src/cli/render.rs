//! `shading-lab render`: a scene into a picture.

use super::{Failure, SceneArguments, progress_bar};
use crate::analysis::{probe, probe_for_overlay};
use crate::document::{check_target, save_picture};
use crate::figure::{OverlayLayer, OverlayOptions, draw_overlay};
use crate::render::{Frame, Renderer};
use crate::scene::Scene;
use clap::Args;
use std::path::PathBuf;
use std::str::FromStr;

/// The most samples a pixel.
const MAX_SAMPLES: i64 = 4096;

#[derive(Debug, Args)]
pub(super) struct Arguments {
    #[command(flatten)]
    scene: SceneArguments,
    /// The picture to write
    #[arg(short, long, value_name = "FILE.png")]
    output: PathBuf,
    /// Samples per pixel
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=MAX_SAMPLES))]
    samples: u32,
    /// What is drawn over the picture: vectors, angles, construction, lights, side-view
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    overlay: Vec<Layer>,
    /// The pixel at which the vectors are drawn; without it the brightest one of the object
    #[arg(long, value_name = "X,Y", value_parser = super::probe::parse_pixel)]
    probe: Option<[u32; 2]>,
}

#[derive(Clone, Copy, Debug)]
struct Layer(OverlayLayer);

impl FromStr for Layer {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let layer = match text.trim() {
            "vectors" => OverlayLayer::Vectors,
            "angles" => OverlayLayer::Angles,
            "construction" => OverlayLayer::Construction,
            "lights" => OverlayLayer::Lights,
            "side-view" => OverlayLayer::SideView,
            _ => return Err("expected vectors, angles, construction, lights or side-view, between commas".into()),
        };
        Ok(Self(layer))
    }
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let png = arguments.output.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("png"));
    if !png {
        let what =
            format!("{}: an unknown kind of picture, expected a name that ends in .png", arguments.output.display());
        return Err(Failure::input(&what));
    }
    check_target(&arguments.output)?;
    let loaded = arguments.scene.load()?;
    let mut renderer = Renderer::default();
    renderer.set_model(loaded.model);
    let bar = progress_bar("drawing");
    bar.set_length(u64::from(arguments.samples));
    let mut frame =
        renderer.render_supersampled(&loaded.scene, arguments.samples, &mut |done| bar.set_position(u64::from(done)));
    bar.finish_and_clear();
    if !arguments.overlay.is_empty() {
        draw_layers(arguments, &loaded.scene, &mut renderer, &mut frame)?;
    }
    Ok(save_picture(&arguments.output, &frame, &loaded.scene)?)
}

fn draw_layers(
    arguments: &Arguments,
    scene: &Scene,
    renderer: &mut Renderer,
    frame: &mut Frame,
) -> Result<(), Failure> {
    let probe = match arguments.probe {
        Some([x, y]) if x >= frame.width || y >= frame.height => {
            let (width, height) = (frame.width, frame.height);
            return Err(Failure::input(&format!(
                "--probe {x},{y}: outside the picture, expected less than {width},{height}"
            )));
        }
        Some([x, y]) => probe(renderer, scene, x, y),
        None => probe_for_overlay(renderer, scene),
    };
    let options =
        OverlayOptions { layers: arguments.overlay.iter().map(|layer| layer.0).collect(), ..OverlayOptions::default() };
    let (width, height) = (frame.width, frame.height);
    if let Some(mut pixmap) = tiny_skia::PixmapMut::from_bytes(frame.pixels.as_flattened_mut(), width, height) {
        draw_overlay(&mut pixmap, scene, &probe, &options);
    }
    Ok(())
}
