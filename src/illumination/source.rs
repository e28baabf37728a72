//! Light sources, prepared: each yields a direction and an attenuation at a point.

use super::{Real, Scalar, V3};
use crate::scene::{Attenuation, Light, LightKind, Rgb};
use glam::DVec3;

/// A light that is farther away than this many camera distances shines in parallel: over an object of the camera
/// distance's size the direction turns by less than 10⁻⁹, well under single precision.
const PARALLEL_BEYOND: f64 = 1e9;

/// Lengths are lifted to this before anything is divided by them, so that a light on the surface stays finite.
const SHORTEST: f64 = 1e-9;

/// One light in the equation's frame: lengths in camera distances, positions relative to the eye, axes as in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Source<T> {
    place: Place<T>,
    falloff: Falloff<T>,
    /// `Ip·kd·color` per channel.
    pub diffuse: [T; 3],
    /// `Ip·ks` per channel.
    pub specular: [T; 3],
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Place<T> {
    /// Parallel rays: L, unit.
    Towards([T; 3]),
    /// A point.
    At([T; 3]),
}

/// The attenuation factor f as a function of a distance in camera distances.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Falloff<T> {
    /// f is the same everywhere.
    Constant(T),
    /// `1/(scale·r + k)`, r to the viewer.
    Viewer { scale: T, k: T },
    /// `1/(scale·r + k)`, r to the light.
    Light { scale: T, k: T },
    /// `min(1, 1/(c1 + c2·d + c3·d²))`.
    Quadratic { c1: T, c2: T, c3: T },
    /// `1/(scale·d)²`, given 1/scale².
    InverseSquare { factor: T },
}

impl<T: Scalar> Source<T> {
    /// Prepares `light`, seen from `eye`, with lengths measured in `unit`s; `kd_color` and `ks` are the material's.
    pub fn new(light: &Light, eye: DVec3, unit: f64, kd_color: Rgb, ks: Rgb) -> Self {
        let offset = (light.position - eye) / unit;
        let distance = length(offset);
        let parallel = light.kind == LightKind::Directional || distance > PARALLEL_BEYOND;
        let place = match light.kind {
            LightKind::Directional => Place::Towards(scalars(-direction(light.direction))),
            LightKind::Point if parallel => Place::Towards(scalars(direction(offset))),
            LightKind::Point => Place::At(scalars(offset)),
        };
        let far = (light.kind == LightKind::Point && parallel).then_some(distance);
        Self {
            place,
            falloff: Falloff::new(light, unit, far),
            diffuse: scalars(light.color * kd_color),
            specular: scalars(light.color * ks),
        }
    }

    /// Unit vector to the light and the attenuation f at `position`, whose distance from the eye is `1/inverse_depth`.
    #[inline(always)]
    pub fn reach<R: Real<Scalar = T>>(&self, position: V3<R>, inverse_depth: R) -> (V3<R>, R) {
        let like = position.x;
        let shortest = like.constant(T::from_f64(SHORTEST));
        let one = like.constant(T::from_f64(1.0));
        let (l, inverse_distance) = match self.place {
            Place::Towards(l) => (V3::constant(like, l), one),
            Place::At(place) => {
                let to_light = V3::constant(like, place) - position;
                let inverse = to_light.dot(to_light).max(shortest * shortest).inverse_sqrt();
                (to_light.scale(inverse), inverse)
            }
        };
        let f = match self.falloff {
            Falloff::Constant(f) => like.constant(f),
            Falloff::Viewer { scale, k } => one / (one / inverse_depth * scale + like.constant(k)).max(shortest),
            Falloff::Light { scale, k } => one / (one / inverse_distance * scale + like.constant(k)).max(shortest),
            Falloff::InverseSquare { factor } => inverse_distance * inverse_distance * factor,
            Falloff::Quadratic { c1, c2, c3 } => {
                let d = one / inverse_distance;
                let sum = d.mul_add(d.mul_add(like.constant(c3), like.constant(c2)), like.constant(c1));
                one.min(one / sum.max(shortest))
            }
        };
        (l, f)
    }

    /// Whether f differs from point to point.
    pub fn attenuates(&self) -> bool {
        !matches!(self.falloff, Falloff::Constant(_))
    }

    /// Whether L is the same everywhere.
    pub fn is_parallel(&self) -> bool {
        matches!(self.place, Place::Towards(_))
    }
}

impl<T: Scalar> Falloff<T> {
    /// `far` is the distance of a point light that is treated as parallel. A directional light has no distance; what
    /// depends on the distance to it leaves it as it is.
    fn new(light: &Light, unit: f64, far: Option<f64>) -> Self {
        let t = T::from_f64;
        let by_distance = light.kind == LightKind::Point;
        match light.attenuation {
            Attenuation::Viewer => Self::Viewer { scale: t(unit), k: t(light.k) },
            _ if !by_distance => Self::Constant(t(1.0)),
            Attenuation::None => Self::Constant(t(1.0)),
            attenuation => {
                if let Some(distance) = far {
                    return Self::Constant(t(at_distance(light, attenuation, distance * unit)));
                }
                match attenuation {
                    Attenuation::Light => Self::Light { scale: t(unit), k: t(light.k) },
                    Attenuation::InverseSquare => Self::InverseSquare { factor: t(1.0 / (unit * unit)) },
                    _ => Self::Quadratic { c1: t(light.c1), c2: t(light.c2 * unit), c3: t(light.c3 * unit * unit) },
                }
            }
        }
    }
}

/// f at `d` world units from the light.
fn at_distance(light: &Light, attenuation: Attenuation, d: f64) -> f64 {
    match attenuation {
        Attenuation::Light => 1.0 / (d + light.k),
        Attenuation::InverseSquare => 1.0 / (d * d),
        Attenuation::Quadratic => (1.0 / (light.c1 + light.c2 * d + light.c3 * d * d)).min(1.0),
        Attenuation::None | Attenuation::Viewer => 1.0,
    }
}

/// Length without overflow or underflow of the squares.
fn length(v: DVec3) -> f64 {
    let largest = v.abs().max_element();
    if largest > 0.0 && largest.is_finite() { (v / largest).length() * largest } else { largest }
}

/// Unit vector of any finite vector but zero, which stays zero.
fn direction(v: DVec3) -> DVec3 {
    let largest = v.abs().max_element();
    if largest > 0.0 { (v / largest).normalize_or_zero() } else { DVec3::ZERO }
}

fn scalars<T: Scalar>(v: DVec3) -> [T; 3] {
    v.to_array().map(T::from_f64)
}
