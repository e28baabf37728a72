//! The object: which shape, how finely it is made of polygons, and where its vertex normals come from.

use super::choice::choices;
use super::parameter::{Limits, Slider, table};
use super::shading::{FlatAt, ShadingMode};
use super::symbol::Symbol;
use super::{Scene, Shared};
use glam::DVec3;
use std::path::PathBuf;

/// The slider of a number of divisions; more can be typed.
const DIVISIONS: Slider = Slider::logarithmic(1.0, 512.0).decimals(0);

table! {
    /// The object: which shape, how finely it is made of polygons, and where its vertex normals come from.
    pub struct Object = "object" in object {
        KIND kind: ObjectKind = ObjectKind::Sphere, Choice, "Object kind", "The shape that is drawn.".label("Shape");
        SEGMENTS segments: u32 = 32, Whole(|scene| divisions(scene.object.min_segments()), DIVISIONS), "Segments",
            "The number of polygons round the axis; of a corrugated sheet, its slopes from left to right."
            .symbol(Symbol::Normal).idle(polygons_unused);
        RINGS rings: u32 = 16, Whole(|scene| divisions(scene.object.min_rings()), DIVISIONS), "Rings",
            "The number of polygons along the axis; of a corrugated sheet, the strips of each slope."
            .symbol(Symbol::Normal).idle(polygons_unused);
        NORMALS normals: NormalSource = NormalSource::Averaged, Choice, "Vertex normals",
            "Where the normals at the vertices come from.".label("Normals").symbol(Symbol::Normal).idle(normals_unused);
        WEIGHTING weighting: Weighting = Weighting::Equal, Choice, "Weighting",
            "The weight of each polygon in an averaged vertex normal."
            .label("Weights").symbol(Symbol::Normal).idle(not_averaged);
        PATH path: Option<PathBuf> = None, Other("path", ""), "Path",
            "The model's Wavefront OBJ file, for `kind = \"obj\"`; relative to the scene file.";
        FIT fit: bool = true, Switch, "Fit model",
            "Whether a model is centred and scaled into the unit sphere, or stays as its file has it."
            .label("Fit").idle(|scene, _| (scene.object.kind != ObjectKind::Obj).then_some("The object is not a model from a file"));
        VERTICES vertices: Shared<DVec3> = Shared::default(), Other("list of points", "at most 16384"), "Vertices",
            "The vertices of the scene's own polygons, for `kind = \"polygons\"`.".unit("world units");
        FACES faces: Shared<Shared<u32>> = Shared::default(),
            Other("list of lists of whole numbers", "at most 16384, of 65536 corners in all"), "Faces",
            "The scene's own polygons by the numbers of their vertices, from 0, counter-clockwise seen from outside.";
        /// Of any length but zero.
        VERTEX_NORMALS vertex_normals: Shared<DVec3> = Shared::default(),
            Other("list of directions", "none, or one for each vertex"), "Own vertex normals",
            "The normals of the scene's own vertices, for `normals = \"file\"`.";
    }
}

impl Object {
    /// The finest tessellation in either direction: 4096 × 4096 quads are 33 million triangles.
    pub const MAX_DIVISIONS: u32 = 4096;

    /// Fewest polygons round the axis: fewer than three enclose nothing. A plane's are counted across it, and so are a
    /// corrugated sheet's slopes, at least one up and one down.
    pub fn min_segments(&self) -> u32 {
        match self.kind {
            ObjectKind::Plane => 1,
            ObjectKind::Corrugated => 2,
            _ => 3,
        }
    }

    /// Fewest polygons along the axis: a sphere needs both of its caps, the tube of a torus encloses something.
    pub fn min_rings(&self) -> u32 {
        match self.kind {
            ObjectKind::Sphere => 2,
            ObjectKind::Torus => 3,
            _ => 1,
        }
    }
}

fn divisions(least: u32) -> Limits {
    Limits::new(f64::from(least), f64::from(Object::MAX_DIVISIONS))
}

/// Why the number of polygons makes no difference.
pub fn polygons_unused(scene: &Scene, _: usize) -> Option<&'static str> {
    match scene.object.kind {
        ObjectKind::Obj | ObjectKind::Polygons => {
            Some("The polygons of this object are given one by one")
        }
        _ => (scene.shading.mode == ShadingMode::Exact)
            .then_some("Exact shading draws the true surface, which has no polygons"),
    }
}

fn normals_unused(scene: &Scene, _: usize) -> Option<&'static str> {
    match (scene.shading.mode, scene.shading.flat_at) {
        (ShadingMode::Exact, _) if scene.object.kind.has_surface() => {
            Some("Exact shading uses the true surface's normal at every pixel")
        }
        (ShadingMode::Interpolated, _) | (ShadingMode::Flat, FlatAt::Centre) => {
            Some("This shading uses the polygon's own normal, not vertex normals")
        }
        _ => None,
    }
}

fn not_averaged(scene: &Scene, index: usize) -> Option<&'static str> {
    let other = scene.object.normals != NormalSource::Averaged;
    normals_unused(scene, index).or(other.then_some("The vertex normals are not averaged"))
}

choices! {
    /// The shapes. All but models and polygons fit into the unit sphere about the origin, the plane but for its corners. Their
    /// axis is y, but for the plane and the corrugated sheet, which face +z.
    pub enum ObjectKind {
        /// Radius 1.
        Sphere = "sphere", "sphere", "";
        /// Radius 0.7 of the ring, 0.3 of the tube.
        Torus = "torus", "torus", "";
        /// Radius 0.6, from y = −0.8 to 0.8, with caps.
        Cylinder = "cylinder", "cylinder", "";
        /// Radius 0.8 at y = −0.6, apex at y = 1, with a cap.
        Cone = "cone", "cone", "";
        /// Half an edge is 1/√3.
        Cube = "cube", "cube", "";
        /// The square −1 ≤ x, y ≤ 1 in the plane z = 0, facing +z.
        Plane = "plane", "plane", "";
        /// Newell's teapot.
        Teapot = "teapot", "teapot", "Martin Newell's, made of 32 patches";
        /// A sheet folded to and fro at ridges parallel to y, facing +z: −0.75 ≤ x ≤ 0.75, −0.65 ≤ y ≤ 0.65, between z = −0.1
        /// and 0.1. `segments` slopes, at least 2, the first rising from a trough at its left border.
        Corrugated = "corrugated", "corrugated sheet", "Folded to and fro: undivided slopes average to one normal";
        /// Polygons of the scene itself.
        Polygons = "polygons", "polygons", "The scene's own; their vertices can be dragged in the picture";
        /// A Wavefront OBJ model.
        Obj = "obj", "model from a file", "A Wavefront OBJ file";
    }
}

impl ObjectKind {
    /// Whether it faces +z, so that this is its axis; otherwise that is y.
    pub fn faces_viewer(self) -> bool {
        matches!(self, Self::Plane | Self::Corrugated)
    }

    /// Whether there is a true surface that the polygons stand for. A model and a scene's own polygons are all there is.
    pub fn has_surface(self) -> bool {
        !matches!(self, Self::Obj | Self::Polygons)
    }
}

choices! {
    /// Where vertex normals come from.
    pub enum NormalSource {
        Averaged = "averaged", "averaged", "The mean of the polygons that meet at the vertex";
        Exact = "exact", "true surface's", "Those of the surface that the polygons approximate";
        File = "file", "from the file", "As the model or the scene file gives them; averaged where it gives none";
        Facet = "facet", "each polygon's own", "No smoothing";
    }
}

choices! {
    /// The weight of each polygon in an averaged vertex normal.
    pub enum Weighting {
        Equal = "equal", "equal", "The same for each polygon (Gouraud 1971)";
        Area = "area", "by area", "The larger the polygon, the more";
        Angle = "angle", "by angle", "By the polygon's angle at the vertex (Thürmer and Wüthrich 1998)";
    }
}
