//! Thin strokes by the thousand, a path of which would take tens of milliseconds to fill: each touches only the hundred
//! pixels nearby. Coverage is `½ − d`, clamped to 0 to 1, with d the distance from the stroke's edge in pixels: exact
//! for a straight edge along the grid, off by less than a tenth for any other.

use crate::figure::palette::Rgb8;
use glam::{DVec2, Vec2};
use tiny_skia::PixmapMut;

/// A straight stroke with round ends and a foot at its start, in pixels.
#[derive(Clone, Copy, Debug)]
pub struct Fine {
    pub foot: DVec2,
    pub tip: DVec2,
    pub width: f64,
    /// Half the width of the foot.
    pub breadth: f64,
    /// True for a square foot, false for a round one.
    pub square: bool,
    /// Lengths of a dash and of a gap; none for a solid stroke.
    pub dash: Option<[f64; 2]>,
}

impl Fine {
    /// Draws the stroke on a pixmap.
    pub fn draw(&self, pixmap: &mut PixmapMut<'_>, colour: Rgb8) {
        let [width, height] = [pixmap.width(), pixmap.height()].map(|side| side as usize);
        let (foot, way) = (self.foot.as_vec2(), (self.tip - self.foot).as_vec2());
        let (along, length) = (way.normalize_or_zero(), way.length());
        let (half, breadth) = (0.5 * self.width as f32, self.breadth as f32);
        let dash = self
            .dash
            .map(|[dash, gap]| [dash as f32, (dash + gap) as f32]);
        if !(foot.is_finite() && length.is_finite()) {
            return;
        }
        let coverage = |at: Vec2| {
            let from = at - foot;
            let travelled = along.dot(from);
            let mut line = inside(half - from.distance(along * travelled.clamp(0.0, length)));
            if let Some([dash, period]) = dash {
                let middle = 0.5 * dash;
                line *= inside(middle - (travelled.rem_euclid(period) - middle).abs());
            }
            let away = if self.square {
                from.abs().max_element()
            } else {
                from.length()
            };
            line.max(inside(breadth - away))
        };
        let (tip, reach) = (foot + along * length, half.max(breadth) + 1.0);
        // The casts saturate, which clips a stroke that lies outside.
        let rows = (foot.y.min(tip.y) - reach) as usize
            ..((foot.y.max(tip.y) + reach).ceil() as usize).min(height);
        for y in rows {
            // The columns within reach of the row's part of the stroke.
            let beside = |off: f32| (y as f32 + 0.5 + off - foot.y) / along.y;
            let travelled = if along.y == 0.0 {
                [0.0, length]
            } else {
                [-reach, reach].map(beside)
            };
            let [a, b] = travelled.map(|t| foot.x + along.x * t.clamp(0.0, length));
            let left = (a.min(b) - reach) as usize;
            let right = ((a.max(b) + reach).ceil() as usize).min(width);
            if left >= right {
                continue;
            }
            let row = &mut pixmap.data_mut()[4 * (y * width + left)..4 * (y * width + right)];
            for (x, pixel) in (left..).zip(row.as_chunks_mut::<4>().0) {
                let share = coverage(Vec2::new(x as f32 + 0.5, y as f32 + 0.5));
                if share > 0.0 {
                    over(pixel, colour, share);
                }
            }
        }
    }
}

/// Returns the coverage at a distance inside an edge.
fn inside(distance: f32) -> f32 {
    (0.5 + distance).clamp(0.0, 1.0)
}

/// Blends a colour over a premultiplied pixel.
fn over(pixel: &mut [u8; 4], [r, g, b]: Rgb8, share: f32) {
    for (stored, own) in pixel.iter_mut().zip([r, g, b, 255]) {
        // Rounded, since the cast truncates.
        *stored = (f32::from(own) * share + f32::from(*stored) * (1.0 - share) + 0.5) as u8;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tiny_skia::Pixmap;

    fn drawn(foot: DVec2, tip: DVec2, change: impl Fn(Fine) -> Fine) -> (Pixmap, f64) {
        let mut pixmap = Pixmap::new(24, 11).expect("not empty");
        let stroke = Fine {
            foot,
            tip,
            width: 2.0,
            breadth: 0.0,
            square: false,
            dash: None,
        };
        change(stroke).draw(&mut pixmap.as_mut(), [200, 100, 0]);
        let covered = pixmap
            .pixels()
            .iter()
            .map(|pixel| f64::from(pixel.alpha()) / 255.0)
            .sum();
        (pixmap, covered)
    }

    #[test]
    fn a_stroke_covers_its_area() {
        for (foot, tip) in [
            ((4.0, 5.5), (20.0, 5.5)),
            ((4.3, 3.1), (19.2, 8.4)),
            ((6.0, 2.0), (6.0, 9.0)),
        ] {
            let (foot, tip) = (DVec2::from(foot), DVec2::from(tip));
            let expected = 2.0 * foot.distance(tip) + std::f64::consts::PI;
            let (_, found) = drawn(foot, tip, |stroke| stroke);
            assert!(
                (found / expected - 1.0).abs() < 0.06,
                "{foot}: {found} of {expected}"
            );
        }
        let middle = DVec2::new(12.0, 5.5);
        let (_, foot) = drawn(middle, middle, |stroke| Fine {
            width: 0.0,
            breadth: 4.0,
            square: true,
            ..stroke
        });
        assert!((foot - 64.0).abs() < 1.5, "{foot}");
        let (left, right) = (DVec2::new(3.0, 5.5), DVec2::new(21.0, 5.5));
        let (_, dashed) = drawn(left, right, |stroke| Fine {
            dash: Some([3.0, 3.0]),
            ..stroke
        });
        assert!((dashed - 18.0).abs() < 2.5, "{dashed}");
    }

    #[test]
    fn what_lies_outside_leaves_no_trace_and_colours_stay_premultiplied() {
        for far in [
            DVec2::splat(1e9),
            DVec2::splat(-500.0),
            DVec2::NAN,
            DVec2::new(f64::INFINITY, 3.0),
        ] {
            assert_eq!(
                drawn(far, far + 3.0, |stroke| Fine {
                    breadth: 3.0,
                    ..stroke
                })
                .1,
                0.0
            );
        }
        let (left, right) = (DVec2::new(-90.0, 5.5), DVec2::new(90.0, 5.5));
        let (across, _) = drawn(left, right, |stroke| Fine {
            width: 3.3,
            breadth: 2.0,
            ..stroke
        });
        assert!(
            across
                .pixels()
                .iter()
                .all(|pixel| pixel.red() <= pixel.alpha() && pixel.green() <= pixel.alpha())
        );
        assert_eq!(across.pixel(0, 5).map(|pixel| pixel.alpha()), Some(255));
    }
}
