//! A vertex normal with the faces that it comes from: the question and its report.

use super::{NormalField, VertexNormal};
use crate::analysis::report::{
    Answer, Column, Part, Report, ReportContext, as_it_is, fixed, table_of,
};
use crate::analysis::{Question, Subject, Watch};
use crate::geometry::NormalOrigin;
use crate::render::Renderer;
use crate::scene::{NormalSource, Scene, View, Weighting};
use crate::text;
use glam::{DVec2, DVec3};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

/// The question for the normal of one vertex.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct NormalsQuestion {
    /// Number of the vertex; without one, the visible vertex nearest to the pixel.
    pub vertex: Option<u32>,
    /// The pixel; without one, the picture's middle.
    pub pixel: Option<[u32; 2]>,
}

/// The normal found, with the counts of the mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct FoundNormal {
    /// The vertex with its normal and faces.
    pub vertex: VertexNormal,
    /// Source of the scene's vertex normals.
    pub source: NormalSource,
    /// Weighting of the polygons in an averaged normal.
    pub weighting: Weighting,
    /// Number of vertices in the mesh.
    pub vertices: usize,
    /// Number of faces in the mesh.
    pub faces: usize,
}

impl Question for NormalsQuestion {
    type Answer = FoundNormal;

    fn answer(&self, subject: &Subject, _: &dyn Watch<FoundNormal>) -> Result<FoundNormal, String> {
        let (mut renderer, scene) = (subject.renderer(), &subject.scene);
        renderer.render(scene);
        let field = NormalField::new(&renderer, &scene.object);
        // By number, or the vertex nearest to a pixel's centre or to the picture's middle.
        let size = scene.image.size;
        let middle = DVec2::from_array(size.map(f64::from)) * 0.5;
        let place = self.pixel.map_or(middle, |pixel| {
            DVec2::from_array(pixel.map(f64::from)) + 0.5
        });
        let number = self
            .vertex
            .or_else(|| field.vertex_next_to(&renderer, scene, place));
        let number = number.ok_or_else(|| text!("picture-no-vertex-seen").to_owned())?;
        Ok(FoundNormal {
            vertex: field.vertex_of(number)?,
            source: field.source,
            weighting: field.weighting,
            vertices: field.vertex_count(),
            faces: field.face_count(),
        })
    }
}

impl NormalField {
    /// Returns the number of the vertex nearest to a place in the picture of `scene` that `renderer` last drew.
    pub fn vertex_next_to(&self, renderer: &Renderer, scene: &Scene, place: DVec2) -> Option<u32> {
        let size = scene.image.size;
        let seen = self.facing(&View::new(&scene.camera, size), size);
        let near = self.vertex_near(renderer, &seen, place, f64::INFINITY)?;
        Some(near.index)
    }

    /// Returns the vertex with that number, or an error that names the valid numbers.
    pub fn vertex_of(&self, number: u32) -> Result<VertexNormal, String> {
        self.vertex(number)
            .ok_or_else(|| match self.vertex_count() {
                0 => text!("picture-no-vertices", number = number),
                count => text!("picture-no-vertex", number = number, last = count - 1),
            })
    }
}

impl FoundNormal {
    /// Returns the unit of the weights; none where faces are counted or nothing is averaged.
    fn unit(&self) -> Option<&'static str> {
        let averages = matches!(
            self.vertex.origin,
            NormalOrigin::Averaged | NormalOrigin::FirstFace
        );
        match self.weighting {
            Weighting::Area if averages => Some("square units"),
            Weighting::Angle if averages => Some("degrees"),
            _ => None,
        }
    }

    fn origin(&self) -> String {
        let vertex = &self.vertex;
        let count = vertex.faces.len();
        match vertex.origin {
            NormalOrigin::Averaged => {
                let weights = match self.weighting {
                    Weighting::Equal => text!("picture-weighted-equally"),
                    Weighting::Area => text!("picture-weighted-by-area"),
                    Weighting::Angle => text!("picture-weighted-by-angle"),
                };
                let key = if vertex.mirrored {
                    "picture-normal-mirrored"
                } else {
                    "picture-normal-averaged"
                };
                text!(key, count = count, weights = weights)
            }
            NormalOrigin::Given if self.source == NormalSource::File => {
                text!("picture-normal-of-file").to_owned()
            }
            NormalOrigin::Given => text!("picture-normal-of-surface").to_owned(),
            NormalOrigin::Facet => text!("picture-normal-of-face").to_owned(),
            NormalOrigin::FirstFace => text!("picture-normal-of-first", count = count),
            NormalOrigin::Nowhere => text!("picture-normal-nowhere").to_owned(),
        }
    }
}

impl Answer for FoundNormal {
    fn report(&self, about: &ReportContext<'_>) -> Report {
        let vertex = &self.vertex;
        let at = triple(vertex.position);
        let (number, count) = (vertex.vertex.to_string(), self.vertices.to_string());
        let title = text!(
            "picture-vertex",
            scene = about.name,
            number = number,
            count = count,
            at = at
        );
        let mut report = Report::new(title);
        let section = report.section("");
        section.line(format!("N = {}: {}", triple(vertex.normal), self.origin()));
        if vertex.length > 0.0 {
            let length = format!("{:.4}", vertex.length);
            section.line(text!(
                "picture-normal-sum",
                sum = triple(vertex.sum),
                length = length
            ));
        }
        let weight = match self.unit() {
            Some("degrees") => text!("picture-column-angle"),
            Some(_) => text!("picture-column-area"),
            None => text!("picture-column-weight"),
        };
        let table = table_of! { face in &vertex.faces;
            Column::both("face", text!("picture-column-face"), as_it_is) => face.face;
            Column::both("share", text!("picture-column-share"), fixed::<4>) => face.share;
            Column::both("weight", weight, fixed::<5>) => face.weight;
            Column::both("angle", text!("picture-column-off"), fixed::<3>) => face.angle;
            Column::shown(text!("picture-column-normal"), as_it_is) => triple(face.normal);
            Column::key("nx") => face.normal.x;
            Column::key("ny") => face.normal.y;
            Column::key("nz") => face.normal.z;
        };
        report.section("").push(Part::Table(table));
        report
    }

    fn value(&self, about: &ReportContext<'_>) -> Value {
        json!({
            "scene": about.name,
            "normals": self.source,
            "weighting": self.weighting,
            "weight_unit": self.unit(),
            "vertices": self.vertices,
            "faces": self.faces,
            "vertex": self.vertex,
        })
    }
}

fn triple(v: DVec3) -> String {
    // Adding zero turns −0 into 0.
    let [x, y, z] = v.to_array().map(|c| (c * 1e4).round() / 1e4 + 0.0);
    format!("({x:.4}, {y:.4}, {z:.4})")
}
