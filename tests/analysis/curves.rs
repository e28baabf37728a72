//! The curves of local illumination against closed forms, and their figures.

mod drawn;

use glam::DVec3;
use shading_lab::analysis::curves::{
    COURSE, Curves, Distances, attenuation_plot, exponent_plot, law_plot, lobe_plot,
    reflectance_plot, shown_kinds,
};
use shading_lab::analysis::lobe::ReflectionLobe;
use shading_lab::analysis::probe::{Probe, probe};
use shading_lab::figure::{Curve, Ink, Plot, PlotKind};
use shading_lab::illumination::{Index, attenuation_at, half_width};
use shading_lab::render::Renderer;
use shading_lab::scene::{
    Attenuation, Backfacing, Camera, Distribution, Light, LightKind, Reflectance, Reflection,
    ReflectionModel, Rgb, Scene, Viewer, presets,
};

fn preset(name: &str) -> Scene {
    let mut scene = presets::find(name).expect("a built-in scene").scene();
    scene.image.size = [96, 96];
    scene
}

/// Draws the scene and probes it at a pixel that it lights.
fn probed(scene: &Scene) -> (Renderer, Probe) {
    let mut renderer = Renderer::default();
    let probe = probe(&mut renderer, scene, 60, 40);
    assert!(probe.hit.is_some());
    (renderer, probe)
}

#[track_caller]
fn near(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance, "{a} is not {b}");
}

fn value(curve: &Curve, x: f64) -> f64 {
    curve.at(x).expect("inside the curve")
}

#[test]
fn at_its_half_width_every_curve_of_the_family_is_one_half() {
    let scene = preset("sphere");
    let plot = exponent_plot(&scene, None).expect("a power");
    assert_eq!(plot.curves.len(), 1 + COURSE.len());
    for (n, name) in COURSE
        .into_iter()
        .map(|n| (n, format!("n = {n}")))
        .chain([(40.0, "n = 40, now".to_owned())])
    {
        let curve = plot.curve(&name).expect("a curve of its own");
        let half = half_width(n).to_degrees();
        for angle in [half, -half] {
            near(value(curve, angle), 0.5, 1e-3);
        }
        assert_eq!(
            (value(curve, 0.0), value(curve, 90.0), value(curve, -90.0)),
            (1.0, 0.0, 0.0)
        );
        for [x, y] in &curve.points {
            near(*y, x.to_radians().cos().max(0.0).powf(n), 1e-12);
        }
        assert!(
            curve.points.windows(2).all(|pair| pair[0][0] < pair[1][0]),
            "{name}"
        );
    }
    let notes: Vec<&str> = plot
        .curves
        .iter()
        .map(|curve| curve.notes[0].as_str())
        .collect();
    assert_eq!(notes, ["10.6°", "29.5°", "17.3°", "10.0°", "2.1°"]);
}

#[test]
fn the_ends_of_the_exponent_have_their_curves() {
    let mut scene = preset("sphere");
    for (n, at_one_degree) in [
        (f64::INFINITY, 0.0),
        (0.0, 1.0),
        (0.5, 1f64.to_radians().cos().sqrt()),
    ] {
        scene.material.n = n;
        let plot = exponent_plot(&scene, None).expect("a power");
        near(value(&plot.curves[0], 1.0), at_one_degree, 1e-6);
        assert_eq!(value(&plot.curves[0], 0.0), 1.0);
        assert!(plot.curves[0].points.iter().all(|[_, y]| y.is_finite()));
    }
    scene.material.n = 45.0;
    assert_eq!(
        exponent_plot(&scene, None).expect("a power").curves.len(),
        4,
        "a curve of the course is not drawn twice"
    );
}

#[test]
fn microfacets_have_the_curve_of_their_distribution() {
    let mut scene = preset("sphere");
    scene.reflection.model = ReflectionModel::CookTorrance;
    for m in [0.05, 0.25, 1.0] {
        scene.material.roughness = m;
        let plot = exponent_plot(&scene, None).expect("a power");
        for degrees in [0.0, 3.0, 20.0, 45.0] {
            let phi = f64::to_radians(degrees);
            let beckmann = (-(phi.tan() / m).powi(2)).exp() / phi.cos().powi(4);
            near(value(&plot.curves[0], degrees), beckmann, 1e-3);
        }
        assert!(
            plot.title.contains("D(α)") && !plot.title.contains("cos"),
            "{}",
            plot.title
        );
        assert!(plot.y.high >= 1.0 && plot.curves[0].points.iter().all(|[_, y]| *y <= plot.y.high));
    }
}

/// Checks that Phong's model has φ, between R and V, and the models that measure N and H have α.
#[test]
fn the_highlights_angle_has_the_letter_of_its_model() {
    let scene = preset("sphere");
    for (model, distribution, letter, other) in [
        (ReflectionModel::Phong, Distribution::Beckmann, 'φ', 'α'),
        (ReflectionModel::Blinn, Distribution::Beckmann, 'α', 'φ'),
        (
            ReflectionModel::CookTorrance,
            Distribution::Beckmann,
            'α',
            'φ',
        ),
        (ReflectionModel::CookTorrance, Distribution::Ggx, 'α', 'φ'),
    ] {
        let mut scene = scene.clone();
        (scene.reflection.model, scene.reflection.distribution) = (model, distribution);
        let (renderer, probe) = probed(&scene);
        let terms = &probe.hit.as_ref().expect("the sphere").lights[0];
        let angle = if letter == 'φ' {
            terms.phi
        } else {
            terms.alpha
        };
        let curves = Curves::new(&renderer, &scene, &probe, 0);
        let plot = curves.plot(PlotKind::Exponent, &scene).expect("a plot");
        let mark = plot
            .marks
            .iter()
            .find(|mark| mark.probe)
            .expect("the probe's");
        near(mark.x, angle.to_degrees(), 1e-9);
        let texts = [
            &plot.title,
            &plot.note,
            &plot.x.name,
            &plot.y.name,
            &mark.label,
        ];
        assert!(
            texts
                .iter()
                .all(|text| text.contains(letter) && !text.contains(other)),
            "{texts:?}"
        );
    }
}

#[test]
fn the_probe_is_marked_with_its_own_values() {
    let mut scene = preset("attenuation");
    scene.material.reflectance = Reflectance::Gold;
    let (renderer, probe) = probed(&scene);
    let terms = &probe.hit.as_ref().expect("the plane").lights[0];
    let mark = |kind| {
        let curves = Curves::new(&renderer, &scene, &probe, 0);
        let plot = curves.plot(kind, &scene).expect("a plot");
        plot.marks
            .into_iter()
            .find(|mark| mark.probe)
            .expect("the probe's mark")
    };
    let attenuation = mark(PlotKind::Attenuation);
    near(
        attenuation.values[0].1,
        terms.attenuation,
        1e-9 * terms.attenuation,
    );
    let exponent = mark(PlotKind::Exponent);
    near(exponent.x, terms.phi.to_degrees(), 1e-9);
    near(
        exponent.values[0].1,
        terms.phi.cos().powf(scene.material.n),
        1e-12,
    );
    let reflectance = mark(PlotKind::Reflectance);
    near(reflectance.x, terms.incidence.to_degrees(), 1e-9);
    for (channel, w) in reflectance.values {
        near(w, terms.reflectance[channel], 1e-9);
    }
}

#[test]
fn reflectance_begins_at_its_closed_form_and_ends_at_one() {
    let mut scene = preset("sphere");
    for (kind, index) in [
        (Reflectance::Glass, Index::GLASS),
        (Reflectance::Silver, Index::SILVER),
        (Reflectance::Gold, Index::GOLD),
    ] {
        scene.material.reflectance = kind;
        let plot = reflectance_plot(&scene, None);
        let own = plot.curves.iter().filter(|curve| curve.emphasised);
        for (channel, curve) in own.enumerate() {
            let (eta, k) = (index.eta[channel], index.k[channel]);
            let down = ((eta - 1.0).powi(2) + k * k) / ((eta + 1.0).powi(2) + k * k);
            near(value(curve, 0.0), down, 1e-12);
            near(value(curve, 90.0), 1.0, 1e-12);
            assert_eq!(curve.notes[0], format!("{down:.3}"));
        }
        let inks: Vec<_> = plot
            .curves
            .iter()
            .filter(|curve| curve.emphasised)
            .map(|curve| (curve.ink, curve.dash, &curve.name))
            .collect();
        assert!(
            inks.len() == 3
                && inks[0].1 != inks[1].1
                && inks[1].1 != inks[2].1
                && inks[0].1 != inks[2].1
        );
    }
    scene.material.reflectance = Reflectance::Constant;
    assert!(
        reflectance_plot(&scene, None).curves[0]
            .points
            .iter()
            .all(|[_, y]| *y == 1.0)
    );
}

#[test]
fn every_attenuation_has_its_curve_from_no_distance_on() {
    let laws = [
        Attenuation::None,
        Attenuation::Viewer,
        Attenuation::Light,
        Attenuation::InverseSquare,
        Attenuation::Quadratic,
    ];
    for attenuation in laws {
        for k in [0.0, 1.0] {
            let light = Light {
                attenuation,
                k,
                c1: 0.0,
                ..Light::default()
            };
            let distances = Distances {
                nearest: Some(1.5),
                farthest: Some(4.0),
                probe: Some(2.0),
            };
            let plot = attenuation_plot(&light, &distances);
            assert!(
                plot.curves[0]
                    .points
                    .iter()
                    .flatten()
                    .all(|value| value.is_finite()),
                "{attenuation:?}"
            );
            assert!(plot.y.high.is_finite() && plot.y.high > 0.0 && plot.x.high > 4.0);
            for mark in &plot.marks {
                let f = attenuation_at(&light, attenuation, mark.x);
                near(mark.values[0].1, f, 1e-12);
                near(value(&plot.curves[0], mark.x), f, 1e-3 * f);
                assert!(
                    f <= plot.y.high * 1.05,
                    "{attenuation:?}: the mark is inside the plot"
                );
            }
            assert_eq!(plot.marks.len(), 3);
        }
    }
    let nowhere = attenuation_plot(&Light::default(), &Distances::default());
    assert!(nowhere.marks.is_empty() && nowhere.x.high > 0.0);
}

#[test]
fn the_distances_are_those_of_what_is_seen() {
    let scene = preset("attenuation");
    let (renderer, probe) = probed(&scene);
    let point = probe.hit.as_ref().map(|hit| hit.position);
    let distances = Distances::seen(&renderer, &scene, &scene.lights[0], point);
    let (nearest, farthest) = (
        distances.nearest.expect("something"),
        distances.farthest.expect("something"),
    );
    // The lamp is 0.55 in front of the middle of a square of side 2, and 0.15 above it.
    assert!((0.55..0.58).contains(&nearest), "{nearest}");
    let corner = (1.0f64 + 1.15 * 1.15 + 0.55 * 0.55).sqrt();
    assert!((corner - 0.1..=corner).contains(&farthest), "{farthest}");
    let probe = distances.probe.expect("the probe's");
    assert!((nearest..=farthest).contains(&probe));
    let distant = Light {
        kind: LightKind::Directional,
        attenuation: Attenuation::Light,
        ..Light::default()
    };
    assert_eq!(
        Distances::seen(&renderer, &scene, &distant, point),
        Distances::default()
    );
}

fn lobe_of(scene: &Scene) -> (Plot, ReflectionLobe, Probe) {
    let (_, probe) = probed(scene);
    let hit = probe.hit.clone().expect("the object");
    let plot = lobe_plot(scene, &hit, 0).expect("a lit point");
    (
        plot,
        ReflectionLobe::at(scene, &hit, 0).expect("a lit point"),
        probe,
    )
}

#[test]
fn phongs_lobe_is_longest_towards_r_and_even_about_it() {
    for n in [3.0, 40.0, 1005.0, f64::INFINITY] {
        let mut scene = preset("sphere");
        scene.material.n = n;
        let (plot, lobe, _) = lobe_of(&scene);
        let r = plot
            .directions
            .iter()
            .find(|direction| direction.letter == "R")
            .expect("R");
        let total = plot.curve(english!("point-both-terms")).expect("the lobe");
        let longest = total
            .points
            .iter()
            .max_by(|a, b| a[1].total_cmp(&b[1]))
            .expect("points");
        near(longest[0], r.angle, 1e-9);
        let light = &scene.lights[0];
        let peak = (light.color * scene.material.ks).dot(Rgb::new(0.2126, 0.7152, 0.0722));
        near(lobe.towards(lobe.r).specular, peak, 0.01 * peak);
        for degrees in [0.5f64, 4.0, 15.0] {
            let turn = degrees.to_radians();
            let [left, right] =
                [-turn, turn].map(|turn| lobe.towards(lobe.in_plane(lobe.mirror_angle() + turn)));
            near(left.specular, right.specular, 1e-9);
            near(left.specular, peak * turn.cos().powf(n), 1e-6);
        }
    }
}

#[test]
fn the_diffuse_part_is_a_half_circle_and_nothing_leaves_below_the_surface() {
    let (plot, lobe, _) = lobe_of(&preset("sphere"));
    let diffuse = plot
        .curve(english!("point-diffuse"))
        .expect("the diffuse part");
    let radius = diffuse.points[0][1];
    assert!(radius > 0.0);
    for [_, y] in &diffuse.points {
        near(*y, radius, 1e-12);
    }
    assert_eq!(
        (
            diffuse.points[0][0],
            diffuse.points[diffuse.points.len() - 1][0]
        ),
        (-90.0, 90.0)
    );
    assert_eq!(lobe.towards(-lobe.n).total(), 0.0);
}

#[test]
fn towards_the_eye_the_lobe_is_what_the_probe_says() {
    for model in [
        ReflectionModel::Phong,
        ReflectionModel::Blinn,
        ReflectionModel::CookTorrance,
    ] {
        for name in ["sphere", "attenuation", "torus"] {
            let mut scene = preset(name);
            scene.reflection.model = model;
            scene.material.reflectance = Reflectance::Glass;
            let (_, lobe, probe) = lobe_of(&scene);
            let hit = probe.hit.expect("the object");
            let seen = (hit.lights[0].diffuse + hit.lights[0].specular)
                .dot(Rgb::new(0.2126, 0.7152, 0.0722));
            near(lobe.towards(hit.view).total(), seen, 1e-9);
        }
    }
}

/// Returns the light that the surface of `scene` reflects specularly from parallel light from `l` towards `v`, without
/// the cosine, which Cook and Torrance's and Phong's models have in different places.
fn specular(scene: &Scene, l: DVec3, v: DVec3) -> f64 {
    let light = Light {
        kind: LightKind::Directional,
        direction: -l,
        ..Light::default()
    };
    let scene = Scene {
        lights: vec![light],
        ..scene.clone()
    };
    let mut probe = probed(&scene).1;
    let hit = probe.hit.as_mut().expect("the object");
    hit.normal = DVec3::Z;
    ReflectionLobe::at(&scene, hit, 0)
        .expect("lit from the front")
        .towards(v)
        .specular
}

#[test]
fn light_and_viewer_may_change_places() {
    let (a, b) = (
        DVec3::new(0.5, 0.3, 0.8).normalize(),
        DVec3::new(-0.6, 0.1, 0.5).normalize(),
    );
    for model in [
        ReflectionModel::Phong,
        ReflectionModel::Blinn,
        ReflectionModel::CookTorrance,
    ] {
        let mut scene = preset("sphere");
        scene.reflection.model = model;
        scene.material.n = 6.0;
        scene.material.roughness = 0.6;
        let [there, back] = [specular(&scene, a, b), specular(&scene, b, a)];
        assert!(there > 1e-4);
        // Cook and Torrance's is a reflectance distribution times N·L.
        let shared = if model == ReflectionModel::CookTorrance {
            (b.z, a.z)
        } else {
            (1.0, 1.0)
        };
        near(there * shared.0, back * shared.1, 1e-9);
    }
}

#[test]
fn a_light_behind_the_surface_has_a_lobe_only_where_the_surface_has_two_sides() {
    let mut scene = preset("sphere");
    scene.lights[0].position = DVec3::new(0.0, 0.0, -5.0);
    let hit = probed(&scene).1.hit.expect("the sphere");
    assert!(lobe_plot(&scene, &hit, 0).is_none() && lobe_plot(&scene, &hit, 7).is_none());
    scene.reflection.backfacing = Backfacing::Flip;
    let lobe = ReflectionLobe::at(&scene, &hit, 0).expect("the other side");
    assert!(lobe.n.dot(hit.normal) < -0.99 && lobe.towards(lobe.r).specular > 0.1);
}

#[test]
fn a_light_straight_above_and_a_viewer_at_infinity_have_a_lobe() {
    let mut scene = preset("sphere");
    scene.camera = Camera {
        viewer: Viewer::Infinite,
        ..scene.camera
    };
    let mut hit = probed(&scene).1.hit.expect("the sphere");
    scene.lights[0] = Light {
        kind: LightKind::Directional,
        direction: -hit.normal,
        ..Light::default()
    };
    hit.view = hit.normal;
    let plot = lobe_plot(&scene, &hit, 0).expect("a lit point");
    assert!(
        plot.curves
            .iter()
            .flat_map(|curve| &curve.points)
            .flatten()
            .all(|value| value.is_finite())
    );
    near(
        plot.directions
            .iter()
            .find(|direction| direction.letter == "R")
            .expect("R")
            .angle,
        0.0,
        1e-6,
    );
}

#[test]
fn attenuation_is_plotted_where_there_is_a_distance() {
    use PlotKind::{Attenuation as F, Exponent, Lobe, Reflectance as W};
    let mut scene = preset("sphere");
    assert_eq!(shown_kinds(&scene, 0), [F, Exponent, W, Lobe]);
    scene.lights[0].kind = LightKind::Directional;
    assert_eq!(shown_kinds(&scene, 0), [Exponent, W, Lobe]);
    assert_eq!(shown_kinds(&scene, 9), [Exponent, W, Lobe]);
}

#[test]
fn a_curve_is_read_between_its_samples_and_not_beyond() {
    let curve = Curve::new(
        "",
        vec![[0.0, 1.0], [2.0, 3.0], [2.0, 5.0], [4.0, 5.0]],
        Ink::N,
    );
    let read = [-0.1, 0.0, 1.0, 2.0, 3.0, 4.0, 4.1].map(|x| curve.at(x));
    assert_eq!(
        read,
        [
            None,
            Some(1.0),
            Some(2.0),
            Some(3.0),
            Some(5.0),
            Some(5.0),
            None
        ]
    );
    assert_eq!(Curve::new("", vec![], Ink::N).at(0.0), None);
}

#[test]
fn every_law_of_attenuation_and_every_substance_stands_beside_the_present_one() {
    let scene = preset("attenuation");
    let (renderer, probe) = probed(&scene);
    let light = &scene.lights[0];
    let curves = Curves::new(&renderer, &scene, &probe, 0);
    let plot_of = |kind| curves.plot(kind, &scene).expect("a plot");
    let laws = plot_of(PlotKind::Attenuation);
    assert_eq!(laws.curves.len(), 4);
    let emphasised: Vec<_> = laws.curves.iter().map(|curve| curve.emphasised).collect();
    assert_eq!(
        emphasised,
        [true, false, false, false],
        "the present law is first"
    );
    let mark = laws
        .marks
        .iter()
        .find(|mark| mark.probe)
        .expect("the probe");
    assert_eq!(mark.values.len(), 4);
    for law in [
        Attenuation::None,
        Attenuation::Light,
        Attenuation::InverseSquare,
        Attenuation::Quadratic,
    ] {
        let f = attenuation_at(light, law, mark.x);
        let told = mark
            .values
            .iter()
            .any(|(_, value)| (value - f).abs() < 1e-12);
        assert!(told, "{law:?}: {f} is not among {:?}", mark.values);
    }
    let names = |plot: &Plot| {
        plot.curves
            .iter()
            .map(|curve| curve.key.clone())
            .collect::<Vec<_>>()
    };
    assert_eq!(
        names(&plot_of(PlotKind::Reflectance)),
        ["constant", "glass", "silver", "gold"]
    );
    let mut gold = scene.clone();
    gold.material.reflectance = Reflectance::Gold;
    let plot = reflectance_plot(&gold, Some(0.5));
    assert_eq!(
        names(&plot),
        ["red", "green", "blue", "constant", "glass", "silver"]
    );
    assert!(plot.x.name.contains(english!("unit-degrees")));
    assert!(laws.x.name.contains(english!("unit-world")));
}

fn with_law(formula: &str) -> Scene {
    let mut scene = preset("sphere");
    scene.reflection.model = ReflectionModel::Formula;
    scene.reflection.formula = formula.to_owned();
    scene.validate().expect("a law");
    scene
}

#[test]
fn the_lobe_of_a_law_is_that_of_the_same_model() {
    for n in [3.0, 40.0, 1005.0] {
        let [mut phong, mut own] = [preset("sphere"), with_law(Reflection::PHONG)];
        (phong.material.n, own.material.n) = (n, n);
        let (plot, lobe, probe) = lobe_of(&own);
        let (_, expected, _) = lobe_of(&phong);
        let hit = probe.hit.expect("the object");
        for turn in -90..=90 {
            let v = lobe.in_plane(f64::from(turn).to_radians());
            near(lobe.towards(v).total(), expected.towards(v).total(), 1e-9);
        }
        near(
            lobe.towards(hit.view).total(),
            expected.towards(hit.view).total(),
            1e-9,
        );
        assert_eq!(plot.curves.len(), 1, "it is not split into two terms");
        let bare = with_law(&Reflection::PHONG.replace("kd", "0 * kd"));
        let bare = Scene {
            material: own.material.clone(),
            ..bare
        };
        let width = lobe_of(&bare).1.half_width();
        assert!((width / half_width(n) - 1.0).abs() < 0.11, "{n}: {width}");
    }
}

#[test]
fn the_curve_of_a_law_is_its_value_whatever_the_light_is() {
    let value_at = |formula: &str, light: &dyn Fn(&mut Light)| {
        let mut scene = with_law(formula);
        light(&mut scene.lights[0]);
        let (_, probe) = probed(&scene);
        let hit = probe.hit.expect("the object");
        let plot = law_plot(&scene, &hit, 0).expect("a lit point");
        let distance = scene.lights[0].position.distance(hit.position);
        (plot, distance)
    };
    let lamps: [&dyn Fn(&mut Light); 3] = [
        &|_| {},
        &|light| light.color = Rgb::new(3.0, 0.0, 0.5),
        &|light| {
            (light.attenuation, light.kind) = (Attenuation::InverseSquare, LightKind::Spot);
        },
    ];
    for light in lamps {
        let (plot, distance) = value_at("(N·V)^2", light);
        assert_eq!(plot.curves.len(), 1);
        for degrees in [-80.0, -30.0, 0.0, 45.0, 89.0] {
            let cosine = f64::to_radians(degrees).cos();
            near(value(&plot.curves[0], degrees), cosine * cosine, 1e-4);
        }
        let (plot, _) = value_at("d", light);
        near(value(&plot.curves[0], 10.0), distance, 1e-9);
    }
    // Below 0, and of several colours.
    let (plot, _) = value_at("od - 1", &|_| {});
    let color = preset("sphere").material.color;
    assert_eq!(plot.curves.len(), 3);
    for (curve, color) in plot.curves.iter().zip(color.to_array()) {
        near(value(curve, 0.0), color - 1.0, 1e-9);
    }
    assert!(plot.y.low < 0.0);
}
