//! The memory that a renderer holds: its bounds for a large mesh, and the accuracy of its account.

#[cfg(target_os = "linux")]
use crate::common::alone::is_alone;
use glam::DQuat;
use shading_lab::geometry::divisions_for;
use shading_lab::render::Renderer;
use shading_lab::scene::{ObjectKind, Overflow, Scene, ShadingMode};

/// Maximum bytes per vertex, per triangle and per pixel.
const BOUNDS: [u64; 3] = [64, 48, 40];
/// Multiple to which arrays of vertices are padded.
const PADDING: u64 = 16;

fn sphere(mode: ShadingMode, triangles: u64, side: u32) -> Scene {
    let mut scene = Scene::default();
    scene.image.size = [side; 2];
    [scene.object.segments, scene.object.rings] = divisions_for(ObjectKind::Sphere, triangles);
    scene.shading.mode = mode;
    scene
}

#[track_caller]
fn assert_within_bounds(renderer: &Renderer, scene: &Scene, what: &str) {
    let (memory, report) = (renderer.memory(), renderer.report());
    let pixels = scene
        .image
        .size
        .iter()
        .map(|side| u64::from(*side))
        .product::<u64>();
    println!(
        "{what}: {:.2} bytes a vertex, {:.2} a triangle, {:.2} a pixel",
        memory.vertices as f64 / report.vertices as f64,
        memory.triangles as f64 / report.triangles as f64,
        memory.pixels as f64 / pixels as f64,
    );
    assert!(
        memory.vertices <= BOUNDS[0] * report.vertices.next_multiple_of(PADDING),
        "{what}: {memory:?}"
    );
    assert!(
        memory.triangles <= BOUNDS[1] * report.triangles,
        "{what}: {memory:?}"
    );
    assert!(memory.pixels <= BOUNDS[2] * pixels, "{what}: {memory:?}");
}

#[test]
fn a_large_sphere_stays_within_the_bounds() {
    let [mut renderer, mut flat] = [Renderer::default(), Renderer::default()];
    for mode in [
        ShadingMode::Phong,
        ShadingMode::Gouraud,
        ShadingMode::Phong,
        ShadingMode::Flat,
    ] {
        let renderer = if mode == ShadingMode::Flat {
            &mut flat
        } else {
            &mut renderer
        };
        let mut scene = sphere(mode, 262_144, 768);
        renderer.render(&scene);
        assert_eq!(renderer.report().triangles, 262_144);
        assert_within_bounds(renderer, &scene, &format!("{mode:?}"));
        for x in [1.0, 2.0] {
            scene.lights[0].position.x = x;
            renderer.render(&scene);
        }
        assert_within_bounds(renderer, &scene, &format!("{mode:?}, a light moved"));
    }
}

/// Checks views all round and near by, in which triangles move through all bands of the picture.
#[test]
fn memory_does_not_add_up_over_the_views() {
    let mut renderer = Renderer::default();
    let mut scene = sphere(ShadingMode::Phong, 65_536, 768);
    let eye = scene.camera.eye;
    for step in 0..60 {
        let angle = 0.3 * f64::from(step);
        let distance = 1.0 + 0.4 * (0.7 * f64::from(step)).sin();
        scene.camera.eye = DQuat::from_rotation_y(angle)
            * DQuat::from_rotation_x(0.5 * angle.sin())
            * eye
            * distance;
        renderer.render(&scene);
    }
    assert_within_bounds(&renderer, &scene, "after 60 views");
}

#[test]
fn what_a_display_needed_is_let_go() {
    let mut renderer = Renderer::default();
    let mut scene = sphere(ShadingMode::Phong, 1024, 256);
    renderer.render(&scene);
    let before = renderer.memory();
    scene.display.overflow = Overflow::Mark;
    renderer.render(&scene);
    let linear = 256 * 256 * size_of::<[f32; 4]>() as u64;
    assert_eq!(renderer.memory().pixels, before.pixels + linear);
    scene.display.overflow = Overflow::Clamp;
    renderer.render(&scene);
    assert_eq!(renderer.memory(), before);
}

/// Returns the resident memory of this process, bytes.
#[cfg(target_os = "linux")]
fn resident() -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").expect("Linux");
    let line = status
        .lines()
        .find(|line| line.starts_with("VmRSS:"))
        .expect("Linux");
    1024.0
        * line
            .split_whitespace()
            .nth(1)
            .expect("a number")
            .parse::<f64>()
            .expect("a number")
}

/// Runs in a process of its own, so that nothing else allocates meanwhile, and with an allocator that returns every large buffer
/// as soon as it is dropped.
#[cfg(target_os = "linux")]
#[test]
fn the_account_is_what_the_process_grows_by() {
    let name = "memory::the_account_is_what_the_process_grows_by";
    let alone = is_alone(name, |program| {
        program.env("MALLOC_MMAP_THRESHOLD_", "65536");
    });
    if !alone {
        return;
    }
    for mode in [ShadingMode::Phong, ShadingMode::Gouraud] {
        // Allocates code, threads and their scratch buffers first.
        Renderer::default().render(&sphere(mode, 1024, 1536));
        let before = resident();
        let mut renderer = Renderer::default();
        renderer.render(&sphere(mode, 1_048_576, 1536));
        let grown = resident() - before;
        let told = renderer.memory().total() as f64;
        println!(
            "{mode:?}: {:.1} MB accounted for, the process grew by {:.1} MB",
            told * 1e-6,
            grown * 1e-6
        );
        assert!((told / grown - 1.0).abs() <= 0.15, "{told} {grown}");
    }
}
