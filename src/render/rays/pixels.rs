//! Rays over the pixels of a picture: shadows, what is seen past and through the object, and light from other surfaces.

use super::bounce::Gathering;
use super::bounce_grid::Receiver;
use super::diffuse::{DiffuseSurface, LightScratch};
use super::floor::{FloorScratch, FloorView};
use super::packet::RAYS;
use super::point_row::PointRow;
use super::primary_hit::{PrimaryHit, PrimaryHits};
use super::shadow::{ShadowCaster, Waiting};
use super::surroundings::{Beyond, Surroundings, in_range};
use super::transmission::Glass;
use super::visibility::{BLOCK, Visibility};
use crate::illumination::Equation;
use crate::render::lens::{FARTHEST, Lens};
use crate::render::memory::{Holds, Memory, room};
use crate::render::raster::{Coverage, ROWS};
use crate::scene::{Rgb, Scene};
use fearless_simd::{Level, dispatch};
use glam::{DVec2, DVec3, Vec3};
use rayon::prelude::*;

/// Marks which sources are seen from which pixels, a block of bits a row.
pub fn shadow_pixels(
    level: Level,
    coverage: Coverage<'_>,
    hits: &PrimaryHits<'_>,
    caster: &ShadowCaster<'_>,
    sources: usize,
    visibility: &mut Visibility,
) {
    let [width, height] = coverage.size.map(|side| side as usize);
    visibility.clear(height, width, sources);
    if caster.reaches_all() {
        return;
    }
    let (block, stride) = (visibility.block, visibility.stride);
    let bands = visibility.words.par_chunks_mut(ROWS * block).zip(coverage.parts());
    bands.for_each_init(<(Vec<PointRow>, Waiting)>::default, |(rows, waiting), (words, (place, band, fragments))| {
        rows.resize_with(ROWS, PointRow::default);
        rows.iter_mut().for_each(|row| row.clear(width));
        hits.walk(place, band, fragments, |x, row, PrimaryHit { normal, lifted, .. }| {
            rows[row].set(x, caster.relative(lifted), normal);
        });
        for (row, words) in rows.iter().zip(words.chunks_mut(block)) {
            dispatch!(level, simd => caster.mark_row(simd, row, stride, words, waiting));
        }
    });
}

/// Marks which sources are seen from which of `count` vertices or faces; `point` gives a point, world, and its normal.
pub fn shadow_points(
    level: Level,
    count: usize,
    point: impl Fn(usize) -> (DVec3, DVec3) + Sync,
    caster: &ShadowCaster<'_>,
    sources: usize,
    visibility: &mut Visibility,
) {
    visibility.clear(count.div_ceil(BLOCK), BLOCK, sources);
    let (block, stride) = (visibility.block, visibility.stride);
    let chunks = visibility.words.par_chunks_mut(block).enumerate();
    chunks.for_each_init(<(PointRow, Waiting)>::default, |(row, waiting), (chunk, words)| {
        row.clear(BLOCK);
        for index in 0..BLOCK.min(count - chunk * BLOCK) {
            let (point, normal) = point(chunk * BLOCK + index);
            row.set(index, caster.relative(point), normal);
        }
        dispatch!(level, simd => caster.mark_row(simd, row, stride, words, waiting));
    });
}

/// The ray from the eye through the centre of a pixel: a point and a unit direction, world.
pub fn eye_ray(lens: &Lens, x: usize, y: usize) -> (DVec3, DVec3) {
    let (point, direction) = lens.ray(DVec2::new(x as f64 + 0.5, y as f64 + 0.5));
    (lens.world(point), direction.normalize())
}

/// Pixels whose rays wait to be followed through the object together.
struct Refracted<'a> {
    level: Level,
    glass: &'a Glass<'a>,
    pixels: Vec<usize>,
    rays: Vec<(PrimaryHit, DVec3)>,
}

impl Refracted<'_> {
    fn push(&mut self, pixel: usize, ray: (PrimaryHit, DVec3), scratch: &mut LightScratch, seen: &mut [Vec3]) {
        self.pixels.push(pixel);
        self.rays.push(ray);
        if self.rays.len() == RAYS {
            self.follow(scratch, seen);
        }
    }

    /// Puts what the rays see into their pixels.
    fn follow(&mut self, scratch: &mut LightScratch, seen: &mut [Vec3]) {
        let Self { level, glass, pixels, rays } = self;
        if !rays.is_empty() {
            glass.transmit(*level, rays, scratch, |ray, path| seen[pixels[ray]] = in_range(path.seen));
        }
        pixels.clear();
        rays.clear();
    }
}

/// What pixels see past the object.
pub struct Background<'a> {
    pub hits: &'a PrimaryHits<'a>,
    pub surroundings: &'a Surroundings,
    pub floor: &'a DiffuseSurface<'a>,
    /// The floor as rows of pixels see it, if there is one.
    pub floor_view: Option<&'a FloorView<'a>>,
    /// What the object is made of, if light passes through it.
    pub glass: Option<&'a Glass<'a>>,
}

/// What each pixel sees past the object, and behind its surface if that is of glass.
pub fn see_background(level: Level, coverage: Coverage<'_>, background: &Background<'_>, seen: &mut Vec<Vec3>) {
    let Background { hits, surroundings, floor, floor_view, glass } = *background;
    let width = coverage.size[0] as usize;
    seen.clear();
    seen.resize(width * coverage.size[1] as usize, Vec3::NAN);
    let parts = seen.par_chunks_mut(ROWS * width).zip(coverage.parts());
    parts.for_each_init(<(LightScratch, FloorScratch)>::default, |(scratch, floor_scratch), (part, job)| {
        let (place, band, fragments) = job;
        let first_row = place.first_row as usize;
        hits.walk_covered(place, band, fragments, |row, columns| {
            part[row * width..(row + 1) * width][columns].fill(Vec3::ZERO);
        });
        if let Some(glass) = glass {
            let mut through = Refracted { level, glass, pixels: vec![], rays: vec![] };
            hits.walk(place, band, fragments, |x, row, hit| {
                let (_, incident) = eye_ray(hits.lens, x, first_row + row);
                through.push(row * width + x, (hit, incident), scratch, part);
            });
            through.follow(scratch, part);
        }
        for (y, line) in (first_row..).zip(part.chunks_mut(width)) {
            if let Some(view) = floor_view {
                dispatch!(level, simd => view.light_row(simd, y, line, floor_scratch));
            }
            surroundings.fill_row(hits.lens, y, line);
            for (x, pixel) in line.iter_mut().enumerate().filter(|(_, pixel)| pixel.is_nan()) {
                let (origin, direction) = eye_ray(hits.lens, x, y);
                match surroundings.meet(origin, direction) {
                    Beyond::Elsewhere(color) => *pixel = in_range(color),
                    Beyond::Floor(point) => {
                        floor.light(level, &[(point, DVec3::Y)], scratch, |_, color| *pixel = in_range(color));
                    }
                }
            }
        }
    });
}

/// Light that arrives at the pixels from other surfaces, and the constant that stands for it best.
#[derive(Default)]
pub struct Bounced {
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
pub fn bounce(
    level: Level,
    coverage: Coverage<'_>,
    hits: &PrimaryHits<'_>,
    scene: &Scene,
    (gathering, floor): (&Gathering<'_>, Option<&FloorView<'_>>),
    pattern: &Equation<f64>,
    bounced: &mut Bounced,
) {
    let lens = hits.lens;
    let [width, height] = scene.image.size.map(|side| side as usize);
    let Bounced { difference, receivers, .. } = bounced;
    receivers.clear();
    receivers.resize(width * height, Receiver::default());
    let farthest = DVec3::splat(FARTHEST);
    let near = |point: DVec3| ((point - lens.eye) / lens.unit).clamp(-farthest, farthest).as_vec3();
    let parts = receivers.par_chunks_mut(ROWS * width).zip(coverage.parts());
    parts.for_each_init(FloorScratch::default, |scratch, (part, (place, band, fragments))| {
        hits.walk(place, band, fragments, |x, row, hit| {
            part[row * width + x] = Receiver { place: near(hit.point), normal: hit.normal.as_vec3(), on_object: true };
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
    let share = ROWS * width;
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
