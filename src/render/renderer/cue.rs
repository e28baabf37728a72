//! Depth cueing: intensities fade into one colour with depth.
//!
//! `I' = s0·I + (1 − s0)·Idc` is affine in I. So the sum of a surface's own light, light from other surfaces and
//! transmitted light may fade as a whole, or each part where it is found: at vertices and faces, before it is carried to
//! the pixels, or at the pixels.

use super::display::{Linear, is_marked};
use super::plan::{Cued, Inputs};
use crate::render::model::{Model, Planes};
use crate::render::node::{Memory, capacity};
use crate::render::raster::{Block, Coverage, Fragment, ROWS, carry, fragment, interpolate};
use crate::scene::FlatAt;
use fearless_simd::dispatch;
use glam::{DVec3, Vec3};
use rayon::prelude::*;

/// The points that one task processes.
const POINTS: usize = 4096;

impl Inputs<'_> {
    /// Returns s0 at points given relative to `origin`.
    fn scales(&self, origin: DVec3, position: &Planes) -> Vec<f32> {
        let mut scales = vec![0.0; position[0].len()];
        scales
            .par_chunks_mut(POINTS)
            .enumerate()
            .for_each(|(chunk, scales)| {
                let start = chunk * POINTS;
                let [x, y, z] = position
                    .each_ref()
                    .map(|plane| &plane[start..start + scales.len()]);
                for (((scale, x), y), z) in scales.iter_mut().zip(x).zip(y).zip(z) {
                    *scale = self.scale(origin + Vec3::new(*x, *y, *z).as_dvec3()) as f32;
                }
            });
        scales
    }

    pub fn fade_points(&self, origin: DVec3, position: &Planes, intensity: &mut Planes) {
        let scales = self.scales(origin, position);
        let color = self.scene.depth_cueing.color.as_vec3();
        for (plane, color) in intensity.iter_mut().zip(color.to_array()) {
            for (value, s0) in plane.iter_mut().zip(&scales) {
                *value = s0 * *value + (1.0 - s0) * color;
            }
        }
    }
}

/// s0 at each pixel that shows the object.
#[derive(Default)]
pub struct CueLayer {
    pub scales: Vec<f32>,
    carried: Vec<Fragment>,
    fragments: Vec<Block>,
}

impl CueLayer {
    pub fn count(&self, memory: &mut Memory) {
        memory.vertices += capacity(&self.carried);
        memory.pixels += capacity(&self.scales) + capacity(&self.fragments);
    }

    /// Computes s0 at each pixel; `middles` are those of the faces relative to the model's origin, where a flat polygon's
    /// s0 is found there.
    pub fn run(&mut self, inputs: &Inputs<'_>, coverage: Coverage<'_>, middles: &Planes) {
        let [width, height] = coverage.size.map(|side| side as usize);
        self.scales.clear();
        self.scales.resize(width * height, 1.0);
        let plan = inputs.plan;
        match plan.cued {
            Cued::Nowhere => {}
            Cued::AtPixels if plan.keeps_fragments() => self.by_depth(inputs, coverage),
            Cued::AtPoints if !plan.carries => self.by_face(inputs, coverage, middles),
            Cued::AtPixels | Cued::AtVertices | Cued::AtPoints => {
                self.by_carrying(inputs, coverage);
            }
        }
    }

    /// Computes s0 from the depths of the bands' own fragments.
    fn by_depth(&mut self, inputs: &Inputs<'_>, coverage: Coverage<'_>) {
        let [width, _] = coverage.size;
        let bands = self
            .scales
            .par_chunks_mut(ROWS * width as usize)
            .zip(coverage.parts());
        bands.for_each(|(scales, (_, fragments))| {
            for (scales, line) in rows(scales, fragments, width) {
                for (x, scale) in scales.iter_mut().enumerate() {
                    *scale = at_key(inputs, fragment(line, x)[3]);
                }
            }
        });
    }

    /// Computes one s0 for each flat polygon, where its intensity is found.
    fn by_face(&mut self, inputs: &Inputs<'_>, coverage: Coverage<'_>, middles: &Planes) {
        let (model, flat_at) = (inputs.triangles.model, inputs.scene.shading.flat_at);
        let points = inputs.scales(
            model.origin,
            if flat_at == FlatAt::Centre {
                middles
            } else {
                &model.position
            },
        );
        let width = coverage.size[0] as usize;
        let bands = self
            .scales
            .par_chunks_mut(ROWS * width)
            .zip(coverage.parts());
        bands.for_each(|(scales, (band, _))| {
            for run in &band.runs {
                let scale = of_face(flat_at, &points, model, inputs.triangles.face(run.triangle));
                let row = usize::from(run.row) * width;
                scales[row + usize::from(run.x0)..row + usize::from(run.x1)].fill(scale);
            }
        });
    }

    /// Interpolates s0 itself, or the depth alone, from the vertices, as normals and intensities are.
    fn by_carrying(&mut self, inputs: &Inputs<'_>, coverage: Coverage<'_>) {
        let (plan, model, [width, height]) = (inputs.plan, inputs.triangles.model, coverage.size);
        let by_depth = plan.cued == Cued::AtPixels;
        let points = if by_depth {
            vec![0.0; model.padded_len()]
        } else {
            inputs.scales(model.origin, &model.position)
        };
        carry(
            inputs.level,
            [&points; 3],
            plan.perspective,
            &inputs.triangles,
            &mut self.carried,
        );
        let blocks = Block::count(width);
        self.fragments.resize(blocks * height as usize, Block::GAP);
        let sources = (inputs.triangles, &*self.carried);
        let bands = self
            .scales
            .par_chunks_mut(ROWS * width as usize)
            .zip(self.fragments.par_chunks_mut(ROWS * blocks));
        bands.zip(coverage.parts()).for_each(|((scales, fragments), (band, _))| {
            dispatch!(inputs.level, simd => interpolate(simd, band, sources, plan.scanline, fragments));
            for (scales, line) in rows(scales, fragments, width) {
                for (x, scale) in scales.iter_mut().enumerate() {
                    let [carried, _, _, depth_key] = fragment(line, x);
                    *scale = match (by_depth, plan.perspective) {
                        (true, _) => at_key(inputs, depth_key),
                        (false, true) => carried / depth_key,
                        (false, false) => carried,
                    };
                }
            }
        });
    }
}

/// Returns the rows of a band, `width` pixels each.
fn rows<'a>(
    scales: &'a mut [f32],
    fragments: &'a [Block],
    width: u32,
) -> impl Iterator<Item = (&'a mut [f32], &'a [Block])> {
    scales
        .chunks_mut(width as usize)
        .zip(fragments.chunks(Block::count(width)))
}

fn at_key(Inputs { lens, scene, .. }: &Inputs<'_>, key: f32) -> f32 {
    scene
        .depth_cueing
        .scale_at(lens.depth_from_key(f64::from(key)) * lens.unit) as f32
}

/// Returns a flat polygon's s0, from those of the points where its intensity is found.
fn of_face(at: FlatAt, points: &[f32], model: &Model, face: u32) -> f32 {
    let corners = model.face(face);
    match at {
        FlatAt::Centre => points[face as usize],
        FlatAt::ProvokingVertex => points[corners.first().copied().unwrap_or_default() as usize],
        FlatAt::VertexMean => {
            let count = corners.len().max(1) as f32;
            corners.iter().map(|&v| points[v as usize]).sum::<f32>() / count
        }
    }
}

/// Fades the pixels that show the object; returns the number of pixels that are marked, of these or, if `all`, of the picture.
pub fn fade_pixels(layer: &CueLayer, color: Vec3, all: bool, linear: &mut [Linear]) -> u64 {
    let fade = |(pixel, s0): (&mut Linear, &f32)| {
        let covered = pixel[3] > 0.0;
        if covered {
            let faded = *s0 * Vec3::from_slice(pixel) + (1.0 - s0) * color;
            pixel[..3].copy_from_slice(&faded.to_array());
        }
        u64::from((covered || all) && is_marked(*pixel))
    };
    linear.par_iter_mut().zip(&layer.scales).map(fade).sum()
}
