//! Single points and their names, each beside its point where nothing else stands.

use super::super::PlotStyle;
use super::super::data::{Plot, Point};
use crate::figure::drawing::{Drawing, Shape, Text, width_of};
use crate::figure::labels::Area;
use crate::figure::scale::Scale;
use glam::DVec2;

/// Radius of a point and of the hole in a ring, and the gap to its name, in ems.
const RADIUS: [f64; 2] = [0.3, 0.15];
const GAP: f64 = 0.2;
/// Size of the names, in that of other letters.
const LETTERS: f64 = 0.85;

/// Draws the points, then the names that find a place, those of the strong ones first.
pub fn points(drawing: &mut Drawing, plot: &Plot, scale: &Scale, area: &Area, style: &PlotStyle) {
    let em = style.text;
    let visible: Vec<(&Point, DVec2)> = plot
        .points
        .iter()
        .map(|point| (point, scale.place(point.at)))
        .filter(|(_, at)| at.is_finite() && area.holds(&Area { min: *at, max: *at }))
        .collect();
    for (point, at) in &visible {
        drawing.shapes.push(Shape::disc(*at, (RADIUS[0] + 0.07) * em, style.paper.ground));
        drawing.shapes.push(Shape::disc(*at, RADIUS[0] * em, style.paper.line(point.ink)));
        if point.hollow {
            drawing.shapes.push(Shape::disc(*at, RADIUS[1] * em, style.paper.ground));
        }
    }
    let mut taken: Vec<Area> =
        visible.iter().map(|(_, at)| Area::about(*at, DVec2::splat(2.0 * RADIUS[0] * em))).collect();
    for strong in [true, false] {
        for (index, (point, at)) in visible.iter().enumerate().filter(|(_, (point, _))| point.strong == strong) {
            let size = LETTERS * em;
            let half = DVec2::new(0.5 * width_of(&point.name, size), 0.5 * size);
            let away = half + (RADIUS[0] + GAP) * em;
            let free = |middle: &DVec2| {
                let place = Area::about(*middle, 2.0 * half);
                let clear = |(other, box_): (usize, &Area)| other == index || !place.overlaps(box_);
                area.holds(&place) && taken.iter().enumerate().all(clear)
            };
            let sides = [[1.0, 0.0], [0.0, -1.0], [-1.0, 0.0], [0.0, 1.0], [0.8, -0.8], [0.8, 0.8], [-0.8, -0.8]];
            let found = sides.map(|side| *at + away * DVec2::from_array(side)).into_iter().find(free);
            let Some(middle) = found else { continue };
            taken.push(Area::about(middle, 2.0 * half));
            let baseline = middle + DVec2::new(0.0, 0.34 * size);
            let text = Text::new(&point.name, baseline, size, style.paper.letters(point.ink)).aligned(0.5);
            drawing.texts.push(Text { strong, ..text.with_halo() });
        }
    }
}
