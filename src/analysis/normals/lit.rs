//! A vertex with the polygons that its normal comes from, each with its share.

use super::needles::{CONTRAST, DARK, LENGTH, LENGTHS, Needles};
use super::{NormalField, VertexFace, VertexNormal, sphere};
use crate::analysis::overlay::{OverlayOptions, Sketch, Style};
use crate::figure::palette::{self, Vector, readable};
use crate::figure::{Area, Drawing, Label, Shape};
use crate::geometry::NormalOrigin;
use crate::render::Renderer;
use crate::scene::{NormalSource, Scene, View};
use crate::text;
use glam::DVec2;
use std::iter;
use tiny_skia::PixmapMut;

/// Text size of a face's share, relative to the vectors' letters.
const SHARE: f64 = 0.8;
/// Length of an emphasised normal, relative to a needle.
const EMPHASIS: f64 = 1.5;
/// Opacity of filled faces: where nothing is averaged, and the increase for the largest share.
const FILL: [f64; 2] = [0.12, 0.33];
/// Maximum number of faces that are lettered; more are only counted.
const LETTERED: usize = 12;
/// Dashes of the outline of a back-facing face, in widths.
const BEHIND: &[f32] = &[2.0, 2.0];

/// A highlighted vertex with the faces that its normal comes from, each with its share.
#[derive(Clone, Debug)]
pub struct LitVertex {
    /// Labels of the shares and of the normal.
    pub labels: Vec<Label>,
    /// The pane of the sphere of normals, pixels.
    pub sphere: Option<Area>,
    /// Drawings with their own halos, the later over the earlier.
    drawings: Vec<Drawing>,
    style: Style,
}

impl LitVertex {
    /// Lays out `vertex` of `field` over a picture of `scene` of `size` pixels; none if it does not appear.
    pub fn new(
        size: [u32; 2],
        scene: &Scene,
        field: &NormalField,
        vertex: &VertexNormal,
        options: &OverlayOptions,
    ) -> Option<Self> {
        let pane = Area::from_size(DVec2::from_array(size.map(f64::from)));
        let side = pane.max.min_element();
        let style = Style::new(side, options);
        let view = View::new(&scene.camera, size);
        let (_, depth) = view.project(vertex.position)?;
        let [least, most] = LENGTHS.map(|share| share * side * view.world_per_pixel(depth));
        let length = EMPHASIS * (LENGTH * field.median_edge).clamp(2.0 * least, most);
        let about = |position| Sketch::new(view, style, pane, position, length);
        let mut sketch = about(vertex.position)?;
        let greatest = vertex
            .faces
            .iter()
            .map(|face| face.share)
            .fold(0.0, f64::max);
        for face in &vertex.faces {
            let weight = if greatest > 0.0 {
                face.share / greatest
            } else {
                0.0
            };
            draw_face(&mut sketch, field, face, weight);
        }
        let lettered = vertex.faces.len() <= LETTERED;
        for face in &vertex.faces {
            if let Some(own) = about(face.centre) {
                draw_face_normal(&mut sketch, &own, face, lettered && greatest > 0.0);
            }
        }
        if !lettered {
            let shares = vertex.faces.iter().map(|face| face.share);
            let (least, count) = (shares.fold(f64::INFINITY, f64::min), vertex.faces.len());
            let text = if greatest == 0.0 {
                text!("picture-lit-faces", count = count)
            } else if greatest - least < 5e-4 {
                let share = format!("{greatest:.3}");
                text!("picture-lit-faces-each", count = count, share = share)
            } else {
                let (least, greatest) = (format!("{least:.3}"), format!("{greatest:.3}"));
                text!(
                    "picture-lit-faces-range",
                    count = count,
                    least = least,
                    greatest = greatest
                )
            };
            sketch.letter(
                text,
                SHARE,
                style.neutral,
                sketch.origin,
                DVec2::Y,
                style.text,
            );
        }
        draw_vertex_normal(&mut sketch, field, vertex);
        let sphere = sphere::sketch(vertex, &sketch, options);
        let pane = sphere.as_ref().map(|sphere| sphere.pane);
        let taken: Vec<Area> = pane
            .into_iter()
            .chain(options.covered.iter().copied())
            .collect();
        let (mut labels, mut drawings) = (Vec::new(), Vec::new());
        for (mut sketch, reserved) in
            iter::once((sketch, &taken[..])).chain(sphere.map(|own| (own, &[][..])))
        {
            labels.extend(sketch.labels(reserved));
            drawings.push(style.drawing(sketch.shapes));
        }
        Some(Self {
            labels,
            sphere: pane,
            drawings,
            style,
        })
    }

    /// Draws the vertex and its faces on a pixmap of the size for which they were laid out.
    pub fn draw(&self, pixmap: &mut PixmapMut<'_>) {
        self.drawings
            .iter()
            .for_each(|drawing| drawing.draw(pixmap));
        self.style.lettered(&self.labels).draw(pixmap);
    }
}

/// Draws the layers of `options` that are normals over a picture of `scene` that `renderer` last drew, and highlights
/// a vertex of its mesh. The pixmap has that picture's size. The error is that of `vertex`.
pub fn draw_normals<E>(
    pixmap: &mut PixmapMut<'_>,
    scene: &Scene,
    renderer: &Renderer,
    options: &OverlayOptions,
    vertex: impl FnOnce(&NormalField) -> Result<Option<VertexNormal>, E>,
) -> Result<(), E> {
    let field = NormalField::new(renderer, &scene.object);
    let size = [pixmap.width(), pixmap.height()];
    let lit =
        vertex(&field)?.and_then(|vertex| LitVertex::new(size, scene, &field, &vertex, options));
    Needles::new(size, scene, renderer, &field, options).draw(pixmap);
    lit.into_iter().for_each(|lit| lit.draw(pixmap));
    Ok(())
}

fn draw_face(sketch: &mut Sketch, field: &NormalField, face: &VertexFace, weight: f64) {
    let front = face.normal.dot(sketch.view.towards_eye(face.centre)) > 0.0;
    let corners = field
        .outline(face.face)
        .into_iter()
        .map(|corner| Some(sketch.view.project(corner)?.0));
    let Some(mut corners) = corners.collect::<Option<Vec<DVec2>>>() else {
        return;
    };
    if front {
        let fill = Shape::area(corners.clone(), palette::FACE).plain();
        sketch.shapes.push(fill.faded(FILL[0] + FILL[1] * weight));
    }
    let width = 0.5 * sketch.style.line;
    corners.extend(corners.first().copied());
    // Yellow shows on its own dark rim, whatever the picture's halo is.
    let rim = Shape::line(corners.clone(), 2.4 * width, DARK).faded(if front { 0.7 } else { 0.4 });
    let outline =
        Shape::line(corners, width, palette::FACE).dashed(if front { &[] } else { BEHIND });
    sketch.shapes.extend([rim.plain(), outline.plain()]);
}

/// Draws the normal at a face's centre, the origin of `own`, and its share beside it.
fn draw_face_normal(sketch: &mut Sketch, own: &Sketch, face: &VertexFace, lettered: bool) {
    let Some(tip) = own.end(face.normal) else {
        return;
    };
    let style = sketch.style;
    let along = (tip - own.origin).normalize_or_zero();
    let head = (0.7 * style.head).min(0.5 * own.origin.distance(tip));
    let width = 0.75 * style.line;
    // Yellow on a dark rim: the same arrow twice, the wider one first.
    for (more, dot, colour, dashes) in [
        (style.line, 1.6, DARK, &[][..]),
        (0.0, 1.1, palette::FACE, &palette::FACE_DASHES[..]),
    ] {
        let [shaft, point] = Shape::arrow([own.origin, tip], along, width + more, head, colour);
        let dot = Shape::disc(own.origin, dot * style.line, colour);
        sketch.shapes.extend(
            [
                shaft.dashed(dashes),
                dot,
                Shape {
                    width: more,
                    ..point
                },
            ]
            .map(Shape::plain),
        );
    }
    if lettered {
        let outwards = (own.origin - sketch.origin).normalize_or(-along);
        let colour = readable(palette::FACE, style.halo_colour, 4.5);
        let text = format!("{:.2}", face.share);
        sketch.letter(text, SHARE, colour, own.origin, outwards, 0.25 * style.text);
    }
}

/// Draws the vertex with its own normal on top of everything, and the normal's source if it is not the faces.
fn draw_vertex_normal(sketch: &mut Sketch, field: &NormalField, vertex: &VertexNormal) {
    let (style, origin) = (sketch.style, sketch.origin);
    let colour = readable(Vector::N.colour(), style.halo_colour, CONTRAST);
    let tip = sketch.end(vertex.normal).unwrap_or(origin);
    let along = sketch.arrow(tip, 1.2 * style.line, colour);
    sketch
        .shapes
        .push(Shape::disc(origin, 1.7 * style.line, colour));
    let (name, size) = match (vertex.origin, field.source) {
        (NormalOrigin::Given, NormalSource::File) => (text!("picture-lit-n-file"), SHARE),
        (NormalOrigin::Given, _) => (text!("picture-lit-n-surface"), SHARE),
        _ => ("N", 1.0),
    };
    let anchor = sketch.inside(tip, 0.5 * style.text);
    sketch.letter(
        name.to_owned(),
        size,
        colour,
        anchor,
        along,
        0.15 * style.text,
    );
}
