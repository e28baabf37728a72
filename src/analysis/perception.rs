//! Models of the eye's response to intensities, which shows Mach bands.
//!
//! Where the slope of the intensity changes, the eye sees a bright or a dark line that is not there (Mach 1865). Two
//! models say how strong it is; both leave a straight ramp as it is, however steep, and respond only to departures
//! from one.
//!
//! Intensities come in and go out linear, 1 the display's white; widths are angles at the eye, which a [`Viewing`]
//! turns into pixels. Beyond the ends of the input its last value continues.

use crate::scene::Rgb;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::f64::consts::{PI, SQRT_2};

/// Number of widths beyond which a Gaussian's weight is under 10⁻⁹.
const REACH: f64 = 6.0;

/// Viewing conditions of the picture.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Viewing {
    /// Distance from the eye to the screen, millimetres.
    pub distance: f64,
    /// Density of the screen, pixels per millimetre.
    pub density: f64,
}

impl Viewing {
    /// Minimum and maximum distance, millimetres.
    pub const DISTANCE: [f64; 2] = [100.0, 5000.0];
    /// Minimum and maximum density, pixels per millimetre.
    pub const DENSITY: [f64; 2] = [0.5, 40.0];

    /// Returns the conditions with values that are out of bounds or not numbers reset to their defaults.
    pub fn sound(self) -> Self {
        Self {
            distance: bounded(self.distance, Self::DISTANCE, Self::default().distance),
            density: bounded(self.density, Self::DENSITY, Self::default().density),
        }
    }

    /// Returns the pixels per degree of visual angle, about the fixation point: `d·tan 1°·density`.
    pub fn pixels_per_degree(&self) -> f64 {
        self.distance * 1f64.to_radians().tan() * self.density
    }
}

impl Default for Viewing {
    /// Returns a screen of 96 pixels per inch at 60 cm, about 40 pixels per degree.
    fn default() -> Self {
        Self {
            distance: 600.0,
            density: 3.78,
        }
    }
}

fn bounded(value: f64, [min, max]: [f64; 2], usual: f64) -> f64 {
    if (min..=max).contains(&value) {
        value
    } else {
        usual
    }
}

/// A model of the eye's response.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ResponseModel {
    /// Lateral inhibition as a difference of two Gaussians (Ratliff 1965; Rodieck 1965; Enroth-Cugell and Robson 1966):
    ///
    /// `R = I + w·(G(σc)∗I − G(σs)∗I)`.
    ///
    /// A corner where the slope changes by Δs departs from its intensity by `w·Δs·(σc − σs)/√(2π)`: a bright line where
    /// the slope falls, a dark one where it rises. It also predicts bands at a plain step, where hardly anybody sees
    /// any.
    #[default]
    LateralInhibition,
    /// Response normalisation, after Kingdom (2014): channels an octave apart, the gain of each lowered where it
    /// responds strongly nearby, so that their responses become more equal.
    ///
    /// `R = I + w·Σ ρ·Eₖ/(ρ + √(G(2σₖ)∗Eₖ²))` with `Eₖ = G(σₖ)∗I − G(2σₖ)∗I` and `σₖ = 2ᵏ·σc`, up to the first k whose
    /// `2σₖ·√2 ≥ σs`.
    ///
    /// A simple form of that idea, not the published model with its fitted constants. Weak responses are those of
    /// lateral inhibition; a step saturates its channels and gains less than a corner.
    ResponseNormalisation,
}

impl ResponseModel {
    /// All models.
    pub const ALL: [Self; 2] = [Self::LateralInhibition, Self::ResponseNormalisation];
}

/// A model with its parameters, which differ between observers; the defaults have the magnitude found for the fovea.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Perception {
    /// The model of the eye.
    pub model: ResponseModel,
    /// σc, the width of the centre, degrees of visual angle.
    pub centre: f64,
    /// σs, the width of the surround, degrees of visual angle.
    pub surround: f64,
    /// w, the strength of the inhibition.
    pub weight: f64,
    /// ρ, the response at which normalisation halves a channel's gain.
    pub saturation: f64,
}

impl Default for Perception {
    fn default() -> Self {
        Self {
            model: ResponseModel::default(),
            centre: 0.04,
            surround: 0.2,
            weight: 1.0,
            saturation: 0.02,
        }
    }
}

impl Perception {
    /// Minimum and maximum σc and σs, degrees of visual angle.
    pub const WIDTH: [f64; 2] = [0.001, 2.0];
    /// Minimum and maximum w.
    pub const WEIGHT: [f64; 2] = [0.0, 10.0];
    /// Minimum and maximum ρ.
    pub const SATURATION: [f64; 2] = [1e-4, 10.0];

    /// Returns the parameters with values that are out of bounds or not numbers reset to their defaults.
    pub fn sound(self) -> Self {
        let usual = Self::default();
        Self {
            centre: bounded(self.centre, Self::WIDTH, usual.centre),
            surround: bounded(self.surround, Self::WIDTH, usual.surround),
            weight: bounded(self.weight, Self::WEIGHT, usual.weight),
            saturation: bounded(self.saturation, Self::SATURATION, usual.saturation),
            ..self
        }
    }

    /// Returns σc and σs in units of which a degree has `per_degree`.
    pub fn widths(&self, per_degree: f64) -> [f64; 2] {
        [self.centre * per_degree, self.surround * per_degree]
    }

    /// Computes the response to `intensity`; `blur(values, σ)` is a Gaussian's mean, a degree being `per_degree` of σ's
    /// units.
    pub fn respond(
        &self,
        intensity: &[f64],
        per_degree: f64,
        blur: &dyn Fn(&[f64], f64) -> Vec<f64>,
    ) -> Vec<f64> {
        let [centre, surround] = self.widths(per_degree);
        match self.model {
            ResponseModel::LateralInhibition => {
                let means = blur(intensity, centre)
                    .into_iter()
                    .zip(blur(intensity, surround));
                intensity
                    .iter()
                    .zip(means)
                    .map(|(i, (near, wide))| i + self.weight * (near - wide))
                    .collect()
            }
            ResponseModel::ResponseNormalisation => {
                self.normalised(intensity, [centre, surround], blur)
            }
        }
    }

    fn normalised(
        &self,
        intensity: &[f64],
        [mut width, surround]: [f64; 2],
        blur: &dyn Fn(&[f64], f64) -> Vec<f64>,
    ) -> Vec<f64> {
        let mut response = intensity.to_vec();
        let mut near = blur(intensity, width);
        loop {
            let wide = blur(intensity, 2.0 * width);
            let channel: Vec<f64> = near
                .iter()
                .zip(&wide)
                .map(|(near, wide)| near - wide)
                .collect();
            let squares: Vec<f64> = channel.iter().map(|e| e * e).collect();
            let energy = blur(&squares, 2.0 * width);
            for ((response, e), energy) in response.iter_mut().zip(&channel).zip(&energy) {
                *response +=
                    self.weight * self.saturation * e / (self.saturation + energy.max(0.0).sqrt());
            }
            width *= 2.0;
            // The last channel is the one whose wider Gaussian is nearest to σs. A width of 0 would never reach it.
            let goes_on = width > 0.0 && width * SQRT_2 < surround;
            if !goes_on {
                return response;
            }
            near = wide;
        }
    }
}

/// Returns the weights of the samples 0, 1, 2 … places away for a Gaussian of width `sigma` samples, at most `longest`;
/// the last receives the weight of all that is cut off. The samples are joined by straight lines, whose mean is exact:
/// a weight is that of a tent, the second difference of ψ(x) = x·Φ(x/σ) + σ·φ(x/σ), the Gaussian's second integral.
fn gaussian(sigma: f64, longest: usize) -> Vec<f64> {
    let length = ((REACH * sigma).ceil() as usize)
        .saturating_add(2)
        .min(longest.max(1));
    if sigma < 1e-6 {
        return vec![1.0];
    }
    let psi = |i: i64| {
        let u = i as f64 / sigma;
        let density = (-0.5 * u * u).exp() / (2.0 * PI).sqrt();
        // Without the linear part, whose second difference is zero, so that no digits cancel.
        sigma * (density - 0.5 * u.abs() * libm::erfc(u.abs() / SQRT_2))
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
    weights
}

/// Returns the mean of `values` about sample `at`; beyond the ends the last value continues.
fn mean(weights: &[f64], values: &[f64], at: usize) -> f64 {
    let last = values.len() - 1;
    let sides = |i: usize| values[at.saturating_sub(i)] + values[(at + i).min(last)];
    weights
        .iter()
        .enumerate()
        .skip(1)
        .fold(weights[0] * values[at], |sum, (i, weight)| {
            sum + weight * sides(i)
        })
}

/// Computes the Gaussian's mean of width `sigma` samples about each of equally spaced samples.
pub fn blur_line(values: &[f64], sigma: f64) -> Vec<f64> {
    let weights = gaussian(sigma, values.len() + 1);
    (0..values.len())
        .into_par_iter()
        .map(|at| mean(&weights, values, at))
        .collect()
}

/// Computes the Gaussian's mean of width `sigma` pixels about each pixel of a picture with rows of `width`.
pub fn blur_picture(values: &[f64], width: usize, sigma: f64) -> Vec<f64> {
    if width == 0 || values.is_empty() {
        return Vec::new();
    }
    let along_rows = |values: &[f64], width: usize| -> Vec<f64> {
        let weights = gaussian(sigma, width + 1);
        let rows = values.par_chunks(width);
        rows.flat_map_iter(|row| {
            (0..row.len())
                .map(|at| mean(&weights, row, at))
                .collect::<Vec<_>>()
        })
        .collect()
    };
    let height = values.len() / width;
    transposed(
        &along_rows(&transposed(&along_rows(values, width), width), height),
        height,
    )
}

fn transposed(values: &[f64], width: usize) -> Vec<f64> {
    let height = values.len() / width;
    (0..width)
        .into_par_iter()
        .flat_map_iter(|x| (0..height).map(move |y| values[y * width + x]))
        .collect()
}

/// Returns the Rec. 709 luminance of a linear colour.
pub fn luminance(color: Rgb) -> f64 {
    color.dot(Rgb::new(0.2126, 0.7152, 0.0722))
}

/// Returns the Rec. 709 luminance of a pixel of a linear picture.
pub fn pixel_luminance(pixel: &[f32; 4]) -> f64 {
    let [r, g, b, _] = pixel.map(f64::from);
    luminance(Rgb::new(r, g, b))
}
