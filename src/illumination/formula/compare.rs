//! The comparison of two formulas as functions, at points of a domain, its corners and edges first.

use super::function::{FormulaFunction, Outcome};

/// The ranges of the names of a formula.
#[derive(Clone, Debug, PartialEq)]
pub struct Domain {
    ranges: Vec<[f64; 2]>,
}

/// A point at which two formulas differ.
#[derive(Clone, Debug, PartialEq)]
pub struct Counterexample {
    /// The values of the names.
    pub values: Vec<f64>,
    /// The results of the first and of the second formula.
    pub results: [Outcome; 2],
}

impl Domain {
    /// The number of points at which formulas are compared.
    pub const POINTS: usize = 4096;

    /// Creates the domain with a range for each name.
    pub fn new(ranges: impl Into<Vec<[f64; 2]>>) -> Self {
        Self {
            ranges: ranges.into(),
        }
    }

    /// Returns [`Self::POINTS`] points: corners, centres of edges and faces, then points that fill the domain evenly.
    ///
    /// A corner has each name at an end or in the middle of its range, in the order of the numbers in base 3; where 0 or 1
    /// lies within a range, that is tried in place of the middle in turn. The rest is the additive recurrence of Roberts
    /// (2018) with the powers of the generalised golden ratio.
    pub fn points(&self) -> Vec<Vec<f64>> {
        let count = self.ranges.len();
        let corners = 3_usize.checked_pow(count as u32).unwrap_or(usize::MAX);
        let corners = corners.min(Self::POINTS / 4);
        let mut points: Vec<Vec<f64>> = (0..corners).map(|corner| self.corner(corner)).collect();
        let ratio = golden(count);
        for place in 0..Self::POINTS.saturating_sub(points.len()) {
            let at = |(axis, [from, to]): (usize, &[f64; 2])| {
                let step = ratio.powi(-(axis as i32 + 1));
                let t = (0.5 + step * (place + 1) as f64).fract();
                t.mul_add(to - from, *from)
            };
            points.push(self.ranges.iter().enumerate().map(at).collect());
        }
        points
    }

    fn corner(&self, corner: usize) -> Vec<f64> {
        let mut left = corner;
        let at = |[from, to]: &[f64; 2]| {
            let digit = left % 3;
            left /= 3;
            let inside = |value: f64| (*from < value && value < *to).then_some(value);
            let middle = inside(0.0).or_else(|| inside(1.0));
            match digit {
                0 => *from,
                1 => *to,
                _ => middle.unwrap_or(0.5 * (from + to)),
            }
        };
        self.ranges.iter().map(at).collect()
    }

    /// Returns the point of the domain where two formulas differ most; none if they differ nowhere by more than `tolerance`
    /// times the larger of 1 and their size. A point where only one has a value is a difference.
    pub fn difference(
        &self,
        first: &FormulaFunction,
        second: &FormulaFunction,
        tolerance: f64,
    ) -> Option<Counterexample> {
        let points = self.points();
        let [a, b] = [first.at_all(&points), second.at_all(&points)];
        let excess = |a: &Outcome, b: &Outcome| {
            if a.undefined != b.undefined {
                return f64::INFINITY;
            }
            if a.value == b.value {
                return 0.0;
            }
            let size = a.value.abs().max(b.value.abs()).max(1.0);
            (a.value - b.value).abs() / size
        };
        let all = points.into_iter().zip(a.into_iter().zip(b));
        let (_, values, results) = all
            .map(|(values, (a, b))| (excess(&a, &b), values, [a, b]))
            .filter(|(excess, ..)| *excess > tolerance || excess.is_nan())
            .max_by(|(a, ..), (b, ..)| a.total_cmp(b))?;
        Some(Counterexample { values, results })
    }
}

/// Returns the root above 1 of `x^(count + 1) = x + 1`.
fn golden(count: usize) -> f64 {
    let exponent = 1.0 / (count as f64 + 1.0);
    (0..32).fold(2.0_f64, |x, _| (1.0 + x).powf(exponent))
}
