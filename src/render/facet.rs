//! A triangle as pixels see it: what is the same for all of them is worked out once.

use super::lens::Lens;
use super::sites::Sight;
use super::solid::Solid;
use glam::{DVec2, DVec3};

/// One triangle of the model, seen through a lens.
///
/// The weights of its corners are quotients of functions linear in the place (J. Blinn, *Hyperbolic interpolation*, 1992):
/// with the ray p + s·d, the edges e1, e2 and f = p − a these are f·(d × e2) and d·(f × e1), over e1·(d × e2). One of p
/// and d is the same for all pixels, so each is linear in the other.
pub(super) struct Facet<'a> {
    lens: &'a Lens,
    corners: [DVec3; 3],
    normals: [DVec3; 3],
    /// The one normal of a facet that is not smooth.
    flat: Option<DVec3>,
    /// The two numerators and the denominator: their dot products with what differs from pixel to pixel, and constants.
    slopes: [DVec3; 3],
    constants: [f64; 3],
    /// How far corner j lies above the tangent plane at corner k: `above[k][j]`.
    above: [DVec3; 3],
}

impl<'a> Facet<'a> {
    pub fn new(solid: &Solid<'_>, lens: &'a Lens, triangle: u32) -> Self {
        let model = solid.model;
        let vertices = model.triangles[triangle as usize];
        let corners = vertices.map(|v| model.position(v));
        let normals = vertices.map(|v| model.normal(v));
        let flat = (!solid.smooth).then(|| model.face_normal(model.faces[triangle as usize]));
        let [a, b, c] = corners.map(|corner| (corner - lens.eye) / lens.unit);
        let (e1, e2) = (b - a, c - a);
        let (slopes, constants) = if lens.perspective {
            // p is the eye, f = −a.
            ([a.cross(e2), e1.cross(a), e2.cross(e1)], [0.0; 3])
        } else {
            let d = lens.forward;
            let (first, second) = (d.cross(e2), e1.cross(d));
            ([first, second, DVec3::ZERO], [-a.dot(first), -a.dot(second), e1.dot(first)])
        };
        let above = |k: usize| DVec3::from_array(corners.map(|corner| (corner - corners[k]).dot(normals[k])));
        let above = if flat.is_some() { [DVec3::ZERO; 3] } else { [above(0), above(1), above(2)] };
        Self { lens, corners, normals, flat, slopes, constants, above }
    }

    /// What is seen at a place in the picture. Seen exactly edge-on the plane has no single point there; its middle stands
    /// for it.
    #[inline]
    pub fn at(&self, place: DVec2) -> Sight {
        let (p, d) = self.lens.ray(place);
        let differing = if self.lens.perspective { d } else { p };
        let [first, second, whole] = [0, 1, 2].map(|k| self.slopes[k].dot(differing) + self.constants[k]);
        let inverse = 1.0 / whole;
        let (mut w1, mut w2) = (first * inverse, second * inverse);
        if !(w1.is_finite() && w2.is_finite()) {
            (w1, w2) = (1.0 / 3.0, 1.0 / 3.0);
        }
        let share = DVec3::new(1.0 - w1 - w2, w1, w2);
        let point = mean(&self.corners, share);
        match self.flat {
            Some(normal) => Sight { point, normal, lifted: point },
            None => {
                let normal = mean(&self.normals, share).try_normalize().unwrap_or_else(|| self.face_normal());
                Sight { point, normal, lifted: self.lifted(point, share) }
            }
        }
    }

    /// The point raised onto the tangent planes at the corners, weighted as the corners are (J. Hanika, *Hacking the shadow
    /// terminator*, Ray Tracing Gems II, 2021). Where the surface is hollow the planes lie below and nothing is raised.
    fn lifted(&self, point: DVec3, share: DVec3) -> DVec3 {
        let mut lifted = point;
        for k in 0..3 {
            let below = self.above[k].dot(share).min(0.0);
            lifted -= self.normals[k] * (below * share[k]);
        }
        lifted
    }

    /// Stands for vertex normals that cancel each other.
    fn face_normal(&self) -> DVec3 {
        let [a, b, c] = self.corners;
        (b - a).cross(c - a).normalize_or_zero()
    }
}

fn mean(vectors: &[DVec3; 3], share: DVec3) -> DVec3 {
    vectors[0] * share.x + vectors[1] * share.y + vectors[2] * share.z
}
