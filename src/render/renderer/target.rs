//! The destinations of colours: the stored pixels, or the linear colours before the display.

use super::display::{Linear, UNDEFINED, is_marked, pack, raw};
use crate::illumination::{BRIGHTEST, LANES, Lanes, Real};
use crate::render::raster::join;
use crate::scene::Encoding;
use fearless_simd::{i32x16, mask32x16, prelude::*};
use std::ops::Range;

/// The lanes of a vector that show the object, and those where the scene's own law is undefined.
#[derive(Clone, Copy)]
pub struct Shown<S: Simd> {
    pub covered: mask32x16<S>,
    pub undefined: u64,
}

/// A destination of colours.
pub trait Target {
    type Pixel: Copy;
    /// The type of such a destination over other pixels.
    type Over<'p>: Target<Pixel = Self::Pixel>;

    /// Returns the destination over other pixels.
    fn over<'p>(&self, pixels: &'p mut [Self::Pixel]) -> Self::Over<'p>;

    /// Returns the pixels, and the value of those that show no object.
    fn pixels(&mut self) -> (&mut [Self::Pixel], Self::Pixel);
    /// Writes one vector's lanes to the pixels from `first` on, at most `count` of them; returns how many overflow or are among the
    /// `undefined`.
    fn put<S: Simd>(
        &mut self,
        simd: S,
        first: usize,
        count: usize,
        color: [Lanes<S>; 3],
        lanes: Shown<S>,
    ) -> u32;
    /// Returns a linear colour in the pixels' format, and whether it overflows or is `undefined`.
    fn ink<S: Simd>(&self, simd: S, color: [f32; 3], undefined: bool) -> (Self::Pixel, bool);

    /// Fills pixels that show no object.
    #[inline(always)]
    fn clear(&mut self, range: Range<usize>) {
        let (pixels, background) = self.pixels();
        pixels[range].fill(background);
    }

    /// Fills pixels with one colour; returns how many overflow.
    #[inline(always)]
    fn fill(&mut self, range: Range<usize>, (ink, overflows): (Self::Pixel, bool)) -> u64 {
        let pixels = &mut self.pixels().0[range];
        pixels.fill(ink);
        if overflows { pixels.len() as u64 } else { 0 }
    }
}

/// Returns a pixel of the object before the display.
#[inline(always)]
fn unstored([r, g, b]: [f32; 3], undefined: bool) -> Linear {
    [r, g, b, if undefined { UNDEFINED } else { 1.0 }]
}

/// The stored pixels of a band.
pub struct Stored<'a> {
    pub pixels: &'a mut [[u8; 4]],
    pub background: [u8; 4],
    pub encoding: Encoding,
}

impl Target for Stored<'_> {
    type Pixel = [u8; 4];
    type Over<'p> = Stored<'p>;

    fn over<'p>(&self, pixels: &'p mut [[u8; 4]]) -> Stored<'p> {
        Stored { pixels, ..*self }
    }

    #[inline(always)]
    fn pixels(&mut self) -> (&mut [[u8; 4]], [u8; 4]) {
        (self.pixels, self.background)
    }

    #[inline(always)]
    fn put<S: Simd>(
        &mut self,
        simd: S,
        first: usize,
        count: usize,
        color: [Lanes<S>; 3],
        Shown { covered, undefined }: Shown<S>,
    ) -> u32 {
        let background = i32x16::simd_from(simd, i32::from_le_bytes(self.background));
        let (packed, over) = pack(simd, color, covered, background, self.encoding);
        let over = over | (undefined & covered.to_bitmask());
        let bytes = self.pixels[first..first + count].as_flattened_mut();
        if count == LANES {
            packed.store_slice(bytes);
            over.count_ones()
        } else {
            bytes.copy_from_slice(&packed.as_slice()[..4 * count]);
            (over & ((1 << count) - 1)).count_ones()
        }
    }

    #[inline(always)]
    fn ink<S: Simd>(&self, simd: S, color: [f32; 3], undefined: bool) -> ([u8; 4], bool) {
        if self.encoding == Encoding::Raw {
            let marked = is_marked(unstored(color, undefined));
            return (raw(simd, color), marked);
        }
        let mut pixel = [[0; 4]];
        let mut one = Stored {
            pixels: &mut pixel,
            ..*self
        };
        let lanes = Shown {
            covered: mask32x16::from_bitmask(simd, 1),
            undefined: u64::from(undefined),
        };
        let [r, g, b] = color;
        let color = [
            Lanes::splat(simd, r),
            Lanes::splat(simd, g),
            Lanes::splat(simd, b),
        ];
        let overflows = one.put(simd, 0, 1, color, lanes) > 0;
        (pixel[0], overflows)
    }
}

/// The linear colours of a band.
pub struct Unstored<'a> {
    pub pixels: &'a mut [Linear],
    pub background: Linear,
}

impl Target for Unstored<'_> {
    type Pixel = Linear;
    type Over<'p> = Unstored<'p>;

    fn over<'p>(&self, pixels: &'p mut [Linear]) -> Unstored<'p> {
        Unstored { pixels, ..*self }
    }

    #[inline(always)]
    fn pixels(&mut self) -> (&mut [Linear], Linear) {
        (self.pixels, self.background)
    }

    #[inline(always)]
    fn put<S: Simd>(
        &mut self,
        simd: S,
        first: usize,
        count: usize,
        color: [Lanes<S>; 3],
        Shown { covered, undefined }: Shown<S>,
    ) -> u32 {
        let one = Lanes::splat(simd, 1.0);
        let [red, green, blue, _] = self.background;
        let brightest = one.constant(BRIGHTEST as f32);
        let [r, g, b] = [
            color[0].min(brightest),
            color[1].min(brightest),
            color[2].min(brightest),
        ];
        let over = r.max(g).max(b).greater_than(one).to_bitmask() | undefined;
        let over = over & covered.to_bitmask() & (u64::MAX >> (64 - count));
        let undefined = one.mask_of_bits(undefined);
        let planes = [
            Lanes::select(covered, r, one.constant(red)),
            Lanes::select(covered, g, one.constant(green)),
            Lanes::select(covered, b, one.constant(blue)),
            Lanes::select(
                covered,
                Lanes::select(undefined, one.constant(UNDEFINED), one),
                one.constant(0.0),
            ),
        ];
        let pixels = &mut self.pixels[first..first + count];
        if count == LANES {
            join(simd, &planes, pixels);
        } else {
            let mut whole = [self.background; LANES];
            join(simd, &planes, &mut whole);
            pixels.copy_from_slice(&whole[..count]);
        }
        over.count_ones()
    }

    #[inline(always)]
    fn ink<S: Simd>(&self, _: S, color: [f32; 3], undefined: bool) -> (Linear, bool) {
        let pixel = unstored(color, undefined);
        (pixel, is_marked(pixel))
    }
}
