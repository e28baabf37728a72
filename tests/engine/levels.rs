//! Every built-in scene at every SIMD level of the machine: identical pictures for any number of threads, pictures within one
//! code value of each other at all levels, and within one code value of the equation in double precision.

use crate::common::simd::levels;
use crate::common::textbook::field_edge;
use fearless_simd::Level;
use glam::DVec2;
use rayon::ThreadPool;
use shading_lab::analysis::probe::{ProbeHit, probe};
use shading_lab::geometry::{Mesh, tessellate};
use shading_lab::render::{Frame, Renderer, srgb};
use shading_lab::scene::{Encoding, Overflow, Scene, ShadingMode, View, presets};

const THREADS: [usize; 4] = [1, 2, 3, 8];
const SIDE: u32 = 150;
/// One pixel in this many is evaluated in double precision: coprime to the side, so that all columns have their turn.
const EVERY: u32 = 7;
/// Error of single precision in N·L near 0, or in a position near an edge.
const STEP: f64 = 1e-4;
/// Thickness of a polygon in pixels, below which the grid of corners, 1/256 of a pixel at each level, moves what a pixel sees by
/// 1/200 of the polygon and more: a code value and more where a highlight comes and goes across a sliver, as on a knob or at an
/// outline.
const THIN: f64 = 0.6;

fn pools() -> Vec<ThreadPool> {
    let pool = |threads| {
        rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .expect("a pool of threads")
    };
    THREADS.map(pool).into()
}

fn scenes() -> impl Iterator<Item = (&'static str, Scene)> {
    presets::ALL.iter().map(|preset| {
        let mut scene = preset.scene();
        scene.image.size = [SIDE; 2];
        (preset.name, scene)
    })
}

/// Draws the picture at `level`, which must not depend on the number of threads.
fn picture(pools: &[ThreadPool], name: &str, scene: &Scene, level: Level) -> Frame {
    let mut pictures = pools
        .iter()
        .map(|pool| pool.install(|| Renderer::default().with_level(level).render(scene).clone()));
    let first = pictures.next().expect("a pool");
    for (picture, threads) in pictures.zip(&THREADS[1..]) {
        assert!(
            picture.pixels == first.pixels,
            "{name}: {level:?} with {threads} threads"
        );
    }
    first
}

/// Returns the unrounded code values of a pixel by the equation in double precision; `None` where the display marks it, or where
/// the equation has a step that rounding may cross.
fn expected(scene: &Scene, hit: &ProbeHit) -> Option<[f64; 3]> {
    let marked = scene.display.overflow == Overflow::Mark && hit.sum.max_element() > 1.0;
    (!marked && !has_step(scene, hit)).then(|| {
        (hit.sum / hit.divisor).to_array().map(|value| {
            let value = value.clamp(0.0, 1.0);
            255.0
                * if scene.display.encoding == Encoding::Srgb {
                    srgb(value)
                } else {
                    value
                }
        })
    })
}

/// Returns whether the equation has a step at a hit: a highlight that reaches beyond the terminator ends there abruptly, and the
/// fields of a pattern meet in an edge. Modes that evaluate the equation at vertices or faces carry such a step to all their
/// pixels, so for them the points of evaluation count.
fn has_step(scene: &Scene, hit: &ProbeHit) -> bool {
    let terminator = hit.lights.iter().any(|light| light.n_dot_l.abs() < STEP);
    let edge = matches!(scene.shading.mode, ShadingMode::Phong | ShadingMode::Exact)
        && field_edge(scene, hit.position, STEP);
    terminator || edge
}

/// Returns a face's thickness in the picture, pixels: twice its area over its longest diagonal or edge.
fn thickness(view: &View, mesh: &Mesh, face: u32) -> f64 {
    let corners = mesh
        .face(face as usize)
        .iter()
        .map(|corner| mesh.positions[corner.position as usize].as_dvec3());
    let corners: Vec<DVec2> = corners
        .filter_map(|p| view.project(mesh.origin + p))
        .map(|(pixel, _)| pixel)
        .collect();
    let pairs = || {
        corners
            .iter()
            .enumerate()
            .flat_map(|(k, a)| corners[..k].iter().map(move |b| (*a, *b)))
    };
    let longest = pairs().map(|(a, b)| a.distance(b)).fold(0.0, f64::max);
    let doubled_area: f64 = (0..corners.len())
        .map(|k| corners[k].perp_dot(corners[(k + 1) % corners.len()]))
        .sum();
    doubled_area.abs() / longest
}

#[test]
fn every_level_draws_the_same_with_any_number_of_threads_and_is_near_double_precision() {
    let (pools, levels) = (pools(), levels());
    let mut wrong = Vec::new();
    for (name, scene) in scenes() {
        let pictures: Vec<Frame> = levels
            .iter()
            .map(|level| picture(&pools, name, &scene, *level))
            .collect();
        let stored = |index: usize| pictures.iter().map(move |picture| picture.pixels[index]);
        for index in 0..(SIDE * SIDE) as usize {
            let apart = (0..3).map(|channel| {
                let values = || stored(index).map(|pixel| pixel[channel]);
                values().max().unwrap_or(0) - values().min().unwrap_or(0)
            });
            let apart = apart.max().unwrap_or(0);
            assert!(
                apart <= 1,
                "{name}: levels are {apart} code values apart at pixel {index}"
            );
        }
        let mut renderer = Renderer::default();
        let (view, mesh) = (
            View::new(&scene.camera, scene.image.size),
            tessellate(&scene.object),
        );
        let (mut seen, mut compared) = (0, 0);
        for index in (0..SIDE * SIDE).step_by(EVERY as usize) {
            let Some(hit) = probe(&mut renderer, &scene, index % SIDE, index / SIDE).hit else {
                continue;
            };
            let Some(code) = expected(&scene, &hit) else {
                continue;
            };
            seen += 1;
            let thick = hit
                .face
                .map_or(f64::INFINITY, |face| thickness(&view, &mesh, face));
            if thick < THIN {
                continue;
            }
            compared += 1;
            for (level, pixel) in levels.iter().zip(stored(index as usize)) {
                let off = (0..3)
                    .map(|c| (code[c] - f64::from(pixel[c])).abs())
                    .fold(0.0, f64::max);
                if off > 1.0 {
                    wrong.push(format!(
                        "{name}: {level:?} is {off:.2} code values off at pixel {index}, {thick:.3} thick, {hit:?}"
                    ));
                }
            }
        }
        assert!(
            compared >= 50 && 5 * compared >= 4 * seen,
            "{name}: {compared} pixels of {seen}"
        );
    }
    assert!(
        wrong.is_empty(),
        "{} pixels, {:#?}",
        wrong.len(),
        &wrong[..wrong.len().min(5)]
    );
}

#[test]
fn srgb_passes_through_its_published_points() {
    for (linear, encoded, within) in [
        (0.003_130_8, 0.040_45, 1e-5),
        (0.214_041_14, 0.5, 1e-6),
        (1.0, 1.0, 1e-12),
    ] {
        assert!((srgb(linear) - encoded).abs() < within, "{linear}");
    }
}
