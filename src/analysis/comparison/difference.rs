//! The difference of two pictures as a picture, with the scale that says what its colours mean.

use crate::analysis::{LinearPicture, luminance};
use crate::figure::palette::{self, Rgb8};
use crate::figure::{Area, Drawing, Shape, Text};
use crate::render::Frame;
use crate::scene::{DifferenceKind, Rgb};
use glam::DVec2;
use rayon::prelude::*;

/// Where neither picture shows the object.
const OUTSIDE: Rgb8 = [0x26, 0x27, 0x2B];
/// No difference, where the scale has two sides.
const NONE: Rgb8 = [0xF4, 0xF4, 0xF2];
/// Ten even steps of cividis, which eyes with and without colour-blindness read alike (Nuñez, Anderton and Renslow 2018).
const CIVIDIS: [Rgb8; 10] = [
    [0x00, 0x20, 0x4D],
    [0x00, 0x33, 0x6F],
    [0x39, 0x48, 0x6B],
    [0x57, 0x5C, 0x6D],
    [0x70, 0x71, 0x73],
    [0x8A, 0x87, 0x79],
    [0xA6, 0x9D, 0x75],
    [0xC4, 0xB5, 0x6C],
    [0xE4, 0xCF, 0x5B],
    [0xFF, 0xEA, 0x46],
];
/// Colours along the drawn scale.
const STEPS: u32 = 128;

/// `picture` less `reference`, times `gain`, in the colours of `kind`. Both are linear and as large as each other.
pub fn difference_picture(
    picture: LinearPicture<'_>,
    reference: LinearPicture<'_>,
    kind: DifferenceKind,
    gain: f64,
) -> Frame {
    let width = picture.width.max(1);
    let seen = |index: usize| picture.pixels[index][3] > 0.0 || reference.pixels[index][3] > 0.0;
    let pixel = |index: usize| {
        let [r, g, b] = if seen(index) {
            let (a, b) = (picture.color(index), reference.color(index));
            colour(kind, std::array::from_fn(|channel| gain * (a[channel] - b[channel])))
        } else {
            OUTSIDE
        };
        [r, g, b, 255]
    };
    let count = picture.pixels.len().min(reference.pixels.len());
    let pixels: Vec<[u8; 4]> = (0..count).into_par_iter().map(pixel).collect();
    #[expect(clippy::cast_possible_truncation, reason = "sides of pictures are 32 bits")]
    let height = (count as u64 / u64::from(width)) as u32;
    Frame { width, height, pixels }
}

/// The colour of a difference of each channel, gain included.
fn colour(kind: DifferenceKind, difference: [f64; 3]) -> Rgb8 {
    match kind {
        DifferenceKind::Signed => signed(luminance(Rgb::from_array(difference))),
        DifferenceKind::Absolute => difference.map(|channel| code(255.0 * channel.abs())),
        DifferenceKind::FalseColor => cividis(difference.iter().fold(0.0, |most, channel| channel.abs().max(most))),
    }
}

/// From blue at −1 to orange at 1.
fn signed(share: f64) -> Rgb8 {
    let end = if share < 0.0 { palette::N } else { palette::L };
    mixed(NONE, end, share.abs())
}

fn cividis(share: f64) -> Rgb8 {
    let steps = (CIVIDIS.len() - 1) as f64;
    let place = (share.clamp(0.0, 1.0) * steps).min(steps - 1e-9);
    let index = place as usize;
    mixed(CIVIDIS[index], CIVIDIS[index + 1], place - index as f64)
}

fn mixed(from: Rgb8, to: Rgb8, share: f64) -> Rgb8 {
    let share = share.clamp(0.0, 1.0);
    std::array::from_fn(|c| code(f64::from(from[c]) + (f64::from(to[c]) - f64::from(from[c])) * share))
}

fn code(value: f64) -> u8 {
    value.round().clamp(0.0, 255.0) as u8
}

/// The scale of a difference picture at its lower right: its colours, and the differences that they stand for. `em` is the
/// size of the letters in pixels. Where the picture has no room for it, it is empty.
pub fn difference_scale(size: [u32; 2], kind: DifferenceKind, gain: f64, em: f64) -> Drawing {
    let size = DVec2::from_array(size.map(f64::from));
    let mut drawing = Drawing::over_picture([0x10; 3], 0.12 * em);
    let (length, breadth) = ((14.0 * em).min(0.6 * size.x), 0.8 * em);
    let corner = size - DVec2::new(length + 2.6 * em, breadth + 2.2 * em);
    if corner.min_element() < 0.0 || length < 8.0 * em {
        return drawing;
    }
    let two_sided = kind == DifferenceKind::Signed;
    let step = length / f64::from(STEPS);
    let bar = (0..STEPS).map(|i| {
        let share = (f64::from(i) + 0.5) / f64::from(STEPS);
        let value = if two_sided { 2.0 * share - 1.0 } else { share };
        let (x0, x1) = (corner.x + f64::from(i) * step, corner.x + f64::from(i + 1) * step + 0.5);
        let (min, max) = (DVec2::new(x0, corner.y), DVec2::new(x1.min(corner.x + length), corner.y + breadth));
        Shape::area(Area { min, max }.corners(), colour(kind, [value; 3])).plain()
    });
    drawing.shapes.extend(bar);
    let whole = Area { min: corner, max: corner + DVec2::new(length, breadth) };
    drawing.shapes.push(Shape::outline(whole.corners(), 0.08 * em, [255; 3]));
    let least = if two_sided { -1.0 } else { 0.0 };
    for value in [least, 0.5 * (least + 1.0), 1.0] {
        let x = corner.x + length * (value - least) / (1.0 - least);
        let at = DVec2::new(x, corner.y + breadth + 1.1 * em);
        let text = Text::new(tick(value / gain, two_sided), at, em, [255; 3]).aligned(0.5);
        drawing.texts.push(Text { halo: drawing.breadth, ..text });
    }
    drawing
}

/// A difference as the scale letters it.
fn tick(value: f64, signed: bool) -> String {
    let digits = if value == 0.0 {
        "0".to_owned()
    } else {
        let text = format!("{:.4}", value.abs());
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    };
    match (signed, value) {
        (true, v) if v > 0.0 => format!("+{digits}"),
        (true, v) if v < 0.0 => format!("−{digits}"),
        _ => digits,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_scale_of_colours_grows_lighter_all_the_way() {
        let light = |share: f64| palette::contrast(cividis(share), [0; 3]);
        for step in 0..100 {
            let share = f64::from(step) / 100.0;
            assert!(light(share + 0.01) > light(share), "{share}");
        }
    }

    #[test]
    fn ticks_are_short() {
        let ticks = [-0.125, 0.0, 0.125, 1.0].map(|value| tick(value, true));
        assert_eq!(ticks, ["−0.125", "0", "+0.125", "+1"]);
        assert_eq!(tick(1.0 / 64.0, false), "0.0156");
    }
}
