//! The overlay of vectors and angles, on a sphere whose points and normals are known in closed form.

use glam::{DVec2, DVec3};
use proptest::prelude::*;
use shading_lab::analysis::{LightTerms, Probe, ProbeHit};
use shading_lab::figure::{ArrowHead, Halo, Overlay, OverlayLayer, OverlayOptions, draw_overlay, palette};
use shading_lab::scene::{Light, LightKind, Projection, ReflectionModel, Rgb, Scene, View, Viewer};
use tiny_skia::{Color, Pixmap};

/// Where the ray through `pixel` meets the unit sphere.
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
    let phi = if scene.reflection.model == ReflectionModel::Blinn { n.angle_between(h) } else { r.angle_between(v) };
    let lit = if n.dot(l) > 0.0 { 1.0 } else { 0.0 };
    let diffuse = light.color * scene.material.kd * scene.material.color * n.dot(l) * lit;
    let specular = light.color * scene.material.ks * phi.cos().max(0.0).powf(scene.material.n) * lit;
    let theta = n.angle_between(l);
    LightTerms { kind: light.kind, l, r, h, n_dot_l: n.dot(l), theta, phi, attenuation: 1.0, diffuse, specular }
}

/// The equation at a pixel of the sphere.
fn probe_at(scene: &Scene, size: [u32; 2], pixel: [u32; 2]) -> Probe {
    let view = View::new(&scene.camera, size);
    let hit = meet(&view, DVec2::new(f64::from(pixel[0]) + 0.5, f64::from(pixel[1]) + 0.5)).map(|position| {
        let v = match scene.camera.viewer {
            Viewer::Local => view.towards_eye(position),
            Viewer::Infinite => -view.forward,
        };
        let lights: Vec<_> = scene.lights.iter().map(|light| terms(scene, light, position, position, v)).collect();
        let ambient = scene.material.ka * scene.material.color * scene.ambient.color;
        let sum = lights.iter().fold(ambient, |sum, light| sum + light.diffuse + light.specular);
        let depth = (position - view.eye).dot(view.forward);
        let stored = sum.to_array().map(|channel| (channel.clamp(0.0, 1.0) * 255.0).round() as u8);
        ProbeHit { position, normal: position, view: v, depth, face: None, ambient, lights, sum, stored }
    });
    Probe { pixel, hit }
}

/// The sphere as it would be stored.
fn picture(scene: &Scene, size: [u32; 2]) -> Pixmap {
    let mut pixmap = Pixmap::new(size[0], size[1]).expect("not empty");
    let background = scene.image.background.to_array().map(|c| (c * 255.0) as u8);
    for y in 0..size[1] {
        for x in 0..size[0] {
            let stored = probe_at(scene, size, [x, y]).hit.map_or(background, |hit| hit.stored);
            let colour = tiny_skia::ColorU8::from_rgba(stored[0], stored[1], stored[2], 255).premultiply();
            pixmap.pixels_mut()[(y * size[0] + x) as usize] = colour;
        }
    }
    pixmap
}

fn three_lights() -> Vec<Light> {
    vec![
        Light::default(),
        Light { position: DVec3::new(-2.5, 1.0, 1.5), color: Rgb::new(0.3, 0.4, 0.7), ..Light::default() },
        Light {
            kind: LightKind::Directional,
            direction: DVec3::new(-0.2, 1.0, -0.4),
            color: Rgb::splat(0.3),
            ..Light::default()
        },
    ]
}

#[test]
#[ignore = "draws pictures to look at into the directory that SHADING_LAB_PICTURES names"]
fn pictures_to_look_at() {
    let directory = std::env::var("SHADING_LAB_PICTURES").expect("SHADING_LAB_PICTURES names a directory");
    let all = OverlayOptions { layers: OverlayLayer::ALL.to_vec(), ..OverlayOptions::default() };
    let simple = OverlayOptions::default();
    let several = Scene { lights: three_lights(), ..Scene::default() };
    let mut blinn = Scene::default();
    blinn.reflection.model = ReflectionModel::Blinn;
    let mut white = Scene::default();
    white.image.background = Rgb::ONE;
    white.material.color = Rgb::splat(0.8);
    let dark = OverlayOptions { halo: Halo::Dark, ..all.clone() };
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
            draw_overlay(&mut pixmap.as_mut(), scene, &probe_at(scene, [side, side], pixel), options);
            pixmap.save_png(format!("{directory}/{name}-{side}.png")).expect("the picture is written");
        }
    }
}
