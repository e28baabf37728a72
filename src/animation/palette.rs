//! Palettes for the frames of a GIF: at most 256 colours, different for each frame. The box around all colours is
//! halved, and the widest box again and again; a pixel gets the mean of its box. So no pixel's error exceeds the widest
//! remaining box, and a rare colour is not lost.

use std::collections::HashMap;
use std::ops::Range;

/// Maximum number of colours in a palette.
const MOST: usize = 256;

/// A colour with the number of its pixels.
type Counted = ([u8; 3], u64);

/// Returns a palette, red, green and blue of each colour, and each pixel's index; up to 256 colours stay exact.
pub fn indexed(pixels: &[[u8; 4]]) -> (Vec<u8>, Vec<u8>) {
    let mut counts = HashMap::new();
    for [r, g, b, _] in pixels {
        *counts.entry([*r, *g, *b]).or_insert(0) += 1;
    }
    let mut colours: Vec<Counted> = counts.into_iter().collect();
    // An order that does not depend on the hash table's.
    colours.sort_unstable();
    let (mut palette, mut numbers) = (Vec::new(), HashMap::new());
    for (range, number) in boxes(&mut colours).into_iter().zip(0_u8..=255) {
        palette.extend(mean(&colours[range.clone()]));
        numbers.extend(colours[range].iter().map(|(colour, _)| (*colour, number)));
    }
    let number = |[r, g, b, _]: &[u8; 4]| numbers.get(&[*r, *g, *b]).copied().unwrap_or_default();
    (palette, pixels.iter().map(number).collect())
}

/// Sorts colours into boxes.
fn boxes(colours: &mut [Counted]) -> Vec<Range<usize>> {
    let mut boxes = vec![(widest(colours), 0..colours.len())];
    while boxes.len() < MOST {
        let place = (0..boxes.len())
            .max_by_key(|place| boxes[*place].0.width)
            .unwrap_or_default();
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
    /// Difference between the maximum and the minimum.
    width: u8,
    /// Mean of the minimum and the maximum, rounded down.
    middle: u8,
}

/// Returns the longest side of the box about colours.
fn widest(colours: &[Counted]) -> Side {
    let side = |axis: usize| {
        let range = |(low, high): (u8, u8), (colour, _): &Counted| {
            (low.min(colour[axis]), high.max(colour[axis]))
        };
        let (low, high) = colours.iter().fold((u8::MAX, 0), range);
        let width = high.saturating_sub(low);
        Side {
            axis,
            width,
            middle: low.saturating_add(width / 2),
        }
    };
    (0..3)
        .map(side)
        .max_by_key(|side| side.width)
        .unwrap_or_default()
}

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
