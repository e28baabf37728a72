//! What a renderer's stages hold, added up.

use super::Renderer;
use crate::render::memory::{Holds, Memory, room, room_of_planes};
use crate::render::plan::Per;

impl Renderer {
    /// The memory that is held for the next picture. A model's polygons, which its owner shares, count as well.
    pub fn memory(&self) -> Memory {
        let per = self.drawn.as_ref().map_or(Per::Pixel, |drawn| drawn.plan.per);
        let (placed, clipped, bins) = &self.placed.output;
        let (centres, normals) = &self.faces.output;
        let faces = Memory::of_triangles(room_of_planes(centres) + room_of_planes(normals));
        let intensity = room_of_planes(&self.intensity.output);
        let intensity = if per == Per::Face { Memory::of_triangles(intensity) } else { Memory::of_vertices(intensity) };
        let picture = Memory::of_pixels(room(&self.frame.pixels) + room(&self.linear));
        let stages = [
            self.mesh.output.memory(),
            self.model.output.memory(),
            placed.memory(),
            clipped.memory(),
            bins.memory(),
            faces,
            intensity,
            self.bands.memory(),
            self.cue.output.memory(),
            self.rays.memory(per),
            picture,
        ];
        stages.into_iter().sum()
    }
}
