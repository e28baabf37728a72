//! The coefficients of the equation, its model of reflection, the pattern and the transparency.

use super::super::{
    AmbientSource, Material, Pattern, PatternKind, Reflectance, ReflectionModel, Rgb, Scene, Transparency,
};
use super::access::access;
use super::{Kind, Limits, Parameter, Slider, Symbol};

pub(super) const ALL: &[&Parameter] = &[
    &KA,
    &KD,
    &KS,
    &N,
    &COLOR,
    &SPECULAR_COLOR,
    &ROUGHNESS,
    &REFLECTANCE,
    &IOR,
    &EXTINCTION,
    &MODEL,
    &DISTRIBUTION,
    &BACKFACING,
    &AMBIENT_COLOR,
    &AMBIENT_SOURCE,
    &PATTERN_KIND,
    &PATTERN_COLOR,
    &PATTERN_SCALE,
    &KT,
    &TRANSPARENCY_IOR,
    &THROUGH,
];

const COEFFICIENT: Limits = Limits::new(0.0, Material::MAX_COEFFICIENT);

/// Why nothing that a light does can be seen.
pub fn no_light(scene: &Scene) -> Option<&'static str> {
    scene.lights.is_empty().then_some("There is no light")
}

/// Why the specular term is not seen.
pub fn no_highlight(scene: &Scene, _: usize) -> Option<&'static str> {
    no_light(scene).or((scene.material.ks == Rgb::ZERO).then_some("Ks is 0: there is no highlight"))
}

/// Why the surface's own colour is not seen.
fn colourless(scene: &Scene, _: usize) -> Option<&'static str> {
    (scene.material.ka == Rgb::ZERO && scene.material.kd == Rgb::ZERO)
        .then_some("Ka and Kd are 0: the surface's own colour is not seen")
}

pub static KA: Parameter = Parameter::new(
    "material.ka",
    "ambient coefficient",
    Kind::Coefficient { at: access!(material.ka), limits: COEFFICIENT, slider: Slider::UNIT },
    "How much of the ambient light the surface reflects.",
)
.label("ambient")
.letter("Ka", Symbol::Ka)
.idle(|scene, _| (scene.ambient.color == Rgb::ZERO).then_some("Ia is black: there is no ambient light"));

pub static KD: Parameter = Parameter::new(
    "material.kd",
    "diffuse coefficient",
    Kind::Coefficient { at: access!(material.kd), limits: COEFFICIENT, slider: Slider::UNIT },
    "How much light the surface scatters equally in all directions (Lambert's law).",
)
.label("diffuse")
.letter("Kd", Symbol::Kd)
.idle(|scene, _| no_light(scene));

pub static KS: Parameter = Parameter::new(
    "material.ks",
    "specular coefficient",
    Kind::Coefficient { at: access!(material.ks), limits: COEFFICIENT, slider: Slider::UNIT },
    "How much light the surface reflects about the mirror direction.",
)
.label("specular")
.letter("Ks", Symbol::Ks)
.idle(|scene, _| no_light(scene));

pub static N: Parameter = Parameter::new(
    "material.n",
    "specular exponent",
    Kind::Number {
        at: access!(material.n),
        limits: Limits::new(0.0, f64::INFINITY),
        slider: Slider::logarithmic(0.1, 1e6).decimals(2),
    },
    "The larger n, the smaller and sharper the highlight; infinity is a mirror.",
)
.label("exponent")
.letter("n", Symbol::Exponent)
.idle(|scene, index| {
    no_highlight(scene, index).or((scene.reflection.model == ReflectionModel::CookTorrance)
        .then_some("The Cook–Torrance model has a roughness instead of an exponent"))
});

pub static COLOR: Parameter = Parameter::new(
    "material.color",
    "surface colour",
    Kind::Colour { at: access!(material.color), limits: COEFFICIENT },
    "The surface's own colour, linear. It multiplies Ka and Kd.",
)
.label("colour")
.letter("Od", Symbol::Od)
.idle(colourless);

pub static SPECULAR_COLOR: Parameter = Parameter::new(
    "material.specular_color",
    "highlight colour",
    Kind::Colour { at: access!(material.specular_color), limits: COEFFICIENT },
    "The colour of the highlight, linear. It multiplies Ks; white leaves the highlight the light's colour, as on plastic.",
)
.label("highlight")
.letter("Os", Symbol::Os)
.idle(no_highlight);

pub static ROUGHNESS: Parameter = Parameter::new(
    "material.roughness",
    "roughness",
    Kind::Number {
        at: access!(material.roughness),
        limits: Limits::new(*Material::ROUGHNESS.start(), *Material::ROUGHNESS.end()),
        slider: Slider::logarithmic(*Material::ROUGHNESS.start(), *Material::ROUGHNESS.end()),
    },
    "The root mean square slope of the microfacets (Beckmann), or their width α (GGX): the smaller, the smoother.",
)
.letter("m", Symbol::Facets)
.idle(|scene, index| no_highlight(scene, index).or(no_facets(scene)));

fn no_facets(scene: &Scene) -> Option<&'static str> {
    (scene.reflection.model != ReflectionModel::CookTorrance).then_some("Only the Cook–Torrance model has microfacets")
}

pub static REFLECTANCE: Parameter = Parameter::new(
    "material.reflectance",
    "reflectance by angle",
    Kind::Choice(&access!(material.reflectance)),
    "W(θ), the fraction of light reflected at the angle of incidence θ. It multiplies Ks.",
)
.label("by angle")
.letter("W", Symbol::Reflectance)
.idle(no_highlight);

fn no_index(scene: &Scene, index: usize) -> Option<&'static str> {
    no_highlight(scene, index).or((scene.material.reflectance != Reflectance::Custom)
        .then_some("W(θ) is not that of an index of refraction of your own"))
}

const INDEX: Slider = Slider::linear(0.0, 5.0);

pub static IOR: Parameter = Parameter::new(
    "material.ior",
    "index of refraction",
    Kind::Channels {
        at: access!(material.ior),
        limits: Limits::new(*Material::IOR.start(), *Material::IOR.end()),
        slider: INDEX,
    },
    "The real part of the material's index of refraction for red, green and blue.",
)
.label("index")
.letter("η", Symbol::Reflectance)
.idle(no_index);

pub static EXTINCTION: Parameter = Parameter::new(
    "material.extinction",
    "extinction",
    Kind::Channels { at: access!(material.extinction), limits: Limits::new(0.0, *Material::IOR.end()), slider: INDEX },
    "The imaginary part of the index for red, green and blue: 0 for clear materials, 2 to 5 for metals.",
)
.letter("k", Symbol::Reflectance)
.idle(no_index);

pub static MODEL: Parameter = Parameter::new(
    "reflection.model",
    "Reflection model",
    Kind::Choice(&access!(reflection.model)),
    "Which angle the specular term depends on: R against V (Phong 1975), N against H (Blinn 1977), or how many microfacets mirror the light (Cook and Torrance 1982).",
)
.label("Highlight")
.symbol(Symbol::Reflected)
.idle(no_highlight);

pub static DISTRIBUTION: Parameter = Parameter::new(
    "reflection.distribution",
    "microfacet distribution",
    Kind::Choice(&access!(reflection.distribution)),
    "How the slopes of the microfacets are distributed, and how much they hide each other.",
)
.label("facets")
.letter("D", Symbol::Masking)
.idle(|scene, index| no_highlight(scene, index).or(no_facets(scene)));

pub static BACKFACING: Parameter = Parameter::new(
    "reflection.backfacing",
    "Back side",
    Kind::Choice(&access!(reflection.backfacing)),
    "What a light contributes where it is behind the surface, N·L < 0.",
)
.symbol(Symbol::Normal)
.idle(|scene, _| no_light(scene));

pub static AMBIENT_COLOR: Parameter = Parameter::new(
    "ambient.color",
    "ambient light",
    Kind::Colour { at: access!(ambient.color), limits: Limits::INTENSITY },
    "The linear intensity of the light that comes equally from all directions.",
)
.label("ambient")
.letter("Ia", Symbol::Ia)
.idle(|scene, _| (scene.material.ka == Rgb::ZERO).then_some("Ka is 0: the surface reflects no ambient light"));

pub static AMBIENT_SOURCE: Parameter = Parameter::new(
    "ambient.source",
    "ambient source",
    Kind::Choice(&access!(ambient.source)),
    "What the ambient light is: a constant, or light that other surfaces of the scene have scattered once.",
)
.label("source")
.letter("Ia", Symbol::Bounce)
.idle(|scene, _| {
    (scene.ambient.source == AmbientSource::Constant && scene.lights.is_empty())
        .then_some("There is no light that could be scattered")
});

pub static PATTERN_KIND: Parameter = Parameter::new(
    "pattern.kind",
    "Pattern",
    Kind::Choice(&access!(pattern.kind)),
    "A second colour of the surface, laid out in space.",
)
.symbol(Symbol::Od)
.idle(colourless);

fn no_pattern(scene: &Scene, index: usize) -> Option<&'static str> {
    colourless(scene, index).or((scene.pattern.kind == PatternKind::None).then_some("There is no pattern"))
}

pub static PATTERN_COLOR: Parameter = Parameter::new(
    "pattern.color",
    "Pattern colour",
    Kind::Colour { at: access!(pattern.color), limits: COEFFICIENT },
    "The surface colour in every other field of the pattern, linear.",
)
.label("in pattern")
.letter("Od", Symbol::Od)
.idle(no_pattern);

pub static PATTERN_SCALE: Parameter = Parameter::new(
    "pattern.scale",
    "Pattern scale",
    Kind::Number { at: access!(pattern.scale), limits: FIELD, slider: Slider::logarithmic(0.01, 4.0) },
    "The width of one field of the pattern.",
)
.label("Field width")
.unit("world units")
.symbol(Symbol::Od)
.idle(no_pattern);

/// Widths of a pattern's fields.
pub(super) const FIELD: Limits = Limits::new(*Pattern::SCALE.start(), *Pattern::SCALE.end());

pub static KT: Parameter = Parameter::new(
    "transparency.kt",
    "transparency",
    Kind::Number { at: access!(transparency.kt), limits: Limits::UNIT, slider: Slider::UNIT },
    "The fraction of the light that comes through the surface from behind: I = (1 − Kt)·Irefl + Kt·Itrans.",
)
.letter("Kt", Symbol::Kt);

fn opaque(scene: &Scene, _: usize) -> Option<&'static str> {
    (scene.transparency.kt == 0.0).then_some("Kt is 0: nothing is seen through the surface")
}

pub static TRANSPARENCY_IOR: Parameter = Parameter::new(
    "transparency.ior",
    "relative index",
    Kind::Number {
        at: access!(transparency.ior),
        limits: Limits::new(*Transparency::IOR.start(), *Transparency::IOR.end()),
        slider: Slider::linear(0.5, 3.0),
    },
    "The index of refraction inside relative to that outside: by Snell's law sin θ = η·sin θt; 1 bends nothing.",
)
.label("index")
.letter("η", Symbol::Transmitted)
.idle(opaque);

pub static THROUGH: Parameter = Parameter::new(
    "transparency.through",
    "Refraction",
    Kind::Choice(&access!(transparency.through)),
    "How far the transmitted ray is followed.",
)
.symbol(Symbol::Transmitted)
.idle(opaque);
