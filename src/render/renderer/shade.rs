//! Shading: the equation at vertices or faces, and at the pixels of a band's fragments; or the interpolated intensities.

use super::plan::{Inputs, Per};
use super::target::{Shown, Target};
use crate::illumination::{
    Equation, LANES, Lanes, LawScratch, Reached, Real, ShadingPoint, SpecularForm, TOGETHER, V3,
};
use crate::render::face_materials::ByMaterial;
use crate::render::lens::{FARTHEST, Lens, pixel_centre};
use crate::render::model::{Model, PADDING, Planes};
use crate::render::raster::{Band, Block, SHORTEST_NORMAL};
use crate::render::rays::BLOCK;
use crate::scene::Rgb;
use fearless_simd::{Level, dispatch, prelude::*};
use glam::DVec3;
use rayon::prelude::*;
use std::ops::Range;

const SHORTEST_SQUARED: f32 = (SHORTEST_NORMAL * SHORTEST_NORMAL) as f32;

/// A source of pixels' colours from their fragments.
pub trait Colour {
    /// Prepares a row: `y` is the pixel row, `blocks` are its fragments in the band.
    #[inline(always)]
    fn row(&mut self, _y: u32, _blocks: Range<usize>) {}

    /// Prepares the pixels from `column` on for the scene's own law, at most [`TOGETHER`] blocks of them.
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

impl Colour for Carried {
    #[inline(always)]
    fn at<S: Simd>(
        &mut self,
        simd: S,
        _: usize,
        carried: [Lanes<S>; 3],
        key: Lanes<S>,
        _: &LawScratch<Lanes<S>>,
    ) -> [Lanes<S>; 3] {
        // Rounding may leave nothing of the key of a far point beside that of a near one.
        let min_key = Lanes::splat(simd, (1.0 / FARTHEST) as f32);
        let factor = if self.by_key {
            Lanes::splat(simd, 1.0) / key.max(min_key)
        } else {
            Lanes::splat(simd, 1.0)
        };
        let [r, g, b] = carried;
        [r * factor, g * factor, b * factor]
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
fn within_reach(v: DVec3) -> [f32; 3] {
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
            if (x - first).is_multiple_of(TOGETHER * LANES) {
                let last = end.div_ceil(LANES).min(place + TOGETHER);
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

/// The points where the equation is evaluated, vertices or faces: coordinates relative to the model's origin, normals, and
/// the colours that tint Od, which are empty where there are none.
pub type PointPlanes<'a> = [&'a Planes; 3];

/// Returns the middle of each face, relative to the model's origin, its own normal, and the mean of its corners' colours;
/// padded as the vertices are.
pub fn face_points(model: &Model) -> [Planes; 3] {
    let count = model.face_count();
    let planes = |of: &(dyn Fn(u32) -> DVec3 + Sync)| -> Planes {
        let faces = (0..u32::try_from(count).unwrap_or(u32::MAX)).into_par_iter();
        let values: Vec<DVec3> = faces.map(of).collect();
        [0, 1, 2].map(|axis| {
            let mut plane: Vec<f32> = values.iter().map(|value| value[axis] as f32).collect();
            plane.resize(count.next_multiple_of(PADDING), 0.0);
            plane
        })
    };
    [
        planes(&|face| model.face_centre(face) - model.origin),
        planes(&|face| model.face_normal(face)),
        if model.is_tinted() {
            planes(&|face| model.face_tint(face))
        } else {
            Planes::default()
        },
    ]
}

/// The intensities at points, vertices or faces, which are shaded chunk by chunk.
#[derive(Default)]
pub struct PointIntensities {
    pub planes: Planes,
    /// Whether each chunk is yet to be shaded.
    pending: Vec<bool>,
}

impl PointIntensities {
    /// Begins other intensities.
    pub fn begin(&mut self) {
        self.pending.clear();
        self.pending.push(true);
    }

    /// Returns whether there are points that are yet to be shaded.
    pub fn is_pending(&self) -> bool {
        self.pending.contains(&true)
    }

    /// Shades `count` points in chunks of `length` that are not shaded yet, one at least and then until `passed`: `shade` is given the
    /// first point of each and its part of the planes.
    fn shade(
        &mut self,
        [count, length]: [usize; 2],
        passed: &(impl Fn() -> bool + Sync),
        shade: impl Fn(usize, [&mut [f32]; 3]) + Sync,
    ) {
        for plane in &mut self.planes {
            // Without more capacity than needed.
            plane.reserve_exact(count.saturating_sub(plane.len()));
            plane.resize(count, 0.0);
        }
        self.pending.resize(count.div_ceil(length), true);
        let least = self.pending.iter().position(|own| *own);
        let [r, g, b] = &mut self.planes;
        let chunks = r
            .par_chunks_mut(length)
            .zip(g.par_chunks_mut(length))
            .zip(b.par_chunks_mut(length))
            .zip(self.pending.par_iter_mut());
        chunks
            .enumerate()
            .for_each(|(chunk, (((r, g), b), pending))| {
                if *pending && (Some(chunk) == least || !passed()) {
                    shade(chunk * length, [r, g, b]);
                    *pending = false;
                }
            });
    }
}

/// Evaluates the equation at the vertices or faces of the model, each with its material's, until `passed`.
pub fn shade_points(
    inputs: &Inputs<'_>,
    equations: &[Equation<f32>],
    [position, normal, tint]: PointPlanes<'_>,
    intensities: &mut PointIntensities,
    passed: &(impl Fn() -> bool + Sync),
) {
    let Inputs {
        lens,
        triangles,
        visibility,
        ..
    } = *inputs;
    let model = triangles.model;
    // Several materials have enough points each in a chunk to fill lanes.
    let chunk_len = (equations.len() * 4 * LANES).next_multiple_of(BLOCK);
    let scale = (1.0 / lens.unit).min(FARTHEST / model.radius.max(f64::MIN_POSITIVE)) as f32;
    let offset = within_reach((model.origin - lens.eye) / lens.unit);
    let shader = PointShader {
        level: inputs.level,
        equations,
        scale,
        offset,
    };
    let chunks = [position[0].len(), chunk_len];
    intensities.shade(chunks, passed, |first, [r, g, b]| {
        let range = first..first + r.len();
        let all = [position, normal, tint].map(|planes| part_of(planes, range.clone()));
        let materials = inputs.point_materials();
        if materials.is_empty() {
            let reached = visibility.and_then(|bits| bits.at(first / BLOCK, 0));
            return shader.shade(0, all, reached, [r, g, b]);
        }
        let materials =
            &materials[range.start.min(materials.len())..range.end.min(materials.len())];
        let own = materials.iter().map(|material| usize::from(*material));
        // The points of one material are shaded together.
        for (material, points) in ByMaterial::of(own, equations.len()).groups() {
            let own = all.map(|planes| gather(planes, points));
            let mut colors = own[0].clone();
            let sources = equations[material].sources.len();
            let bits = points.iter().map(|point| {
                let point = first + *point as usize;
                let row = visibility.and_then(|bits| bits.at(point / BLOCK, 0));
                (row, point % BLOCK)
            });
            let (words, stride) = Reached::gathered(bits, sources);
            let reached = (!words.is_empty()).then_some(Reached {
                words: &words,
                stride,
                first: 0,
            });
            let gathered = own
                .each_ref()
                .map(|planes| planes.each_ref().map(Vec::as_slice));
            let out = colors.each_mut().map(Vec::as_mut_slice);
            shader.shade(material, gathered, reached, out);
            for (own, point) in points.iter().map(|point| *point as usize).enumerate() {
                [r[point], g[point], b[point]] = colors.each_ref().map(|plane| plane[own]);
            }
        }
    });
}

/// The equations of the materials, and the way from the model's coordinates to theirs.
struct PointShader<'a> {
    level: Level,
    equations: &'a [Equation<f32>],
    scale: f32,
    offset: [f32; 3],
}

impl PointShader<'_> {
    /// Evaluates a material's equation at points.
    fn shade(
        &self,
        material: usize,
        [position, normal, tint]: [[&[f32]; 3]; 3],
        reached: Option<Reached<'_>>,
        out: [&mut [f32]; 3],
    ) {
        let points = Points {
            equation: &self.equations[material],
            scale: self.scale,
            offset: self.offset,
            position,
            normal,
            tint,
            reached,
        };
        dispatch!(self.level, simd => points.shade(simd, out));
    }
}

/// Returns a range of planes; nothing of empty ones.
fn part_of(planes: &Planes, range: Range<usize>) -> [&[f32]; 3] {
    planes
        .each_ref()
        .map(|plane| plane.get(range.clone()).unwrap_or_default())
}

/// Returns planes of the numbers at `points`, padded by zeros; empty ones of empty ones.
fn gather(planes: [&[f32]; 3], points: &[u32]) -> Planes {
    planes.map(|plane| {
        if plane.is_empty() {
            return vec![];
        }
        let mut own: Vec<f32> = points.iter().map(|point| plane[*point as usize]).collect();
        own.resize(points.len().next_multiple_of(PADDING), 0.0);
        own
    })
}

/// Evaluates the equation at the vertices or faces of the model in double precision, each with its material's, until `passed`.
pub fn shade_points_in_double(
    inputs: &Inputs<'_>,
    equations: &[Equation<f64>],
    [position, normal, _]: PointPlanes<'_>,
    intensities: &mut PointIntensities,
    passed: &(impl Fn() -> bool + Sync),
) {
    const LENGTH: usize = 64;
    let at = |planes: &Planes, index: usize| {
        DVec3::from_array([0, 1, 2].map(|axis| f64::from(planes[axis][index])))
    };
    let shaded = |index: usize| {
        let reached = inputs
            .visibility
            .and_then(|bits| bits.at(index / BLOCK, index % BLOCK));
        let (point, normal) = (
            inputs.triangles.model.origin + at(position, index),
            at(normal, index),
        );
        let (material, model) = (inputs.point_materials().get(index), inputs.triangles.model);
        let tint = match inputs.plan.per {
            _ if index >= inputs.point_count() => Rgb::ONE,
            Per::Face => model.face_tint(index as u32),
            _ => model.tint(index as u32),
        };
        equations[material.map_or(0, |material| usize::from(*material))]
            .illuminate_tinted((point, normal), tint, None, reached)
            .as_vec3()
            .to_array()
    };
    let chunks = [position[0].len(), LENGTH];
    intensities.shade(chunks, passed, |first, [r, g, b]| {
        for place in 0..r.len() {
            [r[place], g[place], b[place]] = shaded(first + place);
        }
    });
}

struct Points<'a> {
    equation: &'a Equation<f32>,
    scale: f32,
    offset: [f32; 3],
    position: [&'a [f32]; 3],
    normal: [&'a [f32]; 3],
    tint: [&'a [f32]; 3],
    reached: Option<Reached<'a>>,
}

impl Points<'_> {
    #[inline(always)]
    fn shade<S: Simd>(&self, simd: S, out: [&mut [f32]; 3]) {
        let scale = Lanes::splat(simd, self.scale);
        let [r, g, b] = out;
        let mut scratch = LawScratch::default();
        for start in (0..r.len()).step_by(LANES) {
            let position = load_lanes(simd, self.position, start)
                .scale_add(scale, V3::constant(scale, self.offset));
            let point = self
                .equation
                .site(position, load_lanes(simd, self.normal, start));
            let tint = (!self.tint[0].is_empty()).then(|| {
                let V3 { x, y, z } = load_lanes(simd, self.tint, start);
                [x, y, z]
            });
            let reached = Reached::starting_at(self.reached, start);
            let (rgb, _) = self
                .equation
                .illuminate_site(&point, reached, tint, &mut scratch);
            rgb[0].0.store_slice(&mut r[start..start + LANES]);
            rgb[1].0.store_slice(&mut g[start..start + LANES]);
            rgb[2].0.store_slice(&mut b[start..start + LANES]);
        }
    }
}

#[inline(always)]
fn load_lanes<S: Simd>(simd: S, [x, y, z]: [&[f32]; 3], start: usize) -> V3<Lanes<S>> {
    V3::new(
        Lanes::load(simd, &x[start..]),
        Lanes::load(simd, &y[start..]),
        Lanes::load(simd, &z[start..]),
    )
}
