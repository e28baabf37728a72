//! How the shade of one point changes while the picture is turned.

use super::{Finding, nothing_interpolated};
use crate::analysis::{luminance, probe};
use crate::illumination::Equation;
use crate::render::Renderer;
use crate::scene::{Interpolation, Rgb, Scene, View};
use glam::{DVec2, DVec3};
use serde::Serialize;

/// Degrees between two samples.
const STEP: u32 = 3;
/// Sides of the pictures that are turned: places in them differ by at least 1/256 of a pixel.
const SIDE: u32 = 256;

/// The dependence on orientation.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Orientation {
    /// What is followed, world.
    pub point: DVec3,
    /// The picture's own roll, degrees from 0 to 360.
    pub roll: f64,
    /// The luminance at the point for every roll.
    pub samples: Vec<Turned>,
    /// Difference between the greatest and the least value along the scan line, and with barycentric weights.
    pub spread: [f64; 2],
}

/// One orientation of the picture.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Turned {
    /// The camera's roll, degrees.
    pub angle: f64,
    /// By scan-line interpolation; nothing where the point is not seen.
    pub scanline: Option<f64>,
    /// By barycentric weights.
    pub barycentric: Option<f64>,
}

pub(super) fn measure(renderer: &mut Renderer, scene: &Scene, pixel: [u32; 2]) -> Finding<Orientation> {
    if let Some(why) = nothing_interpolated(scene) {
        return Err(why);
    }
    let missed = "the probe sees the background";
    let point = probe(renderer, scene, pixel[0], pixel[1]).hit.ok_or(missed)?.position;
    let triangle = renderer.triangle_at(pixel).ok_or(missed)?;
    let renderer = &*renderer;
    let mut turned = scene.clone();
    turned.image.size = [SIDE; 2];
    // Shadows would be those of the small picture's pixels.
    turned.shading.shadows = false;
    let equation = renderer.shining_equation(&turned);
    let samples: Vec<Turned> = (0..=360 / STEP)
        .map(|step| {
            turned.camera.roll = f64::from(step * STEP);
            let mut at = |interpolation| {
                turned.shading.interpolation = interpolation;
                value(renderer, &turned, &equation, triangle, point)
            };
            let (scanline, barycentric) = (at(Interpolation::Scanline), at(Interpolation::Affine));
            Turned { angle: f64::from(step * STEP), scanline, barycentric }
        })
        .collect();
    let spread = |of: fn(&Turned) -> Option<f64>| {
        let values = samples.iter().filter_map(of);
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
        (high - low).max(0.0)
    };
    let spread = [spread(|turned| turned.scanline), spread(|turned| turned.barycentric)];
    Ok(Orientation { point, roll: scene.camera.roll.rem_euclid(360.0), samples, spread })
}

/// The luminance of `point`, which lies on `triangle`, in a turned picture. The triangle that is seen there is the same in all.
fn value(renderer: &Renderer, turned: &Scene, equation: &Equation<f64>, triangle: u32, point: DVec3) -> Option<f64> {
    let (place, _) = View::new(&turned.camera, turned.image.size).project(point)?;
    let inside = place.cmpge(DVec2::ZERO).all() && place.max_element() < f64::from(SIDE);
    let intensity = renderer.intensity_turned(turned, equation, triangle, place).filter(|_| inside)?;
    Some(luminance(intensity.max(Rgb::ZERO)))
}
