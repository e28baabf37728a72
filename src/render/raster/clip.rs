//! Clipping of triangles that reach behind the near plane or beyond the guard band.
//!
//! Sutherland and Hodgman's algorithm against five planes, in double precision. A corner made by clipping stores its
//! weights over the triangle's vertices, so that the vertices' values can be interpolated for it later.

use super::grid::{GUARD, GridPosition, SUBPIXELS};
use super::transform::Placed;
use crate::render::lens::{Lens, NEAR};
use crate::render::model::Model;
use crate::render::node::{Memory, capacity};
use glam::DVec3;

/// A vertex made by clipping.
#[derive(Clone, Copy, Debug)]
pub struct Cut {
    pub vertices: [u32; 3],
    /// The barycentric weights over `vertices`, on the triangle in space.
    pub weights: [f64; 3],
}

/// A vertex of the polygon being clipped: view components and weights.
#[derive(Clone, Copy)]
struct ClipVertex {
    view: DVec3,
    weights: DVec3,
}

/// The clipper's output, beside the model's own triangles and vertices.
#[derive(Default)]
pub struct Clipped {
    /// The new vertices: vertex `model.padded_len() + i` is `cuts[i]`.
    pub cuts: Vec<Cut>,
    /// The new triangles: triangle `model.triangles.len() + i` has these vertices and belongs to `parents[i]`'s face.
    pub triangles: Vec<[u32; 3]>,
    pub parents: Vec<u32>,
}

impl Clipped {
    pub fn count(&self, memory: &mut Memory) {
        memory.triangles +=
            capacity(&self.cuts) + capacity(&self.triangles) + capacity(&self.parents);
    }

    pub fn clear(&mut self) {
        self.cuts.clear();
        self.triangles.clear();
        self.parents.clear();
    }

    /// Clips `triangle` and adds the remaining pieces, appending the new vertices to `placed`.
    pub fn add(&mut self, lens: &Lens, model: &Model, triangle: u32, placed: &mut Placed) {
        let vertices = model.triangles[triangle as usize];
        let views = vertices.map(|v| lens.view_from_world(model.position(v)));
        let polygon = clip(lens, views);
        let Some((first, rest)) = polygon.split_first() else {
            return;
        };
        let mut add = |corner: &ClipVertex| self.add_vertex(lens, vertices, corner, placed);
        let hub = add(first);
        let rim: Vec<u32> = rest.iter().map(&mut add).collect();
        for pair in rim.windows(2) {
            self.triangles.push([hub, pair[0], pair[1]]);
            self.parents.push(triangle);
        }
    }

    fn add_vertex(
        &mut self,
        lens: &Lens,
        vertices: [u32; 3],
        corner: &ClipVertex,
        placed: &mut Placed,
    ) -> u32 {
        let index = placed.places.len();
        // Rounding may take a cut off the plane by some part of the triangle's extent, however large that is.
        let view = DVec3 {
            z: corner.view.z.max(NEAR),
            ..corner.view
        };
        let place = (lens.picture_from_view(view) * f64::from(SUBPIXELS)).round();
        let limit = f64::from(SUBPIXELS) * (GUARD + 1.0);
        let place: GridPosition = [
            place.x.clamp(-limit, limit) as i32,
            place.y.clamp(-limit, limit) as i32,
        ];
        placed.places.push(place);
        placed.keys.push(lens.key_from_depth(view.z) as f32);
        self.cuts.push(Cut {
            vertices,
            weights: corner.weights.to_array(),
        });
        u32::try_from(index).unwrap_or(u32::MAX)
    }
}

/// Clips the triangle with view components `views`; the result is empty where nothing remains.
fn clip(lens: &Lens, views: [DVec3; 3]) -> Vec<ClipVertex> {
    let mut polygon: Vec<ClipVertex> = views
        .into_iter()
        .zip([DVec3::X, DVec3::Y, DVec3::Z])
        .map(|(view, weights)| ClipVertex { view, weights })
        .collect();
    cut(&mut polygon, |view| view.z - NEAR);
    // The extent of the guard band from the middle at depth 1 (or anywhere, without perspective).
    let reach = |side: f64| (GUARD - side.abs()) / lens.focal;
    let (across, down) = (reach(lens.middle.x), reach(lens.middle.y));
    let depth = |view: DVec3| if lens.perspective { view.z } else { 1.0 };
    cut(&mut polygon, |view| across * depth(view) - view.x);
    cut(&mut polygon, |view| across * depth(view) + view.x);
    cut(&mut polygon, |view| down * depth(view) - view.y);
    cut(&mut polygon, |view| down * depth(view) + view.y);
    if polygon.len() < 3 {
        polygon.clear();
    }
    polygon
}

/// Cuts the polygon down to the part where `distance`, linear in the view components, is not negative.
fn cut(polygon: &mut Vec<ClipVertex>, distance: impl Fn(DVec3) -> f64) {
    let mut kept = Vec::with_capacity(polygon.len() + 1);
    for (i, corner) in polygon.iter().enumerate() {
        let next = &polygon[(i + 1) % polygon.len()];
        let (d0, d1) = (distance(corner.view), distance(next.view));
        if d0 >= 0.0 {
            kept.push(*corner);
        }
        if (d0 >= 0.0) != (d1 >= 0.0) {
            // Always from the inside out, so that both neighbours of an edge cut it at the same point.
            let (a, b, t) = if d0 >= 0.0 {
                (corner, next, d0 / (d0 - d1))
            } else {
                (next, corner, d1 / (d1 - d0))
            };
            if t.is_finite() {
                kept.push(ClipVertex {
                    view: a.view.lerp(b.view, t),
                    weights: a.weights.lerp(b.weights, t),
                });
            }
        }
    }
    *polygon = kept;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::properties;
    use crate::scene::Camera;
    use glam::DVec2;
    use proptest::prelude::*;

    fn triangle(c: [f64; 9]) -> [DVec3; 3] {
        [0, 3, 6].map(|k| DVec3::from_slice(&c[k..k + 3]))
    }

    proptest! {
        #![proptest_config(properties::config(file!()))]

        /// Checks that the parts cut off and kept by a plane make up the triangle.
        #[test]
        fn a_cut_keeps_the_area(c in prop::array::uniform9(-3.0..3.0f64), nx in -1.0..1.0f64, ny in -1.0..1.0f64, d in -1.0..1.0f64) {
            let points = triangle(c);
            let area = |corners: &[DVec3]| {
                let doubled = |pair: &[DVec3]| (pair[0] - corners[0]).cross(pair[1] - corners[0]).length();
                corners.windows(2).map(doubled).sum::<f64>() / 2.0
            };
            let part = |side: f64| {
                let mut polygon = points.map(|view| ClipVertex { view, weights: DVec3::ZERO }).to_vec();
                cut(&mut polygon, |view| side * (view.x * nx + view.y * ny + view.z * 0.5 - d));
                area(&polygon.iter().map(|corner| corner.view).collect::<Vec<_>>())
            };
            prop_assert!((part(1.0) + part(-1.0) - area(&points)).abs() < 1e-9);
        }

        /// Checks that a remaining corner lies before the near plane, inside the guard band, at the point given by its weights.
        #[test]
        fn corners_are_where_their_weights_say(c in prop::array::uniform9(-5.0..5.0f64)) {
            let lens = Lens::new(&Camera::default(), [640, 480], DVec2::ZERO, 4.0);
            let views = triangle(c);
            for ClipVertex { view, weights: w } in clip(&lens, views) {
                prop_assert!(view.z >= NEAR * (1.0 - 1e-9));
                prop_assert!(lens.picture_from_view(view).abs().max_element() <= GUARD + 1e-3);
                prop_assert!((views[0] * w.x + views[1] * w.y + views[2] * w.z - view).length() < 1e-9);
                prop_assert!((w.element_sum() - 1.0).abs() < 1e-12);
            }
        }
    }
}
