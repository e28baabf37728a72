//! Rectangles, and lines clipped to them before they are dashed, stroked or handed to a window.
//!
//! A curve may extend ten orders of magnitude beyond its plot: dashing all of it would exhaust the memory.

use glam::DVec2;

/// A rectangle in pixels, y downwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Area {
    /// Top left corner.
    pub min: DVec2,
    /// Bottom right corner.
    pub max: DVec2,
}

impl Area {
    /// Creates the area of `size` whose top left corner is the origin.
    pub fn from_size(size: DVec2) -> Self {
        Self {
            min: DVec2::ZERO,
            max: size,
        }
    }

    /// Creates the area of `size` about `centre`.
    pub fn about(centre: DVec2, size: DVec2) -> Self {
        Self {
            min: centre - size * 0.5,
            max: centre + size * 0.5,
        }
    }

    /// Returns the area without a margin on all sides; a negative one enlarges it.
    pub fn inset(&self, margin: f64) -> Self {
        Self {
            min: self.min + margin,
            max: self.max - margin,
        }
    }

    /// Returns its middle.
    pub fn centre(&self) -> DVec2 {
        (self.min + self.max) * 0.5
    }

    /// Returns its corners, clockwise from the top left.
    pub fn corners(&self) -> Vec<DVec2> {
        vec![
            self.min,
            DVec2::new(self.max.x, self.min.y),
            self.max,
            DVec2::new(self.min.x, self.max.y),
        ]
    }

    /// Returns whether `other` lies within, edges included.
    pub fn holds(&self, other: &Self) -> bool {
        other.min.cmpge(self.min).all() && other.max.cmple(self.max).all()
    }

    /// Returns whether `point` lies within, edges included.
    pub fn contains(&self, point: DVec2) -> bool {
        point.cmpge(self.min).all() && point.cmple(self.max).all()
    }

    /// Returns whether the two share more than an edge.
    pub fn overlaps(&self, other: &Self) -> bool {
        self.min.cmplt(other.max).all() && other.min.cmplt(self.max).all()
    }

    /// Returns the point of the area nearest to `point`.
    pub fn nearest(&self, point: DVec2) -> DVec2 {
        point.clamp(self.min, self.max)
    }

    /// Returns the length of the segment from `a` to `b` inside; 0 on an edge.
    pub fn covers(&self, a: DVec2, b: DVec2) -> f64 {
        // Most segments are nowhere near.
        if a.max(b).cmple(self.min).any() || a.min(b).cmpge(self.max).any() {
            return 0.0;
        }
        self.segment(a, b)
            .map_or(0.0, |(from, to)| from.distance(to))
    }

    /// Returns the part of the segment from `near` to `far` within (Liang and Barsky 1984).
    fn segment(&self, near: DVec2, far: DVec2) -> Option<(DVec2, DVec2)> {
        // From the nearer end, so that a far one out of all proportion costs no digits of the visible part.
        if near.length_squared() > far.length_squared() {
            return self.segment(far, near).map(|(to, from)| (from, to));
        }
        let along = far - near;
        let (mut enter, mut leave) = (0.0f64, 1.0f64);
        for axis in 0..2 {
            let (low, high) = (self.min[axis] - near[axis], self.max[axis] - near[axis]);
            if along[axis] == 0.0 {
                if low > 0.0 || high < 0.0 {
                    return None;
                }
                continue;
            }
            let (t, u) = (low / along[axis], high / along[axis]);
            (enter, leave) = (enter.max(t.min(u)), leave.min(t.max(u)));
        }
        let at = |t: f64| match t {
            t if t <= 0.0 => near,
            t if t >= 1.0 => far,
            // Rounding must not lead outside again.
            t => (near + along * t).clamp(self.min, self.max),
        };
        (enter <= leave && along.is_finite()).then(|| (at(enter), at(leave)))
    }
}

/// A connected part of a line.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// Points in pixels.
    pub points: Vec<DVec2>,
    /// Length of the line up to this part, so that dashes stay in step.
    pub start: f64,
}

/// Clips the line through `points` to `area`; returns its parts inside, without segments that are not finite.
pub fn clipped(points: impl IntoIterator<Item = DVec2>, area: &Area) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    let mut last: Option<DVec2> = None;
    let mut travelled = 0.0;
    for point in points {
        let before = last.replace(point);
        let Some(before) = before.filter(|before| before.is_finite() && point.is_finite()) else {
            continue;
        };
        if let Some((from, to)) = area.segment(before, point) {
            match runs
                .last_mut()
                .filter(|run| run.points.last() == Some(&from))
            {
                Some(run) => run.points.push(to),
                None => runs.push(Run {
                    points: vec![from, to],
                    start: travelled + from.distance(before),
                }),
            }
        }
        travelled += before.distance(point);
    }
    runs
}

/// Returns whether a filled shape is drawn: it overlaps `area` and is not enormous, as perspective can make one.
pub fn can_be_filled(points: &[DVec2], area: &Area) -> bool {
    let bounds = points.iter().copied().map(|point| (point, point));
    let Some((min, max)) = bounds.reduce(|(a, b), (c, d)| (a.min(c), b.max(d))) else {
        return false;
    };
    let seen = min.cmple(area.max).all() && max.cmpge(area.min).all();
    seen && points.iter().all(|point| point.is_finite())
        && (max - min).cmple((area.max - area.min) * 4.0).all()
}
