//! What the equation at a point leaves out: what lies past the object or behind its surface, and light that other
//! surfaces scatter. Linear pictures in, linear pictures out.

use super::bounce::{Gathering, Receiver};
use super::display::Linear;
use super::lens::Lens;
use super::painting::Bands;
use super::shadow::{Reach, Shadows};
use super::sites::{Sight, Sights};
use super::surroundings::{Beyond, Surroundings};
use super::transmission::Glass;
use crate::illumination::Equation;
use crate::scene::{AmbientSource, Rgb, Scene};
use glam::{DVec2, DVec3, Vec3};
use rayon::prelude::*;

/// Marks which sources reach which pixels, a block of bits a row.
pub(super) fn reach_pixels(
    bands: &Bands,
    sights: &Sights<'_>,
    shadows: &Shadows<'_>,
    size: [u32; 2],
    reach: &mut Reach,
) {
    let [width, height] = size.map(|side| side as usize);
    reach.clear(height, width, shadows.equation.sources.len());
    let (block, stride) = (reach.block, reach.stride);
    let rows = Bands::ROWS * block;
    reach.words.par_chunks_mut(rows).zip(bands.parts(size)).for_each(|(words, (place, band, fragments))| {
        sights.walk(place, band, fragments, |x, row, Sight { normal, lifted, .. }| {
            shadows.mark(lifted, normal, x, stride, &mut words[row * block..(row + 1) * block]);
        });
    });
}

/// Marks which sources reach which points, `sites` of them a block; `point` gives a point, world, and its normal.
pub(super) fn reach_points(
    count: usize,
    sites: usize,
    point: impl Fn(usize) -> (DVec3, DVec3) + Sync,
    shadows: &Shadows<'_>,
    reach: &mut Reach,
) {
    reach.clear(count.div_ceil(sites), sites, shadows.equation.sources.len());
    let (block, stride) = (reach.block, reach.stride);
    reach.words.par_chunks_mut(block).enumerate().for_each(|(chunk, words)| {
        for bit in 0..sites.min(count - chunk * sites) {
            let (point, normal) = point(chunk * sites + bit);
            shadows.mark(point, normal, bit, stride, words);
        }
    });
}

/// The ray from the eye through the centre of a pixel: a point and a unit direction, world.
pub(super) fn eye_ray(lens: &Lens, x: usize, y: usize) -> (DVec3, DVec3) {
    let (point, direction) = lens.ray(DVec2::new(x as f64 + 0.5, y as f64 + 0.5));
    (lens.world(point), direction.normalize())
}

/// An intensity in single precision, at most its greatest number.
fn in_range(intensity: Rgb) -> Vec3 {
    let greatest = f64::from(f32::MAX);
    intensity.clamp(Rgb::splat(-greatest), Rgb::splat(greatest)).as_vec3()
}

/// What each pixel sees past the object, and behind its surface if that is `glass`.
pub(super) fn seen_beyond(
    bands: &Bands,
    sights: &Sights<'_>,
    size: [u32; 2],
    surroundings: &Surroundings<'_>,
    glass: Option<&Glass<'_>>,
    seen: &mut Vec<Vec3>,
) {
    let width = size[0] as usize;
    seen.clear();
    seen.resize(width * size[1] as usize, Vec3::NAN);
    seen.par_chunks_mut(Bands::ROWS * width).zip(bands.parts(size)).for_each_init(Vec::new, |scratch, (part, job)| {
        let (place, band, fragments) = job;
        let first_row = place.first_row as usize;
        sights.walk(place, band, fragments, |x, row, sight| {
            part[row * width + x] = match glass {
                Some(glass) => {
                    let (_, incident) = eye_ray(sights.lens, x, first_row + row);
                    in_range(glass.transmit(sight.point, sight.normal, incident, scratch).seen)
                }
                None => Vec3::ZERO,
            };
        });
        for (index, pixel) in part.iter_mut().enumerate().filter(|(_, pixel)| pixel.is_nan()) {
            let (origin, direction) = eye_ray(sights.lens, index % width, first_row + index / width);
            *pixel = in_range(surroundings.along(origin, direction, scratch));
        }
    });
}

/// Light that arrives at the pixels from other surfaces, and the constant that stands for it best.
#[derive(Default)]
pub(super) struct Bounced {
    /// The mean intensity that arrives, times what the surface scatters of it, less the constant ambient term.
    pub difference: Vec<Vec3>,
    /// The Ia whose constant term differs least from it: least squares over all pixels that see a surface.
    pub fit: Option<Rgb>,
}

/// What a surface returns of the constant ambient light, and of light from other surfaces.
struct Returned {
    constant: Rgb,
    scattered: Rgb,
}

/// Gathers light from other surfaces at every pixel.
pub(super) fn bounce(
    bands: &Bands,
    sights: &Sights<'_>,
    scene: &Scene,
    gathering: &Gathering<'_>,
    pattern: &Equation<f64>,
    bounced: &mut Bounced,
) {
    let lens = sights.lens;
    let [width, height] = scene.image.size.map(|side| side as usize);
    let mut receivers = vec![Receiver::default(); width * height];
    let near = |point: DVec3| ((point - lens.eye) / lens.unit).as_vec3();
    let surroundings = gathering.surroundings;
    let parts = receivers.par_chunks_mut(Bands::ROWS * width).zip(bands.parts(scene.image.size));
    let on_object: Vec<Vec<bool>> = parts
        .map(|(part, (place, band, fragments))| {
            let mut object = vec![false; part.len()];
            sights.walk(place, band, fragments, |x, row, sight| {
                part[row * width + x] = Receiver { place: near(sight.point), normal: sight.normal.as_vec3() };
                object[row * width + x] = true;
            });
            for (index, receiver) in part.iter_mut().enumerate().filter(|(index, _)| !object[*index]) {
                let (origin, direction) = eye_ray(lens, index % width, place.first_row as usize + index / width);
                if let Beyond::Floor(point) = surroundings.meet(origin, direction) {
                    *receiver = Receiver { place: near(point), normal: Vec3::Y };
                }
            }
            object
        })
        .collect();
    let world = |place: Vec3| lens.world(place.as_dvec3());
    bounced.difference = gathering.gather(&receivers, width, world);
    let (mut products, mut squares) = (Rgb::ZERO, Rgb::ZERO);
    let of = |receiver: &Receiver, object: bool| returned(scene, pattern, world(receiver.place), object);
    for ((light, receiver), object) in
        bounced.difference.iter_mut().zip(&receivers).zip(on_object.into_iter().flatten())
    {
        if receiver.normal == Vec3::ZERO {
            continue;
        }
        let Returned { constant, scattered } = of(receiver, object);
        let arrived = light.as_dvec3() * scattered;
        products += constant * arrived;
        squares += constant * constant;
        *light = in_range(arrived - constant * scene.ambient.color);
    }
    bounced.fit = (squares.min_element() > 0.0).then(|| products / squares);
}

fn returned(scene: &Scene, pattern: &Equation<f64>, point: DVec3, object: bool) -> Returned {
    let (material, ground) = (&scene.material, &scene.ground);
    if object {
        let color = if pattern.has_pattern() { pattern.pattern_color(point) } else { material.color };
        Returned { constant: material.ka * color, scattered: material.kd * color }
    } else {
        Returned { constant: ground.color * ground.ka, scattered: ground.color * ground.kd }
    }
}

/// Puts together what the equation gave, what is seen beyond and what other surfaces scatter; returns how many pixels
/// overflow.
pub(super) fn compose(scene: &Scene, seen: &[Vec3], bounced: &[Vec3], linear: &mut [Linear]) -> u64 {
    let width = scene.image.size[0] as usize;
    let kt = scene.transparency.kt as f32;
    let side = scene.ambient.source;
    let whole = linear.par_chunks_mut(width.max(1)).enumerate();
    let overflowing = whole.map(|(row, line)| {
        let mut over = 0;
        for (x, pixel) in line.iter_mut().enumerate() {
            let index = row * width + x;
            let covered = pixel[3] > 0.0;
            let beyond = seen.get(index).copied().unwrap_or(Vec3::ZERO);
            let mut color = if covered { Vec3::from_slice(&pixel[..3]) } else { beyond };
            if let Some(difference) = bounced.get(index).filter(|_| bounces_at(side, x, width)) {
                color = (color + *difference).max(Vec3::ZERO);
            }
            if covered && kt > 0.0 {
                color = color * (1.0 - kt) + beyond * kt;
            }
            color = color.min(Vec3::MAX);
            over += u64::from(color.max_element() > 1.0);
            pixel[..3].copy_from_slice(&color.to_array());
        }
        over
    });
    overflowing.sum()
}

/// Whether a pixel's ambient light is gathered from other surfaces.
pub(super) fn bounces_at(source: AmbientSource, x: usize, width: usize) -> bool {
    match source {
        AmbientSource::Constant => false,
        AmbientSource::Bounce => true,
        AmbientSource::Split => 2 * x >= width,
    }
}
