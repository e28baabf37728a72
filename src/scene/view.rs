//! The camera's mathematics: from the world to the picture and back, in double precision.

use super::{Camera, Projection};
use glam::{DVec2, DVec3};

/// Below this sine of the angle between the viewing direction and `up` their cross product is mostly rounding.
const PARALLEL: f64 = 1e-9;

/// The camera of one picture: an orthonormal frame at the eye and a scale.
///
/// Pixels are square; (0, 0) is the picture's top left corner, and the centre of pixel (x, y) is (x + 0.5, y + 0.5).
/// The depth of a point is its distance from the eye along the viewing direction, in world units.
///
/// # Guarantees
///
/// `right`, `up` and `forward` are unit, orthogonal and finite, `right × up = −forward`, and the scale is positive and
/// finite, whatever the camera holds: an eye upon the target looks along −z, and an `up` along the viewing direction
/// gives way to the axis farthest from it. A roll that is not finite counts as none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Position of the eye, world.
    pub eye: DVec3,
    /// Direction that points to the right in the picture.
    pub right: DVec3,
    /// Direction that points upwards in the picture.
    pub up: DVec3,
    /// Viewing direction, into the picture.
    pub forward: DVec3,
    /// The picture's middle, pixels.
    pub centre: DVec2,
    /// Perspective: pixels per unit of tangent, which is the distance of the picture's plane in pixels. Orthographic:
    /// pixels per world unit.
    pub scale: f64,
    pub projection: Projection,
}

impl View {
    /// The view of `camera` in a picture of `size` (width, height) pixels; a side of 0 counts as 1.
    pub fn new(camera: &Camera, size: [u32; 2]) -> Self {
        let [width, height] = size.map(|side| f64::from(side.max(1)));
        let forward = direction(camera.target * 0.5 - camera.eye * 0.5).unwrap_or(DVec3::NEG_Z);
        let [right, up] = frame(forward, camera.up, camera.roll);
        let scale = match camera.projection {
            Projection::Perspective => 0.5 * height / (0.5 * camera.fov_y.to_radians()).tan(),
            Projection::Orthographic => height / camera.height,
        };
        Self {
            eye: camera.eye,
            right,
            up,
            forward,
            centre: DVec2::new(0.5 * width, 0.5 * height),
            scale: if scale > 0.0 && scale.is_finite() { scale } else { height },
            projection: camera.projection,
        }
    }

    /// A way across the picture, `x` to the right and `y` upwards, as the same camera without its roll has it.
    pub fn without_roll(across: DVec2, roll: f64) -> DVec2 {
        rotation(-roll).rotate(across)
    }

    /// Where `world` appears, in pixels, and its depth; nothing for a point behind the eye or beside it, or one so far
    /// out that its pixel is no number.
    pub fn project(&self, world: DVec3) -> Option<(DVec2, f64)> {
        let from_eye = world - self.eye;
        let depth = from_eye.dot(self.forward);
        if depth.is_nan() || depth <= 0.0 {
            return None;
        }
        let across = DVec2::new(from_eye.dot(self.right), -from_eye.dot(self.up));
        let pixel = self.centre
            + self.scale
                * match self.projection {
                    Projection::Perspective => across / depth,
                    Projection::Orthographic => across,
                };
        (pixel.is_finite() && depth.is_finite()).then_some((pixel, depth))
    }

    /// The ray through a point of the picture: its origin and its unit direction, world.
    pub fn ray(&self, pixel: DVec2) -> (DVec3, DVec3) {
        let across = self.across(pixel);
        match self.projection {
            Projection::Perspective => (self.eye, direction(self.forward + across).unwrap_or(self.forward)),
            Projection::Orthographic => (self.eye + across, self.forward),
        }
    }

    /// The point at `depth` that appears at `pixel`, world.
    pub fn unproject(&self, pixel: DVec2, depth: f64) -> DVec3 {
        let across = self.across(pixel);
        match self.projection {
            Projection::Perspective => self.eye + (self.forward + across) * depth,
            Projection::Orthographic => self.eye + across + self.forward * depth,
        }
    }

    /// World units that a pixel spans at `depth`, measured across the viewing direction.
    pub fn world_per_pixel(&self, depth: f64) -> f64 {
        match self.projection {
            Projection::Perspective => depth / self.scale,
            Projection::Orthographic => 1.0 / self.scale,
        }
    }

    /// The unit direction from `world` to the eye; the viewer of an orthographic picture is at infinity.
    pub fn towards_eye(&self, world: DVec3) -> DVec3 {
        match self.projection {
            Projection::Perspective => direction(self.eye - world).unwrap_or(-self.forward),
            Projection::Orthographic => -self.forward,
        }
    }

    /// From the middle of the picture to `pixel`: world units (orthographic), or units of depth 1 (perspective).
    fn across(&self, pixel: DVec2) -> DVec3 {
        let offset = (pixel - self.centre) / self.scale;
        self.right * offset.x - self.up * offset.y
    }
}

/// The unit vector along `v`, of any magnitude but zero and infinity.
fn direction(v: DVec3) -> Option<DVec3> {
    let largest = v.abs().max_element();
    (v.is_finite() && largest > 0.0).then(|| (v / largest).normalize())
}

/// What points to the right and upwards in a picture whose content is turned counter-clockwise by `roll` degrees.
fn frame(forward: DVec3, up: DVec3, roll: f64) -> [DVec3; 2] {
    let right = sideways(forward, up);
    let up = right.cross(forward).normalize();
    let turn = rotation(roll);
    [right * turn.x - up * turn.y, right * turn.y + up * turn.x]
}

/// Cosine and sine of an angle in degrees, exact at its quarter turns.
fn rotation(degrees: f64) -> DVec2 {
    let within = if degrees.is_finite() { degrees.rem_euclid(360.0) } else { 0.0 };
    let quarters = (within / 90.0).round();
    let rest = DVec2::from_angle((within - 90.0 * quarters).to_radians());
    match quarters as u8 {
        1 => rest.perp(),
        2 => -rest,
        3 => -rest.perp(),
        _ => rest,
    }
}

/// The unit vector at right angles to `forward` and `up`, to the right of one who looks along `forward`.
fn sideways(forward: DVec3, up: DVec3) -> DVec3 {
    let right = direction(up).map_or(DVec3::ZERO, |up| forward.cross(up));
    if right.length() > PARALLEL {
        return right.normalize();
    }
    let [x, y, z] = forward.abs().to_array();
    let substitute = match (x <= y && x <= z, y <= z) {
        (true, _) => DVec3::X,
        (false, true) => DVec3::Y,
        (false, false) => DVec3::Z,
    };
    forward.cross(substitute).normalize()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::properties;
    use proptest::prelude::*;

    const SIZE: [u32; 2] = [640, 480];

    fn vector(range: f64) -> impl Strategy<Value = DVec3> {
        prop::array::uniform3(-range..range).prop_map(DVec3::from_array)
    }

    fn camera() -> impl Strategy<Value = Camera> {
        let place = (vector(10.0), vector(10.0), vector(1.0), -1e3..1e3f64);
        (place, any::<bool>(), 1.0..170.0, 0.01..100.0).prop_map(
            |((eye, target, up, roll), perspective, fov_y, height)| {
                let projection = if perspective { Projection::Perspective } else { Projection::Orthographic };
                Camera { eye, target, up, roll, projection, fov_y, height, ..Camera::default() }
            },
        )
    }

    #[test]
    fn the_target_is_in_the_middle_and_the_field_of_view_spans_the_height() {
        let view = View::new(&Camera::default(), SIZE);
        assert_eq!(view.project(DVec3::ZERO), Some((DVec2::new(320.0, 240.0), 4.0)));
        let top = DVec3::new(0.0, 4.0 * 20f64.to_radians().tan(), 0.0);
        let (pixel, _) = view.project(top).expect("in front of the eye");
        assert!((pixel - DVec2::new(320.0, 0.0)).length() < 1e-9, "{pixel}");
        let (right, _) = view.project(DVec3::X).expect("in front of the eye");
        assert!(right.x > 320.0 && (right.y - 240.0).abs() < 1e-12, "+x is to the right of an eye on +z");
    }

    #[test]
    fn an_orthographic_picture_spans_its_height_at_every_depth() {
        let view = View::new(&Camera { projection: Projection::Orthographic, ..Camera::default() }, SIZE);
        for z in [-5.0, 0.0, 3.0] {
            let (pixel, depth) = view.project(DVec3::new(0.0, 1.25, z)).expect("in front of the eye");
            assert!(pixel.y.abs() < 1e-12 && (depth - (4.0 - z)).abs() < 1e-12);
        }
    }

    #[test]
    fn a_roll_turns_what_is_seen_counter_clockwise() {
        let at = |roll: f64, world: DVec3| {
            let view = View::new(&Camera { roll, ..Camera::default() }, SIZE);
            let (pixel, _) = view.project(world).expect("in front of the eye");
            // Upwards, from the middle.
            (pixel - view.centre) * DVec2::new(1.0, -1.0)
        };
        let across = at(0.0, DVec3::X).x;
        for quarters in -9..9i32 {
            let turned = at(f64::from(quarters) * 90.0, DVec3::X);
            let expected = [DVec2::X, DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y][quarters.rem_euclid(4) as usize] * across;
            assert!((turned - expected).length() < 1e-12, "{quarters} quarters: {turned}");
        }
        let turned = at(30.0, DVec3::X);
        assert!((turned.to_angle().to_degrees() - 30.0).abs() < 1e-9, "{turned}");
        let back = View::without_roll(turned, 30.0);
        assert!((back - DVec2::new(across, 0.0)).length() < 1e-9);
        for roll in [f64::NAN, f64::INFINITY, -1e300] {
            assert!(View::new(&Camera { roll, ..Camera::default() }, SIZE).right.is_finite());
        }
    }

    #[test]
    fn what_is_behind_the_eye_does_not_appear() {
        let view = View::new(&Camera::default(), SIZE);
        assert_eq!(view.project(DVec3::new(0.0, 0.0, 4.0)), None);
        assert_eq!(view.project(DVec3::new(0.0, 0.0, 5.0)), None);
        assert_eq!(view.project(DVec3::NAN), None);
    }

    #[test]
    fn a_degenerate_camera_still_has_a_frame() {
        let upon = DVec3::splat(2.0);
        for (eye, target, up) in [
            (upon, upon, DVec3::Y),
            (DVec3::Y * 4.0, DVec3::ZERO, DVec3::Y),
            (DVec3::Z, DVec3::ZERO, DVec3::ZERO),
            (DVec3::Z * 1e-300, DVec3::ZERO, DVec3::Y * 1e-300),
            (DVec3::Z * 1e308, DVec3::Z * -1e308, DVec3::X * 1e308),
        ] {
            let view = View::new(&Camera { eye, target, up, ..Camera::default() }, SIZE);
            assert!((view.right.cross(view.up) + view.forward).length() < 1e-9, "{eye} {target} {up}: {view:?}");
        }
    }

    proptest! {
        #![proptest_config(properties::config(file!()))]

        #[test]
        fn unprojecting_what_was_projected_returns_the_point(camera in camera(), point in vector(10.0)) {
            let view = View::new(&camera, SIZE);
            // Beside the eye the pixel lies far outside and its digits no longer hold the point's.
            if let Some((pixel, depth)) = view.project(point).filter(|(_, depth)| *depth > 0.01) {
                prop_assert!((view.unproject(pixel, depth) - point).length() < 1e-8);
                let (origin, along) = view.ray(pixel);
                prop_assert!((along.length() - 1.0).abs() < 1e-12);
                prop_assert!((point - origin).cross(along).length() < 1e-8);
                let beside = point + view.right * view.world_per_pixel(depth);
                let (next, _) = view.project(beside).expect("as deep as the point");
                prop_assert!((next - pixel - DVec2::X).length() < 1e-6);
            }
        }

        #[test]
        fn the_frame_is_orthonormal(camera in camera()) {
            let view = View::new(&camera, SIZE);
            prop_assert!((view.right.cross(view.up) + view.forward).length() < 1e-9);
            let upright = View::new(&Camera { roll: 0.0, ..camera.clone() }, SIZE);
            prop_assert!(upright.up.dot(camera.up) >= 0.0, "up in the world is up in the picture");
        }
    }
}
