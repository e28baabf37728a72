//! The places of a profile: equally spaced along the line and past its ends, as far as an eye's surround reaches.

use glam::DVec2;
use serde::Serialize;

/// A place of the line.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Sample {
    pub x: f64,
    pub y: f64,
    /// 0 at the line's beginning, 1 at its end.
    pub t: f64,
}

/// Samples to a pixel along the longer side of the line, and the length from which on there is one.
const FINENESS: f64 = 4.0;
const LONG: f64 = 4096.0;
/// How far past its ends the line is followed, in widths of the surround.
const REACH: f64 = 6.0;
/// Samples nearer to an end of the line than this share of their distance are that end.
const SAME: f64 = 1e-9;

/// A line through the picture. `s` runs from 0 to 1 over all that is followed, `t` from 0 to 1 between the ends asked for.
#[derive(Clone, Debug)]
pub struct Line {
    ends: [DVec2; 2],
    from: DVec2,
    along: DVec2,
    /// t of the first sample, and the step to the next.
    first: f64,
    step: f64,
    count: usize,
}

impl Line {
    /// The line between two places of a picture of `size`, followed for a surround of width `surround` pixels.
    pub fn new(from: DVec2, to: DVec2, size: [u32; 2], surround: f64) -> Option<Self> {
        let along = to - from;
        let longer = if along.x.abs() >= along.y.abs() { along.x } else { along.y };
        let begin = if along.x.abs() >= along.y.abs() { from.x } else { from.y };
        if longer.abs() < 1e-6 {
            return None;
        }
        let fineness = if longer.abs() > LONG { 1.0 } else { FINENESS };
        let (low, high) = in_picture(from, along, DVec2::from_array(size.map(f64::from)));
        let past = REACH * surround / along.length();
        let (low, high) = (low.max(-past).min(0.0), high.min(1.0 + past).max(1.0));
        // Samples have their longer coordinate at (k + ½)/fineness − ½/fineness: at centres, and evenly between them.
        let step = 1.0 / (longer.abs() * fineness);
        let offset = if fineness > 1.0 { 0.0 } else { 0.5 };
        let grid = |t: f64| (begin + t * longer - offset) * fineness * longer.signum();
        let first = (grid(low) - SAME).ceil();
        let last = (grid(high) + SAME).floor();
        let first_t = (first * longer.signum() / fineness + offset - begin) / longer;
        let count = (last - first + 1.0).max(0.0) as usize;
        if count == 0 {
            // Shorter than a step: its ends alone.
            return Some(Self { ends: [from, to], from, along, first: 0.0, step: 1.0, count: 2 });
        }
        Some(Self { ends: [from, to], from, along, first: first_t, step, count })
    }

    /// Distance between samples, pixels.
    pub fn spacing(&self) -> f64 {
        self.step * self.along.length()
    }

    /// The two places between which the picture is followed.
    pub fn extent(&self) -> [DVec2; 2] {
        [0.0, 1.0].map(|s| self.place(s))
    }

    #[expect(clippy::cast_precision_loss, reason = "fewer samples than 2⁵³")]
    fn span(&self) -> [f64; 2] {
        let end = self.first + self.step * (self.count - 1) as f64;
        [self.first.min(0.0), end.max(1.0)]
    }

    /// t of s.
    pub fn t(&self, s: f64) -> f64 {
        let [low, high] = self.span();
        low + s * (high - low)
    }

    /// s of t.
    pub fn s(&self, t: f64) -> f64 {
        let [low, high] = self.span();
        (t - low) / (high - low)
    }

    /// The place at s.
    pub fn place(&self, s: f64) -> DVec2 {
        self.at(self.t(s))
    }

    fn at(&self, t: f64) -> DVec2 {
        let at = self.from + self.along * t;
        // The ends are what was asked for, without a rounding.
        if t == 0.0 {
            self.ends[0]
        } else if t == 1.0 {
            self.ends[1]
        } else {
            at
        }
    }

    /// A pixel in units of s.
    pub fn pixel(&self) -> f64 {
        let [low, high] = self.span();
        1.0 / ((high - low) * self.along.length())
    }

    /// t of all that is followed.
    #[expect(clippy::cast_precision_loss, reason = "fewer samples than 2⁵³")]
    pub fn followed(&self) -> impl Iterator<Item = f64> {
        let (first, step) = (self.first, self.step);
        (0..self.count).map(move |k| first + step * k as f64)
    }

    /// The samples between the ends, these included.
    pub fn samples(&self) -> Vec<Sample> {
        let sample = |t: f64| {
            let DVec2 { x, y } = self.at(t);
            Sample { x, y, t }
        };
        let inner = self.followed().filter(|t| self.inner(*t)).map(sample);
        std::iter::once(sample(0.0)).chain(inner).chain([sample(1.0)]).collect()
    }

    fn inner(&self, t: f64) -> bool {
        let least = self.step * SAME;
        t > least && t < 1.0 - least
    }

    /// Of values at all places that are followed those of [`Line::samples`]; an end's own where it is given, otherwise linear
    /// between its neighbours.
    pub fn within(&self, values: &[f64], ends: [Option<f64>; 2]) -> Vec<f64> {
        let between = |t: f64| {
            let at = ((t - self.first) / self.step).clamp(0.0, (self.count - 1) as f64);
            let (k, share) = (at.floor() as usize, at.fract());
            let next = values.get(k + 1).or(values.last()).copied().unwrap_or_default();
            values.get(k).copied().unwrap_or_default() * (1.0 - share) + next * share
        };
        let inner = self.followed().zip(values).filter(|(t, _)| self.inner(*t)).map(|(_, value)| *value);
        let [first, last] = [0.0, 1.0].map(between);
        let first = std::iter::once(ends[0].unwrap_or(first));
        first.chain(inner).chain([ends[1].unwrap_or(last)]).collect()
    }
}

/// t between which the line is inside a picture.
fn in_picture(from: DVec2, along: DVec2, size: DVec2) -> (f64, f64) {
    let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
    for axis in 0..2 {
        if along[axis] != 0.0 {
            let (a, b) = (-from[axis] / along[axis], (size[axis] - from[axis]) / along[axis]);
            (low, high) = (low.max(a.min(b)), high.min(a.max(b)));
        }
    }
    (low, high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pixel_centre_on_the_line_is_a_sample() {
        for (from, to) in [([0.0, 20.5], [64.0, 20.5]), ([10.3, 20.5], [50.0, 20.5]), ([60.0, 61.0], [2.0, 3.0])] {
            let (from, to) = (DVec2::from(from), DVec2::from(to));
            let line = Line::new(from, to, [64, 64], 8.0).expect("a line");
            let samples = line.samples();
            assert!(samples.windows(2).all(|pair| pair[0].t < pair[1].t));
            assert_eq!((samples[0].t, samples[samples.len() - 1].t), (0.0, 1.0));
            let (low, high) = (from.x.min(to.x), from.x.max(to.x));
            for x in (0..64).map(|x| f64::from(x) + 0.5).filter(|x| (low..=high).contains(x)) {
                assert!(samples.iter().any(|sample| (sample.x - x).abs() < 1e-9), "{x} of {from} to {to}");
            }
        }
    }

    #[test]
    fn a_line_shorter_than_a_step_is_its_ends() {
        let line = Line::new(DVec2::new(3.3, 3.0), DVec2::new(3.4, 3.0), [9, 9], 0.0).expect("a line");
        assert_eq!(line.samples().len(), 2);
        assert!(Line::new(DVec2::ONE, DVec2::ONE, [9, 9], 1.0).is_none());
    }
}
