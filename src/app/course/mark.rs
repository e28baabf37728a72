//! The marks of a step over the picture: its line, the point that the student has marked, and the right one.

use crate::app::course::Course;
use crate::app::session::place::{Place, ProfileLine};
use crate::app::widgets::letter::letter;
use crate::app::widgets::palette;
use crate::figure::palette::Vector;
use crate::scene::place_to_pixel;
use crate::text::text;
use eframe::egui::{Align2, Color32, FontId, Painter, Pos2, Stroke, vec2};
use glam::DVec2;

/// The radius of a mark, in points.
const MARK: f32 = 8.0;

/// Paints the line and the marked and right points of the step.
pub fn paint(painter: &Painter, course: &Course, place: Place, font: &FontId) {
    let dark = |width| Stroke::new(width, Color32::from_black_alpha(170));
    let white = |width| Stroke::new(width, Color32::WHITE);
    let name = |at, align, text: &str| letter(painter, at, align, text, font, Color32::WHITE);
    if let Some((line, along)) = course.line() {
        let ends = ProfileLine(line)
            .pixels(place.size)
            .map(|end| place.point(end));
        painter.line_segment(ends, dark(3.5));
        painter.line_segment(ends, white(1.5));
        // If the ends are close together, their names are beside them.
        let close = ends[0].distance(ends[1]) < 3.0 * MARK;
        let sides = if close {
            [Align2::RIGHT_BOTTOM, Align2::LEFT_BOTTOM]
        } else {
            [Align2::CENTER_BOTTOM; 2]
        };
        for ((end, share), side) in ends.into_iter().zip(["0", "1"]).zip(sides) {
            painter.circle(end, 4.0, Color32::WHITE, dark(1.5));
            name(end + vec2(0.0, -8.0), side, share);
        }
        if let Some(along) = along {
            let at = ends[0] + (ends[1] - ends[0]) * along as f32;
            painter.circle(at, 5.0, palette::vector(Vector::L), dark(2.0));
        }
    }
    let size = DVec2::from_array(place.size.map(f64::from));
    let point = |at: DVec2| place.point(place_to_pixel(at, size));
    let right = course.right_places();
    let green = palette::vector(Vector::V);
    if let [only] = right {
        let at = point(*only);
        ring(painter, at, MARK + 4.0, green);
        let below = at + vec2(0.0, MARK + 8.0);
        name(below, Align2::CENTER_TOP, text!("course-mark-right"));
    } else {
        for at in right {
            painter.circle(point(*at), 2.5, green, dark(1.0));
        }
    }
    if let Some(at) = course.mark() {
        let at = point(at);
        for stroke in [dark(5.0), white(2.0)] {
            for way in [vec2(1.0, 1.0), vec2(1.0, -1.0)] {
                painter.line_segment([at - way * MARK, at + way * MARK], stroke);
            }
        }
        if !right.is_empty() {
            let above = at - vec2(0.0, MARK + 4.0);
            name(above, Align2::CENTER_BOTTOM, text!("course-mark-yours"));
        }
    }
}

fn ring(painter: &Painter, at: Pos2, radius: f32, colour: Color32) {
    painter.circle_stroke(at, radius, Stroke::new(5.5, Color32::from_black_alpha(170)));
    painter.circle_stroke(at, radius, Stroke::new(3.0, colour));
}
