//! `render`: a scene into a PNG file.

use super::analyse::picture_name;
use super::compare::{PaneArguments, View};
use super::failure::Failure;
use super::input::{SceneArguments, parse_size};
use super::output::progress_bar;
use super::overlay::{OverlayList, parse_vertex};
use super::profile::parse_place;
use clap::Args;
use glam::DVec2;
use shading_lab::analysis::{comparison_sheet, draw_panes, panes_on_sheet};
use shading_lab::document::{check_target, save_picture};
use shading_lab::render::{Frame, Renderer, check_memory};
use shading_lab::scene::{CompareView, Scene};
use std::path::PathBuf;

/// Most samples a pixel: beyond, 8 bits show no difference.
const MAX_SAMPLES: u32 = 4096;

#[derive(Args)]
pub struct Render {
    #[command(flatten)]
    scene: SceneArguments,
    /// The picture to write; the scene goes with it and comes back when it is opened
    #[arg(short, long, value_name = "FILE.png", value_parser = picture_name())]
    output: PathBuf,
    /// Width and height in pixels, instead of the scene's
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    size: Option<[u32; 2]>,
    /// Samples per pixel
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=i64::from(MAX_SAMPLES)))]
    samples: u32,
    /// How the scene's panes are shown; with --pane, side by side unless this says otherwise
    #[arg(long, value_enum)]
    compare: Option<View>,
    #[command(flatten)]
    panes: PaneArguments,
    /// Leaves out the names and figures of panes, and the scale of a difference
    #[arg(long)]
    no_captions: bool,
    /// Drawings over the picture: vectors, angles, construction, lights, lobe, side-view, profile, defects,
    /// face-normals, vertex-normals; with probe=X,Y the pixel that they
    /// explain, otherwise a lit one near the middle whose vectors are well apart
    #[arg(long, value_name = "LIST", value_parser = OverlayList::parse, allow_hyphen_values = true)]
    overlay: Option<OverlayList>,
    /// Where the line of --overlay profile begins, in pixels; without a line it is level, through the probe or the middle
    #[arg(long, value_name = "X,Y", value_parser = parse_place, requires_all = ["to", "overlay"], allow_hyphen_values = true)]
    from: Option<DVec2>,
    /// Where it ends
    #[arg(long, value_name = "X,Y", value_parser = parse_place, requires = "from", allow_hyphen_values = true)]
    to: Option<DVec2>,
    /// The vertex whose faces --overlay vertex-normals lights up, each with its weight
    #[arg(long, value_name = "I", value_parser = parse_vertex, requires = "overlay", allow_hyphen_values = true)]
    vertex: Option<u32>,
}

impl Render {
    pub fn run(mut self, earlier: &[String]) -> Result<(), Failure> {
        let mut loaded = self.scene.load(earlier)?;
        check_target(&self.output)?;
        let scene = &mut loaded.scene;
        scene.image.size = self.size.unwrap_or(scene.image.size);
        self.panes.apply(scene, self.compare)?;
        let which = panes_on_sheet(scene);
        if let Some(overlay) = &mut self.overlay {
            overlay.set_line(self.from, self.to)?;
            overlay.set_vertex(self.vertex)?;
            overlay.check(which.first().map_or(scene.image.size, |(_, size)| *size))?;
        }
        check_memory(scene).map_err(Failure::work)?;
        let mut renderer = Renderer::default();
        renderer.set_model(loaded.model);
        let bar = progress_bar(u64::from(self.samples) * which.len() as u64, "drawing");
        let mut progress = |done: u32| {
            bar.set_position(done.into());
            true
        };
        let over = |frame: &mut Frame, renderer: &mut Renderer, scene: &Scene| match &self.overlay {
            Some(overlay) => overlay.draw(frame, renderer, scene),
            None => Ok(()),
        };
        let frame = if scene.compare.view == CompareView::Single {
            let mut frame = renderer.render_supersampled(scene, self.samples, &mut progress);
            over(&mut frame, &mut renderer, scene)?;
            frame
        } else {
            let panes = draw_panes(&mut renderer, scene, &which, self.samples, &mut progress, over)?;
            comparison_sheet(scene, &panes, !self.no_captions)
        };
        bar.finish_and_clear();
        Ok(save_picture(&self.output, &frame, scene)?)
    }
}
