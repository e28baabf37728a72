//! Placement of letters: near the things that they name, inside the picture, off the lines and off one another.

use super::area::Area;
use super::drawing::{Shape, Text};
use super::palette::Rgb8;
use glam::DVec2;

/// Turns away from the preferred direction to try, in degrees.
const TURNS: [f64; 12] = [
    0.0, 25.0, -25.0, 50.0, -50.0, 80.0, -80.0, 110.0, -110.0, 145.0, -145.0, 180.0,
];
/// Distances to try, in text sizes beyond the clearance.
const DISTANCES: [f64; 7] = [0.0, 0.3, 0.7, 1.2, 1.8, 2.5, 3.5];
/// Costs of a text size of distance, of a half turn, and of a text size of covered line.
const COST: [f64; 3] = [1.0, 1.0, 5.0];
/// Number of places to try along each side of the picture if there is no space near the anchor.
const GRID: u32 = 24;
/// Approximate number of chords by which a curve counts as an obstacle.
const CHORDS: usize = 12;

/// A text in the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// The text.
    pub text: String,
    /// Area that it covers, halo included.
    pub area: Area,
    /// Text size, pixels an em.
    pub size: f64,
    /// Colour as stored: red, green and blue.
    pub colour: Rgb8,
}

impl Label {
    /// Returns the text in the middle of its area.
    pub fn to_text(&self, halo: f64) -> Text {
        Text::centred(&self.text, self.area.centre(), self.size, self.colour).haloed(halo)
    }
}

/// A text to be placed.
#[derive(Clone, Copy, Debug)]
pub struct Wish {
    /// The point that it names.
    pub anchor: DVec2,
    /// Preferred direction from the anchor: a unit vector, or zero for no preference.
    pub direction: DVec2,
    /// Extent with its halo.
    pub size: DVec2,
    /// Minimum distance from the anchor.
    pub clearance: f64,
}

/// A placer of labels one after another.
#[derive(Clone, Debug)]
pub struct Placer {
    bounds: Area,
    text_size: f64,
    taken: Vec<Area>,
    segments: Vec<[DVec2; 2]>,
    /// The best place found so far for the current label, and its cost.
    best: Option<(f64, Area)>,
}

impl Placer {
    /// Creates a placer for labels within `bounds`, off `shapes` and out of `taken`.
    pub fn new(bounds: Area, text_size: f64, shapes: &[Shape], taken: Vec<Area>) -> Self {
        let mut segments = Vec::new();
        for shape in shapes {
            let coarse: Vec<DVec2> = shape
                .points
                .iter()
                .copied()
                .step_by(1 + shape.points.len() / CHORDS)
                .collect();
            segments.extend(coarse.array_windows::<2>());
        }
        Self {
            bounds,
            text_size,
            taken,
            segments,
            best: None,
        }
    }

    /// Returns the best free place, or none if the picture has no space. The place is reserved from then on.
    pub fn place(&mut self, wish: &Wish) -> Option<Area> {
        self.best = None;
        self.try_beside(wish);
        if self.best.is_none() {
            self.try_anywhere(wish);
        }
        let (_, area) = self.best?;
        self.taken.push(area);
        Some(area)
    }

    fn try_beside(&mut self, wish: &Wish) {
        let towards = wish
            .direction
            .try_normalize()
            .unwrap_or(DVec2::new(-0.8, -0.6));
        for distance in DISTANCES {
            for turn in TURNS {
                let turned = if wish.direction == DVec2::ZERO {
                    0.0
                } else {
                    turn.abs() / 180.0
                };
                let way = DVec2::from_angle(turn.to_radians()).rotate(towards);
                let reach =
                    (wish.size * 0.5).dot(way.abs()) + wish.clearance + distance * self.text_size;
                let area = Area::about(wish.anchor + way * reach, wish.size);
                self.consider(area, COST[0] * distance + COST[1] * turned);
            }
        }
    }

    fn try_anywhere(&mut self, wish: &Wish) {
        let slack = self.bounds.max - self.bounds.min - wish.size;
        if slack.min_element() < 0.0 {
            return;
        }
        for row in 0..=GRID {
            for column in 0..=GRID {
                let share = DVec2::new(f64::from(column), f64::from(row)) / f64::from(GRID);
                let area =
                    Area::about(self.bounds.min + wish.size * 0.5 + slack * share, wish.size);
                let distance = (area.nearest(wish.anchor) - wish.anchor).length() / self.text_size;
                self.consider(area, COST[0] * distance);
            }
        }
    }

    /// Keeps a place that costs `base` besides the lines it covers, if it is free and better than the best so far.
    fn consider(&mut self, area: Area, base: f64) {
        let lowest = self.best.map_or(f64::INFINITY, |(cost, _)| cost);
        let inside = area.min.is_finite() && self.bounds.holds(&area);
        if lowest <= base || !inside || self.taken.iter().any(|taken| taken.overlaps(&area)) {
            return;
        }
        let covered: f64 = self.segments.iter().map(|[a, b]| area.covers(*a, *b)).sum();
        let cost = base + COST[2] * covered / self.text_size;
        if cost < lowest {
            self.best = Some((cost, area));
        }
    }
}
