//! The places of a profile, equally spaced along the line and past its ends as far as an eye's surround reaches; and
//! one mode's intensity at any of them.

use crate::analysis::perception::{luminance, pixel_luminance};
use crate::illumination::Equation;
use crate::render::{Piece, Renderer};
use crate::scene::{Rgb, Scene};
use glam::DVec2;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// Samples per pixel along the longer side of the line, and the length from which on there is one.
const FINENESS: f64 = 4.0;
const LONG: f64 = 4096.0;
/// Distance past its ends to which the line is followed, in widths of the surround.
const REACH: f64 = 6.0;
/// Share of their distance within which a sample counts as an end of the line.
const SAME: f64 = 1e-9;
/// Half the distance over which slopes are taken, pixels: short beside polygons, long beside rounding errors.
const DELTA: f64 = 1.0 / 64.0;
/// Share of the line within which ends of pieces count as one place.
const ADJOINING: f64 = 1e-9;

/// A place of the line.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Sample {
    /// Pixels from the picture's left.
    pub x: f64,
    /// Pixels from the picture's top.
    pub y: f64,
    /// Parameter along the line, 0 at its start and 1 at its end.
    pub t: f64,
}

/// A line through the picture: `t` runs from 0 to 1 between its ends, and beyond them where it is followed further.
#[derive(Clone, Debug)]
pub struct Line {
    ends: [DVec2; 2],
    /// t of the first place, the step to the next, and the number of places.
    first: f64,
    step: f64,
    count: usize,
}

impl Line {
    /// Creates the line between two places of a picture of `size`, followed past its ends for a surround of `surround` pixels;
    /// none where it has no length.
    pub fn new(from: DVec2, to: DVec2, size: [u32; 2], surround: f64) -> Option<Self> {
        let along = to - from;
        let axis = usize::from(along.x.abs() < along.y.abs());
        let (longer, begin) = (along[axis], from[axis]);
        if longer.abs() < 1e-6 {
            return None;
        }
        let fineness = if longer.abs() > LONG { 1.0 } else { FINENESS };
        let (low, high) = in_picture(from, along, DVec2::from_array(size.map(f64::from)));
        let past = REACH * surround / along.length();
        let (low, high) = (low.max(-past).min(0.0), high.min(1.0 + past).max(1.0));
        // Samples have their longer coordinate at (k + ½)/fineness − ½/fineness: at centres, and evenly between them.
        let step = 1.0 / (longer.abs() * fineness);
        let offset = if fineness > 1.0 { 0.0 } else { 0.5 };
        let grid = |t: f64| (begin + t * longer - offset) * fineness * longer.signum();
        let (first, last) = ((grid(low) - SAME).ceil(), (grid(high) + SAME).floor());
        let count = (last - first + 1.0).max(0.0) as usize;
        let (first, step, count) = if count == 0 {
            // Shorter than a step: only its ends.
            (0.0, 1.0, 2)
        } else {
            let first = (first * longer.signum() / fineness + offset - begin) / longer;
            (first, step, count)
        };
        Some(Self {
            ends: [from, to],
            first,
            step,
            count,
        })
    }

    /// Returns the length between the ends, pixels.
    fn length(&self) -> f64 {
        self.ends[0].distance(self.ends[1])
    }

    /// Returns the distance between samples, pixels.
    pub fn spacing(&self) -> f64 {
        self.step * self.length()
    }

    /// Returns the range of t in which the picture is followed.
    fn span(&self) -> [f64; 2] {
        [
            self.first.min(0.0),
            (self.first + self.step * (self.count - 1) as f64).max(1.0),
        ]
    }

    /// Returns the place at t, without rounding errors at the ends.
    pub fn place(&self, t: f64) -> DVec2 {
        let [from, to] = self.ends;
        if t == 1.0 { to } else { from + (to - from) * t }
    }

    /// Returns t of all places that are followed.
    fn followed(&self) -> impl Iterator<Item = f64> {
        (0..self.count).map(|k| self.first + self.step * k as f64)
    }

    /// Returns the samples between the ends, inclusive.
    pub fn samples(&self) -> Vec<Sample> {
        let inner = self.followed().filter(|t| self.is_inner(*t));
        let all = std::iter::once(0.0).chain(inner).chain([1.0]);
        let sample = |t: f64| {
            let DVec2 { x, y } = self.place(t);
            Sample { x, y, t }
        };
        all.map(sample).collect()
    }

    fn is_inner(&self, t: f64) -> bool {
        let min_distance = self.step * SAME;
        t > min_distance && t < 1.0 - min_distance
    }

    /// Selects from values at all places those at [`Line::samples`]; at the ends as given, or linear between
    /// neighbours.
    pub fn within(&self, values: &[f64], ends: [Option<f64>; 2]) -> Vec<f64> {
        let between = |t: f64| {
            let at = ((t - self.first) / self.step).clamp(0.0, (self.count - 1) as f64);
            let (k, share) = (at.floor() as usize, at.fract());
            let next = values.get(k + 1).or(values.last());
            let next = next.copied().unwrap_or_default();
            values.get(k).copied().unwrap_or_default() * (1.0 - share) + next * share
        };
        let inner = self
            .followed()
            .zip(values)
            .filter(|(t, _)| self.is_inner(*t))
            .map(|(_, value)| *value);
        let first = std::iter::once(ends[0].unwrap_or_else(|| between(0.0)));
        first
            .chain(inner)
            .chain([ends[1].unwrap_or_else(|| between(1.0))])
            .collect()
    }
}

/// Returns the range of t in which the line is inside a picture.
fn in_picture(from: DVec2, along: DVec2, size: DVec2) -> (f64, f64) {
    let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
    for axis in 0..2 {
        if along[axis] != 0.0 {
            let a = -from[axis] / along[axis];
            let b = (size[axis] - from[axis]) / along[axis];
            (low, high) = (low.max(a.min(b)), high.min(a.max(b)));
        }
    }
    (low, high)
}

/// A drawn scene, read along one line. Values are intensities with their slopes per pixel.
pub struct Source<'a> {
    line: &'a Line,
    renderer: &'a Renderer,
    equations: Vec<Equation<f64>>,
    background: f64,
    size: [u32; 2],
    /// Pieces that the line sees, by t.
    pieces: Vec<Piece>,
    true_surface: bool,
    /// Luminance of the pixels, if contributions beyond the equation enter them.
    pixels: Option<Vec<f64>>,
}

impl<'a> Source<'a> {
    /// Draws `scene` and finds the polygons along `line`.
    pub fn new(renderer: &'a mut Renderer, scene: &Scene, line: &'a Line) -> Self {
        renderer.render(scene);
        let composes = renderer.plan().is_some_and(|plan| plan.composes);
        let pixels = composes.then(|| {
            renderer
                .linear_picture(scene)
                .iter()
                .map(pixel_luminance)
                .collect()
        });
        let renderer = &*renderer;
        let [low, high] = line.span();
        let mut pieces = renderer.section(line.place(low), line.place(high));
        for piece in &mut pieces {
            piece.from = low + piece.from * (high - low);
            piece.to = low + piece.to * (high - low);
        }
        Self {
            line,
            renderer,
            equations: renderer.shining_equations(scene),
            background: luminance(scene.image.background),
            size: scene.image.size,
            pieces,
            true_surface: renderer.plan().is_some_and(|plan| plan.true_surface),
            pixels,
        }
    }

    /// Returns the values at all places of the line.
    pub fn values(&self) -> Vec<(f64, f64)> {
        let places: Vec<f64> = self.line.followed().collect();
        places.into_par_iter().map(|t| self.value(t)).collect()
    }

    /// Returns the value at t; at a joint that of the piece after it.
    pub fn value(&self, t: f64) -> (f64, f64) {
        let after = self.pieces.partition_point(|piece| piece.from <= t);
        let piece = after
            .checked_sub(1)
            .and_then(|index| self.pieces.get(index))
            .filter(|piece| t < piece.to);
        let delta = DELTA / self.line.length();
        let (mut from, mut to) = (t - delta, t + delta);
        if let (Some(piece), None) = (piece, &self.pixels) {
            (from, to) = (from.max(piece.from), to.min(piece.to));
        } else if self.true_surface && self.pixels.is_none() {
            // A difference across the outline would not be a slope.
            let sees = |t: f64| self.renderer.evaluation_at(self.place(t), None).is_some();
            let seen = sees(t);
            [from, to] = [from, to].map(|end| if sees(end) == seen { end } else { t });
        }
        let at = |t: f64| self.intensity(t, piece);
        let run = (to - from) * self.line.length();
        let slope = if run > 0.0 {
            (at(to) - at(from)) / run
        } else {
            0.0
        };
        (at(t), slope)
    }

    /// Returns the joints between the line's ends, where one piece ends and another or the background begins.
    pub fn joints(&self) -> Vec<(f64, [Option<&Piece>; 2])> {
        let before = std::iter::once(None).chain(self.pieces.iter().map(Some));
        let after = self.pieces.iter().map(Some).chain([None]);
        let joints = before.zip(after).flat_map(|sides| match sides {
            (Some(a), Some(b)) if b.from - a.to <= ADJOINING => vec![(b.from, [Some(a), Some(b)])],
            (a, b) => {
                let left = a.map(|a| (a.to, [Some(a), None]));
                let right = b.map(|b| (b.from, [None, Some(b)]));
                left.into_iter().chain(right).collect()
            }
        });
        // Where the followed line begins or ends on the object there is no border.
        let [low, high] = self.line.span();
        let inside = (low + ADJOINING).max(0.0)..=(high - ADJOINING).min(1.0);
        joints.filter(|(t, _)| inside.contains(t)).collect()
    }

    /// Returns the values on both sides of a joint at t.
    pub fn sides(&self, t: f64, sides: [Option<&Piece>; 2]) -> [(f64, f64); 2] {
        let delta = DELTA / self.line.length();
        let side = |piece: Option<&Piece>, way: f64| {
            let Some(piece) = piece else {
                return (self.intensity(t + way * delta, None), 0.0);
            };
            let delta = delta.min(piece.to - piece.from) * way;
            let [here, there] = [t, t + delta].map(|t| self.intensity(t, Some(piece)));
            (here, (there - here) / (delta * self.line.length()))
        };
        [side(sides[0], -1.0), side(sides[1], 1.0)]
    }

    /// Returns the place at t, clamped to the picture.
    fn place(&self, t: f64) -> DVec2 {
        let last = DVec2::from_array(self.size.map(|side| f64::from(side) - 1e-6));
        self.line.place(t).clamp(DVec2::ZERO, last)
    }

    fn intensity(&self, t: f64, piece: Option<&Piece>) -> f64 {
        if let Some(pixels) = &self.pixels {
            return bilinear(pixels, self.size, self.line.place(t));
        }
        let seen = self.renderer.evaluation_at(self.place(t), piece);
        seen.map_or(self.background, |seen| {
            luminance(seen.shown(&self.equations).max(Rgb::ZERO))
        })
    }
}

/// Interpolates linearly between the centres of pixels; beyond the outermost ones their value continues.
fn bilinear(pixels: &[f64], [width, height]: [u32; 2], place: DVec2) -> f64 {
    let split = |at: f64, side: u32| {
        let last = side.saturating_sub(1);
        let at = (at - 0.5).clamp(0.0, f64::from(last));
        let index = at.floor() as usize;
        (index, (index + 1).min(last as usize), at.fract())
    };
    let ((x0, x1, u), (y0, y1, v)) = (split(place.x, width), split(place.y, height));
    let at = |x: usize, y: usize| {
        pixels
            .get(y * width as usize + x)
            .copied()
            .unwrap_or_default()
    };
    let row = |y| at(x0, y) * (1.0 - u) + at(x1, y) * u;
    row(y0) * (1.0 - v) + row(y1) * v
}
