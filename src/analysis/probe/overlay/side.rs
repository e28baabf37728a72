//! The vectors seen from the side, in a corner of the picture.
//!
//! V points at the eye, so that in the picture it is a point and φ is seen edge-on. From the side, perpendicular to
//! the plane of N and L with N upwards and L on the left, the figure is that of the textbooks: N, L and R have their
//! true lengths and angles. A vector outside the plane appears shorter.

use crate::analysis::overlay::{OverlayOptions, Sketch, Style};
use crate::figure::{Area, Shape};
use crate::render;
use crate::scene::{Projection, View};
use glam::{BVec2, DVec2, DVec3};

/// Side of the pane: its share of the picture's shorter side as an inset and when it is enlarged, and the minimum in
/// text sizes.
const SIDE: [f64; 2] = [0.35, 0.72];
const LEAST_SIDE: f64 = 8.5;
/// Sine of the angle to the line of sight below which a vector points at the viewer.
const HEAD_ON: f64 = 0.45;
/// Length of a unit vector in the pane's side: twice as much fits above the point, which R's construction needs.
const UNIT: f64 = 0.36;
/// Distance of the point below the pane's middle; less where an L from behind the surface would leave the pane.
const DROP: [f64; 2] = [0.26, 0.45];
/// Extent of the surface beside the point and its thickness below it, in unit vectors.
const SURFACE_SIZE: [f64; 2] = [0.72, 0.07];
/// Grey of the surface, and the opacity of it and of the pane's background.
const SURFACE: [u8; 3] = [128; 3];
const OPAQUE: [f64; 2] = [0.35, 0.88];

/// Returns whether two of the vectors point at the viewer or away, so that they hide one another.
pub(super) fn is_needed(sketch: &Sketch, vectors: [DVec3; 3]) -> bool {
    let is_head_on = |vector: &DVec3| sketch.slant(*vector).abs() < HEAD_ON;
    vectors.iter().filter(|vector| is_head_on(vector)).count() >= 2
}

/// Returns the side of the largest square in each corner of `frame` that shows the background alone, in pixels: top left,
/// top right, bottom left, bottom right. `None` where what is drawn reaches the frame's edge.
pub fn free_corners(frame: &render::Frame) -> Option<[u32; 4]> {
    let background = frame.pixels.first()?;
    let is_drawn = |pixel: &[u8; 4]| pixel != background;
    let mut free = [frame.width.min(frame.height); 4];
    let rows = frame.pixels.chunks_exact(frame.width as usize);
    for (row, above) in rows.zip(0..) {
        let ends = [
            row.iter().position(is_drawn),
            row.iter().rposition(is_drawn),
        ];
        let [Some(before), Some(last)] = ends else {
            continue;
        };
        let beside = [before as u32, frame.width - 1 - last as u32];
        let around = [above, frame.height - 1 - above];
        if beside.contains(&0) || around.contains(&0) {
            return None;
        }
        for (corner, free) in free.iter_mut().enumerate() {
            *free = (*free).min(beside[corner % 2].max(around[corner / 2]));
        }
    }
    Some(free)
}

/// Returns the pane in the corner where it is largest, or else in the one farthest from `point`; none in a picture, or in
/// `free` corners, too small for it.
pub(super) fn pane(
    picture: Area,
    point: DVec2,
    style: &Style,
    enlarged: bool,
    free: Option<[u32; 4]>,
) -> Option<Area> {
    let shorter = (picture.max - picture.min).min_element();
    let [least, inset] = [LEAST_SIDE, 0.5].map(|sizes| sizes * style.text);
    let wanted = (SIDE[usize::from(enlarged)] * shorter).max(least);
    if wanted > SIDE[1] * shorter {
        return None;
    }
    let corner = |index: usize| {
        let room = free.map_or(wanted, |free| f64::from(free[index]) - inset);
        let side = wanted.min(room);
        let after = BVec2::new(index % 2 == 1, index / 2 == 1);
        let middle = inset + 0.5 * side;
        let middle = DVec2::select(after, picture.max - middle, picture.min + middle);
        let pane = Area::about(middle, DVec2::splat(side));
        (side >= least).then(|| (side, pane.centre().distance(point), pane))
    };
    let better =
        |a: &(f64, f64, _), b: &(f64, f64, _)| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1));
    let corners = (0..4).filter_map(corner);
    corners.max_by(better).map(|(.., pane)| pane)
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
    let ground = Shape::area(pane.corners(), style.halo_colour).plain();
    let frame = Shape::outline(pane.corners(), 0.35 * style.line, SURFACE).plain();
    sketch.shapes.extend([ground.faded(OPAQUE[1]), frame]);
    draw_surface(&mut sketch, n);
    Some(sketch)
}

/// Draws a section of the surface below the point.
pub(super) fn draw_surface(sketch: &mut Sketch, n: DVec3) {
    let across = n.cross(sketch.view.forward).normalize_or_zero();
    let [beside, below] = SURFACE_SIZE;
    let corners = [(-1.0, 0.0), (1.0, 0.0), (1.0, 1.0), (-1.0, 1.0)];
    let corners = sketch.ends(corners.map(|(x, y)| across * (beside * x) - n * (below * y)));
    let area = corners.map(|corners| Shape::area(corners, SURFACE).plain().faded(OPAQUE[0]));
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

    #[test]
    fn the_pane_takes_the_far_corner_of_a_picture_with_room() {
        let pane = |side: f64, enlarged, free| {
            let picture = Area {
                min: DVec2::ZERO,
                max: DVec2::new(4.0 / 3.0 * side, side),
            };
            let style = Style::new(side, &OverlayOptions::default());
            let pane = pane(picture, DVec2::splat(side / 6.0), &style, enlarged, free)?;
            assert!(picture.holds(&pane));
            Some(pane)
        };
        let far = pane(600.0, false, None).expect("room enough");
        let large = pane(600.0, true, None).expect("room enough");
        assert!(large.min.cmplt(far.min).all() && far.min.x > 400.0 && far.min.y > 300.0);
        assert_eq!(pane(60.0, false, None), None);
        // Where corners are not free enough, another is taken, or none.
        let above = pane(600.0, false, Some([190, 210, 190, 150])).expect("room enough");
        assert!(above.min.x >= 590.0 && above.max.y <= 210.0, "{above:?}");
        assert_eq!(pane(600.0, false, Some([40; 4])), None);
    }

    #[test]
    fn corners_are_free_up_to_what_is_drawn() {
        let [width, height] = [40, 30];
        let drawn = |inside: &dyn Fn(u32, u32) -> bool| {
            let pixel = |index: u32| [200 * u8::from(inside(index % width, index / width)); 4];
            let pixels = (0..width * height).map(pixel).collect();
            free_corners(&render::Frame {
                width,
                height,
                pixels,
            })
        };
        let in_box = |x: u32, y: u32| (12..30).contains(&x) && (5..21).contains(&y);
        assert_eq!(drawn(&in_box), Some([12, 10, 12, 10]));
        assert_eq!(drawn(&|_, _| false), Some([30; 4]));
        assert_eq!(drawn(&|_, y| y > 20), None);
        assert_eq!(drawn(&|x, y| x + y == 0), None);
    }
}
