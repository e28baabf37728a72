//! The visual language: one letter, one colour and one line style for each vector, wherever it is drawn.
//!
//! The colours are Okabe and Ito's (2008, "Color Universal Design"), which people with colour blindness can tell
//! apart; the letters and the dashes carry the meaning where colour cannot.

use crate::scene::ShadingMode;
use std::sync::LazyLock;

/// A display colour: red, green, blue, as stored in a picture.
pub type Rgb8 = [u8; 3];

/// The colours of flat, interpolated, Gouraud, Phong and exact shading, from the same palette.
const SHADING: [Rgb8; 5] = [
    [0xD5, 0x5E, 0x00],
    [0xCC, 0x79, 0xA7],
    [0x00, 0x72, 0xB2],
    [0x00, 0x9E, 0x73],
    [0x8A, 0x6D, 0x00],
];

/// Returns the colour of a shading mode.
pub const fn shading(mode: ShadingMode) -> Rgb8 {
    SHADING[mode as usize]
}

/// The share α along an edge or along a scan line, which is no vector: yellow.
pub const ALPHA: Rgb8 = [0xF0, 0xE4, 0x42];
/// The normal of a polygon beside those of vertices: yellow, the colour that no vector has.
pub const FACE: Rgb8 = ALPHA;
/// Dashes of a polygon's normal, in the form of [`Vector::dashes`].
pub const FACE_DASHES: [f32; 2] = [3.0, 1.5];

/// The vectors of the illumination equation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Vector {
    /// The surface's normal: blue.
    N,
    /// The direction to the light: orange.
    L,
    /// L mirrored at N: vermilion.
    R,
    /// The direction to the viewer: bluish green.
    V,
    /// The direction half-way between L and V: reddish purple.
    H,
    /// The transmitted direction: sky blue.
    T,
}

/// The letter, the colour and the dashes of each vector, in the order of [`Vector::ALL`].
const VECTORS: [(&str, Rgb8, &[f32]); 6] = [
    ("N", [0x00, 0x72, 0xB2], &[]),
    ("L", [0xE6, 0x9F, 0x00], &[4.5, 1.5]),
    ("R", [0xD5, 0x5E, 0x00], &[4.5, 1.25, 1.25, 1.25]),
    ("V", [0x00, 0x9E, 0x73], &[1.25, 1.25]),
    ("H", [0xCC, 0x79, 0xA7], &[2.5, 1.5]),
    (
        "T",
        [0x56, 0xB4, 0xE9],
        &[4.5, 1.25, 1.25, 1.25, 1.25, 1.25],
    ),
];

impl Vector {
    /// All vectors, in the order of the legend.
    pub const ALL: [Self; 6] = [Self::N, Self::L, Self::R, Self::V, Self::H, Self::T];

    /// Returns its letter in the textbooks.
    pub const fn letter(self) -> &'static str {
        VECTORS[self as usize].0
    }

    /// Returns its colour, as stored in a picture.
    pub const fn colour(self) -> Rgb8 {
        VECTORS[self as usize].1
    }

    /// Returns the lengths of dashes and gaps, in stroke widths, for a stroke with flat ends; empty is solid.
    pub const fn dashes(self) -> &'static [f32] {
        VECTORS[self as usize].2
    }
}

/// Returns the colour at a share of the way from one colour to another, from 0 to 1.
pub(crate) fn mixed(from: Rgb8, to: Rgb8, share: f64) -> Rgb8 {
    let [from, to] = [from, to].map(|colour| colour.map(f64::from));
    std::array::from_fn(|c| (from[c] + (to[c] - from[c]) * share).round() as u8)
}

/// Returns `colour`, moved towards black or white as far as needed for the contrast `ratio` with `background`.
pub fn readable(colour: Rgb8, background: Rgb8, ratio: f64) -> Rgb8 {
    const STEPS: u32 = 20;
    // The grey at equal contrast from black and white.
    let away = if luminance(background) > 0.18 {
        [0; 3]
    } else {
        [255; 3]
    };
    let towards = |step: u32| mixed(colour, away, f64::from(step) / f64::from(STEPS));
    let stands_out = |candidate: &Rgb8| contrast(*candidate, background) >= ratio;
    (0..=STEPS).map(towards).find(stands_out).unwrap_or(away)
}

/// Returns the contrast ratio as defined by WCAG 2.2, from 1 to 21.
pub fn contrast(a: Rgb8, b: Rgb8) -> f64 {
    let [a, b] = [luminance(a), luminance(b)];
    (a.max(b) + 0.05) / (a.min(b) + 0.05)
}

/// Returns the relative luminance as defined by WCAG 2.2.
fn luminance(colour: Rgb8) -> f64 {
    static LINEAR: LazyLock<[f64; 256]> = LazyLock::new(|| {
        std::array::from_fn(|code| {
            let value = code as f64 / 255.0;
            if value <= 0.04045 {
                value / 12.92
            } else {
                ((value + 0.055) / 1.055).powf(2.4)
            }
        })
    });
    let [r, g, b] = colour.map(|code| LINEAR[usize::from(code)]);
    0.2126 * r + 0.7152 * g + 0.0722 * b
}
