//! Depth cueing: intensities fade into one colour with depth.
//!
//! `I' = s0·I + (1 − s0)·Idc` is affine in I. So it does not matter whether the sum of a surface's own light, what other
//! surfaces add and what comes through fades as a whole or each part where it is found: at vertices and faces, before it is
//! carried to the pixels, or at the pixels.

use super::display::Linear;
use super::plan::{Cued, Plan};
use crate::render::lens::Lens;
use crate::render::memory::{Holds, Memory, room};
use crate::render::model::{Model, Planes};
use crate::render::raster::{Block, CarriedValues, Coverage, Fragment, ROWS, Rule, Triangles, fragment, interpolate};
use crate::scene::{DepthCueing, FlatAt, Scene};
use fearless_simd::{Level, dispatch};
use glam::{DVec3, Vec3};
use rayon::prelude::*;

/// Points that one task takes.
const POINTS: usize = 4096;

/// The law, and the eye from which depths are measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cue {
    pub law: DepthCueing,
    eye: DVec3,
    forward: DVec3,
}

impl Cue {
    /// The cue of a scene, where the plan has any.
    pub fn for_plan(scene: &Scene, plan: &Plan, lens: &Lens) -> Option<Self> {
        let cue = Self { law: scene.depth_cueing, eye: lens.eye, forward: lens.forward };
        (plan.cued != Cued::Nowhere).then_some(cue)
    }

    /// s0 at a point, world.
    pub fn at(&self, point: DVec3) -> f64 {
        self.law.scale_at((point - self.eye).dot(self.forward))
    }

    /// Idc.
    pub fn color(&self) -> Vec3 {
        self.law.color.as_vec3()
    }

    /// s0 at points given relative to `origin`.
    pub fn scales(&self, origin: DVec3, position: &Planes) -> Vec<f32> {
        let mut scales = vec![0.0; position[0].len()];
        scales.par_chunks_mut(POINTS).enumerate().for_each(|(chunk, scales)| {
            let start = chunk * POINTS;
            let [x, y, z] = position.each_ref().map(|plane| &plane[start..start + scales.len()]);
            for (((scale, x), y), z) in scales.iter_mut().zip(x).zip(y).zip(z) {
                *scale = self.at(origin + Vec3::new(*x, *y, *z).as_dvec3()) as f32;
            }
        });
        scales
    }

    /// Lets the intensities of points fade.
    pub fn fade_points(&self, origin: DVec3, position: &Planes, intensity: &mut Planes) {
        let scales = self.scales(origin, position);
        for (plane, color) in intensity.iter_mut().zip(self.color().to_array()) {
            for (value, s0) in plane.iter_mut().zip(&scales) {
                *value = s0 * *value + (1.0 - s0) * color;
            }
        }
    }
}

/// What the layer reads.
#[derive(Clone, Debug, PartialEq)]
pub struct CueKey {
    pub cue: Cue,
    pub cued: Cued,
    pub lens: Lens,
    pub size: [u32; 2],
    pub model: u64,
    pub coverage: u64,
    pub perspective: bool,
    pub scanline: bool,
    /// Whether the bands' own fragments have the depths, and how a flat polygon is cued.
    pub keeps_fragments: bool,
    pub flat_at: Option<FlatAt>,
}

/// s0 at each pixel that sees the object.
#[derive(Default)]
pub struct CueLayer {
    pub scales: Vec<f32>,
    carried: Vec<Fragment>,
    fragments: Vec<Block>,
}

impl Holds for CueLayer {
    fn memory(&self) -> Memory {
        Memory { vertices: room(&self.carried), triangles: 0, pixels: room(&self.scales) + room(&self.fragments) }
    }
}

/// What the layer is made from.
pub struct Found<'a> {
    pub level: Level,
    pub coverage: Coverage<'a>,
    pub triangles: Triangles<'a>,
    /// The middles of the faces relative to the model's origin, where a flat polygon's s0 is found there.
    pub middles: &'a Planes,
}

impl CueLayer {
    pub fn run(&mut self, key: &CueKey, found: &Found<'_>) {
        let [width, height] = key.size.map(|side| side as usize);
        self.scales.clear();
        self.scales.resize(width * height, 1.0);
        match key.cued {
            Cued::Nowhere => {}
            Cued::AtPixels if key.keeps_fragments => self.by_depth(key, found),
            Cued::AtPoints if key.flat_at.is_some() => self.by_face(key, found),
            Cued::AtPixels | Cued::AtVertices | Cued::AtPoints => self.by_carrying(key, found),
        }
    }

    /// From the depths of the bands' own fragments.
    fn by_depth(&mut self, key: &CueKey, found: &Found<'_>) {
        let (share, bands) = (ROWS * key.size[0] as usize, found.coverage.parts());
        self.scales.par_chunks_mut(share).zip(bands).for_each(|(scales, (_, _, fragments))| {
            for (scales, line) in rows(scales, fragments, key.size[0]) {
                for (x, scale) in scales.iter_mut().enumerate() {
                    *scale = at_key(key, fragment(line, x)[3]);
                }
            }
        });
    }

    /// One for each flat polygon, where its intensity is found.
    fn by_face(&mut self, key: &CueKey, found: &Found<'_>) {
        let model = found.triangles.model;
        let at_centre = key.flat_at == Some(FlatAt::Centre);
        let points = key.cue.scales(model.origin, if at_centre { found.middles } else { &model.position });
        let width = key.size[0] as usize;
        let (share, bands) = (ROWS * width, found.coverage.parts());
        self.scales.par_chunks_mut(share).zip(bands).for_each(|(scales, (_, band, _))| {
            for run in &band.runs {
                let face = found.triangles.face(run.triangle);
                let scale = key.flat_at.map_or(1.0, |at| of_face(at, &points, model, face));
                let row = usize::from(run.row) * width;
                scales[row + usize::from(run.x0)..row + usize::from(run.x1)].fill(scale);
            }
        });
    }

    /// Carried from the vertices as normals and intensities are: s0 itself, or the depth alone.
    fn by_carrying(&mut self, key: &CueKey, found: &Found<'_>) {
        let model = found.triangles.model;
        let by_depth = key.cued == Cued::AtPixels;
        let points =
            if by_depth { vec![0.0; model.padded_len()] } else { key.cue.scales(model.origin, &model.position) };
        let values = CarriedValues { planes: [&points; 3], by_key: key.perspective };
        values.carry(found.level, &mut self.carried, &found.triangles);
        let blocks = Block::count(key.size[0]);
        self.fragments.resize(blocks * key.size[1] as usize, Block::GAP);
        let sources = (found.triangles, &*self.carried);
        let (share, bands) = (ROWS * key.size[0] as usize, found.coverage.parts());
        let parts = self.scales.par_chunks_mut(share).zip(self.fragments.par_chunks_mut(ROWS * blocks));
        parts.zip(bands).for_each(|((scales, fragments), (place, band, _))| {
            let rule = if key.scanline { Rule::Scanline } else { Rule::Steps };
            dispatch!(found.level, simd => interpolate(simd, place, band, sources, rule, fragments));
            for (scales, line) in rows(scales, fragments, key.size[0]) {
                for (x, scale) in scales.iter_mut().enumerate() {
                    let [carried, _, _, depth_key] = fragment(line, x);
                    *scale = match (by_depth, key.perspective) {
                        (true, _) => at_key(key, depth_key),
                        (false, true) => carried / depth_key,
                        (false, false) => carried,
                    };
                }
            }
        });
    }
}

/// The rows of a band, `width` pixels each.
fn rows<'a>(
    scales: &'a mut [f32],
    fragments: &'a [Block],
    width: u32,
) -> impl Iterator<Item = (&'a mut [f32], &'a [Block])> {
    scales.chunks_mut(width as usize).zip(fragments.chunks(Block::count(width)))
}

fn at_key(inputs: &CueKey, key: f32) -> f32 {
    let CueKey { cue, lens, .. } = inputs;
    cue.law.scale_at(lens.depth_from_key(f64::from(key)) * lens.unit) as f32
}

/// What a flat polygon's s0 is, from those of the points where its intensity is found.
fn of_face(at: FlatAt, points: &[f32], model: &Model, face: u32) -> f32 {
    let corners = model.face(face);
    match at {
        FlatAt::Centre => points[face as usize],
        FlatAt::ProvokingVertex => points[corners.first().copied().unwrap_or_default() as usize],
        FlatAt::VertexMean => {
            #[expect(clippy::cast_precision_loss, reason = "a face has few corners")]
            let count = corners.len().max(1) as f32;
            corners.iter().map(|&v| points[v as usize]).sum::<f32>() / count
        }
    }
}

/// Lets the pixels that see the object fade; returns how many overflow, of these or, where `all` count, of the picture.
pub fn fade_pixels(layer: &CueLayer, color: Vec3, all: bool, linear: &mut [Linear]) -> u64 {
    let fade = |([r, g, b, covered], s0): (&mut Linear, &f32)| {
        let (mut pixel, covered) = (Vec3::new(*r, *g, *b), *covered > 0.0);
        if covered {
            pixel = *s0 * pixel + (1.0 - s0) * color;
            (*r, *g, *b) = pixel.into();
        }
        u64::from((covered || all) && pixel.max_element() > 1.0)
    };
    linear.par_iter_mut().zip(&layer.scales).map(fade).sum()
}
