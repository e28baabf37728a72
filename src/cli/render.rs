//! `render`: writes a scene as a PNG file, with overlays.

use super::input::{
    PaneArguments, SceneArguments, choice, inside_picture, parse_choice, parse_pixel, parse_place,
    parse_size, parse_vertex, picture_name, whole,
};
use super::output::{Failure, check_picture_target, progress_bar};
use clap::Args;
use glam::DVec2;
use shading_lab::analysis::comparison::{Captions, comparison_sheet, draw_panes, panes_on_sheet};
use shading_lab::analysis::defects::{defects, draw_defects};
use shading_lab::analysis::normals::{NormalField, draw_normals};
use shading_lab::analysis::overlay::{OverlayLayer, OverlayOptions};
use shading_lab::analysis::probe::{clearest_pixel, draw_overlay, probe};
use shading_lab::analysis::profile::{ProfileQuestion, draw_profile, profile};
use shading_lab::analysis::unwatched;
use shading_lab::document::{check_target, save_picture};
use shading_lab::render::{Frame, Renderer, check_memory_for};
use shading_lab::scene::{Choice, CompareView, Scene};
use shading_lab::text::text;
use std::path::PathBuf;
use tiny_skia::PixmapMut;

/// Maximum number of samples per pixel: beyond, 8 bits show no difference.
pub const MAX_SAMPLES: u32 = 4096;

#[derive(Args)]
pub struct Render {
    #[command(flatten)]
    scene: SceneArguments,
    #[arg(short, long, value_name = "FILE.png", value_parser = picture_name())]
    output: PathBuf,
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    size: Option<[u32; 2]>,
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = whole::<u32>(1..=MAX_SAMPLES))]
    samples: u32,
    #[arg(long, value_parser = choice(CompareView::VALUES))]
    compare: Option<CompareView>,
    #[command(flatten)]
    panes: PaneArguments,
    #[arg(long)]
    no_captions: bool,
    #[arg(long, value_name = "LIST", value_parser = Overlays::parse, allow_hyphen_values = true)]
    overlay: Option<Overlays>,
    #[arg(long, value_name = "X,Y", value_parser = parse_place, requires_all = ["to", "overlay"], allow_hyphen_values = true)]
    from: Option<DVec2>,
    #[arg(long, value_name = "X,Y", value_parser = parse_place, requires = "from", allow_hyphen_values = true)]
    to: Option<DVec2>,
    #[arg(long, value_name = "I", value_parser = parse_vertex, requires = "overlay", allow_hyphen_values = true)]
    vertex: Option<u32>,
}

impl Render {
    pub fn run(self, earlier: &[String]) -> Result<(), Failure> {
        let mut loaded = self.scene.load(earlier)?;
        check_target(&self.output)?;
        check_picture_target(&self.output)?;
        let scene = &mut loaded.scene;
        scene.image.size = self.size.unwrap_or(scene.image.size);
        self.panes.apply(scene, self.compare)?;
        let which = panes_on_sheet(scene);
        if let Some(overlays) = &self.overlay {
            self.check(
                overlays,
                which.first().map_or(scene.image.size, |(_, size)| *size),
            )?;
        }
        check_memory_for(scene, loaded.model.as_deref(), 1).map_err(Failure::work)?;
        let (mut renderer, scene) = (loaded.renderer(), &loaded.scene);
        let bar = progress_bar(
            u64::from(self.samples) * which.len() as u64,
            text!("cli-drawing"),
        );
        let mut progress = |done: u32| {
            bar.set_position(done.into());
            true
        };
        let over = |frame: &mut Frame, renderer: &mut Renderer, scene: &Scene| match &self.overlay {
            Some(overlays) => self.draw(overlays, frame, renderer, scene),
            None => Ok(()),
        };
        let frame = if scene.compare.view == CompareView::Single {
            let mut frame = renderer.render_supersampled(scene, self.samples, &mut progress);
            over(&mut frame, &mut renderer, scene)?;
            frame
        } else {
            let panes = draw_panes(
                &mut renderer,
                scene,
                &which,
                self.samples,
                &mut progress,
                over,
            )?;
            let captions = if self.no_captions {
                Captions::None
            } else {
                Captions::Figures
            };
            comparison_sheet(scene, &panes, captions)
        };
        Ok(save_picture(&self.output, &frame, scene)?)
    }

    /// Refuses a line or a vertex that no overlay shows, and a pixel or a line outside a picture of `sides` pixels.
    fn check(&self, overlays: &Overlays, sides: [u32; 2]) -> Result<(), Failure> {
        if self.from.is_some() && !overlays.layers.contains(&OverlayLayer::Profile) {
            return Err(Failure::input(text!("cli-line-without-profile")));
        }
        if self.vertex.is_some() && !overlays.layers.iter().any(|layer| layer.of_needles()) {
            return Err(Failure::input(text!("cli-vertex-without-normals")));
        }
        let size = DVec2::from_array(sides.map(f64::from));
        let outside = |p: &DVec2| p.min_element() < 0.0 || p.cmpgt(size).any();
        if let Some(DVec2 { x, y }) = [self.from, self.to].into_iter().flatten().find(outside) {
            let DVec2 {
                x: right,
                y: bottom,
            } = size;
            return Err(Failure::input(text!(
                "cli-outside-picture",
                what = format!("{x},{y}"),
                last = format!("{right},{bottom}")
            )));
        }
        overlays
            .pixel
            .map_or(Ok(()), |pixel| inside_picture("--overlay", pixel, sides))
    }

    /// Draws the overlays on `frame`, which is a picture of `scene`.
    fn draw(
        &self,
        overlays: &Overlays,
        frame: &mut Frame,
        renderer: &mut Renderer,
        scene: &Scene,
    ) -> Result<(), Failure> {
        let layers = &overlays.layers;
        let any = |of: fn(OverlayLayer) -> bool| layers.iter().any(|layer| of(*layer));
        let probed = match overlays.pixel {
            Some([x, y]) => probe(renderer, scene, x, y),
            None => clearest_pixel(renderer, scene),
        };
        if any(OverlayLayer::of_point) && probed.hit.is_none() {
            let [x, y] = probed.pixel;
            return Err(Failure::input(text!(
                "cli-background",
                what = format!("--overlay {x},{y}")
            )));
        }
        let options = OverlayOptions {
            layers: layers.clone(),
            ..OverlayOptions::default()
        };
        let size = scene.image.size;
        let mut pixmap =
            PixmapMut::from_bytes(frame.pixels.as_flattened_mut(), frame.width, frame.height)
                .ok_or_else(|| Failure::work(text!("cli-too-large-for-overlays")))?;
        if any(OverlayLayer::of_needles) {
            let vertex = |field: &NormalField| {
                self.vertex
                    .map(|number| field.vertex_of(number))
                    .transpose()
            };
            draw_normals(&mut pixmap, scene, renderer, &options, vertex).map_err(Failure::input)?;
        }
        if layers.contains(&OverlayLayer::Profile) {
            let [width, height] = size.map(f64::from);
            let y = overlays
                .pixel
                .map_or(0.5 * height, |[_, y]| f64::from(y) + 0.5);
            let (from, to) = self
                .from
                .zip(self.to)
                .unwrap_or((DVec2::new(0.0, y), DVec2::new(width, y)));
            let question = ProfileQuestion {
                modes: vec![scene.shading.mode],
                ..ProfileQuestion::new(from, to)
            };
            let taken = profile(renderer, scene, &question)
                .map_err(|error| Failure::input(format!("--overlay profile: {error}")))?;
            taken
                .traces
                .iter()
                .for_each(|trace| draw_profile(&mut pixmap, &taken, trace, &options));
        }
        if layers.contains(&OverlayLayer::Defects) {
            draw_defects(
                &mut pixmap,
                &defects(renderer, scene, probed.pixel, &unwatched),
                None,
                &options,
            );
        }
        if any(OverlayLayer::of_overlay) {
            draw_overlay(&mut pixmap, scene, &probed, &options);
        }
        Ok(())
    }
}

/// The layers of `--overlay vectors,angles,probe=X,Y` and the pixel that they explain.
#[derive(Clone, Debug, PartialEq)]
struct Overlays {
    layers: Vec<OverlayLayer>,
    pixel: Option<[u32; 2]>,
}

impl Overlays {
    /// Parses names between commas; `probe=X,Y` or any of the names followed by `=X,Y` sets the pixel.
    fn parse(text: &str) -> Result<Self, String> {
        let mut list = Self {
            layers: Vec::new(),
            pixel: None,
        };
        let mut pieces = text.split(',');
        while let Some(piece) = pieces.next() {
            let (name, x) = piece
                .split_once('=')
                .map_or((piece, None), |(name, x)| (name, Some(x)));
            match name.trim() {
                "probe" if x.is_none() => {
                    return Err(text!("cli-probe-without-pixel").to_owned());
                }
                "probe" => {}
                name => list.layers.push(parse_choice(name, &OverlayLayer::ALL)?),
            }
            if let Some(x) = x {
                let pixel = parse_pixel(&format!("{x},{}", pieces.next().unwrap_or_default()))?;
                if list.pixel.is_some_and(|other| other != pixel) {
                    return Err(text!("cli-two-pixels").to_owned());
                }
                list.pixel = Some(pixel);
            }
        }
        if list.layers.is_empty() {
            return Err(text!("cli-pixel-alone").to_owned());
        }
        Ok(list)
    }
}
