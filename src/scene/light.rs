//! Light sources and their attenuation.

use super::camera::{Projection, Viewer};
use super::choice::choices;
use super::parameter::{Limits, Reason, Slider, Unit, table};
use super::symbol::Symbol;
use super::{Rgb, Scene};
use glam::DVec3;
use std::ops::RangeInclusive;

/// The sliders of an area light's lengths and of a constant of the attenuation.
const LENGTHS: Slider = Slider::linear(0.0, 4.0);
const CONSTANT: Slider = Slider::linear(0.0, 2.0);
const ANGLE: Slider = Slider::linear(1.0, 90.0).decimals(1);
const EXPONENTS: Slider = Slider::logarithmic(0.0, Light::MAX_EXPONENT).decimals(2);
const COUNT: Slider = Slider::logarithmic(1.0, Light::MAX_SAMPLES as f64).decimals(0);

table! {
    /// One light source. Fields that its kind or its attenuation does not read keep their value, so that switching back and
    /// forth loses nothing.
    pub struct Light = [light.N] in [lights] {
        /// The light's name; at most 64 characters.
        NAME name: String = String::new(), Text(Light::MAX_NAME).symbol(Symbol::Lights);
        /// The kind of source.
        KIND kind: LightKind = LightKind::Point, Choice.symbol(Symbol::Lights);
        /// A switch that turns the light off.
        MUTE mute: bool = false, Switch.symbol(Symbol::Lights);
        /// A switch that leaves only soloed lights on.
        SOLO solo: bool = false, Switch.symbol(Symbol::Lights);
        /// The light's position, world; the centre of an area light. Not read for directional lights.
        POSITION position: DVec3 = DVec3::new(2.0, 2.0, 3.0), Point.letter("L", Symbol::Light).measured_in(Unit::World)
            .idle_if(&[NO_POSITION]);
        /// The direction of its light: the axis of a spot light, the normal of a rectangle. Of any length but zero, even
        /// where it is not read, so that every light can become one of any kind.
        DIRECTION direction: DVec3 = DVec3::new(-2.0, -2.0, -3.0), Direction(|_, _| true).letter("D", Symbol::Light)
            .idle_if(&[NO_DIRECTION]);
        /// Intensity Ip, linear, 0 to 10³⁰.
        COLOR color: Rgb = Rgb::ONE, Colour(Limits::INTENSITY).letter("Ip", Symbol::Ip);
        /// Angle δ from the axis to the edge of a spot light, degrees, 0.1 to 90.
        CONE cone: f64 = 20.0, Number(Limits::within(&Light::CONE), ANGLE)
            .letter("δ", Symbol::Light).measured_in(Unit::Degrees).idle_if(&[NO_SPOT]);
        /// Exponent e of a spot light: it falls off with the e-th power of the cosine of the angle to its axis; 0 to 1000.
        EXPONENT exponent: f64 = 4.0, Number(Limits::new(0.0, Light::MAX_EXPONENT), EXPONENTS)
            .letter("e", Symbol::Light).idle_if(&[NO_SPOT]);
        /// Outer part of a spot light's cone over which it fades, 0 to 1; 0 is a hard edge.
        SOFTNESS softness: f64 = 0.0, Number(Limits::UNIT, Slider::UNIT).symbol(Symbol::Light).idle_if(&[NO_SPOT]);
        /// Shape of an area light.
        SHAPE shape: AreaShape = AreaShape::Rectangle, Choice.symbol(Symbol::Light).idle_if(&[NO_AREA]);
        /// Width and height of a rectangle, world units.
        EXTENT extent: [f64; 2] = [1.0, 1.0], Pair(Limits::LENGTH, LENGTHS)
            .symbol(Symbol::Light).measured_in(Unit::World).idle_if(&[NO_AREA, NO_RECTANGLE]);
        /// Radius of a sphere, world units.
        RADIUS radius: f64 = 0.5, Number(Limits::LENGTH, LENGTHS)
            .symbol(Symbol::Light).measured_in(Unit::World).idle_if(&[NO_AREA, NO_SPHERE]);
        /// Number N of points that stand for an area light, 1 to 1024.
        SAMPLES samples: u32 = 16, Whole(|_| Limits::new(1.0, Light::MAX_SAMPLES as f64), COUNT)
            .letter("N", Symbol::Light).idle_if(&[NO_AREA]);
        /// The law f(d).
        ATTENUATION attenuation: Attenuation = Attenuation::None, Choice.letter("f", Symbol::Attenuation);
        /// Constant k of 1/(r + k), world units.
        K k: f64 = 1.0, Number(Limits::LENGTH, CONSTANT)
            .letter("k", Symbol::Attenuation).measured_in(Unit::World).idle_if(&[NO_SUM, FAR_LIGHT]);
        /// Constant c1 of the quadratic attenuation.
        C1 c1: f64 = 0.25, Number(Limits::LENGTH, CONSTANT).letter("c1", Symbol::Attenuation).idle_if(&[NO_QUADRATIC, FAR_LIGHT]);
        /// Constant c2 of the quadratic attenuation, 1/world unit.
        C2 c2: f64 = 0.1, Number(Limits::LENGTH, CONSTANT)
            .letter("c2", Symbol::Attenuation).measured_in(Unit::PerWorld).idle_if(&[NO_QUADRATIC, FAR_LIGHT]);
        /// Constant c3 of the quadratic attenuation, 1/world unit².
        C3 c3: f64 = 0.05, Number(Limits::LENGTH, CONSTANT)
            .letter("c3", Symbol::Attenuation).measured_in(Unit::PerWorldSquared).idle_if(&[NO_QUADRATIC, FAR_LIGHT]);
    }
}

/// Returns whether there is such a light and `holds` is true of it.
fn light_is(scene: &Scene, index: usize, holds: fn(&Light) -> bool) -> bool {
    scene.lights.get(index).is_some_and(holds)
}

const NO_POSITION: Reason = (
    |scene, index| !light_is(scene, index, |light| light.kind.has_position()),
    "idle-no-position",
);
const NO_DIRECTION: Reason = (
    |scene, index| !light_is(scene, index, Light::has_direction),
    "idle-no-direction",
);
const NO_SPOT: Reason = (
    |scene, index| !light_is(scene, index, |light| light.kind == LightKind::Spot),
    "idle-no-spotlight",
);
const NO_AREA: Reason = (
    |scene, index| !light_is(scene, index, |light| light.kind == LightKind::Area),
    "idle-no-area",
);
const NO_RECTANGLE: Reason = (
    |scene, index| !light_is(scene, index, |light| light.shape == AreaShape::Rectangle),
    "idle-is-sphere",
);
const NO_SPHERE: Reason = (
    |scene, index| !light_is(scene, index, |light| light.shape == AreaShape::Sphere),
    "idle-is-rectangle",
);
/// No attenuation by 1/(r + k).
const NO_SUM: Reason = (
    |scene, index| {
        light_is(scene, index, |light| {
            !matches!(light.attenuation, Attenuation::Viewer | Attenuation::Light)
        })
    },
    "idle-other-attenuation",
);
const NO_QUADRATIC: Reason = (
    |scene, index| {
        light_is(scene, index, |light| {
            light.attenuation != Attenuation::Quadratic
        })
    },
    "idle-other-attenuation",
);
/// No distance that the attenuation could depend on.
const FAR_LIGHT: Reason = (
    |scene, index| {
        let far = |light: &Light| {
            light.kind == LightKind::Directional && light.attenuation != Attenuation::Viewer
        };
        light_is(scene, index, far)
    },
    "idle-far-light",
);

/// Returns whether the attenuation follows the eye although V is taken as constant.
pub fn viewer_far(scene: &Scene, index: usize) -> bool {
    let camera = &scene.camera;
    let constant =
        camera.viewer == Viewer::Infinite || camera.projection == Projection::Orthographic;
    constant
        && light_is(scene, index, |light| {
            light.attenuation == Attenuation::Viewer
        })
}

choices! {
    /// The kinds of light sources.
    pub enum LightKind = "light-kind" {
        /// A point that shines in all directions.
        Point = "point";
        /// Parallel rays, like sunlight.
        Directional = "directional";
        /// A point that shines into a cone.
        Spot = "spot";
        /// A rectangle or a sphere, by points spread evenly over it.
        Area = "area";
    }
}

impl LightKind {
    /// Returns whether the light has a position.
    pub fn has_position(self) -> bool {
        self != Self::Directional
    }
}

impl Light {
    /// The range of the angle from a spot light's axis to the edge of its cone, degrees.
    pub const CONE: RangeInclusive<f64> = 0.1..=90.0;

    /// The largest exponent of a spot light: its beam is then 4° wide.
    pub const MAX_EXPONENT: f64 = 1e3;

    /// The most characters of a light's name.
    pub const MAX_NAME: usize = 64;

    /// The most points that one area light is replaced by.
    pub const MAX_SAMPLES: u32 = 1024;

    /// Returns whether `direction` is read.
    pub fn has_direction(&self) -> bool {
        match self.kind {
            LightKind::Point => false,
            LightKind::Directional | LightKind::Spot => true,
            LightKind::Area => self.shape == AreaShape::Rectangle,
        }
    }

    /// Returns whether the light is on: not muted, and soloed if any light is (`soloing`, see [`Scene::soloing`]).
    pub fn shines(&self, soloing: bool) -> bool {
        !self.mute && (self.solo || !soloing)
    }

    /// Returns the radius of a ball about its position that holds an area light, world units; 0 for other lights.
    pub fn reach(&self) -> f64 {
        match (self.kind, self.shape) {
            (LightKind::Area, AreaShape::Rectangle) => 0.5 * self.extent[0].hypot(self.extent[1]),
            (LightKind::Area, AreaShape::Sphere) => self.radius,
            _ => 0.0,
        }
    }

    /// Returns the number of points that the light is replaced by: 1, or an area light's samples.
    pub fn sample_count(&self) -> u32 {
        if self.kind == LightKind::Area {
            self.samples
        } else {
            1
        }
    }
}

impl Scene {
    /// Returns whether any light is soloed, so that the others are off.
    pub fn soloing(&self) -> bool {
        self.lights.iter().any(|light| light.solo)
    }
}

choices! {
    /// The shape of an area light.
    pub enum AreaShape = "area-shape" {
        /// A rectangle whose points shine to all sides.
        Rectangle = "rectangle";
        /// A sphere.
        Sphere = "sphere";
    }
}

choices! {
    /// The factor f of a light's contribution.
    pub enum Attenuation = "attenuation" {
        /// f = 1.
        None = "none";
        /// f = 1/(r + k), r the distance from the point to the viewer.
        Viewer = "viewer";
        /// f = 1/(r + k), r the distance from the point to the light.
        Light = "light";
        /// f = 1/d², d the distance from the point to the light.
        InverseSquare = "inverse-square";
        /// f = min(1, 1/(c1 + c2·d + c3·d²)).
        Quadratic = "quadratic";
    }
}
