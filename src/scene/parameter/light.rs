//! The keys of each light.

use super::super::{AreaShape, Attenuation, Light, LightKind, Projection, Scene, Viewer};
use super::access::access;
use super::{Kind, Limits, Parameter, Slider, Symbol};

pub(super) const ALL: &[&Parameter] = &[
    &NAME,
    &KIND,
    &MUTE,
    &SOLO,
    &POSITION,
    &DIRECTION,
    &COLOR,
    &CONE,
    &EXPONENT,
    &SOFTNESS,
    &SHAPE,
    &EXTENT,
    &RADIUS,
    &SAMPLES,
    &ATTENUATION,
    &K,
    &C1,
    &C2,
    &C3,
];

/// `reason`, where the light does not satisfy `used`.
fn unless(scene: &Scene, index: usize, used: fn(&Light) -> bool, reason: &'static str) -> Option<&'static str> {
    scene.lights.get(index).is_none_or(|light| !used(light)).then_some(reason)
}

pub static NAME: Parameter = Parameter::new(
    "light.N.name",
    "name",
    Kind::Text { at: access!(light: name), longest: Light::MAX_NAME },
    "What the light is called; may be empty.",
)
.label("Name")
.symbol(Symbol::Lights);

pub static KIND: Parameter =
    Parameter::new("light.N.kind", "kind", Kind::Choice(&access!(light: kind)), "The kind of light source.")
        .label("Kind")
        .symbol(Symbol::Lights);

pub static MUTE: Parameter =
    Parameter::new("light.N.mute", "mute", Kind::Switch(access!(light: mute)), "Whether the light is switched off.")
        .label("Mute")
        .symbol(Symbol::Lights);

pub static SOLO: Parameter = Parameter::new(
    "light.N.solo",
    "solo",
    Kind::Switch(access!(light: solo)),
    "While any light has this, only the lights that have it are on.",
)
.label("Solo")
.symbol(Symbol::Lights);

pub static POSITION: Parameter = Parameter::new(
    "light.N.position",
    "position",
    Kind::Point(access!(light: position)),
    "Where the light is, or the centre of an area light: x to the right, y up, z towards the default camera.",
)
.letter("L", Symbol::Light)
.unit("world units")
.idle(|scene, index| unless(scene, index, |light| light.kind.has_position(), "A directional light has no position"));

pub static DIRECTION: Parameter = Parameter::new(
    "light.N.direction",
    "direction",
    Kind::Direction {
        at: access!(light: direction),
        needed: |scene, index| scene.lights.get(index).is_some_and(Light::has_direction),
    },
    "The direction in which directional light travels, the axis of a spot light's cone, or the side that a rectangle faces; of any length but zero.",
)
.letter("D", Symbol::Light)
.idle(|scene, index| unless(scene, index, Light::has_direction, "This light shines equally in all directions"));

pub static COLOR: Parameter = Parameter::new(
    "light.N.color",
    "intensity",
    Kind::Colour { at: access!(light: color), limits: Limits::INTENSITY },
    "The linear intensity of the light per channel; 1 is white. An area light's is that of all its samples together.",
)
.label("intensity")
.letter("Ip", Symbol::Ip);

fn no_spot(scene: &Scene, index: usize) -> Option<&'static str> {
    unless(scene, index, |light| light.kind == LightKind::Spot, "The light is not a spot light")
}

pub static CONE: Parameter = Parameter::new(
    "light.N.cone",
    "cone",
    Kind::Number {
        at: access!(light: cone),
        limits: Limits::new(*Light::CONE.start(), *Light::CONE.end()),
        slider: Slider::linear(1.0, 90.0).decimals(1),
    },
    "The angle between a spot light's axis and the edge of its cone.",
)
.letter("δ", Symbol::Light)
.unit("degrees")
.idle(no_spot);

pub static EXPONENT: Parameter = Parameter::new(
    "light.N.exponent",
    "exponent",
    Kind::Number {
        at: access!(light: exponent),
        limits: Limits::new(0.0, Light::MAX_EXPONENT),
        slider: Slider::logarithmic(0.0, Light::MAX_EXPONENT).decimals(2),
    },
    "How fast a spot light falls off: as the e-th power of the cosine of the angle to its axis.",
)
.label("fall-off")
.letter("e", Symbol::Light)
.idle(no_spot);

pub static SOFTNESS: Parameter = Parameter::new(
    "light.N.softness",
    "softness",
    Kind::Number { at: access!(light: softness), limits: Limits::UNIT, slider: Slider::UNIT },
    "The outer fraction of a spot light's cone over which the light fades; 0 is a hard edge.",
)
.label("Softness")
.symbol(Symbol::Light)
.idle(no_spot);

fn no_area(scene: &Scene, index: usize) -> Option<&'static str> {
    unless(scene, index, |light| light.kind == LightKind::Area, "The light is not an area light")
}

pub static SHAPE: Parameter =
    Parameter::new("light.N.shape", "shape", Kind::Choice(&access!(light: shape)), "The shape of an area light.")
        .label("Shape")
        .symbol(Symbol::Light)
        .idle(no_area);

/// The slider of an area light's lengths.
const LENGTHS: Slider = Slider::linear(0.0, 4.0);

pub static EXTENT: Parameter = Parameter::new(
    "light.N.extent",
    "extent",
    Kind::Pair { at: access!(light: extent), limits: Limits::LENGTH, slider: LENGTHS },
    "Width and height of a rectangular light; its width is level.",
)
.label("Extent")
.symbol(Symbol::Light)
.unit("world units")
.idle(|scene, index| {
    no_area(scene, index).or(unless(scene, index, |light| light.shape == AreaShape::Rectangle, "The light is a sphere"))
});

pub static RADIUS: Parameter = Parameter::new(
    "light.N.radius",
    "radius",
    Kind::Number { at: access!(light: radius), limits: Limits::LENGTH, slider: LENGTHS },
    "The radius of a spherical light.",
)
.label("Radius")
.symbol(Symbol::Light)
.unit("world units")
.idle(|scene, index| {
    no_area(scene, index).or(unless(scene, index, |light| light.shape == AreaShape::Sphere, "The light is a rectangle"))
});

pub static SAMPLES: Parameter = Parameter::new(
    "light.N.samples",
    "samples",
    Kind::Whole {
        at: access!(light: samples),
        limits: |_| Limits::new(1.0, Light::MAX_SAMPLES as f64),
        slider: Slider::logarithmic(1.0, Light::MAX_SAMPLES as f64).decimals(0),
    },
    "The number of points that stand for an area light. The work grows with N; the error falls about as 1/N.",
)
.letter("N", Symbol::Light)
.idle(no_area);

pub static ATTENUATION: Parameter = Parameter::new(
    "light.N.attenuation",
    "attenuation",
    Kind::Choice(&access!(light: attenuation)),
    "How the light weakens with distance: d and r are distances to the light, or r to the viewer.",
)
.letter("f", Symbol::Attenuation);

/// Why a constant of the attenuation has no effect.
fn unused(scene: &Scene, index: usize, quadratic: bool) -> Option<&'static str> {
    let light = scene.lights.get(index)?;
    let read = match light.attenuation {
        Attenuation::Viewer | Attenuation::Light => !quadratic,
        Attenuation::Quadratic => quadratic,
        Attenuation::None | Attenuation::InverseSquare => false,
    };
    let far = light.kind == LightKind::Directional && light.attenuation != Attenuation::Viewer;
    (!read)
        .then_some("This form of attenuation does not use it")
        .or(far.then_some("A directional light is infinitely far away and is not attenuated"))
}

/// The slider of a constant of the attenuation.
const CONSTANT: Slider = Slider::linear(0.0, 2.0);

pub static K: Parameter = Parameter::new(
    "light.N.k",
    "k",
    Kind::Number { at: access!(light: k), limits: Limits::LENGTH, slider: CONSTANT },
    "The constant that keeps 1/(r + k) finite.",
)
.label("constant")
.letter("k", Symbol::Attenuation)
.unit("world units")
.idle(|scene, index| unused(scene, index, false));

pub static C1: Parameter = Parameter::new(
    "light.N.c1",
    "c1",
    Kind::Number { at: access!(light: c1), limits: Limits::LENGTH, slider: CONSTANT },
    "The constant coefficient of the quadratic attenuation. One of c1, c2, c3 is above 0.",
)
.label("constant")
.letter("c1", Symbol::Attenuation)
.idle(|scene, index| unused(scene, index, true));

pub static C2: Parameter = Parameter::new(
    "light.N.c2",
    "c2",
    Kind::Number { at: access!(light: c2), limits: Limits::LENGTH, slider: CONSTANT },
    "The linear coefficient of the quadratic attenuation.",
)
.label("linear")
.letter("c2", Symbol::Attenuation)
.unit("per world unit")
.idle(|scene, index| unused(scene, index, true));

pub static C3: Parameter = Parameter::new(
    "light.N.c3",
    "c3",
    Kind::Number { at: access!(light: c3), limits: Limits::LENGTH, slider: CONSTANT },
    "The quadratic coefficient of the quadratic attenuation.",
)
.label("quadratic")
.letter("c3", Symbol::Attenuation)
.unit("per world unit squared")
.idle(|scene, index| unused(scene, index, true));

/// Whether the attenuation follows the eye although V is taken as constant.
pub fn viewer_far(scene: &Scene, index: usize) -> bool {
    let camera = &scene.camera;
    let constant = camera.viewer == Viewer::Infinite || camera.projection == Projection::Orthographic;
    constant && scene.lights.get(index).is_some_and(|light| light.attenuation == Attenuation::Viewer)
}
