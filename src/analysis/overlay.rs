//! Drawings over a picture: their layers, and the sizes, colours and labels that they share.

pub(in crate::analysis) mod inset;

pub use inset::free_corners;

use crate::figure::palette::{Rgb8, Vector, readable};
use crate::figure::{Area, Drawing, Label, Placer, Shape, Wish, inked_size};
use crate::scene::{Projection, View};
use glam::{DVec2, DVec3};
use serde::{Deserialize, Serialize};

/// Minimum depth of an arrow's end in depths of its tail: perspective would enlarge nearer ends without bound.
const NEAREST: f64 = 0.05;
/// Distance along the line of sight, in pixels, below which the direction of an end is due to rounding alone.
const ROUNDING: f64 = 1e-3;
/// Distance of an end, in pixels, beyond which it is drawn at this distance: the line to it looks the same.
const FARTHEST: f64 = 1e6;
/// Minimum text size, in pixels an em, before [`OverlayOptions::scale`].
const LEAST_TEXT: f64 = 13.0;

/// Returns the size of letters over a pane with a shorter `side`, pixels, before [`OverlayOptions::scale`].
pub fn overlay_letters(side: f64) -> f64 {
    LEAST_TEXT.max(side / 28.0)
}

/// A layer of an overlay.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum OverlayLayer {
    /// N, L, R, V and, for Blinn's model, H at the probe's point.
    Vectors,
    /// The arcs of θ and φ with their values.
    Angles,
    /// Construction of R from L by projection on N.
    Construction,
    /// A sun for each light, parallel rays for each directional one.
    Lights,
    /// Light that the point reflects in every direction, as a surface about it.
    Lobe,
    /// The vectors once more in a corner, from the side: V points at the eye and is but a point in the picture itself.
    SideView,
    /// The intensity along a line. It belongs to no point; [`draw_profile`](crate::analysis::profile::draw_profile)
    /// draws it.
    Profile,
    /// Positions of the defects of interpolated shading; [`draw_defects`](crate::analysis::defects::draw_defects) draws
    /// them.
    Defects,
    /// A needle at the centre of each visible polygon, drawn by [`Needles`](crate::analysis::normals::Needles).
    FaceNormals,
    /// A needle at each visible vertex.
    VertexNormals,
}

impl OverlayLayer {
    /// All layers.
    pub const ALL: [Self; 10] = [
        Self::Vectors,
        Self::Angles,
        Self::Construction,
        Self::Lights,
        Self::Lobe,
        Self::SideView,
        Self::Profile,
        Self::Defects,
        Self::FaceNormals,
        Self::VertexNormals,
    ];

    /// Returns whether the layer explains the probed point.
    pub fn of_point(self) -> bool {
        !matches!(
            self,
            Self::Lights | Self::Profile | Self::Defects | Self::FaceNormals | Self::VertexNormals
        )
    }

    /// Returns whether an [`Overlay`](crate::analysis::probe::Overlay) draws the layer.
    pub fn of_overlay(self) -> bool {
        self.of_point() || self == Self::Lights
    }

    /// Returns whether [`Needles`](crate::analysis::normals::Needles) draw the layer.
    pub fn of_needles(self) -> bool {
        matches!(self, Self::FaceNormals | Self::VertexNormals)
    }
}

/// The halo that sets strokes and letters off from the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Halo {
    /// A white halo.
    Light,
    /// A nearly black halo.
    Dark,
}

/// Appearance of an overlay.
#[derive(Clone, Debug, PartialEq)]
pub struct OverlayOptions {
    /// Layers to draw, the later over the earlier.
    pub layers: Vec<OverlayLayer>,
    /// Index of the light that is emphasised and shown in full; without one, the first that the point faces, or the
    /// first.
    pub light: Option<usize>,
    /// Length of a unit vector in world units; without one, about a fifth of the picture's shorter side.
    pub length: Option<f64>,
    /// True to show H for every model, false for Blinn's alone.
    pub half_vector: bool,
    /// True to add the side view where vectors point at the viewer and hide one another.
    pub side_view_where_needed: bool,
    /// True if the side view shows angles.
    pub side_view_angles: bool,
    /// True if the side view takes most of the picture.
    pub side_view_enlarged: bool,
    /// Sides of the squares in the picture's corners that a pane with a drawing of its own may cover, as
    /// [`free_corners`] returns them; without them, it may cover all.
    pub free_corners: Option<[u32; 4]>,
    /// Halo that sets lines and letters off from the picture.
    pub halo: Halo,
    /// Areas covered by other drawings, pixels, which labels avoid.
    pub covered: Vec<Area>,
    /// Factor of text size and line widths, from 0.05 to 20; 1 suits a picture that fills the screen.
    pub scale: f64,
}

impl Default for OverlayOptions {
    fn default() -> Self {
        Self {
            layers: vec![OverlayLayer::Vectors, OverlayLayer::Angles],
            light: None,
            length: None,
            half_vector: false,
            side_view_where_needed: false,
            side_view_angles: true,
            side_view_enlarged: false,
            free_corners: None,
            halo: Halo::Light,
            covered: vec![],
            scale: 1.0,
        }
    }
}

/// Sizes of all elements, in pixels, and the neutral colours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::analysis) struct Style {
    pub text: f64,
    pub line: f64,
    pub halo: f64,
    /// Length of an arrow's head.
    pub head: f64,
    /// Radius of the probe's ring.
    pub ring: f64,
    /// Colour of lines and letters that belong to no vector.
    pub neutral: Rgb8,
    pub halo_colour: Rgb8,
    /// Minimum contrast of the vectors with their halo.
    pub contrast: f64,
}

impl Style {
    /// Returns the colour of a vector: lighter on a dark halo where its own is dark.
    pub fn colour(&self, vector: Vector) -> Rgb8 {
        readable(vector.colour(), self.halo_colour, self.contrast)
    }

    /// Returns the style of a pane whose shorter side is `side` pixels.
    pub fn new(side: f64, options: &OverlayOptions) -> Self {
        let scale = if options.scale.is_finite() {
            options.scale.clamp(0.05, 20.0)
        } else {
            1.0
        };
        Self::of_text(overlay_letters(side) * scale, options.halo)
    }

    /// Returns the style with letters of `text` pixels an em.
    pub fn of_text(text: f64, halo: Halo) -> Self {
        let line = 0.115 * text;
        let (neutral, halo_colour, contrast) = match halo {
            Halo::Light => ([24; 3], [255; 3], 1.0),
            Halo::Dark => ([255; 3], [16; 3], 5.5),
        };
        Self {
            text,
            line,
            halo: 0.075 * text,
            head: 5.0 * line,
            ring: 1.8 * line,
            neutral,
            halo_colour,
            contrast,
        }
    }

    pub fn drawing(&self, shapes: Vec<Shape>) -> Drawing {
        Drawing {
            shapes,
            ..Drawing::over_picture(self.halo_colour, self.halo)
        }
    }

    pub fn lettered<'a>(&self, labels: impl IntoIterator<Item = &'a Label>) -> Drawing {
        let texts = labels
            .into_iter()
            .map(|label| label.to_text(self.halo))
            .collect();
        Drawing {
            texts,
            ..self.drawing(vec![])
        }
    }
}

/// A point of the world in a view, with the shapes drawn about it.
pub(in crate::analysis) struct Sketch {
    pub view: View,
    pub style: Style,
    /// The part of the picture that may be drawn on.
    pub pane: Area,
    pub position: DVec3,
    /// Position of `position` in the picture.
    pub origin: DVec2,
    /// Length of a unit vector, world units.
    pub length: f64,
    pub shapes: Vec<Shape>,
    /// Labels not yet placed: their text, size and colour, and their preferred position.
    pending: Vec<(String, f64, Rgb8, Wish)>,
}

impl Sketch {
    /// Creates a sketch with unit vectors of `length` world units; none where `position` does not appear.
    pub fn new(view: View, style: Style, pane: Area, position: DVec3, length: f64) -> Option<Self> {
        let (origin, _) = view.project(position)?;
        Some(Self {
            view,
            style,
            pane,
            position,
            origin,
            length,
            shapes: Vec::new(),
            pending: Vec::new(),
        })
    }

    /// Returns the picture position of the end of `vector` when it starts at the point: in perspective, at the end's
    /// own depth. A vector that would pass the eye is cut short before it.
    pub fn end(&self, vector: DVec3) -> Option<DVec2> {
        let depth = (self.position - self.view.eye).dot(self.view.forward);
        let reach = vector * self.length;
        let approach = -reach.dot(self.view.forward);
        let limit = (1.0 - NEAREST) * depth;
        let share = if approach > limit {
            limit / approach
        } else {
            1.0
        };
        let (end, _) = self.view.project(self.position + reach * share)?;
        let way = end - self.origin;
        let far = way.abs().max_element();
        Some(if far > FARTHEST {
            self.origin + way / far * FARTHEST
        } else if far < ROUNDING {
            self.origin
        } else {
            end
        })
    }
    /// Returns the positions of the ends of several vectors, if all are in the picture.
    pub fn ends(&self, vectors: impl IntoIterator<Item = DVec3>) -> Option<Vec<DVec2>> {
        vectors.into_iter().map(|vector| self.end(vector)).collect()
    }

    /// Draws an arrow from the origin to `tip`, whose head takes at most half of it; returns its direction in the picture.
    pub fn arrow(&mut self, tip: DVec2, width: f64, colour: Rgb8) -> DVec2 {
        let along = (tip - self.origin).normalize_or_zero();
        let head = self.style.head.min(0.5 * self.origin.distance(tip));
        let [shaft, point] = Shape::arrow([self.origin, tip], along, width, head, colour);
        self.shapes.push(shaft);
        self.shapes.extend((head > 0.0).then_some(point));
        along
    }

    /// Returns the sine of the angle between `vector` and the line of sight, signed: positive towards the eye.
    pub fn slant(&self, vector: DVec3) -> f64 {
        let towards = match self.view.projection {
            Projection::Perspective => self.view.towards_eye(self.position),
            Projection::Orthographic => -self.view.forward,
        };
        let cosine = vector.normalize_or_zero().dot(towards);
        (1.0 - cosine * cosine).max(0.0).sqrt().copysign(cosine)
    }

    /// Returns the last point of the line from the origin to `point` inside the pane, `margin` from its edge.
    pub fn inside(&self, point: DVec2, margin: f64) -> DVec2 {
        let bounds = Area {
            min: self.pane.min + margin,
            max: (self.pane.max - margin).max(self.pane.min + margin),
        };
        let from = bounds.nearest(self.origin);
        let way = point - from;
        let mut share = 1.0f64;
        for axis in 0..2 {
            if way[axis] > 0.0 {
                share = share.min((bounds.max[axis] - from[axis]) / way[axis]);
            } else if way[axis] < 0.0 {
                share = share.min((bounds.min[axis] - from[axis]) / way[axis]);
            }
        }
        from + way * share
    }

    /// Draws the end of an arrow seen along its shaft: in a circle a dot towards the eye, a cross away from it.
    pub fn draw_end_on(&mut self, at: DVec2, radius: f64, towards_eye: bool, colour: Rgb8) {
        let line = self.style.line;
        self.shapes
            .push(Shape::ring(at, radius, 0.8 * line, colour));
        if towards_eye {
            self.shapes.push(Shape::disc(at, 1.1 * line, colour));
            return;
        }
        let arm = DVec2::splat(radius * std::f64::consts::FRAC_1_SQRT_2);
        let cross =
            [arm, arm.perp()].map(|arm| Shape::line(vec![at - arm, at + arm], 0.6 * line, colour));
        self.shapes.extend(cross);
    }

    /// Requests a label of `size` times the usual size.
    pub fn letter(
        &mut self,
        text: String,
        size: f64,
        colour: Rgb8,
        anchor: DVec2,
        direction: DVec2,
        clearance: f64,
    ) {
        let em = size * self.style.text;
        let size = inked_size(&text, em) + 2.0 * self.style.halo + 0.1 * em;
        self.pending.push((
            text,
            em,
            colour,
            Wish {
                anchor,
                direction,
                size,
                clearance,
            },
        ));
    }

    /// Places every requested label, in order, outside `reserved`.
    pub fn labels(&mut self, reserved: &[Area]) -> Vec<Label> {
        let mut placer = Placer::new(self.pane, self.style.text, &self.shapes, reserved.to_vec());
        let mut labels = Vec::new();
        for (text, size, colour, wish) in std::mem::take(&mut self.pending) {
            let Some(area) = placer.place(&wish) else {
                continue;
            };
            self.leader(&wish, area, colour);
            labels.push(Label {
                text,
                area,
                size,
                colour,
            });
        }
        labels
    }

    /// Draws a thin line from a label that had to be placed far away to the point that it names.
    fn leader(&mut self, wish: &Wish, label: Area, colour: Rgb8) {
        let Wish {
            anchor, clearance, ..
        } = *wish;
        let near = label.nearest(anchor);
        let way = near - anchor;
        if way.length() > clearance + 1.3 * self.style.text {
            let start = anchor + way.normalize_or_zero() * clearance;
            self.shapes.push(Shape::line(
                vec![start, near],
                0.35 * self.style.line,
                colour,
            ));
        }
    }
}
