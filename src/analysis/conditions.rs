//! Conditions under which flat shading is exact: the three of Foley, van Dam, Feiner and Hughes (1990, section
//! 16.2.1), and by how much a scene violates each.
//!
//! One intensity per polygon is correct where nothing in the equation varies across the polygon:
//!
//! 1. the light is at infinity, so that L and with it N·L are constant;
//! 2. the viewer is at infinity, so that V and with it N·V are constant;
//! 3. the polygon is the surface itself and does not approximate a curved one, so that N is constant.
//!
//! They also assume that nothing else in the equation varies; [`Assumption`] lists the properties of a scene that
//! can.

use super::comparison::{ErrorFigures, LinearPicture, error_figures, region_errors};
use super::report::{Answer, Column, Report, ReportContext, Table, cells, grouped};
use super::{Question, Subject, Watch};
use crate::geometry::{Mesh, angle};
use crate::render::{Cued, Plan, Renderer};
use crate::scene::{
    Attenuation, Compare, FlatAt, Light, LightKind, Material, NormalSource, PatternKind, Rgb,
    Scene, ShadingMode, Viewer,
};
use crate::text;
use glam::DVec3;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use std::sync::Arc;

/// Largest angle that rounding corners and normals to single precision produces, degrees.
const ROUNDING: f64 = 0.01;

/// Maximum variation of a unit vector across a polygon.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Variation {
    /// Angle by which it turns across the polygon where it turns most, degrees.
    pub degrees: f64,
    /// Maximum change of its cosine with N across any polygon.
    pub cosine: f64,
}

/// An assumption of the three conditions that a scene violates: flat shading is then not exact even where they hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Assumption {
    /// Od is constant; a pattern varies it.
    Pattern,
    /// f is constant; it falls with the distance to the viewer.
    ViewerDistance,
    /// f is constant; it falls with the distance to a light.
    LightDistance,
    /// A light is equally bright in all directions; a spot light is not.
    Spot,
    /// A light reaches all of a polygon; a shadow can fall on part of it.
    Shadows,
    /// The intensity does not fade; flat shading fades it by one depth a polygon.
    DepthCueing,
    /// N is the polygon's own; at the vertices, where the equation is evaluated, it is a different one.
    VertexNormals,
}

/// The conditions as measured in a scene.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Conditions {
    /// Variation of L, over all lights that are on.
    pub light: Variation,
    /// Variation of V.
    pub viewer: Variation,
    /// Maximum angle between a polygon's normal and those at its corners, of the surface or else of the vertices;
    /// degrees.
    pub surface: f64,
    /// True if the object has a surface beyond its polygons.
    pub has_surface: bool,
    /// Assumptions of the three conditions that the scene violates.
    pub further: Vec<Assumption>,
    /// Difference of flat and exact shading where both show the object, or the same polygon if that is the surface.
    pub error: ErrorFigures,
    /// Difference of flat and exact shading where either shows the object, as a comparison of both pictures has it.
    pub everywhere: ErrorFigures,
}

/// A test of a condition.
type Holds = fn(&Conditions) -> bool;

/// The conditions: the key of each one's sentence, and its test.
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

/// The question whether flat shading is exact in a scene.
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
        watch.progress(1.0);
        Ok(found)
    }
}

/// Checks the three conditions for the object of `scene`, and compares its flat picture with the exact one.
pub fn conditions(renderer: &mut Renderer, scene: &Scene) -> Conditions {
    let modes = [ShadingMode::Exact, ShadingMode::Flat];
    let [exact, flat] = modes.map(|mode| renderer.linear_picture(&alone(scene, mode)));
    let [exact, flat] = [&exact, &flat].map(|pixels| LinearPicture {
        width: scene.image.size[0],
        pixels,
        clamps: scene.clamps(),
    });
    let mesh = &*Arc::clone(renderer.mesh_shown());
    let has_surface = scene.object.kind.has_surface();
    // If there is no surface beyond the polygons, the vertex normals represent it.
    let surface = normal_deviation(
        mesh,
        scene,
        if has_surface {
            NormalSource::Exact
        } else {
            scene.object.normal_source()
        },
    );
    let inside = if has_surface && surface < ROUNDING {
        same_polygon(renderer, scene)
    } else {
        vec![true; flat.pixels.len()]
    };
    // The flat picture was drawn last.
    let materials = renderer.for_each_material(scene, |scene| scene.material.clone());
    Conditions {
        light: light_variation(mesh, scene),
        // In parallel projection, too, V of a local viewer points to the eye.
        viewer: match scene.camera.viewer {
            Viewer::Infinite => Variation::default(),
            Viewer::Local => variation(mesh, scene.camera.eye),
        },
        surface,
        has_surface,
        further: renderer
            .plan()
            .map_or_else(Vec::new, |plan| assumptions(mesh, scene, plan, &materials)),
        error: region_errors(flat, exact, &inside).interior,
        everywhere: error_figures(flat, exact),
    }
}

/// Returns the scene in a shading mode, without the panes of a comparison.
fn alone(scene: &Scene, mode: ShadingMode) -> Scene {
    let mut alone = Scene {
        compare: Compare::default(),
        ..scene.clone()
    };
    alone.shading.mode = mode;
    alone
}

/// Returns for each pixel whether both pictures show the same polygon, judging by the normals: beside an edge, a pixel's
/// centre can lie on different sides of it in the two. The flat picture is drawn last.
fn same_polygon(renderer: &mut Renderer, scene: &Scene) -> Vec<bool> {
    let width = scene.image.size[0] as usize;
    let [exact, flat] = [ShadingMode::Exact, ShadingMode::Flat].map(|mode| {
        let count = renderer.render(&alone(scene, mode)).pixels.len();
        let renderer = &*renderer;
        let normal = |index: usize| {
            let seen = renderer.evaluation((index % width) as u32, (index / width) as u32)?;
            Some(seen.normal)
        };
        let normals = (0..count).into_par_iter().map(normal);
        normals.collect::<Vec<Option<DVec3>>>()
    });
    let same = |pair| match pair {
        (Some(a), Some(b)) => angle(a, b).to_degrees() < ROUNDING,
        _ => true,
    };
    exact.into_iter().zip(flat).map(same).collect()
}

/// Measures the variation of L over all lights that are on and not at infinity.
fn light_variation(mesh: &Mesh, scene: &Scene) -> Variation {
    let soloing = scene.soloing();
    scene
        .lights
        .iter()
        .filter(|light| light.shines(soloing) && light.kind != LightKind::Directional)
        .map(|light| variation(mesh, light.position))
        .fold(Variation::default(), Variation::max)
}

/// Returns the assumptions of the three conditions that the scene violates; `plan` is that of its flat picture, `materials` are those
/// of its faces.
fn assumptions(mesh: &Mesh, scene: &Scene, plan: &Plan, materials: &[Material]) -> Vec<Assumption> {
    let any = |varies: fn(&Light) -> bool| {
        let mut lights = scene.lights.iter().zip(&plan.lights);
        lights.any(|(light, shines)| *shines && varies(light))
    };
    let pattern = &scene.pattern;
    let patterned = |own: &Material| {
        let colored = own.ka != Rgb::ZERO || own.kd != Rgb::ZERO;
        pattern.kind != PatternKind::None && pattern.color != own.color && colored
    };
    let own_normals = || {
        scene.shading.flat_at == FlatAt::Centre
            || normal_deviation(mesh, scene, scene.object.normal_source()) < ROUNDING
    };
    let broken = [
        (Assumption::Pattern, materials.iter().any(patterned)),
        (
            Assumption::ViewerDistance,
            any(|light| light.attenuation == Attenuation::Viewer),
        ),
        (Assumption::LightDistance, any(falls_with_distance)),
        (Assumption::Spot, any(|light| light.kind == LightKind::Spot)),
        (Assumption::Shadows, plan.shadows),
        (Assumption::DepthCueing, plan.cued == Cued::AtPoints),
        (
            Assumption::VertexNormals,
            scene.object.kind.has_surface() && !own_normals(),
        ),
    ];
    broken
        .into_iter()
        .filter(|(_, broken)| *broken)
        .map(|(assumption, _)| assumption)
        .collect()
}

fn falls_with_distance(light: &Light) -> bool {
    let falls = match light.attenuation {
        Attenuation::None | Attenuation::Viewer => false,
        Attenuation::Light | Attenuation::InverseSquare => true,
        Attenuation::Quadratic => light.c2 != 0.0 || light.c3 != 0.0,
    };
    falls && light.kind.has_position()
}

impl Variation {
    fn max(self, other: Self) -> Self {
        Self {
            degrees: self.degrees.max(other.degrees),
            cosine: self.cosine.max(other.cosine),
        }
    }
}

/// Measures the variation of the direction to a place across polygons, between their corners and centres.
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
                degrees = degrees.max(angle(*way, *other).to_degrees());
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
        .reduce(Variation::default, Variation::max)
}

/// Returns the maximum angle between a polygon's normal and those at its corners, degrees.
fn normal_deviation(mesh: &Mesh, scene: &Scene, normals: NormalSource) -> f64 {
    let vertices = mesh.with_vertex_normals(normals, scene.object.weighting);
    let of_face = |f: usize| {
        let normal = mesh.face_normal(f);
        let corners = vertices.face(f).iter();
        corners
            .map(|&vertex| vertices.normals[vertex as usize].as_dvec3())
            .filter(|_| normal != DVec3::ZERO)
            .map(|own| angle(normal, own).to_degrees())
            .fold(0.0, f64::max)
    };
    (0..mesh.face_count())
        .into_par_iter()
        .map(of_face)
        .reduce(|| 0.0, f64::max)
}

impl Conditions {
    /// Returns the sentence of a condition; without a surface beyond the polygons the third is about their normals.
    pub fn title(&self, index: usize) -> &'static str {
        match CONDITIONS[index].0 {
            "picture-condition-surface" if !self.has_surface => text!("picture-condition-polygons"),
            title => text!(title),
        }
    }

    /// Describes the quantities of the scene that vary besides L, V and N.
    pub fn further_words(&self) -> String {
        if self.further.is_empty() {
            return text!("picture-further-none").to_owned();
        }
        let words: Vec<&str> = self.further.iter().map(|found| found.words()).collect();
        words.join(text!("point-sentence-gap"))
    }

    /// Describes the measurements of a condition.
    pub fn figures(&self, index: usize) -> String {
        let (key, Variation { degrees, cosine }) = match index {
            0 => ("picture-condition-light.figures", self.light),
            1 => ("picture-condition-viewer.figures", self.viewer),
            _ => {
                let key = if self.has_surface {
                    "picture-condition-surface.figures"
                } else {
                    "picture-condition-polygons.figures"
                };
                let (degrees, cosine) = (self.surface, 0.0);
                (key, Variation { degrees, cosine })
            }
        };
        text!(
            key,
            degrees = format!("{degrees:.2}"),
            change = format!("{cosine:.4}")
        )
    }

    /// Returns the number of pixels that show the object in one of the pictures only, or another polygon.
    pub fn outline_pixels(&self) -> u64 {
        self.everywhere.pixels - self.error.pixels
    }
}

impl Assumption {
    fn words(self) -> &'static str {
        match self {
            Self::Pattern => text!("picture-further-pattern"),
            Self::ViewerDistance => text!("picture-further-viewer-distance"),
            Self::LightDistance => text!("picture-further-light-distance"),
            Self::Spot => text!("picture-further-spot"),
            Self::Shadows => text!("picture-further-shadows"),
            Self::DepthCueing => text!("picture-further-depth-cueing"),
            Self::VertexNormals => text!("picture-further-vertex-normals"),
        }
    }
}

fn verdict(holds: bool) -> &'static str {
    if holds {
        text!("picture-holds")
    } else {
        text!("picture-fails")
    }
}

impl Answer for Conditions {
    fn report(&self, about: &ReportContext<'_>) -> Report {
        let mut report = Report::new(text!("picture-conditions-of", scene = about.heading()));
        for (index, (_, holds)) in CONDITIONS.iter().enumerate() {
            let words = format!("{} {}", verdict(holds(self)), self.figures(index));
            report.section(self.title(index)).line(words);
        }
        let holds = verdict(self.further.is_empty());
        let words = format!("{holds} {}", self.further_words());
        report.section(text!("picture-further")).line(words);
        let section = report.section(text!("picture-flat-and-exact"));
        section.quantity(
            format!("{:.4}", self.error.greatest),
            text!("picture-flat-greatest"),
        );
        section.quantity(format!("{:.4}", self.error.rms), "RMS");
        section.line(text!(
            "picture-flat-compared",
            inside = grouped(self.error.pixels),
            outline = grouped(self.outline_pixels()),
            greatest = format!("{:.4}", self.everywhere.greatest)
        ));
        report
    }

    fn table(&self) -> Option<Table> {
        let mut table = Table::new(["condition", "holds", "degrees", "cosine"].map(Column::key));
        let rows = [
            ("light", Some(self.light.degrees), Some(self.light.cosine)),
            (
                "viewer",
                Some(self.viewer.degrees),
                Some(self.viewer.cosine),
            ),
            ("surface", Some(self.surface), None),
            ("further", None, None),
        ];
        let holds = CONDITIONS
            .map(|(_, holds)| holds(self))
            .into_iter()
            .chain([self.further.is_empty()]);
        for ((name, degrees, cosine), holds) in rows.into_iter().zip(holds) {
            table
                .rows
                .push(cells![name, holds.to_string(), degrees, cosine]);
        }
        Some(table)
    }

    fn value(&self, about: &ReportContext<'_>) -> Value {
        let [light, viewer, surface] = CONDITIONS.map(|(_, holds)| holds(self));
        json!({
            "scene": about.name,
            "size": about.scene.image.size,
            "light": { "holds": light, "degrees": self.light.degrees, "cosine": self.light.cosine },
            "viewer": { "holds": viewer, "degrees": self.viewer.degrees, "cosine": self.viewer.cosine },
            "surface": { "holds": surface, "degrees": self.surface },
            "further": { "holds": self.further.is_empty(), "fails": self.further },
            "flat_minus_exact": self.error,
            "everywhere": self.everywhere,
            "outline_pixels": self.outline_pixels(),
        })
    }
}
