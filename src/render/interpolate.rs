//! Runs in, fragments out: the normal or the intensity and the depth key at every pixel that sees the object.
//!
//! What is carried from the vertices to the pixels is four numbers: three of a normal or an intensity, and the depth key.
//! For perspective-correct interpolation the three are multiplied by the key (1/depth), which makes them linear in the
//! picture; the kernels that read the fragments divide again where it matters.

use super::clip::{Clipped, Cut};
use super::cover::{Band, BandPlace, Weights};
use super::fragments::{self, Block, Fragment, join};
use super::model::Model;
use super::scan_line::{self, Crossing, Outlines};
use super::transform::{HALF, Placed, SUBPIXELS};
use crate::illumination::Lanes;
use fearless_simd::{Level, dispatch, f32x4, prelude::*};
use rayon::prelude::*;

/// An interpolated normal shorter than this has no direction: its rounding is 10⁻³ of it and more. It is not lengthened to 1,
/// so that normals which cancel out stay near zero.
pub(super) const SHORTEST_NORMAL: f64 = 1e-4;

/// What the vertices are to carry.
#[derive(Clone, Copy)]
pub(super) struct CarriedValues<'a> {
    /// One plane a component.
    pub planes: [&'a [f32]; 3],
    /// Whether they carry them multiplied by the depth key.
    pub by_key: bool,
}

impl CarriedValues<'_> {
    /// Fills `carried` with what each vertex carries, and its depth key.
    pub fn carry(&self, level: Level, carried: &mut Vec<Fragment>, placed: &Placed, clipped: &Clipped) {
        const CHUNK: usize = 4096;
        let count = self.planes[0].len();
        carried.reserve_exact(count.saturating_sub(carried.len()));
        carried.resize(count, [0.0; 4]);
        carried.par_chunks_mut(CHUNK).enumerate().for_each(|(chunk, carried)| {
            dispatch!(level, simd => self.carry_chunk(simd, chunk * CHUNK, carried, &placed.keys));
        });
        for (cut, key) in clipped.cuts.iter().zip(&placed.keys[carried.len()..]) {
            let factor = if self.by_key { *key } else { 1.0 };
            #[expect(clippy::cast_possible_truncation, reason = "back to the precision of the vertices")]
            let [a, b, c] = self.planes.map(|plane| {
                let parts = cut.vertices.iter().zip(cut.weights);
                parts.map(|(&v, w)| f64::from(plane[v as usize]) * w).sum::<f64>() as f32 * factor
            });
            carried.push([a, b, c, *key]);
        }
    }

    #[inline(always)]
    fn carry_chunk<S: Simd>(&self, simd: S, first: usize, carried: &mut [Fragment], keys: &[f32]) {
        let lanes = Lanes::<S>::LEN;
        let [a, b, c] = self.planes;
        let one = Lanes::splat(simd, 1.0);
        for (start, carried) in (first..).step_by(lanes).zip(carried.chunks_exact_mut(lanes)) {
            let key = Lanes::load(simd, &keys[start..]);
            let factor = if self.by_key { key } else { one };
            let values = [
                Lanes::load(simd, &a[start..]) * factor,
                Lanes::load(simd, &b[start..]) * factor,
                Lanes::load(simd, &c[start..]) * factor,
                key,
            ];
            join(simd, &values, carried);
        }
    }
}

/// What the interpolation of a band reads.
#[derive(Clone, Copy)]
pub(super) struct Sources<'a> {
    pub model: &'a Model,
    pub clipped: &'a Clipped,
    pub placed: &'a Placed,
    pub carried: &'a [Fragment],
}

impl Sources<'_> {
    /// Vertices of a triangle of the model or of the clipper.
    #[inline(always)]
    pub fn vertices(&self, triangle: u32) -> [u32; 3] {
        let own = self.model.triangles.len();
        match self.model.triangles.get(triangle as usize) {
            Some(vertices) => *vertices,
            None => self.clipped.triangles[triangle as usize - own],
        }
    }

    /// Whether a triangle is a piece that clipping made.
    #[inline(always)]
    pub fn is_piece(&self, triangle: u32) -> bool {
        triangle as usize >= self.model.triangles.len()
    }

    /// What a vertex is made from that clipping made.
    pub fn cut(&self, vertex: u32) -> Option<&Cut> {
        self.clipped.cuts.get((vertex as usize).wrapping_sub(self.model.padded_len()))
    }

    /// The model's triangle: that which a piece that clipping made is part of.
    #[inline(always)]
    fn whole(&self, triangle: u32) -> usize {
        let (index, own) = (triangle as usize, self.model.triangles.len());
        if index < own { index } else { self.clipped.parents[index - own] as usize }
    }

    /// The face that a triangle belongs to.
    #[inline(always)]
    pub fn face(&self, triangle: u32) -> u32 {
        self.model.faces[self.whole(triangle)]
    }

    /// The vertex that a triangle's face is coloured by where one of them colours it: the face's first.
    #[inline(always)]
    pub fn provoking_vertex(&self, triangle: u32) -> u32 {
        self.model.face(self.face(triangle)).first().copied().unwrap_or_default()
    }
}

/// How values are found inside a polygon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Rule {
    /// Linear along the polygon's edges, then along the scan line.
    Scanline,
    /// Linear over the triangle: by a step from one pixel to the next.
    Steps,
}

/// Linear over the triangle (of values that are linear there: affine ones, or perspective ones times the key).
struct Barycentric<'a, S: Simd> {
    sources: Sources<'a>,
    triangle: u32,
    weights: Weights,
    origin: f32x4<S>,
    d1: f32x4<S>,
    d2: f32x4<S>,
}

impl<'a, S: Simd> Barycentric<'a, S> {
    #[inline(always)]
    fn new(simd: S, sources: Sources<'a>) -> Self {
        let zero = f32x4::splat(simd, 0.0);
        let weights = Weights::new([[0, 0], [1, 0], [0, 1]]);
        Self { sources, triangle: u32::MAX, weights, origin: zero, d1: zero, d2: zero }
    }

    #[inline(always)]
    fn take(&mut self, simd: S, triangle: u32) {
        if triangle != self.triangle {
            self.triangle = triangle;
            let vertices = self.sources.vertices(triangle);
            self.weights = Weights::new(self.sources.placed.corners(vertices));
            let [a, b, c] = vertices;
            self.origin = f32x4::simd_from(simd, self.sources.carried[a as usize]);
            self.d1 = f32x4::simd_from(simd, self.sources.carried[b as usize]) - self.origin;
            self.d2 = f32x4::simd_from(simd, self.sources.carried[c as usize]) - self.origin;
        }
    }

    /// What is carried to where the second and third vertex have these weights.
    #[inline(always)]
    fn at(&self, simd: S, [w1, w2]: [f32; 2]) -> f32x4<S> {
        self.d1.mul_add(f32x4::splat(simd, w1), self.d2.mul_add(f32x4::splat(simd, w2), self.origin))
    }
}

/// Linear along the polygon's edges to P and Q on the scan line, then linear from P to Q (Gouraud 1971).
struct Span {
    /// Places of P and Q.
    x: [f64; 2],
    /// What they carry.
    values: [[f64; 4]; 2],
}

impl Span {
    fn new([p, q]: [&Crossing; 2], carried: &[Fragment]) -> Self {
        let value = |crossing: &Crossing| {
            let [a, b] = crossing.ends.map(|v| carried[v as usize]);
            [0, 1, 2, 3].map(|k| (1.0 - crossing.alpha) * f64::from(a[k]) + crossing.alpha * f64::from(b[k]))
        };
        Self { x: [p.x, q.x], values: [value(p), value(q)] }
    }

    /// From the pixel in column `x` on: the value there, the step to the next pixel, and the column where they end to hold, at
    /// most `end`. Beside P and Q a pixel has their value, so that none leaves the range between them.
    #[expect(clippy::cast_possible_truncation, reason = "fragments are single precision; the guard band bounds places")]
    fn from<S: Simd>(&self, simd: S, x: u16, end: u16) -> (f32x4<S>, f32x4<S>, u16) {
        let ([xp, xq], [p, q]) = (self.x, self.values);
        let pixel = f64::from(SUBPIXELS);
        let centre = f64::from(x) * pixel + f64::from(HALF);
        // A span of no length has one value, P's.
        let per_unit = if xq > xp { 1.0 / (xq - xp) } else { 0.0 };
        let t = ((centre - xp) * per_unit).clamp(0.0, 1.0);
        let start = [0, 1, 2, 3].map(|k| (p[k] + t * (q[k] - p[k])) as f32);
        let step = [0, 1, 2, 3].map(|k| (per_unit * pixel * (q[k] - p[k])) as f32);
        let inside = centre >= xp;
        let last = if inside { ((xq - f64::from(HALF)) / pixel).floor() as i32 } else { 0 };
        let until = last.saturating_add(1).clamp(i32::from(x) + 1, i32::from(end)) as u16;
        (f32x4::simd_from(simd, start), f32x4::simd_from(simd, step), until)
    }
}

/// Fills the fragments of a band, rows of `place.width`. In each row all pixels of the extent are written.
#[inline(always)]
pub(super) fn interpolate<S: Simd>(
    simd: S,
    place: BandPlace,
    band: &Band,
    sources: Sources<'_>,
    rule: Rule,
    fragments: &mut [Block],
) {
    open_gaps(place, band, fragments);
    match rule {
        Rule::Scanline => fill_by_spans(simd, place, band, sources, fragments),
        Rule::Steps => fill_by_steps(simd, place, band, sources, fragments),
    }
}

/// Makes those pixels of the extents gaps that no run may fill.
#[inline(always)]
fn open_gaps(place: BandPlace, band: &Band, fragments: &mut [Block]) {
    let count = Block::count(place.width);
    for (extent, line) in band.extents.iter().zip(fragments.chunks_mut(count)).filter(|(extent, _)| !extent.is_empty())
    {
        let blocks = Block::over(extent);
        if band.sorted {
            fragments::open(&mut line[blocks]);
        } else {
            // Runs leave no gaps between them.
            fragments::open(&mut line[blocks.start..=blocks.start]);
            fragments::open(&mut line[blocks.end - 1..blocks.end]);
        }
    }
}

#[inline(always)]
fn fill_by_steps<S: Simd>(simd: S, place: BandPlace, band: &Band, sources: Sources<'_>, fragments: &mut [Block]) {
    let count = Block::count(place.width);
    let mut rule = Barycentric::new(simd, sources);
    for run in &band.runs {
        rule.take(simd, run.triangle);
        let [s1, s2] = rule.weights.step;
        let start = rule.at(simd, rule.weights.at(i32::from(run.x0), place.y(*run)));
        let step = rule.d1.mul_add(s1, rule.d2 * s2);
        let row = usize::from(run.row) * count;
        let line = &mut fragments[row..row + count];
        fragments::fill(simd, line, usize::from(run.x0)..usize::from(run.x1), start, step);
    }
}

#[inline(always)]
fn fill_by_spans<S: Simd>(simd: S, place: BandPlace, band: &Band, sources: Sources<'_>, fragments: &mut [Block]) {
    let count = Block::count(place.width);
    let mut outlines = Outlines::new(sources, place, band.sorted);
    for run in &band.runs {
        let row = usize::from(run.row) * count;
        let line = &mut fragments[row..row + count];
        let crossings = outlines.crossings(run.triangle, place.y(*run));
        let mut x = run.x0;
        while x < run.x1 {
            let centre = f64::from(i32::from(x) * SUBPIXELS + HALF);
            // A row that sees the polygon crosses its outline.
            let Some(pair) = scan_line::span(crossings, centre) else { break };
            let (start, step, end) = Span::new(pair, sources.carried).from(simd, x, run.x1);
            fragments::fill(simd, line, usize::from(x)..usize::from(end), start, step);
            x = end;
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::properties;
    use crate::render::Renderer;
    use crate::scene::{
        Interpolation, Light, LightKind, NormalSource, ObjectKind, Projection, Rgb, Scene, ShadingMode, Shared,
    };
    use glam::{DVec2, DVec3};
    use proptest::prelude::*;

    const SIDE: u32 = 64;

    /// The linear picture of a polygon whose corners, in pixels, have these intensities.
    fn drawn(corners: &[(DVec2, f64)], interpolation: Interpolation) -> Vec<[f32; 4]> {
        let mut scene = Scene::default();
        (scene.image.size, scene.image.background) = ([SIDE; 2], Rgb::splat(9.0));
        (scene.camera.projection, scene.camera.height) = (Projection::Orthographic, f64::from(SIDE));
        let half = f64::from(SIDE / 2);
        scene.object.kind = ObjectKind::Polygons;
        scene.object.vertices = corners.iter().map(|(at, _)| DVec3::new(at.x - half, half - at.y, 0.0)).collect();
        // Under light along −z, I is the normal's z.
        scene.object.vertex_normals = corners.iter().map(|(_, i)| DVec3::new((1.0 - i * i).sqrt(), 0.0, *i)).collect();
        scene.object.faces = vec![(0..corners.len() as u32).collect::<Shared<u32>>()].into();
        scene.object.normals = NormalSource::File;
        (scene.material.ka, scene.material.kd, scene.material.ks) = (Rgb::ZERO, Rgb::ONE, Rgb::ZERO);
        scene.material.color = Rgb::ONE;
        (scene.shading.mode, scene.shading.interpolation) = (ShadingMode::Gouraud, interpolation);
        scene.lights = vec![Light { kind: LightKind::Directional, direction: DVec3::NEG_Z, ..Light::default() }];
        assert_eq!(scene.validate(), Ok(()));
        Renderer::default().draw_linear(&scene)
    }

    /// The course's formula in a convex quadrilateral, at a pixel's centre.
    fn bilinear(corners: &[(DVec2, f64)], at: DVec2) -> f64 {
        let cuts: Vec<[f64; 2]> = (0..corners.len())
            .filter_map(|k| {
                let ((a, ia), (b, ib)) = (corners[k], corners[(k + 1) % corners.len()]);
                let alpha = (at.y - a.y) / (b.y - a.y);
                (0.0..1.0).contains(&alpha).then_some([a.x + alpha * (b.x - a.x), ia + alpha * (ib - ia)])
            })
            .collect();
        let [p, q] = cuts[..] else { panic!("{cuts:?} at {at}") };
        p[1] + (at.x - p[0]) / (q[0] - p[0]) * (q[1] - p[1])
    }

    /// A place on the grid of the picture, off the rows of the pixels' centres.
    fn place() -> impl Strategy<Value = DVec2> {
        [0..16_000u32, 0..16_000u32].prop_map(|xy| DVec2::from_array(xy.map(|k| (f64::from(k) + 64.0).floor() / 256.0)))
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 64, ..properties::config(file!()) })]

        #[test]
        fn on_a_triangle_the_scan_line_is_affine(corners in prop::collection::vec((place(), 0.0..=1.0f64), 3)) {
            let area = (corners[1].0 - corners[0].0).perp_dot(corners[2].0 - corners[0].0);
            prop_assume!(area.abs() > 20.0);
            let (line, affine) = (drawn(&corners, Interpolation::Scanline), drawn(&corners, Interpolation::Affine));
            for (line, affine) in line.iter().zip(&affine) {
                prop_assert!((line[0] - affine[0]).abs() < 1e-5, "{line:?} {affine:?}");
            }
        }

        #[test]
        fn on_a_quadrilateral_it_is_bilinear(parts in prop::collection::vec((0u32..3000, 0.0..=1.0f64), 4)) {
            // A corner on each side of the picture, counter-clockwise, a quarter of a pixel off the centres' rows.
            let along = |k: usize| f64::from(parts[k].0) / 256.0 + 20.25;
            let at = [
                DVec2::new(1.25, along(0)), DVec2::new(along(1), 62.25), DVec2::new(62.25, along(2)), DVec2::new(along(3), 1.25),
            ];
            prop_assume!([0, 2].iter().all(|&k| (at[k].y.fract() - 0.5).abs() > 0.01));
            let corners: Vec<_> = at.into_iter().zip(parts).map(|(at, (_, i))| (at, i)).collect();
            let picture = drawn(&corners, Interpolation::Scanline);
            for (k, pixel) in (0u32..).zip(&picture).filter(|(_, pixel)| pixel[0] < 2.0) {
                let centre = DVec2::new(f64::from(k % SIDE), f64::from(k / SIDE)) + 0.5;
                let expected = bilinear(&corners, centre);
                prop_assert!((f64::from(pixel[0]) - expected).abs() < 1e-5, "{centre}: {pixel:?}, expected {expected}");
            }
        }
    }
}
