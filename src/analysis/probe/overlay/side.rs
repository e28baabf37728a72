//! The vectors seen from the side, in a corner of the picture.
//!
//! V points at the eye, so that in the picture it is a point and φ is seen edge-on. From the side, perpendicular to
//! the plane of N and L with N upwards and L on the left, the figure is that of the textbooks: N, L and R have their
//! true lengths and angles. A vector outside the plane appears shorter.

use crate::analysis::overlay::{OverlayOptions, Sketch, Style, inset};
use crate::figure::{Area, Shape};
use crate::scene::{Projection, View};
use glam::{DVec2, DVec3};

/// Sine of the angle to the line of sight below which a vector points at the viewer.
const HEAD_ON: f64 = 0.45;
/// Length of a unit vector in the pane's side: twice as much fits above the point, which R's construction needs.
const UNIT: f64 = 0.36;
/// Distance of the point below the pane's middle; less where an L from behind the surface would leave the pane.
const DROP: [f64; 2] = [0.26, 0.45];
/// Extent of the surface beside the point and its thickness below it, in unit vectors.
const SURFACE_SIZE: [f64; 2] = [0.72, 0.07];
/// Opacity of the surface.
const OPAQUE: f64 = 0.35;

/// Returns whether two of the vectors point at the viewer or away, so that they hide one another.
pub(super) fn is_needed(sketch: &Sketch, vectors: [DVec3; 3]) -> bool {
    let is_head_on = |vector: &DVec3| sketch.slant(*vector).abs() < HEAD_ON;
    vectors.iter().filter(|vector| is_head_on(vector)).count() >= 2
}

/// Returns a sketch of the surface about the point, ready for the vectors of a light; all are unit vectors.
pub(super) fn sketch(
    pane: Area,
    [n, l, v]: [DVec3; 3],
    options: &OverlayOptions,
) -> Option<Sketch> {
    let side = (pane.max - pane.min).min_element();
    let view = view(in_pane(pane, [n, l]), n, [l, v]);
    let style = Style::new(2.3 * side, options);
    let mut sketch = Sketch::new(view, style, pane, DVec3::ZERO, 1.0)?;
    sketch.shapes.extend(inset::ground(pane, &style));
    draw_surface(&mut sketch, n);
    Some(sketch)
}

/// Draws a section of the surface below the point.
pub(super) fn draw_surface(sketch: &mut Sketch, n: DVec3) {
    let across = n.cross(sketch.view.forward).normalize_or_zero();
    let [beside, below] = SURFACE_SIZE;
    let corners = [(-1.0, 0.0), (1.0, 0.0), (1.0, 1.0), (-1.0, 1.0)];
    let corners = sketch.ends(corners.map(|(x, y)| across * (beside * x) - n * (below * y)));
    let area = corners.map(|corners| Shape::area(corners, inset::GREY).plain().faded(OPAQUE));
    sketch.shapes.extend(area);
}

/// Position of the point and length of a unit vector.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    pub origin: DVec2,
    pub unit: f64,
}

/// Returns the frame of a pane; an L from behind the surface stays within it.
fn in_pane(pane: Area, [n, l]: [DVec3; 2]) -> Frame {
    let side = (pane.max - pane.min).min_element();
    let drop = DROP[0].min(DROP[1] - UNIT * (-n.dot(l)).max(0.0));
    Frame {
        origin: pane.centre() + DVec2::new(0.0, drop * side),
        unit: UNIT * side,
    }
}

/// Returns the view of the plane of `n` and the first of `aside`, with `n` upwards and the other on the left. Where the
/// first coincides with `n`, the next decides. All are unit vectors.
pub(super) fn view(frame: Frame, n: DVec3, aside: [DVec3; 2]) -> View {
    let right = aside
        .into_iter()
        .zip([-1.0, 1.0])
        .find_map(|(vector, sign)| (sign * (vector - n * vector.dot(n))).try_normalize())
        .unwrap_or_else(|| n.any_orthonormal_vector());
    let forward = n.cross(right);
    View {
        eye: forward * -4.0,
        right,
        up: n,
        forward,
        centre: frame.origin,
        scale: frame.unit,
        projection: Projection::Orthographic,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::properties;
    use proptest::prelude::*;

    fn unit() -> impl Strategy<Value = DVec3> {
        prop::array::uniform3(-1.0..1.0)
            .prop_map(DVec3::from_array)
            .prop_filter("has a direction", |v| v.length() > 0.01)
            .prop_map(DVec3::normalize)
    }

    const PANE: Area = Area {
        min: DVec2::ZERO,
        max: DVec2::new(300.0, 300.0),
    };

    proptest! {
        #![proptest_config(properties::config(file!()))]

        #[test]
        fn n_l_and_r_have_their_true_lengths_and_angles(n in unit(), l in unit(), v in unit()) {
            let r = 2.0 * n.dot(l) * n - l;
            let view = view(in_pane(PANE, [n, l]), n, [l, v]);
            prop_assert!((view.right.cross(view.up) + view.forward).length() < 1e-9);
            let at = |vector: DVec3| (view.project(vector).expect("in front").0 - view.centre) / view.scale;
            prop_assert!((at(n) - DVec2::NEG_Y).length() < 1e-6, "N is at {}", at(n));
            prop_assert!(at(l).x < 1e-6, "L is at {}", at(l));
            for (a, b) in [(n, l), (n, r), (l, r)] {
                prop_assert!((at(a).length() - 1.0).abs() < 1e-6);
                prop_assert!((at(a).dot(at(b)) - a.dot(b)).abs() < 1e-6);
            }
        }
    }

    #[test]
    fn coinciding_vectors_still_have_a_side() {
        let y = DVec3::Y;
        for v in [y, DVec3::X] {
            let view = view(in_pane(PANE, [y; 2]), y, [y, v]);
            assert!(
                (view.right.cross(view.up) + view.forward).length() < 1e-9,
                "{view:?}"
            );
        }
    }
}
