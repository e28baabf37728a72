//! Shades a band's fragments: the equation at each pixel, or the interpolated intensities.

use super::display::{Linear, WIDEST, pack, raw};
use crate::illumination::{BRIGHTEST, Equation, Lanes, Reached, Real, Specular, V3};
use crate::render::lens::{FARTHEST, Lens};
use crate::render::raster::{BandPlace, Block, SHORTEST_NORMAL, join};
use crate::render::rays::Visibility;
use crate::scene::Encoding;
use fearless_simd::prelude::*;
use glam::{DVec2, DVec3};
use std::marker::PhantomData;
use std::ops::Range;

/// The square of [`SHORTEST_NORMAL`].
const SHORTEST_SQUARED: f32 = (SHORTEST_NORMAL * SHORTEST_NORMAL) as f32;

/// Colours of pixels from their fragments.
pub trait Colour {
    /// Readies a row: `y` is the pixel row.
    #[inline(always)]
    fn row(&mut self, _y: u32) {}

    /// Red, green, blue at the pixels from `column` on, given the three carried numbers and the depth key.
    fn at<S: Simd>(&mut self, simd: S, column: usize, carried: [Lanes<S>; 3], key: Lanes<S>) -> [Lanes<S>; 3];
}

/// The carried numbers are intensities.
#[derive(Clone, Copy)]
pub struct Carried {
    /// They were multiplied by the depth key.
    pub by_key: bool,
}

impl Colour for Carried {
    #[inline(always)]
    fn at<S: Simd>(&mut self, simd: S, _: usize, carried: [Lanes<S>; 3], key: Lanes<S>) -> [Lanes<S>; 3] {
        // Rounding may leave nothing of the key of what is far beside what is near.
        let least = Lanes::splat(simd, (1.0 / FARTHEST) as f32);
        let factor = if self.by_key { Lanes::splat(simd, 1.0) / key.max(least) } else { Lanes::splat(simd, 1.0) };
        let [r, g, b] = carried;
        [r * factor, g * factor, b * factor]
    }
}

/// The carried numbers are normals, and the equation is evaluated.
#[derive(Clone, Copy)]
pub struct Evaluated<'a, F> {
    equation: &'a Equation<f32>,
    rays: Rays,
    by_key: bool,
    renormalise: bool,
    form: PhantomData<F>,
    visibility: Option<&'a Visibility>,
    /// The bits of the present row.
    reached: Option<Reached<'a>>,
}

impl<'a, F: Specular> Evaluated<'a, F> {
    pub fn new(
        equation: &'a Equation<f32>,
        lens: &Lens,
        by_key: bool,
        renormalise: bool,
        visibility: Option<&'a Visibility>,
    ) -> Self {
        Self { equation, rays: Rays::new(lens), by_key, renormalise, form: PhantomData, visibility, reached: None }
    }
}

/// The rays of a picture's pixels, in camera distances relative to the eye.
#[derive(Clone, Copy)]
struct Rays {
    lens: Lens,
    perspective: bool,
    /// Change of the ray to the next pixel on the right.
    step: [f32; 3],
    /// Through column 0 of the present row.
    start: [f32; 3],
    forward: [f32; 3],
    least_key: f32,
}

impl Rays {
    fn new(lens: &Lens) -> Self {
        let step = within_reach(lens.right / lens.focal);
        let (forward, least_key) = (lens.forward.as_vec3().to_array(), lens.least_key() as f32);
        Self { lens: *lens, perspective: lens.perspective, step, start: [0.0; 3], forward, least_key }
    }

    #[inline(always)]
    fn row(&mut self, y: u32) {
        let (point, direction) = self.lens.ray(DVec2::new(0.5, f64::from(y) + 0.5));
        self.start = within_reach(if self.perspective { direction } else { point });
    }

    /// The points that pixels in columns `x` see at depth key `key`.
    #[inline(always)]
    fn positions<S: Simd>(&self, simd: S, x: Lanes<S>, key: Lanes<S>) -> V3<Lanes<S>> {
        let step = V3::constant(x, self.step);
        let across = step.scale_add(x, V3::constant(x, self.start));
        if self.perspective {
            across.scale(Lanes::splat(simd, 1.0) / key)
        } else {
            V3::constant(x, self.forward).scale_add(-key, across)
        }
    }
}

/// In single precision, no component greater than the farthest distance.
fn within_reach(v: DVec3) -> [f32; 3] {
    v.clamp(DVec3::splat(-FARTHEST), DVec3::splat(FARTHEST)).as_vec3().to_array()
}

impl<F: Specular> Colour for Evaluated<'_, F> {
    #[inline(always)]
    fn row(&mut self, y: u32) {
        self.rays.row(y);
        self.reached = self.visibility.and_then(|bits| bits.at(y as usize, 0));
    }

    #[inline(always)]
    fn at<S: Simd>(&mut self, simd: S, column: usize, carried: [Lanes<S>; 3], key: Lanes<S>) -> [Lanes<S>; 3] {
        let key = key.max(Lanes::splat(simd, self.rays.least_key));
        let [nx, ny, nz] = carried;
        let normal = V3::new(nx, ny, nz);
        let normal = if self.renormalise {
            let shortest = Lanes::splat(simd, SHORTEST_SQUARED);
            normal.normalised_from(if self.by_key { key * key * shortest } else { shortest })
        } else if self.by_key {
            normal.scale(Lanes::splat(simd, 1.0) / key)
        } else {
            normal
        };
        let x = Lanes::count_up(simd) + Lanes::splat(simd, column as f32);
        let point = self.equation.site(self.rays.positions(simd, x, key), normal);
        let reached = self.reached.map(
            #[inline(always)]
            |reached| reached.starting_at(column),
        );
        self.equation.illuminate::<Lanes<S>, F>(&point, reached)
    }
}

/// Where colours go.
pub trait Target {
    type Pixel: Copy;

    /// Writes one vector's lanes to the pixels from `first` on, at most `count` of them; returns how many overflow.
    fn put<S: Simd>(&mut self, simd: S, first: usize, count: usize, color: [Lanes<S>; 3], covered: S::mask32s) -> u32;
    /// Fills pixels that see no object.
    fn clear(&mut self, range: Range<usize>);
    /// A linear colour as pixels hold it.
    fn ink<S: Simd>(&self, simd: S, color: [f32; 3]) -> Ink<Self::Pixel>;
    /// Fills pixels with one colour; returns how many overflow.
    fn fill(&mut self, range: Range<usize>, ink: Ink<Self::Pixel>) -> u64;
}

/// A colour for many pixels.
#[derive(Clone, Copy)]
pub struct Ink<P> {
    pixel: P,
    overflows: bool,
}

impl<P: Copy> Ink<P> {
    /// Fills pixels; returns how many overflow.
    #[inline(always)]
    fn fill(self, pixels: &mut [P]) -> u64 {
        pixels.fill(self.pixel);
        if self.overflows { pixels.len() as u64 } else { 0 }
    }
}

#[inline(always)]
fn overflows(color: [f32; 3]) -> bool {
    color.iter().any(|&v| v > 1.0)
}

/// Stored pixels of a band.
pub struct Stored<'a> {
    pub pixels: &'a mut [[u8; 4]],
    pub background: [u8; 4],
    pub encoding: Encoding,
}

impl Target for Stored<'_> {
    type Pixel = [u8; 4];

    #[inline(always)]
    fn put<S: Simd>(&mut self, simd: S, first: usize, count: usize, color: [Lanes<S>; 3], covered: S::mask32s) -> u32 {
        let background = S::i32s::simd_from(simd, i32::from_le_bytes(self.background));
        let (packed, over) = pack(simd, color, covered, background, self.encoding);
        let bytes = self.pixels[first..first + count].as_flattened_mut();
        if count == Lanes::<S>::LEN {
            packed.store_slice(bytes);
            over.count_ones()
        } else {
            bytes.copy_from_slice(&packed.as_slice()[..4 * count]);
            (over & ((1 << count) - 1)).count_ones()
        }
    }

    #[inline(always)]
    fn clear(&mut self, range: Range<usize>) {
        self.pixels[range].fill(self.background);
    }

    #[inline(always)]
    fn ink<S: Simd>(&self, simd: S, color: [f32; 3]) -> Ink<[u8; 4]> {
        if self.encoding == Encoding::Raw {
            return Ink { pixel: raw(simd, color), overflows: overflows(color) };
        }
        let mut pixel = [[0; 4]];
        let mut one = Stored { pixels: &mut pixel, ..*self };
        let covered = S::mask32s::from_bitmask(simd, 1);
        let [r, g, b] = color;
        let color = [Lanes::splat(simd, r), Lanes::splat(simd, g), Lanes::splat(simd, b)];
        let overflows = one.put(simd, 0, 1, color, covered) > 0;
        Ink { pixel: pixel[0], overflows }
    }

    #[inline(always)]
    fn fill(&mut self, range: Range<usize>, ink: Ink<[u8; 4]>) -> u64 {
        ink.fill(&mut self.pixels[range])
    }
}

/// Linear colours of a band.
pub struct Unstored<'a> {
    pub pixels: &'a mut [Linear],
    pub background: Linear,
}

impl Target for Unstored<'_> {
    type Pixel = Linear;

    #[inline(always)]
    fn put<S: Simd>(&mut self, simd: S, first: usize, count: usize, color: [Lanes<S>; 3], covered: S::mask32s) -> u32 {
        let one = Lanes::splat(simd, 1.0);
        let [red, green, blue, _] = self.background;
        let brightest = one.constant(BRIGHTEST as f32);
        let [r, g, b] = [color[0].min(brightest), color[1].min(brightest), color[2].min(brightest)];
        let over = (r.max(g).max(b).greater_than(one) & covered).to_bitmask() & (u64::MAX >> (64 - count));
        let planes = [
            Lanes::select(covered, r, one.constant(red)),
            Lanes::select(covered, g, one.constant(green)),
            Lanes::select(covered, b, one.constant(blue)),
            Lanes::select(covered, one, one.constant(0.0)),
        ];
        let pixels = &mut self.pixels[first..first + count];
        if count == Lanes::<S>::LEN {
            join(simd, &planes, pixels);
        } else {
            let mut whole = [self.background; WIDEST];
            join(simd, &planes, &mut whole[..Lanes::<S>::LEN]);
            pixels.copy_from_slice(&whole[..count]);
        }
        over.count_ones()
    }

    #[inline(always)]
    fn clear(&mut self, range: Range<usize>) {
        self.pixels[range].fill(self.background);
    }

    #[inline(always)]
    fn ink<S: Simd>(&self, _: S, color: [f32; 3]) -> Ink<Linear> {
        let [r, g, b] = color;
        Ink { pixel: [r, g, b, 1.0], overflows: overflows(color) }
    }

    #[inline(always)]
    fn fill(&mut self, range: Range<usize>, ink: Ink<Linear>) -> u64 {
        ink.fill(&mut self.pixels[range])
    }
}

/// Colours a band and returns how many pixels overflow.
#[inline(always)]
pub fn shade<S: Simd>(
    simd: S,
    place: BandPlace,
    extents: &[Range<u32>],
    fragments: &[Block],
    mut colour: impl Colour,
    target: &mut impl Target,
) -> u64 {
    let width = place.width as usize;
    let mut over = 0;
    for ((row, extent), line) in extents.iter().enumerate().zip(fragments.chunks(Block::count(place.width))) {
        let start = row * width;
        if extent.is_empty() {
            target.clear(start..start + width);
            continue;
        }
        // Whole vectors: what they have beyond the extent are gaps.
        let lanes = Lanes::<S>::LEN;
        let first = extent.start as usize / lanes * lanes;
        let end = (extent.end as usize).next_multiple_of(lanes).min(width);
        target.clear(start..start + first);
        target.clear(start + end..start + width);
        colour.row(place.first_row + row as u32);
        let limit = Lanes::splat(simd, f32::MIN);
        for x in (first..end).step_by(lanes) {
            let [a, b, c, key] = line[x / Block::PIXELS].load(simd, x % Block::PIXELS);
            let rgb = colour.at(simd, x, [a, b, c], key);
            let count = lanes.min(width - x);
            over += u64::from(target.put(simd, start + x, count, rgb, key.greater_than(limit)));
        }
    }
    over
}
