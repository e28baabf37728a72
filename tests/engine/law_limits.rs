//! The largest laws that are allowed: they are prepared and drawn in bounded time, and their pictures can be stopped.

use crate::common::simd::levels;
use shading_lab::analysis::Watch;
use shading_lab::illumination::Equation;
use shading_lab::jobs::{Job, Work};
use shading_lab::render::Renderer;
use shading_lab::scene::{
    AreaShape, Light, LightKind, Reflection, ReflectionModel, Scene, ShadingMode,
};
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};
use std::time::{Duration, Instant};

/// Far more than anything here takes, on a machine that does something else as well.
const PATIENCE: Duration = Duration::from_secs(20);

/// Returns the largest laws of their kind: of 256 operations, or of 2000 characters.
fn dearest() -> Vec<String> {
    let lines = |first: &str, line: &str, count: usize, last: &str| {
        format!("a={first}\n{}{last}", format!("a={line}\n").repeat(count))
    };
    vec![
        lines("d", "(a+kd)^d", 127, "a"),
        lines("d", "acos(a)^kd", 127, "a"),
        lines("d", "a*a", 255, "a"),
        lines("N", "cross(a,L*kd)", 120, "a.x"),
        lines("N+R", "normalize(a)", 125, "a.x+a.y"),
        lines("d", "smoothstep(a,kd,d)", 90, "a"),
        lines("R", "mix(a,H,kd)", 135, "a·a"),
        lines("d", "tan(a*kd)", 125, "a"),
        lines("d", "d", 496, "a"),
        format!("sum({}d)", "d,".repeat(995)),
        format!("max({}R.x)", "H.y*kd,".repeat(255)),
        format!("{}d{}", "(".repeat(60), ")".repeat(60)),
    ]
}

/// Returns a scene with a law and an area light of many samples.
fn scene(law: String, side: u32) -> Scene {
    let mut scene = Scene::default();
    scene.image.size = [side; 2];
    scene.shading.mode = ShadingMode::Phong;
    scene.lights = vec![Light {
        kind: LightKind::Area,
        shape: AreaShape::Sphere,
        radius: 0.5,
        samples: 32,
        ..scene.lights[0].clone()
    }];
    scene.reflection = Reflection {
        model: ReflectionModel::Formula,
        formula: law,
        ..scene.reflection
    };
    assert_eq!(scene.validate(), Ok(()));
    scene
}

#[test]
fn the_largest_laws_are_prepared_and_drawn() {
    let mut longest = Duration::ZERO;
    for law in dearest() {
        let scene = scene(law.clone(), 16);
        let began = Instant::now();
        let _ = Equation::<f32>::new(&scene);
        let took = began.elapsed();
        longest = longest.max(took);
        let began = Instant::now();
        for level in levels() {
            let mut renderer = Renderer::default().with_level(level);
            renderer.keep_linear(true);
            renderer.render(&scene);
            let finite = |x: &f32| x.is_finite();
            assert!(renderer.linear().iter().flatten().all(finite), "{law}");
        }
        let start: String = law.chars().take(24).collect();
        println!(
            "{start:?} prepared in {took:?}, drawn in {:?}",
            began.elapsed()
        );
    }
    assert!(longest < Duration::from_millis(500), "{longest:?}");
}

/// A picture with many samples a pixel, and how many are done.
struct Drawing {
    scene: Scene,
    done: Arc<AtomicU32>,
}

impl Work for Drawing {
    type Answer = ();

    fn run(&self, watch: &dyn Watch<()>) -> Result<(), String> {
        Renderer::default().render_supersampled(&self.scene, 10_000, &mut |done| {
            self.done.store(done, Ordering::Relaxed);
            watch.progress(done as f32 / 10_000.0)
        });
        Ok(())
    }
}

#[test]
fn a_picture_of_the_largest_law_is_stopped() {
    let scene = scene(dearest().remove(0), 48);
    let mut calls = 0;
    let began = Instant::now();
    Renderer::default().render_supersampled(&scene, 10_000, &mut |_| {
        calls += 1;
        false
    });
    println!("stopped after {:?}", began.elapsed());
    assert_eq!(calls, 1);
    let done = Arc::new(AtomicU32::default());
    let work = Drawing {
        scene,
        done: Arc::clone(&done),
    };
    let job = Job::start(work, |_| {});
    let began = Instant::now();
    while done.load(Ordering::Relaxed) == 0 {
        assert!(began.elapsed() < PATIENCE, "no sample is done");
        std::thread::sleep(Duration::from_millis(1));
    }
    let began = Instant::now();
    drop(job);
    // The caller does not wait for the sample that is being drawn.
    let took = began.elapsed();
    assert!(took < Duration::from_millis(100), "{took:?}");
    while Arc::strong_count(&done) > 1 {
        assert!(began.elapsed() < PATIENCE, "the work goes on");
        std::thread::sleep(Duration::from_millis(1));
    }
    println!("the work ended {:?} later", began.elapsed());
    assert!(done.load(Ordering::Relaxed) < 10_000);
}
