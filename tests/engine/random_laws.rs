//! Random laws typed as formulas: the picture at every SIMD level, the equation in double precision, and the probe lie within the
//! bounds of an evaluator of their own.
//!
//! `PROPTEST_CASES=10000 cargo test --release --test engine random_laws` tries 40 times as many formulas, `--nocapture` prints how
//! many points were compared.

mod bounds;

use crate::common::any_formula::any_formula;
use crate::common::dice::Dice;
use crate::common::simd::levels;
use crate::common::tries::tries;
use bounds::{Bounds, Value, bounds};
use glam::{DVec2, DVec3};
use rayon::prelude::*;
use shading_lab::analysis::probe::probe;
use shading_lab::illumination::Equation;
use shading_lab::render::Renderer;
use shading_lab::scene::{
    Attenuation, Camera, Encoding, LAW_NUMBERS, LAW_VECTORS, Light, LightKind, NormalSource,
    ObjectKind, Projection, ReflectionModel, Rgb, Scene, ShadingMode, Shared,
};

/// Pixels to a side.
const SIDE: u32 = 24;
/// The error of a unit vector's components in single precision.
const INPUT: f64 = 1e-6;
/// The code values by which a law may change through rounding, so that its pixels are compared.
const STEADY: f64 = 1.0 / 3.0;
/// A triangle that reaches beyond the picture, its corners on the picture's grid, so that a pixel's place on it is exact.
const CORNERS: [DVec2; 3] = [
    DVec2::new(-2.0, -2.0),
    DVec2::new(4.0, -2.0),
    DVec2::new(-2.0, 4.0),
];

/// Returns a scene of a triangle whose normal turns like that of a curved surface, its numbers without a pattern.
fn scene(dice: &mut Dice) -> Scene {
    let mut scene = Scene::default();
    scene.image.size = [SIDE; 2];
    scene.camera = Camera {
        eye: DVec3::new(0.0, 0.0, 4.0),
        target: DVec3::ZERO,
        projection: Projection::Orthographic,
        height: 2.0,
        ..scene.camera
    };
    let object = &mut scene.object;
    object.kind = ObjectKind::Polygons;
    object.normals = NormalSource::File;
    object.vertices = CORNERS.iter().map(|corner| corner.extend(0.0)).collect();
    object.faces = [vec![0, 1, 2]].into_iter().map(Shared::from).collect();
    object.vertex_normals = [[-0.7, -0.6, 0.6], [1.6, -0.3, 0.5], [-0.2, 1.5, 0.7]]
        .into_iter()
        .map(|normal| DVec3::from_array(normal).normalize())
        .collect();
    scene.shading.mode = ShadingMode::Phong;
    scene.display.encoding = Encoding::Raw;
    let mut color = |low: f64| DVec3::from_array([(); 3].map(|()| dice.between(low, 1.0)));
    let material = &mut scene.material;
    (material.ka, material.kd, material.ks) = (color(0.1), color(0.1), color(0.1));
    (material.color, material.specular_color) = (color(0.1), color(0.1));
    material.ior = color(0.5) * 2.0;
    material.n = dice.of(&[1.0, 2.0, 5.0, 12.5, 60.0]);
    material.roughness = dice.between(0.1, 0.9);
    let light = |position: [f64; 3], kind| Light {
        kind,
        position: DVec3::from_array(position),
        direction: DVec3::new(0.3, -0.5, -1.0),
        attenuation: Attenuation::None,
        ..Light::default()
    };
    scene.lights = vec![
        light([0.9, 0.7, 1.2], LightKind::Point),
        light([-1.5, -0.4, -0.3], LightKind::Point),
    ];
    if dice.unit() < 0.1 {
        scene.lights.push(light([0.0; 3], LightKind::Directional));
    }
    scene.reflection.model = ReflectionModel::Formula;
    scene
}

/// A point of the triangle with its normal.
#[derive(Clone, Copy)]
struct Site {
    point: DVec3,
    normal: DVec3,
}

/// Returns what a pixel shows.
fn site(scene: &Scene, index: u32) -> Site {
    let at = DVec2::new(f64::from(index % SIDE), f64::from(index / SIDE)) + 0.5;
    let place = (at * 2.0 / f64::from(SIDE) - 1.0) * DVec2::new(1.0, -1.0);
    let [a, b, c] = CORNERS;
    let share = (place - a) / DVec2::new((b - a).x, (c - a).y);
    let normals = &scene.object.vertex_normals;
    let sum = normals[0] * (1.0 - share.x - share.y) + normals[1] * share.x + normals[2] * share.y;
    Site {
        point: place.extend(0.0),
        normal: sum.normalize(),
    }
}

/// Returns the bounds of a name of the law, for a light and a channel.
fn named(scene: &Scene, site: Site, light: &Light, channel: usize, index: usize) -> Value {
    let n = site.normal;
    let v = (scene.camera.eye - site.point).normalize();
    let (l, distance) = match light.kind {
        LightKind::Directional => (-light.direction.normalize(), 4e12),
        _ => {
            let way = light.position - site.point;
            (way.normalize(), way.length())
        }
    };
    let (r, h) = (2.0 * n.dot(l) * n - l, (l + v).normalize());
    let vector = |name: &str| match name {
        "N" => n,
        "L" => l,
        "V" => v,
        "R" => r,
        _ => h,
    };
    if let Some(index) = index.checked_sub(LAW_NUMBERS.len()) {
        let components = vector(LAW_VECTORS[index]).to_array();
        return Value::Vector(components.map(|x| Bounds::input(x, INPUT)));
    }
    let material = &scene.material;
    let own = |color: Rgb| Bounds::known(color.to_array()[channel]);
    let cosine = |a: DVec3, b: DVec3| Bounds::input(a.dot(b), INPUT);
    let angle = |cosine: Bounds| cosine.acos().unwrap_or(Bounds::input(0.0, f64::INFINITY));
    Value::Number(match LAW_NUMBERS[index] {
        "d" => Bounds::input(distance, INPUT * distance),
        "theta" => angle(cosine(n, l)),
        "phi" => angle(cosine(r, v)),
        "ka" => own(material.ka),
        "kd" => own(material.kd),
        "ks" => own(material.ks),
        "od" => own(material.color),
        "os" => own(material.specular_color),
        "eta" => own(material.ior),
        "m" => Bounds::known(material.roughness),
        "n" => Bounds::known(material.n),
        product => {
            let (a, b) = product.split_once('·').expect("a product");
            cosine(vector(a), vector(b))
        }
    })
}

/// The points of a formula's picture.
#[derive(Clone, Copy, Default)]
struct Tally {
    channels: u64,
    /// Those whose bounds are too far apart.
    skipped: u64,
    /// Those compared that are neither black nor white.
    between: u64,
}

/// Returns the bounds of each channel of each pixel, for the light of both colours; `None` where rounding has no limit.
type Factors = Vec<[Option<[f64; 2]>; 3]>;

/// Returns the bounds of the law's factors, summed over the lights.
fn factors(scene: &Scene) -> Factors {
    let formula = scene.reflection.law().expect("a law");
    let of_pixel = |index| {
        let site = site(scene, index);
        [0, 1, 2].map(|channel| {
            scene.lights.iter().try_fold([0.0; 2], |sum, light| {
                let name = |index| named(scene, site, light, channel, index);
                let own = bounds(&formula, &name)?;
                Some([sum[0] + own.low, sum[1] + own.high])
            })
        })
    };
    (0..SIDE * SIDE).map(of_pixel).collect()
}

/// Gives the lights and the ambient light intensities that lay the law's values around the middle of the code values.
fn expose(scene: &mut Scene, factors: &Factors) {
    let mut sizes: Vec<f64> = factors
        .iter()
        .flatten()
        .flatten()
        .map(|[low, high]| 0.5 * (low + high).abs())
        .collect();
    sizes.sort_by(f64::total_cmp);
    let usual = sizes.get(sizes.len() * 4 / 5).copied().unwrap_or(1.0);
    let intensity = (0.4 / usual).clamp(1e-3, 1e3);
    for light in &mut scene.lights {
        light.color = Rgb::splat(intensity);
    }
    scene.ambient.color = Rgb::splat(0.5) / (scene.material.ka * scene.material.color);
}

/// Limits a value: what a light adds is at most a share of 10³⁴, so that larger values cannot be told from one another.
fn limited(value: f64) -> f64 {
    value.clamp(-1e33, 1e33)
}

/// Compares the pictures of a random law with its bounds.
fn compare(seed: u64) -> (Tally, Option<String>) {
    let mut dice = Dice(seed.wrapping_mul(0xd134_2543_de82_ef95));
    let mut scene = scene(&mut dice);
    scene.reflection.formula = any_formula(&mut dice);
    let factors = factors(&scene);
    expose(&mut scene, &factors);
    assert_eq!(scene.validate(), Ok(()), "{}", scene.reflection.formula);
    let intensity = scene.lights[0].color.x;
    let equation = Equation::<f64>::new(&scene);
    let mut renderers: Vec<_> = levels()
        .into_iter()
        .map(|level| (level, Renderer::default().with_level(level)))
        .collect();
    for (_, renderer) in &mut renderers {
        renderer.render(&scene);
    }
    let (mut tally, mut wrong) = (Tally::default(), None);
    let mut fail = |index: u32, what: String| {
        let [x, y] = [index % SIDE, index / SIDE];
        wrong.get_or_insert_with(|| {
            let formula = &scene.reflection.formula;
            format!(
                "law {seed} at {x},{y}: {what}\n{formula}\n{}",
                scene.to_toml()
            )
        });
    };
    for (index, factors) in (0..).zip(&factors) {
        let site = site(&scene, index);
        let double = equation
            .illuminate_world(site.point, site.normal, None)
            .to_array();
        let probed = (index % 191 == 57).then(|| {
            let renderer = &mut renderers[0].1;
            probe(renderer, &scene, index % SIDE, index / SIDE)
                .hit
                .expect("the triangle")
        });
        for channel in 0..3 {
            tally.channels += 1;
            let Some(range) = factors[channel].map(|range| range.map(|x| 0.5 + intensity * x))
            else {
                tally.skipped += 1;
                continue;
            };
            let [low, high] = range.map(limited);
            let rounding = 1e-9 + 1e-12 * low.abs().max(high.abs());
            let off = |value| !(low - rounding..=high + rounding).contains(&limited(value));
            if off(double[channel]) {
                fail(
                    index,
                    format!("in double precision {}, not {range:?}", double[channel]),
                );
            }
            let hit = probed.as_ref().map(|hit| hit.sum.to_array()[channel]);
            if let Some(sum) = hit.filter(|sum| off(*sum)) {
                fail(index, format!("the probe has {sum}, not {range:?}"));
            }
            let codes = range.map(|value| 255.0 * value.clamp(0.0, 1.0));
            if codes[1] - codes[0] > 2.0 * STEADY {
                tally.skipped += 1;
                continue;
            }
            tally.between += u64::from(codes[0] > 0.0 && codes[1] < 255.0);
            for (level, renderer) in &renderers {
                let stored = f64::from(renderer.frame().pixels[index as usize][channel]);
                if !(codes[0] - 1.0..=codes[1] + 1.0).contains(&stored) {
                    fail(index, format!("{level:?} has {stored}, not {codes:?}"));
                }
            }
        }
    }
    (tally, wrong)
}

#[test]
fn a_random_law_has_the_same_values_everywhere() {
    let all: Vec<_> = (0..tries(3000)).into_par_iter().map(compare).collect();
    let wrong: Vec<&String> = all.iter().filter_map(|(_, wrong)| wrong.as_ref()).collect();
    let sum = |of: fn(&Tally) -> u64| all.iter().map(|(tally, _)| of(tally)).sum::<u64>();
    let [channels, skipped, between] =
        [sum(|t| t.channels), sum(|t| t.skipped), sum(|t| t.between)];
    println!(
        "{} laws, {channels} values, {skipped} skipped, {between} neither black nor white, {} laws wrong",
        all.len(),
        wrong.len()
    );
    let heads = wrong.iter().filter_map(|text| text.lines().next());
    assert!(
        wrong.is_empty(),
        "{}\n{}",
        heads.collect::<Vec<_>>().join("\n"),
        wrong[0]
    );
    assert!(3 * skipped <= channels, "{skipped} of {channels} skipped");
    assert!(
        2 * between >= channels,
        "{between} of {channels} tell something"
    );
}
