//! When flat shading is exact: the three conditions of Foley, van Dam, Feiner and Hughes (1990, section 16.2.1), and by how
//! much a scene fails each.
//!
//! One intensity a polygon is right where nothing in the equation varies across the polygon:
//!
//! 1. the light is at infinity, so that L and with it N·L are constant;
//! 2. the viewer is at infinity, so that V and with it N·V are constant;
//! 3. the polygon is the surface itself and stands for no curved one, so that N is constant.

use super::report::{About, Answer, Column, Report, Table, cells};
use super::{ErrorFigures, LinearPicture, Question, Subject, Watch, region_errors};
use crate::geometry::Mesh;
use crate::render::Renderer;
use crate::scene::{
    Compare, FlatAt, LightKind, NormalSource, Projection, Scene, ShadingMode, Viewer,
};
use crate::text;
use glam::DVec3;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

/// Angles below this are what rounding corners and normals to single precision leaves, degrees.
const ROUNDING: f64 = 0.01;

/// How a unit vector varies across a polygon, at most.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Variation {
    /// Of the polygon across which it turns most: by how much, degrees.
    pub degrees: f64,
    /// The greatest change of its cosine with N across any polygon.
    pub cosine: f64,
}

/// Which conditions a scene meets.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Conditions {
    /// Of L, over all lights that are on.
    pub light: Variation,
    /// Of V.
    pub viewer: Variation,
    /// Greatest angle between a polygon's normal and the surface's at its corners, degrees.
    pub surface: f64,
    /// Flat minus exact shading, where both show the object.
    pub error: ErrorFigures,
}

/// Whether a condition holds.
type Holds = fn(&Conditions) -> bool;

/// The conditions: the key of each one's sentence, and whether it holds.
pub const CONDITIONS: [(&str, Holds); 3] = [
    ("picture-condition-light", |found| {
        found.light.degrees < ROUNDING
    }),
    ("picture-condition-viewer", |found| {
        found.viewer.degrees < ROUNDING
    }),
    ("picture-condition-surface", |found| {
        found.surface < ROUNDING
    }),
];

/// Whether flat shading is exact in a scene.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct ConditionsQuestion;

impl Question for ConditionsQuestion {
    type Answer = Conditions;

    fn answer(
        &self,
        subject: &Subject,
        watch: &dyn Watch<Conditions>,
    ) -> Result<Conditions, String> {
        let found = conditions(&mut subject.renderer(), &subject.scene);
        watch.at(1.0);
        Ok(found)
    }
}

/// Checks the three conditions for the object of `scene`, and compares its flat picture with the exact one.
pub fn conditions(renderer: &mut Renderer, scene: &Scene) -> Conditions {
    let alone = |mode: ShadingMode| {
        let mut alone = Scene {
            compare: Compare::default(),
            ..scene.clone()
        };
        (alone.shading.mode, alone.shading.flat_at) = (mode, FlatAt::Centre);
        alone
    };
    let [exact, flat] =
        [ShadingMode::Exact, ShadingMode::Flat].map(|mode| renderer.linear_picture(&alone(mode)));
    let picture = |pixels| LinearPicture {
        width: scene.image.size[0],
        pixels,
        clamps: scene.clamps(),
    };
    let everywhere = vec![true; flat.len()];
    // The flat picture was drawn last, from the polygons.
    let mesh = renderer.mesh_shown();
    let soloing = scene.soloing();
    let far = |light: &&crate::scene::Light| light.kind != LightKind::Directional;
    let light = scene
        .lights
        .iter()
        .filter(|light| light.shines(soloing))
        .filter(far)
        .map(|light| variation(mesh, light.position))
        .fold(Variation::default(), Variation::or_more);
    let camera = &scene.camera;
    let infinite =
        camera.viewer == Viewer::Infinite || camera.projection == Projection::Orthographic;
    Conditions {
        light,
        viewer: if infinite {
            Variation::default()
        } else {
            variation(mesh, camera.eye)
        },
        surface: leaning(mesh, scene),
        error: region_errors(picture(&flat), picture(&exact), &everywhere).interior,
    }
}

impl Variation {
    fn or_more(self, other: Self) -> Self {
        Self {
            degrees: self.degrees.max(other.degrees),
            cosine: self.cosine.max(other.cosine),
        }
    }
}

/// How the direction to a place varies across the polygons of a mesh: between their corners and their centres.
fn variation(mesh: &Mesh, place: DVec3) -> Variation {
    let of_face = |f: usize| {
        let normal = mesh.face_normal(f);
        let to = |point: DVec3| (place - point).try_normalize();
        let Some(middle) = to(mesh.face_centre(f)).filter(|_| normal != DVec3::ZERO) else {
            return Variation::default();
        };
        let corners: Vec<DVec3> = mesh
            .face_points(f)
            .filter_map(|point| to(mesh.origin + point))
            .chain([middle])
            .collect();
        let (mut low, mut high, mut degrees) = (f64::INFINITY, f64::NEG_INFINITY, 0.0f64);
        for (index, way) in corners.iter().enumerate() {
            let cosine = normal.dot(*way);
            (low, high) = (low.min(cosine), high.max(cosine));
            for other in &corners[..index] {
                degrees = degrees.max(angle(*way, *other));
            }
        }
        Variation {
            degrees,
            cosine: high - low,
        }
    };
    (0..mesh.face_count())
        .into_par_iter()
        .map(of_face)
        .reduce(Variation::default, Variation::or_more)
}

/// The greatest angle between a polygon's normal and the surface's at its corners, degrees. Where there is no surface beyond
/// the polygons, the vertex normals say what they stand for.
fn leaning(mesh: &Mesh, scene: &Scene) -> f64 {
    let object = &scene.object;
    let source = if object.kind.has_surface() {
        NormalSource::Exact
    } else {
        object.normals
    };
    let vertices = mesh.with_vertex_normals(source, object.weighting);
    let of_face = |f: usize| {
        let normal = mesh.face_normal(f);
        let corners = vertices.face(f).iter();
        corners
            .map(|&vertex| vertices.normals[vertex as usize].as_dvec3())
            .filter(|_| normal != DVec3::ZERO)
            .map(|own| angle(normal, own))
            .fold(0.0, f64::max)
    };
    (0..mesh.face_count())
        .into_par_iter()
        .map(of_face)
        .reduce(|| 0.0, f64::max)
}

/// Degrees.
fn angle(a: DVec3, b: DVec3) -> f64 {
    a.cross(b).length().atan2(a.dot(b)).to_degrees()
}

impl Conditions {
    /// What was measured of a condition, in words.
    pub fn figures(&self, index: usize) -> String {
        let varies = |key, found: &Variation| {
            text!(
                key,
                degrees = format!("{:.2}", found.degrees),
                change = format!("{:.4}", found.cosine)
            )
        };
        match index {
            0 => varies("picture-condition-light.figures", &self.light),
            1 => varies("picture-condition-viewer.figures", &self.viewer),
            _ => text!(
                "picture-condition-surface.figures",
                degrees = format!("{:.2}", self.surface)
            ),
        }
    }
}

impl Answer for Conditions {
    /// A section for each condition, and one for the pictures.
    fn report(&self, about: &About<'_>) -> Report {
        let mut report = Report::new(text!(
            "picture-conditions-of",
            scene = about.heading().as_str()
        ));
        for (index, (key, holds)) in CONDITIONS.iter().enumerate() {
            let verdict = if holds(self) {
                text!("picture-holds")
            } else {
                text!("picture-fails")
            };
            let section = report.section(text!(key));
            section.line(format!("{verdict} {}", self.figures(index)));
        }
        let section = report.section(text!("picture-flat-and-exact"));
        section.quantity(
            format!("{:.4}", self.error.greatest),
            text!("picture-flat-greatest"),
        );
        section.quantity(format!("{:.4}", self.error.rms), "RMS");
        report
    }

    fn table(&self) -> Option<Table> {
        let mut table = Table::new(["condition", "holds", "degrees", "cosine"].map(Column::key));
        let rows = [
            ("light", self.light.degrees, Some(self.light.cosine)),
            ("viewer", self.viewer.degrees, Some(self.viewer.cosine)),
            ("surface", self.surface, None),
        ];
        for ((name, degrees, cosine), (_, holds)) in rows.into_iter().zip(CONDITIONS) {
            let holds = if holds(self) { "true" } else { "false" };
            table.rows.push(cells![name, holds, degrees, cosine]);
        }
        Some(table)
    }

    fn json(&self, about: &About<'_>) -> Value {
        let [light, viewer, surface] = CONDITIONS.map(|(_, holds)| holds(self));
        json!({
            "scene": about.name,
            "size": about.scene.image.size,
            "light": { "holds": light, "degrees": self.light.degrees, "cosine": self.light.cosine },
            "viewer": { "holds": viewer, "degrees": self.viewer.degrees, "cosine": self.viewer.cosine },
            "surface": { "holds": surface, "degrees": self.surface },
            "flat_minus_exact": self.error,
        })
    }
}
