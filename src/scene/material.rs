//! The coefficients of the equation, its model of reflection, the pattern and the transparency.

use super::Rgb;
use super::choice::choices;
use super::parameter::{Limits, Reason, Slider, Unit, table};
use super::symbol::Symbol;
use std::ops::RangeInclusive;

pub(super) const COEFFICIENT: Limits = Limits::new(0.0, Material::MAX_COEFFICIENT);
const EXPONENTS: Slider = Slider::logarithmic(1.0, 1000.0).decimals(2);
const SLOPES: Slider =
    Slider::logarithmic(*Material::ROUGHNESS.start(), *Material::ROUGHNESS.end());
const INDEX: Slider = Slider::linear(0.0, 5.0);

/// Makes the reason of a quantity that the scene's own law does not use.
macro_rules! unused {
    ($($quantity:literal),+) => {
        (
            |scene, _| scene.reflection.law_leaves_out(&[$($quantity),+]),
            "idle-not-in-formula",
        )
    };
}
pub(super) use unused;

table! {
    /// The reflecting material: the coefficients of the illumination equation.
    pub struct Material = [material] in material {
        /// Ambient coefficient Ka, 0 to 10⁶ per channel.
        KA ka: Rgb = Rgb::splat(0.1), Coefficient(COEFFICIENT, Slider::UNIT)
            .letter("Ka", Symbol::Ka).idle_if(&[AMBIENT_ALONE]);
        /// Diffuse coefficient Kd, 0 to 10⁶ per channel.
        KD kd: Rgb = Rgb::splat(0.7), Coefficient(COEFFICIENT, Slider::UNIT)
            .letter("Kd", Symbol::Kd).idle_if(&[NO_LIGHT, unused!("kd")]);
        /// Specular coefficient Ks, 0 to 10⁶ per channel.
        KS ks: Rgb = Rgb::splat(0.4), Coefficient(COEFFICIENT, Slider::UNIT)
            .letter("Ks", Symbol::Ks).idle_if(&[NO_LIGHT, unused!("ks")]);
        /// Specular exponent n of Phong and Blinn, 0 or more.
        N n: f64 = 32.0, Number(Limits::new(0.0, f64::INFINITY), EXPONENTS)
            .letter("n", Symbol::Exponent).idle_if(&[NO_LIGHT, NO_HIGHLIGHT, NO_EXPONENT, unused!("n")]);
        /// Colour Od of the surface, linear: it tints ambient and diffuse light.
        COLOR color: Rgb = Rgb::new(0.9, 0.3, 0.2), Colour(COEFFICIENT).letter("Od", Symbol::Od).idle_if(&[COLOURLESS, NO_COLOUR]);
        /// Colour Os of the highlight, linear.
        SPECULAR_COLOR specular_color: Rgb = Rgb::ONE, Colour(COEFFICIENT)
            .letter("Os", Symbol::Os).idle_if(&[NO_LIGHT, NO_HIGHLIGHT, unused!("os")]);
        /// Root mean square slope m of the microfacets, 0.001 to 1. Cook–Torrance, or a formula with m.
        ROUGHNESS roughness: f64 = 0.25, Number(Limits::within(&Material::ROUGHNESS), SLOPES)
            .letter("m", Symbol::Facets).idle_if(&[NO_LIGHT, NO_HIGHLIGHT, NO_ROUGHNESS, unused!("m")]);
        /// The source of W(θ).
        REFLECTANCE reflectance: Reflectance = Reflectance::Constant, Choice
            .letter("W", Symbol::Reflectance).idle_if(&[NO_LIGHT, OWN_LAW, NO_HIGHLIGHT]);
        /// Index of refraction η, 0.01 to 100 per channel. `reflectance = "custom"`, or a formula with eta.
        IOR ior: Rgb = Rgb::splat(1.5), Channels(Limits::within(&Material::IOR), INDEX)
            .letter("η", Symbol::Reflectance).idle_if(&[NO_LIGHT, NO_HIGHLIGHT, NO_INDEX, unused!("eta")]);
        /// Extinction coefficient k, 0 to 100 per channel. `reflectance = "custom"` only.
        EXTINCTION extinction: Rgb = Rgb::ZERO, Channels(Limits::new(0.0, *Material::IOR.end()), INDEX)
            .letter("k", Symbol::Reflectance).idle_if(&[NO_LIGHT, OWN_LAW, NO_HIGHLIGHT, NO_INDEX]);
        /// The material of a model's faces: their own from its MTL file, or this one.
        SOURCE source: MaterialSource = MaterialSource::Model, Choice.idle_if(&[NO_MODEL]);
    }
}

impl Material {
    /// The largest reflection coefficient. Above 1 a surface emits more than it receives, which is not physical but shows
    /// what overflows; the bound keeps every product far from the end of single precision.
    pub const MAX_COEFFICIENT: f64 = 1e6;

    /// The range of the roughness. Below it the highlight is narrower than single precision distinguishes directions; above
    /// it most slopes exceed 45°.
    pub const ROUGHNESS: RangeInclusive<f64> = 1e-3..=1.0;

    /// The range of indices of refraction: no known material lies outside.
    pub const IOR: RangeInclusive<f64> = 0.01..=100.0;

    /// Returns the roughness whose highlight is as narrow as that of the exponent `n`: m = √(2/(n + 2)).
    pub(crate) fn roughness_of(n: f64) -> f64 {
        let m = (2.0 / (n + 2.0)).sqrt();
        m.clamp(*Self::ROUGHNESS.start(), *Self::ROUGHNESS.end())
    }
}

choices! {
    /// The material of a model's faces.
    pub enum MaterialSource = "material-source" {
        /// Each face has the material that the model gives it; the scene's, where it gives none.
        Model = "model";
        /// Every face has the scene's material.
        Scene = "scene";
    }
}

const NO_MODEL: Reason = (
    |scene, _| !scene.object.kind.has_materials(),
    "idle-no-model",
);

// The reasons why no effect of a light, the ambient term, the specular term and the surface's own colour are not visible.
pub(super) const NO_LIGHT: Reason = (|scene, _| scene.lights.is_empty(), "idle-no-light");
pub(super) const NO_AMBIENT: Reason = (
    |scene, _| scene.ambient.color == Rgb::ZERO,
    "idle-no-ambient",
);
/// Ka has no effect without ambient light, but in a formula.
const AMBIENT_ALONE: Reason = (
    |scene, _| scene.ambient.color == Rgb::ZERO && !scene.reflection.law_uses(&["ka"]),
    "idle-no-ambient",
);
const NO_HIGHLIGHT: Reason = (
    |scene, _| scene.material.ks == Rgb::ZERO && !scene.reflection.is_own_law(),
    "idle-no-highlight",
);
const COLOURLESS: Reason = (
    |scene, _| {
        let material = &scene.material;
        material.ka == Rgb::ZERO && material.kd == Rgb::ZERO && !scene.reflection.is_own_law()
    },
    "idle-colourless",
);
/// Neither the ambient term nor the formula has Od.
const NO_COLOUR: Reason = (
    |scene, _| scene.material.ka == Rgb::ZERO && scene.reflection.law_leaves_out(&["od"]),
    "idle-not-in-formula",
);

/// The formula takes the place of both terms, W(θ) and the policy for the back side included.
const OWN_LAW: Reason = (|scene, _| scene.reflection.is_own_law(), "idle-own-law");

const NO_EXPONENT: Reason = (
    |scene, _| scene.reflection.model == ReflectionModel::CookTorrance,
    "idle-roughness-instead",
);
const NO_FORMULA: Reason = (|scene, _| !scene.reflection.is_own_law(), "idle-no-formula");
const NO_ROUGHNESS: Reason = (
    |scene, index| (NO_FACETS.0)(scene, index) && !scene.reflection.is_own_law(),
    NO_FACETS.1,
);
const NO_FACETS: Reason = (
    |scene, _| scene.reflection.model != ReflectionModel::CookTorrance,
    "idle-no-microfacets",
);
const NO_INDEX: Reason = (
    |scene, _| scene.material.reflectance != Reflectance::Custom && !scene.reflection.is_own_law(),
    "idle-index-not-custom",
);

choices! {
    /// W(θ): the part of the light that is reflected at the angle of incidence θ.
    pub enum Reflectance = "reflectance" {
        /// W = 1 at every angle, as in Phong's model.
        Constant = "constant";
        /// Fresnel's formulas with the index of crown glass, N-BK7.
        Glass = "glass";
        /// Fresnel's formulas with the index of silver (Johnson and Christy 1972).
        Silver = "silver";
        /// Fresnel's formulas with the index of gold (Johnson and Christy 1972).
        Gold = "gold";
        /// Fresnel's formulas with [`Material::ior`] and [`Material::extinction`].
        Custom = "custom";
    }
}

table! {
    /// The specular term, and the policy for the side away from a light.
    pub struct Reflection = [reflection] in reflection {
        /// The specular term.
        MODEL model: ReflectionModel = ReflectionModel::Phong, Choice.symbol(Symbol::Reflected).idle_if(&[NO_LIGHT]);
        /// The law as a formula: the factor of one light's part, for each channel. `model = "formula"` only.
        FORMULA formula: String = Reflection::PHONG.to_owned(), Lines(Reflection::MOST_CHARACTERS)
            .symbol(Symbol::Reflected).idle_if(&[NO_LIGHT, NO_FORMULA]);
        /// Distribution D of the microfacets. Cook–Torrance only.
        DISTRIBUTION distribution: Distribution = Distribution::Beckmann, Choice
            .letter("D", Symbol::Masking).idle_if(&[NO_LIGHT, OWN_LAW, NO_HIGHLIGHT, NO_FACETS]);
        /// The policy for a light behind the surface.
        BACKFACING backfacing: Backfacing = Backfacing::Clamp, Choice.symbol(Symbol::Normal).idle_if(&[NO_LIGHT, OWN_LAW]);
    }
}

choices! {
    /// The specular term.
    pub enum ReflectionModel = "reflection-model" {
        /// `(R·V)^n` (Phong 1975).
        Phong = "phong";
        /// `(N·H)^n` (Blinn 1977).
        Blinn = "blinn";
        /// `π·D·G/(4·(N·V))` of microfacets (Cook and Torrance 1982).
        CookTorrance = "cook-torrance";
        /// The law that [`Reflection::formula`] writes down, in place of the diffuse and the specular term.
        Formula = "formula";
    }
}

choices! {
    /// The distribution of the microfacets' slopes.
    pub enum Distribution = "distribution" {
        /// Normally distributed slopes (Beckmann and Spizzichino 1963), with the V-cavities of Torrance and Sparrow 1967.
        Beckmann = "beckmann";
        /// The longer tail of Walter et al. 2007, with their shadowing.
        Ggx = "ggx";
    }
}

choices! {
    /// The policy where N·L < 0.
    pub enum Backfacing = "backfacing" {
        /// The light adds nothing.
        Clamp = "clamp";
        /// N is turned towards the light: a two-sided surface.
        Flip = "flip";
    }
}

table! {
    /// The light that arrives from all sides.
    pub struct Ambient = [ambient] in ambient {
        /// Ia, linear, 0 to 10³⁰.
        AMBIENT_COLOR color: Rgb = Rgb::ONE, Colour(Limits::INTENSITY).letter("Ia", Symbol::Ia)
            .idle_if(&[NOTHING_REFLECTED]);
        /// The source of Ia: constant, or gathered from other surfaces.
        AMBIENT_SOURCE source: AmbientSource = AmbientSource::Constant, Choice.letter("Ia", Symbol::Bounce).idle_if(&[NO_BOUNCE]);
    }
}

const NOTHING_REFLECTED: Reason = (
    |scene, _| scene.material.ka == Rgb::ZERO,
    "idle-no-ambient-reflected",
);
const NO_BOUNCE: Reason = (
    |scene, _| scene.ambient.source == AmbientSource::Constant && scene.lights.is_empty(),
    "idle-no-bounce",
);

impl Ambient {
    /// Returns Ia as the equation uses it: zero where light from other surfaces replaces it in the whole picture.
    pub fn constant(&self) -> Rgb {
        if self.source == AmbientSource::Bounce {
            Rgb::ZERO
        } else {
            self.color
        }
    }
}

choices! {
    /// The model of the light that arrives from all sides.
    pub enum AmbientSource = "ambient-source" {
        /// A constant Ia everywhere.
        Constant = "constant";
        /// Light that other surfaces of the scene have scattered once.
        Bounce = "bounce";
        /// Constant in the left half of the picture, one bounce in the right half.
        Split = "split";
    }
}

table! {
    /// A second colour of the surface, laid out by object coordinates, so that no picture file is needed.
    pub struct Pattern = [pattern] in pattern {
        /// The kind of pattern.
        PATTERN_KIND kind: PatternKind = PatternKind::None, Choice.symbol(Symbol::Od).idle_if(&[COLOURLESS, NO_COLOUR]);
        /// The pattern's colour, linear. The material's colour is visible between.
        PATTERN_COLOR color: Rgb = Rgb::new(0.95, 0.92, 0.85), Colour(COEFFICIENT)
            .letter("Od", Symbol::Od).idle_if(&[COLOURLESS, NO_COLOUR, NO_PATTERN]);
        /// Width of a field, world units, 10⁻⁴ to 10⁴.
        PATTERN_SCALE scale: f64 = 0.25, Number(FIELD, FIELD_SLIDER)
            .measured_in(Unit::World).symbol(Symbol::Od).idle_if(&[COLOURLESS, NO_COLOUR, NO_PATTERN]);
    }
}

/// The limits of the widths of a pattern's fields.
pub(super) const FIELD: Limits = Limits::within(&Pattern::SCALE);
pub(super) const FIELD_SLIDER: Slider = Slider::logarithmic(0.01, 4.0);

impl Pattern {
    /// The range of the width of a field, world units. Narrower fields are not distinguished in single precision.
    pub const SCALE: RangeInclusive<f64> = 1e-4..=1e4;
}

const NO_PATTERN: Reason = (
    |scene, _| scene.pattern.kind == PatternKind::None,
    "idle-no-pattern",
);

choices! {
    /// The patterns. Fields are counted from the origin, the first of them centred there.
    pub enum PatternKind = "pattern" {
        /// No pattern.
        None = "none";
        /// Cubes of alternating colour.
        Checker = "checker";
        /// Horizontal layers.
        Stripes = "stripes";
        /// Concentric shells round the axis.
        Rings = "rings";
    }
}

table! {
    /// Light that passes through the surface.
    pub struct Transparency = [transparency] in transparency {
        /// Transparency Kt: the part of the light from behind that passes, 0 to 1.
        KT kt: f64 = 0.0, Number(Limits::UNIT, Slider::UNIT).letter("Kt", Symbol::Kt);
        /// Index of refraction η of the inside relative to the outside, 0.1 to 10.
        TRANSPARENCY_IOR ior: f64 = 1.5, Number(Limits::within(&Transparency::IOR), Slider::linear(0.5, 3.0))
            .letter("η", Symbol::Transmitted).idle_if(&[OPAQUE]);
        /// The number of refractions: on entry only, or also on exit.
        THROUGH through: Through = Through::Solid, Choice.symbol(Symbol::Transmitted).idle_if(&[OPAQUE]);
    }
}

impl Transparency {
    /// The range of indices of refraction, either way through the surface.
    pub const IOR: RangeInclusive<f64> = 0.1..=10.0;
}

const OPAQUE: Reason = (|scene, _| scene.transparency.kt == 0.0, "idle-opaque");

choices! {
    /// The extent to which a transmitted ray is followed.
    pub enum Through = "through" {
        /// Refraction once: everything behind the surface is inside the material.
        Surface = "surface";
        /// Refraction on entry and exit, with total reflection inside.
        Solid = "solid";
    }
}
