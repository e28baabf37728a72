//! The overlay of vectors and angles, on a sphere whose points and normals are known in closed form.

mod extremes;

use crate::common::properties;
use glam::{DVec2, DVec3};
use proptest::prelude::*;
use shading_lab::analysis::overlay::{Halo, OverlayLayer, OverlayOptions};
use shading_lab::analysis::probe::{
    Angle, ArrowHead, LightTerms, Overlay, Probe, ProbeHit, ZeroCauses, draw_overlay,
};
use shading_lab::analysis::scan::{face_at, lay_out_scan, scan, scan_room};
use shading_lab::figure::{Area, Paper, PlotStyle, palette};
use shading_lab::render::Renderer;
use shading_lab::scene::{
    Light, LightKind, Projection, ReflectionModel, Rgb, Scene, ShadingMode, View, Viewer,
};
use tiny_skia::Pixmap;

/// Returns the point where the ray through `pixel` meets the unit sphere.
fn meet(view: &View, pixel: DVec2) -> Option<DVec3> {
    let (origin, along) = view.ray(pixel);
    let half = origin.dot(along);
    let root = half * half - origin.length_squared() + 1.0;
    (root >= 0.0).then(|| origin + along * (-half - root.sqrt()))
}

fn terms(scene: &Scene, light: &Light, position: DVec3, n: DVec3, v: DVec3) -> LightTerms {
    let l = match light.kind {
        LightKind::Directional => -light.direction.normalize(),
        _ => (light.position - position).normalize(),
    };
    let (r, h) = (2.0 * n.dot(l) * n - l, (l + v).normalize());
    let (phi, alpha) = (r.angle_between(v), n.angle_between(h));
    let lobe = match scene.reflection.model {
        ReflectionModel::Phong | ReflectionModel::Formula => phi,
        ReflectionModel::Blinn | ReflectionModel::CookTorrance => alpha,
    };
    let lit = if n.dot(l) > 0.0 { 1.0 } else { 0.0 };
    let diffuse = light.color * scene.material.kd * scene.material.color * n.dot(l) * lit;
    let specular =
        light.color * scene.material.ks * lobe.cos().max(0.0).powf(scene.material.n) * lit;
    let theta = n.angle_between(l);
    LightTerms {
        kind: light.kind,
        l,
        r,
        h,
        n_dot_l: n.dot(l),
        theta,
        phi,
        alpha,
        attenuation: 1.0,
        spot: 1.0,
        reflectance: Rgb::ONE,
        incidence: theta,
        reached: 1.0,
        diffuse,
        specular,
        diffuse_zero: ZeroCauses::default(),
        specular_zero: ZeroCauses::default(),
        law: None,
    }
}

/// Probes a pixel of the sphere.
fn probe_at(scene: &Scene, size: [u32; 2], pixel: [u32; 2]) -> Probe {
    let view = View::new(&scene.camera, size);
    let hit = meet(
        &view,
        DVec2::new(f64::from(pixel[0]) + 0.5, f64::from(pixel[1]) + 0.5),
    )
    .map(|position| {
        let v = match scene.camera.viewer {
            Viewer::Local => view.towards_eye(position),
            Viewer::Infinite => -view.forward,
        };
        let lights: Vec<_> = scene
            .lights
            .iter()
            .map(|light| terms(scene, light, position, position, v))
            .collect();
        let ambient = scene.material.ka * scene.material.color * scene.ambient.color;
        let sum = lights
            .iter()
            .fold(ambient, |sum, light| sum + light.diffuse + light.specular);
        let depth = (position - view.eye).dot(view.forward);
        let stored = sum
            .to_array()
            .map(|channel| (channel.clamp(0.0, 1.0) * 255.0).round() as u8);
        let (reflected, transmission) = (sum, None);
        ProbeHit {
            position,
            normal: position,
            view: v,
            depth,
            face: None,
            material: None,
            tint: None,
            ambient,
            bounced: false,
            color: scene.material.color,
            lights,
            reflected,
            transmission,
            intensity: sum,
            cue: None,
            sum,
            divisor: 1.0,
            stored,
        }
    });
    Probe {
        pixel,
        hit,
        ambient_fit: None,
    }
}

/// Draws the sphere as it would be stored.
fn picture(scene: &Scene, size: [u32; 2]) -> Pixmap {
    let mut pixmap = Pixmap::new(size[0], size[1]).expect("not empty");
    let background = scene.image.background.to_array().map(|c| (c * 255.0) as u8);
    for y in 0..size[1] {
        for x in 0..size[0] {
            let stored = probe_at(scene, size, [x, y])
                .hit
                .map_or(background, |hit| hit.stored);
            let colour =
                tiny_skia::ColorU8::from_rgba(stored[0], stored[1], stored[2], 255).premultiply();
            pixmap.pixels_mut()[(y * size[0] + x) as usize] = colour;
        }
    }
    pixmap
}

fn three_lights() -> Vec<Light> {
    vec![
        Light::default(),
        Light {
            position: DVec3::new(-2.5, 1.0, 1.5),
            color: Rgb::new(0.3, 0.4, 0.7),
            ..Light::default()
        },
        Light {
            kind: LightKind::Directional,
            direction: DVec3::new(-0.2, 1.0, -0.4),
            color: Rgb::splat(0.3),
            ..Light::default()
        },
    ]
}

/// Returns the options of an overlay with every layer.
fn everything() -> OverlayOptions {
    OverlayOptions {
        layers: OverlayLayer::ALL.to_vec(),
        ..OverlayOptions::default()
    }
}

fn near(a: DVec2, b: DVec2, tolerance: f64) -> bool {
    (a - b).length() <= tolerance
}

#[test]
fn arrows_end_where_the_vectors_end() {
    let scene = Scene {
        lights: three_lights(),
        ..Scene::default()
    };
    let probe = probe_at(&scene, [768, 768], [420, 230]);
    let hit = probe.hit.as_ref().expect("on the sphere");
    let options = OverlayOptions {
        length: Some(0.6),
        ..everything()
    };
    let overlay = Overlay::new([768, 768], &scene, &probe, &options);
    let view = View::new(&scene.camera, [768, 768]);
    let lights = &hit.lights;
    let vectors = [
        hit.normal,
        lights[0].l,
        lights[0].r,
        hit.view,
        lights[1].l,
        lights[2].l,
    ];
    assert_eq!(overlay.arrows.len(), vectors.len());
    for (arrow, vector) in overlay.arrows.iter().zip(vectors) {
        let (tip, _) = view
            .project(hit.position + vector * 0.6)
            .expect("in front of the eye");
        assert!(
            near(arrow.tip, tip, 2e-3),
            "{:?} should end at {tip}",
            arrow
        );
        assert!(near(arrow.tail, DVec2::new(420.5, 230.5), 1e-6));
    }
}

#[test]
fn a_unit_vector_across_the_line_of_sight_is_about_a_fifth_of_the_shorter_side() {
    let scene = Scene::default();
    let probe = probe_at(&scene, [900, 600], [450 + 206, 300]);
    let overlay = Overlay::new([900, 600], &scene, &probe, &OverlayOptions::default());
    let n = &overlay.arrows[0];
    assert_eq!(n.vector, palette::Vector::N);
    let share = (n.tip - n.tail).length() / 600.0;
    assert!((0.15..0.21).contains(&share), "{share}");
}

#[test]
fn v_is_seen_from_the_front_and_a_vector_into_the_picture_from_behind() {
    let mut scene = Scene::default();
    scene.lights[0].kind = LightKind::Directional;
    scene.lights[0].direction = DVec3::Z;
    scene.camera.projection = Projection::Orthographic;
    let probe = probe_at(&scene, [200, 200], [130, 90]);
    let overlay = Overlay::new([200, 200], &scene, &probe, &OverlayOptions::default());
    let head = |letter| {
        overlay
            .arrows
            .iter()
            .find(|arrow| arrow.vector == letter)
            .map(|arrow| arrow.head)
    };
    assert_eq!(head(palette::Vector::V), Some(ArrowHead::Towards));
    assert_eq!(head(palette::Vector::L), Some(ArrowHead::Away));
    assert_eq!(head(palette::Vector::N), Some(ArrowHead::Plain));
    assert_eq!(
        head(palette::Vector::R),
        None,
        "there is no reflection of a light behind the surface"
    );
}

#[test]
fn arcs_run_from_arrow_to_arrow() {
    let scene = Scene::default();
    let probe = probe_at(&scene, [600, 600], [240, 250]);
    let overlay = Overlay::new([600, 600], &scene, &probe, &OverlayOptions::default());
    let tip = |letter| {
        overlay
            .arrows
            .iter()
            .find(|arrow| arrow.vector == letter)
            .expect("drawn")
            .tip
    };
    let origin = overlay.arrows[0].tail;
    let on_shaft = |point: DVec2, letter| {
        let along = (tip(letter) - origin).normalize_or_zero();
        along.perp_dot(point - origin).abs() < 1e-6 && along.dot(point - origin) > 0.0
    };
    let arc = |angle| {
        overlay
            .arcs
            .iter()
            .find(|arc| arc.angle == angle)
            .expect("drawn")
    };
    for (angle, ends) in [
        (Angle::Theta, palette::Vector::L),
        (Angle::Mirror, palette::Vector::R),
    ] {
        let points = &arc(angle).points;
        assert!(
            on_shaft(points[0], palette::Vector::N) && on_shaft(points[points.len() - 1], ends),
            "{angle:?}"
        );
        assert!(!arc(angle).edge_on);
    }
    assert!(
        arc(Angle::Phi).edge_on,
        "the plane of R and V holds the line of sight"
    );
    let hit = probe.hit.expect("on the sphere");
    let theta = format!("θ {:.1}°", hit.lights[0].theta.to_degrees());
    let phi = format!("φ {:.1}°", hit.lights[0].phi.to_degrees());
    for text in [theta, phi] {
        assert!(
            overlay.labels.iter().any(|label| label.text == text),
            "{text} in {:?}",
            overlay.labels
        );
    }
}

#[test]
fn only_the_chosen_light_has_a_reflection_and_its_number() {
    let scene = Scene {
        lights: three_lights(),
        ..Scene::default()
    };
    let probe = probe_at(&scene, [768, 768], [330, 330]);
    let options = OverlayOptions {
        light: Some(1),
        ..OverlayOptions::default()
    };
    let overlay = Overlay::new([768, 768], &scene, &probe, &options);
    let texts: Vec<&str> = overlay
        .labels
        .iter()
        .map(|label| label.text.as_str())
        .collect();
    for text in ["N", "V", "L₁", "L₂", "L₃", "R₂"] {
        assert!(texts.contains(&text), "{text} in {texts:?}");
    }
    assert!(!texts.contains(&"R₁"));
    assert!(
        overlay
            .arrows
            .iter()
            .all(|arrow| arrow.emphasised == (arrow.light.is_none_or(|light| light == 1)))
    );
    let none = Overlay::new(
        [768, 768],
        &scene,
        &probe,
        &OverlayOptions {
            light: Some(7),
            ..options
        },
    );
    assert!(
        none.arrows
            .iter()
            .any(|arrow| arrow.vector == palette::Vector::R && arrow.light == Some(0))
    );
}

#[test]
fn h_belongs_to_blinns_model_or_is_asked_for() {
    let mut scene = Scene::default();
    let shows_h = |scene: &Scene, half_vector| {
        let probe = probe_at(scene, [300, 300], [140, 140]);
        let options = OverlayOptions {
            half_vector,
            ..OverlayOptions::default()
        };
        let overlay = Overlay::new([300, 300], scene, &probe, &options);
        overlay
            .arrows
            .iter()
            .any(|arrow| arrow.vector == palette::Vector::H)
    };
    assert!(!shows_h(&scene, false) && shows_h(&scene, true));
    scene.reflection.model = ReflectionModel::Blinn;
    assert!(shows_h(&scene, false));
}

#[test]
fn every_vector_is_seen_in_its_colour() {
    let mut scene = Scene::default();
    scene.reflection.model = ReflectionModel::Blinn;
    scene.lights[0].position = DVec3::new(-2.0, 3.0, 2.0);
    let probe = probe_at(&scene, [600, 600], [330, 240]);
    let mut pixmap = Pixmap::new(600, 600).expect("not empty");
    draw_overlay(
        &mut pixmap.as_mut(),
        &scene,
        &probe,
        &OverlayOptions::default(),
    );
    for colour in [
        palette::Vector::N.colour(),
        palette::Vector::L.colour(),
        palette::Vector::R.colour(),
        palette::Vector::V.colour(),
        palette::Vector::H.colour(),
        [255; 3],
        [24; 3],
    ] {
        let inked = pixmap
            .pixels()
            .iter()
            .filter(|p| [p.red(), p.green(), p.blue()] == colour)
            .count();
        assert!(inked > 100, "{inked} pixels of {colour:?}");
    }
    let bare = pixmap.pixels().iter().filter(|p| p.alpha() == 0).count();
    assert!(
        bare > 600 * 600 * 9 / 10,
        "the picture is still to be seen: {bare} pixels untouched"
    );
}

#[test]
fn lights_stand_where_they_appear_or_at_the_edge_towards_them() {
    let mut scene = Scene {
        lights: three_lights(),
        ..Scene::default()
    };
    scene.lights[1].position = DVec3::new(-0.9, 0.8, 0.5);
    scene.lights.push(Light {
        position: DVec3::new(3.0, 0.0, 9.0),
        ..Light::default()
    });
    let nothing = Probe {
        pixel: [0, 0],
        hit: None,
        ambient_fit: None,
    };
    let overlay = Overlay::new([500, 400], &scene, &nothing, &everything());
    let view = View::new(&scene.camera, [500, 400]);
    assert_eq!(overlay.lights.len(), 4);
    let (shown, _) = view
        .project(scene.lights[1].position)
        .expect("in front of the eye");
    assert!(near(overlay.lights[1].pixel, shown, 1e-9) && !overlay.lights[1].outside);
    let above_right = &overlay.lights[0];
    assert!(
        above_right.outside && above_right.pixel.x > 400.0 && above_right.pixel.y < 100.0,
        "{above_right:?}"
    );
    let behind_right = &overlay.lights[3];
    assert!(
        behind_right.outside
            && behind_right.pixel.x > 400.0
            && near(
                behind_right.pixel,
                DVec2::new(behind_right.pixel.x, 200.0),
                1e-6
            )
    );
    let rays = &overlay.lights[2];
    assert!(
        !rays.outside && rays.pixel.y > 200.0,
        "the light that travels upwards comes from below: {rays:?}"
    );
    let texts: Vec<&str> = overlay
        .labels
        .iter()
        .map(|label| label.text.as_str())
        .collect();
    assert_eq!(texts, ["1", "2", "3", "4"]);
}

#[test]
fn nothing_is_drawn_where_the_probe_met_nothing() {
    let scene = Scene::default();
    let mut pixmap = Pixmap::new(64, 64).expect("not empty");
    let nothing = Probe {
        pixel: [0, 0],
        hit: None,
        ambient_fit: None,
    };
    draw_overlay(
        &mut pixmap.as_mut(),
        &scene,
        &nothing,
        &OverlayOptions::default(),
    );
    assert!(pixmap.data().iter().all(|byte| *byte == 0));
}

#[test]
fn the_same_overlay_has_the_same_pixels() {
    let scene = Scene {
        lights: three_lights(),
        ..Scene::default()
    };
    let probe = probe_at(&scene, [320, 240], [150, 110]);
    let draw = || {
        let mut pixmap = Pixmap::new(320, 240).expect("not empty");
        draw_overlay(&mut pixmap.as_mut(), &scene, &probe, &everything());
        pixmap
    };
    assert_eq!(draw(), draw());
}

#[test]
fn the_side_view_writes_angles_and_covers_the_picture_only_where_it_may() {
    let mut scene = Scene::default();
    scene.lights[0].position = scene.camera.eye + DVec3::new(0.6, 0.6, 0.0);
    let probe = probe_at(&scene, [768, 768], [384, 384]);
    let options = OverlayOptions {
        layers: vec![OverlayLayer::Vectors, OverlayLayer::SideView],
        ..OverlayOptions::default()
    };
    let angles = |options: &OverlayOptions| {
        let overlay = Overlay::new([768, 768], &scene, &probe, options);
        assert!(overlay.side_view.is_some());
        let labels = overlay.labels.iter();
        labels.filter(|label| label.text.contains('°')).count()
    };
    assert!(angles(&options) > 0);
    let without = OverlayOptions {
        side_view_angles: false,
        ..options.clone()
    };
    assert_eq!(angles(&without), 0);

    // Where it is not asked for but only needed, it keeps to free corners.
    let pane = |free_corners| {
        let options = OverlayOptions {
            layers: vec![OverlayLayer::Vectors],
            side_view_where_needed: true,
            free_corners,
            ..options.clone()
        };
        Overlay::new([768, 768], &scene, &probe, &options).side_view
    };
    let anywhere = pane(None).expect("N, L and R point at the viewer");
    assert!(anywhere.max.x - anywhere.min.x > 200.0);
    let kept = pane(Some([250, 0, 0, 0])).expect("room enough");
    assert!(kept.max.max_element() <= 250.0);
    assert_eq!(pane(Some([30; 4])), None);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, ..properties::config(file!()) })]

    #[test]
    fn labels_are_inside_the_picture_and_apart(
        size in prop::array::uniform2(1u32..1200),
        place in prop::array::uniform2(0.0..1.0),
        eye in prop::array::uniform3(-4.0..4.0),
        light in prop::array::uniform3(-4.0..4.0),
        options in (any::<bool>(), any::<bool>(), prop::option::of(0usize..4), 0.3..3.0),
    ) {
        let (dark, half_vector, chosen, scale) = options;
        let mut scene = Scene { lights: three_lights(), ..Scene::default() };
        scene.camera.eye = DVec3::from_array(eye).normalize_or(DVec3::Z) * 4.0;
        scene.lights[1].position = DVec3::from_array(light);
        let pixel = [0, 1].map(|axis| (place[axis] * f64::from(size[axis])) as u32);
        let halo = if dark { Halo::Dark } else { Halo::Light };
        let options = OverlayOptions { light: chosen, half_vector, halo, scale, ..everything() };
        let overlay = Overlay::new(size, &scene, &probe_at(&scene, size, pixel), &options);
        let picture = Area { min: DVec2::ZERO, max: DVec2::from_array(size.map(f64::from)) };
        for (i, label) in overlay.labels.iter().enumerate() {
            prop_assert!(picture.holds(&label.area), "{label:?} in {size:?}");
            for other in overlay.labels.iter().skip(i + 1) {
                prop_assert!(!label.area.overlaps(&other.area), "{label:?} and {other:?}");
            }
        }
        for light in &overlay.lights {
            prop_assert!(picture.nearest(light.pixel) == light.pixel, "{light:?} in {size:?}");
        }
    }

    #[test]
    fn a_picture_of_usual_size_has_all_its_letters(place in prop::array::uniform2(0.0..1.0)) {
        let scene = Scene { lights: three_lights(), ..Scene::default() };
        let pixel = place.map(|share| (share * 768.0) as u32);
        let probe = probe_at(&scene, [768, 768], pixel);
        let overlay = Overlay::new([768, 768], &scene, &probe, &OverlayOptions::default());
        let lettered = overlay.labels.iter().filter(|label| !label.text.contains('°')).count();
        prop_assert_eq!(lettered, overlay.arrows.len());
    }
}

#[test]
#[ignore = "draws pictures to look at into the directory that SHADING_LAB_PICTURES names"]
fn pictures_to_look_at() {
    let directory =
        std::env::var("SHADING_LAB_PICTURES").expect("SHADING_LAB_PICTURES names a directory");
    let all = OverlayOptions {
        layers: OverlayLayer::ALL.to_vec(),
        ..OverlayOptions::default()
    };
    let simple = OverlayOptions::default();
    let several = Scene {
        lights: three_lights(),
        ..Scene::default()
    };
    let mut blinn = Scene::default();
    blinn.reflection.model = ReflectionModel::Blinn;
    let mut white = Scene::default();
    white.image.background = Rgb::ONE;
    white.material.color = Rgb::splat(0.8);
    let dark = OverlayOptions {
        halo: Halo::Dark,
        ..all.clone()
    };
    let views: [(&str, &Scene, &OverlayOptions, [f64; 2]); 9] = [
        ("dark-halo", &Scene::default(), &dark, [0.40, 0.42]),
        ("white-dark-halo", &white, &dark, [0.7, 0.6]),
        ("simple", &Scene::default(), &simple, [0.62, 0.35]),
        ("all", &Scene::default(), &all, [0.40, 0.42]),
        ("several", &several, &all, [0.55, 0.30]),
        ("blinn", &blinn, &all, [0.6, 0.55]),
        ("white", &white, &all, [0.7, 0.6]),
        ("edge", &several, &simple, [0.82, 0.5]),
        ("centre", &Scene::default(), &all, [0.5, 0.5]),
    ];
    for (name, scene, options, place) in views {
        for side in [300, 768, 1600] {
            let pixel = place.map(|share| (share * f64::from(side)) as u32);
            let mut pixmap = picture(scene, [side, side]);
            let probe = probe_at(scene, [side, side], pixel);
            let start = std::time::Instant::now();
            draw_overlay(&mut pixmap.as_mut(), scene, &probe, options);
            println!("{name} {side}: {:?}", start.elapsed());
            pixmap
                .save_png(format!("{directory}/{name}-{side}.png"))
                .expect("the picture is written");
        }
    }
}

/// Draws every step of a few polygons, with and without a title, and checks that all of it lies on the sheet.
#[test]
fn every_step_is_drawn_within_its_room() {
    let mut scene = Scene::default();
    scene.image.size = [96, 96];
    let mut renderer = Renderer::default();
    for (mode, pixel) in [
        (ShadingMode::Gouraud, [40, 30]),
        (ShadingMode::Phong, [70, 66]),
    ] {
        scene.shading.mode = mode;
        let face = face_at(&mut renderer, &scene, pixel[0], pixel[1]).expect("the sphere");
        let scan = scan(&mut renderer, &scene, face, 12).expect("a polygon in sight");
        for titled in [true, false] {
            let style = PlotStyle {
                paper: Paper::DARK,
                text: 14.0,
                titled,
            };
            let room = scan_room(&scan, 300.0, 260.0, &style);
            let size = if titled {
                DVec2::new(672.0, 520.0)
            } else {
                room
            };
            for step in 0..=scan.last() {
                let drawing = lay_out_scan(&scan, step, size, &style);
                let inside =
                    |place: DVec2| place.cmpge(DVec2::ZERO).all() && place.cmple(size).all();
                for text in &drawing.texts {
                    let left = text.at - DVec2::new(text.align * text.width(), 0.0);
                    let right = left + DVec2::new(text.width(), 0.0);
                    assert!(inside(left) && inside(right), "{mode:?} {step}: {text:?}");
                }
                assert!(
                    drawing
                        .shapes
                        .iter()
                        .flat_map(|shape| &shape.points)
                        .all(|place| inside(*place))
                );
            }
        }
    }
}

/// Checks that the drawing begins with the pixels shaded so far; lines and letters cross a few of them.
#[test]
fn the_filled_pixels_have_the_stored_colours() {
    let mut scene = Scene::default();
    scene.image.size = [96, 96];
    let mut renderer = Renderer::default();
    let face = face_at(&mut renderer, &scene, 40, 30).expect("the sphere");
    let scan = scan(&mut renderer, &scene, face, 12).expect("a polygon in sight");
    let style = PlotStyle {
        paper: Paper::LIGHT,
        text: 2.0,
        titled: false,
    };
    let drawing = lay_out_scan(&scan, scan.last(), DVec2::new(600.0, 400.0), &style);
    let frame = drawing.to_frame().expect("a picture");
    let (mut found, mut all) = (0, 0);
    for ((_, pixel), square) in scan.filled(scan.last()).zip(&drawing.shapes) {
        assert_eq!((square.fill, square.colour), (true, pixel.stored));
        let place = square.points[0].lerp(square.points[2], 0.3);
        found += usize::from(frame.pixel(place.x as u32, place.y as u32) == Some(pixel.stored));
        all += 1;
    }
    assert!(
        all > 50 && found * 10 >= all * 7,
        "{found} of {all}; edges cross the others"
    );
    assert!(drawing.to_svg("a polygon").contains("<polygon"));
}
