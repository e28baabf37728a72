//! Two pictures of one scene against each other, and what stands out in one.

mod difference;
mod regions;
mod report;
mod sheet;

pub use difference::{difference_picture, difference_scale};
pub use regions::{RegionErrors, region_errors};
pub use report::{Comparison, ComparisonQuestion};
pub use sheet::{DrawnPane, PaneArea, caption, comparison_sheet, draw_panes, pane_areas, pane_figures, panes_on_sheet};

use super::luminance;
use crate::scene::Rgb;
use rayon::prelude::*;
use serde::Serialize;

/// Pixels in a share of the work.
const CHUNK: usize = 1 << 14;

/// A picture before the display: linear red, green, blue and the part of each pixel that shows the object, row by row.
#[derive(Clone, Copy, Debug)]
pub struct LinearPicture<'a> {
    pub width: u32,
    pub pixels: &'a [[f32; 4]],
    /// Whether the display clamps at 1: differences above are then not seen, and not counted.
    pub clamps: bool,
}

impl LinearPicture<'_> {
    pub(crate) fn color(&self, index: usize) -> [f64; 3] {
        let [r, g, b, _] = self.pixels[index].map(f64::from);
        if self.clamps { [r, g, b].map(|value| value.min(1.0)) } else { [r, g, b] }
    }

    fn at(&self, index: usize) -> [u32; 2] {
        let (index, width) = (index as u64, u64::from(self.width.max(1)));
        #[expect(clippy::cast_possible_truncation, reason = "sides of pictures are 32 bits")]
        [(index % width) as u32, (index / width) as u32]
    }
}

/// How far one picture is from another, in linear intensity (1 is white; 1/255 is a code value of the raw encoding), over
/// the pixels that show the object in either.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct ErrorFigures {
    /// Pixels compared.
    pub pixels: u64,
    /// Mean of |d| over pixels and channels.
    pub mean: f64,
    /// Root of the mean of d².
    pub rms: f64,
    /// Greatest |d| of any channel.
    pub greatest: f64,
    /// The first pixel that has it; nothing where nothing differs.
    pub at: Option<[u32; 2]>,
}

/// Sums over a part of the picture.
#[derive(Clone, Copy, Default)]
struct Sums {
    pixels: u64,
    absolute: f64,
    squares: f64,
    greatest: f64,
    index: usize,
}

impl Sums {
    fn and(self, later: Self) -> Self {
        let (greatest, index) =
            if later.greatest > self.greatest { (later.greatest, later.index) } else { (self.greatest, self.index) };
        Self {
            pixels: self.pixels + later.pixels,
            absolute: self.absolute + later.absolute,
            squares: self.squares + later.squares,
            greatest,
            index,
        }
    }
}

/// The error of `picture` against `reference`, which is as large.
pub fn error_figures(picture: LinearPicture<'_>, reference: LinearPicture<'_>) -> ErrorFigures {
    let seen = |index: usize| picture.pixels[index][3] != 0.0 || reference.pixels[index][3] != 0.0;
    error_figures_where(picture, reference, seen)
}

/// The same over the pixels that `counts`.
fn error_figures_where(
    picture: LinearPicture<'_>,
    reference: LinearPicture<'_>,
    counts: impl Fn(usize) -> bool + Sync,
) -> ErrorFigures {
    let count = picture.pixels.len().min(reference.pixels.len());
    let parts: Vec<Sums> = (0..count.div_ceil(CHUNK))
        .into_par_iter()
        .map(|chunk| sums(picture, reference, (chunk * CHUNK..count.min((chunk + 1) * CHUNK)).filter(|i| counts(*i))))
        .collect();
    // Added up in the picture's order, so that the number of threads does not matter.
    let total = parts.into_iter().fold(Sums::default(), Sums::and);
    #[expect(clippy::cast_precision_loss, reason = "pictures have far fewer than 2⁵³ pixels")]
    let values = (3 * total.pixels).max(1) as f64;
    ErrorFigures {
        pixels: total.pixels,
        mean: total.absolute / values,
        rms: (total.squares / values).sqrt(),
        greatest: total.greatest,
        at: (total.greatest > 0.0).then(|| picture.at(total.index)),
    }
}

fn sums(picture: LinearPicture<'_>, reference: LinearPicture<'_>, pixels: impl Iterator<Item = usize>) -> Sums {
    let mut sums = Sums::default();
    for index in pixels {
        sums.pixels += 1;
        for (a, b) in picture.color(index).into_iter().zip(reference.color(index)) {
            let difference = (a - b).abs();
            sums.absolute += difference;
            sums.squares += difference * difference;
            if difference > sums.greatest {
                (sums.greatest, sums.index) = (difference, index);
            }
        }
    }
    sums
}

/// The brightest pixel of the object.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Brightest {
    /// Its luminance (Rec. 709), linear and not clamped.
    pub value: f64,
    pub at: [u32; 2],
}

/// The brightest pixel that shows the object, the first of equal ones.
pub fn brightest(picture: LinearPicture<'_>) -> Option<Brightest> {
    let of_chunk = |(chunk, pixels): (usize, &[[f32; 4]])| {
        let mut best: Option<(f64, usize)> = None;
        for (index, [r, g, b, seen]) in pixels.iter().enumerate() {
            let value = luminance(Rgb::new((*r).into(), (*g).into(), (*b).into()));
            if *seen > 0.0 && best.is_none_or(|(most, _)| value > most) {
                best = Some((value, chunk * CHUNK + index));
            }
        }
        best
    };
    let brighter = |a: (f64, usize), b: (f64, usize)| if b.0 > a.0 || (b.0 == a.0 && b.1 < a.1) { b } else { a };
    let best = picture.pixels.par_chunks(CHUNK).enumerate().filter_map(of_chunk).reduce_with(brighter);
    best.map(|(value, index)| Brightest { value, at: picture.at(index) })
}

/// What a caption says of a pane.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PaneFigures {
    pub name: String,
    pub brightest: Option<Brightest>,
    /// Against the last pane; the last pane has none.
    pub error: Option<ErrorFigures>,
}
