//! The five defects of interpolated shading, each as a number that measures it in a scene.
//!
//! Foley, van Dam, Feiner and Hughes (1990, section 16.2.6) name them: the polygonal silhouette, the perspective distortion,
//! the dependence on orientation, the problems at shared vertices, and unrepresentative vertex normals. None is made up here:
//! each is measured on what the engine draws.

mod orientation;
mod overlay;
mod perspective;
mod plots;
mod shared;
mod silhouette;
mod vertex_normals;

pub use orientation::Orientation;
pub use overlay::{DefectMark, defect_marks, draw_defects};
pub use perspective::PerspectiveDistortion;
pub use plots::defect_plots;
pub use shared::SharedVertices;
pub use silhouette::Silhouette;
pub use vertex_normals::VertexNormals;

use crate::geometry::Mesh;
use crate::render::Renderer;
use crate::scene::{Compare, Scene, ShadingMode};
use rayon::prelude::*;
use serde::Serialize;
use std::sync::atomic::{AtomicBool, Ordering};

/// A measurement, or why there is nothing to measure.
pub type Finding<T> = Result<T, &'static str>;

/// What was measured in a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Defects {
    pub silhouette: Finding<Silhouette>,
    pub perspective: Finding<PerspectiveDistortion>,
    pub orientation: Finding<Orientation>,
    pub shared_vertices: Finding<SharedVertices>,
    pub vertex_normals: Finding<VertexNormals>,
}

/// Why there is no measurement after a stop.
const STOPPED: &str = "stopped";

/// Measures all five in `scene`, as its picture of `scene.image.size` has them; the dependence on orientation at what `pixel`
/// sees. `renderer` holds the model, if there is one, and draws other pictures in between.
pub fn defects(renderer: &mut Renderer, scene: &Scene, pixel: [u32; 2]) -> Defects {
    defects_with_progress(renderer, scene, pixel, &mut |_| {}, &AtomicBool::new(false))
}

/// The same, telling `progress` from 0 to 1 how far it is. What is not measured yet when `cancel` is set stays missing.
pub fn defects_with_progress(
    renderer: &mut Renderer,
    scene: &Scene,
    pixel: [u32; 2],
    progress: &mut dyn FnMut(f32),
    cancel: &AtomicBool,
) -> Defects {
    let alone = &Scene { compare: Compare::default(), ..scene.clone() };
    let silhouette = unless(cancel, || silhouette::measure(renderer, alone, cancel));
    progress(0.3);
    let perspective = unless(cancel, || perspective::measure(renderer, alone));
    progress(0.4);
    let orientation = unless(cancel, || orientation::measure(renderer, alone, pixel));
    progress(0.5);
    let along = &mut |share: f32| progress(0.5 + 0.3 * share);
    let shared_vertices = unless(cancel, || shared::measure(renderer, alone, along, cancel));
    progress(0.8);
    let vertex_normals = unless(cancel, || vertex_normals::measure(renderer, alone));
    progress(1.0);
    Defects { silhouette, perspective, orientation, shared_vertices, vertex_normals }
}

fn unless<T>(cancel: &AtomicBool, measure: impl FnOnce() -> Finding<T>) -> Finding<T> {
    if cancel.load(Ordering::Relaxed) { Err(STOPPED) } else { measure() }
}

/// The edges that exactly one of the faces that `counts` has, as pairs of points, sorted.
fn edges_of_one(mesh: &Mesh, counts: impl Fn(usize) -> bool + Sync) -> Vec<[u32; 2]> {
    let edges = |f: usize| {
        let face = mesh.face(f);
        let pairs = face.iter().zip(face.iter().cycle().skip(1));
        pairs.map(|(a, b)| [a.position.min(b.position), a.position.max(b.position)])
    };
    let faces = (0..mesh.face_count()).into_par_iter().filter(|f| counts(*f));
    let mut all: Vec<[u32; 2]> = faces.flat_map_iter(edges).collect();
    all.par_sort_unstable();
    all.chunk_by(|a, b| a == b).filter(|alike| alike.len() == 1).map(|alike| alike[0]).collect()
}

/// Why nothing is interpolated in a scene, where nothing is.
fn nothing_interpolated(scene: &Scene) -> Option<&'static str> {
    match scene.shading.mode {
        ShadingMode::Flat => Some("flat shading interpolates nothing"),
        ShadingMode::Exact => Some("exact shading interpolates nothing"),
        ShadingMode::Interpolated | ShadingMode::Gouraud | ShadingMode::Phong => None,
    }
}

/// A measurement as it is written into JSON.
#[derive(Serialize)]
#[serde(untagged)]
enum Written<'a, T> {
    Measured(&'a T),
    Missing { missing: &'static str },
}

impl<'a, T> From<&'a Finding<T>> for Written<'a, T> {
    fn from(finding: &'a Finding<T>) -> Self {
        match finding {
            Ok(measured) => Self::Measured(measured),
            Err(missing) => Self::Missing { missing },
        }
    }
}

impl Serialize for Defects {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        use serde::ser::SerializeMap;
        let Self { silhouette, perspective, orientation, shared_vertices, vertex_normals } = self;
        let mut map = serializer.serialize_map(Some(5))?;
        map.serialize_entry("silhouette", &Written::from(silhouette))?;
        map.serialize_entry("perspective", &Written::from(perspective))?;
        map.serialize_entry("orientation", &Written::from(orientation))?;
        map.serialize_entry("shared_vertices", &Written::from(shared_vertices))?;
        map.serialize_entry("vertex_normals", &Written::from(vertex_normals))?;
        map.end()
    }
}
