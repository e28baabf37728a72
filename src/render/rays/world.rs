//! What rays meet besides the object: the floor, the wall behind, or the plain background; and surfaces as light from them is
//! gathered.

use super::packet::{PointRow, RAYS};
use super::primary_hit::PrimaryHits;
use super::shadow::{ShadowCaster, Waiting};
use super::solid::Solid;
use crate::illumination::{BRIGHTEST, Equation, Fields, Reached, V3};
use crate::scene::{Ground, Material, Pattern, PatternKind, Reflectance, Rgb, Scene};
use fearless_simd::dispatch;
use glam::{DVec2, DVec3, Vec3};

/// All that rays meet.
pub struct World<'a> {
    pub scene: &'a Scene,
    pub hits: PrimaryHits<'a>,
    /// The height of the floor, if there is one.
    pub ground: Option<f64>,
    wall: Option<Wall>,
    /// How far along the viewing direction the wall stands before the eye, camera distances; infinite where there is none.
    pub wall_depth: f64,
    pub floor: DiffuseSurface<'a>,
    /// The floor's equation for rows of pixels.
    pub floor_lanes: Equation<f32>,
}

/// A plane upright to the viewing direction.
struct Wall {
    centre: DVec3,
    right: DVec3,
    up: DVec3,
    forward: DVec3,
    fields: Fields<f64>,
    color: Rgb,
}

/// What a ray meets.
pub enum Beyond {
    /// A point of the floor, world.
    Floor(DVec3),
    /// The wall, or nothing at all, with its colour.
    Elsewhere(Rgb),
}

impl<'a> World<'a> {
    /// Whether anything but the plain background is there.
    pub fn has_surroundings(scene: &Scene) -> bool {
        scene.ground.visible || scene.backdrop.pattern != PatternKind::None
    }

    /// The world of `scene`; `ka` is the floor's coefficient of ambient light, and `shadows` says whether the object casts any.
    pub fn new(scene: &'a Scene, hits: PrimaryHits<'a>, ka: f64, shadows: bool) -> Self {
        let (lens, backdrop) = (hits.lens, &scene.backdrop);
        let wall = Fields::new(backdrop.pattern, backdrop.scale, 2, DVec3::ZERO, 1.0).map(|fields| Wall {
            centre: scene.camera.target + lens.forward * backdrop.distance,
            right: lens.right,
            up: lens.up,
            forward: lens.forward,
            fields,
            color: backdrop.color,
        });
        let depth = wall.as_ref().map(|wall| (wall.centre - lens.eye).dot(lens.forward) / lens.unit);
        let Ground { kd, color, .. } = scene.ground;
        let floor = matt_scene(scene, [Rgb::splat(ka), Rgb::splat(kd), color], Pattern::default());
        Self {
            scene,
            ground: scene.ground.visible.then_some(scene.ground.height),
            wall,
            wall_depth: depth.filter(|depth| *depth > 0.0).unwrap_or(f64::INFINITY),
            floor_lanes: Equation::in_units(&floor, lens.unit),
            floor: DiffuseSurface::new(&floor, hits.solid, lens.unit, shadows),
            hits,
        }
    }

    /// What the ray meets first: the floor, the wall, or nothing.
    pub fn meet(&self, origin: DVec3, direction: DVec3) -> Beyond {
        let floor = self.ground.and_then(|height| meet_floor(height, origin, direction));
        let wall = self.wall.as_ref().and_then(|wall| wall.met(origin, direction));
        match (floor, wall) {
            (Some((t, point)), wall) if wall.is_none_or(|(nearest, _)| t <= nearest) => Beyond::Floor(point),
            (_, wall) => Beyond::Elsewhere(wall.and_then(|(_, color)| color).unwrap_or(self.scene.image.background)),
        }
    }

    /// Fills the unset (NaN) pixels of row `y` with what lies behind everything; not where there is a floor,
    /// which each ray may meet or miss.
    ///
    /// The wall is upright to the viewing direction, so that places on it are linear along a row.
    pub fn fill_row(&self, y: usize, line: &mut [Vec3]) {
        if self.ground.is_some() {
            return;
        }
        let (lens, depth, background) = (self.hits.lens, self.wall_depth, in_range(self.scene.image.background));
        let Some(wall) = self.wall.as_ref().filter(|_| depth.is_finite()) else {
            line.iter_mut().filter(|pixel| pixel.is_nan()).for_each(|pixel| *pixel = background);
            return;
        };
        let at = |x: f64| {
            let (point, direction) = lens.ray(DVec2::new(x, y as f64 + 0.5));
            let place = lens.world(point + direction * depth) - wall.centre;
            DVec2::new(place.dot(wall.right), place.dot(wall.up))
        };
        let (first, step) = (at(0.5), (at(line.len() as f64 + 0.5) - at(0.5)) / line.len() as f64);
        let color = in_range(wall.color);
        for (x, pixel) in line.iter_mut().enumerate().filter(|(_, pixel)| pixel.x.is_nan()) {
            let place = first + step * x as f64;
            *pixel = if wall.fields.lie_on(V3::new(place.x, place.y, 0.0)) { color } else { background };
        }
    }
}

/// Where the ray meets the floor from above: how many times its length away, and the point. `floor.rs` does the same for the
/// rays of a row of pixels, eight at a time: two texts, since most pixels of a picture may see the floor.
fn meet_floor(height: f64, origin: DVec3, direction: DVec3) -> Option<(f64, DVec3)> {
    let t = (height - origin.y) / direction.y;
    let point = DVec3 { y: height, ..origin + direction * t };
    (direction.y < 0.0 && origin.y > height && point.is_finite()).then_some((t, point))
}

impl Wall {
    /// Where the ray meets the wall: how many times its length away, and the colour of the field there, if there is one.
    fn met(&self, origin: DVec3, direction: DVec3) -> Option<(f64, Option<Rgb>)> {
        let t = (self.centre - origin).dot(self.forward) / direction.dot(self.forward);
        let place = origin + direction * t - self.centre;
        let flat = V3::new(place.dot(self.right), place.dot(self.up), 0.0);
        (t > 0.0 && place.is_finite()).then(|| (t, self.fields.lie_on(flat).then_some(self.color)))
    }
}

/// An intensity in single precision, at most the brightest.
pub fn in_range(intensity: Rgb) -> Vec3 {
    intensity.clamp(Rgb::splat(-BRIGHTEST), Rgb::splat(BRIGHTEST)).as_vec3()
}

/// The scene with a plain diffuse material. Sources that cannot light the object are kept.
pub fn matt_scene(scene: &Scene, [ka, kd, color]: [Rgb; 3], pattern: Pattern) -> Scene {
    let material =
        Material { ka, kd, ks: Rgb::ZERO, color, reflectance: Reflectance::Constant, ..scene.material.clone() };
    Scene { material, pattern, ..scene.clone() }
}

/// A surface that pixels do not see directly, in the shadow of the object if that casts any.
pub struct DiffuseSurface<'a> {
    pub equation: Equation<f64>,
    caster: Option<ShadowCaster<'a>>,
}

/// What a thread keeps from one row of points to the next.
#[derive(Default)]
pub struct LightScratch {
    pub row: PointRow,
    pub words: Vec<u64>,
    pub waiting: Waiting,
}

impl<'a> DiffuseSurface<'a> {
    /// The surface whose material is that of `scene`.
    pub fn new(scene: &Scene, solid: Solid<'a>, unit: f64, shadows: bool) -> Self {
        let equation = Equation::in_units(scene, unit);
        let caster = shadows.then(|| ShadowCaster::new(scene, solid, &equation, false));
        Self { equation, caster }
    }

    /// Finds which sources reach the points of a row; none where there are no shadows.
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
        dispatch!(caster.solid.level, simd => caster.mark_row(simd, row, stride, words, waiting));
        Some(Reached { words, stride, first: 0 })
    }

    /// Calls `each` with the index of every point, world, and I there.
    pub fn light(&self, points: &[(DVec3, DVec3)], scratch: &mut LightScratch, mut each: impl FnMut(usize, Rgb)) {
        let LightScratch { row, words, waiting } = scratch;
        for (first, points) in (0..).step_by(RAYS).zip(points.chunks(RAYS)) {
            if let Some(caster) = &self.caster {
                row.clear(points.len());
                for (index, (point, normal)) in points.iter().enumerate() {
                    row.set(index, caster.relative(*point), *normal);
                }
            }
            let reached = self.reached(1, row, words, waiting);
            for (index, (point, normal)) in points.iter().enumerate() {
                let reached = reached.map(|reached| reached.starting_at(index));
                each(first + index, self.equation.illuminate_world(*point, *normal, reached));
            }
        }
    }
}
