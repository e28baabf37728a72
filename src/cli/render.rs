//! `render`: a scene into a PNG file.

use super::failure::Failure;
use super::input::{SceneArguments, parse_size};
use super::output::progress_bar;
use super::overlay::OverlayList;
use super::profile::parse_place;
use clap::Args;
use glam::DVec2;
use shading_lab::document::{check_target, save_picture};
use shading_lab::render::Renderer;
use std::path::{Path, PathBuf};

/// Most samples a pixel: beyond, 8 bits show no difference.
const MAX_SAMPLES: u32 = 4096;

#[derive(Args)]
pub struct Render {
    #[command(flatten)]
    scene: SceneArguments,
    /// The picture to write; the scene goes with it and comes back when it is opened
    #[arg(short, long, value_name = "FILE.png", value_parser = parse_target)]
    output: PathBuf,
    /// Width and height in pixels, instead of the scene's
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    size: Option<[u32; 2]>,
    /// Samples per pixel
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=i64::from(MAX_SAMPLES)))]
    samples: u32,
    /// Drawings over the picture: vectors, angles, construction, lights, lobe, side-view, profile; with probe=X,Y the pixel that they
    /// explain, otherwise a lit one near the middle whose vectors are well apart
    #[arg(long, value_name = "LIST", value_parser = OverlayList::parse, allow_hyphen_values = true)]
    overlay: Option<OverlayList>,
    /// Where the line of --overlay profile begins, in pixels; without a line it is level, through the probe or the middle
    #[arg(long, value_name = "X,Y", value_parser = parse_place, requires_all = ["to", "overlay"], allow_hyphen_values = true)]
    from: Option<DVec2>,
    /// Where it ends
    #[arg(long, value_name = "X,Y", value_parser = parse_place, requires = "from", allow_hyphen_values = true)]
    to: Option<DVec2>,
}

impl Render {
    pub fn run(mut self, earlier: &[String]) -> Result<(), Failure> {
        let mut loaded = self.scene.load(earlier)?;
        check_target(&self.output)?;
        let scene = &mut loaded.scene;
        scene.image.size = self.size.unwrap_or(scene.image.size);
        if let Some(overlay) = &mut self.overlay {
            overlay.set_line(self.from, self.to)?;
            overlay.check(scene)?;
        }
        let mut renderer = Renderer::default();
        renderer.set_model(loaded.model);
        let bar = progress_bar(self.samples.into(), "drawing");
        let mut frame = renderer.render_supersampled(scene, self.samples, &mut |done| bar.set_position(done.into()));
        bar.finish_and_clear();
        if let Some(overlay) = &self.overlay {
            overlay.draw(&mut frame, &mut renderer, scene)?;
        }
        Ok(save_picture(&self.output, &frame, scene)?)
    }
}

/// A path whose ending says PNG, or a device.
fn parse_target(text: &str) -> Result<PathBuf, String> {
    let path = Path::new(text);
    let png = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("png"));
    let device = path.metadata().is_ok_and(|metadata| !metadata.is_file() && !metadata.is_dir());
    if png || device { Ok(path.to_owned()) } else { Err("expected a name that ends in .png".to_owned()) }
}
