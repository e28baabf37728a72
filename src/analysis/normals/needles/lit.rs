//! One vertex: the polygons that its normal comes from, lit up, each with its share.

use super::{CONTRAST, DARK, LENGTH, LENGTHS};
use crate::analysis::overlay::{OverlayOptions, Sketch, Style};
use crate::analysis::{NormalField, VertexFace, VertexNormal};
use crate::figure::palette::{self, readable};
use crate::figure::{Area, Drawing, Label, Shape};
use crate::geometry::NormalOrigin;
use crate::scene::{NormalSource, Scene, View};
use glam::DVec2;
use tiny_skia::PixmapMut;

/// Length of an emphasised normal in that of a needle.
const EMPHASIS: f64 = 1.5;
/// How opaque faces are filled: where nothing is averaged, and what the largest share adds.
const FILL: [f64; 2] = [0.12, 0.33];
/// More faces than this are counted instead of lettered.
const LETTERED: usize = 12;
/// Of the outline of a face that is seen from behind, in widths.
const BEHIND: &[f32] = &[2.0, 2.0];
/// Size of the shares in that of the vectors' letters.
const SHARE: f64 = 0.8;

/// A vertex and the faces round it, laid out for a picture.
#[derive(Clone, Debug)]
pub struct LitVertex {
    /// The shares and the letter of the normal.
    pub labels: Vec<Label>,
    drawing: Drawing,
    style: Style,
}

impl LitVertex {
    /// Lays out `vertex` of `field` over a picture of `scene` of `size` pixels; nothing where it does not appear.
    pub fn new(
        size: [u32; 2],
        scene: &Scene,
        field: &NormalField,
        vertex: &VertexNormal,
        options: &OverlayOptions,
    ) -> Option<Self> {
        let pane = Area { min: DVec2::ZERO, max: DVec2::from_array(size.map(f64::from)) };
        let side = pane.max.min_element();
        let style = Style::new(side, options);
        let view = View::new(&scene.camera, size);
        let (_, depth) = view.project(vertex.position)?;
        let [least, most] = LENGTHS.map(|share| share * side * view.world_per_pixel(depth));
        let length = EMPHASIS * (LENGTH * field.median_edge()).clamp(2.0 * least, most);
        let about = |position| Sketch::new(view, style, pane, position, Some(length), 1.0);
        let mut sketch = about(vertex.position)?;
        let greatest = vertex.faces.iter().map(|face| face.share).fold(0.0, f64::max);
        for face in &vertex.faces {
            let front = face.normal.dot(view.towards_eye(face.centre)) > 0.0;
            let weight = if greatest > 0.0 { face.share / greatest } else { 0.0 };
            area(&mut sketch, field, face, front, weight);
        }
        for face in &vertex.faces {
            if let Some(own) = about(face.centre) {
                normal(&mut sketch, &own, face, vertex.faces.len() <= LETTERED && greatest > 0.0);
            }
        }
        count(&mut sketch, vertex);
        vertex_normal(&mut sketch, vertex, name(field, vertex));
        let labels = sketch.labels(&[]);
        Some(Self { labels, drawing: style.drawing(sketch.shapes), style })
    }

    /// Draws it on a pixmap of the size for which it was laid out.
    pub fn draw(&self, pixmap: &mut PixmapMut<'_>) {
        self.drawing.draw(pixmap);
        self.style.lettered(&self.labels).draw(pixmap);
    }
}

/// Fills and outlines a face.
fn area(sketch: &mut Sketch, field: &NormalField, face: &VertexFace, front: bool, weight: f64) {
    let corners: Option<Vec<DVec2>> =
        field.outline(face.face).into_iter().map(|corner| Some(sketch.view.project(corner)?.0)).collect();
    let Some(mut corners) = corners else { return };
    if front {
        let fill = Shape::area(corners.clone(), palette::FACE).plain();
        sketch.shapes.push(fill.faded(FILL[0] + FILL[1] * weight));
    }
    let width = 0.5 * sketch.style.line;
    corners.extend(corners.first().copied());
    // Yellow shows on its own dark rim, whatever the picture's halo is.
    let rim = Shape::line(corners.clone(), 2.4 * width, DARK).faded(if front { 0.7 } else { 0.4 });
    let outline = Shape::line(corners, width, palette::FACE).dashed(if front { &[] } else { BEHIND });
    sketch.shapes.extend([rim.plain(), outline.plain()]);
}

/// The normal at a face's centre, and its share beside it.
fn normal(sketch: &mut Sketch, own: &Sketch, face: &VertexFace, lettered: bool) {
    let Some(tip) = own.end(face.normal) else { return };
    let style = sketch.style;
    let along = (tip - own.origin).normalize_or_zero();
    let head = (0.7 * style.head).min(0.5 * own.origin.distance(tip));
    let width = 0.75 * style.line;
    // Yellow on a dark rim: the same arrow twice, first wider.
    for (more, dot, colour, dashes) in
        [(style.line, 1.6, DARK, &[][..]), (0.0, 1.1, palette::FACE, &palette::FACE_DASHES[..])]
    {
        let [shaft, point] = Shape::arrow([own.origin, tip], along, width + more, head, colour);
        let dot = Shape::disc(own.origin, dot * style.line, colour);
        sketch.shapes.extend([shaft.dashed(dashes), dot, Shape { width: more, ..point }].map(Shape::plain));
    }
    if lettered {
        let outwards = (own.origin - sketch.origin).normalize_or(-along);
        let colour = readable(palette::FACE, style.halo_colour, 4.5);
        let text = format!("{:.2}", face.share);
        sketch.letter(text, SHARE, colour, own.origin, outwards, 0.25 * style.text);
    }
}

/// Says how many faces there are where that is too many for letters.
fn count(sketch: &mut Sketch, vertex: &VertexNormal) {
    let count = vertex.faces.len();
    if count <= LETTERED {
        return;
    }
    let shares = vertex.faces.iter().map(|face| face.share);
    let (least, most) = shares.fold((f64::INFINITY, 0.0f64), |(l, m), share| (l.min(share), m.max(share)));
    let text = if most == 0.0 {
        format!("{count} faces")
    } else if most - least < 5e-4 {
        format!("{count} faces, {most:.3} each")
    } else {
        format!("{count} faces, {least:.3} to {most:.3}")
    };
    let (origin, neutral) = (sketch.origin, sketch.style.neutral);
    sketch.letter(text, SHARE, neutral, origin, DVec2::Y, sketch.style.text);
}

/// N, and where it comes from if not from the faces.
fn name(field: &NormalField, vertex: &VertexNormal) -> &'static str {
    match (vertex.origin, field.source()) {
        (NormalOrigin::Given, NormalSource::File) => "N of the file",
        (NormalOrigin::Given, _) => "N of the surface",
        _ => "N",
    }
}

/// The vertex with its own normal, over everything.
fn vertex_normal(sketch: &mut Sketch, vertex: &VertexNormal, name: &str) {
    let style = sketch.style;
    let origin = sketch.origin;
    let colour = readable(palette::N, style.halo_colour, CONTRAST);
    let tip = sketch.end(vertex.normal).unwrap_or(origin);
    let along = (tip - origin).normalize_or_zero();
    let head = style.head.min(0.5 * origin.distance(tip));
    let [shaft, point] = Shape::arrow([origin, tip], along, 1.2 * style.line, head, colour);
    sketch.shapes.push(shaft);
    sketch.shapes.extend((head > 0.0).then_some(point));
    sketch.shapes.push(Shape::disc(origin, 1.7 * style.line, colour));
    let anchor = sketch.inside(tip, 0.5 * style.text);
    let size = if name == "N" { 1.0 } else { SHARE };
    sketch.letter(name.to_owned(), size, colour, anchor, along, 0.15 * style.text);
}
