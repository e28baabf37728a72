//! The coefficients of the equation, its model of reflection, the pattern and the transparency.

use super::choice::choices;
use super::parameter::{Limits, Slider, table};
use super::symbol::Symbol;
use super::{Rgb, Scene};
use std::ops::RangeInclusive;

pub(super) const COEFFICIENT: Limits = Limits::new(0.0, Material::MAX_COEFFICIENT);
const EXPONENTS: Slider = Slider::logarithmic(0.1, 1e6).decimals(2);
const SLOPES: Slider =
    Slider::logarithmic(*Material::ROUGHNESS.start(), *Material::ROUGHNESS.end());
const INDEX: Slider = Slider::linear(0.0, 5.0);

table! {
    /// The reflecting material: the coefficients of the illumination equation.
    pub struct Material = "material" in material {
        KA ka: Rgb = Rgb::splat(0.1), Coefficient(COEFFICIENT, Slider::UNIT), "ambient coefficient",
            "How much of the ambient light the surface reflects."
            .label("ambient").letter("Ka", Symbol::Ka).idle(|scene, _| no_ambient(scene));
        KD kd: Rgb = Rgb::splat(0.7), Coefficient(COEFFICIENT, Slider::UNIT), "diffuse coefficient",
            "How much light the surface scatters equally in all directions (Lambert's law)."
            .label("diffuse").letter("Kd", Symbol::Kd).idle(no_light);
        KS ks: Rgb = Rgb::splat(0.4), Coefficient(COEFFICIENT, Slider::UNIT), "specular coefficient",
            "How much light the surface reflects about the mirror direction."
            .label("specular").letter("Ks", Symbol::Ks).idle(no_light);
        N n: f64 = 32.0, Number(Limits::new(0.0, f64::INFINITY), EXPONENTS), "specular exponent",
            "The larger n, the smaller and sharper the highlight; infinity is a mirror."
            .label("exponent").letter("n", Symbol::Exponent).idle(no_exponent);
        COLOR color: Rgb = Rgb::new(0.9, 0.3, 0.2), Colour(COEFFICIENT), "surface colour",
            "The surface's own colour, linear. It multiplies Ka and Kd."
            .label("colour").letter("Od", Symbol::Od).idle(colourless);
        SPECULAR_COLOR specular_color: Rgb = Rgb::ONE, Colour(COEFFICIENT), "highlight colour",
            "The colour of the highlight, linear. It multiplies Ks; white leaves the highlight the light's colour, as on plastic."
            .label("highlight").letter("Os", Symbol::Os).idle(no_highlight);
        /// Cook–Torrance only.
        ROUGHNESS roughness: f64 = 0.25, Number(Limits::within(&Material::ROUGHNESS), SLOPES), "roughness",
            "The root mean square slope of the microfacets (Beckmann), or their width α (GGX): the smaller, the smoother."
            .letter("m", Symbol::Facets).idle(no_facets);
        REFLECTANCE reflectance: Reflectance = Reflectance::Constant, Choice, "reflectance by angle",
            "W(θ), the fraction of light reflected at the angle of incidence θ. It multiplies Ks."
            .label("by angle").letter("W", Symbol::Reflectance).idle(no_highlight);
        /// `reflectance = "custom"` only.
        IOR ior: Rgb = Rgb::splat(1.5), Channels(Limits::within(&Material::IOR), INDEX), "index of refraction",
            "The real part of the material's index of refraction for red, green and blue."
            .label("index").letter("η", Symbol::Reflectance).idle(no_index);
        /// `reflectance = "custom"` only.
        EXTINCTION extinction: Rgb = Rgb::ZERO, Channels(Limits::new(0.0, *Material::IOR.end()), INDEX), "extinction",
            "The imaginary part of the index for red, green and blue: 0 for clear materials, 2 to 5 for metals."
            .letter("k", Symbol::Reflectance).idle(no_index);
    }
}

impl Material {
    /// Greatest reflection coefficient. Above 1 a surface sends out more than it receives, which is no physics but
    /// shows what overflows; the bound keeps every product far from the end of single precision.
    pub const MAX_COEFFICIENT: f64 = 1e6;

    /// Below, the highlight is narrower than single precision tells directions apart; above, slopes pass 45° mostly.
    pub const ROUGHNESS: RangeInclusive<f64> = 1e-3..=1.0;

    /// Indices of refraction: no material known lies outside.
    pub const IOR: RangeInclusive<f64> = 0.01..=100.0;
}

/// Why nothing that a light does can be seen.
pub(super) fn no_light(scene: &Scene, _: usize) -> Option<&'static str> {
    scene.lights.is_empty().then_some("There is no light")
}

/// Why the ambient term is not seen.
pub(super) fn no_ambient(scene: &Scene) -> Option<&'static str> {
    (scene.ambient.color == Rgb::ZERO).then_some("Ia is black: there is no ambient light")
}

/// Why the specular term is not seen.
pub fn no_highlight(scene: &Scene, index: usize) -> Option<&'static str> {
    no_light(scene, index)
        .or((scene.material.ks == Rgb::ZERO).then_some("Ks is 0: there is no highlight"))
}

fn no_exponent(scene: &Scene, index: usize) -> Option<&'static str> {
    no_highlight(scene, index).or((scene.reflection.model == ReflectionModel::CookTorrance)
        .then_some("The Cook–Torrance model has a roughness instead of an exponent"))
}

fn no_facets(scene: &Scene, index: usize) -> Option<&'static str> {
    no_highlight(scene, index).or((scene.reflection.model != ReflectionModel::CookTorrance)
        .then_some("Only the Cook–Torrance model has microfacets"))
}

fn no_index(scene: &Scene, index: usize) -> Option<&'static str> {
    no_highlight(scene, index).or((scene.material.reflectance != Reflectance::Custom)
        .then_some("W(θ) is not that of an index of refraction of your own"))
}

/// Why the surface's own colour is not seen.
fn colourless(scene: &Scene, _: usize) -> Option<&'static str> {
    (scene.material.ka == Rgb::ZERO && scene.material.kd == Rgb::ZERO)
        .then_some("Ka and Kd are 0: the surface's own colour is not seen")
}

choices! {
    /// W(θ): the part of the light that is reflected at the angle of incidence θ.
    pub enum Reflectance {
        Constant = "constant", "constant", "1 at every angle, as in Phong's model";
        Glass = "glass", "glass", "Crown glass N-BK7, by Fresnel's formulas";
        Silver = "silver", "silver", "By the index of Johnson and Christy 1972";
        Gold = "gold", "gold", "By the index of Johnson and Christy 1972";
        Custom = "custom", "custom η and k", "A complex index of refraction of your own";
    }
}

table! {
    /// The specular term, and what happens on the side away from a light.
    pub struct Reflection = "reflection" in reflection {
        MODEL model: ReflectionModel = ReflectionModel::Phong, Choice, "Reflection model",
            "Which angle the specular term depends on: R against V (Phong 1975), N against H (Blinn 1977), or how many microfacets mirror the light (Cook and Torrance 1982)."
            .label("Highlight").symbol(Symbol::Reflected).idle(no_highlight);
        /// Cook–Torrance only.
        DISTRIBUTION distribution: Distribution = Distribution::Beckmann, Choice, "microfacet distribution",
            "How the slopes of the microfacets are distributed, and how much they hide each other."
            .label("facets").letter("D", Symbol::Masking).idle(no_facets);
        BACKFACING backfacing: Backfacing = Backfacing::Clamp, Choice, "Back side",
            "What a light contributes where it is behind the surface, N·L < 0.".symbol(Symbol::Normal).idle(no_light);
    }
}

choices! {
    /// The specular term.
    pub enum ReflectionModel {
        /// `(R·V)^n` (Phong 1975).
        Phong = "phong", "Phong  (R·V)^n", "R is L reflected about N";
        /// `(N·H)^n` (Blinn 1977).
        Blinn = "blinn", "Blinn  (N·H)^n", "H is half-way between L and V";
        /// `π·D·G/(4·(N·V))` of microfacets (Cook and Torrance 1982).
        CookTorrance = "cook-torrance", "Cook–Torrance  D·G", "Microfacets: D is the fraction that mirrors the light, G the fraction of those that is lit and seen";
    }
}

choices! {
    /// How the slopes of microfacets are spread.
    pub enum Distribution {
        /// Normally distributed slopes (Beckmann and Spizzichino 1963), with the V-cavities of Torrance and Sparrow 1967.
        Beckmann = "beckmann", "Beckmann", "Normally distributed slopes, with V-shaped cavities";
        /// The longer tail of Walter et al. 2007, with their shadowing.
        Ggx = "ggx", "GGX", "A longer tail about the highlight (Walter et al. 2007), with Smith's G";
    }
}

choices! {
    /// What happens where N·L < 0.
    pub enum Backfacing {
        Clamp = "clamp", "clamp to 0", "The light contributes nothing";
        Flip = "flip", "flip N", "The normal is turned towards the light: a two-sided surface";
    }
}

table! {
    /// The light that arrives from all sides.
    pub struct Ambient = "ambient" in ambient {
        AMBIENT_COLOR color: Rgb = Rgb::ONE, Colour(Limits::INTENSITY), "ambient light",
            "The linear intensity of the light that comes equally from all directions."
            .label("ambient").letter("Ia", Symbol::Ia)
            .idle(|scene, _| (scene.material.ka == Rgb::ZERO).then_some("Ka is 0: the surface reflects no ambient light"));
        AMBIENT_SOURCE source: AmbientSource = AmbientSource::Constant, Choice, "ambient source",
            "What the ambient light is: a constant, or light that other surfaces of the scene have scattered once."
            .label("source").letter("Ia", Symbol::Bounce).idle(no_bounce);
    }
}

fn no_bounce(scene: &Scene, _: usize) -> Option<&'static str> {
    (scene.ambient.source == AmbientSource::Constant && scene.lights.is_empty())
        .then_some("There is no light that could be scattered")
}

impl Ambient {
    /// Ia as the equation has it: nothing where light from other surfaces takes its place in the whole picture.
    pub fn constant(&self) -> Rgb {
        if self.source == AmbientSource::Bounce {
            Rgb::ZERO
        } else {
            self.color
        }
    }
}

choices! {
    /// What stands for the light that arrives from all sides.
    pub enum AmbientSource {
        Constant = "constant", "constant", "Ia everywhere";
        Bounce = "bounce", "one bounce", "Light that other surfaces of the scene have scattered once";
        Split = "split", "compare halves", "The constant in the left half of the picture, one bounce in the right half";
    }
}

table! {
    /// A second colour of the surface, laid out by object coordinates, so that no picture file is needed.
    pub struct Pattern = "pattern" in pattern {
        PATTERN_KIND kind: PatternKind = PatternKind::None, Choice, "Pattern",
            "A second colour of the surface, laid out in space.".symbol(Symbol::Od).idle(colourless);
        /// The material's colour is seen between.
        PATTERN_COLOR color: Rgb = Rgb::new(0.95, 0.92, 0.85), Colour(COEFFICIENT), "Pattern colour",
            "The surface colour in every other field of the pattern, linear."
            .label("in pattern").letter("Od", Symbol::Od).idle(no_pattern);
        PATTERN_SCALE scale: f64 = 0.25, Number(FIELD, FIELD_SLIDER), "Pattern scale",
            "The width of one field of the pattern."
            .label("Field width").unit("world units").symbol(Symbol::Od).idle(no_pattern);
    }
}

/// Widths of a pattern's fields.
pub(super) const FIELD: Limits = Limits::within(&Pattern::SCALE);
pub(super) const FIELD_SLIDER: Slider = Slider::logarithmic(0.01, 4.0);

impl Pattern {
    /// World units. Fields narrower than the least are not told apart in single precision.
    pub const SCALE: RangeInclusive<f64> = 1e-4..=1e4;
}

fn no_pattern(scene: &Scene, index: usize) -> Option<&'static str> {
    colourless(scene, index)
        .or((scene.pattern.kind == PatternKind::None).then_some("There is no pattern"))
}

choices! {
    /// The patterns. Fields are counted from the origin, the first of them centred there.
    pub enum PatternKind {
        None = "none", "none", "No pattern";
        Checker = "checker", "checker", "Cubes, every other one coloured";
        Stripes = "stripes", "stripes", "Level layers";
        Rings = "rings", "rings", "Shells about the axis";
    }
}

table! {
    /// Light that passes through the surface.
    pub struct Transparency = "transparency" in transparency {
        KT kt: f64 = 0.0, Number(Limits::UNIT, Slider::UNIT), "transparency",
            "The fraction of the light that comes through the surface from behind: I = (1 − Kt)·Irefl + Kt·Itrans."
            .letter("Kt", Symbol::Kt);
        TRANSPARENCY_IOR ior: f64 = 1.5, Number(Limits::within(&Transparency::IOR), Slider::linear(0.5, 3.0)), "relative index",
            "The index of refraction inside relative to that outside: by Snell's law sin θ = η·sin θt; 1 bends nothing."
            .label("index").letter("η", Symbol::Transmitted).idle(opaque);
        THROUGH through: Through = Through::Solid, Choice, "Refraction",
            "How far the transmitted ray is followed.".symbol(Symbol::Transmitted).idle(opaque);
    }
}

impl Transparency {
    /// Indices of refraction, either way through the surface.
    pub const IOR: RangeInclusive<f64> = 0.1..=10.0;
}

fn opaque(scene: &Scene, _: usize) -> Option<&'static str> {
    (scene.transparency.kt == 0.0).then_some("Kt is 0: nothing is seen through the surface")
}

choices! {
    /// How far a transmitted ray is followed.
    pub enum Through {
        Surface = "surface", "one surface", "Refracted once: what lies behind is inside the material as well";
        Solid = "solid", "solid", "Refracted on its way in and out, and reflected inside where it cannot leave";
    }
}
