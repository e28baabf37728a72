//! The picture turned about the line of sight.

use shading_lab::analysis::probe::probe;
use shading_lab::render::Renderer;
use shading_lab::scene::{Camera, Scene, ShadingMode, presets};

const SIDE: usize = 96;

fn scene(name: &str) -> Scene {
    let mut scene = presets::find(name).expect("a built-in scene").scene();
    scene.image.size = [SIDE as u32; 2];
    scene
}

fn rolled(scene: &Scene, roll: f64) -> Scene {
    Scene {
        camera: Camera {
            roll,
            ..scene.camera.clone()
        },
        ..scene.clone()
    }
}

fn picture(scene: &Scene) -> Vec<[u8; 4]> {
    Renderer::default().render(scene).pixels.clone()
}

/// Turns the picture counter-clockwise by a quarter: its right side becomes the top.
fn turned(pixels: &[[u8; 4]]) -> Vec<[u8; 4]> {
    let from = |x: usize, y: usize| pixels[x * SIDE + SIDE - 1 - y];
    (0..SIDE * SIDE)
        .map(|at| from(at % SIDE, at / SIDE))
        .collect()
}

/// Counts the pixels that differ by more than rounding.
fn differences(a: &[[u8; 4]], b: &[[u8; 4]]) -> usize {
    let far = |(a, b): &(&[u8; 4], &[u8; 4])| a.iter().zip(*b).any(|(a, b)| a.abs_diff(*b) > 1);
    a.iter().zip(b).filter(far).count()
}

#[test]
fn a_quarter_turn_of_the_camera_is_a_quarter_turn_of_the_picture() {
    for name in ["cube", "plane", "shadows"] {
        for mode in [
            ShadingMode::Flat,
            ShadingMode::Gouraud,
            ShadingMode::Phong,
            ShadingMode::Exact,
        ] {
            let mut scene = scene(name);
            scene.shading.mode = mode;
            let mut expected = picture(&scene);
            for quarter in 1..4u8 {
                expected = turned(&expected);
                let found = picture(&rolled(&scene, 90.0 * f64::from(quarter)));
                let edges = differences(&expected, &found);
                assert!(
                    edges <= SIDE * SIDE / 200,
                    "{name}, {mode:?}, {quarter} quarters: {edges} pixels differ"
                );
            }
            assert!(
                differences(&picture(&scene), &expected) > SIDE * SIDE / 50,
                "{name}: there is something to turn"
            );
            assert!(picture(&rolled(&scene, -720.0)) == picture(&scene));
        }
    }
}

#[test]
fn the_probe_turns_with_the_picture() {
    let scene = scene("plane");
    let at = |roll: f64, x: u32, y: u32| {
        let rolled = rolled(&scene, roll);
        let mut renderer = Renderer::default();
        renderer.render(&rolled);
        probe(&mut renderer, &rolled, x, y)
    };
    let (plain, turned) = (at(0.0, 60, 30), at(90.0, 30, 95 - 60));
    let (plain, turned) = (
        plain.hit.expect("the plane"),
        turned.hit.expect("the plane"),
    );
    assert!(
        plain.position.distance(turned.position) < 1e-6,
        "{} {}",
        plain.position,
        turned.position
    );
    assert!((plain.sum - turned.sum).abs().max_element() < 1e-6);
}
