//! One mode's intensity at any place of a line.

use super::line::Line;
use crate::illumination::Equation;
use crate::render::{Piece, Renderer};
use crate::scene::{Rgb, Scene, ShadingMode};
use glam::DVec2;
use rayon::prelude::*;

/// Half the distance over which slopes are taken, pixels: short beside any polygon that is seen as one, long beside the
/// roundings of double precision.
const DELTA: f64 = 1.0 / 64.0;
/// Ends of pieces nearer to each other than this share of the line are one place.
const TOGETHER: f64 = 1e-9;

/// A drawn scene, read along one line.
pub struct Source<'a> {
    renderer: &'a Renderer,
    equation: Equation<f64>,
    background: f64,
    size: [u32; 2],
    mode: ShadingMode,
    pieces: Vec<Piece>,
    true_surface: bool,
    /// Luminance of the pixels, where more than the equation makes them up.
    pixels: Option<Vec<f64>>,
}

impl<'a> Source<'a> {
    /// Draws `scene` and finds the polygons along `line`.
    pub fn new(renderer: &'a mut Renderer, scene: &Scene, line: &Line) -> Self {
        renderer.render(scene);
        let composes = renderer.plan().is_some_and(|plan| plan.composes);
        let pixels = composes.then(|| {
            let linear = renderer.linear_picture(scene);
            linear.iter().map(|[r, g, b, _]| luminance(Rgb::new((*r).into(), (*g).into(), (*b).into()))).collect()
        });
        let renderer = &*renderer;
        let equation = renderer.shining_equation(scene);
        let plan = renderer.plan();
        let [from, to] = line.extent();
        Self {
            renderer,
            equation,
            background: luminance(scene.image.background),
            size: scene.image.size,
            mode: scene.shading.mode,
            pieces: renderer.section(from, to),
            true_surface: plan.is_some_and(|plan| plan.true_surface),
            pixels,
        }
    }

    pub fn mode(&self) -> ShadingMode {
        self.mode
    }

    /// Intensity and slope wherever the line is followed.
    pub fn values(&self, line: &Line) -> Vec<(f64, f64)> {
        let places: Vec<f64> = line.followed().map(|t| line.s(t)).collect();
        places.into_par_iter().map(|s| self.value(line, s, self.piece(s))).collect()
    }

    /// Intensity and slope at the line's own ends.
    pub fn at_ends(&self, line: &Line) -> [(f64, f64); 2] {
        [0.0, 1.0].map(|t| {
            let s = line.s(t);
            self.value(line, s, self.piece(s))
        })
    }

    /// Where one piece ends and another or the background begins.
    pub fn joints(&self) -> impl Iterator<Item = (f64, [Option<&Piece>; 2])> {
        let before = std::iter::once(None).chain(self.pieces.iter().map(Some));
        let after = self.pieces.iter().map(Some).chain([None]);
        let joints = before.zip(after).flat_map(|sides| match sides {
            (Some(a), Some(b)) if b.from - a.to <= TOGETHER => vec![(b.from, [Some(a), Some(b)])],
            (a, b) => {
                let left = a.map(|a| (a.to, [Some(a), None]));
                let right = b.map(|b| (b.from, [None, Some(b)]));
                left.into_iter().chain(right).collect()
            }
        });
        // Where the line begins or ends on the object there is no border.
        joints.filter(|(s, _)| (TOGETHER..=1.0 - TOGETHER).contains(s))
    }

    /// Intensity and slope on both sides of a joint at s.
    pub fn sides(&self, line: &Line, s: f64, sides: [Option<&Piece>; 2]) -> [(f64, f64); 2] {
        let delta = DELTA * line.pixel();
        let at = |s: f64, piece: &Piece| self.intensity(line.place(s), Some(piece));
        let side = |piece: Option<&Piece>, way: f64| {
            let Some(piece) = piece else { return (self.value(line, s + way * delta, None).0, 0.0) };
            let delta = delta.min(piece.to - piece.from) * way;
            let (here, there) = (at(s, piece), at(s + delta, piece));
            (here, (there - here) / (delta / line.pixel()))
        };
        [side(sides[0], -1.0), side(sides[1], 1.0)]
    }

    /// The piece seen at s; at a joint the one after it.
    fn piece(&self, s: f64) -> Option<&Piece> {
        let after = self.pieces.partition_point(|piece| piece.from <= s);
        self.pieces.get(after.checked_sub(1)?).filter(|piece| s < piece.to)
    }

    fn value(&self, line: &Line, s: f64, piece: Option<&Piece>) -> (f64, f64) {
        let at = |s: f64| self.intensity(line.place(s), piece);
        let here = at(s);
        let delta = DELTA * line.pixel();
        let (mut from, mut to) = (s - delta, s + delta);
        if let (Some(piece), None) = (piece, &self.pixels) {
            (from, to) = (from.max(piece.from), to.min(piece.to));
        } else if self.true_surface && self.pixels.is_none() {
            // A difference that crosses the outline would be no slope.
            let sees = |s: f64| self.sees(line.place(s));
            let seen = sees(s);
            (from, to) = (if sees(from) == seen { from } else { s }, if sees(to) == seen { to } else { s });
        }
        let run = (to - from) / line.pixel();
        (here, if run > 0.0 { (at(to) - at(from)) / run } else { 0.0 })
    }

    fn sees(&self, place: DVec2) -> bool {
        self.renderer.evaluation_at(self.inside(place), None).is_some()
    }

    /// The place, kept inside the picture.
    fn inside(&self, place: DVec2) -> DVec2 {
        place.clamp(DVec2::ZERO, DVec2::from_array(self.size.map(|side| f64::from(side) - 1e-6)))
    }

    fn intensity(&self, place: DVec2, piece: Option<&Piece>) -> f64 {
        if let Some(pixels) = &self.pixels {
            return bilinear(pixels, self.size, place);
        }
        let seen = self.renderer.evaluation_at(self.inside(place), piece);
        seen.map_or(self.background, |seen| luminance(seen.shown(&self.equation).max(Rgb::ZERO)))
    }
}

/// Linear between the centres of pixels; beyond the outermost ones their value goes on.
fn bilinear(pixels: &[f64], [width, height]: [u32; 2], place: DVec2) -> f64 {
    let split = |at: f64, side: u32| {
        let at = (at - 0.5).clamp(0.0, f64::from(side.saturating_sub(1)));
        (at.floor() as usize, (at.floor() as usize + 1).min(side.saturating_sub(1) as usize), at.fract())
    };
    let ((x0, x1, u), (y0, y1, v)) = (split(place.x, width), split(place.y, height));
    let at = |x: usize, y: usize| pixels.get(y * width as usize + x).copied().unwrap_or_default();
    let row = |y| at(x0, y) * (1.0 - u) + at(x1, y) * u;
    row(y0) * (1.0 - v) + row(y1) * v
}

/// Rec. 709 luminance of a linear colour.
pub fn luminance(color: Rgb) -> f64 {
    color.dot(Rgb::new(0.2126, 0.7152, 0.0722))
}
