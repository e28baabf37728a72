//! The five defects of interpolated shading, each as a number that measures it in a scene.
//!
//! Foley, van Dam, Feiner and Hughes (1990, section 16.2.6) name them: the polygonal silhouette, the perspective distortion,
//! the dependence on orientation, the problems at shared vertices, and unrepresentative vertex normals. None is made up here:
//! each is measured on what the engine draws.

mod orientation;
mod perspective;
mod plots;
mod shared;
mod silhouette;
mod vertex_normals;

pub use orientation::Orientation;
pub use perspective::PerspectiveDistortion;
pub use plots::defect_plots;
pub use shared::SharedVertices;
pub use silhouette::Silhouette;
pub use vertex_normals::VertexNormals;

use crate::render::Renderer;
use crate::scene::{Compare, Scene, ShadingMode};
use serde::Serialize;

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

/// Measures all five in `scene`, as its picture of `scene.image.size` has them; the dependence on orientation at what `pixel`
/// sees. `renderer` holds the model, if there is one, and draws other pictures in between.
pub fn defects(renderer: &mut Renderer, scene: &Scene, pixel: [u32; 2]) -> Defects {
    let alone = Scene { compare: Compare::default(), ..scene.clone() };
    Defects {
        silhouette: silhouette::measure(renderer, &alone),
        perspective: perspective::measure(renderer, &alone),
        orientation: orientation::measure(renderer, &alone, pixel),
        shared_vertices: shared::measure(renderer, &alone),
        vertex_normals: vertex_normals::measure(renderer, &alone),
    }
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
