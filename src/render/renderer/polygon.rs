//! One polygon of the last picture: where the equation is evaluated for it, whatever pixels it covers.

use super::pipeline::Renderer;
use super::reference::WeightedPoint;
use crate::render::lens::NEAR;
use glam::{DVec2, DVec3};

/// A polygon as it is shaded.
#[derive(Clone, Debug)]
pub(crate) struct Polygon<'a> {
    /// Its corners, counter-clockwise from outside, each with the normal that the shading mode gives it.
    pub corners: Vec<WeightedPoint<'a>>,
    /// Where flat shading evaluates the equation.
    pub flat: Vec<WeightedPoint<'a>>,
    /// Whether all of it lies beyond the near plane.
    pub before_the_eye: bool,
}

impl Renderer {
    /// Polygons of the last picture's object.
    pub(crate) fn polygon_count(&self) -> usize {
        self.reference().map_or(0, |reference| reference.triangles.model.face_count())
    }

    /// Face `face` of the last picture's object, if there is one of that index.
    pub(crate) fn polygon(&self, face: u32) -> Option<Polygon<'_>> {
        let reference = self.reference()?;
        if face as usize >= reference.triangles.model.face_count() {
            return None;
        }
        let corners = reference.corner_points(face);
        let depth = |at: &WeightedPoint<'_>| reference.lens.view_from_world(at.point).z;
        let before_the_eye = corners.iter().all(|at| depth(at) >= NEAR);
        Some(Polygon { flat: reference.flat_points(face), corners, before_the_eye })
    }

    /// The polygon that a pixel of the last picture sees. A picture of the true surface shows none: there it is the polygon
    /// that stands for what is seen.
    pub(crate) fn polygon_at(&self, x: u32, y: u32) -> Option<u32> {
        let reference = self.reference()?;
        if !reference.plan.true_surface {
            return self.evaluation(x, y)?.face;
        }
        let place = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
        let (origin, along) = reference.lens.ray(place);
        let (model, lens) = (reference.triangles.model, reference.lens);
        let distance = |vertices: &[u32; 3]| {
            let [a, b, c] = vertices.map(|v| (model.position(v) - lens.eye) / lens.unit);
            distance_to([a, b, c], origin, along).filter(|distance| *distance >= NEAR)
        };
        let hits = model.triangles.iter().zip(&model.faces);
        let hits = hits.filter_map(|(vertices, face)| Some((distance(vertices)?, *face)));
        hits.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, face)| face)
    }
}

/// How far along a ray it meets a triangle, in lengths of its direction (Möller and Trumbore 1997).
fn distance_to([a, b, c]: [DVec3; 3], origin: DVec3, along: DVec3) -> Option<f64> {
    let (e1, e2, from) = (b - a, c - a, origin - a);
    let (p, q) = (along.cross(e2), from.cross(e1));
    let determinant = e1.dot(p);
    let [u, v, distance] = [from.dot(p), along.dot(q), e2.dot(q)].map(|part| part / determinant);
    (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && distance.is_finite()).then_some(distance)
}
