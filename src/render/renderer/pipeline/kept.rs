//! The outputs that a renderer keeps from one picture to the next: discarding them, freeing their memory, and counting it.

use super::{Picture, Renderer};
use crate::render::node::{Memory, capacity, capacity_of_planes};
use crate::render::raster::BAND;
use crate::render::renderer::bands::Canvas;
use crate::render::renderer::frame::Frame;
use crate::render::renderer::plan::Per;
use std::mem::take;

/// The part of the pixels or triangles that buffers were made for below which they are freed.
const LEAST_USE: f64 = 0.5;

impl Renderer {
    /// Discards every output but the geometry's: the next picture is transformed, covered and shaded anew.
    pub fn redraw(&mut self) {
        self.placed.forget();
        self.points.forget();
        self.bands.forget();
        self.interpolated.forget();
        self.rays.forget();
        self.cue.forget();
        self.picture.forget();
    }

    /// Returns the pixels of the last picture, and the triangles of the model.
    pub(super) fn extent(&self) -> [f64; 2] {
        let Frame { width, height, .. } = self.picture.output.frame;
        [
            f64::from(width) * f64::from(height),
            self.model.output.triangles.len() as f64,
        ]
    }

    /// Frees all buffers but the geometry's, where a picture of `size` uses little of a picture with the extent `before`.
    pub(super) fn give_back_unused(&mut self, before: [f64; 2], size: [u32; 2]) {
        let [width, height] = size.map(f64::from);
        let [_, triangles] = self.extent();
        let wanted = [width * height, triangles];
        if (0..2).all(|of| wanted[of] >= LEAST_USE * before[of]) {
            return;
        }
        let all = take(self);
        *self = Self {
            level: all.level,
            clock: all.clock,
            given: all.given,
            mesh: all.mesh,
            model: all.model,
            surface: all.surface,
            keeps_linear: all.keeps_linear,
            leaves_nothing_out: all.leaves_nothing_out,
            coarser: all.coarser,
            shading_time: all.shading_time,
            report: all.report,
            ..Self::default()
        };
    }

    /// Returns the memory held for the next picture. A model's polygons, which its owner shares, count as well.
    pub fn memory(&self) -> Memory {
        let per = self.plan().map_or(Per::Pixel, |plan| plan.per);
        let Picture { frame, linear, .. } = &self.picture.output;
        let mut memory = Memory::default();
        self.mesh.output.count(&mut memory);
        self.model.output.count(&mut memory);
        self.placed.output.count(&mut memory);
        self.interpolated.output.count(&mut memory);
        self.cue.output.count(&mut memory);
        self.rays.count(per, &mut memory);
        memory.triangles += self
            .faces
            .output
            .iter()
            .map(capacity_of_planes)
            .sum::<u64>();
        let points = if per == Per::Face {
            &mut memory.triangles
        } else {
            &mut memory.vertices
        };
        *points += self
            .points
            .output
            .iter()
            .map(|own| capacity_of_planes(&own.planes) + capacity(&own.undefined))
            .sum::<u64>();
        // Each run has a pixel of its own at least, so that runs grow with the pixels.
        memory.pixels += self
            .bands
            .output
            .iter()
            .map(|band| capacity(&band.runs) + capacity(&band.extents))
            .sum::<u64>();
        memory.pixels += capacity(&frame.pixels) + capacity(linear);
        memory
    }
}

impl Picture {
    /// Begins another picture of that size.
    pub(super) fn begin(&mut self, [width, height]: [u32; 2]) {
        let frame = &mut self.frame;
        if [frame.width, frame.height] != [width, height] {
            frame.pixels.clear();
        }
        self.pending.clear();
        self.pending.resize(height.div_ceil(BAND) as usize, true);
        self.tally = [0; 2];
    }

    /// Returns whether there are bands that are yet to be shaded.
    pub(super) fn is_pending(&self) -> bool {
        self.pending.contains(&true)
    }

    /// Gives the buffers their size; frees the memory of a linear picture that is not wanted.
    pub(super) fn canvas(&mut self, [width, height]: [u32; 2], whole: bool) -> Canvas<'_> {
        let Self {
            frame,
            linear,
            pending,
            ..
        } = self;
        let pixels = width as usize * height as usize;
        (frame.width, frame.height) = (width, height);
        frame.pixels.resize(pixels, [0; 4]);
        if !whole {
            *linear = Vec::new();
        }
        linear.resize(if whole { pixels } else { 0 }, [0.0; 4]);
        Canvas {
            pixels: &mut frame.pixels,
            linear,
            pending,
        }
    }
}
