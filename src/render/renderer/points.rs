//! Shading at points: the equation at the vertices or faces of the model, chunk by chunk.

use super::plan::{Inputs, Per};
use super::shade::within_reach;
use crate::geometry::Buckets;
use crate::illumination::{Equation, LANES, Lanes, LawScratch, Reached, Real, V3};
use crate::render::lens::FARTHEST;
use crate::render::model::{Model, PADDING, Planes};
use crate::render::rays::BLOCK;
use crate::scene::Rgb;
use fearless_simd::{Level, dispatch, prelude::*};
use glam::DVec3;
use rayon::prelude::*;
use std::ops::Range;

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
    /// The points where the scene's own law is undefined, in order.
    pub undefined: Vec<u32>,
    /// True for each chunk that is yet to be shaded.
    pending: Vec<bool>,
}

impl PointIntensities {
    /// Begins other intensities.
    pub fn begin(&mut self) {
        self.pending.clear();
        self.pending.push(true);
        self.undefined.clear();
    }

    /// Returns whether there are points that are yet to be shaded.
    pub fn is_pending(&self) -> bool {
        self.pending.contains(&true)
    }

    /// Returns the mean intensity of some points.
    #[inline(always)]
    pub fn mean(&self, points: &[u32]) -> [f32; 3] {
        let at = |point: u32| self.planes.each_ref().map(|plane| plane[point as usize]);
        if let [point] = points {
            return at(*point);
        }
        let share = 1.0 / points.len().max(1) as f32;
        let add = |a: [f32; 3], b: [f32; 3]| [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
        let sum = points.iter().map(|point| at(*point)).fold([0.0; 3], add);
        sum.map(|v| v * share)
    }

    /// Returns whether the scene's own law is undefined at any of some points.
    #[inline(always)]
    pub fn is_undefined_at(&self, points: &[u32]) -> bool {
        let is_undefined = |point: &u32| self.undefined.binary_search(point).is_ok();
        !self.undefined.is_empty() && points.iter().any(is_undefined)
    }

    /// Shades `count` points in chunks of `length` that are not shaded yet, one at least and then until `passed`: `shade` is given the
    /// first point of each and its part of the planes, and returns the points where the law is undefined, counted from the first.
    fn shade(
        &mut self,
        [count, length]: [usize; 2],
        passed: &(impl Fn() -> bool + Sync),
        shade: impl Fn(usize, [&mut [f32]; 3]) -> Vec<u32> + Sync,
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
        let undefined = chunks
            .enumerate()
            .flat_map_iter(|(chunk, (((r, g), b), pending))| {
                if !*pending || Some(chunk) != least && passed() {
                    return vec![];
                }
                *pending = false;
                let first = (chunk * length) as u32;
                let mut undefined = shade(chunk * length, [r, g, b]);
                undefined.iter_mut().for_each(|point| *point += first);
                undefined
            });
        self.undefined.par_extend(undefined);
        self.undefined.sort_unstable();
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
        let mut undefined = vec![];
        let materials =
            &materials[range.start.min(materials.len())..range.end.min(materials.len())];
        let own = materials.iter().map(|material| u32::from(*material));
        // The points of one material are shaded together.
        for (material, points) in Buckets::new(equations.len(), own.zip(0..)).filled() {
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
            let found = shader.shade(material, gathered, reached, out);
            undefined.extend(found.iter().filter_map(|own| points.get(*own as usize)));
            for (own, point) in points.iter().map(|point| *point as usize).enumerate() {
                [r[point], g[point], b[point]] = colors.each_ref().map(|plane| plane[own]);
            }
        }
        undefined
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
    /// Evaluates a material's equation at points; returns those where the scene's own law is undefined.
    fn shade(
        &self,
        material: usize,
        [position, normal, tint]: [[&[f32]; 3]; 3],
        reached: Option<Reached<'_>>,
        out: [&mut [f32]; 3],
    ) -> Vec<u32> {
        let points = Points {
            equation: &self.equations[material],
            scale: self.scale,
            offset: self.offset,
            position,
            normal,
            tint,
            reached,
        };
        dispatch!(self.level, simd => points.shade(simd, out))
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
        let at = (
            inputs.triangles.model.origin + at(position, index),
            at(normal, index),
        );
        let (material, model) = (inputs.point_materials().get(index), inputs.triangles.model);
        let tint = match inputs.plan.per {
            _ if index >= inputs.point_count() => Rgb::ONE,
            Per::Face => model.face_tint(index as u32),
            _ => model.tint(index as u32),
        };
        let equation = &equations[material.map_or(0, |material| usize::from(*material))];
        let color = equation.illuminate_tinted(at, tint, None, reached);
        (
            color.as_vec3().to_array(),
            equation.is_undefined(at, tint, reached),
        )
    };
    let chunks = [position[0].len(), LENGTH];
    intensities.shade(chunks, passed, |first, [r, g, b]| {
        let mut undefined = vec![];
        for place in 0..r.len() {
            let (color, is_undefined) = shaded(first + place);
            [r[place], g[place], b[place]] = color;
            if is_undefined {
                undefined.push(place as u32);
            }
        }
        undefined
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
    fn shade<S: Simd>(&self, simd: S, out: [&mut [f32]; 3]) -> Vec<u32> {
        let mut undefined = vec![];
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
            let (rgb, is_undefined) =
                self.equation
                    .illuminate_site(&point, reached, tint, &mut scratch);
            rgb[0].0.store_slice(&mut r[start..start + LANES]);
            rgb[1].0.store_slice(&mut g[start..start + LANES]);
            rgb[2].0.store_slice(&mut b[start..start + LANES]);
            let lanes = is_undefined.greater_than(scale.constant(0.0)).to_bitmask();
            if lanes != 0 {
                let lanes = (0..LANES).filter(|lane| lanes >> lane & 1 == 1);
                undefined.extend(lanes.map(|lane| (start + lane) as u32));
            }
        }
        undefined
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
