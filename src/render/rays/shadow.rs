//! Shadows: the clearing of visibility bits of sources that the object hides from rows of points.
//!
//! Sixteen points are tested together. Rays that [`super::proof`] cannot decide wait until they fill a packet.

use super::light_buffer::LightBuffer;
use super::packet::{BLOCK, Packet, PointRow, RAYS, Visibility, rays_of};
use super::proof::{AreaLight, Balls, Points, Target};
use super::solid::{PrimaryHit, PrimaryHits, Solid};
use crate::illumination::{Equation, lights_backs};
use crate::render::raster::{Coverage, ROWS};
use crate::scene::{LightKind, Scene};
use fearless_simd::{Simd, dispatch};
use glam::DVec3;
use rayon::prelude::*;
use std::ops::Range;

/// The ratio of a point's distance to the light's from which rounding moves the point by as much as the model's details:
/// its ray then starts at the light.
const FAR_POINT: f64 = 1e9;

struct Lamp<'a> {
    sources: Range<usize>,
    /// One flag for sources under the floor, and one for sources above it.
    sides: [bool; 2],
    /// The area light, where testing all its sources at once is worthwhile.
    area: Option<AreaLight>,
    /// The object as its only source sees it.
    buffer: Option<&'a LightBuffer>,
}

/// The caster of shadows upon rows of points.
pub struct ShadowCaster<'a> {
    pub solid: Solid<'a>,
    /// The height of the floor, if there is one.
    ground: Option<f64>,
    flip: bool,
    targets: Vec<Target>,
    lamps: Vec<Lamp<'a>>,
    balls: Balls,
    middle: DVec3,
    /// True if the points lie on the object as the picture shows it: each pixel or vertex is lifted by its own normal.
    own: bool,
}

/// The rays that wait for their packet to be full. Each light has its own, since rays to one point pass through the same boxes.
#[derive(Default)]
pub struct Waiting(Vec<Queue>);

/// The rays of one light, with their source and point.
#[derive(Default)]
struct Queue {
    packet: Packet,
    marks: [(u32, u32); RAYS],
    count: usize,
}

/// The bits of a row, set where a point sees a source: a source has `stride` words.
struct VisibilityMask<'a> {
    stride: usize,
    words: &'a mut [u64],
}

impl VisibilityMask<'_> {
    /// Clears bits of a source; the lowest bit of `dark` is that of point `first`.
    #[inline(always)]
    fn darken(&mut self, source: usize, first: usize, dark: u32) {
        self.words[source * self.stride + first / 64] &= !(u64::from(dark) << (first % 64));
    }
}

/// Sixteen points of a row, on one side of the surface.
struct Group<'a, S: Simd> {
    row: &'a PointRow,
    first: usize,
    /// 1 on the side of the normals, −1 on the other.
    side: f64,
    points: Points<S>,
}

impl<'a> ShadowCaster<'a> {
    /// Creates the caster of the shadows of `solid` for the sources of `equation`; `own` says whether the points lie on the object.
    pub fn new(scene: &Scene, solid: Solid<'a>, equation: &Equation<f64>, own: bool) -> Self {
        let (middle, radius) = solid.ball();
        let ground = scene.ground.visible.then_some(scene.ground.height);
        let target = |source: usize| {
            let (place, t_max) = equation.way_to(source, middle);
            let parallel = t_max > 1.0;
            let up = if parallel {
                place.y
            } else {
                ground.map_or(0.0, |ground| middle.y + place.y - ground)
            };
            Target::new(place, parallel, up, radius)
        };
        let targets: Vec<Target> = (0..equation.sources.len()).map(target).collect();
        let lamp = |light: usize| {
            let sources = equation.sources_of(light);
            let area = scene
                .lights
                .get(light)
                .filter(|light| light.kind == LightKind::Area && sources.len() > 1);
            let any = |sign: f32| {
                targets[sources.clone()]
                    .iter()
                    .any(|target| target.rise * sign > 0.0)
            };
            let sides = [any(-1.0), any(1.0)];
            let buffer = solid.buffers.get(light).and_then(Option::as_ref);
            Lamp {
                sides,
                buffer: buffer.filter(|_| sources.len() == 1),
                sources,
                area: area.map(|light| AreaLight::new(light, middle, radius)),
            }
        };
        Self {
            lamps: (0..equation.light_count()).map(lamp).collect(),
            targets,
            balls: Balls {
                outer: radius as f32,
                inner: solid.inner_radius() as f32,
            },
            flip: lights_backs(&scene.reflection),
            ground,
            middle,
            solid,
            own,
        }
    }

    /// Returns the words of bits for a row of points with `stride` words per source; one more, since bits are read two
    /// words at a time.
    pub fn words(&self, stride: usize) -> usize {
        self.targets.len() * stride + 1
    }

    /// Returns the lowest height of the object's own points, though normals that lean out of its faces may lift some
    /// beneath the floor.
    fn least_height(&self) -> f64 {
        let ground = self
            .ground
            .filter(|ground| self.solid.lowest() >= ground - self.solid.clearance());
        ground.unwrap_or(f64::NEG_INFINITY)
    }

    /// Returns whether all sources certainly reach all points: a convex solid shadows nothing that faces a source, and no
    /// floor separates them.
    fn reaches_all(&self) -> bool {
        let above = |ground: f64| {
            self.least_height() >= ground && self.targets.iter().all(|target| target.rise > 0.0)
        };
        self.own && !self.flip && self.solid.is_convex() && self.ground.is_none_or(above)
    }

    /// Marks the sources visible from each pixel, a block of bits for each row.
    pub fn mark_pixels(
        &self,
        coverage: Coverage<'_>,
        hits: &PrimaryHits<'_>,
        visibility: &mut Visibility,
    ) {
        let [width, height] = coverage.size.map(|side| side as usize);
        visibility.clear(height, width, self.targets.len());
        if self.reaches_all() {
            return;
        }
        let (block, stride) = (visibility.block, visibility.stride);
        let bands = visibility
            .words
            .par_chunks_mut(ROWS * block)
            .zip(coverage.parts());
        bands.for_each_init(
            <(Vec<PointRow>, Waiting)>::default,
            |(rows, waiting), (words, (band, fragments))| {
                rows.resize_with(ROWS, PointRow::default);
                rows.iter_mut().for_each(|row| row.clear(width));
                hits.walk(
                    band,
                    fragments,
                    |x, row, PrimaryHit { normal, lifted, .. }| {
                        rows[row].set(x, self.relative(lifted), normal);
                    },
                );
                for (row, words) in rows.iter().zip(words.chunks_mut(block)) {
                    self.mark_row(row, stride, words, waiting);
                }
            },
        );
    }

    /// Marks the sources visible from each of `count` vertices or faces; `point` gives a point, world, and its normal.
    pub fn mark_points(
        &self,
        count: usize,
        point: impl Fn(usize) -> (DVec3, DVec3) + Sync,
        visibility: &mut Visibility,
    ) {
        visibility.clear(count.div_ceil(BLOCK), BLOCK, self.targets.len());
        let (block, stride) = (visibility.block, visibility.stride);
        let chunks = visibility.words.par_chunks_mut(block).enumerate();
        chunks.for_each_init(
            <(PointRow, Waiting)>::default,
            |(row, waiting), (chunk, words)| {
                row.clear(BLOCK);
                for index in 0..BLOCK.min(count - chunk * BLOCK) {
                    let (point, normal) = point(chunk * BLOCK + index);
                    row.set(index, self.relative(point), normal);
                }
                self.mark_row(row, stride, words, waiting);
            },
        );
    }

    /// Converts a point of the world to the coordinates of rows.
    pub fn relative(&self, point: DVec3) -> DVec3 {
        point - self.middle
    }

    /// Clears the bits of the sources that are hidden from a row's points; a source has `stride` words.
    pub fn mark_row(
        &self,
        row: &PointRow,
        stride: usize,
        words: &mut [u64],
        waiting: &mut Waiting,
    ) {
        dispatch!(self.solid.level, simd => self.mark_in_lanes(simd, row, stride, words, waiting));
    }

    #[inline(always)]
    fn mark_in_lanes<S: Simd>(
        &self,
        simd: S,
        row: &PointRow,
        stride: usize,
        words: &mut [u64],
        waiting: &mut Waiting,
    ) {
        let mut visible = VisibilityMask { stride, words };
        waiting.0.resize_with(self.lamps.len(), Queue::default);
        let min_height = if self.own {
            self.least_height()
        } else {
            f64::NEG_INFINITY
        };
        let heights = [self.ground.unwrap_or(f64::NEG_INFINITY), min_height]
            .map(|height| height - self.middle.y);
        // Where light counts from either side, a ray starts on the side of its source.
        let sides: &[f64] = if self.flip { &[1.0, -1.0] } else { &[1.0] };
        for packet in (0..row.present.len()).filter(|packet| row.present[*packet] != 0) {
            for &side in sides {
                let lift = [side, self.solid.clearance()];
                let points = Points::load(simd, row, packet, lift, heights, self.balls);
                let group = Group {
                    row,
                    first: packet * RAYS,
                    side,
                    points,
                };
                for (lamp, queue) in self.lamps.iter().zip(&mut waiting.0) {
                    self.mark_lamp(simd, &group, lamp, &mut visible, queue);
                }
            }
        }
        for queue in &mut waiting.0 {
            self.follow(simd, &mut visible, queue);
        }
    }

    #[inline(always)]
    fn mark_lamp<S: Simd>(
        &self,
        simd: S,
        group: &Group<'_, S>,
        lamp: &Lamp<'_>,
        visible: &mut VisibilityMask<'_>,
        queue: &mut Queue,
    ) {
        let Group {
            row,
            first,
            side,
            points,
        } = group;
        let present = row.present[first / RAYS];
        // A convex solid lies behind the tangent plane of each of its points.
        let alone = self.own && *side > 0.0 && self.solid.is_convex();
        let (hidden, mixed) = match &lamp.area {
            _ if alone => (0, 0),
            None => (0, present),
            Some(area) => {
                let hidden = points.hidden(simd, area, self.balls) & present;
                (
                    hidden,
                    present & !hidden & !points.clear(simd, area, self.balls),
                )
            }
        };
        if hidden | mixed == 0 && !(self.ground.is_some() && points.floor_parts(simd, lamp.sides)) {
            return;
        }
        for source in lamp.sources.clone() {
            let target = &self.targets[source];
            let way = points.way_to(simd, target);
            let facing = present & points.facing(simd, &way);
            let mut dark = facing & (hidden | points.beyond_floor(simd, target));
            let unknown = facing & mixed & !dark;
            if unknown != 0 {
                let [open, shut] = points.decide(simd, &way, target, self.balls);
                dark |= unknown & shut;
                let mut unknown = unknown & !open & !shut;
                if let Some(buffer) = lamp.buffer.filter(|_| unknown != 0) {
                    let seen = points.seen(simd, buffer);
                    unknown &= !seen.clear;
                    for ray in rays_of(unknown & seen.sound) {
                        let meets = |triangle| {
                            self.solid
                                .blocks(triangle, self.ray(group, first + ray, source))
                        };
                        if let Some(hides) = buffer.hides(simd, &seen, ray, meets) {
                            dark |= u32::from(hides) << ray;
                            unknown &= !(1 << ray);
                        }
                    }
                }
                self.wait(simd, group, unknown, source, visible, queue);
            }
            visible.darken(source, *first, dark);
        }
    }

    /// Returns the ray from a point to a source: its origin, its direction and the end of its parameter.
    fn ray<S: Simd>(
        &self,
        group: &Group<'_, S>,
        point: usize,
        source: usize,
    ) -> (DVec3, DVec3, f64) {
        let Target {
            place: to,
            parallel,
            ..
        } = self.targets[source];
        let start = group.row.lifted(point, group.side * self.solid.clearance());
        if parallel {
            (start, to, f64::MAX)
        } else if start.length_squared() > (FAR_POINT * to.length()).powi(2) {
            (to, start - to, 1.0)
        } else {
            (start, to - start, 1.0)
        }
    }

    /// Queues rays until their packet is full.
    #[inline(always)]
    fn wait<S: Simd>(
        &self,
        simd: S,
        group: &Group<'_, S>,
        mut rays: u32,
        source: usize,
        visible: &mut VisibilityMask<'_>,
        queue: &mut Queue,
    ) {
        while rays != 0 {
            let point = group.first + rays.trailing_zeros() as usize;
            rays &= rays - 1;
            let (origin, direction, t_max) = self.ray(group, point, source);
            let count = queue.count;
            queue.packet.set(count, origin, direction, t_max);
            queue.marks[count] = (source as u32, point as u32);
            queue.count += 1;
            if queue.count == RAYS {
                self.follow(simd, visible, queue);
            }
        }
    }

    #[inline(always)]
    fn follow<S: Simd>(&self, simd: S, visible: &mut VisibilityMask<'_>, queue: &mut Queue) {
        let count = std::mem::take(&mut queue.count);
        if count == 0 {
            return;
        }
        let requested = u32::MAX >> (32 - count);
        let mut blocked = self.solid.blocked(simd, &queue.packet, requested);
        while blocked != 0 {
            let (source, point) = queue.marks[blocked.trailing_zeros() as usize];
            blocked &= blocked - 1;
            visible.darken(source as usize, point as usize, 1);
        }
    }
}
