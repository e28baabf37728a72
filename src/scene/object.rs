//! The object: its shape, the fineness of its polygons, and the source of its vertex normals.

use super::Shared;
use super::choice::choices;
use super::material_override::MaterialOverride;
use super::parameter::{Limits, Reason, Slider, Unit, at_most, table};
use super::shading::{FlatAt, ShadingMode};
use super::symbol::Symbol;
use crate::text::text;
use glam::DVec3;
use std::path::PathBuf;

/// The slider of a number of divisions; larger numbers can be typed.
const DIVISIONS: Slider = Slider::logarithmic(1.0, 512.0).decimals(0);

table! {
    /// The object: its shape, the fineness of its polygons, and the source of its vertex normals.
    pub struct Object = [object] in object with (/// `[[object.material]]`: changes of the model's materials, for the kind `obj`; at most [`Self::MAX_MATERIALS`].
        materials: Vec<MaterialOverride> = vec![]) {
        /// The shape.
        KIND kind: ObjectKind = ObjectKind::Sphere, Choice;
        /// Polygons round the axis, 3 to 4096 (a plane's from 1, a corrugated sheet's from 2).
        SEGMENTS segments: u32 = 32, Whole(|scene| divisions(scene.object.min_segments()), DIVISIONS)
            .symbol(Symbol::Normal).idle_if(&[OWN_POLYGONS, NO_POLYGONS]);
        /// Polygons along the axis, up to 4096; [`Self::min_rings`] has the fewest.
        RINGS rings: u32 = 16, Whole(|scene| divisions(scene.object.min_rings()), DIVISIONS)
            .symbol(Symbol::Normal).idle_if(&[OWN_POLYGONS, NO_POLYGONS]);
        /// The source of the vertex normals.
        NORMALS normals: NormalSource = NormalSource::Averaged, Choice.symbol(Symbol::Normal).idle_if(&[TRUE_NORMALS, POLYGON_NORMALS]);
        /// Weight of each polygon in an averaged normal.
        WEIGHTING weighting: Weighting = Weighting::Equal, Choice.symbol(Symbol::Normal).idle_if(&[TRUE_NORMALS, POLYGON_NORMALS, NOT_AVERAGED]);
        /// Wavefront OBJ file of a model, for the kind `obj`.
        PATH path: Option<PathBuf> = None, Other("kind-path", String::new);
        /// A switch that centres a model and scales it into the unit sphere.
        FIT fit: bool = true, Switch.idle_if(&[NO_MODEL]);
        /// Vertices of the scene's own polygons, world, for the kind `polygons`; at most 16384.
        VERTICES vertices: Shared<DVec3> = Shared::default(), Other("kind-points", || at_most(Object::MAX_POLYGONS))
            .measured_in(Unit::World);
        /// The scene's own polygons: numbers of vertices from 0, counter-clockwise from outside.
        FACES faces: Shared<Shared<u32>> = Shared::default(),
            Other("kind-faces", || text!("range-faces", count = Object::MAX_POLYGONS, corners = Object::MAX_ALL_CORNERS));
        /// Normals at the scene's own vertices, none or one each, for `normals = "file"`. Of any length but zero.
        VERTEX_NORMALS vertex_normals: Shared<DVec3> = Shared::default(),
            Other("kind-directions", || text!("range-vertex-normals").to_owned());
    }
}

impl Object {
    /// The most divisions in either direction: 4096 × 4096 quads are 33 million triangles.
    pub const MAX_DIVISIONS: u32 = 4096;

    /// Returns the source of its vertex normals: that of `normals` where it exists. A built-in shape has no normals from a
    /// file, so they are averaged; a model or a scene's polygons have no true surface behind them.
    pub fn normal_source(&self) -> NormalSource {
        match self.normals {
            NormalSource::File if self.kind.has_surface() => NormalSource::Averaged,
            NormalSource::Exact if !self.kind.has_surface() => NormalSource::File,
            source => source,
        }
    }

    /// Returns whether vertex normals from this source may be averaged over faces: a true surface has its own everywhere,
    /// but a model or a scene's polygons may lack some.
    pub fn averages(&self, source: NormalSource) -> bool {
        match source {
            NormalSource::Averaged | NormalSource::File => true,
            NormalSource::Exact => !self.kind.has_surface(),
            NormalSource::Facet => false,
        }
    }

    /// Returns the fewest polygons round the axis: fewer than three enclose nothing. A plane's are counted across it, and
    /// so are a corrugated sheet's slopes, at least one up and one down.
    pub fn min_segments(&self) -> u32 {
        match self.kind {
            ObjectKind::Plane => 1,
            ObjectKind::Corrugated => 2,
            _ => 3,
        }
    }

    /// Returns the fewest polygons along the axis: a sphere needs both of its caps, and the tube of a torus must enclose something.
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

const OWN_POLYGONS: Reason = (|scene, _| scene.object.kind.is_given(), "idle-own-polygons");
const NO_POLYGONS: Reason = (
    |scene, _| scene.shading.mode == ShadingMode::Exact,
    "idle-exact-no-polygons",
);
const TRUE_NORMALS: Reason = (
    |scene, _| scene.shading.mode == ShadingMode::Exact && scene.object.kind.has_surface(),
    "idle-exact-normals",
);
const POLYGON_NORMALS: Reason = (
    |scene, _| match scene.shading.mode {
        ShadingMode::Flat => scene.shading.flat_at == FlatAt::Centre,
        mode => mode == ShadingMode::Interpolated,
    },
    "idle-polygon-normal",
);
const NOT_AVERAGED: Reason = (
    |scene, _| !scene.object.averages(scene.object.normals),
    "idle-not-averaged",
);
const NO_MODEL: Reason = (|scene, _| !scene.object.kind.is_model(), "idle-no-model");

choices! {
    /// The shapes. All but models and polygons fit into the unit sphere about the origin, except for the plane's corners.
    /// Their axis is y; that of the plane and the corrugated sheet, which face +z, is z.
    pub enum ObjectKind = "object-kind" {
        /// A sphere of radius 1.
        Sphere = "sphere";
        /// A torus with a ring of radius 0.7 and a tube of radius 0.3.
        Torus = "torus";
        /// A cylinder of radius 0.6, from y = −0.8 to 0.8, with caps.
        Cylinder = "cylinder";
        /// A cone of radius 0.8 at y = −0.6, with its apex at y = 1 and a cap.
        Cone = "cone";
        /// A cube with edges of length 2/√3.
        Cube = "cube";
        /// The square −1 ≤ x, y ≤ 1 in the plane z = 0, facing +z.
        Plane = "plane";
        /// Newell's teapot.
        Teapot = "teapot";
        /// A sheet folded to and fro at ridges parallel to y, facing +z: −0.75 ≤ x ≤ 0.75, −0.65 ≤ y ≤ 0.65, between z = −0.1
        /// and 0.1. `segments` slopes, at least 2, the first rising from a trough at its left border.
        Corrugated = "corrugated";
        /// Three balls of radius 0.31 side by side, each with a material of its own: `assets/balls`, read as a model is.
        Balls = "balls";
        /// The polygons listed in the scene.
        Polygons = "polygons";
        /// A Wavefront OBJ model.
        Obj = "obj";
    }
}

impl ObjectKind {
    /// Returns whether it faces +z, so that z is its axis; otherwise y is.
    pub fn faces_viewer(self) -> bool {
        matches!(self, Self::Plane | Self::Corrugated)
    }

    /// Returns whether it is a model from a file.
    pub fn is_model(self) -> bool {
        self == Self::Obj
    }

    /// Returns whether its faces may have materials of their own.
    pub fn has_materials(self) -> bool {
        matches!(self, Self::Obj | Self::Balls)
    }

    /// Returns whether its polygons are given, so that it has no numbers of divisions.
    pub fn is_given(self) -> bool {
        matches!(self, Self::Obj | Self::Balls | Self::Polygons)
    }

    /// Returns whether there is a true surface that the polygons stand for. Given polygons have none.
    pub fn has_surface(self) -> bool {
        !self.is_given()
    }
}

choices! {
    /// The source of vertex normals.
    pub enum NormalSource = "normals" {
        /// The weighted mean over the polygons that meet at the vertex.
        Averaged = "averaged";
        /// The normals of the true surface.
        Exact = "exact";
        /// The normals of the model or of the scene; averaged where they are missing.
        File = "file";
        /// Each polygon's own normal: no smoothing.
        Facet = "facet";
    }
}

choices! {
    /// The weight of each polygon in an averaged vertex normal.
    pub enum Weighting = "weighting" {
        /// Equal weight for each polygon (Gouraud 1971).
        Equal = "equal";
        /// The polygon's area.
        Area = "area";
        /// The polygon's angle at the vertex (Thürmer and Wüthrich 1998).
        Angle = "angle";
    }
}
