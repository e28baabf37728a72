//! One bounce: light that the object and the floor have scattered once, gathered from all sides.
//!
//! The light that arrives at a point is the mean of that seen in directions distributed by the cosine to its normal, as a
//! diffuse surface weights them. It is gathered on a grid of pixels and interpolated to the others by weights that fall
//! with the distance in the picture and vanish on another surface (after W. J. Ward et al., *A ray tracing solution for
//! diffuse interreflection*, 1988: indirect light changes slowly except at creases).

use super::packet::{Packet, RAYS};
use super::world::{Beyond, DiffuseSurface, FloorScratch, LightScratch, LitPoint, World, in_range};
use crate::illumination::{LANES, Lanes, Real, V3};
use crate::render::lens::FARTHEST;
use crate::render::node::{Memory, capacity};
use crate::render::raster::{Coverage, ROWS};
use crate::scene::{FaceMaterial, Rgb};
use fearless_simd::{dispatch, prelude::*};
use glam::{DVec3, Vec3};
use rayon::prelude::*;
use std::f64::consts::TAU;
use std::ops::Range;

/// The directions from a point: rows times columns.
const DIRECTIONS: [usize; 2] = [8, 8];
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

/// The surface that a pixel shows, if any.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
enum ReceiverKind {
    #[default]
    Beyond,
    Floor,
    /// The object, where its material has this index.
    Object(u32),
}

/// A point that a pixel shows.
#[derive(Clone, Copy, Debug, Default)]
struct Receiver {
    kind: ReceiverKind,
    /// The position relative to the eye, camera distances.
    place: Vec3,
    /// The unit normal.
    normal: Vec3,
    /// The colour that tints Od there.
    tint: Vec3,
}

/// The points that scatter light to a receiver.
#[derive(Default)]
struct Senders {
    on_object: Vec<LitPoint>,
    on_floor: Vec<LitPoint>,
}

/// The points that the pixels show, and those that scatter light to a grid of them: all that stays while lights move.
#[derive(Default)]
pub struct Receivers {
    /// The point of each pixel of a picture `width` wide.
    pixels: Vec<Receiver>,
    width: usize,
    grid: Grid,
    /// The senders of each of the grid's points.
    senders: Vec<Senders>,
}

/// The light that arrives at the pixels from other surfaces, and the constant that approximates it best.
#[derive(Default)]
pub struct Bounced {
    /// The light that the surface scatters of the mean intensity that arrives.
    pub scattered: Vec<Vec3>,
    /// The Ia whose constant term differs least from it: least squares over all pixels that show a surface.
    pub fit: Option<Rgb>,
}

impl Receivers {
    pub fn count(&self, memory: &mut Memory) {
        memory.pixels +=
            capacity(&self.pixels) + capacity(&self.grid.points) + capacity(&self.senders);
        let points = |senders: &Senders| capacity(&senders.on_object) + capacity(&senders.on_floor);
        memory.pixels += self.senders.iter().map(points).sum::<u64>();
    }

    /// Finds the points that the pixels of a picture show that stands for a finer one of `coarser` times its sides, and the
    /// senders of those in a grid.
    pub fn run(&mut self, world: &World<'_>, coverage: Coverage<'_>, coarser: u32) {
        let [width, height] = world.scene.image.size.map(|side| side as usize);
        self.width = width;
        self.pixels.resize(width * height, Receiver::default());
        find_receivers(world, coverage, width, &mut self.pixels);
        let points = (POINTS / coarser as usize).max(FEWEST_POINTS);
        self.grid = Grid::new(&self.pixels, [width, height], points);
        self.senders
            .resize_with(self.grid.points.len(), Senders::default);
        let points = self.senders.par_iter_mut().zip(&self.grid.points);
        points
            .enumerate()
            .for_each(|(cell, (senders, receiver))| senders.find(world, receiver, cell));
    }
}

impl Bounced {
    pub fn count(&self, memory: &mut Memory) {
        memory.pixels += capacity(&self.scattered);
    }

    /// Gathers light at every pixel; neither the floor nor `object`, whose `materials` these are, has the ambient light that
    /// the bounce replaces.
    pub fn run(
        &mut self,
        world: &World<'_>,
        (object, materials): (&DiffuseSurface<'_>, &[FaceMaterial]),
        receivers: &Receivers,
    ) {
        let Receivers {
            pixels,
            width,
            grid,
            senders,
        } = receivers;
        let (ground, lens) = (&world.scene.ground, world.hits.lens);
        let arriving: Vec<Vec3> = senders
            .par_iter()
            .map_init(LightScratch::default, |scratch, senders| {
                senders.arriving(world, object, scratch)
            })
            .collect();
        let returned = |receiver: &Receiver| match receiver.kind {
            ReceiverKind::Object(own) => {
                let (equation, material) = (
                    &object.equations[own as usize],
                    &materials[own as usize].material,
                );
                let color = if equation.has_pattern() {
                    equation.pattern_color(lens.world(receiver.place.as_dvec3()))
                } else {
                    material.color
                } * receiver.tint.as_dvec3();
                [material.ka * color, material.kd * color]
            }
            ReceiverKind::Floor | ReceiverKind::Beyond => {
                [ground.color * ground.ka, ground.color * ground.kd]
            }
        };
        self.scattered.resize(pixels.len(), Vec3::ZERO);
        let bands = self
            .scattered
            .par_chunks_mut(ROWS * width.max(&1))
            .zip(pixels.par_chunks(ROWS * width.max(&1)));
        let of_band =
            |(scratch, own): &mut (LightScratch, Senders),
             (band, (light, receivers)): (usize, (&mut [Vec3], &[Receiver]))| {
                let (mut products, mut squares) = (Rgb::ZERO, Rgb::ZERO);
                let rows = light.chunks_mut(*width).zip(receivers.chunks(*width));
                for (y, (light, receivers)) in (band * ROWS..).zip(rows) {
                    dispatch!(world.hits.solid.level, simd => grid.carry_row(simd, y, &arriving, receivers, light));
                    for (x, (light, receiver)) in light.iter_mut().zip(receivers).enumerate() {
                        if receiver.kind == ReceiverKind::Beyond {
                            *light = Vec3::ZERO;
                            continue;
                        }
                        if light.is_nan() {
                            own.find(world, receiver, y * width + x);
                            *light = own.arriving(world, object, scratch);
                        }
                        let [constant, diffuse] = returned(receiver);
                        let returned = light.as_dvec3() * diffuse;
                        products += constant * returned;
                        squares += constant * constant;
                        *light = in_range(returned);
                    }
                }
                [products, squares]
            };
        let sums: Vec<[Rgb; 2]> = bands
            .enumerate()
            .map_init(Default::default, of_band)
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
        part.fill(Receiver::default());
        hits.walk(band, fragments, |x, row, hit| {
            part[row * width + x] = Receiver { place: near(hit.point), normal: hit.normal.as_vec3(), kind: ReceiverKind::Object(hit.material as u32), tint: hit.tint.as_vec3() };
        });
        if world.ground.is_none() {
            return;
        }
        for (y, line) in (band.place.first_row as usize..).zip(part.chunks_mut(width)) {
            dispatch!(hits.solid.level, simd => {
                world.find_row(simd, y, width, #[inline(always)] |x| line[x].kind == ReceiverKind::Beyond, scratch)
            });
            for (x, receiver) in line.iter_mut().enumerate() {
                if let Some(place) = scratch.seen(x) {
                    *receiver = Receiver { place, normal: Vec3::Y, kind: ReceiverKind::Floor, tint: Vec3::ONE };
                }
            }
        }
    });
}

impl Senders {
    /// Finds the points that scatter light to a receiver. `salt` turns the directions, so that their number does not show as
    /// steps.
    fn find(&mut self, world: &World<'_>, receiver: &Receiver, salt: usize) {
        let Self {
            on_object,
            on_floor,
        } = self;
        on_object.clear();
        on_floor.clear();
        if receiver.kind == ReceiverKind::Beyond {
            return;
        }
        let (lens, solid) = (world.hits.lens, &world.hits.solid);
        let n = receiver.normal.as_dvec3();
        let start = lens.world(receiver.place.as_dvec3()) + n * solid.clearance();
        let from = start - solid.ball().0;
        // A convex solid lies behind the tangent plane of each of its points.
        let alone = receiver.kind != ReceiverKind::Floor && solid.is_convex();
        let may_meet = |direction: &DVec3| !alone && !solid.is_passed(from, *direction);
        let (towards, past): (Vec<DVec3>, Vec<DVec3>) =
            directions(n, salt).into_iter().partition(may_meet);
        let mut see_past = |direction: DVec3| {
            if let Beyond::Floor(point) = world.meet(start, direction) {
                on_floor.push(LitPoint::of_floor(point));
            }
        };
        past.into_iter().for_each(&mut see_past);
        let mut packet = Packet::default();
        for directions in towards.chunks(RAYS) {
            for (ray, direction) in directions.iter().enumerate() {
                packet.set(ray, from, *direction, f64::INFINITY);
            }
            let all = u32::MAX >> (32 - directions.len());
            solid.nearest(&packet, all, |ray, hit| match hit {
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

    /// Returns the mean intensity that arrives from them.
    fn arriving(
        &self,
        world: &World<'_>,
        object: &DiffuseSurface<'_>,
        scratch: &mut LightScratch,
    ) -> Vec3 {
        let mut sum = Rgb::ZERO;
        object.light(&self.on_object, scratch, |_, intensity| sum += intensity);
        world
            .floor
            .light(&self.on_floor, scratch, |_, intensity| sum += intensity);
        let count: usize = DIRECTIONS.iter().product();
        (sum / count as f64).min(Rgb::splat(1e36)).as_vec3()
    }
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

/// The points of the picture at which light is gathered: the middles of square cells.
#[derive(Default)]
struct Grid {
    points: Vec<Receiver>,
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
    /// Creates a grid of `points` along the picture's longer side.
    fn new(pixels: &[Receiver], [width, height]: [usize; 2], points: usize) -> Self {
        let step = (width.max(height) / points).max(1);
        let place = |cell: usize, side: usize| (cell * step + step / 2).min(side - 1);
        let middles = |side: usize| (0..side.div_ceil(step)).map(move |cell| place(cell, side));
        let points =
            middles(height).flat_map(|y| middles(width).map(move |x| pixels[y * width + x]));
        Self {
            points: points.collect(),
            columns: width.div_ceil(step),
            step,
        }
    }

    /// Computes the weighted mean of the light that arrives at the grid's points about each pixel of row `y`; NaN where none
    /// lies on the same surface.
    #[inline(always)]
    fn carry_row<S: Simd>(
        &self,
        simd: S,
        y: usize,
        arriving: &[Vec3],
        receivers: &[Receiver],
        light: &mut [Vec3],
    ) {
        let rows = self.around(y, y, self.points.len() / self.columns);
        for (x, (receivers, light)) in (0..)
            .step_by(LANES)
            .zip(receivers.chunks(LANES).zip(light.chunks_mut(LANES)))
        {
            let all = |kind: ReceiverKind| receivers.iter().all(|receiver| receiver.kind == kind);
            if all(ReceiverKind::Beyond) {
                continue;
            }
            let on_floor = all(ReceiverKind::Floor);
            let pixels = Pixels::load(simd, x, receivers);
            let zero = Lanes::splat(simd, 0.0);
            let columns = self.around(x, x + receivers.len() - 1, self.columns);
            let mut tents = [zero; LANES + 2 * NEIGHBOURS];
            for (tent, column) in tents.iter_mut().zip(columns.clone()) {
                *tent = pixels.tent(self.middle(column), self.step as f32);
            }
            let (mut sum, mut weights) = (V3::new(zero, zero, zero), zero);
            for row in rows.clone() {
                let share = self.tent(row, y);
                let cells = row * self.columns + columns.start..row * self.columns + columns.end;
                let points = self.points[cells.clone()].iter().zip(&arriving[cells]);
                for ((other, arriving), tent) in points.zip(&tents) {
                    if share > 0.0 && other.kind != ReceiverKind::Beyond {
                        let mut weight = *tent * share;
                        // Points of the floor are in one plane.
                        if !(on_floor && other.kind == ReceiverKind::Floor) {
                            weight = weight * pixels.likeness(other);
                        }
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
