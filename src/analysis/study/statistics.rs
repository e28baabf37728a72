//! Orders of convergence with their confidence, medians, and the Pareto front.

use serde::{Deserialize, Serialize};

/// Minimum number of points for fitting a slope with its confidence.
const LEAST: usize = 3;

/// Error below which rounding dominates, to single precision and of positions to 1/256 of a pixel.
const ROUNDING: f64 = 2e-6;

/// A straight line through points, by least squares: `y = offset + slope·x`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Fit {
    /// Change of y per unit of x.
    pub slope: f64,
    /// Value of y at x = 0.
    pub offset: f64,
    /// Half-width of the interval about the slope that contains the true one with a probability of 95 %, if the points
    /// scatter normally and independently: Student's t times the slope's standard error.
    pub confidence: f64,
    /// Number of points.
    pub points: usize,
}

/// Fits a line to `points`; none for fewer than three, or where all have the same x.
pub fn fit_line(points: &[[f64; 2]]) -> Option<Fit> {
    if points.len() < LEAST {
        return None;
    }
    let count = points.len() as f64;
    let mean = |axis: usize| points.iter().map(|point| point[axis]).sum::<f64>() / count;
    let (mx, my) = (mean(0), mean(1));
    let sxx: f64 = points.iter().map(|[x, _]| (x - mx).powi(2)).sum();
    let sxy: f64 = points.iter().map(|[x, y]| (x - mx) * (y - my)).sum();
    let slope = sxy / sxx;
    let offset = my - slope * mx;
    let left: f64 = points
        .iter()
        .map(|[x, y]| (y - offset - slope * x).powi(2))
        .sum();
    let confidence = student(points.len() - 2) * (left / (count - 2.0) / sxx).sqrt();
    (slope.is_finite() && confidence.is_finite()).then_some(Fit {
        slope,
        offset,
        confidence,
        points: points.len(),
    })
}

/// Fits the order p of an error proportional to hᵖ, from pairs of h and the error, without those at the level of
/// rounding.
pub fn order_of(errors: impl IntoIterator<Item = (f64, f64)>) -> Option<Fit> {
    let known = errors
        .into_iter()
        .filter(|(spacing, error)| *spacing > 0.0 && *error > ROUNDING && error.is_finite());
    let points: Vec<[f64; 2]> = known
        .map(|(spacing, error)| [spacing.ln(), error.ln()])
        .collect();
    fit_line(&points)
}

/// Returns Student's t such that ±t holds 95 %, for a number of degrees of freedom, from 1; beyond the table by the
/// first terms of Cornish and Fisher's expansion, off by less than 10⁻⁴.
pub fn student(freedom: usize) -> f64 {
    const TABLE: [f64; 30] = [
        12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228, 2.201, 2.179, 2.160,
        2.145, 2.131, 2.120, 2.110, 2.101, 2.093, 2.086, 2.080, 2.074, 2.069, 2.064, 2.060, 2.056,
        2.052, 2.048, 2.045, 2.042,
    ];
    if let Some(value) = freedom.checked_sub(1).and_then(|index| TABLE.get(index)) {
        return *value;
    }
    let z = 1.959_964_f64;
    let f = freedom.max(1) as f64;
    z + (z.powi(3) + z) / (4.0 * f)
        + (5.0 * z.powi(5) + 16.0 * z.powi(3) + 3.0 * z) / (96.0 * f * f)
}

/// Returns which pairs (time, error) no other beats in one without losing in the other: the Pareto front, never NaN.
pub fn pareto_front(points: &[[f64; 2]]) -> Vec<bool> {
    let beats = |a: &[f64; 2], b: &[f64; 2]| a[0] <= b[0] && a[1] <= b[1] && a != b;
    let on = |point: &[f64; 2]| {
        point.iter().all(|value| value.is_finite())
            && !points.iter().any(|other| beats(other, point))
    };
    points.iter().map(on).collect()
}

/// Returns the median and interquartile range of samples in nanoseconds, as milliseconds.
pub fn median_and_spread(samples: &mut [u64]) -> (f64, f64) {
    samples.sort_unstable();
    let milliseconds = |place: f64| samples[place as usize] as f64 / 1e6;
    let quantile = |share: f64| {
        let place = share * (samples.len() - 1) as f64;
        let (below, above) = (milliseconds(place.floor()), milliseconds(place.ceil()));
        below + (above - below) * place.fract()
    };
    if samples.is_empty() {
        (0.0, 0.0)
    } else {
        (quantile(0.5), quantile(0.75) - quantile(0.25))
    }
}
