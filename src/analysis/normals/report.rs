//! A vertex normal with the faces that it comes from: how it is asked, and what it says.

use super::{NormalField, VertexNormal};
use crate::analysis::report::{About, Answer, Column, Part, Report, Table, as_it_is, cells, fixed};
use crate::analysis::{Question, Subject, Watch};
use crate::geometry::NormalOrigin;
use crate::scene::{NormalSource, View, Weighting};
use glam::{DVec2, DVec3};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

/// The normal of one vertex.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct NormalsQuestion {
    /// By its number; otherwise the seen vertex next to the pixel.
    pub vertex: Option<u32>,
    /// Otherwise the picture's middle.
    pub pixel: Option<[u32; 2]>,
}

/// The vertex, and how many there are.
#[derive(Clone, Debug, PartialEq)]
pub struct FoundNormal {
    pub vertex: VertexNormal,
    pub source: NormalSource,
    pub weighting: Weighting,
    pub vertices: usize,
    pub faces: usize,
}

impl Question for NormalsQuestion {
    type Answer = FoundNormal;

    fn answer(&self, subject: &Subject, _: &dyn Watch<FoundNormal>) -> Result<FoundNormal, String> {
        let (mut renderer, scene) = (subject.renderer(), &subject.scene);
        renderer.render(scene);
        let field = NormalField::new(&renderer, &scene.object);
        // By its number, or next to a pixel's centre or to the picture's middle.
        let size = scene.image.size;
        let middle = DVec2::from_array(size.map(f64::from)) * 0.5;
        let place = self.pixel.map_or(middle, |pixel| {
            DVec2::from_array(pixel.map(f64::from)) + 0.5
        });
        let seen = || field.facing(&View::new(&scene.camera, size), size);
        let near = || {
            Some(
                field
                    .vertex_near(&renderer, &seen(), place, f64::INFINITY)?
                    .index,
            )
        };
        let number = self.vertex.or_else(near);
        let number = number.ok_or(
            "no vertex is seen in the picture, expected --vertex or a camera that sees the object",
        )?;
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
    /// The vertex of that number, or which numbers there are.
    pub fn vertex_of(&self, number: u32) -> Result<VertexNormal, String> {
        self.vertex(number).ok_or_else(|| {
            let expected = match self.vertex_count() {
                0 => "expected none: the object has no vertices".to_owned(),
                count => format!("expected 0 to {}", count - 1),
            };
            format!("--vertex {number}: no such vertex, {expected}")
        })
    }
}

impl FoundNormal {
    /// The unit of the weights; none where faces are counted or nothing is averaged.
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

    /// Where the normal comes from, in words.
    fn origin(&self) -> String {
        let vertex = &self.vertex;
        let images = if vertex.mirrored {
            " and their mirror images in x"
        } else {
            ""
        };
        let count = vertex.faces.len();
        let faces = if count == 1 {
            "1 face".to_owned()
        } else {
            format!("{count} faces")
        };
        match vertex.origin {
            NormalOrigin::Averaged => {
                let weights = match self.weighting {
                    Weighting::Equal => "weighted equally",
                    Weighting::Area => "weighted by area",
                    Weighting::Angle => "weighted by angle",
                };
                format!("the mean of {faces}{images}, {weights}")
            }
            NormalOrigin::Given if self.source == NormalSource::File => "the file's own".to_owned(),
            NormalOrigin::Given => "the true surface's".to_owned(),
            NormalOrigin::Facet => "the face's own".to_owned(),
            NormalOrigin::FirstFace => format!("that of the first of {faces} whose normals cancel"),
            NormalOrigin::Nowhere => "no face here has an area".to_owned(),
        }
    }
}

impl Answer for FoundNormal {
    fn report(&self, about: &About<'_>) -> Report {
        let vertex = &self.vertex;
        let (number, count, place) = (vertex.vertex, self.vertices, triple(vertex.position));
        let mut report = Report::new(format!(
            "{}: vertex {number} of {count}, at {place}",
            about.name
        ));
        let section = report.section("");
        section.line(format!("N = {}: {}", triple(vertex.normal), self.origin()));
        if vertex.length > 0.0 {
            section.line(format!(
                "Σ share·N = {}, of length {:.4}",
                triple(vertex.sum),
                vertex.length
            ));
        }
        let weight = match self.unit() {
            Some("degrees") => "angle, °",
            Some(_) => "area",
            None => "weight",
        };
        let mut columns = vec![
            Column::both("face", "face", as_it_is),
            Column::both("share", "share", fixed::<4>),
            Column::both("weight", weight, fixed::<5>),
            Column::both("angle", "off N, °", fixed::<3>),
            Column::shown("normal", as_it_is),
        ];
        columns.extend(["nx", "ny", "nz"].map(Column::key));
        let mut table = Table::new(columns);
        table.rows.extend(vertex.faces.iter().map(|face| {
            let DVec3 { x, y, z } = face.normal;
            cells![
                face.face,
                face.share,
                face.weight,
                face.angle,
                triple(face.normal),
                x,
                y,
                z
            ]
        }));
        report.section("").push(Part::Table(table));
        report
    }

    fn json(&self, about: &About<'_>) -> Value {
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
