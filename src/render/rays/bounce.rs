//! One bounce: light that the object and the floor have scattered once, gathered from all sides.
//!
//! The light that arrives at a point is the mean of that seen in directions distributed by the cosine to its normal, as a
//! diffuse surface weights them. It is gathered on a grid of pixels and interpolated to the others by weights that fall
//! with the distance in the picture and vanish on another surface (after W. J. Ward et al., *A ray tracing solution for
//! diffuse interreflection*, 1988: indirect light changes slowly except at creases).

use super::packet::{Packet, RAYS};
use super::world::{Beyond, DiffuseSurface, FloorScratch, LightScratch, LitPoint, World, in_range};
use crate::illumination::{Equation, LANES, Lanes, Real, V3};
use crate::render::lens::FARTHEST;
use crate::render::node::{Memory, capacity};
use crate::render::raster::{Coverage, ROWS};
use crate::scene::{FaceMaterial, Material, Rgb};
use fearless_simd::{dispatch, prelude::*};
use glam::{DVec3, Vec3};
use rayon::prelude::*;
use std::f64::consts::TAU;
use std::ops::Range;

/// The directions from a point: rows times columns.
const DIRECTIONS: [usize; 2] = [8, 8];
const ALL: u32 = u32::MAX >> (32 - RAYS);
/// The points of the grid along the picture's longer side: light from other surfaces changes over the object, not over pixels.
const POINTS: usize = 72;
/// The fewest of them, of a coarser picture that stands for a finer one.
const FEWEST_POINTS: usize = 24;
/// The weight below which interpolation is unreliable; the pixel then gathers for itself.
const LEAST_WEIGHT: f32 = 0.02;
/// The distance, in cells, at which a grid point's weight falls to zero.
const WIDTH: f32 = 2.5;
/// The cells on either side within that distance.
const NEIGHBOURS: usize = 2;

#[derive(Clone, Copy, Debug, Default)]
struct Receiver {
    /// The position relative to the eye, camera distances.
    place: Vec3,
    /// The unit normal; zero where there is no surface.
    normal: Vec3,
    /// The index of the material of the object there; `None` on the floor.
    on_object: Option<usize>,
    /// The colour that tints Od there.
    tint: Vec3,
}

impl Receiver {
    fn is_there(&self) -> bool {
        self.normal != Vec3::ZERO
    }
}

/// The light that arrives at the pixels from other surfaces, and the constant that approximates it best.
#[derive(Default)]
pub struct Bounced {
    /// The light that the surface scatters of the mean intensity that arrives.
    pub scattered: Vec<Vec3>,
    /// The Ia whose constant term differs least from it: least squares over all pixels that show a surface.
    pub fit: Option<Rgb>,
    /// The points where the pixels gather; kept to reuse its capacity.
    receivers: Vec<Receiver>,
}

/// The buffers that a thread reuses from one receiver to the next.
#[derive(Default)]
struct Scratch {
    on_object: Vec<LitPoint>,
    on_floor: Vec<LitPoint>,
    light: LightScratch,
}

impl Bounced {
    pub fn count(&self, memory: &mut Memory) {
        memory.pixels += capacity(&self.scattered) + capacity(&self.receivers);
    }

    /// Gathers light at every pixel of a picture that stands for a finer one of `coarser` times its sides; neither the floor nor `object`, whose `materials` these are, has the ambient light that the
    /// bounce replaces.
    pub fn run(
        &mut self,
        world: &World<'_>,
        (object, materials): (&DiffuseSurface<'_>, &[FaceMaterial]),
        coverage: Coverage<'_>,
        coarser: u32,
    ) {
        let (scene, lens) = (world.scene, world.hits.lens);
        let [width, height] = scene.image.size.map(|side| side as usize);
        let Self {
            scattered,
            receivers,
            ..
        } = self;
        receivers.clear();
        receivers.resize(width * height, Receiver::default());
        find_receivers(world, coverage, width, receivers);
        let points = (POINTS / coarser as usize).max(FEWEST_POINTS);
        gather(world, object, receivers, [width, points], scattered);
        let share = ROWS * width;
        let parts = scattered
            .par_chunks_mut(share)
            .zip(receivers.par_chunks(share));
        let sums: Vec<[Rgb; 2]> = parts
            .map(|(part, receivers)| {
                let (mut products, mut squares) = (Rgb::ZERO, Rgb::ZERO);
                for (light, receiver) in part
                    .iter_mut()
                    .zip(receivers)
                    .filter(|(_, receiver)| receiver.is_there())
                {
                    let point = lens.world(receiver.place.as_dvec3());
                    let [constant, diffuse] = match receiver.on_object {
                        Some(own) => {
                            let own = (&object.equations[own], &materials[own].material);
                            returned(own, receiver.tint.as_dvec3(), point)
                        }
                        None => {
                            let ground = &scene.ground;
                            [ground.color * ground.ka, ground.color * ground.kd]
                        }
                    };
                    let returned = light.as_dvec3() * diffuse;
                    products += constant * returned;
                    squares += constant * constant;
                    *light = in_range(returned);
                }
                [products, squares]
            })
            .collect();
        // Added in the order of the bands, whichever was done first.
        let [products, squares] = sums
            .iter()
            .fold([Rgb::ZERO; 2], |[p, s], [products, squares]| {
                [p + products, s + squares]
            });
        self.fit = (squares.min_element() > 0.0).then(|| products / squares);
    }
}

/// Returns the light that the object reflects of the constant ambient light, and of light from other surfaces.
fn returned((pattern, material): (&Equation<f64>, &Material), tint: Rgb, point: DVec3) -> [Rgb; 2] {
    let color = if pattern.has_pattern() {
        pattern.pattern_color(point)
    } else {
        material.color
    } * tint;
    [material.ka * color, material.kd * color]
}

/// Finds the points of the object and the floor that pixels show.
fn find_receivers(
    world: &World<'_>,
    coverage: Coverage<'_>,
    width: usize,
    receivers: &mut [Receiver],
) {
    let (hits, lens) = (&world.hits, world.hits.lens);
    let farthest = DVec3::splat(FARTHEST);
    let near = |point: DVec3| {
        ((point - lens.eye) / lens.unit)
            .clamp(-farthest, farthest)
            .as_vec3()
    };
    let parts = receivers.par_chunks_mut(ROWS * width).zip(coverage.parts());
    parts.for_each_init(FloorScratch::default, |scratch, (part, (band, fragments))| {
        hits.walk(band, fragments, |x, row, hit| {
            part[row * width + x] = Receiver { place: near(hit.point), normal: hit.normal.as_vec3(), on_object: Some(hit.material), tint: hit.tint.as_vec3() };
        });
        if world.ground.is_none() {
            return;
        }
        for (y, line) in (band.place.first_row as usize..).zip(part.chunks_mut(width)) {
            dispatch!(hits.solid.level, simd => {
                world.find_row(simd, y, width, #[inline(always)] |x| line[x].on_object.is_none(), scratch)
            });
            for (x, receiver) in line.iter_mut().enumerate() {
                if let Some(place) = scratch.seen(x) {
                    *receiver = Receiver { place, normal: Vec3::Y, on_object: None, tint: Vec3::ONE };
                }
            }
        }
    });
}

/// Computes the mean intensity that arrives from other surfaces at every pixel of a picture `width` wide, from that at `points` along
/// its longer side.
fn gather(
    world: &World<'_>,
    object: &DiffuseSurface<'_>,
    receivers: &[Receiver],
    [width, points]: [usize; 2],
    gathered: &mut Vec<Vec3>,
) {
    gathered.resize(receivers.len(), Vec3::ZERO);
    if receivers.is_empty() || width == 0 {
        return;
    }
    let height = receivers.len() / width;
    let step = (width.max(height) / points).max(1);
    let columns = width.div_ceil(step);
    let at = |receiver: &Receiver, salt: usize, scratch: &mut Scratch| {
        arriving(world, object, receiver, salt, scratch)
            .min(Rgb::splat(1e36))
            .as_vec3()
    };
    let pick = |column: usize, row: usize| {
        let (x, y) = (
            (column * step + step / 2).min(width - 1),
            (row * step + step / 2).min(height - 1),
        );
        receivers[y * width + x]
    };
    let points: Vec<(Receiver, Vec3)> = (0..height.div_ceil(step) * columns)
        .into_par_iter()
        .map_init(Scratch::default, |scratch, cell| {
            let receiver = pick(cell % columns, cell / columns);
            let light = if receiver.is_there() {
                at(&receiver, cell, scratch)
            } else {
                Vec3::ZERO
            };
            (receiver, light)
        })
        .collect();
    let grid = Grid {
        points,
        columns,
        step,
    };
    let lines = gathered
        .par_chunks_mut(width)
        .zip(receivers.par_chunks(width))
        .enumerate();
    lines.for_each_init(Scratch::default, |scratch, (y, (line, receivers))| {
        dispatch!(world.hits.solid.level, simd => grid.carry_row(simd, y, receivers, line));
        for (x, (light, receiver)) in line.iter_mut().zip(receivers).enumerate() {
            if !receiver.is_there() {
                *light = Vec3::ZERO;
            } else if light.is_nan() {
                *light = at(receiver, y * width + x, scratch);
            }
        }
    });
}

/// Returns the mean intensity from other surfaces at a receiver. `salt` turns the directions, so that their number does not
/// show as steps.
fn arriving(
    world: &World<'_>,
    object: &DiffuseSurface<'_>,
    receiver: &Receiver,
    salt: usize,
    scratch: &mut Scratch,
) -> Rgb {
    let (lens, solid) = (world.hits.lens, &world.hits.solid);
    let n = receiver.normal.as_dvec3();
    let start = lens.world(receiver.place.as_dvec3()) + n * solid.clearance();
    let (middle, _) = solid.ball();
    let directions = directions(n, salt);
    let Scratch {
        on_object,
        on_floor,
        light,
    } = scratch;
    on_object.clear();
    on_floor.clear();
    let mut see_past = |direction: DVec3| {
        if let Beyond::Floor(point) = world.meet(start, direction) {
            on_floor.push(LitPoint::of_floor(point));
        }
    };
    // A convex solid lies behind the tangent plane of each of its points.
    if receiver.on_object.is_some() && solid.is_convex() {
        directions.into_iter().for_each(see_past);
    } else {
        let mut packet = Packet::default();
        for directions in directions.chunks_exact(RAYS) {
            for (ray, direction) in directions.iter().enumerate() {
                packet.set(ray, start - middle, *direction, f64::INFINITY);
            }
            solid.nearest(&packet, ALL, |ray, hit| match hit {
                Some(hit) => on_object.push(LitPoint {
                    point: hit.point,
                    normal: hit.normal,
                    material: hit.material,
                    tint: hit.tint,
                    view: None,
                }),
                None => see_past(directions[ray]),
            });
        }
    }
    let mut sum = Rgb::ZERO;
    object.light(on_object, light, |_, intensity| sum += intensity);
    world
        .floor
        .light(on_floor, light, |_, intensity| sum += intensity);
    sum / directions.len() as f64
}

/// Returns directions about `n`, distributed by the cosine to it and turned by `salt`.
fn directions(n: DVec3, salt: usize) -> [DVec3; DIRECTIONS[0] * DIRECTIONS[1]] {
    let (tangent, bitangent) = n.any_orthonormal_pair();
    let [rows, columns] = DIRECTIONS;
    let turn = [0.754_877_666, 0.569_840_291].map(|golden: f64| (salt as f64 * golden).fract());
    std::array::from_fn(|k| {
        let height = ((k / columns) as f64 + turn[0]) / rows as f64;
        let angle = TAU * ((k % columns) as f64 + turn[1]) / columns as f64;
        // Uniform over the disc under the half-sphere, so distributed by the cosine over the half-sphere.
        let (radius, (sine, cosine)) = (height.sqrt(), angle.sin_cos());
        tangent * (radius * cosine) + bitangent * (radius * sine) + n * (1.0 - height).sqrt()
    })
}

/// The points of the picture at which light was gathered: the middles of square cells.
struct Grid {
    points: Vec<(Receiver, Vec3)>,
    columns: usize,
    step: usize,
}

struct Pixels<S: Simd> {
    x: Lanes<S>,
    place: V3<Lanes<S>>,
    normal: V3<Lanes<S>>,
    /// 1 over the distance of two planes that count as one.
    inverse_gap: Lanes<S>,
}

impl Grid {
    /// Computes the weighted mean of the grid's points about each pixel of row `y`; NaN where none lies on the same surface.
    #[inline(always)]
    fn carry_row<S: Simd>(&self, simd: S, y: usize, receivers: &[Receiver], light: &mut [Vec3]) {
        let rows = self.around(y, y, self.points.len() / self.columns);
        for (x, (receivers, light)) in (0..)
            .step_by(LANES)
            .zip(receivers.chunks(LANES).zip(light.chunks_mut(LANES)))
        {
            if !receivers.iter().any(Receiver::is_there) {
                continue;
            }
            let pixels = Pixels::load(simd, x, receivers);
            let zero = Lanes::splat(simd, 0.0);
            let (mut sum, mut weights) = (V3::new(zero, zero, zero), zero);
            for row in rows.clone() {
                let share = self.tent(row, y);
                for column in self.around(x, x + receivers.len() - 1, self.columns) {
                    let (other, arriving) = &self.points[row * self.columns + column];
                    if share > 0.0 && other.is_there() {
                        let across = pixels.tent(self.middle(column), self.step as f32) * share;
                        let weight = across * pixels.likeness(other);
                        sum = V3::constant(zero, arriving.to_array()).scale_add(weight, sum);
                        weights = weights + weight;
                    }
                }
            }
            let known = weights.greater_than(Lanes::splat(simd, LEAST_WEIGHT));
            let inverse = Lanes::select(
                known,
                Lanes::splat(simd, 1.0) / weights,
                Lanes::splat(simd, f32::NAN),
            );
            let mean = sum.scale(inverse);
            for (lane, light) in light.iter_mut().enumerate() {
                *light = Vec3::new(mean.x.0[lane], mean.y.0[lane], mean.z.0[lane]);
            }
        }
    }

    /// Returns the cells that have a weight at any of the pixels `first` to `last` of a row or column.
    fn around(&self, first: usize, last: usize, count: usize) -> Range<usize> {
        (first / self.step).saturating_sub(NEIGHBOURS)
            ..(last / self.step + NEIGHBOURS + 1).min(count)
    }

    fn middle(&self, cell: usize) -> f32 {
        (cell * self.step + self.step / 2) as f32
    }

    /// Returns a weight that falls from 1 at the cell's middle to 0.
    fn tent(&self, cell: usize, pixel: usize) -> f32 {
        (1.0 - (self.middle(cell) - pixel as f32).abs() / (WIDTH * self.step as f32)).max(0.0)
    }
}

impl<S: Simd> Pixels<S> {
    #[inline(always)]
    fn load(simd: S, x: usize, receivers: &[Receiver]) -> Self {
        let mut planes = [[0.0_f32; 16]; 6];
        for (lane, receiver) in receivers.iter().enumerate() {
            for axis in 0..3 {
                planes[axis][lane] = receiver.place[axis];
                planes[3 + axis][lane] = receiver.normal[axis];
            }
        }
        let [px, py, pz, nx, ny, nz] = &planes;
        let place = V3::new(
            Lanes::load(simd, px),
            Lanes::load(simd, py),
            Lanes::load(simd, pz),
        );
        let normal = V3::new(
            Lanes::load(simd, nx),
            Lanes::load(simd, ny),
            Lanes::load(simd, nz),
        );
        let one = Lanes::splat(simd, 1.0);
        let gap = place
            .dot(place)
            .sqrt()
            .mul_add(Lanes::splat(simd, 0.01), Lanes::splat(simd, 1e-6));
        Self {
            x: Lanes::count_up(simd) + Lanes::splat(simd, x as f32),
            place,
            normal,
            inverse_gap: one / gap,
        }
    }

    /// Returns a weight that falls from 1 at a cell's middle to 0.
    #[inline(always)]
    fn tent(&self, middle: f32, step: f32) -> Lanes<S> {
        let one = self.x.constant(1.0);
        let distance = (self.x - self.x.constant(middle)).abs();
        distance
            .mul_add(self.x.constant(-1.0 / (WIDTH * step)), one)
            .max(self.x.constant(0.0))
    }

    /// Returns 1 for points in one plane, falling towards 0 as the normals or the planes differ.
    #[inline(always)]
    fn likeness(&self, other: &Receiver) -> Lanes<S> {
        let (zero, one) = (self.x.constant(0.0), self.x.constant(1.0));
        let cosine = self
            .normal
            .dot(V3::constant(zero, other.normal.to_array()))
            .max(zero);
        let square = cosine * cosine;
        let fourth = square * square;
        let eighth = fourth * fourth;
        let apart = (self.place - V3::constant(zero, other.place.to_array())).dot(self.normal)
            * self.inverse_gap;
        let square = apart * apart;
        eighth * eighth / square.mul_add(square, one)
    }
}
