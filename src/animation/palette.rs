//! The colours of a GIF's frame: at most 256, each frame its own.
//!
//! The colours of a shaded picture lie on a few curves and sheets in the cube of all colours. The box about them is halved, and
//! halved again wherever a box is widest, until there are as many boxes as a palette has colours; a pixel gets the mean of its
//! box. So no pixel is off by more than the widest box that is left, and a colour that few pixels have is not forgotten.

use std::collections::HashMap;
use std::ops::Range;

/// Most colours of a palette.
const MOST: usize = 256;

/// A colour, and how many pixels have it.
type Counted = ([u8; 3], u64);

/// Returns a palette, red, green and blue of each colour, and each pixel's number in it. Where a picture has at most 256 colours
/// these are they.
pub fn indexed(pixels: &[[u8; 4]]) -> (Vec<u8>, Vec<u8>) {
    let mut counts = HashMap::new();
    for [r, g, b, _] in pixels {
        *counts.entry([*r, *g, *b]).or_insert(0) += 1;
    }
    let mut colours: Vec<Counted> = counts.into_iter().collect();
    // In an order that does not depend on the table's.
    colours.sort_unstable();
    let (mut palette, mut numbers) = (Vec::new(), HashMap::new());
    for (range, number) in boxes(&mut colours).into_iter().zip(0_u8..=255) {
        palette.extend(mean(&colours[range.clone()]));
        numbers.extend(colours[range].iter().map(|(colour, _)| (*colour, number)));
    }
    let number = |[r, g, b, _]: &[u8; 4]| numbers.get(&[*r, *g, *b]).copied().unwrap_or_default();
    let numbers = pixels.iter().map(number).collect();
    (palette, numbers)
}

/// Sorts colours into boxes.
fn boxes(colours: &mut [Counted]) -> Vec<Range<usize>> {
    let whole = 0..colours.len();
    let mut boxes = vec![(widest(colours), whole)];
    while boxes.len() < MOST {
        let place = (0..boxes.len()).max_by_key(|place| boxes[*place].0.width);
        let place = place.unwrap_or_default();
        let (
            Side {
                axis,
                width,
                middle,
            },
            range,
        ) = boxes[place].clone();
        if width == 0 {
            break;
        }
        let inside = &mut colours[range.clone()];
        inside.sort_unstable_by_key(|(colour, _)| colour[axis]);
        let cut = inside.partition_point(|(colour, _)| colour[axis] <= middle);
        let [low, high] = [range.start..range.start + cut, range.start + cut..range.end];
        boxes[place] = (widest(&colours[low.clone()]), low);
        boxes.push((widest(&colours[high.clone()]), high));
    }
    boxes.into_iter().map(|(_, range)| range).collect()
}

/// A side of a box of colours.
#[derive(Clone, Copy, Default)]
struct Side {
    /// The channel.
    axis: usize,
    /// From the least value to the greatest.
    width: u8,
    /// Half-way between them, rounded down.
    middle: u8,
}

/// Returns the longest side of the box about colours.
fn widest(colours: &[Counted]) -> Side {
    let side = |axis: usize| {
        let (low, high) = colours
            .iter()
            .fold((u8::MAX, 0), |(low, high), (colour, _)| {
                (low.min(colour[axis]), high.max(colour[axis]))
            });
        let width = high.saturating_sub(low);
        let middle = low.saturating_add(width / 2);
        Side {
            axis,
            width,
            middle,
        }
    };
    let sides = (0..3).map(side);
    sides.max_by_key(|side| side.width).unwrap_or_default()
}

/// The mean of the pixels' colours.
fn mean(colours: &[Counted]) -> [u8; 3] {
    let count: u64 = colours.iter().map(|(_, count)| count).sum();
    std::array::from_fn(|channel| {
        let sum: u64 = colours
            .iter()
            .map(|(colour, count)| u64::from(colour[channel]) * count)
            .sum();
        u8::try_from((sum + count / 2) / count.max(1)).unwrap_or(u8::MAX)
    })
}
