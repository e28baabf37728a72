//! The built-in scenes whose law is a formula, against the expressions of their papers, evaluated from angles.
//!
//! A law is π times the BRDF times cos θ, as `kd·od·(N·L)` is of the BRDF `kd·od/π`.

use glam::DVec3;
use shading_lab::illumination::Equation;
use shading_lab::render::Renderer;
use shading_lab::scene::{
    Framing, Light, LightKind, ObjectKind, PatternKind, Projection, ReflectionModel, Rgb, Scene,
    ShadingMode, Viewer, presets,
};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, FRAC_PI_6, PI};

/// The directions to the light and to the viewer: their angles to the normal, and the angle between them about it. Radians.
#[derive(Clone, Copy, Debug)]
struct Angles {
    incidence: f64,
    view: f64,
    azimuth: f64,
}

impl Angles {
    fn new(incidence: f64, view: f64, azimuth: f64) -> Self {
        Self {
            incidence,
            view,
            azimuth,
        }
    }

    /// Returns the angles of unit vectors.
    fn of(n: DVec3, l: DVec3, v: DVec3) -> Self {
        let [along_l, along_v] = [l, v].map(|x| x - n * n.dot(x));
        let azimuth = along_l.cross(along_v).length().atan2(along_l.dot(along_v));
        Self::new(n.angle_between(l), n.angle_between(v), azimuth)
    }

    /// Returns N·L, or 0 behind the surface.
    fn lambert(self) -> f64 {
        self.incidence.cos().max(0.0)
    }

    /// Returns the cosine of the angle between two directions that are `azimuth` apart about the normal.
    fn between(self, azimuth: f64) -> f64 {
        let (i, e) = (self.incidence, self.view);
        i.cos() * e.cos() + i.sin() * e.sin() * azimuth.cos()
    }

    /// Returns R·V, or 0: R is the light's direction turned by half a circle about the normal.
    fn mirrored(self) -> f64 {
        self.between(PI - self.azimuth).max(0.0)
    }

    /// Returns the angle between N and H.
    fn halfway(self) -> f64 {
        let phase = self.between(self.azimuth).clamp(-1.0, 1.0).acos();
        ((self.incidence.cos() + self.view.cos()) / (2.0 * (phase / 2.0).cos()))
            .min(1.0)
            .acos()
    }
}

/// The numbers of a material in one channel.
struct Numbers {
    diffuse: f64,
    specular: f64,
    n: f64,
    od: f64,
    channel: usize,
}

impl Numbers {
    fn of(scene: &Scene) -> [Self; 3] {
        let material = &scene.material;
        [0, 1, 2].map(|channel| {
            let own = |color: Rgb| color.to_array()[channel];
            Self {
                diffuse: own(material.kd * material.color),
                specular: own(material.ks * material.specular_color),
                n: material.n,
                od: own(material.color),
                channel,
            }
        })
    }
}

type Expression = fn(Angles, &Numbers) -> f64;

/// The scenes with the expressions of the papers.
const LAWS: [(&str, Expression); 8] = [
    ("lommel-seeliger", |at, of| {
        of.diffuse * at.lambert() / (at.lambert() + at.view.cos())
    }),
    ("minnaert", |at, of| of.diffuse * minnaert(at, 1.4)),
    ("oren-nayar", |at, of| {
        of.diffuse * oren_nayar(at, FRAC_PI_6)
    }),
    // (1 + cos θ)/2 is the square of cos(θ/2).
    ("half-lambert", |at, of| {
        of.diffuse * (at.incidence / 2.0).cos().powi(4)
    }),
    ("schlick", |at, of| {
        let t = at.mirrored();
        let highlight = t / (of.n - of.n * t + t);
        let lit = at.incidence < FRAC_PI_2;
        of.diffuse * at.lambert() + if lit { of.specular * highlight } else { 0.0 }
    }),
    ("ward", |at, of| {
        of.diffuse * at.lambert() + of.specular * PI * at.lambert() * ward(at, 0.2)
    }),
    ("gooch", |at, of| {
        let (blue, yellow) = ([0.0, 0.0, 0.4], [0.4, 0.4, 0.0]);
        let cool = blue[of.channel] + 0.2 * of.od;
        let warm = yellow[of.channel] + 0.6 * of.od;
        let half = at.incidence / 2.0;
        half.cos().powi(2) * warm + half.sin().powi(2) * cool
    }),
    ("toon", |at, of| {
        let tone = (3.0 * at.lambert()).ceil() / 3.0;
        let spot = at.mirrored() > 0.5_f64.powf(1.0 / of.n) && at.incidence < FRAC_PI_2;
        of.diffuse * tone + if spot { of.specular } else { 0.0 }
    }),
];

/// Minnaert 1941, with Lambert's constant 1.
fn minnaert(at: Angles, k: f64) -> f64 {
    at.lambert().powf(k) * at.view.cos().powf(k - 1.0)
}

/// Oren and Nayar 1994, equation 30: the qualitative model; `sigma` in radians.
fn oren_nayar(at: Angles, sigma: f64) -> f64 {
    let square = sigma.powi(2);
    let a = 1.0 - 0.5 * square / (square + 0.33);
    let b = 0.45 * square / (square + 0.09);
    let (alpha, beta) = (at.incidence.max(at.view), at.incidence.min(at.view));
    at.lambert() * (a + b * at.azimuth.cos().max(0.0) * alpha.sin() * beta.tan())
}

/// The specular part of Ward's isotropic BRDF (1992), with ρs = 1; 0 behind the surface.
fn ward(at: Angles, alpha: f64) -> f64 {
    if at.incidence >= FRAC_PI_2 {
        return 0.0;
    }
    let slopes = (-(at.halfway().tan() / alpha).powi(2)).exp() / (4.0 * PI * alpha * alpha);
    slopes / (at.incidence.cos() * at.view.cos()).sqrt()
}

fn built_in(name: &str) -> Scene {
    let scene = presets::find(name).expect("a built-in scene").scene();
    assert_eq!(scene.reflection.model, ReflectionModel::Formula, "{name}");
    scene
}

/// Gives a named line of the scene's formula another number.
fn with_line(scene: &Scene, name: &str, number: f64) -> Scene {
    let begins = format!("{name} = ");
    let lines = scene.reflection.formula.lines();
    let changed: Vec<String> = lines
        .map(|line| {
            if line.starts_with(&begins) {
                format!("{begins}{number}")
            } else {
                line.to_owned()
            }
        })
        .collect();
    let mut own = scene.clone();
    own.reflection.formula = changed.join("\n");
    own.validate().expect("a law");
    assert_ne!(own, *scene, "no line {name}, or with that number");
    own
}

/// Returns the scene with one white directional light from `l`.
fn lit(scene: &Scene, l: DVec3) -> Scene {
    let mut scene = scene.clone();
    scene.pattern.kind = PatternKind::None;
    scene.lights = vec![Light {
        kind: LightKind::Directional,
        direction: -l,
        ..Light::default()
    }];
    scene
}

/// A scene's law where the normal is z, under light from one direction.
struct Bench(Equation<f64>);

impl Bench {
    fn new(scene: &Scene, incidence: f64) -> Self {
        let mut scene = lit(scene, direction(incidence, 0.0));
        (scene.camera.eye, scene.camera.target) = (DVec3::ZERO, DVec3::Z);
        scene.camera.viewer = Viewer::Local;
        Self(Equation::new(&scene))
    }

    /// Evaluates the law for each channel. The point lies so that the eye, at the origin, is in the given direction.
    fn factor(&self, view: f64, azimuth: f64) -> [f64; 3] {
        let point = -direction(view, azimuth);
        let response = self.0.respond_world(0, point, DVec3::Z, None);
        response.diffuse.to_array()
    }
}

/// Returns the unit vector at an angle to z, turned about z.
fn direction(angle: f64, turn: f64) -> DVec3 {
    let across = angle.sin();
    DVec3::new(across * turn.cos(), across * turn.sin(), angle.cos())
}

/// Evaluates a scene's law.
fn factor(scene: &Scene, at: Angles) -> [f64; 3] {
    Bench::new(scene, at.incidence).factor(at.view, at.azimuth)
}

/// Returns the angles from 0 `to` another in steps, given in degrees, as radians.
fn degrees(to: f64, step: f64) -> impl Iterator<Item = f64> {
    (0..)
        .map(move |k| step * f64::from(k))
        .take_while(move |angle| *angle <= to)
        .map(f64::to_radians)
}

/// Returns directions in which a surface is seen: the angle to the normal, and the one about it.
fn views() -> impl Iterator<Item = (f64, f64)> {
    degrees(88.0, 7.7).flat_map(|view| degrees(180.0, 22.5).map(move |azimuth| (view, azimuth)))
}

/// Returns angles of all directions from which light can come and in which a surface is seen.
fn everywhere() -> impl Iterator<Item = Angles> {
    degrees(180.0, 7.3).flat_map(|incidence| {
        views().map(move |(view, azimuth)| Angles::new(incidence, view, azimuth))
    })
}

/// Returns the largest difference between a scene's law and an expression, and where.
fn difference(scene: &Scene, expression: Expression) -> (f64, Option<Angles>) {
    let numbers = Numbers::of(scene);
    let mut most = (0.0, None);
    for incidence in degrees(180.0, 4.3) {
        let bench = Bench::new(scene, incidence);
        for (view, azimuth) in views() {
            let at = Angles::new(incidence, view, azimuth);
            for (own, numbers) in bench.factor(view, azimuth).into_iter().zip(&numbers) {
                let expected = expression(at, numbers);
                let off = (own - expected).abs() / expected.abs().max(1.0);
                if off > most.0 || off.is_nan() {
                    most = (off, Some(at));
                }
            }
        }
    }
    most
}

#[test]
fn each_law_is_the_expression_of_its_paper() {
    for (name, expression) in LAWS {
        let (off, at) = difference(&built_in(name), expression);
        assert!(off < 1e-9, "{name}: {off} at {at:?}");
    }
    let formulas = presets::ALL
        .iter()
        .filter(|preset| preset.scene().reflection.model == ReflectionModel::Formula);
    assert_eq!(formulas.count(), LAWS.len(), "each scene has a paper");
}

/// Returns the places of the numbers in a formula, without its comments.
fn numbers_in(formula: &str) -> Vec<std::ops::Range<usize>> {
    let mut found: Vec<std::ops::Range<usize>> = vec![];
    let (mut comment, mut word) = (false, false);
    for (at, c) in formula.char_indices() {
        comment = (comment || c == '#') && c != '\n';
        let digit = (c.is_ascii_digit() || c == '.') && !comment && !word;
        word = !digit && c.is_ascii_alphanumeric();
        if digit {
            match found.last_mut().filter(|last| last.end == at) {
                Some(last) => last.end = at + 1,
                None => found.push(at..at + 1),
            }
        }
    }
    found
}

/// Checks that the test above notices each number of each law when it is wrong: by 2 %, or 1 in place of 0.
#[test]
fn each_number_of_a_law_matters() {
    let mut count = 0;
    for (name, expression) in LAWS {
        let scene = built_in(name);
        let formula = &scene.reflection.formula;
        for place in numbers_in(formula) {
            let number: f64 = formula[place.clone()].parse().expect("a number");
            let wrong = if number == 0.0 { 1.0 } else { 1.02 * number };
            let mut other = scene.clone();
            other
                .reflection
                .formula
                .replace_range(place, &wrong.to_string());
            other.validate().expect("a law");
            let (off, _) = difference(&other, expression);
            assert!(off > 1e-4, "{name} with {wrong} for {number}: {off}");
            count += 1;
        }
    }
    assert!(count >= 30, "{count}");
}

#[test]
fn a_ball_is_drawn_by_the_expression_of_each_paper() {
    const SIDE: u32 = 48;
    let mut renderer = Renderer::default();
    renderer.keep_linear(true);
    let l = DVec3::new(0.5, 0.6, 0.7).normalize();
    for (name, expression) in LAWS {
        let mut scene = lit(&built_in(name), l);
        (scene.camera.eye, scene.camera.target) = (4.0 * DVec3::Z, DVec3::ZERO);
        scene.camera.viewer = Viewer::Infinite;
        scene.object.kind = ObjectKind::Sphere;
        scene.shading.mode = ShadingMode::Exact;
        scene.camera.projection = Projection::Orthographic;
        scene.camera.framing = Framing::Height;
        scene.camera.height = 2.0;
        scene.image.size = [SIDE; 2];
        scene.material.ka = Rgb::ZERO;
        renderer.render(&scene);
        let numbers = Numbers::of(&scene);
        let mut compared = 0;
        for (index, pixel) in renderer.linear().iter().enumerate() {
            let along = |index: usize| 2.0 * (index as f64 + 0.5) / f64::from(SIDE) - 1.0;
            let (x, y) = (along(index % SIDE as usize), -along(index / SIDE as usize));
            let square = 1.0 - x * x - y * y;
            if square < 0.01 {
                continue;
            }
            let n = DVec3::new(x, y, square.sqrt());
            let at = Angles::of(n, l, DVec3::Z);
            compared += 1;
            for (drawn, numbers) in pixel.iter().zip(&numbers) {
                let expected = expression(at, numbers);
                let off = (f64::from(*drawn) - expected).abs();
                assert!(
                    off <= 1e-4 * expected.max(1.0),
                    "{name}: {drawn}, {expected} at {at:?}"
                );
            }
        }
        assert!(compared > 1500, "{compared}");
    }
}

#[test]
fn the_full_moon_is_flat_and_lamberts_is_not() {
    let row = |model| {
        let mut scene = built_in("lommel-seeliger");
        scene.reflection.model = model;
        scene.image.size = [64, 64];
        let frame = Renderer::default().render(&scene).clone();
        let row = (0..64).filter_map(|x| frame.pixel(x, 32));
        let codes: Vec<u8> = row.map(|pixel| pixel[0]).filter(|red| *red > 0).collect();
        assert!(codes.len() > 40);
        let (least, most) = (codes.iter().min(), codes.iter().max());
        f64::from(*least.expect("a pixel")) / f64::from(*most.expect("a pixel"))
    };
    assert!(row(ReflectionModel::Formula) > 0.98);
    assert!(row(ReflectionModel::Phong) < 0.6);
}

#[test]
fn minnaert_is_lambert_for_k_1_flat_for_one_half_and_obeys_helmholtz() {
    let scene = built_in("minnaert");
    let (lambert, flat) = (with_line(&scene, "k", 1.0), with_line(&scene, "k", 0.5));
    let [diffuse, ..] = Numbers::of(&scene).map(|of| of.diffuse);
    for at in everywhere() {
        let [own, ..] = factor(&lambert, at);
        assert!((own - diffuse * at.lambert()).abs() < 1e-9, "{at:?}");
        let opposed = Angles::new(at.view, at.view, 0.0);
        assert!((factor(&flat, opposed)[0] - diffuse).abs() < 1e-9, "{at:?}");
        assert_reciprocal(&scene, at);
    }
}

/// Checks that the law over N·L is the same with the light and the viewer exchanged.
fn assert_reciprocal(scene: &Scene, at: Angles) {
    if at.incidence.cos() < 0.03 {
        return;
    }
    let other = Angles::new(at.view, at.incidence, at.azimuth);
    let (one, back) = (factor(scene, at)[0], factor(scene, other)[0]);
    let (one, back) = (one / at.lambert(), back / other.lambert());
    assert!((one - back).abs() < 1e-9 * (1.0 + one), "{at:?}");
}

#[test]
fn oren_nayar_is_lambert_without_slopes_and_flatter_with_them() {
    let scene = built_in("oren-nayar");
    let [diffuse, ..] = Numbers::of(&scene).map(|of| of.diffuse);
    let smooth = with_line(&scene, "sigma", 0.0);
    for at in everywhere() {
        let [own, ..] = factor(&smooth, at);
        assert!((own - diffuse * at.lambert()).abs() < 1e-9, "{at:?}");
        assert_reciprocal(&scene, at);
    }
    // The rim at 60° beside the middle, of a ball that is lit from behind the viewer: A = 0.7731, B = 0.3388 for 30°.
    let opposed = |angle| factor(&scene, Angles::new(angle, angle, 0.0))[0];
    let rim = opposed(FRAC_PI_3) / opposed(0.0);
    assert!((rim - 0.8286).abs() < 1e-3, "{rim}");
    // 10° is nearer to Lambert's 0.5.
    let less = with_line(&scene, "sigma", 10.0);
    let opposed = |angle| factor(&less, Angles::new(angle, angle, 0.0))[0];
    let rim = opposed(FRAC_PI_3) / opposed(0.0);
    assert!((0.55..0.75).contains(&rim), "{rim}");
}

#[test]
fn half_lambert_is_a_quarter_at_the_terminator() {
    let scene = built_in("half-lambert");
    let numbers = Numbers::of(&scene);
    for (angle, expected) in [(0.0, 1.0), (90.0, 0.25), (120.0, 0.0625), (180.0, 0.0)] {
        let own = factor(&scene, Angles::new(f64::to_radians(angle), 0.0, 0.0));
        for (own, numbers) in own.into_iter().zip(&numbers) {
            assert!((own - expected * numbers.diffuse).abs() < 1e-12, "{angle}");
        }
    }
}

/// Schlick 1994: as t^n, the quotient is 1 with the slope n at t = 1. It is never below t^n, and above it by less than the
/// largest 1/(1 + u) − e⁻ᵘ, the limit of large n.
#[test]
fn schlicks_quotient_stays_above_the_power_by_a_fifth_at_most() {
    let mut scene = built_in("schlick");
    (scene.material.kd, scene.material.ks) = (Rgb::ZERO, Rgb::ONE);
    let limit = (1..1000)
        .map(|k| 0.01 * f64::from(k))
        .map(|u| 1.0 / (1.0 + u) - (-u).exp())
        .fold(0.0, f64::max);
    assert!((limit - 0.2036).abs() < 1e-3, "{limit}");
    let mut most = 0.0_f64;
    for n in [1.0, 2.0, 5.0, 20.0, 100.0, 1000.0] {
        scene.material.n = n;
        let quotient = |t: f64| factor(&scene, Angles::new(0.0, t.acos(), 0.0))[0];
        assert!((quotient(1.0) - 1.0).abs() < 1e-12);
        let slope = (1.0 - quotient(1.0 - 1e-6 / n)) / (1e-6 / n);
        assert!((slope / n - 1.0).abs() < 1e-4, "{n}: {slope}");
        for k in 1..1000 {
            let t = 0.001 * f64::from(k);
            let above = quotient(t) - t.powf(n);
            assert!((-1e-9..limit + 1e-4).contains(&above), "{n} {t}: {above}");
            most = most.max(above);
        }
    }
    assert!(most > 0.2, "{most}");
}

/// Ward 1992: 1/(4πα² cos θ) in the mirror direction; what is reflected in all, the integral of BRDF · cos θ, is at most the
/// light that arrives, and all of it at normal incidence where slopes are small.
#[test]
fn wards_highlight_is_normalised() {
    let mut scene = built_in("ward");
    (scene.material.kd, scene.material.ks) = (Rgb::ZERO, Rgb::ONE);
    for alpha in [0.05, 0.1, 0.3] {
        scene.material.roughness = alpha;
        for incidence in [0.0, 0.3, 0.6, 0.9, 1.2] {
            let mirror = factor(&scene, Angles::new(incidence, incidence, PI))[0];
            let peak = mirror / (PI * incidence.cos());
            let published = 1.0 / (4.0 * PI * alpha * alpha * incidence.cos());
            assert!((peak / published - 1.0).abs() < 1e-9, "{alpha} {incidence}");
            let albedo = albedo(&scene, incidence);
            assert!(albedo < 1.001, "{alpha} {incidence}: {albedo}");
        }
    }
    scene.material.roughness = 0.1;
    let albedo = albedo(&scene, 0.0);
    assert!((albedo - 1.0).abs() < 0.05, "{albedo}");
}

/// Integrates BRDF · cos θ over the half-sphere by midpoints.
fn albedo(scene: &Scene, incidence: f64) -> f64 {
    let bench = Bench::new(scene, incidence);
    let (across, around) = (200, 60);
    let (step, turn) = (FRAC_PI_2 / f64::from(across), PI / f64::from(around));
    let mut sum = 0.0;
    for row in 0..across {
        let view = step * (f64::from(row) + 0.5);
        for column in 0..around {
            let [law, ..] = bench.factor(view, turn * (f64::from(column) + 0.5));
            let brdf = law / (PI * incidence.cos());
            // Both halves of the half-sphere.
            sum += 2.0 * brdf * view.cos() * view.sin() * step * turn;
        }
    }
    sum
}

#[test]
fn gooch_goes_from_cool_to_warm() {
    let scene = built_in("gooch");
    let at = |angle: f64| factor(&scene, Angles::new(angle, 0.0, 0.0));
    let (warm, cool) = (at(0.0), at(PI));
    assert!(warm[0] > cool[0] && warm[1] > cool[1] && warm[2] < cool[2]);
    let mut before = warm;
    for k in 1..=180 {
        let now = at(f64::to_radians(f64::from(k)));
        assert!(now[0] < before[0] && now[1] < before[1] && now[2] > before[2]);
        before = now;
    }
    // Nowhere black, and room for highlights above.
    assert!(cool.iter().sum::<f64>() > 0.3 && warm.iter().all(|warm| *warm < 1.0));
}

#[test]
fn toon_shading_has_the_listed_values_only() {
    let mut scene = built_in("toon");
    (scene.material.kd, scene.material.color) = (Rgb::splat(3.0), Rgb::ONE);
    scene.material.ks = Rgb::splat(10.0);
    let mut found: Vec<i64> = everywhere()
        .map(|at| {
            let [value, ..] = factor(&scene, at);
            assert!((value - value.round()).abs() < 1e-9, "{value} at {at:?}");
            value.round() as i64
        })
        .collect();
    found.sort_unstable();
    found.dedup();
    assert_eq!(found, [0, 1, 2, 3, 11, 12, 13]);
}
