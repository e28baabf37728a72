//! The polygons of what is drawn, before they are given vertex normals.

use crate::geometry::{Mesh, tessellate};
use crate::render::memory::{Holds, Memory, room};
use crate::scene::Object;
use std::sync::{Arc, OnceLock};

/// A model's own polygons, or those of a shape.
///
/// Once a shape's have gone into the arrays that are drawn they would only take room, so they are let go, and made again
/// when somebody asks for them.
#[derive(Default)]
pub struct MeshSource {
    mesh: OnceLock<Arc<Mesh>>,
    /// What they are made from; none for a model.
    shape: Option<Object>,
}

impl MeshSource {
    pub fn of_model(mesh: Arc<Mesh>) -> Self {
        Self { mesh: mesh.into(), shape: None }
    }

    pub fn of_shape(shape: Object) -> Self {
        Self { mesh: OnceLock::new(), shape: Some(shape) }
    }

    pub fn mesh(&self) -> &Arc<Mesh> {
        self.mesh.get_or_init(|| self.shape.as_ref().map_or_else(Arc::default, |shape| Arc::new(tessellate(shape))))
    }

    /// Lets a shape's polygons go, unless somebody shares them.
    pub fn release(&mut self) {
        let shared = self.mesh.get().is_some_and(|mesh| Arc::strong_count(mesh) > 1);
        if self.shape.is_some() && !shared {
            self.mesh.take();
        }
    }
}

impl Holds for MeshSource {
    fn memory(&self) -> Memory {
        let Some(mesh) = self.mesh.get() else { return Memory::default() };
        let vertices = room(&mesh.positions) + room(&mesh.normals) + room(&mesh.mirrored);
        Memory { vertices, triangles: room(&mesh.starts) + room(&mesh.corners), pixels: 0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_let_go_is_made_again() {
        let mut source = MeshSource::of_shape(Object::default());
        let first = Arc::clone(source.mesh());
        source.release();
        assert!(Arc::ptr_eq(&first, source.mesh()), "what is shared is kept");
        let (positions, corners) = (first.positions.clone(), first.corners.clone());
        drop(first);
        assert!(source.memory().vertices > 0);
        source.release();
        assert_eq!(source.memory(), Memory::default());
        assert_eq!((&source.mesh().positions, &source.mesh().corners), (&positions, &corners));
    }

    #[test]
    fn a_model_is_kept() {
        let model = Arc::new(tessellate(&Object::default()));
        let mut source = MeshSource::of_model(Arc::clone(&model));
        source.release();
        assert!(Arc::ptr_eq(&model, source.mesh()));
    }
}
