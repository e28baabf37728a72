//! Curves compared by value and shape: what a drawn curve is like, free of the pen's tremble.
//!
//! At each abscissa a straight line is fitted to the points about it, with weights that fall as a Gaussian: a local linear
//! regression (Cleveland 1979). It gives a value and a slope, of the drawn curve as of the one that it is compared with. Two
//! curves differ by their distance, measured across the curve where that is steep, and by their angles.

use crate::lesson::{CurveFault, Hint};

/// The standard deviation of the weights, in points.
const SMOOTHING: f64 = 2.5;
/// The height of the axes as a fraction of their width, as in the window: slopes are compared as they are seen.
const ASPECT: f64 = 0.5;
/// The distance, as a fraction of the height, that counts as much as an angle of one radian. With more, the trembling of a hand
/// would count as much as what it means to draw; with less, a chain of straight pieces could not be told from the smooth curve
/// through its corners (`tests/lessons/models.rs` draws both).
const TURN: f64 = 0.3;
/// The value and the slope below which a curve counts as zero and as level.
const ZERO: f64 = 0.01;
const LEVEL: f64 = 0.1;

/// A piece of a curve: value and slope of the line that fits best.
#[derive(Clone, Copy, Debug, Default)]
pub struct Piece {
    /// As a fraction of the axis' height, from its lower end.
    value: f64,
    /// Per width of the axis.
    slope: f64,
}

impl Piece {
    /// Returns the angle to the horizontal axis, radians.
    fn angle(self) -> f64 {
        (ASPECT * self.slope).atan()
    }

    /// Returns the vertical distance from another piece, measured across this one.
    fn above(self, other: Self) -> f64 {
        (self.value - other.value) * self.angle().cos()
    }

    /// Returns the angle by which it is steeper upwards than another one, as a distance.
    fn turned(self, other: Self) -> f64 {
        TURN * (self.angle() - other.angle())
    }
}

/// Returns the pieces of a curve at each of its points; `y` are the ends of the vertical axis.
pub fn pieces(points: &[Option<f64>], [low, high]: [f64; 2]) -> Vec<Piece> {
    let last = points.len().saturating_sub(1).max(1) as f64;
    let piece = |at: usize| {
        // The sums of the normal equations of the straight line.
        let [mut w, mut wx, mut wxx, mut wy, mut wxy] = [0.0; 5];
        for (index, value) in points.iter().enumerate() {
            let Some(value) = value else { continue };
            let x = index as f64 - at as f64;
            let weight = (-0.5 * (x / SMOOTHING).powi(2)).exp();
            let y = (value - low) / (high - low);
            w += weight;
            wx += weight * x;
            wxx += weight * x * x;
            wy += weight * y;
            wxy += weight * x * y;
        }
        let determinant = w * wxx - wx * wx;
        Piece {
            value: (wxx * wy - wx * wxy) / determinant,
            slope: last * (w * wxy - wx * wy) / determinant,
        }
    };
    (0..points.len()).map(piece).collect()
}

/// Returns how far a curve is from another one, as a fraction of the axis' height.
pub fn distance(given: &[Piece], model: &[Piece]) -> f64 {
    let squares = given.iter().zip(model).map(|(given, model)| {
        let [above, turned] = [given.above(*model), given.turned(*model)];
        above * above + turned * turned
    });
    (squares.sum::<f64>() / given.len().max(1) as f64).sqrt()
}

/// Returns where a curve is farthest from the right one, and how, on axes with these ends.
pub fn hint(given: &[Piece], right: &[Piece], [x, y]: [[f64; 2]; 2]) -> Hint {
    let pairs = || given.iter().zip(right);
    let above = Run::longest(pairs().map(|(given, right)| given.above(*right)));
    let turned = Run::longest(pairs().map(|(given, right)| given.turned(*right)));
    let by_value = above.weight >= turned.weight;
    let run = if by_value { above } else { turned };
    let [given, right_there] = [given, right].map(|pieces| &pieces[run.from..=run.to]);
    let zero = -y[0] / (y[1] - y[0]);
    let steepness = |pieces: &[Piece]| pieces.iter().map(|piece| piece.slope.abs()).sum::<f64>();
    let fault = if by_value {
        if !run.is_above {
            CurveFault::Low
        } else if right_there
            .iter()
            .all(|piece| (piece.value - zero).abs() < ZERO)
        {
            CurveFault::NotZero
        } else {
            CurveFault::High
        }
    } else if right_there.iter().all(|piece| piece.slope.abs() < LEVEL) {
        CurveFault::NotLevel
    } else if steepness(given) > 1.2 * steepness(right_there) {
        CurveFault::Steep
    } else if 1.2 * steepness(given) < steepness(right_there) {
        CurveFault::Shallow
    } else {
        CurveFault::Bent
    };
    let abscissa = |index: usize| x[0] + (x[1] - x[0]) * index as f64 / (right.len() - 1) as f64;
    Hint::Curve {
        fault,
        from: abscissa(run.from),
        to: abscissa(run.to),
    }
}

/// Neighbouring points at which one curve is on the same side of another.
#[derive(Clone, Copy, Debug, Default)]
struct Run {
    from: usize,
    to: usize,
    is_above: bool,
    weight: f64,
}

impl Run {
    /// Finds the run that weighs most, without its ends where the difference is small.
    fn longest(differences: impl Iterator<Item = f64>) -> Self {
        let differences: Vec<f64> = differences.collect();
        let largest = differences
            .iter()
            .fold(0.0, |most: f64, d| most.max(d.abs()));
        let mut best = Self::default();
        let mut run = Self::default();
        for (index, difference) in differences.iter().enumerate() {
            if difference.abs() < 0.3 * largest {
                run = Self::default();
                continue;
            }
            if run.weight == 0.0 || run.is_above != (*difference > 0.0) {
                run = Self {
                    from: index,
                    is_above: *difference > 0.0,
                    ..Self::default()
                };
            }
            run.to = index;
            run.weight += difference * difference;
            if run.weight > best.weight {
                best = run;
            }
        }
        best
    }
}
