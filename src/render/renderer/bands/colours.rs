//! Pixels whose colours come from vertices or faces: what flat shading fills them with, and those of points where the scene's own law
//! is undefined.

use super::BandPainter;
use crate::render::raster::{Band, Block, fragment};
use crate::render::renderer::plan::Inputs;
use crate::render::renderer::points::PointIntensities;
use crate::render::renderer::shade::Carried;
use crate::render::renderer::target::Target;
use crate::scene::FlatAt;
use fearless_simd::{Simd, dispatch};
use std::ops::Range;
use std::slice;

impl BandPainter<'_> {
    /// Fills each run with its face's colour, for flat shading.
    #[inline(always)]
    pub(super) fn fill_faces<S: Simd>(
        &self,
        simd: S,
        band: &Band,
        columns: &Range<usize>,
        intensity: &PointIntensities,
        mut target: impl Target,
    ) -> u64 {
        let width = band.place.width as usize;
        let inside = |x: usize| x.clamp(columns.start, columns.end);
        for (row, extent) in band.extents.iter().enumerate() {
            let line = row * width;
            // There are no gaps between runs that are not sorted.
            if band.sorted || extent.is_empty() {
                target.clear(line + columns.start..line + columns.end);
            } else {
                target.clear(line + columns.start..line + inside(extent.start as usize));
                target.clear(line + inside(extent.end as usize)..line + columns.end);
            }
        }
        let mut over = 0;
        for (face, runs) in band.runs_by_face(&self.inputs.triangles) {
            let points = self.points_of(&face);
            let color = intensity.mean(points);
            let ink = target.ink(simd, color, intensity.is_undefined_at(points));
            for run in runs {
                let row = usize::from(run.row) * width;
                let [x0, x1] = [run.x0, run.x1].map(|x| row + inside(usize::from(x)));
                over += target.fill(x0..x1, ink);
            }
        }
        over
    }

    /// Returns the points whose mean is the colour of a face.
    #[inline(always)]
    fn points_of<'b>(&'b self, face: &'b u32) -> &'b [u32] {
        let corners = self.inputs.triangles.model.face(*face);
        match self.inputs.scene.shading.flat_at {
            FlatAt::Centre => slice::from_ref(face),
            FlatAt::ProvokingVertex => corners.get(..1).unwrap_or_default(),
            FlatAt::VertexMean => corners,
        }
    }

    /// Marks the pixels to which a vertex carries an intensity where the scene's own law is undefined; returns how many of them do not
    /// overflow besides.
    pub(super) fn mark(
        &self,
        (band, fragments): (&Band, &[Block]),
        columns: &Range<usize>,
        carried: Carried,
        intensity: &PointIntensities,
        target: &mut impl Target,
    ) -> u64 {
        if intensity.undefined.is_empty() {
            return 0;
        }
        let Inputs {
            level,
            plan,
            triangles,
            ..
        } = self.inputs;
        let (width, blocks) = (band.place.width as usize, Block::count(band.place.width));
        let mut count = 0;
        for run in &band.runs {
            // A scan line goes from edge to edge of the whole polygon.
            let vertices = if plan.scanline {
                triangles.model.face(triangles.face(run.triangle))
            } else {
                &triangles.model.triangles[triangles.whole(run.triangle)]
            };
            if !intensity.is_undefined_at(vertices) {
                continue;
            }
            let row = usize::from(run.row);
            let line = &fragments[row * blocks..][..blocks];
            for x in usize::from(run.x0).max(columns.start)..usize::from(run.x1).min(columns.end) {
                let [r, g, b, key] = fragment(line, x);
                let color = carried.color([r, g, b], key);
                let at = row * width + x;
                let [(_, overflows), ink] = [false, true]
                    .map(|undefined| dispatch!(level, simd => target.ink(simd, color, undefined)));
                target.fill(at..at + 1, ink);
                count += u64::from(!overflows);
            }
        }
        count
    }
}
