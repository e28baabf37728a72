//! The vectors seen from the side, in a corner of the picture.
//!
//! V points at the eye, so that in the picture it is a point and φ is seen edge-on. From the side, perpendicular to
//! the plane of N and L with N upwards and L on the left, the figure is that of the textbooks; it is seen slightly
//! from above, so that a V outside the plane is recognisable, and turned about N where V would hide behind another
//! vector.

use crate::analysis::overlay::{OverlayOptions, Sketch, Style};
use crate::figure::{Area, Shape};
use crate::scene::{Projection, View};
use glam::{DVec2, DVec3};

/// Side of the pane: the preferred share of the picture's shorter side, the maximum share, and the minimum in text
/// sizes.
const SIDE: [f64; 3] = [0.35, 0.6, 8.5];
/// Length of a unit vector in the pane's side: twice as much fits above the point, which R's construction needs.
const UNIT: f64 = 0.36;
/// Distance of the point below the pane's middle; less where an L from behind the surface would leave the pane.
const DROP: [f64; 2] = [0.26, 0.45];
/// Elevation from which the surface is seen, radians.
const TILT: f64 = 0.22;
/// Maximum turn about N, radians, so that L stays on the left; the number of steps searched each way; and the cost of
/// a turn's square relative to the visible share of the worst angle.
const TURN: f64 = 1.1;
const TURNS: u32 = 60;
const RELUCTANCE: f64 = 0.2;
/// Radius of the disc that represents the surface, in unit vectors.
const DISC: f64 = 0.62;
/// Grey of the surface, and the opacity of it and of the pane's background.
const SURFACE: [u8; 3] = [128; 3];
const OPAQUE: [f64; 2] = [0.35, 0.88];

/// Returns the pane in the corner farthest from `point`; none in a picture too small for it.
pub(super) fn pane(picture: Area, point: DVec2, style: &Style) -> Option<Area> {
    let shorter = (picture.max - picture.min).min_element();
    let side = (SIDE[0] * shorter).max(SIDE[2] * style.text);
    if side > SIDE[1] * shorter {
        return None;
    }
    let inset = 0.5 * style.text + 0.5 * side;
    let before = point.cmplt(picture.centre());
    let middle = DVec2::select(before, picture.max - inset, picture.min + inset);
    Some(Area::about(middle, DVec2::splat(side)))
}

/// Returns a sketch of the surface about the point, ready for the vectors of a light; all are unit vectors.
pub(super) fn sketch(
    pane: Area,
    [n, l, v]: [DVec3; 3],
    lobe_between: (DVec3, DVec3),
    options: &OverlayOptions,
) -> Option<Sketch> {
    let side = (pane.max - pane.min).min_element();
    let view = view(in_pane(pane, [n, l]), [n, l, v], lobe_between);
    let style = Style::new(2.3 * side, options);
    let mut sketch = Sketch::new(view, style, pane, DVec3::ZERO, Some(1.0), side)?;
    let ground = Shape::area(pane.corners(), style.halo_colour).plain();
    let frame = Shape::outline(pane.corners(), 0.35 * style.line, SURFACE).plain();
    sketch.shapes.extend([ground.faded(OPAQUE[1]), frame]);
    draw_surface(&mut sketch, n);
    Some(sketch)
}

/// Draws a disc for the surface about the point.
pub(super) fn draw_surface(sketch: &mut Sketch, n: DVec3) {
    let (across, into) = n.any_orthonormal_pair();
    let rim = Shape::ring(DVec2::ZERO, DISC, 0.0, SURFACE).points;
    let rim: Option<Vec<DVec2>> = rim
        .into_iter()
        .map(|p| sketch.end(across * p.x + into * p.y))
        .collect();
    sketch
        .shapes
        .extend(rim.map(|rim| Shape::area(rim, SURFACE).plain().faded(OPAQUE[0])));
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

/// Returns the view, turned about N by the smallest angle that shows the angles and V at a fair share of their size.
/// All vectors are unit vectors.
pub(super) fn view(frame: Frame, [n, l, v]: [DVec3; 3], lobe_between: (DVec3, DVec3)) -> View {
    let shown = |view: &View| {
        [(n, l), lobe_between, (v, DVec3::ZERO)]
            .iter()
            .fold(1.0, |least: f64, (from, to)| {
                let between = *from - *to;
                let across = between - view.forward * between.dot(view.forward);
                // Vectors that coincide have no angle to show.
                if between.length() < 1e-6 {
                    least
                } else {
                    least.min(across.length() / between.length())
                }
            })
    };
    let straight = view_turned(frame, [n, l, v], 0.0);
    let (mut best, mut most) = (straight, shown(&straight));
    for step in 1..=TURNS {
        for side in [1.0, -1.0] {
            let turn = side * TURN * f64::from(step) / f64::from(TURNS);
            let turned = view_turned(frame, [n, l, v], turn);
            let merit = shown(&turned) - RELUCTANCE * turn * turn;
            if merit > most {
                (best, most) = (turned, merit);
            }
        }
    }
    best
}

fn view_turned(frame: Frame, [n, l, v]: [DVec3; 3], turn: f64) -> View {
    let aside = |vector: DVec3| (vector - n * vector.dot(n)).try_normalize();
    let right = aside(-l)
        .or_else(|| aside(v))
        .unwrap_or_else(|| n.any_orthonormal_vector());
    let into = n.cross(right);
    let (sine, cosine) = turn.sin_cos();
    let (right, into) = (right * cosine + into * sine, into * cosine - right * sine);
    let (sine, cosine) = TILT.sin_cos();
    let (forward, up) = (into * cosine - n * sine, n * cosine + into * sine);
    View {
        eye: forward * -4.0,
        right,
        up,
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
        fn n_points_up_l_to_the_left_and_v_is_never_a_point(n in unit(), l in unit(), v in unit()) {
            let r = 2.0 * n.dot(l) * n - l;
            let view = view(in_pane(PANE, [n, l]), [n, l, v], (r, v));
            prop_assert!((view.right.cross(view.up) + view.forward).length() < 1e-9);
            let at = |vector: DVec3| view.project(vector).expect("in front").0 - view.centre;
            prop_assert!(at(n).y < -0.9 * UNIT * 300.0 && at(n).x.abs() < 1e-6, "N is at {}", at(n));
            prop_assert!(at(l).x < 1e-6, "L is at {}", at(l));
            prop_assert!(at(v).length() > 0.25 * UNIT * 300.0, "V is at {}", at(v));
        }
    }

    #[test]
    fn coinciding_vectors_still_have_a_side() {
        let y = DVec3::Y;
        let view = view(in_pane(PANE, [y; 2]), [y; 3], (y, y));
        assert!(
            (view.right.cross(view.up) + view.forward).length() < 1e-9,
            "{view:?}"
        );
    }

    #[test]
    fn the_pane_takes_the_far_corner_of_a_picture_with_room() {
        let picture = Area {
            min: DVec2::ZERO,
            max: DVec2::new(800.0, 600.0),
        };
        let style = Style::new(600.0, &OverlayOptions::default());
        let far = pane(picture, DVec2::new(100.0, 100.0), &style).expect("room enough");
        assert!(far.min.x > 400.0 && far.min.y > 300.0 && picture.holds(&far));
        let small = Area {
            min: DVec2::ZERO,
            max: DVec2::splat(60.0),
        };
        assert_eq!(
            pane(
                small,
                DVec2::ZERO,
                &Style::new(60.0, &OverlayOptions::default())
            ),
            None
        );
    }
}
