//! What replacing an area light by N points costs: the difference to many points, over a small picture.

use crate::illumination::Equation;
use crate::render::Renderer;
use crate::scene::{Light, LightKind, Rgb, Scene};
use glam::DVec3;

/// Points of the light that the difference is measured against.
pub const REFERENCE_SAMPLES: u32 = 4096;

/// Pixels on the longer side of the picture that the difference is measured over.
const SIDE: u32 = 64;

/// How far the light of N points is from that of [`REFERENCE_SAMPLES`], in linear intensity: 1 is the display's white.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SamplingError {
    /// The root mean square over the channels of the pixels that show the object.
    pub rms: f64,
    /// The greatest difference of a channel.
    pub greatest: f64,
}

/// The error of the area light of index `light`, by a picture of 64 pixels on the longer side. Nothing where there is no
/// such light, it is not an area light, it does not shine, or the object is not seen.
///
/// The equation is evaluated where the shading mode evaluates it, in double precision; of all lights only this one
/// differs, so only its terms are. Shadows are left aside: every point of the light reaches every point of the object.
pub fn sampling_error(scene: &Scene, light: usize) -> Option<SamplingError> {
    sampling_error_with(&mut Renderer::default(), scene, light)
}

/// [`sampling_error`] by a renderer that holds the scene's model. It is left with the small picture.
pub fn sampling_error_with(renderer: &mut Renderer, scene: &Scene, light: usize) -> Option<SamplingError> {
    let chosen = scene.lights.get(light).filter(|chosen| chosen.kind == LightKind::Area)?;
    if !chosen.shines(scene.soloing()) {
        return None;
    }
    let mut small = scene.clone();
    small.image.size = small_size(scene.image.size);
    small.shading.shadows = false;
    renderer.render(&small);
    let pixels = places(renderer, small.image.size);
    if pixels.is_empty() {
        return None;
    }
    let of = |samples: u32| {
        let mut alone = small.clone();
        alone.lights = vec![Light { samples, ..chosen.clone() }];
        Equation::<f64>::new(&alone)
    };
    let (coarse, fine) = (of(chosen.samples), of(REFERENCE_SAMPLES));
    // On this thread alone: the others are left to whoever draws meanwhile.
    let (mut sum, mut greatest) = (0.0, 0.0f64);
    for sites in &pixels {
        let each = difference(sites, &coarse, &fine);
        sum += each.length_squared();
        greatest = greatest.max(each.abs().max_element());
    }
    #[expect(clippy::cast_precision_loss, reason = "at most 4096 pixels")]
    let channels = 3.0 * pixels.len() as f64;
    Some(SamplingError { rms: (sum / channels).sqrt(), greatest })
}

/// A point, its normal, and the weight with which the equation there enters the pixel.
type Place = (f64, DVec3, DVec3);

/// Where the equation is evaluated for each pixel that shows the object.
fn places(renderer: &Renderer, [width, height]: [u32; 2]) -> Vec<Vec<Place>> {
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let seen = pixels.filter_map(|(x, y)| renderer.evaluation(x, y));
    seen.map(|pixel| pixel.points.iter().map(|site| (site.weight, site.point, site.normal)).collect()).collect()
}

fn difference(sites: &[Place], coarse: &Equation<f64>, fine: &Equation<f64>) -> Rgb {
    let at = |equation: &Equation<f64>, (weight, point, normal): &Place| {
        let light = equation.respond_world(0, *point, *normal, None);
        (light.diffuse + light.specular) * *weight
    };
    sites.iter().map(|site| at(coarse, site) - at(fine, site)).sum()
}

/// The shape of a picture, [`SIDE`] pixels on its longer side.
fn small_size([width, height]: [u32; 2]) -> [u32; 2] {
    let longer = u64::from(width.max(height).max(1));
    [width, height].map(|side| (u64::from(side) * u64::from(SIDE) / longer).max(1) as u32)
}
