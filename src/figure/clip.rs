//! Lines clipped to where they can be seen, before they are dashed, stroked or handed to a window.
//!
//! A curve may leave its plot by ten orders of magnitude: dashing all of it would take all memory.

use super::labels::Area;
use glam::DVec2;

/// A connected part of a line.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    pub points: Vec<DVec2>,
    /// Length of the line up to this part, so that dashes stay in step.
    pub start: f64,
}

/// The parts of the line through `points` that lie within `area`. Segments with an end that is not finite are left out.
pub fn clipped(points: impl IntoIterator<Item = DVec2>, area: &Area) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    let mut last: Option<DVec2> = None;
    let mut travelled = 0.0;
    for point in points {
        let before = last.replace(point);
        let Some(before) = before.filter(|before| before.is_finite() && point.is_finite()) else { continue };
        if let Some((from, to)) = segment(before, point, area) {
            match runs.last_mut().filter(|run| run.points.last() == Some(&from)) {
                Some(run) => run.points.push(to),
                None => runs.push(Run { points: vec![from, to], start: travelled + from.distance(before) }),
            }
        }
        travelled += before.distance(point);
    }
    runs
}

/// Whether a filled shape is to be drawn: it reaches into `area` and does not dwarf it, as one does that perspective blew up
/// beyond meaning.
pub fn can_be_filled(points: &[DVec2], area: &Area) -> bool {
    let bounds = points.iter().copied().map(|point| (point, point));
    let Some((min, max)) = bounds.reduce(|(a, b), (c, d)| (a.min(c), b.max(d))) else { return false };
    let seen = min.cmple(area.max).all() && max.cmpge(area.min).all();
    seen && points.iter().all(|point| point.is_finite()) && (max - min).cmple((area.max - area.min) * 4.0).all()
}

/// The part of the segment from `a` to `b` within `area` (Liang and Barsky 1984).
fn segment(a: DVec2, b: DVec2, area: &Area) -> Option<(DVec2, DVec2)> {
    // From the end that is nearer, so that one out of all proportion takes no digits from what is seen.
    if a.length_squared() > b.length_squared() {
        return segment_from(b, a, area).map(|(to, from)| (from, to));
    }
    segment_from(a, b, area)
}

fn segment_from(near: DVec2, far: DVec2, area: &Area) -> Option<(DVec2, DVec2)> {
    let along = far - near;
    let (mut enter, mut leave) = (0.0f64, 1.0f64);
    for axis in 0..2 {
        let (low, high) = (area.min[axis] - near[axis], area.max[axis] - near[axis]);
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
        // Rounding must not lead out again.
        t => (near + along * t).clamp(area.min, area.max),
    };
    (enter <= leave && along.is_finite()).then(|| (at(enter), at(leave)))
}

#[cfg(test)]
mod tests {
    use super::*;

    const AREA: Area = Area { min: DVec2::ZERO, max: DVec2::splat(10.0) };

    fn runs(points: &[(f64, f64)]) -> Vec<Run> {
        clipped(points.iter().map(|(x, y)| DVec2::new(*x, *y)), &AREA)
    }

    #[test]
    fn a_line_that_leaves_and_returns_is_two_lines() {
        let runs = runs(&[(0.0, 5.0), (4.0, -5.0), (8.0, 5.0), (9.0, 5.0)]);
        assert_eq!(runs.len(), 2, "{runs:?}");
        assert_eq!((runs[0].points[1], runs[1].points[0]), (DVec2::new(2.0, 0.0), DVec2::new(6.0, 0.0)));
        assert_eq!((runs[0].start, runs[1].points.len()), (0.0, 3));
        let leg = 116.0_f64.sqrt();
        assert!((runs[1].start - 1.5 * leg).abs() < 1e-9, "{}", runs[1].start);
    }

    #[test]
    fn whatever_the_numbers_what_is_left_is_inside() {
        let numbers = [0.0, 5.0, -7.0, 1e18, -1e30, 1e300, f64::MAX, -f64::MAX, f64::INFINITY, f64::NAN];
        let points = || numbers.iter().flat_map(|x| numbers.iter().map(move |y| (*x, *y)));
        for (a, b) in points().flat_map(|a| points().map(move |b| (a, b))) {
            for run in runs(&[a, b, (5.0, 5.0)]) {
                let inside = |p: &DVec2| AREA.holds(&Area { min: *p, max: *p });
                assert!(run.points.iter().all(inside), "{a:?} {b:?}: {run:?}");
            }
        }
    }

    #[test]
    fn a_segment_to_an_end_far_away_keeps_its_direction() {
        for far in [1e6, 1e18, 1e300] {
            let seen = runs(&[(5.0, 5.0), (5.0, far)]);
            assert_eq!(seen, [Run { points: vec![DVec2::new(5.0, 5.0), DVec2::new(5.0, 10.0)], start: 0.0 }]);
        }
    }

    #[test]
    fn a_shape_beyond_all_proportion_is_not_filled() {
        let triangle = |size: f64| [DVec2::ZERO, DVec2::new(size, 0.0), DVec2::new(0.0, size)];
        assert!(can_be_filled(&triangle(20.0), &AREA));
        for size in [1e9, f64::INFINITY, f64::NAN] {
            assert!(!can_be_filled(&triangle(size), &AREA), "{size}");
        }
        assert!(!can_be_filled(&triangle(2.0).map(|point| point - 50.0), &AREA), "out of sight");
    }
}
