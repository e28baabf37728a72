//! What the equation at a point leaves out: what lies past the object or behind its surface, and light that other
//! surfaces scatter. Linear pictures in, linear pictures out.

use super::bounce::{Gathering, Receiver};
use super::bvh::RAYS;
use super::display::Linear;
use super::floor::{FloorScratch, FloorView};
use super::lens::{FARTHEST, Lens};
use super::memory::{Holds, Memory, room};
use super::painting::Bands;
use super::shadow::{Cast, Reach, Shadows, SiteRow, Waiting};
use super::sites::{Sight, Sights};
use super::surroundings::{Surroundings, in_range};
use super::transmission::Glass;
use crate::illumination::{BRIGHTEST, Equation};
use crate::scene::{AmbientSource, Rgb, Scene};
use fearless_simd::{Level, dispatch};
use glam::{DVec2, DVec3, Vec3};
use rayon::prelude::*;

/// What a thread that marks shadows keeps from one row of sites to the next.
#[derive(Default)]
struct RowScratch {
    rows: Vec<SiteRow>,
    waiting: Waiting,
}

/// Marks which sources reach which pixels, a block of bits a row.
pub(super) fn reach_pixels(
    level: Level,
    bands: &Bands,
    sights: &Sights<'_>,
    shadows: &Shadows<'_>,
    size: [u32; 2],
    reach: &mut Reach,
) {
    let [width, height] = size.map(|side| side as usize);
    reach.clear(height, width, shadows.equation.sources.len());
    let (block, stride) = (reach.block, reach.stride);
    let cast = Cast::new(*shadows, true);
    if cast.reaches_all() {
        return;
    }
    let bands = reach.words.par_chunks_mut(Bands::ROWS * block).zip(bands.parts(size));
    bands.for_each_init(RowScratch::default, |scratch, (words, (place, band, fragments))| {
        let RowScratch { rows, waiting } = scratch;
        rows.resize_with(Bands::ROWS, SiteRow::default);
        rows.iter_mut().for_each(|row| row.clear(width));
        sights.walk(place, band, fragments, |x, row, Sight { normal, lifted, .. }| {
            rows[row].set(x, cast.relative(lifted), normal);
        });
        for (row, words) in rows.iter().zip(words.chunks_mut(block)) {
            dispatch!(level, simd => cast.mark_row(simd, row, stride, words, waiting));
        }
    });
}

/// Marks which sources reach which points, `sites` of them a block; `point` gives a point, world, and its normal.
pub(super) fn reach_points(
    level: Level,
    count: usize,
    sites: usize,
    point: impl Fn(usize) -> (DVec3, DVec3) + Sync,
    shadows: &Shadows<'_>,
    reach: &mut Reach,
) {
    reach.clear(count.div_ceil(sites), sites, shadows.equation.sources.len());
    let (block, stride) = (reach.block, reach.stride);
    let cast = Cast::new(*shadows, true);
    let chunks = reach.words.par_chunks_mut(block).enumerate();
    chunks.for_each_init(<(SiteRow, Waiting)>::default, |(row, waiting), (chunk, words)| {
        row.clear(sites);
        for site in 0..sites.min(count - chunk * sites) {
            let (point, normal) = point(chunk * sites + site);
            row.set(site, cast.relative(point), normal);
        }
        dispatch!(level, simd => cast.mark_row(simd, row, stride, words, waiting));
    });
}

/// The ray from the eye through the centre of a pixel: a point and a unit direction, world.
pub(super) fn eye_ray(lens: &Lens, x: usize, y: usize) -> (DVec3, DVec3) {
    let (point, direction) = lens.ray(DVec2::new(x as f64 + 0.5, y as f64 + 0.5));
    (lens.world(point), direction.normalize())
}

/// Pixels whose rays wait to be followed through the object together.
struct Refracted<'a> {
    level: Level,
    glass: &'a Glass<'a>,
    pixels: Vec<usize>,
    rays: Vec<(Sight, DVec3)>,
}

impl<'a> Refracted<'a> {
    fn new(level: Level, glass: &'a Glass<'a>) -> Self {
        Self { level, glass, pixels: Vec::with_capacity(RAYS), rays: Vec::with_capacity(RAYS) }
    }

    fn push(&mut self, pixel: usize, ray: (Sight, DVec3), scratch: &mut Vec<u64>, seen: &mut [Vec3]) {
        self.pixels.push(pixel);
        self.rays.push(ray);
        if self.rays.len() == RAYS {
            self.follow(scratch, seen);
        }
    }

    /// Puts what the rays see into their pixels.
    fn follow(&mut self, scratch: &mut Vec<u64>, seen: &mut [Vec3]) {
        let Self { level, glass, pixels, rays } = self;
        if rays.is_empty() {
            return;
        }
        dispatch!(*level, simd => glass.transmit_all(simd, rays, scratch, #[inline(always)] |ray, intensity| {
            seen[pixels[ray]] = in_range(intensity);
        }));
        pixels.clear();
        rays.clear();
    }
}

/// What pixels see past the object.
pub(super) struct Prospect<'a> {
    pub sights: &'a Sights<'a>,
    pub surroundings: &'a Surroundings<'a>,
    /// The floor, if there is one.
    pub floor: Option<&'a FloorView<'a>>,
    /// What the object is made of, if light passes through it.
    pub glass: Option<&'a Glass<'a>>,
}

/// What each pixel sees past the object, and behind its surface if that is of glass.
pub(super) fn seen_beyond(level: Level, bands: &Bands, size: [u32; 2], prospect: &Prospect<'_>, seen: &mut Vec<Vec3>) {
    let Prospect { sights, surroundings, floor, glass } = *prospect;
    let width = size[0] as usize;
    seen.clear();
    seen.resize(width * size[1] as usize, Vec3::NAN);
    let parts = seen.par_chunks_mut(Bands::ROWS * width).zip(bands.parts(size));
    parts.for_each_init(<(Vec<u64>, FloorScratch)>::default, |(scratch, floor_scratch), (part, job)| {
        let (place, band, fragments) = job;
        let first_row = place.first_row as usize;
        sights.walk_covered(place, band, fragments, |row, columns| {
            part[row * width..(row + 1) * width][columns].fill(Vec3::ZERO);
        });
        if let Some(glass) = glass {
            let mut through = Refracted::new(level, glass);
            sights.walk(place, band, fragments, |x, row, sight| {
                let (_, incident) = eye_ray(sights.lens, x, first_row + row);
                through.push(row * width + x, (sight, incident), scratch, part);
            });
            through.follow(scratch, part);
        }
        if let Some(floor) = floor {
            for (y, line) in (first_row..).zip(part.chunks_mut(width)) {
                dispatch!(level, simd => floor.light_row(simd, y, line, floor_scratch));
            }
        }
        for (y, line) in (first_row..).zip(part.chunks_mut(width)) {
            dispatch!(level, simd => surroundings.fill_row(simd, sights.lens, y, line));
        }
        for (index, pixel) in part.iter_mut().enumerate().filter(|(_, pixel)| pixel.is_nan()) {
            let (origin, direction) = eye_ray(sights.lens, index % width, first_row + index / width);
            *pixel = in_range(surroundings.along(origin, direction, scratch));
        }
    });
}

/// Light that arrives at the pixels from other surfaces, and the constant that stands for it best.
#[derive(Default)]
pub(super) struct Bounced {
    /// The mean intensity that arrives, times what the surface scatters of it, less the constant ambient term as far as the
    /// equation has it.
    pub difference: Vec<Vec3>,
    /// The Ia whose constant term differs least from it: least squares over all pixels that see a surface.
    pub fit: Option<Rgb>,
    /// Where the pixels gather; kept for its room.
    receivers: Vec<Receiver>,
}

impl Holds for Bounced {
    fn memory(&self) -> Memory {
        Memory::of_pixels(room(&self.difference) + room(&self.receivers))
    }
}

/// What a surface returns of the constant ambient light, and of light from other surfaces.
struct Returned {
    constant: Rgb,
    scattered: Rgb,
}

/// Gathers light from other surfaces at every pixel.
pub(super) fn bounce(
    level: Level,
    bands: &Bands,
    sights: &Sights<'_>,
    scene: &Scene,
    gathering: &Gathering<'_>,
    pattern: &Equation<f64>,
    bounced: &mut Bounced,
) {
    let lens = sights.lens;
    let [width, height] = scene.image.size.map(|side| side as usize);
    let Bounced { difference, receivers, .. } = bounced;
    receivers.clear();
    receivers.resize(width * height, Receiver::default());
    let farthest = DVec3::splat(FARTHEST);
    let near = |point: DVec3| ((point - lens.eye) / lens.unit).clamp(-farthest, farthest).as_vec3();
    let floor = gathering.floor_view;
    let parts = receivers.par_chunks_mut(Bands::ROWS * width).zip(bands.parts(scene.image.size));
    parts.for_each_init(FloorScratch::default, |scratch, (part, (place, band, fragments))| {
        sights.walk(place, band, fragments, |x, row, sight| {
            part[row * width + x] =
                Receiver { place: near(sight.point), normal: sight.normal.as_vec3(), on_object: true };
        });
        let Some(floor) = floor else { return };
        for (y, line) in (place.first_row as usize..).zip(part.chunks_mut(width)) {
            dispatch!(level, simd => {
                floor.find_row(simd, y, width, #[inline(always)] |x| !line[x].on_object, scratch)
            });
            for (x, receiver) in line.iter_mut().enumerate() {
                if let Some(place) = scratch.seen(x) {
                    *receiver = Receiver { place, normal: Vec3::Y, on_object: false };
                }
            }
        }
    });
    let world = |place: Vec3| lens.world(place.as_dvec3());
    gathering.gather(level, receivers, width, world, difference);
    let share = Bands::ROWS * width;
    let parts = difference.par_chunks_mut(share).zip(receivers.par_chunks(share));
    let sums: Vec<[Rgb; 2]> = parts
        .map(|(part, receivers)| {
            let (mut products, mut squares) = (Rgb::ZERO, Rgb::ZERO);
            for (light, receiver) in part.iter_mut().zip(receivers).filter(|(_, receiver)| receiver.is_there()) {
                let point = world(receiver.place);
                let Returned { constant, scattered } = returned(scene, pattern, point, receiver.on_object);
                let arrived = light.as_dvec3() * scattered;
                products += constant * arrived;
                squares += constant * constant;
                *light = in_range(arrived - constant * scene.ambient.constant());
            }
            [products, squares]
        })
        .collect();
    // Added in the order of the bands, whichever was done first.
    let [products, squares] =
        sums.iter().fold([Rgb::ZERO; 2], |[p, s], [products, squares]| [p + products, s + squares]);
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
///
/// What the equation gave may have faded with the depth already, where it was found at vertices or faces. Then `faded` has
/// s0 at each pixel, for what is added there.
pub(super) fn compose(
    scene: &Scene,
    seen: &[Vec3],
    bounced: &[Vec3],
    faded: Option<&[f32]>,
    linear: &mut [Linear],
) -> u64 {
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
pub(super) fn bounces_at(source: AmbientSource, x: usize, width: usize) -> bool {
    match source {
        AmbientSource::Constant => false,
        AmbientSource::Bounce => true,
        AmbientSource::Split => 2 * x >= width,
    }
}
