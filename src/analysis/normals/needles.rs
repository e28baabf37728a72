//! The normals of polygons and of vertices as needles, and the polygons that one vertex normal comes from.
//!
//! A needle stands at a polygon's centre (yellow, dashed, a square foot) or at a vertex (N's blue, solid, a round foot). All
//! are equally long in the world, so that what is seen of one shows how it leans.

mod fine;
mod lit;
mod thin;

pub use lit::LitVertex;

use crate::analysis::overlay::{OverlayLayer, OverlayOptions, Sketch, Style};
use crate::analysis::{NormalField, SeenNormal};
use crate::figure::palette::{self, Rgb8};
use crate::figure::{Area, Label, inked_size};
use crate::render::Renderer;
use crate::scene::{Scene, View};
use fine::Fine;
use glam::{DVec2, DVec3};
use thin::thinned;
use tiny_skia::PixmapMut;

/// Length of a needle: the wanted share of the polygons' median edge, and its bounds in the picture's shorter side.
const LENGTH: f64 = 0.5;
const LENGTHS: [f64; 2] = [0.014, 0.085];
/// Width of a needle, in the line width of the vectors, and its foot's radius in its own width.
const WIDTH: f64 = 0.62;
const FOOT: f64 = 1.3;
/// Breadth of the halo, in widths.
const HALO: f64 = 0.5;
/// Contrast of blue needles with their halo: they are thin.
const CONTRAST: f64 = 5.5;
/// Size of the note about what is left out, in that of the vectors' letters.
const NOTE: f64 = 0.62;
/// The halo of yellow needles, which on white would not show.
const DARK: Rgb8 = [16; 3];

/// Whose normal a needle is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NeedleKind {
    Face,
    Vertex,
}

/// A normal in the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Needle {
    pub kind: NeedleKind,
    /// The face's or the vertex' number.
    pub index: u32,
    /// Where its point appears, pixels.
    pub foot: DVec2,
    pub tip: DVec2,
}

/// The needles of a picture, laid out.
#[derive(Clone, Debug)]
pub struct Needles {
    pub needles: Vec<Needle>,
    /// Length of every needle, world units.
    pub length: f64,
    /// Says how many there are, where not all are drawn.
    pub note: Option<Label>,
    style: Style,
}

impl Needles {
    /// The needles of the layers among `options` that are normals, over a picture of `scene` of `size` pixels that
    /// `renderer` last drew. Back faces and what other parts hide are left out; of more than fit, an even choice is made.
    pub fn new(
        size: [u32; 2],
        scene: &Scene,
        renderer: &Renderer,
        field: &NormalField,
        options: &OverlayOptions,
    ) -> Self {
        let side = f64::from(size[0].min(size[1]));
        let style = Style::new(side, options);
        let view = View::new(&scene.camera, size);
        let seen = field.facing(&view, size);
        let layers = [
            (NeedleKind::Vertex, OverlayLayer::VertexNormals, seen.vertices, "vertex normals"),
            (NeedleKind::Face, OverlayLayer::FaceNormals, seen.faces, "face normals"),
        ];
        let mut needles = Self { needles: vec![], length: 0.0, note: None, style };
        let (mut notes, mut others) = (Vec::new(), Vec::new());
        for (kind, layer, seen, name) in layers {
            if !options.layers.contains(&layer) || seen.is_empty() {
                continue;
            }
            let unit = view.world_per_pixel(median_depth(&seen));
            let letter = style.text * unit;
            let hidden = |one: &SeenNormal| field.hidden(renderer, one);
            let edge = field.median_edge();
            let choice = thinned(&seen, edge, letter, &others, hidden);
            if choice.thinned {
                notes.push(format!("{} of {} {name}", choice.shown.len(), seen.len()));
            }
            let [least, most] = LENGTHS.map(|share| share * side * unit);
            // Of either kind as long as the first.
            if needles.length == 0.0 {
                needles.length = (LENGTH * choice.apart.max(edge)).clamp(least, most);
            }
            others.extend(choice.shown.iter().map(|one| one.point));
            for one in &choice.shown {
                let tip = end(&view, one.point, one.normal * needles.length);
                needles.needles.extend(tip.map(|tip| Needle { kind, index: one.index, foot: one.pixel, tip }));
            }
        }
        needles.note = (!notes.is_empty()).then(|| note(notes.join(", "), size, &style));
        needles
    }

    /// Draws them on a pixmap of the size for which they were laid out.
    pub fn draw(&self, pixmap: &mut PixmapMut<'_>) {
        let width = WIDTH * self.style.line;
        for kind in [NeedleKind::Face, NeedleKind::Vertex] {
            let (colour, halo) = colours(kind, &self.style);
            let own = || self.needles.iter().filter(|needle| needle.kind == kind);
            let stroke = |needle: &Needle, more: f64| {
                let stroke = Fine::new(needle.foot, needle.tip, width + 2.0 * more, FOOT * width + more);
                if kind == NeedleKind::Face { stroke.square() } else { stroke }
            };
            own().for_each(|needle| stroke(needle, HALO * width).draw(pixmap, halo));
            let [dash, gap] = palette::FACE_DASHES.map(|length| f64::from(length) * width);
            for needle in own() {
                let solid = stroke(needle, 0.0);
                let stroke = if kind == NeedleKind::Face { solid.dashed(dash, gap) } else { solid };
                stroke.draw(pixmap, colour);
            }
        }
        self.style.lettered(&self.note).draw(pixmap);
    }
}

/// Draws the layers of `options` that are normals over a picture of `scene` that `renderer` last drew, and lights up the
/// vertex at `point` of its mesh. The pixmap is of that picture's size.
pub fn draw_normals(
    pixmap: &mut PixmapMut<'_>,
    scene: &Scene,
    renderer: &Renderer,
    options: &OverlayOptions,
    point: Option<u32>,
) {
    if !options.layers.iter().any(|layer| layer.of_needles()) {
        return;
    }
    let field = NormalField::new(renderer, &scene.object);
    let size = [pixmap.width(), pixmap.height()];
    Needles::new(size, scene, renderer, &field, options).draw(pixmap);
    let vertex = point.and_then(|point| field.vertex(field.vertex_at(point)?));
    if let Some(lit) = vertex.and_then(|vertex| LitVertex::new(size, scene, &field, &vertex, options)) {
        lit.draw(pixmap);
    }
}

/// The colour of a kind of needle and of its halo.
fn colours(kind: NeedleKind, style: &Style) -> (Rgb8, Rgb8) {
    match kind {
        NeedleKind::Face => (palette::FACE, DARK),
        NeedleKind::Vertex => (palette::readable(palette::N, style.halo_colour, CONTRAST), style.halo_colour),
    }
}

/// Where the end of `reach` from `point` appears; one that would pass the eye is cut short before it.
fn end(view: &View, point: DVec3, reach: DVec3) -> Option<DVec2> {
    Sketch::new(*view, Style::new(1.0, &OverlayOptions::default()), NO_PANE, point, Some(1.0), 1.0)?.end(reach)
}

const NO_PANE: Area = Area { min: DVec2::ZERO, max: DVec2::ZERO };

fn median_depth(seen: &[SeenNormal]) -> f64 {
    let mut depths: Vec<f64> = seen.iter().map(|one| one.depth).collect();
    let middle = depths.len() / 2;
    *depths.select_nth_unstable_by(middle, f64::total_cmp).1
}

/// At the lower left.
fn note(text: String, size: [u32; 2], style: &Style) -> Label {
    let em = (NOTE * style.text).max(13.0);
    let extent = inked_size(&text, em) + 2.0 * style.halo;
    let margin = DVec2::splat(0.8 * em);
    let corner = DVec2::new(margin.x, f64::from(size[1]) - margin.y - extent.y);
    Label { text, area: Area { min: corner, max: corner + extent }, size: em, colour: style.neutral }
}
