//! The specular factor S: Phong's `(R·V)^n` and Blinn's `(N·H)^n`, each in two forms.
//!
//! A power of a cosine is stiff: an error δ of the cosine becomes n·δ of the result, and near the lobe's axis the cosine
//! itself is rounded to a few 10⁻⁸ in single precision. With the chord between the two unit vectors,
//! `1 − a·b = |a − b|²/2`, the distance from the axis keeps its digits, and `(a·b)^n = exp(n·ln(1 − |a − b|²/2))`. At
//! small n the plain cosine is the better form, because the lobe is wide and the chord long.

use super::{Real, Scalar, Site, V3};
use crate::scene::{ReflectionModel, Rgb, Scene, ShadingMode};

/// The exponent n, prepared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exponent<T> {
    /// n, finite: a mirror's is so large that all but the axis itself vanishes.
    n: T,
    /// `0^n`: 1 for n = 0, otherwise 0.
    at_zero: T,
}

/// Stands for n = ∞: any deviation that single precision can tell from 0 vanishes.
const MIRROR: f64 = 1e30;

impl<T: Scalar> Exponent<T> {
    /// From n ≥ 0, infinity included.
    pub fn new(n: f64) -> Self {
        Self { n: T::from_f64(n.min(MIRROR)), at_zero: T::from_f64(if n == 0.0 { 1.0 } else { 0.0 }) }
    }
}

/// Which text of the specular factor a scene needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SpecularForm {
    /// No light is reflected specularly.
    None,
    PhongCosine,
    PhongChord,
    BlinnCosine,
    BlinnChord,
}

impl SpecularForm {
    /// From this n on the chord form is used. Where the chord's logarithm ends, at `1 − a·b` = 0.29, the power is then
    /// below 0.71⁶⁴ = 3·10⁻¹⁰, and below it the cosine form loses less than 64 · 10⁻⁷.
    pub const CHORD_FROM: f64 = 64.0;

    /// The form that `scene` needs. Normals that are left short of unit length have no chord.
    pub fn of(scene: &Scene) -> Self {
        let lit = scene.lights.iter().any(|light| scene.material.ks * light.color != Rgb::ZERO);
        let shading = &scene.shading;
        let unit_normals = shading.renormalise || shading.mode != ShadingMode::Phong;
        let chord = scene.material.n >= Self::CHORD_FROM && unit_normals;
        match scene.reflection.model {
            _ if !lit => Self::None,
            ReflectionModel::Phong if chord => Self::PhongChord,
            ReflectionModel::Phong => Self::PhongCosine,
            ReflectionModel::Blinn if chord => Self::BlinnChord,
            ReflectionModel::Blinn => Self::BlinnCosine,
        }
    }
}

/// Work that is compiled once for each specular form.
pub trait FormTask {
    type Output;

    fn run<F: Specular>(self, form: F) -> Self::Output;
}

impl SpecularForm {
    /// Runs `task` with the type that stands for this form.
    pub fn dispatch<T: FormTask>(self, task: T) -> T::Output {
        match self {
            Self::None => task.run(NoSpecular),
            Self::PhongCosine => task.run(PhongCosine),
            Self::PhongChord => task.run(PhongChord),
            Self::BlinnCosine => task.run(BlinnCosine),
            Self::BlinnChord => task.run(BlinnChord),
        }
    }
}

/// The specular factor of one light, a type for each form so that loops carry no choice.
pub trait Specular: Copy + Send + Sync + 'static {
    const PRESENT: bool = true;

    /// S at `site` for the unit direction `l` to the light and `n_dot_l` = N·L.
    fn factor<R: Real>(site: &Site<R>, l: V3<R>, n_dot_l: R, exponent: &Exponent<R::Scalar>) -> R;
}

/// ks = 0.
#[derive(Clone, Copy, Debug)]
pub struct NoSpecular;
#[derive(Clone, Copy, Debug)]
pub struct PhongCosine;
#[derive(Clone, Copy, Debug)]
pub struct PhongChord;
#[derive(Clone, Copy, Debug)]
pub struct BlinnCosine;
#[derive(Clone, Copy, Debug)]
pub struct BlinnChord;

impl Specular for NoSpecular {
    const PRESENT: bool = false;

    #[inline(always)]
    fn factor<R: Real>(_: &Site<R>, _: V3<R>, n_dot_l: R, _: &Exponent<R::Scalar>) -> R {
        n_dot_l.constant(R::Scalar::default())
    }
}

/// `R = 2N(N·L) − L`, L mirrored at N.
#[inline(always)]
pub(super) fn reflect<R: Real>(n: V3<R>, l: V3<R>, n_dot_l: R) -> V3<R> {
    n.scale_add(n_dot_l + n_dot_l, -l)
}

/// `H = (L + V)/|L + V|`, half-way between the light and the viewer.
#[inline(always)]
pub(super) fn halfway<R: Real>(l: V3<R>, v: V3<R>) -> V3<R> {
    (l + v).normalised()
}

/// `max(c, 0)^n`, from the cosine.
#[inline(always)]
fn power_of_cosine<R: Real>(c: R, exponent: &Exponent<R::Scalar>) -> R {
    let zero = c.constant(R::Scalar::default());
    let tiny = c.constant(R::Scalar::from_f64(f64::from(f32::MIN_POSITIVE)));
    let power = (c.max(tiny).log2() * exponent.n).exp2();
    R::select(c.greater_than(zero), power, c.constant(exponent.at_zero))
}

/// `(a·b)^n` of two unit vectors, from the chord between them.
#[inline(always)]
fn power_of_chord<R: Real>(a: V3<R>, b: V3<R>, exponent: &Exponent<R::Scalar>) -> R {
    let chord = a - b;
    let t = chord.dot(chord) * R::Scalar::from_f64(0.5);
    let t = t.min(t.constant(R::Scalar::from_f64(0.29)));
    (R::log2_one_minus(t) * exponent.n).exp2()
}

impl Specular for PhongCosine {
    #[inline(always)]
    fn factor<R: Real>(site: &Site<R>, l: V3<R>, n_dot_l: R, exponent: &Exponent<R::Scalar>) -> R {
        // R·V without R: 2(N·L)(N·V) − L·V.
        let n_dot_v = site.normal.dot(site.view);
        power_of_cosine((n_dot_l + n_dot_l).mul_add(n_dot_v, -l.dot(site.view)), exponent)
    }
}

impl Specular for PhongChord {
    #[inline(always)]
    fn factor<R: Real>(site: &Site<R>, l: V3<R>, n_dot_l: R, exponent: &Exponent<R::Scalar>) -> R {
        power_of_chord(reflect(site.normal, l, n_dot_l), site.view, exponent)
    }
}

impl Specular for BlinnCosine {
    #[inline(always)]
    fn factor<R: Real>(site: &Site<R>, l: V3<R>, _: R, exponent: &Exponent<R::Scalar>) -> R {
        power_of_cosine(site.normal.dot(halfway(l, site.view)), exponent)
    }
}

impl Specular for BlinnChord {
    #[inline(always)]
    fn factor<R: Real>(site: &Site<R>, l: V3<R>, _: R, exponent: &Exponent<R::Scalar>) -> R {
        power_of_chord(site.normal, halfway(l, site.view), exponent)
    }
}
