//! The specular factor in single precision, over all exponents and at every SIMD level, against the plain cosine in double.
//!
//! N, L and V are unit vectors rounded to single precision: these are the inputs, and their rounding is no error of the factor.
//! The reference is the cosine of exactly these directions, in `f64`: for Phong's model `(R·V)^n` with N, L and V normalised
//! again; for Blinn's `(N·H)^n` with N and H normalised, and H along the sum of L and V as they are.

use crate::common::dice::Dice;
use crate::common::simd::levels;
use fearless_simd::{Level, dispatch, prelude::*};
use glam::DVec3;
use shading_lab::illumination::{LANES, Lanes, Lobe, ShadingPoint, SpecularForm, V3};
use shading_lab::scene::{Material, ReflectionModel, Scene};
use std::f64::consts::TAU;

/// Maximum error of the factor.
const WITHIN: f64 = 0.002;

const MODELS: [ReflectionModel; 2] = [ReflectionModel::Phong, ReflectionModel::Blinn];

/// Exponent and cosine below which the factor may be on either side of its jump to 0 at the rim of the lobe. Single precision
/// does not tell such a cosine, a sum of products of unit vectors, from 0, and a power below 0.4 of it is still above [`WITHIN`].
const RIM: (f64, f64) = (0.4, 1e-6);

/// One evaluation: N, L, V.
#[derive(Clone, Copy, Debug)]
struct Directions([[f32; 3]; 3]);

impl Directions {
    fn rounded(vectors: [DVec3; 3]) -> Self {
        Self(vectors.map(|v| v.as_vec3().to_array()))
    }

    /// Returns the cosine that the model raises to the power n.
    fn cosine(&self, model: ReflectionModel) -> f64 {
        let [n, l, v] = self.0.map(|v| DVec3::from_array(v.map(f64::from)));
        let n = n.normalize();
        match model {
            ReflectionModel::Phong => {
                let (l, v) = (l.normalize(), v.normalize());
                (2.0 * n * n.dot(l) - l).dot(v)
            }
            _ => n.dot((l + v).normalize_or_zero()),
        }
    }
}

/// Returns a direction `angle` from `axis`.
fn beside(dice: &mut Dice, axis: DVec3, angle: f64) -> DVec3 {
    let (across, along) = axis.any_orthonormal_pair();
    let (sine, cosine) = dice.between(0.0, TAU).sin_cos();
    (axis * angle.cos() + (across * cosine + along * sine) * angle.sin()).normalize()
}

fn anywhere(dice: &mut Dice) -> DVec3 {
    let (height, turn) = (dice.between(-1.0, 1.0), dice.between(0.0, TAU));
    let level = (1.0 - height * height).sqrt();
    DVec3::new(level * turn.cos(), level * turn.sin(), height)
}

fn exponent(dice: &mut Dice) -> f64 {
    let special = [0.0, 0.5, 1.0, 2.0, 64_f64.next_down(), 64.0, 65.0, 1e6, 1e7];
    if dice.unit() < 0.1 {
        dice.of(&special)
    } else {
        10_f64.powf(dice.between(-3.0, 7.0))
    }
}

/// Returns random directions, mostly within some widths of the lobe about its axis; L at any angle, at times almost level with
/// the surface.
fn directions(dice: &mut Dice, model: ReflectionModel, n: f64) -> Directions {
    let normal = if dice.unit() < 0.05 {
        dice.of(&[DVec3::X, DVec3::Y, DVec3::NEG_Z])
    } else {
        anywhere(dice)
    };
    let grazing = dice.unit() < 0.3;
    let from_level = if grazing {
        10_f64.powf(dice.between(-6.0, -1.0))
    } else {
        dice.unit()
    };
    let l = beside(dice, normal, from_level.acos());
    let away = dice.between(0.0, 5.0) * (1.0 / n.max(1.0)).sqrt();
    let mirrored = |axis: DVec3| (2.0 * axis * axis.dot(l) - l).normalize();
    let v = match model {
        _ if dice.unit() < 0.1 => anywhere(dice),
        ReflectionModel::Phong => beside(dice, mirrored(normal), away),
        _ => mirrored(beside(dice, normal, away)),
    };
    Directions::rounded([normal, l, v])
}

#[inline(always)]
fn factors<S: Simd>(
    simd: S,
    form: SpecularForm,
    lobe: &Lobe<f32>,
    directions: &[Directions],
) -> Vec<f32> {
    let mut all = Vec::with_capacity(directions.len());
    for chunk in directions.chunks(LANES) {
        let component = |vector: usize, axis: usize| {
            let mut numbers = [0.0; 16];
            for (number, Directions(vectors)) in numbers.iter_mut().zip(chunk) {
                *number = vectors[vector][axis];
            }
            Lanes::<S>::load(simd, &numbers)
        };
        let vector = |k: usize| V3::new(component(k, 0), component(k, 1), component(k, 2));
        let [normal, l, view] = [0, 1, 2].map(vector);
        let site = ShadingPoint {
            normal,
            position: -view,
            view,
            inverse_distance: Lanes::splat(simd, 1.0),
        };
        let factor = form.factor(&site, l, normal.dot(l), lobe);
        all.extend(&factor.0.as_slice()[..chunk.len()]);
    }
    all
}

#[test]
fn the_factor_is_right_at_every_exponent_and_level() {
    const EXPONENTS: usize = 62_500;
    const EACH: usize = 16;
    let mut dice = Dice(0x5eed_1977);
    let levels = levels();
    let mut scene = Scene::default();
    // The maximum error in each decade of n, the first that of n < 10⁻², the last that of n = 10⁷.
    let mut worst = [[0.0_f64; 11]; 2];
    for index in 0..EXPONENTS {
        let n = exponent(&mut dice);
        let which = index % 2;
        let model = MODELS[which];
        scene.reflection.model = model;
        scene.material = Material {
            n,
            ..Material::default()
        };
        let directions: Vec<Directions> =
            (0..EACH).map(|_| directions(&mut dice, model, n)).collect();
        let lobe = Lobe::of(&scene.material);
        for &level in &levels {
            let form = SpecularForm::of(&scene);
            let factors = dispatch!(level, simd => factors(simd, form, &lobe, &directions));
            for (factor, directions) in factors.iter().zip(&directions) {
                let cosine = directions.cosine(model);
                if n > 0.0 && n < RIM.0 && cosine.abs() < RIM.1 {
                    continue;
                }
                let truth = if n == 0.0 {
                    1.0
                } else {
                    cosine.clamp(0.0, 1.0).powf(n)
                };
                let error = (f64::from(*factor) - truth).abs();
                let decade = (n.max(1e-3).log10() + 3.0).floor() as usize;
                worst[which][decade] = worst[which][decade].max(error);
                assert!(
                    error < WITHIN,
                    "{model:?}, n = {n}, {level:?}: {factor}, not {truth}; {directions:?}"
                );
            }
        }
    }
    println!("greatest errors by decades of n from 10⁻³ on, Phong and Blinn: {worst:?}");
}

#[test]
fn the_cosine_alone_would_lose_a_stiff_lobe() {
    const N: f64 = 1e7;
    let mut dice = Dice(1977);
    let lobe = Lobe::of(&Material {
        n: N,
        ..Material::default()
    });
    let directions: Vec<Directions> = (0..4000)
        .map(|_| directions(&mut dice, ReflectionModel::Phong, N))
        .collect();
    let worst = |factors: Vec<f32>| {
        let truth = |directions: &Directions| {
            directions
                .cosine(ReflectionModel::Phong)
                .clamp(0.0, 1.0)
                .powf(N)
        };
        let errors = factors
            .iter()
            .zip(&directions)
            .map(|(got, at)| (f64::from(*got) - truth(at)).abs());
        errors.fold(0.0, f64::max)
    };
    let [cosine, chord] = [SpecularForm::PhongCosine, SpecularForm::PhongChord]
        .map(|form| dispatch!(Level::new(), simd => factors(simd, form, &lobe, &directions)))
        .map(worst);
    assert!(
        chord < WITHIN && cosine > 0.1,
        "chord {chord}, cosine {cosine}"
    );
}
