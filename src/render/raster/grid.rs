//! The fixed-point grid of places in a picture, and its bands of rows.

use std::ops::Range;

/// Fractional bits of a place in the picture.
pub const SUBPIXEL_BITS: u32 = 8;
/// One pixel in fixed point.
pub const SUBPIXELS: i32 = 1 << SUBPIXEL_BITS;
/// Half a pixel in fixed point: where a pixel's centre lies.
pub const HALF: i32 = SUBPIXELS / 2;

/// Places reach this many pixels from the picture's corner. With 8 fractional bits they have 23 bits and their products
/// 47, so that `f64` carries the arithmetic of coverage exactly.
pub const GUARD: f64 = 32_000.0;

/// The x of a vertex without a place.
pub const UNPLACED: i32 = i32::MIN;

/// Fixed-point pixel coordinates, y downwards.
pub type Place = [i32; 2];

/// Twice the signed area of a triangle in fixed point; negative where the corners run counter-clockwise on the screen (y
/// downwards), which is how the outside of a closed model appears.
#[inline(always)]
pub fn doubled_area([a, b, c]: [Place; 3]) -> i64 {
    let e1 = [i64::from(b[0]) - i64::from(a[0]), i64::from(b[1]) - i64::from(a[1])];
    let e2 = [i64::from(c[0]) - i64::from(a[0]), i64::from(c[1]) - i64::from(a[1])];
    e1[0] * e2[1] - e1[1] * e2[0]
}

/// The first pixel whose centre is not before `fixed`.
#[inline(always)]
pub fn first_centre(fixed: i32) -> i32 {
    (fixed - HALF + SUBPIXELS - 1) >> SUBPIXEL_BITS
}

/// Rows of a band: its fragments, 16 bytes a pixel, stay in a core's own cache.
pub const BAND: u32 = 16;

/// Where a band lies.
#[derive(Clone, Copy)]
pub struct BandPlace {
    pub first_row: u32,
    pub rows: u32,
    pub width: u32,
}

impl BandPlace {
    pub fn row_range(self) -> Range<i32> {
        self.first_row as i32..(self.first_row + self.rows) as i32
    }
}
