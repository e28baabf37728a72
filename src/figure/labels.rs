//! Finding room for letters: near what they name, inside the picture, off the lines and off one another.

use super::drawing::{Shape, Text};
use super::palette::Rgb8;
use glam::DVec2;

/// Turns away from the wanted direction that are tried, in degrees.
const TURNS: [f64; 12] = [0.0, 25.0, -25.0, 50.0, -50.0, 80.0, -80.0, 110.0, -110.0, 145.0, -145.0, 180.0];
/// Distances that are tried, in text sizes beyond the clearance.
const DISTANCES: [f64; 7] = [0.0, 0.3, 0.7, 1.2, 1.8, 2.5, 3.5];
/// What a text size of distance, a half turn, and a text size of covered line cost.
const COST: [f64; 3] = [1.0, 1.0, 5.0];
/// Places along each side of the picture that are tried when there is no room near the anchor.
const GRID: u32 = 24;

/// A curve counts as an obstacle by about this many chords.
const CHORDS: usize = 12;

/// A rectangle in pixels, y downwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Area {
    /// Top left corner.
    pub min: DVec2,
    /// Bottom right corner.
    pub max: DVec2,
}

impl Area {
    /// The area of `size` about `centre`.
    pub fn about(centre: DVec2, size: DVec2) -> Self {
        Self { min: centre - size * 0.5, max: centre + size * 0.5 }
    }

    /// Its middle.
    pub fn centre(&self) -> DVec2 {
        (self.min + self.max) * 0.5
    }

    /// Its corners, clockwise from the top left.
    pub fn corners(&self) -> Vec<DVec2> {
        vec![self.min, DVec2::new(self.max.x, self.min.y), self.max, DVec2::new(self.min.x, self.max.y)]
    }

    /// Whether `other` lies within, edges included.
    pub fn holds(&self, other: &Self) -> bool {
        other.min.cmpge(self.min).all() && other.max.cmple(self.max).all()
    }

    /// Whether the two share more than an edge.
    pub fn overlaps(&self, other: &Self) -> bool {
        self.min.cmplt(other.max).all() && other.min.cmplt(self.max).all()
    }

    /// The point of the area next to `point`.
    pub fn nearest(&self, point: DVec2) -> DVec2 {
        point.clamp(self.min, self.max)
    }

    /// Length of the segment from `a` to `b` inside.
    fn covers(&self, a: DVec2, b: DVec2) -> f64 {
        // Most segments are nowhere near.
        if a.max(b).cmple(self.min).any() || a.min(b).cmpge(self.max).any() {
            return 0.0;
        }
        let along = b - a;
        let (mut enter, mut leave) = (0.0f64, 1.0f64);
        for axis in 0..2 {
            if along[axis] == 0.0 {
                if a[axis] <= self.min[axis] || a[axis] >= self.max[axis] {
                    return 0.0;
                }
                continue;
            }
            let (t, u) = ((self.min[axis] - a[axis]) / along[axis], (self.max[axis] - a[axis]) / along[axis]);
            enter = enter.max(t.min(u));
            leave = leave.min(t.max(u));
        }
        (leave - enter).max(0.0) * along.length()
    }
}

/// A text in the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    pub text: String,
    /// What it covers, halo included.
    pub area: Area,
    /// Size of the type, pixels an em.
    pub size: f64,
    pub colour: Rgb8,
}

impl Label {
    /// The text in the middle of its area.
    pub fn to_text(&self, halo: f64) -> Text {
        Text { halo, ..Text::centred(&self.text, self.area.centre(), self.size, self.colour) }
    }
}

/// A text that wants a place.
pub(crate) struct Wish {
    /// What it names.
    pub anchor: DVec2,
    /// Where it would like to stand as seen from the anchor; unit, or zero for no preference.
    pub direction: DVec2,
    /// Extent with its halo.
    pub size: DVec2,
    /// Least distance from the anchor.
    pub clearance: f64,
}

/// Places labels one after another.
pub(crate) struct Placer {
    bounds: Area,
    text_size: f64,
    taken: Vec<Area>,
    segments: Vec<(DVec2, DVec2)>,
}

impl Placer {
    /// A placer for labels within `bounds`, off `shapes`.
    pub fn new(bounds: Area, text_size: f64, shapes: &[Shape]) -> Self {
        let mut segments = Vec::new();
        for shape in shapes {
            let coarse: Vec<DVec2> = shape.points.iter().copied().step_by(1 + shape.points.len() / CHORDS).collect();
            segments.extend(coarse.windows(2).filter_map(|ends| match ends {
                &[a, b] => Some((a, b)),
                _ => None,
            }));
        }
        Self { bounds, text_size, taken: Vec::new(), segments }
    }

    /// Keeps labels out of `area`.
    pub fn reserve(&mut self, area: Area) {
        self.taken.push(area);
    }

    /// The best free place, or nothing where the picture has no room. The place is taken from then on.
    pub fn place(&mut self, wish: &Wish) -> Option<Area> {
        let area = self.beside(wish).or_else(|| self.anywhere(wish))?;
        self.taken.push(area);
        Some(area)
    }

    fn beside(&self, wish: &Wish) -> Option<Area> {
        let towards = wish.direction.try_normalize().unwrap_or(DVec2::new(-0.8, -0.6));
        let mut best: Option<(f64, Area)> = None;
        for distance in DISTANCES {
            for turn in TURNS {
                let turned = if wish.direction == DVec2::ZERO { 0.0 } else { turn.abs() / 180.0 };
                let dearest = COST[0] * distance + COST[1] * turned;
                if best.is_some_and(|(cost, _)| cost <= dearest) {
                    continue;
                }
                let way = DVec2::from_angle(turn.to_radians()).rotate(towards);
                let reach = (wish.size * 0.5).dot(way.abs()) + wish.clearance + distance * self.text_size;
                let area = Area::about(wish.anchor + way * reach, wish.size);
                self.consider(area, dearest, &mut best);
            }
        }
        best.map(|(_, area)| area)
    }

    fn anywhere(&self, wish: &Wish) -> Option<Area> {
        let room = self.bounds.max - self.bounds.min - wish.size;
        if room.min_element() < 0.0 {
            return None;
        }
        let mut best = None;
        for row in 0..=GRID {
            for column in 0..=GRID {
                let share = DVec2::new(f64::from(column), f64::from(row)) / f64::from(GRID);
                let area = Area::about(self.bounds.min + wish.size * 0.5 + room * share, wish.size);
                let distance = (area.nearest(wish.anchor) - wish.anchor).length() / self.text_size;
                self.consider(area, COST[0] * distance, &mut best);
            }
        }
        best.map(|(_, area)| area)
    }

    fn consider(&self, area: Area, base: f64, best: &mut Option<(f64, Area)>) {
        if best.is_some_and(|(cost, _)| cost <= base) || !self.free(&area) {
            return;
        }
        let covered: f64 = self.segments.iter().map(|&(a, b)| area.covers(a, b)).sum();
        let cost = base + COST[2] * covered / self.text_size;
        if best.is_none_or(|(least, _)| cost < least) {
            *best = Some((cost, area));
        }
    }

    fn free(&self, area: &Area) -> bool {
        area.min.is_finite() && self.bounds.holds(area) && !self.taken.iter().any(|taken| taken.overlaps(area))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOUNDS: Area = Area { min: DVec2::ZERO, max: DVec2::new(100.0, 100.0) };

    fn wish(x: f64, y: f64) -> Wish {
        Wish { anchor: DVec2::new(x, y), direction: DVec2::X, size: DVec2::new(20.0, 10.0), clearance: 2.0 }
    }

    #[test]
    fn a_label_stands_where_it_wants_when_there_is_room() {
        let mut placer = Placer::new(BOUNDS, 10.0, &[]);
        assert_eq!(placer.place(&wish(50.0, 50.0)), Some(Area::about(DVec2::new(62.0, 50.0), DVec2::new(20.0, 10.0))));
    }

    #[test]
    fn a_label_avoids_a_line() {
        let line = Shape::line(vec![DVec2::new(50.0, 50.0), DVec2::new(100.0, 50.0)], 1.0, [0; 3]);
        let area = Placer::new(BOUNDS, 10.0, &[line]).place(&wish(50.0, 50.0)).expect("room enough");
        assert!(area.max.y <= 50.0 || area.min.y >= 50.0, "{area:?}");
    }

    #[test]
    fn labels_fill_the_picture_without_overlap_and_then_give_up() {
        let mut placer = Placer::new(BOUNDS, 10.0, &[]);
        let placed: Vec<Area> = (0..100).map_while(|_| placer.place(&wish(95.0, 5.0))).collect();
        assert!((10..=50).contains(&placed.len()), "{} labels of 200 pixels in 10000", placed.len());
        for (i, a) in placed.iter().enumerate() {
            assert!(BOUNDS.holds(a));
            assert!(placed.iter().skip(i + 1).all(|b| !a.overlaps(b)));
        }
    }

    #[test]
    fn a_label_larger_than_the_picture_is_left_out() {
        let large = Wish { size: DVec2::splat(101.0), ..wish(50.0, 50.0) };
        assert_eq!(Placer::new(BOUNDS, 10.0, &[]).place(&large), None);
    }

    #[test]
    fn the_covered_length_of_a_segment() {
        let area = Area { min: DVec2::ZERO, max: DVec2::splat(10.0) };
        assert_eq!(area.covers(DVec2::new(-5.0, 5.0), DVec2::new(5.0, 5.0)), 5.0);
        assert_eq!(area.covers(DVec2::new(-5.0, 15.0), DVec2::new(5.0, 15.0)), 0.0);
    }
}
