//! The intensity along a line through the picture, for each way of shading, with its slope and what is perceived of it.
//!
//! Gouraud shading makes the intensity continuous but leaves corners in it, where its slope changes at once: Mach bands are
//! seen there. Phong shading weakens them, it does not abolish them.
//!
//! Intensities are linear and before the display: neither clamped nor rounded, as Rec. 709 luminance. The equation is
//! evaluated at the places of the line themselves, in double precision, where the shading mode evaluates it; only what rays
//! find (a ground, what is seen through glass, light from other surfaces) is taken from the pixels and is linear between their
//! centres.

mod line;
mod overlay;
mod picture;
mod plots;
mod report;
mod source;

pub use overlay::{CURVE, ProfileCurves, draw_profile, lay_out_profile};
pub use picture::{PERCEIVED_WIDTH, perceived_picture};
pub use plots::profile_plots;
pub use report::TakenProfile;

pub use line::Sample;
pub use source::luminance;

use super::perception::{Perception, Viewing, blur_line};
use crate::render::{Piece, Renderer};
use crate::scene::{Scene, ShadingMode};
use glam::DVec2;
use line::Line;
use serde::{Deserialize, Serialize};
use source::Source;
use thiserror::Error;

/// What the profile is taken of.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ProfileQuestion {
    /// The line's ends in pixels, a pixel's centre at +0.5; inside the picture.
    pub from: DVec2,
    pub to: DVec2,
    pub modes: Vec<ShadingMode>,
    pub viewing: Viewing,
    pub perception: Perception,
}

impl ProfileQuestion {
    /// The modes that are compared unless others are asked for.
    pub const MODES: [ShadingMode; 4] =
        [ShadingMode::Flat, ShadingMode::Gouraud, ShadingMode::Phong, ShadingMode::Exact];

    /// A line between two places, with everything else as usual.
    pub fn new(from: DVec2, to: DVec2) -> Self {
        let (viewing, perception) = Default::default();
        Self { from, to, modes: Self::MODES.to_vec(), viewing, perception }
    }

    /// Whether there is such a profile in a picture of `size`.
    ///
    /// # Errors
    /// Why there is none.
    pub fn check(&self, size: [u32; 2]) -> Result<(), ProfileError> {
        self.line(size).map(|_| ())
    }

    fn line(&self, size: [u32; 2]) -> Result<Line, ProfileError> {
        let inside = |p: DVec2| p.cmpge(DVec2::ZERO).all() && p.cmple(DVec2::from_array(size.map(f64::from))).all();
        if !inside(self.from) || !inside(self.to) {
            return Err(ProfileError::Outside { size });
        }
        if self.modes.is_empty() {
            return Err(ProfileError::NoMode);
        }
        let [_, surround] = self.perception.widths(self.viewing.pixels_per_degree());
        Line::new(self.from, self.to, size, surround).ok_or(ProfileError::NoLength)
    }
}

/// Why there is no profile.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum ProfileError {
    #[error("outside the picture, expected 0,0 to {width},{height}", width = .size[0], height = .size[1])]
    Outside { size: [u32; 2] },
    #[error("both ends of the line are at one place, expected two")]
    NoLength,
    #[error("no shading mode, expected at least one")]
    NoMode,
}

/// The profile along a line.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Profile {
    pub samples: Vec<Sample>,
    /// One per mode, in the order asked for.
    pub traces: Vec<Trace>,
    /// Where the line crosses from one polygon to another or to the background. The true surface has none.
    pub borders: Vec<Border>,
    /// Length of the line, pixels.
    pub length: f64,
    /// σc and σs, pixels.
    pub widths: [f64; 2],
}

/// One mode's values, one per sample.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Trace {
    pub mode: ShadingMode,
    pub intensity: Vec<f64>,
    /// Per pixel along the line. It is taken within the polygon that the sample sees and never across its border, so that a
    /// corner stays a jump of the slope.
    pub slope: Vec<f64>,
    pub perceived: Vec<f64>,
    /// What happens at each border; nothing where the mode knows no polygons.
    pub corners: Vec<Option<Corner>>,
}

/// A border between polygons on the line.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Border {
    pub x: f64,
    pub y: f64,
    pub t: f64,
    /// The faces before and after it; none is the background. Twice the same is the diagonal along which a polygon was cut.
    pub faces: [Option<u32>; 2],
}

/// The intensity on both sides of a border.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Corner {
    /// By how much the intensity jumps.
    pub step: f64,
    /// One-sided slopes before and after, per pixel.
    pub slopes: [f64; 2],
    /// Their difference.
    pub jump: f64,
}

impl Trace {
    /// The mode's name, as in a scene file.
    pub fn word(&self) -> &'static str {
        match self.mode {
            ShadingMode::Flat => "flat",
            ShadingMode::Interpolated => "interpolated",
            ShadingMode::Gouraud => "gouraud",
            ShadingMode::Phong => "phong",
            ShadingMode::Exact => "exact",
        }
    }
}

/// Takes the profile of `scene`, which is drawn once for each mode.
///
/// The samples are at most a quarter of a pixel apart (a pixel, on lines beyond 4096) and include the place of every
/// pixel's centre that lies on the line: the longer of its sides runs over multiples of a quarter. What is perceived depends on
/// what lies past the line's ends too; there the picture is followed to its edge, past which its last value goes on.
///
/// # Errors
/// A line without length or with an end outside the picture, or no mode.
pub fn profile(renderer: &mut Renderer, scene: &Scene, request: &ProfileQuestion) -> Result<Profile, ProfileError> {
    let line = request.line(scene.image.size)?;
    let per_degree = request.viewing.pixels_per_degree();
    let widths = request.perception.widths(per_degree);
    let mut profile = Profile {
        samples: line.samples(),
        traces: Vec::new(),
        borders: Vec::new(),
        length: request.from.distance(request.to),
        widths,
    };
    for &mode in &request.modes {
        let mut drawn = scene.clone();
        drawn.shading.mode = mode;
        let source = Source::new(renderer, &drawn, &line);
        if profile.borders.is_empty() {
            profile.borders = borders(&source, &line);
        }
        profile.traces.push(trace(&source, &line, request, &profile.borders, per_degree));
    }
    for trace in &mut profile.traces {
        trace.corners.resize(profile.borders.len(), None);
    }
    Ok(profile)
}

fn trace(source: &Source<'_>, line: &Line, request: &ProfileQuestion, borders: &[Border], per_degree: f64) -> Trace {
    let (intensity, slope): (Vec<f64>, Vec<f64>) = source.values(line).into_iter().unzip();
    let blur = |values: &[f64], sigma: f64| blur_line(values, sigma / line.spacing());
    let perceived = request.perception.respond(&intensity, per_degree, &blur);
    let (ends, corners) = (source.at_ends(line), corners(source, line, borders));
    Trace {
        mode: source.mode(),
        intensity: line.within(&intensity, ends.map(|end| Some(end.0))),
        slope: line.within(&slope, ends.map(|end| Some(end.1))),
        perceived: line.within(&perceived, [None; 2]),
        corners,
    }
}

/// The borders on the line itself.
fn borders(source: &Source<'_>, line: &Line) -> Vec<Border> {
    let border = |s: f64, faces| {
        let (place, t) = (line.place(s), line.t(s));
        (0.0..=1.0).contains(&t).then_some(Border { x: place.x, y: place.y, t, faces })
    };
    let face = |piece: Option<&Piece>| piece.map(|piece| piece.face);
    source.joints().filter_map(|(s, [before, after])| border(s, [face(before), face(after)])).collect()
}

fn corners(source: &Source<'_>, line: &Line, borders: &[Border]) -> Vec<Option<Corner>> {
    let joints = source.joints().filter(|(s, _)| (0.0..=1.0).contains(&line.t(*s)));
    let corner = |(s, sides): (f64, [Option<&Piece>; 2])| {
        let [before, after] = source.sides(line, s, sides);
        let slopes = [before.1, after.1];
        Corner { step: after.0 - before.0, slopes, jump: slopes[1] - slopes[0] }
    };
    let mut corners: Vec<_> = joints.map(|joint| Some(corner(joint))).collect();
    corners.resize(borders.len(), None);
    corners
}
