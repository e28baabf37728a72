//! What each of a few lights does at each pixel, kept while only coefficients change.
//!
//! I is linear in Ka, Kd, Ks and in the colours. As a hand moves one of them, the factors `f·max(N·L, 0)` and f·S of each light
//! stay what they are: the second picture keeps them, and from the third on they are taken as they lie.
//!
//! ```text
//!   row of a picture   │ block 0: 16 pixels                      │ block 1 …
//!                      │ diffuse 0 │ specular 0 │ diffuse 1 │ …  │
//! ```

use super::fragments::Block;
use super::plan::{Per, Plan};
use super::shade::{Colour, Evaluated};
use crate::illumination::{Equation, Lanes, NoSpecular, Specular, SpecularForm};
use fearless_simd::prelude::*;
use std::ops::RangeInclusive;

/// Of so many sources: with one there is nothing to gain, and with many the memory is in the way.
const SOURCES: RangeInclusive<usize> = 2..=4;

/// A factor at the pixels of a block.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(super) struct Plane([f32; Block::PIXELS]);

impl Plane {
    pub const ZERO: Self = Self([0.0; Block::PIXELS]);
}

/// What the factors depend on.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct FactorInputs {
    bands: u64,
    /// The run of the bits, where there are shadows.
    reach: Option<u64>,
    equation: Equation<f32>,
    renormalise: bool,
}

impl FactorInputs {
    /// The inputs of a picture whose factors can be kept.
    pub fn of(plan: &Plan, equation: &Equation<f32>, bands: u64, reach: u64) -> Option<Self> {
        let few = SOURCES.contains(&equation.sources.len());
        let can = few && plan.per == Per::Pixel && !plan.double && plan.leaves_out && !equation.has_fresnel();
        can.then(|| Self {
            bands,
            reach: plan.shadows.then_some(reach),
            equation: equation.without_coefficients(),
            renormalise: plan.renormalise,
        })
    }
}

/// Planes of a row of `width` pixels lit by `sources`.
pub(super) fn row_length(width: u32, sources: usize) -> usize {
    Block::count(width) * 2 * sources
}

/// Evaluates the equation and keeps the factors.
pub(super) struct Keeping<'a, F> {
    pub evaluated: Evaluated<'a, F>,
    pub rows: Rows<&'a mut [Plane]>,
}

/// Takes the factors.
pub(super) struct Taking<'a> {
    pub evaluated: Evaluated<'a, NoSpecular>,
    pub rows: Rows<&'a [Plane]>,
}

/// The rows of a band, and which of them is the present one.
pub(super) struct Rows<P> {
    planes: P,
    length: usize,
    first: u32,
    start: usize,
}

impl<P> Rows<P> {
    /// Rows of `length` planes from pixel row `first` on.
    pub fn new(planes: P, length: usize, first: u32) -> Self {
        Self { planes, length, first, start: 0 }
    }

    #[inline(always)]
    fn row(&mut self, y: u32) {
        self.start = (y - self.first) as usize * self.length;
    }

    /// Where the planes of the block that `column` lies in start, for `sources`.
    #[inline(always)]
    fn block(&self, column: usize, sources: usize) -> usize {
        self.start + column / Block::PIXELS * 2 * sources
    }
}

impl<F: Specular> Colour for Keeping<'_, F> {
    #[inline(always)]
    fn row(&mut self, y: u32) {
        self.evaluated.row(y);
        self.rows.row(y);
    }

    #[inline(always)]
    fn at<S: Simd>(&mut self, simd: S, column: usize, carried: [Lanes<S>; 3], key: Lanes<S>) -> [Lanes<S>; 3] {
        let (site, reached) = self.evaluated.site(simd, column, carried, key);
        let equation = self.evaluated.equation();
        let (mut sum, color) = equation.unlit(site.position);
        let count = equation.sources.len();
        let (block, lane) = (self.rows.block(column, count), column % Block::PIXELS);
        let planes = &mut self.rows.planes[block..block + 2 * count];
        for (index, planes) in planes.chunks_exact_mut(2).enumerate() {
            let zero = Lanes::splat(simd, 0.0);
            let (mut diffuse, mut specular) = (zero, zero);
            if let Some(response) = equation.respond_if_reached::<_, F>(index, &site, reached) {
                (diffuse, specular) = (response.diffuse, response.specular);
            }
            diffuse.0.store_slice(&mut planes[0].0[lane..lane + Lanes::<S>::LEN]);
            specular.0.store_slice(&mut planes[1].0[lane..lane + Lanes::<S>::LEN]);
            equation.add_diffuse(&mut sum, index, color, diffuse);
            if F::PRESENT {
                equation.add_specular(&mut sum, index, specular, zero);
            }
        }
        sum
    }
}

impl Colour for Taking<'_> {
    #[inline(always)]
    fn row(&mut self, y: u32) {
        self.evaluated.row(y);
        self.rows.row(y);
    }

    #[inline(always)]
    fn at<S: Simd>(&mut self, simd: S, column: usize, _: [Lanes<S>; 3], key: Lanes<S>) -> [Lanes<S>; 3] {
        let equation = self.evaluated.equation();
        let (mut sum, color) = equation.unlit(self.evaluated.position(simd, column, key));
        let count = equation.sources.len();
        let (block, lane) = (self.rows.block(column, count), column % Block::PIXELS);
        let shines = equation.form() != SpecularForm::None;
        for (index, planes) in self.rows.planes[block..block + 2 * count].chunks_exact(2).enumerate() {
            equation.add_diffuse(&mut sum, index, color, Lanes::load(simd, &planes[0].0[lane..]));
            if shines {
                let specular = Lanes::load(simd, &planes[1].0[lane..]);
                equation.add_specular(&mut sum, index, specular, specular);
            }
        }
        sum
    }
}
