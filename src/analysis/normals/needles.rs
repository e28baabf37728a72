//! Needles for the normals of polygons and vertices.
//!
//! A needle stands at a polygon's centre (yellow, dashed, a square foot) or at a vertex (N's blue, solid, a round
//! foot). All have the same length in the world, so that the visible length of one shows how it leans. Where there
//! are more than a picture can show, an even choice is drawn: needles keep a distance in the world, not in the
//! picture, so that they crowd towards an outline as the surface does, and those on the outline stay.

use super::fine::Fine;
use super::{NormalField, SeenNormal};
use crate::analysis::overlay::{OverlayLayer, OverlayOptions, Sketch, Style};
use crate::bits::SplitMix64;
use crate::figure::palette::{self, Rgb8, Vector, readable};
use crate::figure::{Area, Label, inked_size};
use crate::render::Renderer;
use crate::scene::{Scene, View};
use crate::text;
use glam::{DVec2, DVec3};
use std::collections::HashMap;
use tiny_skia::PixmapMut;

/// Length of a needle as a share of the polygons' median edge, and its bounds in the picture's shorter side.
pub(super) const LENGTH: f64 = 0.5;
pub(super) const LENGTHS: [f64; 2] = [0.014, 0.085];
/// Width of a needle, in the line width of the vectors; radius of its foot and width of its halo, in its own width.
const WIDTH: f64 = 0.62;
const FOOT: f64 = 1.3;
const HALO: f64 = 0.5;
/// Minimum contrast of the thin blue needles with their halo.
pub(super) const CONTRAST: f64 = 5.5;
/// Text size of the note about omitted needles, relative to the vectors' letters.
const NOTE: f64 = 0.62;
/// Minimum text size of the note, pixels an em, before the scale.
const LEAST_NOTE: f64 = 13.0;
/// Halo of yellow needles, which would not show on white.
pub(super) const DARK: Rgb8 = [16; 3];
/// Maximum number of needles drawn.
const MOST: usize = 2000;
/// Maximum number of normals considered one by one; of more, a random choice of this many.
const LOOKED_AT: usize = 24_000;
/// Edge length, in letters, below which needles do not fit at every edge.
const CROWDED: f64 = 0.5;
/// Minimum distance between needles: in letters where crowded, else in median edges, since some parts are finer.
const APART: f64 = 0.8;
const APART_IN_EDGES: f64 = 0.15;
/// Minimum distance from needles of the other kind, where crowded, relative to that within a kind.
const OTHERS: f64 = 0.3;
/// The owner of a needle's normal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NeedleKind {
    /// A face, at its centre.
    Face,
    /// A vertex.
    Vertex,
}

/// A normal in the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Needle {
    /// The owner of the normal: a face or a vertex.
    pub kind: NeedleKind,
    /// Number of the face or vertex.
    pub index: u32,
    /// Position of the normal's point in the picture, pixels.
    pub foot: DVec2,
    /// Position of the needle's tip in the picture, pixels.
    pub tip: DVec2,
}

/// The needles of a picture, laid out.
#[derive(Clone, Debug)]
pub struct Needles {
    /// The needles that are drawn.
    pub needles: Vec<Needle>,
    /// Length of every needle, world units.
    pub length: f64,
    /// Note about the number of needles, where not all are drawn.
    pub note: Option<Label>,
    style: Style,
}

impl Needles {
    /// Lays out the needles of the layers among `options` over a picture of `scene` of `size` pixels that `renderer`
    /// last drew, without back faces and hidden points; if there are too many, an even choice is made.
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
            (
                NeedleKind::Vertex,
                OverlayLayer::VertexNormals,
                seen.vertices,
                "picture-needles-vertices",
            ),
            (
                NeedleKind::Face,
                OverlayLayer::FaceNormals,
                seen.faces,
                "picture-needles-faces",
            ),
        ];
        let mut needles = Self {
            needles: vec![],
            length: 0.0,
            note: None,
            style,
        };
        let (mut notes, mut others) = (Vec::new(), Vec::new());
        for (kind, layer, seen, name) in layers {
            if !options.layers.contains(&layer) || seen.is_empty() {
                continue;
            }
            let mut depths: Vec<f64> = seen.iter().map(|one| one.depth).collect();
            let middle = depths.len() / 2;
            let unit =
                view.world_per_pixel(*depths.select_nth_unstable_by(middle, f64::total_cmp).1);
            let edge = field.median_edge;
            let choice = thinned(&seen, edge, style.text * unit, &others, |one| {
                field.hidden(renderer, one)
            });
            if choice.thinned {
                let (shown, all) = (choice.shown.len(), seen.len());
                notes.push(text!(
                    name,
                    shown = shown.to_string(),
                    all = all.to_string()
                ));
            }
            let [least, most] = LENGTHS.map(|share| share * side * unit);
            // Needles of either kind are as long as the first.
            if needles.length == 0.0 {
                needles.length = (LENGTH * choice.apart.max(edge)).clamp(least, most);
            }
            others.extend(choice.shown.iter().map(|one| one.point));
            for one in &choice.shown {
                // A needle that would pass the eye is cut short before it.
                let nowhere = Area::from_size(DVec2::ZERO);
                let sketch = Sketch::new(view, style, nowhere, one.point, 1.0);
                let tip = sketch.and_then(|sketch| sketch.end(one.normal * needles.length));
                needles.needles.extend(tip.map(|tip| Needle {
                    kind,
                    index: one.index,
                    foot: one.pixel,
                    tip,
                }));
            }
        }
        if !notes.is_empty() {
            // At the lower right, since panes have their figures at the lower left.
            let text = match &notes[..] {
                [vertices, faces] => text!(
                    "picture-needles-both",
                    vertices = &vertices[..],
                    faces = &faces[..]
                ),
                _ => notes.concat(),
            };
            let em = (NOTE * style.text).max(LEAST_NOTE * options.scale);
            let extent = inked_size(&text, em) + 2.0 * style.halo;
            let corner = DVec2::from_array(size.map(f64::from)) - DVec2::splat(0.8 * em) - extent;
            let area = Area {
                min: corner,
                max: corner + extent,
            };
            needles.note = Some(Label {
                text,
                area,
                size: em,
                colour: style.neutral,
            });
        }
        needles
    }

    /// Draws the needles on a pixmap of the size for which they were laid out.
    pub fn draw(&self, pixmap: &mut PixmapMut<'_>) {
        let (style, width) = (self.style, WIDTH * self.style.line);
        let blue = readable(Vector::N.colour(), style.halo_colour, CONTRAST);
        let dash = palette::FACE_DASHES.map(|length| f64::from(length) * width);
        for (kind, colour, halo, dash) in [
            (NeedleKind::Face, palette::FACE, DARK, Some(dash)),
            (NeedleKind::Vertex, blue, style.halo_colour, None),
        ] {
            // All halos come first.
            for (colour, more, dash) in [(halo, HALO * width, None), (colour, 0.0, dash)] {
                for needle in self.needles.iter().filter(|needle| needle.kind == kind) {
                    let Needle { foot, tip, .. } = *needle;
                    let (width, breadth) = (width + 2.0 * more, FOOT * width + more);
                    Fine {
                        foot,
                        tip,
                        width,
                        breadth,
                        square: kind == NeedleKind::Face,
                        dash,
                    }
                    .draw(pixmap, colour);
                }
            }
        }
        style.lettered(&self.note).draw(pixmap);
    }
}

struct Choice {
    shown: Vec<SeenNormal>,
    /// Distance kept between them where they are crowded, world units.
    apart: f64,
    /// True if some were omitted although nothing hides them.
    thinned: bool,
}

/// Chooses needles that are not `hidden` and keep a distance from each other and from `others`, in the mesh's order.
fn thinned(
    seen: &[SeenNormal],
    edge: f64,
    letter: f64,
    others: &[DVec3],
    hidden: impl Fn(&SeenNormal) -> bool,
) -> Choice {
    let crowded = seen.len() > MOST || edge < CROWDED * letter;
    let (mut apart, others) = if crowded {
        (APART * letter, others)
    } else {
        (APART_IN_EDGES * edge, &[][..])
    };
    let one_in = seen.len().div_ceil(LOOKED_AT) as u64;
    let looked_at: Vec<SeenNormal> = seen
        .iter()
        .filter(|one| scattered(one.index).is_multiple_of(one_in))
        .copied()
        .collect();
    loop {
        let (shown, dropped) = kept_apart(&looked_at, apart, others, &hidden);
        // If a letter has no size either, no distance would ever suffice.
        let grows = apart.is_finite() && (apart > 0.0 || letter > 0.0);
        if shown.len() <= MOST || !grows {
            let apart = if crowded { apart } else { 0.0 };
            return Choice {
                shown,
                apart,
                thinned: dropped || one_in > 1,
            };
        }
        // If all edges have no length, the distance goes from zero to a letter's size.
        apart = (1.25 * apart).max(APART * letter);
    }
}

/// Returns a number unrelated to those of neighbouring indices.
fn scattered(index: u32) -> u64 {
    SplitMix64(index.into()).next_u64()
}

/// A grid with cells as wide as the minimum distance: anything too near lies in the same cell or a neighbour.
#[derive(Default)]
struct Grid {
    cell: f64,
    feet: HashMap<[i64; 3], Vec<DVec3>>,
}

impl Grid {
    fn place(&self, foot: DVec3) -> [i64; 3] {
        (foot / self.cell.max(f64::MIN_POSITIVE))
            .floor()
            .to_array()
            .map(|x| x as i64)
    }

    fn add(&mut self, foot: DVec3) {
        self.feet.entry(self.place(foot)).or_default().push(foot);
    }

    /// Returns whether no point is nearer to `foot` than the width of a cell.
    fn free(&self, foot: DVec3) -> bool {
        if self.feet.is_empty() {
            return true;
        }
        let near = |other: &DVec3| other.distance_squared(foot) < self.cell * self.cell;
        let taken = |place: [i64; 3]| {
            self.feet
                .get(&place)
                .is_some_and(|feet| feet.iter().any(near))
        };
        let [x, y, z] = self.place(foot);
        let beside = |x: i64| x.saturating_sub(1)..=x.saturating_add(1);
        // Its own cell decides for most points that are not free.
        !taken([x, y, z])
            && !beside(x).any(|x| beside(y).any(|y| beside(z).any(|z| taken([x, y, z]))))
    }
}

/// Returns the needles that are kept, and whether any was omitted that nothing hides.
fn kept_apart(
    seen: &[SeenNormal],
    apart: f64,
    others: &[DVec3],
    hidden: &impl Fn(&SeenNormal) -> bool,
) -> (Vec<SeenNormal>, bool) {
    let mut taken = Grid {
        cell: OTHERS * apart,
        ..Grid::default()
    };
    others.iter().for_each(|foot| taken.add(*foot));
    let mut own = Grid {
        cell: apart,
        ..Grid::default()
    };
    let mut shown: Vec<SeenNormal> = Vec::new();
    let mut dropped = false;
    for one in seen {
        if !own.free(one.point) || !taken.free(one.point) {
            // Several normals at one point belong to several vertices.
            let upon = shown
                .last()
                .is_some_and(|last| last.point == one.point && last.normal != one.normal);
            if !upon {
                dropped = dropped || !hidden(one);
                continue;
            }
        }
        if !hidden(one) {
            own.add(one.point);
            shown.push(*one);
        }
    }
    (shown, dropped)
}
