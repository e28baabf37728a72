//! Light sources and their attenuation.

use super::Rgb;
use glam::DVec3;
use serde::{Deserialize, Serialize};

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Ambient {
    /// Ia, per channel.
    pub color: Rgb,
}

impl Default for Ambient {
    fn default() -> Self {
        Self { color: Rgb::ONE }
    }
}

/// One light source. Fields that its kind or its attenuation does not read keep their value, so that switching back
/// and forth loses nothing.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Light {
    pub kind: LightKind,
    /// Where a point light stands, world.
    pub position: DVec3,
    /// The way a directional light travels; any length but zero.
    pub direction: DVec3,
    /// Ip, per channel.
    pub color: Rgb,
    pub attenuation: Attenuation,
    /// The constant of `1/(r + k)`, world units.
    pub k: f64,
    /// Constant coefficient of the quadratic attenuation.
    pub c1: f64,
    /// Linear coefficient, per world unit.
    pub c2: f64,
    /// Quadratic coefficient, per world unit squared.
    pub c3: f64,
}

impl Default for Light {
    fn default() -> Self {
        Self {
            kind: LightKind::Point,
            position: DVec3::new(2.0, 2.0, 3.0),
            direction: DVec3::new(-2.0, -2.0, -3.0),
            color: Rgb::ONE,
            attenuation: Attenuation::None,
            k: 1.0,
            c1: 0.25,
            c2: 0.1,
            c3: 0.05,
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum LightKind {
    Point,
    Directional,
}

/// The factor f of a light's contribution.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Attenuation {
    /// f = 1.
    None,
    /// f = 1/(r + k), r the distance from the point to the viewer.
    Viewer,
    /// f = 1/(r + k), r the distance from the point to the light.
    Light,
    /// f = 1/d², d the distance from the point to the light.
    InverseSquare,
    /// f = min(1, 1/(c1 + c2·d + c3·d²)).
    Quadratic,
}
