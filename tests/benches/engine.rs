//! Times of the engine's stages, kernels and frames: `cargo bench --bench engine`.
//!
//! A stage is measured through the renderer: the change from one frame to the next leaves little to do but that stage, in a
//! picture or on a mesh whose size keeps the rest small. Kernels run in one thread. The sphere has the default view, one point
//! light, and Phong's model with a local viewer.

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use fearless_simd::Level;
use rayon::ThreadPoolBuilder;
use shading_lab::geometry::divisions_for;
use shading_lab::render::{FrameReport, Renderer};
use shading_lab::scene::{
    Choice, Display, Distribution, Encoding, Interpolation, NormalSource, ObjectKind, Overflow,
    ReflectionModel, Rgb, Scene, ShadingMode,
};
use std::fmt;

fn main() {
    divan::main();
}

const TRIANGLES: [u64; 3] = [1024, 16_384, 262_144];
const SIDE: u32 = 1024;
/// The side of a picture so small that its pixels hardly count.
const SMALL: u32 = 16;

/// An argument with its name.
#[derive(Clone, Copy)]
struct Case<T> {
    name: &'static str,
    value: T,
}

impl<T> fmt::Display for Case<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)
    }
}

fn sphere(mode: ShadingMode, triangles: u64, side: u32) -> Scene {
    let mut scene = Scene::default();
    scene.image.size = [side; 2];
    [scene.object.segments, scene.object.rings] = divisions_for(ObjectKind::Sphere, triangles);
    scene.object.normals = NormalSource::Exact;
    scene.shading.mode = mode;
    scene
}

/// Draws two scenes alternately on `threads` threads (0: one for each core) and measures one frame; `count` returns the number of
/// items in it.
fn alternate(
    bencher: Bencher<'_, '_>,
    threads: usize,
    mut renderer: Renderer,
    scenes: [Scene; 2],
    count: fn(&FrameReport) -> u64,
) {
    let pool = ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .expect("threads");
    for scene in &scenes {
        pool.install(|| _ = renderer.render(scene));
    }
    let items = count(renderer.report());
    let mut turn = 0;
    bencher.counter(ItemsCount::new(items)).bench_local(|| {
        turn = 1 - turn;
        pool.install(|| black_box(renderer.render(&scenes[turn]).pixels.len()))
    });
}

fn changed(scene: &Scene, change: impl FnOnce(&mut Scene)) -> [Scene; 2] {
    let mut other = scene.clone();
    change(&mut other);
    [scene.clone(), other]
}

fn light_moved(scene: &Scene) -> [Scene; 2] {
    changed(scene, |scene| scene.lights[0].position.x += 0.1)
}

fn camera_moved(scene: &Scene) -> [Scene; 2] {
    changed(scene, |scene| scene.camera.eye.x += 0.1)
}

fn covered(report: &FrameReport) -> u64 {
    report.covered
}

fn vertices(report: &FrameReport) -> u64 {
    report.vertices
}

/// Returns the SIMD levels of this machine.
fn levels() -> Vec<Case<Level>> {
    let best = Level::new();
    let mut levels = vec![Case {
        name: "baseline",
        value: Level::baseline(),
    }];
    #[cfg(target_arch = "x86_64")]
    {
        levels.extend(best.as_sse4_2().map(|level| Case {
            name: "SSE4.2",
            value: Level::Sse4_2(level),
        }));
        levels.extend(best.as_avx2().map(|level| Case {
            name: "AVX2",
            value: Level::Avx2(level),
        }));
    }
    levels.push(Case {
        name: "best",
        value: best,
    });
    levels
}

/// Sets a scene's model and exponent n to a named specular form.
fn with_form(scene: &mut Scene, form: &str) {
    let (model, n) = match form {
        "none" => return scene.material.ks = Rgb::ZERO,
        "phong-cosine" => (ReflectionModel::Phong, 20.0),
        "phong-chord" => (ReflectionModel::Phong, 200.0),
        "blinn-cosine" => (ReflectionModel::Blinn, 20.0),
        "blinn-chord" => (ReflectionModel::Blinn, 200.0),
        _ => (ReflectionModel::CookTorrance, 20.0),
    };
    (scene.reflection.model, scene.material.n) = (model, n);
    scene.reflection.distribution = if form == "ggx" {
        Distribution::Ggx
    } else {
        Distribution::Beckmann
    };
}

const FORMS: [&str; 7] = [
    "none",
    "phong-cosine",
    "phong-chord",
    "blinn-cosine",
    "blinn-chord",
    "beckmann",
    "ggx",
];

/// Returns each specular form at each SIMD level.
fn kernels() -> Vec<Kernel> {
    FORMS
        .iter()
        .flat_map(|form| {
            levels()
                .into_iter()
                .map(move |level| Kernel { form, level })
        })
        .collect()
}

#[derive(Clone, Copy)]
struct Kernel {
    form: &'static str,
    level: Case<Level>,
}

impl fmt::Display for Kernel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.form, self.level)
    }
}

impl Kernel {
    fn scene(self, mode: ShadingMode, triangles: u64, side: u32) -> Scene {
        let mut scene = sphere(mode, triangles, side);
        with_form(&mut scene, self.form);
        scene
    }

    fn renderer(self) -> Renderer {
        Renderer::default().with_level(self.level.value)
    }
}

/// Measures the transform of vertices to the picture and the binning of triangles into bands.
#[divan::bench(args = levels())]
fn transform(bencher: Bencher<'_, '_>, level: Case<Level>) {
    let scene = sphere(ShadingMode::Flat, 262_144, SMALL);
    let renderer = Renderer::default().with_level(level.value);
    alternate(bencher, 1, renderer, camera_moved(&scene), vertices);
}

/// Measures visibility per pixel, with few triangles and with many; the torus needs the depth test.
#[divan::bench(args = ["sphere 1k", "sphere 262k", "torus 1k", "torus 262k"])]
fn coverage(bencher: Bencher<'_, '_>, what: &str) {
    let mut scene = sphere(
        ShadingMode::Flat,
        if what.ends_with("262k") {
            262_144
        } else {
            1024
        },
        SIDE,
    );
    if what.starts_with("torus") {
        scene.object.kind = ObjectKind::Torus;
    }
    alternate(
        bencher,
        1,
        Renderer::default(),
        camera_moved(&scene),
        covered,
    );
}

/// Measures the equation at pixels, and storing them.
#[divan::bench(args = kernels())]
fn pixel_shading(bencher: Bencher<'_, '_>, kernel: Kernel) {
    let scene = kernel.scene(ShadingMode::Phong, 1024, SIDE);
    alternate(bencher, 1, kernel.renderer(), light_moved(&scene), covered);
}

/// Measures the equation at vertices.
#[divan::bench(args = kernels())]
fn vertex_shading(bencher: Bencher<'_, '_>, kernel: Kernel) {
    let scene = kernel.scene(ShadingMode::Gouraud, 262_144, SMALL);
    alternate(bencher, 1, kernel.renderer(), light_moved(&scene), vertices);
}

/// Measures the interpolation of intensities at the pixels, by `rule` and by affine interpolation in turn, and storing them.
#[divan::bench(args = [Interpolation::Perspective, Interpolation::Scanline])]
fn interpolation(bencher: Bencher<'_, '_>, rule: Interpolation) {
    let mut scene = sphere(ShadingMode::Gouraud, 1024, SIDE);
    scene.shading.interpolation = rule;
    let scenes = changed(&scene, |scene| {
        scene.shading.interpolation = Interpolation::Affine;
    });
    alternate(bencher, 1, Renderer::default(), scenes, covered);
}

/// Measures the conversion of intensities to stored values, interpolation included: as each pixel is shaded, or once the whole
/// picture is known.
#[divan::bench(args = ["clamp raw", "clamp sRGB", "scale raw", "scale sRGB", "mark raw"])]
fn display(bencher: Bencher<'_, '_>, what: &str) {
    let mut scene = sphere(ShadingMode::Gouraud, 1024, SIDE);
    let overflow = match what.split_once(' ') {
        Some(("scale", _)) => Overflow::Scale,
        Some(("mark", _)) => Overflow::Mark,
        _ => Overflow::Clamp,
    };
    let encoding = if what.ends_with("sRGB") {
        Encoding::Srgb
    } else {
        Encoding::Raw
    };
    scene.display = Display { overflow, encoding };
    let scenes = changed(&scene, |scene| scene.image.background = Rgb::splat(0.1));
    alternate(bencher, 1, Renderer::default(), scenes, covered);
}

/// Measures everything from the transform on, on all cores.
#[divan::bench(args = ShadingMode::VALUES, consts = TRIANGLES)]
fn frame<const TRIANGLES: u64>(bencher: Bencher<'_, '_>, mode: ShadingMode) {
    let scene = sphere(mode, TRIANGLES, SIDE);
    let mut renderer = Renderer::default();
    renderer.render(&scene);
    bencher.bench_local(|| {
        renderer.redraw();
        black_box(renderer.render(&scene).pixels.len())
    });
}

/// Measures a frame in which a light has moved.
#[divan::bench(args = ShadingMode::VALUES, consts = TRIANGLES)]
fn light<const TRIANGLES: u64>(bencher: Bencher<'_, '_>, mode: ShadingMode) {
    let scene = sphere(mode, TRIANGLES, SIDE);
    alternate(
        bencher,
        0,
        Renderer::default(),
        light_moved(&scene),
        covered,
    );
}

/// Measures a frame in which Ka has changed under one to four lights; the cached sum of several lights is reused.
#[divan::bench(args = [1, 2, 3, 4])]
fn ka_under_lights(bencher: Bencher<'_, '_>, lights: usize) {
    let mut scene = sphere(ShadingMode::Phong, 16_384, SIDE);
    scene.lights = vec![scene.lights[0].clone(); lights];
    for (light, x) in scene.lights.iter_mut().zip([2.0, -2.0, 0.0, 4.0]) {
        light.position.x = x;
    }
    let scenes = changed(&scene, |scene| scene.material.ka = Rgb::splat(0.2));
    alternate(bencher, 0, Renderer::default(), scenes, covered);
}

/// Measures a frame in which Ka has changed.
#[divan::bench(args = ShadingMode::VALUES, consts = TRIANGLES)]
fn ka<const TRIANGLES: u64>(bencher: Bencher<'_, '_>, mode: ShadingMode) {
    let scene = sphere(mode, TRIANGLES, SIDE);
    let scenes = changed(&scene, |scene| scene.material.ka = Rgb::splat(0.2));
    alternate(bencher, 0, Renderer::default(), scenes, covered);
}
