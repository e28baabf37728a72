//! Evaluates the equation at vertices or faces.

use super::inputs::Inputs;
use crate::illumination::{Equation, Lanes, Reached, Specular, V3};
use crate::render::lens::FARTHEST;
use crate::render::model::{Model, PADDING, Planes};
use crate::render::rays::BLOCK;
use fearless_simd::{dispatch, prelude::*};
use glam::DVec3;
use rayon::prelude::*;

/// The middle of each face, relative to the model's origin, and its own normal; padded as the vertices are.
pub fn face_points(model: &Model) -> [Planes; 2] {
    let count = model.face_count();
    let points: Vec<(DVec3, DVec3)> = (0..u32::try_from(count).unwrap_or(u32::MAX))
        .into_par_iter()
        .map(|face| (model.face_centre(face) - model.origin, model.face_normal(face)))
        .collect();
    let plane = |get: &dyn Fn(&(DVec3, DVec3)) -> f64| -> Vec<f32> {
        let mut plane: Vec<f32> = points.iter().map(|p| get(p) as f32).collect();
        plane.resize(count.next_multiple_of(PADDING), 0.0);
        plane
    };
    [[0, 1, 2].map(|axis| plane(&|p| p.0[axis])), [0, 1, 2].map(|axis| plane(&|p| p.1[axis]))]
}

/// Evaluates the equation at the vertices or faces of the model, [`BLOCK`] of them a task.
pub fn shade_points<F: Specular>(
    inputs: &Inputs<'_>,
    equation: &Equation<f32>,
    [position, normal]: [&Planes; 2],
    intensity: &mut Planes,
) {
    let Inputs { lens, triangles, visibility, .. } = *inputs;
    let model = triangles.model;
    fit(intensity, position[0].len());
    let scale = (1.0 / lens.unit).min(FARTHEST / model.radius.max(f64::MIN_POSITIVE)) as f32;
    let offset = (model.origin - lens.eye) / lens.unit;
    let offset = offset.clamp(DVec3::splat(-FARTHEST), DVec3::splat(FARTHEST)).as_vec3().to_array();
    let [r, g, b] = intensity;
    let out = r.par_chunks_mut(BLOCK).zip(g.par_chunks_mut(BLOCK)).zip(b.par_chunks_mut(BLOCK));
    out.enumerate().for_each(|(chunk, ((r, g), b))| {
        let range = chunk * BLOCK..chunk * BLOCK + r.len();
        let position = position.each_ref().map(|plane| &plane[range.clone()]);
        let normal = normal.each_ref().map(|plane| &plane[range.clone()]);
        let reached = visibility.and_then(|bits| bits.at(chunk, 0));
        let points = Points { equation, scale, offset, position, normal, reached };
        dispatch!(inputs.level, simd => points.shade::<_, F>(simd, [r, g, b]));
    });
}

/// The same in double precision.
pub fn shade_points_in_double(inputs: &Inputs<'_>, [position, normal]: [&Planes; 2], intensity: &mut Planes) {
    let equation = inputs.equation();
    fit(intensity, position[0].len());
    let [r, g, b] = intensity;
    let at = |planes: &Planes, index: usize| DVec3::from_array([0, 1, 2].map(|axis| f64::from(planes[axis][index])));
    let out = r.par_iter_mut().zip(g.par_iter_mut()).zip(b.par_iter_mut());
    out.enumerate().for_each(|(index, ((r, g), b))| {
        let reached = inputs.visibility.and_then(|bits| bits.at(index / BLOCK, index % BLOCK));
        let (point, normal) = (inputs.triangles.model.origin + at(position, index), at(normal, index));
        [*r, *g, *b] = equation.illuminate_world(point, normal, reached).as_vec3().to_array();
    });
}

/// Gives the planes their length, and no more room than that takes.
fn fit(planes: &mut Planes, count: usize) {
    for plane in planes {
        plane.reserve_exact(count.saturating_sub(plane.len()));
        plane.resize(count, 0.0);
    }
}

struct Points<'a> {
    equation: &'a Equation<f32>,
    scale: f32,
    offset: [f32; 3],
    position: [&'a [f32]; 3],
    normal: [&'a [f32]; 3],
    reached: Option<Reached<'a>>,
}

impl Points<'_> {
    #[inline(always)]
    fn shade<S: Simd, F: Specular>(&self, simd: S, out: [&mut [f32]; 3]) {
        let lanes = Lanes::<S>::LEN;
        let scale = Lanes::splat(simd, self.scale);
        let [r, g, b] = out;
        for start in (0..r.len()).step_by(lanes) {
            let position = load(simd, self.position, start).scale_add(scale, V3::constant(scale, self.offset));
            let point = self.equation.site(position, load(simd, self.normal, start));
            let reached = self.reached.map(
                #[inline(always)]
                |reached| reached.starting_at(start),
            );
            let rgb = self.equation.illuminate::<Lanes<S>, F>(&point, reached);
            rgb[0].0.store_slice(&mut r[start..start + lanes]);
            rgb[1].0.store_slice(&mut g[start..start + lanes]);
            rgb[2].0.store_slice(&mut b[start..start + lanes]);
        }
    }
}

#[inline(always)]
fn load<S: Simd>(simd: S, [x, y, z]: [&[f32]; 3], start: usize) -> V3<Lanes<S>> {
    V3::new(Lanes::load(simd, &x[start..]), Lanes::load(simd, &y[start..]), Lanes::load(simd, &z[start..]))
}
