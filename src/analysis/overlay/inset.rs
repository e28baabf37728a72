//! Panes in the corners of a picture, for drawings of their own.

use super::Style;
use crate::figure::{Area, Shape};
use crate::render;
use glam::{BVec2, DVec2};

/// Side of the pane: its share of the picture's shorter side as an inset and when it is enlarged, and the minimum in
/// text sizes.
const SIDE: [f64; 2] = [0.35, 0.72];
const LEAST_SIDE: f64 = 8.5;
/// Grey of the frame, and the opacity of the background.
pub(in crate::analysis) const GREY: [u8; 3] = [128; 3];
const OPAQUE: f64 = 0.88;

/// Returns the side of the largest square in each corner of `frame` that shows the background alone, in pixels: top left,
/// top right, bottom left, bottom right. Returns none where the drawing reaches the frame's edge.
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
pub(in crate::analysis) fn pane(
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

/// Returns the background of a pane and its frame.
pub(in crate::analysis) fn ground(pane: Area, style: &Style) -> [Shape; 2] {
    let ground = Shape::area(pane.corners(), style.halo_colour).plain();
    let frame = Shape::outline(pane.corners(), 0.35 * style.line, GREY).plain();
    [ground.faded(OPAQUE), frame]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::overlay::OverlayOptions;

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
