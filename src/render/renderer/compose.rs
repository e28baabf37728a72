//! Puts the linear picture together: the equation, what is seen beyond the object, and what other surfaces scatter.

use super::display::Linear;
use crate::illumination::BRIGHTEST;
use crate::scene::{AmbientSource, Scene};
use glam::Vec3;
use rayon::prelude::*;

/// Puts together what the equation gave, what is seen beyond and what other surfaces scatter; returns how many pixels
/// overflow.
///
/// What the equation gave may have faded with the depth already, where it was found at vertices or faces. Then `faded` has
/// s0 at each pixel, for what is added there.
pub fn compose(scene: &Scene, [seen, bounced]: [&[Vec3]; 2], faded: Option<&[f32]>, linear: &mut [Linear]) -> u64 {
    let width = scene.image.size[0] as usize;
    let kt = scene.transparency.kt as f32;
    let side = scene.ambient.source;
    let veil = scene.depth_cueing.color.as_vec3();
    let whole = linear.par_chunks_mut(width.max(1)).enumerate();
    let overflowing = whole.map(|(row, line)| {
        let mut over = 0;
        for (x, pixel) in line.iter_mut().enumerate() {
            let index = row * width + x;
            let covered = pixel[3] > 0.0;
            let beyond = seen.get(index).copied().unwrap_or(Vec3::ZERO);
            let mut color = if covered { Vec3::from_slice(&pixel[..3]) } else { beyond };
            let s0 = faded.filter(|_| covered).and_then(|faded| faded.get(index)).copied().unwrap_or(1.0);
            if let Some(difference) = bounced.get(index).filter(|_| bounces_at(side, x, width)) {
                // What has faded holds its veil already, which no lack of light takes away.
                color = (color + s0 * *difference).max((1.0 - s0) * veil);
            }
            if covered && kt > 0.0 {
                color = color * (1.0 - kt) + (s0 * beyond + (1.0 - s0) * veil) * kt;
            }
            color = color.min(Vec3::splat(BRIGHTEST as f32));
            over += u64::from(color.max_element() > 1.0);
            pixel[..3].copy_from_slice(&color.to_array());
        }
        over
    });
    overflowing.sum()
}

/// Whether a pixel's ambient light is gathered from other surfaces.
pub fn bounces_at(source: AmbientSource, x: usize, width: usize) -> bool {
    match source {
        AmbientSource::Constant => false,
        AmbientSource::Bounce => true,
        AmbientSource::Split => 2 * x >= width,
    }
}
