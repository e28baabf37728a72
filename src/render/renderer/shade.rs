//! Shading of a band's pixels from their fragments: the equation, or the interpolated intensities.

use super::plan::Inputs;
use super::target::{Shown, Target};
use crate::illumination::{
    Equation, GROUPS_TOGETHER, LANES, Lanes, LawScratch, Reached, Real, ShadingPoint, SpecularForm,
    V3,
};
use crate::render::lens::{FARTHEST, Lens, pixel_centre};
use crate::render::raster::{Band, Block, SHORTEST_NORMAL};
use fearless_simd::prelude::*;
use glam::DVec3;
use std::ops::Range;

const SHORTEST_SQUARED: f32 = (SHORTEST_NORMAL * SHORTEST_NORMAL) as f32;

/// A source of pixels' colours from their fragments.
pub trait Colour {
    /// Prepares a row: `y` is the pixel row, `blocks` are its fragments in the band.
    #[inline(always)]
    fn row(&mut self, _y: u32, _blocks: Range<usize>) {}

    /// Prepares the pixels from `column` on for the scene's own law, at most [`GROUPS_TOGETHER`] blocks of them.
    #[inline(always)]
    fn prepare<S: Simd>(
        &mut self,
        _: S,
        _column: usize,
        _fragments: &[Block],
        _: &mut LawScratch<Lanes<S>>,
    ) {
    }

    /// Returns red, green, blue at the pixels from `column` on, given the three carried numbers and the depth key; `scratch` holds what
    /// was prepared.
    fn at<S: Simd>(
        &mut self,
        simd: S,
        column: usize,
        carried: [Lanes<S>; 3],
        key: Lanes<S>,
        scratch: &LawScratch<Lanes<S>>,
    ) -> [Lanes<S>; 3];

    /// Returns at which of the last pixels the scene's own law is undefined, the lowest bit for the first.
    #[inline(always)]
    fn undefined(&self) -> u64 {
        0
    }
}

/// Colours whose carried numbers are intensities.
#[derive(Clone, Copy)]
pub struct Carried {
    /// True if they were multiplied by the depth key.
    pub by_key: bool,
}

impl Carried {
    /// Returns the colour of a pixel, or those of several side by side.
    #[inline(always)]
    pub fn color<R: Real<Scalar = f32>>(self, carried: [R; 3], key: R) -> [R; 3] {
        // Rounding may leave nothing of the key of a far point beside that of a near one.
        let factor = if self.by_key {
            key.number(1.0) / key.max(key.number(1.0 / FARTHEST))
        } else {
            key.number(1.0)
        };
        let [r, g, b] = carried;
        [r * factor, g * factor, b * factor]
    }
}

impl Colour for Carried {
    #[inline(always)]
    fn at<S: Simd>(
        &mut self,
        _: S,
        _: usize,
        carried: [Lanes<S>; 3],
        key: Lanes<S>,
        _: &LawScratch<Lanes<S>>,
    ) -> [Lanes<S>; 3] {
        self.color(carried, key)
    }
}

/// Colours whose carried numbers are normals: the equation is evaluated at the points that the pixels' rays meet. Lengths
/// are camera distances, positions relative to the eye.
pub struct Evaluated<'a> {
    inputs: &'a Inputs<'a>,
    equation: &'a Equation<f32>,
    form: SpecularForm,
    perspective: bool,
    by_key: bool,
    renormalise: bool,
    /// The change of the ray to the next pixel on the right.
    step: [f32; 3],
    /// The ray through column 0 of the current row.
    start: [f32; 3],
    forward: [f32; 3],
    least_key: f32,
    /// The shadow bits of the current row.
    reached: Option<Reached<'a>>,
    /// The ray through column 0 of its row and the column of each pixel, where the fragments come from several rows.
    places: Option<&'a [Block]>,
    /// The interpolated colours that tint Od, those of the band and those of the current row; empty where there are none.
    tints: [&'a [Block]; 2],
    /// The first column that was prepared for the scene's own law.
    prepared: usize,
    undefined: u64,
}

impl<'a> Evaluated<'a> {
    #[inline(always)]
    pub fn new(inputs: &'a Inputs<'a>, equation: &'a Equation<f32>, form: SpecularForm) -> Self {
        let Inputs { plan, lens, .. } = inputs;
        Self {
            inputs,
            equation,
            form,
            perspective: lens.perspective,
            by_key: plan.perspective && !plan.true_surface,
            renormalise: plan.renormalise,
            step: within_reach(lens.right / lens.focal),
            start: [0.0; 3],
            forward: lens.forward.as_vec3().to_array(),
            least_key: lens.least_key() as f32,
            reached: None,
            places: None,
            tints: [&[]; 2],
            prepared: 0,
            undefined: 0,
        }
    }

    /// Sets the pixels of fragments that come from several rows, and their shadow bits.
    #[inline(always)]
    pub fn at_places(self, places: Option<&'a [Block]>, reached: Option<Reached<'a>>) -> Self {
        Self {
            reached,
            places,
            ..self
        }
    }

    /// Sets the fragments of the colours that tint Od; without any, nothing is tinted.
    #[inline(always)]
    pub fn tinted(self, tints: &'a [Block]) -> Self {
        Self {
            tints: [tints, &[]],
            ..self
        }
    }

    /// Returns the points that pixels in columns `x` show at depth key `key`; `start` is the ray through column 0.
    #[inline(always)]
    fn positions<S: Simd>(
        &self,
        simd: S,
        x: Lanes<S>,
        start: V3<Lanes<S>>,
        key: Lanes<S>,
    ) -> V3<Lanes<S>> {
        let step = V3::constant(x, self.step);
        let across = step.scale_add(x, start);
        if self.perspective {
            across.scale(Lanes::splat(simd, 1.0) / key)
        } else {
            V3::constant(x, self.forward).scale_add(-key, across)
        }
    }

    /// Returns the points that the pixels from `column` on show, given the three carried numbers and the depth key, and what tints Od
    /// there.
    #[inline(always)]
    fn site<S: Simd>(
        &self,
        simd: S,
        column: usize,
        carried: [Lanes<S>; 3],
        key: Lanes<S>,
    ) -> (ShadingPoint<Lanes<S>>, Option<[Lanes<S>; 3]>) {
        let key = key.max(Lanes::splat(simd, self.least_key));
        let [nx, ny, nz] = carried;
        let normal = V3::new(nx, ny, nz);
        let normal = if self.renormalise {
            let shortest = Lanes::splat(simd, SHORTEST_SQUARED);
            normal.normalised_from(if self.by_key {
                key * key * shortest
            } else {
                shortest
            })
        } else if self.by_key {
            normal.scale(Lanes::splat(simd, 1.0) / key)
        } else {
            normal
        };
        let (x, start) = match self.places {
            None => {
                let x = Lanes::count_up(simd) + Lanes::splat(simd, column as f32);
                (x, V3::constant(x, self.start))
            }
            Some(places) => {
                let [a, b, c, x] = places[column / LANES].load(simd);
                (x, V3::new(a, b, c))
            }
        };
        let site = self
            .equation
            .site(self.positions(simd, x, start, key), normal);
        let tint = self.tints[1].get(column / LANES).map(|block| {
            let [r, g, b, _] = block.load(simd);
            if !self.by_key {
                return [r, g, b];
            }
            let inverse = Lanes::splat(simd, 1.0) / key;
            [r * inverse, g * inverse, b * inverse]
        });
        (site, tint)
    }
}

/// Returns the ray through column 0 of a pixel row, as the kernels take it.
pub fn start_of_row(lens: &Lens, y: usize) -> [f32; 3] {
    let (point, direction) = lens.ray(pixel_centre(0, y));
    within_reach(if lens.perspective { direction } else { point })
}

/// Converts to single precision, with no component larger than the farthest distance.
pub(super) fn within_reach(v: DVec3) -> [f32; 3] {
    v.clamp(DVec3::splat(-FARTHEST), DVec3::splat(FARTHEST))
        .as_vec3()
        .to_array()
}

impl Colour for Evaluated<'_> {
    #[inline(always)]
    fn row(&mut self, y: u32, blocks: Range<usize>) {
        self.tints[1] = self.tints[0].get(blocks).unwrap_or_default();
        if self.places.is_some() {
            return;
        }
        let Inputs {
            lens, visibility, ..
        } = self.inputs;
        self.start = start_of_row(lens, y as usize);
        self.reached = visibility.and_then(|bits| bits.at(y as usize, 0));
    }

    #[inline(always)]
    fn prepare<S: Simd>(
        &mut self,
        simd: S,
        column: usize,
        fragments: &[Block],
        scratch: &mut LawScratch<Lanes<S>>,
    ) {
        if self.form != SpecularForm::Formula {
            return;
        }
        self.prepared = column;
        scratch.points.clear();
        for (block, fragment) in fragments.iter().enumerate() {
            let [a, b, c, key] = fragment.load(simd);
            let (site, tint) = self.site(simd, column + block * LANES, [a, b, c], key);
            scratch.points.push(self.equation.law_point(site, tint));
        }
        let reached = Reached::starting_at(self.reached, column);
        let sources = 0..self.equation.sources.len();
        self.equation.add_law(sources, reached, scratch);
    }

    #[inline(always)]
    fn at<S: Simd>(
        &mut self,
        simd: S,
        column: usize,
        carried: [Lanes<S>; 3],
        key: Lanes<S>,
        scratch: &LawScratch<Lanes<S>>,
    ) -> [Lanes<S>; 3] {
        if self.form == SpecularForm::Formula {
            let point = &scratch.points[(column - self.prepared) / LANES];
            self.undefined = point.undefined.greater_than(key.constant(0.0)).to_bitmask();
            return point.sum;
        }
        let (site, tint) = self.site(simd, column, carried, key);
        let reached = Reached::starting_at(self.reached, column);
        self.equation.illuminate_by(self.form, &site, reached, tint)
    }

    #[inline(always)]
    fn undefined(&self) -> u64 {
        self.undefined
    }
}

/// Colours some columns of a band and returns how many pixels overflow. The lanes that hold the first of them may also
/// colour pixels to its left.
#[inline(always)]
pub fn shade<S: Simd>(
    simd: S,
    Band { place, extents, .. }: &Band,
    fragments: &[Block],
    columns: &Range<usize>,
    mut colour: impl Colour,
    target: &mut impl Target,
) -> u64 {
    let width = place.width as usize;
    let (mut over, mut scratch) = (0, LawScratch::default());
    for ((row, extent), line) in extents
        .iter()
        .enumerate()
        .zip(fragments.chunks(Block::count(place.width)))
    {
        let start = row * width;
        let seen = columns.start.max(extent.start as usize)..columns.end.min(extent.end as usize);
        if seen.is_empty() {
            target.clear(start + columns.start..start + columns.end);
            continue;
        }
        // In whole blocks: the part beyond the extent consists of gaps.
        let first = seen.start / LANES * LANES;
        let end = seen.end.next_multiple_of(LANES).min(columns.end);
        target.clear(start + columns.start..start + first.max(columns.start));
        target.clear(start + end..start + columns.end);
        let blocks = row * line.len()..(row + 1) * line.len();
        colour.row(place.first_row + row as u32, blocks);
        let limit = Lanes::splat(simd, f32::MIN);
        for x in (first..end).step_by(LANES) {
            let place = x / LANES;
            if (x - first).is_multiple_of(GROUPS_TOGETHER * LANES) {
                let last = end.div_ceil(LANES).min(place + GROUPS_TOGETHER);
                colour.prepare(simd, x, &line[place..last], &mut scratch);
            }
            let [a, b, c, key] = line[place].load(simd);
            let rgb = colour.at(simd, x, [a, b, c], key, &scratch);
            let count = LANES.min(columns.end - x);
            let lanes = Shown {
                covered: key.greater_than(limit),
                undefined: colour.undefined(),
            };
            over += u64::from(target.put(simd, start + x, count, rgb, lanes));
        }
    }
    over
}
