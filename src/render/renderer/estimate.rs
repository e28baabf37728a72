//! The memory that drawing a scene takes, estimated before any of it is allocated.

use super::plan::Plan;
use super::samples::{MOST_AT_ONCE, rows_at_once};
use crate::geometry::{Mesh, triangles};
use crate::render::face_materials::transmits;
use crate::render::rays::World;
use crate::scene::{AmbientSource, CompareView, NormalSource, ObjectKind, Scene};
use crate::text::text;

/// The bytes for each pixel that is drawn at once with several samples, except for the stored picture; rays take the most.
const PIXEL: u64 = 96;
/// The bytes for each triangle and each vertex while the arrays of a mesh are made from its polygons, which is when they
/// take the most. `tests/cli/scripts/memory.rs` checks that this much is enough.
const TRIANGLE: u64 = 96;
const VERTEX: u64 = 108;
/// The bytes for each triangle where rays are followed: their hierarchy of boxes while it is sorted.
const BOXED: u64 = 144;
/// The bytes for everything else in a process that draws, and in one that draws a picture in strips (`BESIDES_LARGE`).
const BESIDES: u64 = 1 << 25;
const BESIDES_LARGE: u64 = 1 << 28;
/// The bytes below which memory is not checked in advance: if so little cannot be had, nothing can.
const SMALL: u64 = 1 << 24;
/// The most bytes on a web page, whose memory ends at 4 GiB and is never returned, and which stops responding while a mesh is made.
const MOST_ON_PAGE: u64 = 1 << 30;

/// The error of a picture whose memory is not available.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}", self.words())]
pub struct TooLarge {
    size: [u32; 2],
    /// The number of triangles; `None` where the picture itself takes the most.
    triangles: Option<u64>,
    megabytes: u64,
}

impl TooLarge {
    fn words(&self) -> String {
        let ([width, height], megabytes) = (self.size, self.megabytes);
        match self.triangles {
            None => text!(
                "render-too-large",
                width = width,
                height = height,
                megabytes = megabytes
            ),
            Some(triangles) => text!(
                "render-too-many-triangles",
                triangles = triangles,
                megabytes = megabytes
            ),
        }
    }
}

/// Returns the triangles and vertices of `scene` without making them; `model` is the mesh of an object of kind `obj`.
/// Counts of vertices are upper bounds except for a shape's poles.
fn mesh_size(scene: &Scene, model: Option<&Mesh>) -> [u64; 2] {
    let normals = Plan::normals(scene);
    let own = normals == NormalSource::Facet;
    match model {
        Some(model) if scene.object.kind == ObjectKind::Obj => {
            let split = own
                || !model.normals.is_empty() && normals == NormalSource::File
                || !model.face_materials.is_empty()
                || !model.corner_colors.is_empty();
            let vertices = if split {
                model.corners.len()
            } else {
                model.positions.len()
            };
            [model.triangle_count() as u64, vertices as u64]
        }
        // Quadrilaterals: four corners to two triangles, and as many points as quadrilaterals.
        _ => {
            let triangles = triangles(&scene.object);
            let vertices = match scene.object.kind {
                _ if own => 2 * triangles,
                // Two normals at each of its edges.
                ObjectKind::Corrugated => triangles,
                _ => triangles / 2,
            };
            [triangles, vertices]
        }
    }
}

fn mesh_bytes(scene: &Scene, model: Option<&Mesh>) -> u64 {
    let [triangles, vertices] = mesh_size(scene, model);
    let rays = scene.shading.shadows
        || transmits(scene, model)
        || scene.ambient.source != AmbientSource::Constant
        || World::has_surroundings(scene);
    let boxed = if rays { BOXED } else { 0 };
    triangles * (TRIANGLE + boxed) + vertices * VERTEX
}

/// Checks that the memory to draw a valid scene is available. Call it before drawing, since running out of memory ends the process.
pub fn check_memory(scene: &Scene) -> Result<(), TooLarge> {
    check_memory_for(scene, None, 1)
}

/// Checks that the memory for the meshes of a valid scene is available, in whatever size it is drawn.
pub fn check_mesh_memory(scene: &Scene, model: Option<&Mesh>) -> Result<(), TooLarge> {
    let mut small = scene.clone();
    small.image.size = [1, 1];
    check_memory_for(&small, model, 1)
}

/// Checks the memory as [`check_memory`] does, for an object that is a `model` from a file, or for several renderers that
/// keep their meshes at the same time, as in most analyses. With a comparison, the largest of its panes counts.
pub fn check_memory_for(
    scene: &Scene,
    model: Option<&Mesh>,
    renderers: u64,
) -> Result<(), TooLarge> {
    let shown = scene.shown_panes();
    let panes = shown.iter().filter_map(|pane| scene.pane(*pane).ok());
    let largest = panes.max_by_key(|pane| mesh_bytes(pane, model));
    let of_mesh = largest.as_ref().unwrap_or(scene);
    let mesh = renderers * mesh_bytes(of_mesh, model);
    let [width, height] = scene.image.size;
    // Panes are compared before the display, all of their pixels.
    let rows = if scene.compare.view == CompareView::Single {
        rows_at_once(scene)
    } else {
        height
    };
    let row = u64::from(width);
    let large = row * u64::from(height) > MOST_AT_ONCE;
    let besides = if large { BESIDES_LARGE } else { BESIDES };
    let stored = row * u64::from(height) * size_of::<[u8; 4]>() as u64;
    let picture = stored + row * u64::from(rows) * PIXEL;
    if mesh + picture <= SMALL || can_be_had(mesh + picture + besides) {
        return Ok(());
    }
    Err(TooLarge {
        size: scene.image.size,
        triangles: (mesh > picture).then(|| mesh_size(of_mesh, model)[0]),
        megabytes: (mesh + picture + besides) >> 20,
    })
}

/// Returns whether this many bytes are available.
pub fn can_be_had(bytes: u64) -> bool {
    if cfg!(target_arch = "wasm32") && bytes > MOST_ON_PAGE {
        return false;
    }
    usize::try_from(bytes).is_ok_and(|bytes| Vec::<u8>::new().try_reserve_exact(bytes).is_ok())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::tessellate;
    use crate::scene::{ObjectKind, ShadingMode};

    #[test]
    fn triangles_and_vertices_are_known_before_they_are_made() {
        for kind in [
            ObjectKind::Sphere,
            ObjectKind::Torus,
            ObjectKind::Cylinder,
            ObjectKind::Cone,
            ObjectKind::Cube,
            ObjectKind::Plane,
            ObjectKind::Teapot,
            ObjectKind::Corrugated,
        ] {
            for mode in [ShadingMode::Phong, ShadingMode::Interpolated] {
                let mut scene = Scene::default();
                scene.object.kind = kind;
                (scene.object.segments, scene.object.rings) = (96, 64);
                scene.shading.mode = mode;
                let normals = Plan::normals(&scene);
                let mesh = tessellate(&scene.object);
                let made = mesh.with_vertex_normals(normals, scene.object.weighting);
                let [triangles, vertices] = mesh_size(&scene, None);
                assert_eq!(triangles, made.triangle_count() as u64, "{kind:?}");
                let made = made.positions.len() as f64;
                let share = made / vertices as f64;
                assert!((0.9..1.1).contains(&share), "{kind:?}, {mode:?}: {share}");
                // A model of the same mesh takes no less.
                scene.object.kind = ObjectKind::Obj;
                let [of_model, corners] = mesh_size(&scene, Some(&mesh));
                assert_eq!(of_model, triangles);
                assert!(corners as f64 >= made, "{kind:?}, {mode:?}");
            }
        }
    }

    #[test]
    fn what_cannot_be_had_is_refused_with_the_figure() {
        assert!(can_be_had(SMALL));
        assert!(!can_be_had(1 << 50), "a petabyte");
        let mut scene = Scene::default();
        assert_eq!(check_memory_for(&scene, None, 1), Ok(()));
        // As many copies as no machine holds.
        let error = check_memory_for(&scene, None, 1 << 40).expect_err("too many");
        let triangles = triangles(&scene.object);
        assert!(
            error
                .to_string()
                .starts_with(&format!("{triangles} triangles need about"))
        );
        scene.compare.view = CompareView::Panes;
        assert_eq!(check_memory(&scene), Ok(()));
    }
}
