//! The vectors of the illumination equation at a probed point, over a picture: arrows, arcs, handles and labels with
//! their positions in pixels, which can be read, tested or drawn.

mod equation;
mod lights;
mod lobe;
mod side;
mod vectors;

pub use equation::{Angle, Arc, Arrow, ArrowHead};
pub use lights::LightHandle;
pub use vectors::{VectorsShown, draw_vectors};

use super::Probe;
use crate::analysis::overlay::{OverlayLayer, OverlayOptions, Sketch, Style};
use crate::figure::{Area, Drawing, Label};
use crate::scene::{Scene, View};
use equation::Equation;
use glam::DVec2;
use tiny_skia::PixmapMut;

/// Length of a unit vector across the line of sight, in the picture's shorter side.
const UNIT_LENGTH: f64 = 0.19;

/// An overlay laid out for a picture of a given size. Labels lie inside it and do not overlap; one that does not fit is
/// left out. All coordinates are finite.
#[derive(Clone, Debug, PartialEq)]
pub struct Overlay {
    /// The vectors at the point.
    pub arrows: Vec<Arrow>,
    /// The angles between them.
    pub arcs: Vec<Arc>,
    /// The lights in the picture.
    pub lights: Vec<LightHandle>,
    /// The letters of vectors and angles.
    pub labels: Vec<Label>,
    /// The pane of the side view, pixels.
    pub side_view: Option<Area>,
    /// Drawings with their own halos, the later over the earlier.
    drawings: Vec<Drawing>,
    style: Style,
}

/// Draws the overlay of `probe` on `pixmap`, which holds a picture of `scene` of any size or nothing yet. Where the
/// probe hit nothing, only the lights are drawn.
pub fn draw_overlay(
    pixmap: &mut PixmapMut<'_>,
    scene: &Scene,
    probe: &Probe,
    options: &OverlayOptions,
) {
    Overlay::new([pixmap.width(), pixmap.height()], scene, probe, options).draw(pixmap);
}

impl Overlay {
    /// Lays out the overlay of `probe` for a picture of `scene` of `size` (width, height) pixels.
    pub fn new(size: [u32; 2], scene: &Scene, probe: &Probe, options: &OverlayOptions) -> Self {
        let picture = Area::from_size(DVec2::from_array(size.map(f64::from)));
        let side = picture.max.min_element();
        let style = Style::new(side, options);
        let view = View::new(&scene.camera, size);
        let about = |position, length: Option<f64>| {
            let (_, depth) = view.project(position)?;
            let length = length.filter(|length| *length > 0.0 && length.is_finite());
            let length = length.unwrap_or(UNIT_LENGTH * side * view.world_per_pixel(depth));
            Sketch::new(view, style, picture, position, length)
        };
        let mut overlay = Self {
            arrows: vec![],
            arcs: vec![],
            lights: vec![],
            labels: vec![],
            side_view: None,
            drawings: vec![],
            style,
        };
        let hit = probe
            .hit
            .as_ref()
            .and_then(|hit| Some((hit, about(hit.position, options.length)?)));
        let own = hit.as_ref().map(|(hit, _)| hit.scene_of(scene));
        let scene = own.as_deref().unwrap_or(scene);
        let (equation, sketch) = match hit {
            Some((hit, sketch)) => (Some(Equation::new(hit, scene, options)), Some(sketch)),
            None => (None, about(view.unproject(view.centre, 1.0), None)),
        };
        let Some(mut sketch) = sketch else {
            return overlay;
        };
        if options.layers.contains(&OverlayLayer::Lights) {
            overlay.lights = lights::draw(&mut sketch, &scene.lights, options.light);
        }
        let mut corner = equation
            .as_ref()
            .and_then(|equation| equation.side_view(picture, scene, &sketch, options));
        if let Some(equation) = equation {
            // Below everything else, and no obstacle to letters, since the lobe fills the middle of the drawing.
            overlay
                .drawings
                .push(style.drawing(equation.lobe(&sketch, scene, &options.layers)));
            // The side view has the angles where the vectors hide one another.
            let mut layers = options.layers.clone();
            layers.retain(|layer| corner.is_none() || *layer != OverlayLayer::Angles);
            (overlay.arrows, overlay.arcs) = equation.draw(&mut sketch, true, &layers);
        }
        overlay.side_view = corner.as_ref().map(|corner| corner.pane);
        let taken: Vec<Area> = overlay
            .side_view
            .into_iter()
            .chain(options.covered.iter().copied())
            .collect();
        overlay.take(&mut sketch, &taken);
        if let Some(corner) = &mut corner {
            overlay.take(corner, &[]);
        }
        overlay
    }

    /// Draws the overlay on a pixmap of the size for which it was laid out.
    pub fn draw(&self, pixmap: &mut PixmapMut<'_>) {
        self.drawings
            .iter()
            .for_each(|drawing| drawing.draw(pixmap));
        self.style.lettered(&self.labels).draw(pixmap);
    }

    fn take(&mut self, sketch: &mut Sketch, reserved: &[Area]) {
        self.labels.extend(sketch.labels(reserved));
        self.drawings
            .push(self.style.drawing(std::mem::take(&mut sketch.shapes)));
    }
}
