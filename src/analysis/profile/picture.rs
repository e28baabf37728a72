//! A profile over its own picture: the line, ticks at the edges between polygons, and the intensity as a curve above
//! the line. Also a picture of the perceived brightness.

use super::{Profile, Trace};
use crate::analysis::overlay::{OverlayOptions, Style};
use crate::analysis::perception::{Perception, Viewing, blur_picture, pixel_luminance};
use crate::figure::Shape;
use crate::figure::palette::{readable, shading};
use crate::render::{Frame, Renderer, displayed};
use crate::scene::{Rgb, Scene};
use glam::DVec2;
use tiny_skia::PixmapMut;

/// Maximum width of the surround in pixels for a whole picture: beyond, the time would grow without bound.
pub const PERCEIVED_WIDTH: f64 = 256.0;
/// Height of an intensity of 1 above the line, in the picture's shorter side.
const HEIGHT: f64 = 0.3;
/// Length of a tick to either side of the line, in letters.
const TICK: f64 = 0.3;
/// Minimum distance between ticks, in letters; ticks nearer to each other are left out.
const GAP: f64 = 0.25;
/// Dashes of the perceived response, in widths.
const DASHES: &[f32] = &[3.5, 2.2];

/// A profile laid out over its picture, pixels.
#[derive(Clone, Debug, PartialEq)]
pub struct ProfileCurves {
    /// Ends of the line.
    pub ends: [DVec2; 2],
    /// Ticks at the edges between polygons, each from one side of the line to the other.
    pub ticks: Vec<[DVec2; 2]>,
    /// The intensity, above the line.
    pub intensity: Vec<DVec2>,
    /// The perceived brightness.
    pub perceived: Vec<DVec2>,
}

/// Lays out the profile of one mode over a picture with a shorter side of `side` and letters of `em` pixels. The curves
/// are above the line in either direction; an intensity of 1 is three tenths of the shorter side.
pub fn lay_out_profile(
    profile: &Profile,
    trace: &Trace,
    side: f64,
    em: f64,
) -> Option<ProfileCurves> {
    let ends =
        [profile.samples.first()?, profile.samples.last()?].map(|end| DVec2::new(end.x, end.y));
    let along = (ends[1] - ends[0]).normalize_or(DVec2::X);
    // Above the line in either direction of travel.
    let across = if along.x < 0.0 {
        along.perp()
    } else {
        -along.perp()
    };
    let curve = |values: &[f64]| -> Vec<DVec2> {
        let places = profile.samples.iter().zip(values);
        places
            .map(|(at, value)| DVec2::new(at.x, at.y) + across * (value * HEIGHT * side))
            .collect()
    };
    let (mut ticks, mut latest) = (Vec::new(), f64::NEG_INFINITY);
    let borders = profile.borders.iter();
    for border in borders.filter(|border| border.faces[0] != border.faces[1]) {
        let s = border.t * profile.length;
        if s - latest >= GAP * em {
            latest = s;
            let (at, reach) = (DVec2::new(border.x, border.y), across * (TICK * em));
            ticks.push([at - reach, at + reach]);
        }
    }
    Some(ProfileCurves {
        ends,
        ticks,
        intensity: curve(&trace.intensity),
        perceived: curve(&trace.perceived),
    })
}

/// Draws the profile of one mode over its picture: the intensity in the mode's colour, the perceived brightness dashed.
pub fn draw_profile(
    pixmap: &mut PixmapMut<'_>,
    profile: &Profile,
    trace: &Trace,
    options: &OverlayOptions,
) {
    let side = f64::from(pixmap.width().min(pixmap.height()));
    let style = Style::new(side, options);
    let Some(ProfileCurves {
        ends,
        ticks,
        intensity,
        perceived,
    }) = lay_out_profile(profile, trace, side, style.text)
    else {
        return;
    };
    let colour = readable(shading(trace.mode), style.halo_colour, 3.0);
    let thin = |points: Vec<DVec2>| Shape::line(points, 0.7 * style.line, style.neutral);
    let mut marks = vec![thin(ends.to_vec())];
    marks.extend(ticks.iter().map(|tick| thin(tick.to_vec())));
    marks.extend(ends.map(|end| Shape::disc(end, 1.6 * style.line, style.neutral)));
    marks.push(Shape::line(intensity, style.line, colour));
    let seen = thin(perceived).dashed(DASHES);
    // Drawn below, so that it shows where it departs.
    style.drawing(vec![seen]).draw(pixmap);
    style.drawing(marks).draw(pixmap);
}

/// Computes a picture of the response: each pixel's colour times the ratio of the response to its luminance. Black
/// pixels become grey, negative values black, and the last pixels continue beyond the edge.
pub fn perceived_picture(
    renderer: &mut Renderer,
    scene: &Scene,
    viewing: &Viewing,
    perception: &Perception,
) -> Frame {
    let width = scene.image.size[0] as usize;
    let mut linear = renderer.linear_picture(scene);
    let intensity: Vec<f64> = linear.iter().map(pixel_luminance).collect();
    let blur = |values: &[f64], sigma: f64| blur_picture(values, width, sigma);
    let response = perception.respond(&intensity, viewing.pixels_per_degree(), &blur);
    for ((pixel, intensity), response) in linear.iter_mut().zip(&intensity).zip(&response) {
        let response = response.max(0.0);
        let [r, g, b, _] = pixel.map(f64::from);
        let seen = if *intensity > 0.0 {
            Rgb::new(r, g, b) * (response / intensity)
        } else {
            Rgb::splat(response)
        };
        pixel[..3].copy_from_slice(&seen.as_vec3().to_array());
    }
    displayed(&linear, scene)
}
