//! What is seen past the object: the floor, the wall behind, or the plain background.

use super::lens::Lens;
use super::shadow::{Extent, Shadows};
use crate::illumination::{BRIGHTEST, Equation, Fields, Reached, Scalar, V3, area_rows};
use crate::scene::{Ground, Light, Material, Pattern, PatternKind, Reflectance, Rgb, Scene, Transparency};
use fearless_simd::Simd;
use glam::{DVec2, DVec3, Vec3};
use std::ops::Range;

/// The scene's floor as a surface of its own: it reflects diffusely and lies under the same lights.
///
/// Its equation takes the object's place in everything but the material. Sources that cannot light the object are kept.
pub(super) fn ground_equation<T: Scalar>(scene: &Scene, unit: f64) -> Equation<T> {
    let Ground { ka, kd, color, .. } = scene.ground;
    Equation::in_units(&diffuse_scene(scene, Rgb::splat(ka), Rgb::splat(kd), color), unit)
}

/// The scene with a plain diffuse material.
pub(super) fn diffuse_scene(scene: &Scene, ka: Rgb, kd: Rgb, color: Rgb) -> Scene {
    let material =
        Material { ka, kd, ks: Rgb::ZERO, color, reflectance: Reflectance::Constant, ..scene.material.clone() };
    Scene { material, pattern: Pattern::default(), transparency: Transparency::default(), ..scene.clone() }
}

/// What lies beyond the object.
pub(super) struct Surroundings<'a> {
    background: Rgb,
    ground: Option<Floor<'a>>,
    wall: Option<Wall>,
}

struct Floor<'a> {
    height: f64,
    equation: &'a Equation<f64>,
    shadows: Option<Shadows<'a>>,
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
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Beyond {
    /// A point of the floor, world.
    Floor(DVec3),
    /// The wall, or nothing at all, with its colour.
    Elsewhere(Rgb),
}

impl<'a> Surroundings<'a> {
    /// The surroundings of `scene`; `equation` is the floor's, and `shadows`, if there are any, come from the object.
    pub fn new(scene: &Scene, lens: &Lens, equation: &'a Equation<f64>, shadows: Option<Shadows<'a>>) -> Self {
        let backdrop = &scene.backdrop;
        let fields = Fields::new(backdrop.pattern, backdrop.scale, 2, DVec3::ZERO, 1.0);
        Self {
            background: scene.image.background,
            ground: scene.ground.visible.then_some(Floor { height: scene.ground.height, equation, shadows }),
            wall: fields.map(|fields| Wall {
                centre: scene.camera.target + lens.forward * backdrop.distance,
                right: lens.right,
                up: lens.up,
                forward: lens.forward,
                fields,
                color: backdrop.color,
            }),
        }
    }

    /// How far along the viewing direction the wall stands before the eye, camera distances; without an end where there is
    /// none.
    pub fn wall_depth(&self, lens: &Lens) -> f64 {
        let depth = |wall: &Wall| (wall.centre - lens.eye).dot(lens.forward) / lens.unit;
        self.wall.as_ref().map(depth).filter(|depth| *depth > 0.0).unwrap_or(f64::INFINITY)
    }

    /// Whether anything but the plain background is there.
    pub fn any(scene: &Scene) -> bool {
        scene.ground.visible || scene.backdrop.pattern != PatternKind::None
    }

    /// What the ray meets first: the floor, the wall, or nothing.
    pub fn meet(&self, origin: DVec3, direction: DVec3) -> Beyond {
        let floor = self.ground.as_ref().and_then(|floor| floor.met(origin, direction));
        let wall = self.wall.as_ref().and_then(|wall| wall.met(origin, direction));
        match (floor, wall) {
            (Some((t, point)), wall) if wall.is_none_or(|(nearest, _)| t <= nearest) => Beyond::Floor(point),
            (_, wall) => Beyond::Elsewhere(wall.and_then(|(_, color)| color).unwrap_or(self.background)),
        }
    }

    /// Fills the pixels of row `y` that are not numbers yet with what lies behind everything; not where there is a floor,
    /// which each ray may meet or miss.
    ///
    /// The wall is upright to the viewing direction, so that places on it are linear along a row.
    #[inline(always)]
    pub fn fill_row<S: Simd>(&self, _: S, lens: &Lens, y: usize, line: &mut [Vec3]) {
        if self.ground.is_some() {
            return;
        }
        let background = in_range(self.background);
        let depth = self.wall_depth(lens);
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

    /// The intensity that arrives along the ray; `scratch` is room for a bit a source.
    pub fn along(&self, origin: DVec3, direction: DVec3, scratch: &mut Vec<u64>) -> Rgb {
        match self.meet(origin, direction) {
            Beyond::Elsewhere(color) => color,
            Beyond::Floor(point) => self.ground.as_ref().map_or(Rgb::ZERO, |floor| floor.intensity(point, scratch)),
        }
    }
}

impl Floor<'_> {
    /// Where the ray meets the floor from above: how many times its length away, and the point.
    fn met(&self, origin: DVec3, direction: DVec3) -> Option<(f64, DVec3)> {
        let t = (self.height - origin.y) / direction.y;
        let point = DVec3 { y: self.height, ..origin + direction * t };
        (direction.y < 0.0 && origin.y > self.height && point.is_finite()).then_some((t, point))
    }

    /// I at a point of the floor.
    fn intensity(&self, point: DVec3, scratch: &mut Vec<u64>) -> Rgb {
        lit(self.equation, self.shadows.as_ref(), point, DVec3::Y, scratch)
    }
}

/// I of a diffuse surface at a point with normal `n`, in the shadow of `shadows`.
pub(super) fn lit(
    equation: &Equation<f64>,
    shadows: Option<&Shadows<'_>>,
    point: DVec3,
    n: DVec3,
    scratch: &mut Vec<u64>,
) -> Rgb {
    let reached = shadows.map(|shadows| {
        scratch.clear();
        let start = point + n * shadows.solid.clearance();
        for light in 0..equation.light_count() {
            // Shadows know the object's sources; these are this surface's own.
            let sources = equation.sources_of(light);
            let open = |source: usize| {
                let (direction, t_max) = equation.way_to(source, point);
                shadows.is_open(start, direction, t_max)
            };
            match shadows.all_of(light, start) {
                Extent::Clear => scratch.extend(sources.map(|_| 1)),
                Extent::Hidden => scratch.extend(sources.map(|_| 0)),
                Extent::Unknown => scratch.extend(sources.map(|source| u64::from(open(source)))),
                Extent::Rows(samples) => {
                    for row in area_rows(samples) {
                        let row = sources.start + row.start as usize..sources.start + row.end as usize;
                        let hidden = hidden_in_row(row.clone(), open);
                        scratch.extend(row.map(|source| u64::from(!hidden.contains(&source))));
                    }
                }
            }
        }
        scratch.push(0);
        Reached { words: scratch, stride: 1, first: 0 }
    });
    equation.illuminate_world(point, n, reached)
}

/// The sources of a row that are hidden, where those follow each other: found from both ends.
fn hidden_in_row(row: Range<usize>, open: impl Fn(usize) -> bool) -> Range<usize> {
    let Some(first) = row.clone().find(|&source| !open(source)) else { return 0..0 };
    let last = (first + 1..row.end).rev().find(|&source| !open(source)).unwrap_or(first);
    first..last + 1
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
pub(super) fn in_range(intensity: Rgb) -> Vec3 {
    intensity.clamp(Rgb::splat(-BRIGHTEST), Rgb::splat(BRIGHTEST)).as_vec3()
}

/// Whether any light is on.
pub(super) fn any_light(scene: &Scene) -> bool {
    let soloing = scene.soloing();
    scene.lights.iter().any(|light: &Light| light.shines(soloing) && light.color != Rgb::ZERO)
}
