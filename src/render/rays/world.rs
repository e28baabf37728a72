//! The surroundings that rays meet besides the object: the floor, the wall behind, or the plain background; and surfaces
//! from which light is gathered.

use super::packet::{PointRow, RAYS};
use super::shadow::{ShadowCaster, Waiting};
use super::solid::{PrimaryHits, Solid};
use crate::illumination::{BRIGHTEST, Equation, Fields, LANES, Lanes, Reached, V3};
use crate::render::lens::{FARTHEST, Lens};
use crate::scene::{
    Backfacing, FaceMaterial, Ground, Material, Pattern, PatternKind, Reflectance, Reflection,
    ReflectionModel, Rgb, Scene,
};
use fearless_simd::{f64x8, prelude::*};
use glam::{DVec2, DVec3, Vec3};

/// Everything that rays meet.
pub struct World<'a> {
    pub scene: &'a Scene,
    pub hits: PrimaryHits<'a>,
    /// The materials of the object's faces.
    pub materials: &'a [FaceMaterial],
    /// The object as rays through its other materials meet it, if it has several and light passes.
    pub object: Option<DiffuseSurface<'a>>,
    /// The height of the floor, if there is one.
    pub ground: Option<f64>,
    wall: Option<Wall>,
    /// The distance of the wall before the eye along the viewing direction, camera distances; infinite where there is none.
    pub wall_depth: f64,
    pub floor: DiffuseSurface<'a>,
    /// The floor's equation for rows of pixels.
    pub floor_lanes: Equation<f32>,
}

/// A plane perpendicular to the viewing direction.
struct Wall {
    centre: DVec3,
    right: DVec3,
    up: DVec3,
    forward: DVec3,
    fields: Fields<f64>,
    color: Rgb,
}

/// The first thing that a ray meets besides the object.
pub enum Beyond {
    Floor(DVec3),
    /// The colour of the wall or the background.
    Elsewhere(Rgb),
}

impl<'a> World<'a> {
    /// Returns whether there is anything but the plain background.
    pub fn has_surroundings(scene: &Scene) -> bool {
        scene.ground.visible || scene.backdrop.pattern != PatternKind::None
    }

    /// Creates the world of `scene`; `ka` is the floor's coefficient of ambient light, and `shadows` says whether the
    /// object casts any.
    pub fn new(
        (scene, materials): (&'a Scene, &'a [FaceMaterial]),
        hits: PrimaryHits<'a>,
        ka: f64,
        shadows: bool,
    ) -> Self {
        let (lens, backdrop) = (hits.lens, &scene.backdrop);
        let wall =
            Fields::new(backdrop.pattern, backdrop.scale, 2, DVec3::ZERO, 1.0).map(|fields| Wall {
                centre: scene.camera.target + lens.forward * backdrop.distance,
                right: lens.right,
                up: lens.up,
                forward: lens.forward,
                fields,
                color: backdrop.color,
            });
        let depth = wall
            .as_ref()
            .map(|wall| (wall.centre - lens.eye).dot(lens.forward) / lens.unit);
        let Ground { kd, color, .. } = scene.ground;
        let mut floor = matt_scene(
            scene,
            [Rgb::splat(ka), Rgb::splat(kd), color],
            Pattern::default(),
        );
        // The object may have two sides; the floor is solid ground.
        floor.reflection.backfacing = Backfacing::Clamp;
        Self {
            scene,
            materials,
            object: None,
            ground: scene.ground.visible.then_some(scene.ground.height),
            wall,
            wall_depth: depth.filter(|depth| *depth > 0.0).unwrap_or(f64::INFINITY),
            floor_lanes: Equation::in_units(&floor, lens.unit),
            floor: DiffuseSurface::new(&floor, hits.solid, lens.unit, shadows),
            hits,
        }
    }

    /// Finds the first thing that the ray meets: the floor, the wall, or nothing.
    pub fn meet(&self, origin: DVec3, direction: DVec3) -> Beyond {
        let floor = self
            .ground
            .and_then(|height| meet_floor(height, origin, direction));
        let wall = self
            .wall
            .as_ref()
            .and_then(|wall| wall.met(origin, direction));
        match (floor, wall) {
            (Some((t, point)), wall) if wall.is_none_or(|(nearest, _)| t <= nearest) => {
                Beyond::Floor(point)
            }
            (_, wall) => Beyond::Elsewhere(
                wall.and_then(|(_, color)| color)
                    .unwrap_or(self.scene.image.background),
            ),
        }
    }

    /// Fills the unset (NaN) pixels of row `y` with the wall and the background, unless a floor may be before them. The
    /// wall is perpendicular to the viewing direction, so that positions on it are linear along a row.
    pub fn fill_row(&self, y: usize, line: &mut [Vec3]) {
        if self.ground.is_some() {
            return;
        }
        let (lens, depth) = (self.hits.lens, self.wall_depth);
        let background = in_range(self.scene.image.background);
        let Some(wall) = self.wall.as_ref().filter(|_| depth.is_finite()) else {
            line.iter_mut()
                .filter(|pixel| pixel.is_nan())
                .for_each(|pixel| *pixel = background);
            return;
        };
        let at = |x: f64| {
            let (point, direction) = lens.ray(DVec2::new(x, y as f64 + 0.5));
            let place = lens.world(point + direction * depth) - wall.centre;
            DVec2::new(place.dot(wall.right), place.dot(wall.up))
        };
        let first = at(0.5);
        let step = (at(line.len() as f64 + 0.5) - first) / line.len() as f64;
        let color = in_range(wall.color);
        for (x, pixel) in line
            .iter_mut()
            .enumerate()
            .filter(|(_, pixel)| pixel.x.is_nan())
        {
            let place = first + step * x as f64;
            *pixel = if wall.fields.lie_on(V3::new(place.x, place.y, 0.0)) {
                color
            } else {
                background
            };
        }
    }
}

/// Intersects the ray with the floor from above; returns the distance in multiples of its length, and the point (see `meet_eight`).
fn meet_floor(height: f64, origin: DVec3, direction: DVec3) -> Option<(f64, DVec3)> {
    let t = (height - origin.y) / direction.y;
    let point = DVec3 {
        y: height,
        ..origin + direction * t
    };
    (direction.y < 0.0 && origin.y > height && point.is_finite()).then_some((t, point))
}

impl Wall {
    /// Intersects the ray with the wall; returns the distance in multiples of its length, and the colour of the field
    /// there, if there is one.
    fn met(&self, origin: DVec3, direction: DVec3) -> Option<(f64, Option<Rgb>)> {
        let t = (self.centre - origin).dot(self.forward) / direction.dot(self.forward);
        let place = origin + direction * t - self.centre;
        let flat = V3::new(place.dot(self.right), place.dot(self.up), 0.0);
        (t > 0.0 && place.is_finite()).then(|| (t, self.fields.lie_on(flat).then_some(self.color)))
    }
}

/// Converts an intensity to single precision, limited to the largest one.
pub fn in_range(intensity: Rgb) -> Vec3 {
    intensity
        .clamp(Rgb::splat(-BRIGHTEST), Rgb::splat(BRIGHTEST))
        .as_vec3()
}

/// Returns the scene with a plain diffuse material. Sources that cannot light the object are kept.
pub fn matt_scene(scene: &Scene, [ka, kd, color]: [Rgb; 3], pattern: Pattern) -> Scene {
    let material = Material {
        ka,
        kd,
        ks: Rgb::ZERO,
        color,
        reflectance: Reflectance::Constant,
        ..scene.material.clone()
    };
    let reflection = Reflection {
        model: ReflectionModel::Phong,
        ..scene.reflection.clone()
    };
    Scene {
        material,
        pattern,
        reflection,
        ..scene.clone()
    }
}

/// A surface that pixels do not show directly, in the shadow of the object if that casts any.
pub struct DiffuseSurface<'a> {
    /// The equation of each of its materials.
    pub equations: Vec<Equation<f64>>,
    caster: Option<ShadowCaster<'a>>,
}

/// The buffers that a thread reuses from one row of points to the next.
#[derive(Default)]
pub struct LightScratch {
    pub row: PointRow,
    pub words: Vec<u64>,
    pub waiting: Waiting,
}

/// A point of such a surface.
#[derive(Clone, Copy, Debug)]
pub struct LitPoint {
    /// The point, world.
    pub point: DVec3,
    pub normal: DVec3,
    /// The index of its material.
    pub material: usize,
    /// The colour that tints Od.
    pub tint: Rgb,
    /// V, unit; `None` for the picture's.
    pub view: Option<DVec3>,
}

impl LitPoint {
    /// The floor before a point of it is known.
    pub const FLOOR: Self = Self {
        point: DVec3::ZERO,
        normal: DVec3::Y,
        material: 0,
        tint: Rgb::ONE,
        view: None,
    };

    /// Returns a point of the floor.
    pub const fn of_floor(point: DVec3) -> Self {
        Self {
            point,
            ..Self::FLOOR
        }
    }
}

impl<'a> DiffuseSurface<'a> {
    /// Creates the surface whose material is that of `scene`.
    pub fn new(scene: &Scene, solid: Solid<'a>, unit: f64, shadows: bool) -> Self {
        Self::of_materials(scene, vec![Equation::in_units(scene, unit)], solid, shadows)
    }

    /// Creates the surface whose materials have these equations, all with the lights of `scene`.
    pub fn of_materials(
        scene: &Scene,
        equations: Vec<Equation<f64>>,
        solid: Solid<'a>,
        shadows: bool,
    ) -> Self {
        let caster = shadows.then(|| ShadowCaster::new(scene, solid, &equations[0], false));
        Self { equations, caster }
    }

    /// Finds the sources that reach the points of a row; `None` where there are no shadows.
    pub fn reached<'b>(
        &self,
        stride: usize,
        row: &PointRow,
        words: &'b mut Vec<u64>,
        waiting: &mut Waiting,
    ) -> Option<Reached<'b>> {
        let caster = self.caster.as_ref()?;
        words.clear();
        words.resize(caster.words(stride), u64::MAX);
        caster.mark_row(row, stride, words, waiting);
        Some(Reached {
            words,
            stride,
            first: 0,
        })
    }

    /// Calls `each` with the index of every point, world, and I there.
    pub fn light(
        &self,
        points: &[LitPoint],
        scratch: &mut LightScratch,
        mut each: impl FnMut(usize, Rgb),
    ) {
        let LightScratch {
            row,
            words,
            waiting,
        } = scratch;
        for (first, points) in (0..).step_by(RAYS).zip(points.chunks(RAYS)) {
            if let Some(caster) = &self.caster {
                row.clear(points.len());
                for (index, at) in points.iter().enumerate() {
                    row.set(index, caster.relative(at.point), at.normal);
                }
            }
            let reached = self.reached(1, row, words, waiting);
            for (index, at) in points.iter().enumerate() {
                let (equation, reached) = (
                    &self.equations[at.material],
                    Reached::starting_at(reached, index),
                );
                let place = (at.point, at.normal);
                let intensity = equation.illuminate_tinted(place, at.tint, at.view, reached);
                each(first + index, intensity);
            }
        }
    }
}

/// The pixels whose rays are intersected with the floor at a time.
const EIGHT: usize = 8;

/// The buffers that a thread reuses from one row to the next.
#[derive(Default)]
pub struct FloorScratch {
    light: LightScratch,
    /// The positions relative to the eye, camera distances.
    position: [Vec<f32>; 3],
}

impl FloorScratch {
    /// Returns the point of the floor that a pixel of the row shows, relative to the eye, camera distances.
    pub fn seen(&self, x: usize) -> Option<Vec3> {
        let [px, py, pz] = &self.position;
        (self.light.row.present[x / RAYS] >> (x % RAYS) & 1 == 1)
            .then(|| Vec3::new(px[x], py[x], pz[x]))
    }
}

impl World<'_> {
    /// Writes the floor's intensity into the unset (NaN) pixels of row `y` that show the floor.
    #[inline(always)]
    pub fn light_row<S: Simd>(
        &self,
        simd: S,
        y: usize,
        line: &mut [Vec3],
        scratch: &mut FloorScratch,
    ) {
        if self.find_row(simd, y, line.len(), |x| line[x].x.is_nan(), scratch) {
            let FloorScratch {
                light:
                    LightScratch {
                        row,
                        words,
                        waiting,
                    },
                position,
            } = scratch;
            let reached = self
                .floor
                .reached(line.len().div_ceil(64), row, words, waiting);
            self.light_found(simd, row, position, reached, line);
        }
    }

    /// Finds the points of the floor that the `wanted` pixels of row `y` show; returns whether there are any.
    #[inline(always)]
    pub fn find_row<S: Simd>(
        &self,
        simd: S,
        y: usize,
        width: usize,
        wanted: impl Fn(usize) -> bool,
        scratch: &mut FloorScratch,
    ) -> bool {
        let Some(ground) = self.ground else {
            return false;
        };
        let FloorScratch {
            light: LightScratch { row, .. },
            position,
        } = scratch;
        row.clear(width);
        position
            .iter_mut()
            .for_each(|plane| plane.resize(width.next_multiple_of(RAYS), 0.0));
        let mut any = false;
        for x in (0..width).step_by(EIGHT) {
            let mut eight = 0;
            for lane in 0..EIGHT.min(width - x) {
                eight |= u32::from(wanted(x + lane)) << lane;
            }
            if eight != 0 {
                any |= self.meet_eight(simd, ground, [x, y], eight, row, position);
            }
        }
        any
    }

    /// Finds the points of the floor that eight pixels from column `x` on show; returns whether there are any.
    #[inline(always)]
    fn meet_eight<S: Simd>(
        &self,
        simd: S,
        height: f64,
        [x, y]: [usize; 2],
        wanted: u32,
        row: &mut PointRow,
        position: &mut [Vec<f32>; 3],
    ) -> bool {
        let lens = self.hits.lens;
        let Lens {
            eye,
            unit,
            right,
            focal,
            middle,
            perspective,
            ..
        } = *lens;
        let (point, direction) = lens.ray(DVec2::new(middle.x, y as f64 + 0.5));
        let columns: [f64; EIGHT] = [0.5, 1.5, 2.5, 3.5, 4.5, 5.5, 6.5, 7.5];
        let across = (f64x8::from_slice(simd, &columns) + (x as f64 - middle.x)) / focal;
        let splat = |v: f64| f64x8::splat(simd, v);
        let drop = (height - eye.y) / unit;
        let (from, along) = if perspective {
            (splat(0.0), across)
        } else {
            (across, splat(0.0))
        };
        let from_y = from * right.y + point.y;
        let along_y = along * right.y + direction.y;
        let t = (splat(drop) - from_y) / along_y;
        let px = t * (along * right.x + direction.x) + (from * right.x + point.x);
        let pz = t * (along * right.z + direction.z) + (from * right.z + point.z);
        let near = splat(FARTHEST);
        let seen = along_y.simd_lt(splat(0.0))
            & from_y.simd_gt(splat(drop))
            & px.abs().simd_lt(near)
            & pz.abs().simd_lt(near)
            & t.simd_le(splat(self.wall_depth));
        let seen = seen.to_bitmask() as u32 & wanted;
        if seen == 0 || drop.abs() >= FARTHEST {
            return false;
        }
        row.present[x / RAYS] |= seen << (x % RAYS);
        let (ball, _) = self.hits.solid.ball();
        let base = eye - ball;
        (px * unit + base.x).store_slice(&mut row.start[0][x..x + EIGHT]);
        (pz * unit + base.z).store_slice(&mut row.start[2][x..x + EIGHT]);
        row.start[1][x..x + EIGHT].fill(height - ball.y);
        row.normal[0][x..x + EIGHT].fill(0.0);
        row.normal[1][x..x + EIGHT].fill(1.0);
        row.normal[2][x..x + EIGHT].fill(0.0);
        position[1][x..x + EIGHT].fill(drop as f32);
        for lane in 0..EIGHT {
            position[0][x + lane] = px[lane] as f32;
            position[2][x + lane] = pz[lane] as f32;
        }
        true
    }

    #[inline(always)]
    fn light_found<S: Simd>(
        &self,
        simd: S,
        row: &PointRow,
        [px, py, pz]: &[Vec<f32>; 3],
        reached: Option<Reached<'_>>,
        line: &mut [Vec3],
    ) {
        let (zero, one) = (Lanes::splat(simd, 0.0), Lanes::splat(simd, 1.0));
        for (x, pixels) in (0..).step_by(LANES).zip(line.chunks_mut(LANES)) {
            let present = row.present[x / RAYS] >> (x % RAYS) & (u32::MAX >> (32 - LANES));
            if present == 0 {
                continue;
            }
            let position = V3::new(
                Lanes::load(simd, &px[x..]),
                Lanes::load(simd, &py[x..]),
                Lanes::load(simd, &pz[x..]),
            );
            let point = self.floor_lanes.site(position, V3::new(zero, one, zero));
            let reached = Reached::starting_at(reached, x);
            let [r, g, b] = self.floor_lanes.illuminate(&point, reached);
            for (lane, pixel) in pixels
                .iter_mut()
                .enumerate()
                .filter(|(lane, _)| present >> lane & 1 == 1)
            {
                *pixel = Vec3::new(r.0[lane], g.0[lane], b.0[lane]);
            }
        }
    }
}
