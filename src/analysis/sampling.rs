//! What replacing an area light by N points costs: the difference to many points, over a small picture.

use crate::illumination::Equation;
use crate::render::Renderer;
use crate::scene::{Light, LightKind, Rgb, Scene};
use serde::{Deserialize, Serialize};

/// Points of the light that the difference is measured against.
pub const REFERENCE_SAMPLES: u32 = 4096;

/// Pixels on the longer side of the picture that the difference is measured over.
const SIDE: u32 = 64;

/// How far the light of N points is from that of [`REFERENCE_SAMPLES`], in linear intensity: 1 is the display's white.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct SamplingError {
    /// The root mean square over the channels of the pixels that show the object.
    pub rms: f64,
    /// The greatest difference of a channel.
    pub greatest: f64,
}

/// The error of the area light of index `light`, by a picture of 64 pixels on the longer side, with which `renderer`, which holds
/// the scene's model, is left. Nothing where there is no such light, it is not an area light, it does not shine, or the object is
/// not seen.
///
/// The equation is evaluated where the shading mode evaluates it, in double precision; of all lights only this one
/// differs, so only its terms are. Shadows are left aside: every point of the light reaches every point of the object.
pub fn sampling_error(
    renderer: &mut Renderer,
    scene: &Scene,
    light: usize,
) -> Option<SamplingError> {
    let chosen = scene
        .lights
        .get(light)
        .filter(|chosen| chosen.kind == LightKind::Area)?;
    if !chosen.shines(scene.soloing()) {
        return None;
    }
    let mut small = scene.clone();
    let longer = u64::from(scene.image.size[0].max(scene.image.size[1]).max(1));
    small.image.size = scene
        .image
        .size
        .map(|side| (u64::from(side) * u64::from(SIDE) / longer).max(1) as u32);
    small.shading.shadows = false;
    renderer.render(&small);
    let of = |samples: u32| {
        let mut alone = small.clone();
        alone.lights = vec![Light {
            samples,
            ..chosen.clone()
        }];
        Equation::<f64>::new(&alone)
    };
    let (coarse, fine) = (of(chosen.samples), of(REFERENCE_SAMPLES));
    // On this thread alone: the others are left to whoever draws meanwhile.
    let (mut count, mut sum, mut greatest) = (0.0, 0.0, 0.0f64);
    let [width, height] = small.image.size;
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    for pixel in pixels.filter_map(|(x, y)| renderer.evaluation(x, y)) {
        let difference = pixel.points.iter().map(|at| {
            let [coarse, fine] = [&coarse, &fine].map(|equation| {
                let light = equation.respond_world(0, at.point, at.normal, None);
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
