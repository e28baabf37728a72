//! While only coefficients change, what each of a few lights does is not evaluated again, and the picture is the same.

use glam::DVec3;
use shading_lab::render::{Frame, Renderer, Stage};
use shading_lab::scene::{Attenuation, Light, LightKind, PatternKind, ReflectionModel, Rgb, Scene, ShadingMode};

fn light(kind: LightKind, position: DVec3, color: Rgb) -> Light {
    Light { kind, position, direction: -position, color, cone: 40.0, softness: 0.5, ..Light::default() }
}

/// Two to four lights of different kinds, with what else the kernels choose between.
fn scenes() -> Vec<(&'static str, Scene)> {
    let mut scene = Scene::default();
    scene.image.size = [150, 110];
    scene.lights = vec![
        light(LightKind::Point, DVec3::new(3.0, 4.0, 4.0), Rgb::new(0.9, 0.7, 0.5)),
        light(LightKind::Directional, DVec3::new(-3.0, 1.0, 2.0), Rgb::new(0.2, 0.4, 0.9)),
    ];
    let mut all = vec![("two lights", scene.clone())];
    let mut three = scene.clone();
    three.lights.push(light(LightKind::Spot, DVec3::new(0.0, -3.0, 3.0), Rgb::ONE));
    three.lights[0].attenuation = Attenuation::Quadratic;
    three.reflection.model = ReflectionModel::Blinn;
    all.push(("a spot light and Blinn's model", three.clone()));
    let mut shadows = three.clone();
    (shadows.shading.shadows, shadows.ground.visible) = (true, true);
    all.push(("shadows and a floor", shadows));
    let mut four = three;
    four.lights.push(light(LightKind::Point, DVec3::new(1.0, 0.0, 5.0), Rgb::new(0.1, 0.5, 0.1)));
    four.pattern.kind = PatternKind::Checker;
    four.material.n = 300.0;
    all.push(("a pattern and a narrow lobe", four));
    let mut exact = scene;
    exact.shading.mode = ShadingMode::Exact;
    all.push(("the true surface", exact));
    all
}

fn anew(scene: &Scene) -> Frame {
    Renderer::default().render(scene).clone()
}

/// Evaluations of the equation at pixels in the last picture.
fn evaluations(renderer: &Renderer) -> u64 {
    renderer.report().stages.iter().filter(|run| run.stage == Stage::PixelShading).map(|run| run.evaluations).sum()
}

/// Changes one coefficient or colour.
type Change = fn(&mut Scene, f64);

const CHANGES: [Change; 6] = [
    |scene, v| scene.material.ka = Rgb::splat(v),
    |scene, v| scene.material.kd = Rgb::splat(v),
    |scene, v| scene.material.ks = Rgb::splat(0.3 + 0.5 * v),
    |scene, v| scene.material.color = Rgb::new(v, 1.0 - v, 0.5),
    |scene, v| scene.lights[1].color = Rgb::new(0.4, v, 0.8),
    |scene, v| scene.ambient.color = Rgb::new(v, 0.2, 1.0 - v),
];

#[test]
fn coefficients_change_the_picture_without_the_lights() {
    for (name, mut scene) in scenes() {
        scene.shading.mode =
            if scene.shading.mode == ShadingMode::Exact { ShadingMode::Exact } else { ShadingMode::Phong };
        assert_eq!(scene.validate(), Ok(()), "{name}");
        let mut renderer = Renderer::default();
        renderer.render(&scene);
        assert!(evaluations(&renderer) > 1000, "{name}");
        for (step, change) in CHANGES.iter().cycle().take(2 * CHANGES.len()).enumerate() {
            change(&mut scene, 0.15 + 0.06 * step as f64);
            let picture = renderer.render(&scene).pixels.clone();
            assert!(picture == anew(&scene).pixels, "{name}, change {step}");
            assert_eq!(evaluations(&renderer) == 0, step > 0, "{name}, change {step}");
        }
        // What the factors depend on is heeded.
        scene.material.n += 5.0;
        assert!(renderer.render(&scene).pixels == anew(&scene).pixels, "{name}, n");
        assert!(evaluations(&renderer) > 1000, "{name}, n");
        scene.lights[0].position.x -= 1.0;
        assert!(renderer.render(&scene).pixels == anew(&scene).pixels, "{name}, a light");
        scene.camera.eye.x += 0.5;
        assert!(renderer.render(&scene).pixels == anew(&scene).pixels, "{name}, the camera");
        scene.lights[1].mute = true;
        assert!(renderer.render(&scene).pixels == anew(&scene).pixels, "{name}, muted");
    }
}

#[test]
fn a_single_light_and_fresnels_law_are_evaluated() {
    let mut scene = Scene::default();
    scene.image.size = [64, 64];
    let mut renderer = Renderer::default();
    for step in 1..4 {
        scene.material.kd = Rgb::splat(0.2 * f64::from(step));
        assert!(renderer.render(&scene).pixels == anew(&scene).pixels);
        assert!(evaluations(&renderer) > 100);
    }
}
