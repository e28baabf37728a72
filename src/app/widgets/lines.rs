//! Lines in the window, clipped to the painter's area before they are dashed or sent to the graphics card.

use crate::figure::{Area, clipped};
use eframe::egui::{Color32, Painter, Pos2, Rect, Shape, Stroke, pos2};
use glam::DVec2;

/// Converts a point of the screen to double precision, in which lines may reach far out of sight.
pub fn exact(at: Pos2) -> DVec2 {
    DVec2::new(at.x.into(), at.y.into())
}

fn rounded(at: &DVec2) -> Pos2 {
    pos2(at.x as f32, at.y as f32)
}

/// Converts a rectangle of the screen to double precision.
pub fn area(rect: Rect) -> Area {
    Area {
        min: exact(rect.min),
        max: exact(rect.max),
    }
}

/// Returns the painter's clip rectangle with a margin for a stroke of `width`; points.
fn sight(painter: &Painter, width: f32) -> Area {
    area(painter.clip_rect().expand(2.0 * width))
}

/// Returns the area of the whole window; points.
pub fn window(painter: &Painter) -> Area {
    area(painter.ctx().content_rect())
}

/// Returns the strokes of a line that is visible on any picture: a dark one, and a narrower white one over it. `widths` are in
/// points, `alphas` the opacities of black and white.
pub fn cased(widths: [f32; 2], alphas: [u8; 2]) -> [Stroke; 2] {
    [
        Stroke::new(widths[0], Color32::from_black_alpha(alphas[0])),
        Stroke::new(widths[1], Color32::from_white_alpha(alphas[1])),
    ]
}

/// Draws a line through points of the screen. `dashes` are alternating lengths of dashes and gaps; empty for a solid
/// line.
pub fn line(
    painter: &Painter,
    points: impl IntoIterator<Item = DVec2>,
    stroke: Stroke,
    dashes: &[f32],
) {
    for run in clipped(points, &sight(painter, stroke.width)) {
        let mut points: Vec<Pos2> = run.points.iter().map(rounded).collect();
        // A segment of zero length has no direction for its dashes.
        points.dedup();
        if points.len() < 2 {
            continue;
        }
        if dashes.is_empty() {
            painter.add(Shape::line(points, stroke));
            continue;
        }
        // The dashes start at the beginning of the line, also where it is clipped.
        let dashed = dashed(&points, dashes, run.start);
        painter.extend(dashed.into_iter().map(|dash| Shape::line(dash, stroke)));
    }
}

/// Returns the dashes of the part of a line that begins `start` points after the line itself.
///
/// A dash is one path over all segments that it crosses: egui moves the ends of a level segment of its own to the middle of
/// pixels, where a short one has no length left.
fn dashed(points: &[Pos2], dashes: &[f32], start: f64) -> Vec<Vec<Pos2>> {
    let period = f64::from(dashes.iter().sum::<f32>());
    // The current dash or gap, and the length that is left of it.
    let (mut index, mut left) = (0, dashes[0] - start.rem_euclid(period) as f32);
    while left <= 0.0 {
        index = (index + 1) % dashes.len();
        left += dashes[index];
    }
    let mut found = Vec::new();
    let mut dash = vec![points[0]];
    for &[from, to] in points.array_windows() {
        let length = from.distance(to);
        let mut at = 0.0;
        while length - at > left {
            at += left;
            let end = from.lerp(to, at / length);
            dash.push(end);
            let done = std::mem::replace(&mut dash, vec![end]);
            found.extend((index % 2 == 0).then_some(done));
            index = (index + 1) % dashes.len();
            left = dashes[index];
        }
        left -= length - at;
        dash.push(to);
    }
    found.extend((index % 2 == 0).then_some(dash));
    found.iter_mut().for_each(Vec::dedup);
    found.retain(|dash| dash.len() > 1);
    found
}

/// Draws a closed line through points of the screen.
pub fn outline(painter: &Painter, points: &[DVec2], stroke: Stroke) {
    let sight = sight(painter, stroke.width);
    if points.iter().all(|at| sight.contains(*at)) {
        let points = points.iter().map(rounded).collect();
        painter.add(Shape::closed_line(points, stroke));
    } else {
        let points = points.iter().chain(points.first()).copied();
        line(painter, points, stroke, &[]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use eframe::egui::{Color32, Context, LayerId, Rect};

    fn drawn(points: &[[f64; 2]], dashes: &[f32]) -> Vec<Shape> {
        let ctx = Context::default();
        let mut output = ctx.run_ui(Default::default(), |ui| {
            let rect = Rect::from_min_max(pos2(0.0, 0.0), pos2(100.0, 100.0));
            let painter = Painter::new(ui.ctx().clone(), LayerId::background(), rect);
            line(
                &painter,
                points.iter().map(|at| DVec2::from_array(*at)),
                Stroke::new(2.0, Color32::WHITE),
                dashes,
            );
        });
        output.textures_delta.clear();
        std::mem::take(&mut output.shapes)
            .into_iter()
            .map(|clipped| clipped.shape)
            .collect()
    }

    #[test]
    fn a_dashed_line_that_touches_the_border_in_a_point_is_not_drawn() {
        assert_eq!(
            drawn(&[[-10.0, 50.0], [-4.0, 50.0], [-10.0, 60.0]], &[6.0, 4.0]),
            []
        );
        let shapes = drawn(
            &[
                [-30.0, 50.0],
                [10.0, 50.0],
                [10.0 + 1e-12, 50.0],
                [40.0, 50.0],
            ],
            &[6.0, 4.0],
        );
        let finite = shapes
            .iter()
            .all(|shape| shape.visual_bounding_rect().is_finite());
        assert!(!shapes.is_empty() && finite, "{shapes:?}");
    }

    #[test]
    fn dashes_run_on_over_short_segments() {
        let pattern = [5.5, 2.0, 1.3, 2.0];
        let ends = |points: &[Pos2]| -> Vec<[f32; 2]> {
            let dashes = dashed(points, &pattern, 3.0);
            dashes
                .iter()
                .map(|dash| [dash[0].x, dash[dash.len() - 1].x])
                .collect()
        };
        let whole = ends(&[pos2(0.0, 5.0), pos2(60.0, 5.0)]);
        let short: Vec<Pos2> = (0..=100).map(|i| pos2(0.6 * i as f32, 5.0)).collect();
        let split = ends(&short);
        assert_eq!(split.len(), whole.len());
        for (split, whole) in split.iter().zip(&whole) {
            let off = (split[0] - whole[0]).abs().max((split[1] - whole[1]).abs());
            assert!(off < 1e-3, "{split:?} {whole:?}");
        }
        assert_eq!(whole[0], [0.0, 2.5]);
        assert!((whole[1][0] - 4.5).abs() < 1e-5 && (whole[1][1] - 5.8).abs() < 1e-5);
    }

    #[test]
    fn a_line_out_of_all_proportion_has_as_many_dashes_as_are_seen() {
        for far in [1e6, 1e12, 1e30, f64::MAX, f64::INFINITY, f64::NAN] {
            for dashes in [&[][..], &[6.0, 4.0]] {
                let shapes = drawn(
                    &[[10.0, 50.0], [50.0, far], [50.0, -far], [90.0, 50.0]],
                    dashes,
                );
                assert!(shapes.len() <= 40, "{far}: {} shapes", shapes.len());
                let near = Rect::from_min_max(pos2(-20.0, -20.0), pos2(120.0, 120.0));
                assert!(
                    shapes
                        .iter()
                        .all(|shape| near.contains_rect(shape.visual_bounding_rect())),
                    "{far}"
                );
            }
        }
    }
}
