//! A profile over its own picture: the line, ticks where polygons meet, and the intensity as a curve above the line.

use super::{OverlayOptions, Style};
use crate::analysis::{Profile, Trace};
use crate::figure::ink::{Ink, Mark};
use crate::figure::palette::{Rgb8, readable};
use glam::DVec2;
use tiny_skia::PixmapMut;

/// Height of an intensity of 1 above the line, in the picture's shorter side.
const HEIGHT: f64 = 0.3;
/// Length of a tick to either side of the line, in letters.
const TICK: f64 = 0.3;
/// Ticks nearer to each other than this are left out, in letters.
const GAP: f64 = 0.25;
/// Of the perceived response, in widths.
const DASHES: &[f32] = &[3.5, 2.2];
/// The curve's colour, before it is fitted to its halo.
const CURVE: Rgb8 = [0xF0, 0xA0, 0x20];

/// Draws the profile of one mode over its picture on `pixmap`: what is there solid, what is perceived dashed. The curve stands
/// on the line's left as one goes along it from right to left, so that it is above a level line; 1 is three tenths of the
/// picture's shorter side.
pub fn draw_profile(pixmap: &mut PixmapMut<'_>, profile: &Profile, trace: &Trace, options: &OverlayOptions) {
    let side = f64::from(pixmap.width().min(pixmap.height()));
    let style = Style::new(side, options);
    let (Some(first), Some(last)) = (profile.samples.first(), profile.samples.last()) else { return };
    let ends = [first, last].map(|end| DVec2::new(end.x, end.y));
    let along = (ends[1] - ends[0]).normalize_or(DVec2::X);
    // Above the line whichever way it is gone along.
    let across = if along.x < 0.0 { along.perp() } else { -along.perp() };
    let curve = |values: &[f64]| -> Vec<DVec2> {
        let places = profile.samples.iter().zip(values);
        places.map(|(at, value)| DVec2::new(at.x, at.y) + across * (value * HEIGHT * side)).collect()
    };
    let colour = readable(CURVE, style.halo_colour, 3.0);
    let mut marks = vec![Mark::line(ends.to_vec(), 0.7 * style.line, style.neutral)];
    let mut latest = f64::NEG_INFINITY;
    for border in profile.borders.iter().filter(|border| border.faces[0] != border.faces[1]) {
        let s = border.t * profile.length;
        if s - latest >= GAP * style.text {
            latest = s;
            let at = DVec2::new(border.x, border.y);
            let reach = across * (TICK * style.text);
            marks.push(Mark::line(vec![at - reach, at + reach], 0.7 * style.line, style.neutral));
        }
    }
    marks.extend(ends.map(|end| Mark::dot(end, 1.6 * style.line, style.neutral)));
    marks.push(Mark::line(curve(&trace.intensity), style.line, colour));
    let seen = Mark::line(curve(&trace.perceived), 0.7 * style.line, style.neutral).dashed(DASHES);
    let mut ink = Ink { pixmap, halo: style.halo_colour, breadth: style.halo };
    // Below, so that it shows where it departs.
    ink.marks(&[seen]);
    ink.marks(&marks);
}
