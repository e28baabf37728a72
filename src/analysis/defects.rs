//! The five defects of interpolated shading, each as a number that measures it in a scene.
//!
//! Foley, van Dam, Feiner and Hughes (1990, section 16.2.6) name them: the polygonal silhouette, the perspective distortion,
//! the dependence on orientation, the problems at shared vertices, and unrepresentative vertex normals. None is made up here:
//! each is measured on what the engine draws.

mod orientation;
mod overlay;
mod perspective;
mod plots;
mod report;
mod shared;
mod silhouette;
mod vertex_normals;

pub use orientation::Orientation;
pub use overlay::{DefectMark, defect_marks, draw_defects};
pub use perspective::PerspectiveDistortion;
pub use plots::defect_plots;
pub use report::{DEFECTS, Defect, DefectsQuestion, MeasuredDefects};
pub use shared::SharedVertices;
pub use silhouette::Silhouette;
pub use vertex_normals::VertexNormals;

use super::question::{Watch, unwatched};
use crate::geometry::Mesh;
use crate::render::Renderer;
use crate::scene::{Compare, Scene, ShadingMode};
use rayon::prelude::*;
use serde::Serialize;
use serde_json::json;

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
    defects_with_progress(renderer, scene, pixel, &unwatched)
}

/// The same with somebody who waits; what is not measured when they stop stays missing.
pub fn defects_with_progress(
    renderer: &mut Renderer,
    scene: &Scene,
    pixel: [u32; 2],
    watch: &dyn Watch<()>,
) -> Defects {
    let alone = &Scene { compare: Compare::default(), ..scene.clone() };
    let silhouette = silhouette::measure(renderer, alone, watch);
    let perspective = if watch.at(0.3) { perspective::measure(renderer, alone) } else { Err(STOPPED) };
    let orientation = if watch.at(0.4) { orientation::measure(renderer, alone, pixel) } else { Err(STOPPED) };
    let along = |share: f32| watch.at(0.5 + 0.3 * share);
    let shared_vertices = if along(0.0) { shared::measure(renderer, alone, &along) } else { Err(STOPPED) };
    let vertex_normals = if watch.at(0.8) { vertex_normals::measure(renderer, alone) } else { Err(STOPPED) };
    watch.at(1.0);
    Defects { silhouette, perspective, orientation, shared_vertices, vertex_normals }
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

/// A missing measurement is written as the reason.
impl Serialize for Defects {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        fn entry<T: Serialize>(finding: &Finding<T>) -> serde_json::Value {
            finding.as_ref().map_or_else(|missing| json!({ "missing": missing }), |measured| json!(measured))
        }
        let Self { silhouette, perspective, orientation, shared_vertices, vertex_normals } = self;
        json!({
            "silhouette": entry(silhouette),
            "perspective": entry(perspective),
            "orientation": entry(orientation),
            "shared_vertices": entry(shared_vertices),
            "vertex_normals": entry(vertex_normals),
        })
        .serialize(serializer)
    }
}
