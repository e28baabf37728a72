//! A picture of what is perceived.

use super::luminance;
use crate::analysis::perception::{Perception, Viewing, blur_picture};
use crate::render::{Frame, Renderer, displayed};
use crate::scene::{Rgb, Scene};

/// Greatest width of the surround in pixels for a whole picture: beyond, its time would grow without bound.
pub const PERCEIVED_WIDTH: f64 = 256.0;

/// The response over the whole picture, as a picture: each pixel's colour is multiplied by the ratio of the response to its
/// luminance. A black pixel has no colour and becomes a grey; what is negative is black. Beyond the picture's edge its last
/// pixels go on.
pub fn perceived_picture(renderer: &mut Renderer, scene: &Scene, viewing: &Viewing, perception: &Perception) -> Frame {
    let width = scene.image.size[0] as usize;
    let mut linear = renderer.linear_picture(scene);
    let colour = |pixel: &[f32; 4]| Rgb::new(pixel[0].into(), pixel[1].into(), pixel[2].into());
    let intensity: Vec<f64> = linear.iter().map(|pixel| luminance(colour(pixel))).collect();
    let blur = |values: &[f64], sigma: f64| blur_picture(values, width, sigma);
    let response = perception.respond(&intensity, viewing.pixels_per_degree(), &blur);
    for ((pixel, intensity), response) in linear.iter_mut().zip(&intensity).zip(&response) {
        let response = response.max(0.0);
        let seen = if *intensity > 0.0 { colour(pixel) * (response / intensity) } else { Rgb::splat(response) };
        pixel[..3].copy_from_slice(&seen.as_vec3().to_array());
    }
    displayed(&linear, scene)
}
