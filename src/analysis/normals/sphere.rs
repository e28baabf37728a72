//! The sphere of normals: the normals of a vertex's polygons as points of a unit sphere, their mean inside it, and the
//! vertex normal, which is the mean at length 1.

use super::needles::{CONTRAST, DARK};
use super::{VertexFace, VertexNormal};
use crate::analysis::overlay::{OverlayLayer, OverlayOptions, Sketch, Style, inset};
use crate::figure::Shape;
use crate::figure::palette::{self, Vector, readable};
use crate::scene::{Projection, View};
use crate::text;
use glam::{DQuat, DVec2, DVec3};

/// Radius of the sphere in the pane's side.
const RADIUS: f64 = 0.36;
/// Angle by which the sphere is seen from above, radians.
const TILT: f64 = -0.4;
/// Radius of a point on the sphere, in lines, for the largest share; an area shows the share.
const POINT: f64 = 2.2;
/// Opacity of what lies on the far half.
const FAR: f64 = 0.35;
/// Text size of the mean's name, relative to the vectors' letters.
const NAME: f64 = 0.8;

/// Draws the sphere of `vertex` in a corner of the picture of `lit`, a free one if there is any. Returns none where nothing
/// is averaged, or where the vectors' side view may be.
pub(super) fn sketch(
    vertex: &VertexNormal,
    lit: &Sketch,
    options: &OverlayOptions,
) -> Option<Sketch> {
    let greatest = vertex
        .faces
        .iter()
        .map(|face| face.share)
        .fold(0.0, f64::max);
    let apart = options.layers.contains(&OverlayLayer::Vectors);
    if greatest == 0.0 || apart {
        return None;
    }
    let pane = |free| inset::pane(lit.pane, lit.origin, &lit.style, false, free);
    let pane = pane(options.free_corners).or_else(|| pane(None))?;
    let side = (pane.max - pane.min).min_element();
    let view = view(vertex.normal, &lit.view, pane.centre(), RADIUS * side);
    let style = Style::new(2.3 * side, options);
    let mut sketch = Sketch::new(view, style, pane, DVec3::ZERO, 1.0)?;
    sketch.shapes.extend(inset::ground(pane, &style));
    let (centre, radius) = (sketch.origin, RADIUS * side);
    let ball = Shape::disc(centre, radius, inset::GREY)
        .faded(0.3 * FAR)
        .plain();
    let rim = Shape::ring(centre, radius, 0.5 * style.line, inset::GREY).plain();
    sketch.shapes.extend([ball, rim]);
    let far = |face: &&VertexFace| face.normal.dot(sketch.view.forward) > 0.0;
    let (behind, before): (Vec<_>, Vec<_>) = vertex.faces.iter().partition(far);
    for (faces, opacity) in [(behind, FAR), (before, 1.0)] {
        for face in faces {
            draw_face(&mut sketch, face, (face.share / greatest).sqrt(), opacity);
        }
    }
    draw_mean(&mut sketch, vertex);
    Some(sketch)
}

/// Returns a view of the unit sphere with N upwards, from a little above, and the picture's right on its right.
fn view(n: DVec3, picture: &View, centre: DVec2, scale: f64) -> View {
    let right = (picture.right - n * picture.right.dot(n)).try_normalize();
    let right = right.unwrap_or_else(|| n.any_orthonormal_vector());
    let turn = DQuat::from_axis_angle(right, TILT);
    let forward = turn * n.cross(right);
    View {
        eye: forward * -4.0,
        right,
        up: turn * n,
        forward,
        centre,
        scale,
        projection: Projection::Orthographic,
    }
}

/// Draws a face's normal from the centre to its point on the sphere, whose size is a share of the largest one.
fn draw_face(sketch: &mut Sketch, face: &VertexFace, size: f64, opacity: f64) {
    let Some(tip) = sketch.end(face.normal) else {
        return;
    };
    let line = sketch.style.line;
    let radius = POINT * size * line;
    for (colour, more, dashes) in [
        (DARK, 0.5 * line, &[][..]),
        (palette::FACE, 0.0, &palette::FACE_DASHES[..]),
    ] {
        let shaft = Shape::line(vec![sketch.origin, tip], 0.5 * line + more, colour).dashed(dashes);
        let point = Shape::disc(tip, radius + 0.5 * more, colour);
        sketch
            .shapes
            .extend([shaft, point].map(|shape| shape.faded(opacity).plain()));
    }
}

/// Draws the mean of the normals inside the sphere and the vertex normal through it.
fn draw_mean(sketch: &mut Sketch, vertex: &VertexNormal) {
    let style = sketch.style;
    let colour = readable(Vector::N.colour(), style.halo_colour, CONTRAST);
    let (Some(mean), Some(tip)) = (sketch.end(vertex.sum), sketch.end(vertex.normal)) else {
        return;
    };
    let along = sketch.arrow(tip, style.line, colour);
    sketch
        .shapes
        .push(Shape::disc(mean, 1.6 * style.line, style.neutral));
    let gap = 0.3 * style.text;
    let beside = along.perp().try_normalize().unwrap_or(DVec2::X);
    sketch.letter("N".to_owned(), 1.0, colour, tip, along, gap);
    sketch.letter(
        text!("picture-lit-mean").to_owned(),
        NAME,
        style.neutral,
        mean,
        beside,
        gap,
    );
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::Area;
    use crate::geometry::NormalOrigin;
    use crate::scene::Camera;

    /// Returns the vertex of a cube's corner: three faces at right angles.
    fn corner() -> VertexNormal {
        let face = |(face, normal): (u32, DVec3)| VertexFace {
            face,
            centre: DVec3::ZERO,
            normal,
            weight: 1.0,
            share: 1.0 / 3.0,
            angle: 0.0,
        };
        let sum = DVec3::ONE / 3.0;
        VertexNormal {
            vertex: 0,
            position: DVec3::ZERO,
            normal: sum.normalize(),
            origin: NormalOrigin::Averaged,
            faces: (0..).zip(DVec3::AXES).map(face).collect(),
            mirrored: false,
            sum,
            length: sum.length(),
        }
    }

    #[test]
    fn n_points_upwards_and_the_mean_lies_on_it_inside_the_sphere() {
        let size = [800, 600];
        let picture = Area {
            min: DVec2::ZERO,
            max: DVec2::new(800.0, 600.0),
        };
        let options = OverlayOptions {
            layers: vec![],
            ..OverlayOptions::default()
        };
        let view = View::new(&Camera::default(), size);
        let style = Style::new(600.0, &options);
        let lit = Sketch::new(view, style, picture, DVec3::ZERO, 1.0).expect("in the picture");
        let vertex = corner();
        let sphere = sketch(&vertex, &lit, &options).expect("room");
        let way = |vector| sphere.end(vector).expect("in the pane") - sphere.origin;
        let (n, mean) = (way(vertex.normal), way(vertex.sum));
        assert!(n.x.abs() < 1e-6 && n.y < 0.0, "{n}");
        assert!((mean - n / 3.0f64.sqrt()).length() < 1e-6, "{mean} {n}");
        // The mean and each face have their dots where they belong.
        let has_dot = |at: DVec2| {
            sphere.shapes.iter().any(|shape| {
                let middle = shape.points.iter().sum::<DVec2>() / shape.points.len() as f64;
                shape.fill && middle.distance(sphere.origin + at) < 0.1
            })
        };
        assert!(has_dot(mean) && !has_dot(1.5 * mean));
        assert!(vertex.faces.iter().all(|face| has_dot(way(face.normal))));
    }
}
