//! Means weighted by Gaussians, along a line and over a picture.

use super::error_function::erfc;
use rayon::prelude::*;
use std::f64::consts::{PI, SQRT_2};

/// Beyond so many widths a Gaussian's part is under 10⁻⁹.
const REACH: f64 = 6.0;

/// Weights of the samples 0, 1, 2 … places away, and half of what lies beyond them: those of the other side are the same.
///
/// The samples are taken as joined by straight lines, and the Gaussian's mean of that is exact: a sample's weight is that of a
/// tent about it, the second difference of ψ(x) = x·Φ(x/σ) + σ·φ(x/σ), the Gaussian's second integral.
struct Kernel {
    weights: Vec<f64>,
}

impl Kernel {
    /// For a width of `sigma` samples, no longer than `longest`; what is cut off goes to the last weight.
    fn new(sigma: f64, longest: usize) -> Self {
        let length = ((REACH * sigma).ceil() as usize).saturating_add(2).min(longest.max(1));
        if sigma < 1e-6 {
            return Self { weights: vec![1.0] };
        }
        let psi = |i: i64| {
            #[expect(clippy::cast_precision_loss, reason = "far fewer samples than 2⁵³")]
            let u = i as f64 / sigma;
            let density = (-0.5 * u * u).exp() / (2.0 * PI).sqrt();
            // Less the part that is linear, whose second difference is nothing, so that no digits cancel.
            sigma * (density - 0.5 * u.abs() * erfc(u.abs() / SQRT_2))
        };
        let tent = |i: i64| {
            let corner = if i == 0 { 1.0 } else { 0.0 };
            corner + psi(i + 1) - 2.0 * psi(i) + psi(i - 1)
        };
        let mut weights: Vec<f64> = (0i64..).take(length).map(tent).collect();
        let sum = weights[0] + 2.0 * weights[1..].iter().sum::<f64>();
        if let Some(last) = weights[1..].last_mut() {
            *last += 0.5 * (1.0 - sum);
        } else {
            weights[0] = 1.0;
        }
        Self { weights }
    }

    /// The mean about sample `at`; beyond the ends the last value goes on.
    fn mean(&self, values: &[f64], at: usize) -> f64 {
        let last = values.len() - 1;
        let mut sum = self.weights[0] * values[at];
        for (i, weight) in self.weights.iter().enumerate().skip(1) {
            sum += weight * (values[at.saturating_sub(i)] + values[(at + i).min(last)]);
        }
        sum
    }
}

/// The Gaussian's mean of width `sigma` samples about each of equally spaced samples, joined by straight lines.
pub fn blur_line(values: &[f64], sigma: f64) -> Vec<f64> {
    let kernel = Kernel::new(sigma, values.len() + 1);
    (0..values.len()).into_par_iter().map(|at| kernel.mean(values, at)).collect()
}

/// The Gaussian's mean of width `sigma` pixels about each pixel of a picture, rows of `width`: along rows, then along columns.
pub fn blur_picture(values: &[f64], width: usize, sigma: f64) -> Vec<f64> {
    if width == 0 || values.is_empty() {
        return Vec::new();
    }
    let rows = along_rows(values, width, sigma);
    let height = values.len() / width;
    transposed(&along_rows(&transposed(&rows, width), height, sigma), height)
}

fn along_rows(values: &[f64], width: usize, sigma: f64) -> Vec<f64> {
    let kernel = Kernel::new(sigma, width + 1);
    let rows = values.par_chunks(width);
    rows.flat_map_iter(|row| (0..row.len()).map(|at| kernel.mean(row, at)).collect::<Vec<_>>()).collect()
}

fn transposed(values: &[f64], width: usize) -> Vec<f64> {
    let height = values.len() / width;
    (0..width).into_par_iter().flat_map_iter(|x| (0..height).map(move |y| values[y * width + x])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_add_up_to_one_and_spread_as_wide_as_asked() {
        for sigma in [0.0, 0.01, 0.3, 1.0, 7.5, 40.0] {
            let kernel = Kernel::new(sigma, 10_000);
            let both = |of: &dyn Fn(f64, f64) -> f64| -> f64 {
                kernel
                    .weights
                    .iter()
                    .enumerate()
                    .map(|(i, w)| if i == 0 { of(0.0, *w) } else { 2.0 * of(i as f64, *w) })
                    .sum()
            };
            assert!((both(&|_, w| w) - 1.0).abs() < 1e-12);
            // A tent of one sample's width adds its own variance, 1/6.
            let variance = both(&|i, w| i * i * w);
            let expected = sigma * sigma + 1.0 / 6.0;
            let wide = sigma >= 1.0;
            assert!(!wide || (variance - expected).abs() < 1e-5 * (1.0 + expected), "{sigma}: {variance}");
        }
    }

    #[test]
    fn a_constant_stays_what_it_is_however_wide_the_gaussian() {
        for sigma in [0.5, 3.0, 500.0] {
            assert!(blur_line(&[0.7; 9], sigma).iter().all(|v| (v - 0.7).abs() < 1e-12));
            assert!(blur_picture(&[0.7; 12], 4, sigma).iter().all(|v| (v - 0.7).abs() < 1e-12));
        }
        assert!(blur_line(&[], 1.0).is_empty() && blur_picture(&[], 0, 1.0).is_empty());
    }

    #[test]
    fn rows_and_columns_are_treated_alike() {
        let mut values = vec![0.0; 21 * 15];
        values[7 * 21 + 10] = 1.0;
        let blurred = blur_picture(&values, 21, 1.7);
        for k in 0..7 {
            assert!((blurred[7 * 21 + 10 + k] - blurred[(7 + k) * 21 + 10]).abs() < 1e-12);
        }
        assert!((blurred.iter().sum::<f64>() - 1.0).abs() < 1e-3);
    }
}
