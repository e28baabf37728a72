//! Light sources and their attenuation.

use super::choice::choices;
use super::{Rgb, Scene};
use glam::DVec3;

#[derive(Clone, Debug, PartialEq)]
pub struct Ambient {
    /// Ia, per channel.
    pub color: Rgb,
    /// What stands for the light that arrives from all sides.
    pub source: AmbientSource,
}

impl Ambient {
    /// Ia as the equation has it: nothing where light from other surfaces takes its place in the whole picture.
    pub fn constant(&self) -> Rgb {
        if self.source == AmbientSource::Bounce { Rgb::ZERO } else { self.color }
    }
}

impl Default for Ambient {
    fn default() -> Self {
        Self { color: Rgb::ONE, source: AmbientSource::Constant }
    }
}

choices! {
    /// What stands for the light that arrives from all sides.
    pub enum AmbientSource {
        /// The constant Ia.
        Constant = "constant", "constant", "Ia everywhere";
        /// Light that other surfaces of the scene have scattered once.
        Bounce = "bounce", "one bounce", "Light that other surfaces of the scene have scattered once";
        /// The constant in the left half of the picture, one bounce in the right half.
        Split = "split", "compare halves", "The constant in the left half of the picture, one bounce in the right half";
    }
}

/// One light source. Fields that its kind or its attenuation does not read keep their value, so that switching back
/// and forth loses nothing.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// What its author calls it; may be empty.
    pub name: String,
    pub kind: LightKind,
    /// Switched off.
    pub mute: bool,
    /// While any light has this, only those that have it shine.
    pub solo: bool,
    /// Where the light stands, world: the middle of an area light.
    pub position: DVec3,
    /// The way a directional light travels, the axis of a spot light's cone, the side that a rectangle faces; any length
    /// but zero.
    pub direction: DVec3,
    /// Ip, per channel. An area light's is that of all its samples together.
    pub color: Rgb,
    /// Angle between a spot light's axis and the edge of its cone, degrees.
    pub cone: f64,
    /// A spot light's intensity falls with this power of the cosine of the angle to its axis.
    pub exponent: f64,
    /// The outer part of a spot light's cone over which the light fades, 0 (a hard edge) to 1 (from the axis on).
    pub softness: f64,
    /// What an area light looks like.
    pub shape: AreaShape,
    /// Width and height of a rectangle, world units. Its width runs level.
    pub extent: [f64; 2],
    /// Radius of a sphere, world units.
    pub radius: f64,
    /// Points that an area light is replaced by.
    pub samples: u32,
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
            name: String::new(),
            kind: LightKind::Point,
            mute: false,
            solo: false,
            position: DVec3::new(2.0, 2.0, 3.0),
            direction: DVec3::new(-2.0, -2.0, -3.0),
            color: Rgb::ONE,
            cone: 20.0,
            exponent: 4.0,
            softness: 0.0,
            shape: AreaShape::Rectangle,
            extent: [1.0, 1.0],
            radius: 0.5,
            samples: 16,
            attenuation: Attenuation::None,
            k: 1.0,
            c1: 0.25,
            c2: 0.1,
            c3: 0.05,
        }
    }
}

choices! {
    pub enum LightKind {
        Point = "point", "point", "Shines from a point in all directions";
        Directional = "directional", "directional", "Parallel rays, like sunlight";
        Spot = "spot", "spot", "Shines from a point into a cone";
        Area = "area", "area", "A rectangle or a sphere, represented by points spread evenly over it";
    }
}

impl LightKind {
    /// Whether the light stands somewhere.
    pub fn has_position(self) -> bool {
        self != Self::Directional
    }
}

impl Light {
    /// Most points that one area light is replaced by.
    pub const MAX_SAMPLES: u32 = 1024;

    /// Whether `direction` is read.
    pub fn has_direction(&self) -> bool {
        match self.kind {
            LightKind::Point => false,
            LightKind::Directional | LightKind::Spot => true,
            LightKind::Area => self.shape == AreaShape::Rectangle,
        }
    }

    /// Whether the light is on: not muted, and soloed if any light is (`soloing`, see [`Scene::soloing`]).
    pub fn shines(&self, soloing: bool) -> bool {
        !self.mute && (self.solo || !soloing)
    }

    /// Radius of a ball about its position that holds an area light, world units; 0 for other lights.
    pub fn reach(&self) -> f64 {
        match (self.kind, self.shape) {
            (LightKind::Area, AreaShape::Rectangle) => 0.5 * self.extent[0].hypot(self.extent[1]),
            (LightKind::Area, AreaShape::Sphere) => self.radius,
            _ => 0.0,
        }
    }

    /// Points that the light is replaced by: 1, or an area light's samples.
    pub fn sample_count(&self) -> u32 {
        if self.kind == LightKind::Area { self.samples } else { 1 }
    }
}

impl Scene {
    /// Whether any light is soloed, so that the others are silent.
    pub fn soloing(&self) -> bool {
        self.lights.iter().any(|light| light.solo)
    }
}

choices! {
    /// The shape of an area light.
    pub enum AreaShape {
        Rectangle = "rectangle", "rectangle", "A window or a panel; its points shine in all directions";
        Sphere = "sphere", "sphere", "A globe";
    }
}

choices! {
    /// The factor f of a light's contribution.
    pub enum Attenuation {
        /// f = 1.
        None = "none", "none", "f = 1";
        /// f = 1/(r + k), r the distance from the point to the viewer.
        Viewer = "viewer", "1/(r+k), r to the viewer", "As in older textbooks";
        /// f = 1/(r + k), r the distance from the point to the light.
        Light = "light", "1/(r+k), r to the light", "";
        /// f = 1/d², d the distance from the point to the light.
        InverseSquare = "inverse-square", "1/d²", "As light weakens in empty space";
        /// f = min(1, 1/(c1 + c2·d + c3·d²)).
        Quadratic = "quadratic", "1/(c1+c2·d+c3·d²)", "At most 1";
    }
}
