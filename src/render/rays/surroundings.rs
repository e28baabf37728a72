//! What is seen past the object: the floor, the wall behind, or the plain background.

use crate::illumination::{BRIGHTEST, Fields, V3};
use crate::render::lens::Lens;
use crate::scene::{PatternKind, Rgb, Scene};
use glam::{DVec2, DVec3, Vec3};

/// What lies beyond the object.
pub struct Surroundings {
    background: Rgb,
    /// The height of the floor, if there is one.
    floor: Option<f64>,
    wall: Option<Wall>,
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
pub enum Beyond {
    /// A point of the floor, world.
    Floor(DVec3),
    /// The wall, or nothing at all, with its colour.
    Elsewhere(Rgb),
}

impl Surroundings {
    pub fn new(scene: &Scene, lens: &Lens) -> Self {
        let backdrop = &scene.backdrop;
        let fields = Fields::new(backdrop.pattern, backdrop.scale, 2, DVec3::ZERO, 1.0);
        Self {
            background: scene.image.background,
            floor: scene.ground.visible.then_some(scene.ground.height),
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
        let floor = self.floor.and_then(|height| meet_floor(height, origin, direction));
        let wall = self.wall.as_ref().and_then(|wall| wall.met(origin, direction));
        match (floor, wall) {
            (Some((t, point)), wall) if wall.is_none_or(|(nearest, _)| t <= nearest) => Beyond::Floor(point),
            (_, wall) => Beyond::Elsewhere(wall.and_then(|(_, color)| color).unwrap_or(self.background)),
        }
    }

    /// Fills the unset (NaN) pixels of row `y` with what lies behind everything; not where there is a floor,
    /// which each ray may meet or miss.
    ///
    /// The wall is upright to the viewing direction, so that places on it are linear along a row.
    pub fn fill_row(&self, lens: &Lens, y: usize, line: &mut [Vec3]) {
        if self.floor.is_some() {
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
}

/// Where the ray meets the floor from above: how many times its length away, and the point. `FloorView` does the same for the
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
