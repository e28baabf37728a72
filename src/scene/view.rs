//! The camera's mathematics: from the world to the picture and back, in double precision.

use super::parameter::GREATEST_LENGTH;
use super::{Camera, Projection};
use glam::{DVec2, DVec3};

/// The sine of the angle between the viewing direction and `up` below which their cross product is mostly rounding.
const PARALLEL: f64 = 1e-9;

/// The camera of one picture: an orthonormal frame at the eye and a scale.
///
/// Pixels are square; (0, 0) is the picture's top left corner, and the centre of pixel (x, y) is (x + 0.5, y + 0.5). The
/// depth of a point is its distance from the eye along the viewing direction, in world units.
///
/// # Guarantees
///
/// `right`, `up` and `forward` are unit, orthogonal and finite, `right × up = −forward`, and the scale is positive and
/// finite, whatever the camera's values: an eye at the target looks along −z, and an `up` along the viewing direction is
/// replaced by the axis farthest from it. A roll that is not finite counts as none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// The position of the eye, world.
    pub eye: DVec3,
    /// The direction that points to the right in the picture.
    pub right: DVec3,
    /// The direction that points upwards in the picture.
    pub up: DVec3,
    /// The viewing direction, into the picture.
    pub forward: DVec3,
    /// The picture's middle, pixels.
    pub centre: DVec2,
    /// The scale. Perspective: pixels per unit of tangent, which is the distance of the picture's plane in pixels.
    /// Orthographic: pixels per world unit.
    pub scale: f64,
    /// Perspective or orthographic.
    pub projection: Projection,
}

impl View {
    /// Creates the view of `camera` in a picture of `size` (width, height) pixels; a side of 0 counts as 1.
    pub fn new(camera: &Camera, size: [u32; 2]) -> Self {
        let [width, height] = size.map(|side| f64::from(side.max(1)));
        let span = camera.span([width, height]);
        let forward = direction(camera.target * 0.5 - camera.eye * 0.5).unwrap_or(DVec3::NEG_Z);
        let [right, up] = frame(forward, camera.up, camera.roll);
        let scale = match camera.projection {
            Projection::Perspective => 0.5 * span / (0.5 * camera.fov_y.to_radians()).tan(),
            Projection::Orthographic => span / camera.height,
        };
        Self {
            eye: camera.eye,
            right,
            up,
            forward,
            centre: DVec2::new(0.5 * width, 0.5 * height),
            scale: if scale > 0.0 && scale.is_finite() {
                scale
            } else {
                span
            },
            projection: camera.projection,
        }
    }

    /// Converts a displacement across the picture, `x` to the right and `y` upwards, to that of the same camera without its roll.
    pub fn without_roll(across: DVec2, roll: f64) -> DVec2 {
        rotation(-roll).rotate(across)
    }

    /// Returns the position of `world` in the picture, in pixels, and its depth; `None` for a point behind the eye or
    /// beside it, or so far out that its pixel is not a number.
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

    /// Returns the ray through a point of the picture: its origin and its unit direction, world.
    pub fn ray(&self, pixel: DVec2) -> (DVec3, DVec3) {
        let across = self.across(pixel);
        match self.projection {
            Projection::Perspective => (
                self.eye,
                direction(self.forward + across).unwrap_or(self.forward),
            ),
            Projection::Orthographic => (self.eye + across, self.forward),
        }
    }

    /// Returns the point at `depth` that appears at `pixel`, world.
    pub fn unproject(&self, pixel: DVec2, depth: f64) -> DVec3 {
        let across = self.across(pixel);
        match self.projection {
            Projection::Perspective => self.eye + (self.forward + across) * depth,
            Projection::Orthographic => self.eye + across + self.forward * depth,
        }
    }

    /// Returns the world units that a pixel spans at `depth`, measured across the viewing direction.
    pub fn world_per_pixel(&self, depth: f64) -> f64 {
        match self.projection {
            Projection::Perspective => depth / self.scale,
            Projection::Orthographic => 1.0 / self.scale,
        }
    }

    /// Returns the unit direction from `world` to the eye; the viewer of an orthographic picture is at infinity.
    pub fn towards_eye(&self, world: DVec3) -> DVec3 {
        match self.projection {
            Projection::Perspective => direction(self.eye - world).unwrap_or(-self.forward),
            Projection::Orthographic => -self.forward,
        }
    }

    /// Returns the displacement from the middle of the picture to `pixel`: in world units (orthographic), or units of depth
    /// 1 (perspective).
    fn across(&self, pixel: DVec2) -> DVec3 {
        let offset = (pixel - self.centre) / self.scale;
        self.right * offset.x - self.up * offset.y
    }
}

impl Camera {
    /// The part of the picture's shorter side that [`Camera::fitted`] leaves free on either side.
    pub const MARGIN: f64 = 0.04;

    /// Returns this camera moved back, or spanning more in orthographic projection, until a ball lies in a picture of
    /// `size` pixels: inside the circle about the middle that leaves [`Camera::MARGIN`] free. A camera that shows all of
    /// the ball is returned unchanged, and so is one that would leave the limits of a scene.
    #[must_use]
    pub fn fitted(&self, centre: DVec3, radius: f64, size: [u32; 2]) -> Self {
        let view = View::new(self, size);
        let shorter = f64::from(size[0].min(size[1]).max(1));
        // Of the circle: its tangent, or world units.
        let half = (0.5 - Self::MARGIN) * shorter / view.scale;
        let offset = centre - view.eye;
        let along = offset.dot(view.forward);
        let across = offset.dot(view.right).hypot(offset.dot(view.up));
        let mut fitted = self.clone();
        let depth = match self.projection {
            Projection::Perspective => {
                let (sine, cosine) = half.atan().sin_cos();
                (radius + across * cosine) / sine
            }
            Projection::Orthographic => {
                fitted.height *= ((across + radius) / half).max(1.0);
                radius
            }
        };
        fitted.eye -= view.forward * (depth - along).max(0.0);
        let reach = fitted.eye.abs().max_element().max(fitted.height);
        // A comparison with NaN is false.
        if reach <= GREATEST_LENGTH {
            fitted
        } else {
            self.clone()
        }
    }
}

/// Returns the unit vector along `v`, of any magnitude but zero and infinity.
pub(crate) fn direction(v: DVec3) -> Option<DVec3> {
    let largest = v.abs().max_element();
    (v.is_finite() && largest > 0.0).then(|| (v / largest).normalize())
}

/// Returns the directions to the right and upwards in a picture whose content is turned counter-clockwise by `roll` degrees.
fn frame(forward: DVec3, up: DVec3, roll: f64) -> [DVec3; 2] {
    let right = sideways(forward, up);
    let up = right.cross(forward).normalize();
    let turn = rotation(roll);
    [right * turn.x - up * turn.y, right * turn.y + up * turn.x]
}

/// Returns cosine and sine of an angle in degrees, exact at its quarter turns.
fn rotation(degrees: f64) -> DVec2 {
    let within = if degrees.is_finite() {
        degrees.rem_euclid(360.0)
    } else {
        0.0
    };
    let quarters = (within / 90.0).round();
    let rest = DVec2::from_angle((within - 90.0 * quarters).to_radians());
    match quarters as u8 {
        1 => rest.perp(),
        2 => -rest,
        3 => -rest.perp(),
        _ => rest,
    }
}

/// Returns the unit vector at right angles to `forward` and `up`, to the right when looking along `forward`.
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
