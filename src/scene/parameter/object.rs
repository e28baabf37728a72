//! The object: its shape, its polygons and its vertex normals.

use super::super::{FlatAt, NormalSource, Object, ObjectKind, Scene, ShadingMode};
use super::access::access;
use super::{Kind, Limits, Parameter, Slider, Symbol};

pub(super) const ALL: &[&Parameter] =
    &[&KIND, &SEGMENTS, &RINGS, &NORMALS, &WEIGHTING, &PATH, &FIT, &VERTICES, &FACES, &VERTEX_NORMALS];

pub static KIND: Parameter =
    Parameter::new("object.kind", "Object kind", Kind::Choice(&access!(object.kind)), "The shape that is drawn.")
        .label("Shape");

/// The slider of a number of divisions; more can be typed.
const DIVISIONS: Slider = Slider::logarithmic(1.0, 512.0).decimals(0);

pub static SEGMENTS: Parameter = Parameter::new(
    "object.segments",
    "Segments",
    Kind::Whole {
        at: access!(object.segments),
        limits: |scene| divisions(scene.object.min_segments()),
        slider: DIVISIONS,
    },
    "The number of polygons round the axis; of a corrugated sheet, its slopes from left to right.",
)
.symbol(Symbol::Normal)
.idle(polygons_unused);

pub static RINGS: Parameter = Parameter::new(
    "object.rings",
    "Rings",
    Kind::Whole { at: access!(object.rings), limits: |scene| divisions(scene.object.min_rings()), slider: DIVISIONS },
    "The number of polygons along the axis; of a corrugated sheet, the strips of each slope.",
)
.symbol(Symbol::Normal)
.idle(polygons_unused);

fn divisions(least: u32) -> Limits {
    Limits::new(f64::from(least), f64::from(Object::MAX_DIVISIONS))
}

/// Why the number of polygons makes no difference.
pub fn polygons_unused(scene: &Scene, _: usize) -> Option<&'static str> {
    match scene.object.kind {
        ObjectKind::Obj | ObjectKind::Polygons => Some("The polygons of this object are given one by one"),
        _ => (scene.shading.mode == ShadingMode::Exact)
            .then_some("Exact shading draws the true surface, which has no polygons"),
    }
}

pub static NORMALS: Parameter = Parameter::new(
    "object.normals",
    "Vertex normals",
    Kind::Choice(&access!(object.normals)),
    "Where the normals at the vertices come from.",
)
.label("Normals")
.symbol(Symbol::Normal)
.idle(normals_unused);

pub static WEIGHTING: Parameter = Parameter::new(
    "object.weighting",
    "Weighting",
    Kind::Choice(&access!(object.weighting)),
    "The weight of each polygon in an averaged vertex normal.",
)
.label("Weights")
.symbol(Symbol::Normal)
.idle(|scene, index| {
    normals_unused(scene, index)
        .or((scene.object.normals != NormalSource::Averaged).then_some("The vertex normals are not averaged"))
});

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

static PATH: Parameter = Parameter::new(
    "object.path",
    "Path",
    Kind::Other { at: &access!(object.path), kind: "path", limits: "" },
    "The model's Wavefront OBJ file, for `kind = \"obj\"`; relative to the scene file.",
);

pub static FIT: Parameter = Parameter::new(
    "object.fit",
    "Fit model",
    Kind::Switch(access!(object.fit)),
    "Whether a model is centred and scaled into the unit sphere, or stays as its file has it.",
)
.label("Fit")
.idle(|scene, _| (scene.object.kind != ObjectKind::Obj).then_some("The object is not a model from a file"));

static VERTICES: Parameter = Parameter::new(
    "object.vertices",
    "Vertices",
    Kind::Other { at: &access!(object.vertices), kind: "list of points", limits: "at most 16384" },
    "The vertices of the scene's own polygons, for `kind = \"polygons\"`.",
)
.unit("world units");

static FACES: Parameter = Parameter::new(
    "object.faces",
    "Faces",
    Kind::Other {
        at: &access!(object.faces),
        kind: "list of lists of whole numbers",
        limits: "at most 16384, of 65536 corners in all",
    },
    "The scene's own polygons by the numbers of their vertices, from 0, counter-clockwise seen from outside.",
);

static VERTEX_NORMALS: Parameter = Parameter::new(
    "object.vertex_normals",
    "Own vertex normals",
    Kind::Other {
        at: &access!(object.vertex_normals),
        kind: "list of directions",
        limits: "none, or one for each vertex",
    },
    "The normals of the scene's own vertices, for `normals = \"file\"`.",
);
