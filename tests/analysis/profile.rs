//! Profiles of pictures, their perceived counterparts, and the theory of both.

use glam::{DVec2, DVec3};
use shading_lab::analysis::perception::{
    Perception, ResponseModel, Viewing, blur_line, blur_picture, luminance,
};
use shading_lab::analysis::probe::probe;
use shading_lab::analysis::profile::{
    Abscissa, Compared, Profile, ProfileError, ProfileQuestion, Trace, compared_plots,
    perceived_picture, profile,
};
use shading_lab::figure::{Paper, Plot, PlotStyle, lay_out_bare};
use shading_lab::render::Renderer;
use shading_lab::scene::{
    Choice, Interpolation, Light, LightKind, NormalSource, ObjectKind, Projection, Rgb, Scene,
    ShadingMode, Viewer, presets,
};
use std::f64::consts::{PI, TAU};

/// Samples a function at `count` points, `h` pixels apart.
fn line(h: f64, count: usize, of: impl Fn(f64) -> f64) -> Vec<f64> {
    (0..count)
        .map(|k| of((k as f64 - (count / 2) as f64) * h))
        .collect()
}

fn respond(perception: &Perception, values: &[f64], h: f64, per_degree: f64) -> Vec<f64> {
    perception.respond(values, per_degree, &|values, sigma| {
        blur_line(values, sigma / h)
    })
}

#[test]
fn a_corner_departs_by_the_product_of_its_slope_and_the_widths() {
    for h in [0.25, 1.0] {
        for (before, after) in [(0.0, 0.01), (0.02, -0.005), (-0.01, -0.011)] {
            for (centre, surround, weight) in [(0.04, 0.2, 1.0), (0.1, 0.3, 0.5), (0.05, 0.08, 2.0)]
            {
                let perception = Perception {
                    centre,
                    surround,
                    weight,
                    ..Perception::default()
                };
                let per_degree = 40.0;
                let corner = line(h, 1601, |x| 0.5 + x * if x < 0.0 { before } else { after });
                let departure = respond(&perception, &corner, h, per_degree)[800] - corner[800];
                let expected =
                    weight * (after - before) * (centre - surround) * per_degree / TAU.sqrt();
                assert!(
                    (departure / expected - 1.0).abs() < 0.01,
                    "{departure} is not {expected}"
                );
            }
        }
    }
}

#[test]
fn a_straight_ramp_is_seen_as_it_is() {
    let ramp = line(0.25, 4001, |x| 0.4 + 0.003 * x);
    for model in ResponseModel::ALL {
        let perception = Perception {
            model,
            ..Perception::default()
        };
        let response = respond(&perception, &ramp, 0.25, 40.0);
        for (k, (seen, there)) in response.iter().zip(&ramp).enumerate().skip(1000).take(2000) {
            assert!(
                (seen - there).abs() < 1e-9,
                "{model:?} at {k}: {seen} is not {there}"
            );
        }
    }
}

#[test]
fn normalisation_leaves_corners_and_weakens_steps() {
    let greatest = |model, values: &[f64]| {
        let perception = Perception {
            model,
            ..Perception::default()
        };
        let response = respond(&perception, values, 0.25, 40.0);
        let inner = response.iter().zip(values).skip(500).take(3000);
        inner.map(|(seen, there)| seen - there).fold(0.0, f64::max)
    };
    let step = line(0.25, 4001, |x| if x < 0.0 { 0.2 } else { 0.8 });
    let knee = line(0.25, 4001, |x| 0.5 + (0.002 * x).clamp(-0.1, 0.1));
    let [inhibited, normalised] =
        ResponseModel::ALL.map(|model| greatest(model, &knee) / greatest(model, &step));
    assert!(
        normalised > 3.0 * inhibited,
        "beside a step a corner is seen better: {normalised} and {inhibited}"
    );
}

#[test]
fn a_degree_is_as_many_pixels_as_the_screen_has_in_it() {
    let viewing = Viewing {
        distance: 1000.0,
        density: 2.0,
    };
    assert!((viewing.pixels_per_degree() - 2000.0 * (PI / 180.0).tan()).abs() < 1e-9);
    assert!((Viewing::default().pixels_per_degree() - 39.59).abs() < 0.01);
}

/// Radius of the unit circle in the picture of [`cylinder`], in pixels.
const RADIUS: f64 = 400.0;

/// Returns a matt cylinder seen across its axis from far away and lit from the viewer's direction: on the facets' corners, the
/// intensity at sin φ from the middle is cos φ.
fn cylinder(segments: u32) -> Scene {
    let mut scene = Scene::default();
    scene.image.size = [1000, 101];
    scene.object.kind = ObjectKind::Cylinder;
    scene.object.segments = segments;
    scene.object.rings = 1;
    scene.object.normals = NormalSource::Exact;
    scene.camera.projection = Projection::Orthographic;
    scene.camera.viewer = Viewer::Infinite;
    scene.camera.eye = DVec3::new(0.0, 0.0, 5.0);
    // The cylinder has radius 0.6.
    scene.camera.height = 0.6 * 101.0 / RADIUS;
    scene.ambient.color = Rgb::ZERO;
    scene.material.kd = Rgb::ONE;
    scene.material.ks = Rgb::ZERO;
    scene.material.color = Rgb::ONE;
    scene.lights = vec![Light {
        kind: LightKind::Directional,
        direction: DVec3::NEG_Z,
        ..Light::default()
    }];
    scene
}

fn taken(scene: &Scene, from: [f64; 2], to: [f64; 2]) -> Profile {
    let request = ProfileQuestion {
        modes: ShadingMode::VALUES.to_vec(),
        ..ProfileQuestion::new(DVec2::from(from), DVec2::from(to))
    };
    profile(&mut Renderer::default(), scene, &request).expect("a line in the picture")
}

fn trace(profile: &Profile, mode: ShadingMode) -> &Trace {
    profile
        .traces
        .iter()
        .find(|trace| trace.mode == mode)
        .expect("the mode was asked for")
}

#[test]
fn the_slope_jumps_at_the_edges_of_a_cylinder_by_the_theory() {
    for segments in [48, 96, 192] {
        let scene = cylinder(segments);
        let profile = taken(&scene, [500.0, 50.5], [960.0, 50.5]);
        let h = RADIUS * TAU / f64::from(segments);
        let mut edges = 0;
        for (index, border) in profile.borders.iter().enumerate() {
            let [Some(before), Some(after)] = border.faces else {
                continue;
            };
            let sine = (border.x - 500.0) / RADIUS;
            if before == after || !(0.25..0.9).contains(&sine) {
                continue;
            }
            edges += 1;
            let phi = sine.asin();
            // Per pixel: the intensity falls as x = sin φ grows, and a pixel is 1/RADIUS of it. The spacing on the circle is
            // h/RADIUS, in the picture cos φ of that.
            let spacing = h * phi.cos();
            let gouraud = -spacing / phi.cos().powi(3) / RADIUS.powi(2);
            let phong = phi.sin().powi(2) * gouraud;
            for (mode, expected) in [(ShadingMode::Gouraud, gouraud), (ShadingMode::Phong, phong)] {
                let corner =
                    trace(&profile, mode).corners[index].expect("a polygon on either side");
                let ratio = corner.jump / expected;
                assert!(
                    (ratio - 1.0).abs() < 0.1,
                    "{mode:?}, {segments} facets, φ = {phi:.2}: {ratio}"
                );
                assert!(
                    corner.step.abs() < 1e-4,
                    "{mode:?} is continuous: {}",
                    corner.step
                );
                if mode == ShadingMode::Phong {
                    // With Phong shading the slope changes within the facets as well.
                    continue;
                }
                // The same jump is in the profile itself, between the samples beside the edge.
                let slopes = &trace(&profile, mode).slope;
                let after = profile
                    .samples
                    .partition_point(|sample| sample.x <= border.x + 1e-6);
                let before = profile
                    .samples
                    .partition_point(|sample| sample.x < border.x - 1e-6)
                    - 1;
                assert!(
                    ((slopes[after] - slopes[before]) / expected - 1.0).abs() < 0.1,
                    "{mode:?}, {segments}"
                );
            }
        }
        assert!(
            edges >= segments as usize / 12,
            "{edges} edges of {segments} facets"
        );
    }
}

#[test]
fn the_profile_passes_through_the_pixels_of_the_picture() {
    for (name, to) in [
        ("sphere", [96.0, 40.5]),
        ("torus", [96.0, 40.5]),
        ("shadows", [96.0, 40.5]),
        ("glass-ball", [96.0, 40.5]),
    ] {
        let mut scene = presets::find(name).expect("a built-in scene").scene();
        scene.image.size = [96, 96];
        for &interpolation in Interpolation::VALUES {
            scene.shading.interpolation = interpolation;
            let profile = taken(&scene, [0.0, 40.5], to);
            for trace in &profile.traces {
                scene.shading.mode = trace.mode;
                let mut renderer = Renderer::default();
                for (sample, value) in profile.samples.iter().zip(&trace.intensity) {
                    if (sample.x.fract() - 0.5).abs() > 1e-9 {
                        continue;
                    }
                    let seen = probe(&mut renderer, &scene, sample.x as u32, 40);
                    let Some(hit) = seen.hit else { continue };
                    let expected = luminance(hit.sum);
                    assert!(
                        (value - expected).abs() < 2e-4,
                        "{name} {:?} at {}: {value}, {expected}",
                        trace.mode,
                        sample.x
                    );
                }
            }
        }
    }
}

#[test]
fn a_flat_picture_is_constant_from_border_to_border() {
    let profile = taken(&cylinder(24), [50.0, 50.5], [950.0, 50.5]);
    let flat = trace(&profile, ShadingMode::Flat);
    assert!(flat.slope.iter().all(|slope| *slope == 0.0));
    let border = |from: f64, to: f64| {
        profile
            .borders
            .iter()
            .any(|border| (from..=to).contains(&border.x))
    };
    for (places, values) in profile.samples.windows(2).zip(flat.intensity.windows(2)) {
        let crossed = border(places[0].x - 1e-9, places[1].x + 1e-9);
        assert!(crossed || values[0] == values[1], "{places:?}");
    }
    let steps = flat
        .corners
        .iter()
        .flatten()
        .filter(|corner| corner.step.abs() > 1e-3)
        .count();
    assert!(steps >= 10, "{steps} steps");
    assert!(
        trace(&profile, ShadingMode::Exact)
            .corners
            .iter()
            .all(Option::is_none)
    );
}

#[test]
fn phong_shading_weakens_mach_bands_and_does_not_abolish_them() {
    let scene = cylinder(24);
    let profile = taken(&scene, [560.0, 50.5], [800.0, 50.5]);
    // The contrast that the eye adds at the borders, which makes bands visible.
    let band = |mode| {
        let trace = trace(&profile, mode);
        let added = |x: f64| {
            let at = profile.samples.partition_point(|sample| sample.x < x);
            (trace.perceived[at] - trace.intensity[at]).abs()
        };
        let borders: Vec<f64> = profile
            .borders
            .iter()
            .filter(|border| border.faces[0] != border.faces[1])
            .map(|b| added(b.x))
            .collect();
        borders.iter().sum::<f64>() / borders.len() as f64
    };
    let [gouraud, phong, exact] =
        [ShadingMode::Gouraud, ShadingMode::Phong, ShadingMode::Exact].map(band);
    assert!(
        gouraud > 1.2 * phong && phong > 1.2 * exact,
        "{gouraud}, {phong}, {exact}"
    );
}

#[test]
fn any_line_in_any_scene_gives_numbers() {
    for preset in presets::ALL {
        let mut scene = preset.scene();
        scene.image.size = [40, 30];
        for (from, to) in [
            ([0.0, 0.0], [40.0, 30.0]),
            ([20.0, 15.0], [20.0, 30.0]),
            ([39.2, 3.3], [0.1, 29.9]),
        ] {
            let profile = taken(&scene, from, to);
            for trace in &profile.traces {
                let values = trace
                    .intensity
                    .iter()
                    .chain(&trace.slope)
                    .chain(&trace.perceived);
                assert!(
                    values.clone().all(|value| value.is_finite()),
                    "{} {:?}",
                    preset.name,
                    trace.mode
                );
                assert_eq!(trace.perceived.len(), profile.samples.len());
                assert_eq!(
                    (trace.slope.len(), trace.corners.len()),
                    (profile.samples.len(), profile.borders.len())
                );
            }
        }
    }
}

#[test]
fn a_line_that_is_none_is_refused() {
    let scene = cylinder(8);
    let asked = |from, to, modes: &[ShadingMode]| {
        let request = ProfileQuestion {
            modes: modes.to_vec(),
            ..ProfileQuestion::new(from, to)
        };
        profile(&mut Renderer::default(), &scene, &request).map(|_| ())
    };
    let (a, b) = (DVec2::new(1.0, 1.0), DVec2::new(9.0, 9.0));
    assert_eq!(
        asked(a, a, ShadingMode::VALUES),
        Err(ProfileError::NoLength)
    );
    assert_eq!(asked(a, b, &[]), Err(ProfileError::NoMode));
    for outside in [
        DVec2::new(-0.1, 3.0),
        DVec2::new(1000.1, 3.0),
        DVec2::new(f64::NAN, 3.0),
    ] {
        assert_eq!(
            asked(a, outside, ShadingMode::VALUES),
            Err(ProfileError::Outside { size: [1000, 101] })
        );
    }
    assert_eq!(
        asked(DVec2::ZERO, DVec2::new(1000.0, 101.0), ShadingMode::VALUES),
        Ok(())
    );
}

#[test]
fn what_is_perceived_of_an_even_picture_is_the_picture() {
    let mut scene = cylinder(8);
    scene.image.size = [40, 30];
    scene.image.background = Rgb::splat(0.4);
    scene.camera.target = DVec3::new(90.0, 0.0, 0.0);
    scene.camera.eye = DVec3::new(90.0, 0.0, 5.0);
    let (viewing, perception) = (Viewing::default(), Perception::default());
    let mut renderer = Renderer::default();
    let seen = perceived_picture(&mut renderer, &scene, &viewing, &perception);
    assert_eq!(seen.pixels, renderer.render(&scene).pixels);
}

#[test]
fn the_perceived_picture_agrees_with_the_profile_where_it_varies_one_way() {
    let mut scene = cylinder(24);
    scene.image.size = [400, 81];
    scene.camera.height = 0.6 * 81.0 / 160.0;
    scene.shading.mode = ShadingMode::Gouraud;
    let profile = taken(&scene, [0.0, 40.5], [400.0, 40.5]);
    let (viewing, perception) = (Viewing::default(), Perception::default());
    let seen = perceived_picture(&mut Renderer::default(), &scene, &viewing, &perception);
    let trace = trace(&profile, ShadingMode::Gouraud);
    for (sample, value) in profile.samples.iter().zip(&trace.perceived) {
        let outline = (sample.x - 200.0).abs() > 130.0;
        if outline || (sample.x.fract() - 0.5).abs() > 1e-9 {
            continue;
        }
        let [red, _, _] = seen
            .pixel(sample.x as u32, 40)
            .expect("a pixel of the picture");
        assert!(
            (f64::from(red) - 255.0 * value.min(1.0)).abs() < 1.5,
            "at {}: {red} and {value}",
            sample.x
        );
    }
}

#[test]
fn the_weights_of_a_gaussian_add_up_to_one_and_spread_as_wide_as_asked() {
    for sigma in [0.0, 0.01, 0.3, 1.0, 7.5, 40.0] {
        let impulse = line(1.0, 801, |x| f64::from(x == 0.0));
        let weights = blur_line(&impulse, sigma);
        assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-12);
        // A tent of one sample's width adds its own variance, 1/6.
        let squares = line(1.0, 801, |x| x * x);
        let variance: f64 = weights
            .iter()
            .zip(&squares)
            .map(|(weight, square)| weight * square)
            .sum();
        let expected = sigma * sigma + 1.0 / 6.0;
        assert!(
            sigma < 1.0 || (variance - expected).abs() < 1e-5 * (1.0 + expected),
            "{sigma}: {variance}"
        );
    }
}

#[test]
fn a_constant_stays_what_it_is_however_wide_the_gaussian() {
    for sigma in [0.5, 3.0, 500.0] {
        assert!(
            blur_line(&[0.7; 9], sigma)
                .iter()
                .all(|v| (v - 0.7).abs() < 1e-12)
        );
        assert!(
            blur_picture(&[0.7; 12], 4, sigma)
                .iter()
                .all(|v| (v - 0.7).abs() < 1e-12)
        );
    }
    assert!(blur_line(&[], 1.0).is_empty() && blur_picture(&[], 0, 1.0).is_empty());
}

#[test]
fn rows_and_columns_are_blurred_alike() {
    let mut values = vec![0.0; 21 * 15];
    values[7 * 21 + 10] = 1.0;
    let blurred = blur_picture(&values, 21, 1.7);
    for k in 0..7 {
        assert!((blurred[7 * 21 + 10 + k] - blurred[(7 + k) * 21 + 10]).abs() < 1e-12);
    }
    assert!((blurred.iter().sum::<f64>() - 1.0).abs() < 1e-3);
}

#[test]
fn every_pixel_centre_on_the_line_is_a_sample() {
    let mut scene = Scene::default();
    scene.image.size = [64, 64];
    for (from, to) in [
        ([0.0, 20.5], [64.0, 20.5]),
        ([10.3, 20.5], [50.0, 20.5]),
        ([60.0, 61.0], [2.0, 3.0]),
    ] {
        let samples = taken(&scene, from, to).samples;
        assert!(samples.windows(2).all(|pair| pair[0].t < pair[1].t));
        assert_eq!((samples[0].t, samples[samples.len() - 1].t), (0.0, 1.0));
        let (low, high) = (from[0].min(to[0]), from[0].max(to[0]));
        for x in (0..64)
            .map(|x| f64::from(x) + 0.5)
            .filter(|x| (low..=high).contains(x))
        {
            assert!(
                samples.iter().any(|sample| (sample.x - x).abs() < 1e-9),
                "{x} of {from:?} to {to:?}"
            );
        }
    }
    let short = taken(&scene, [3.3, 3.0], [3.4, 3.0]).samples;
    assert_eq!(short.len(), 2, "a line shorter than a step is its ends");
}

fn compared(
    profile: &Profile,
    request: &ProfileQuestion,
    own: ShadingMode,
    abscissa: Abscissa,
) -> [Plot; 3] {
    let view = Compared {
        own,
        abscissa,
        edges: true,
        perceived: true,
    };
    compared_plots(profile, request, view)
}

#[test]
fn the_plots_stand_out_for_the_own_mode_and_hold_their_curves() {
    let scene = cylinder(24);
    let request = ProfileQuestion {
        modes: vec![ShadingMode::Gouraud, ShadingMode::Phong],
        ..ProfileQuestion::new(DVec2::new(520.0, 50.5), DVec2::new(840.0, 50.5))
    };
    let profile = profile(&mut Renderer::default(), &scene, &request).expect("a line");
    let plots = compared(&profile, &request, ShadingMode::Phong, Abscissa::Distance);
    for plot in &plots {
        let strong: Vec<&str> = plot
            .curves
            .iter()
            .filter(|curve| curve.emphasised)
            .map(|curve| curve.name.as_str())
            .collect();
        assert_eq!(strong, [ShadingMode::Phong.label()], "{}", plot.title);
        // No outline on this line: no peak is cut off.
        let values = plot.curves.iter().flat_map(|curve| &curve.points);
        assert!(
            values
                .clone()
                .all(|[_, y]| (plot.y.low..=plot.y.high).contains(y)),
            "{}",
            plot.title
        );
        assert!(!plot.borders.is_empty() && plot.x.name.contains(english!("unit-pixels")));
    }
    let names: Vec<&str> = plots[0]
        .curves
        .iter()
        .map(|curve| curve.name.as_str())
        .collect();
    let keys = [
        "choice-shading-gouraud",
        "choice-shading-phong",
        "line-perceived",
    ];
    assert_eq!(names, keys.map(|key| english!(key)));
}

#[test]
fn over_x_of_the_picture_a_line_reads_the_same_both_ways() {
    let scene = cylinder(24);
    let [one, other] = [
        [[100.0, 50.5], [900.0, 50.5]],
        [[900.0, 50.5], [100.0, 50.5]],
    ]
    .map(|ends| taken(&scene, ends[0], ends[1]));
    let request = ProfileQuestion::new(DVec2::ZERO, DVec2::ONE);
    let x = Abscissa::PictureX([100.0, 900.0]);
    let [one, other] =
        [one, other].map(|profile| compared(&profile, &request, ShadingMode::Gouraud, x));
    for (a, b) in one.iter().zip(&other) {
        assert_eq!((a.x.low, a.x.high), (100.0, 900.0));
        for (a, b) in a.curves.iter().zip(&b.curves) {
            assert!(a.points.is_sorted_by(|a, b| a[0] <= b[0]), "{}", a.name);
            for x in (105..895).step_by(10) {
                let [a, b] = [a, b].map(|curve| curve.at(f64::from(x) + 0.25).expect("inside"));
                assert!((a - b).abs() < 0.02, "{x}: {a}, {b}");
            }
        }
    }
}

#[test]
fn flat_shading_has_jumps_in_place_of_a_slope() {
    let request = ProfileQuestion {
        modes: vec![ShadingMode::Flat],
        ..ProfileQuestion::new(DVec2::new(50.0, 50.5), DVec2::new(950.0, 50.5))
    };
    let profile = profile(&mut Renderer::default(), &cylinder(24), &request).expect("a line");
    let [_, slope, _] = compared(&profile, &request, ShadingMode::Flat, Abscissa::Distance);
    assert!(slope.note.contains(english!("line-jumps-note")));
    let jumps = slope.curves[0]
        .points
        .iter()
        .filter(|[_, y]| y.abs() > 1e-3)
        .count();
    assert!(jumps >= 10, "{jumps}");
    assert!(slope.y.high - slope.y.low > 0.01, "{:?}", slope.y);
}

#[test]
fn a_plots_axis_lies_where_it_is_told_to() {
    let profile = taken(&cylinder(24), [100.0, 50.5], [900.0, 50.5]);
    let request = ProfileQuestion::new(DVec2::ZERO, DVec2::ONE);
    let x = Abscissa::PictureX([100.0, 900.0]);
    let style = PlotStyle {
        paper: Paper::DARK,
        text: 12.6,
        titled: false,
    };
    for span in [[100.0, 900.0], [3.0, 999.0]] {
        for plot in compared(&profile, &request, ShadingMode::Gouraud, x) {
            let drawing = lay_out_bare(&plot, DVec2::new(1000.0, 200.0), Some(span), &style);
            for (share, at) in [
                (0.0, span[0]),
                (0.5, 0.5 * (span[0] + span[1])),
                (1.0, span[1]),
            ] {
                let (place, _) = drawing
                    .place([100.0 + 800.0 * share, plot.y.low])
                    .expect("a plot");
                assert!((place.x - at).abs() < 1e-9, "{place} is not at {at}");
            }
            for text in &drawing.texts {
                let left = text.at.x - text.align * text.width();
                assert!(left >= 0.0, "{text:?}");
            }
        }
    }
}

#[test]
fn too_many_edges_are_left_out_with_a_word() {
    let scene = cylinder(192);
    let profile = taken(&scene, [100.0, 50.5], [900.0, 50.5]);
    let request = ProfileQuestion::new(DVec2::ZERO, DVec2::ONE);
    let [plot, ..] = compared(&profile, &request, ShadingMode::Gouraud, Abscissa::Distance);
    let style = PlotStyle {
        paper: Paper::DARK,
        text: 12.6,
        titled: false,
    };
    let crowded = english!("line-edges-crowded", count = "|");
    let (_, close) = crowded.split_once('|').expect("a number");
    let words = |width: f64| {
        let drawing = lay_out_bare(&plot, DVec2::new(width, 200.0), None, &style);
        let mut texts = drawing.texts.into_iter().map(|text| text.text);
        texts.find(|text| text.contains(close))
    };
    assert_eq!(words(1200.0), None);
    let count = plot.borders.len();
    assert!(words(280.0).is_some_and(|text| text.starts_with(&count.to_string())));
}
