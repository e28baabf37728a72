//! The error of replacing an area light by N points: the difference from many points, over a small picture.

use crate::illumination::Equation;
use crate::render::{Renderer, WeightedPoint};
use crate::scene::{Light, LightKind, Rgb, Scene};
use serde::{Deserialize, Serialize};

/// Number of points of the light in the reference.
pub const REFERENCE_SAMPLES: u32 = 4096;

/// Longer side of the picture over which the difference is measured, pixels.
const SIDE: u32 = 64;

/// Difference between the light of N points and that of [`REFERENCE_SAMPLES`], in linear intensity.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct SamplingError {
    /// Root mean square over the channels of the pixels that show the object.
    pub rms: f64,
    /// Maximum difference of a channel.
    pub greatest: f64,
}

/// Measures the error of the area light of index `light` by a picture of 64 pixels on the longer side. `renderer`
/// must hold the scene's model and is left with that picture. Returns none where there is no such light, it is not an
/// area light, it does not shine, or the object is not visible. Shadows are ignored.
///
/// The equation is evaluated where the shading mode evaluates it, in double precision, for this light alone.
pub fn sampling_error(
    renderer: &mut Renderer,
    scene: &Scene,
    light: usize,
) -> Option<SamplingError> {
    let shines = |chosen: &&Light| chosen.shines(scene.soloing());
    let chosen = scene.lights.get(light).filter(shines)?;
    if chosen.kind != LightKind::Area {
        return None;
    }
    let mut small = scene.clone();
    let [width, height] = scene.image.size;
    let longer = u64::from(width.max(height).max(1));
    let side = |side: u32| (u64::from(side) * u64::from(SIDE) / longer).max(1) as u32;
    small.image.size = scene.image.size.map(side);
    small.shading.shadows = false;
    renderer.render(&small);
    let of = |samples: u32| {
        let mut alone = small.clone();
        alone.lights = vec![Light {
            samples,
            ..chosen.clone()
        }];
        renderer.for_each_material(&alone, Equation::<f64>::new)
    };
    let (coarse, fine) = (of(chosen.samples), of(REFERENCE_SAMPLES));
    // On this thread alone: the others are left to any drawing in the meantime.
    let (mut count, mut sum, mut greatest) = (0.0, 0.0, 0.0f64);
    let [width, height] = small.image.size;
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    for pixel in pixels.filter_map(|(x, y)| renderer.evaluation(x, y)) {
        let difference = pixel.points.iter().map(|at| {
            let [coarse, fine] = [&coarse, &fine].map(|equations| {
                let at = WeightedPoint {
                    reached: None,
                    ..*at
                };
                let light = at.respond(&equations[pixel.material], 0);
                (light.diffuse + light.specular) * at.weight
            });
            coarse - fine
        });
        let difference: Rgb = difference.sum();
        count += 1.0;
        sum += difference.length_squared();
        greatest = greatest.max(difference.abs().max_element());
    }
    (count > 0.0).then(|| SamplingError {
        rms: (sum / (3.0 * count)).sqrt(),
        greatest,
    })
}
