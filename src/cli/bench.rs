//! `bench`: the time of a frame.
//!
//! Every figure is the median over the frames asked for, after frames that are not counted: of everything drawn anew,
//! with its stages, and of frames in which a single thing changed since the frame before.

use super::failure::Failure;
use super::input::{SceneArguments, nanoseconds, parse_size};
use super::output::{print, print_json, progress_bar};
use clap::Args;
use glam::DQuat;
use indicatif::ProgressBar;
use serde_json::{Map, Value, json};
use shading_lab::document::Loaded;
use shading_lab::render::{Renderer, Report};
use shading_lab::scene::{LightKind, Rgb, Scene};
use std::fmt::Write;

/// Frames that warm caches and buffers up before any is counted.
const WARM_UP: u32 = 2;

#[derive(Args)]
pub struct Bench {
    #[command(flatten)]
    scene: SceneArguments,
    /// Frames for each figure
    #[arg(long, value_name = "N", default_value_t = 30, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    frames: u32,
    /// Threads; one for each core unless given
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
    /// Width and height in pixels, instead of the scene's
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    size: Option<[u32; 2]>,
    /// Print one JSON object; times in milliseconds
    #[arg(long)]
    json: bool,
}

impl Bench {
    pub fn run(self, earlier: &[String]) -> Result<(), Failure> {
        let mut loaded = self.scene.load(earlier)?;
        loaded.scene.image.size = self.size.unwrap_or(loaded.scene.image.size);
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(self.threads.map_or(0, usize::from))
            .build()
            .map_err(|error| Failure::work(format!("the threads cannot be started ({error})")))?;
        let bar = progress_bar(u64::from(self.frames) * (1 + CHANGES.len() as u64), "measuring");
        let figures = pool.install(|| measure(&loaded, self.frames, &bar));
        bar.finish_and_clear();
        let threads = pool.current_num_threads();
        if self.json {
            print_json(&json(&figures, &loaded, threads, self.frames))
        } else {
            print(&text(&figures, &loaded, threads, self.frames))
        }
    }
}

/// The scene's frame of a number, from 1; none where the scene has nothing of the kind to change.
type Change = fn(&Scene, u32) -> Option<Scene>;

/// Each makes the scene's frame of a number; consecutive numbers up to 8 give different scenes.
const CHANGES: [(&str, Change); 4] = [("light", move_light), ("n", turn_n), ("ka", turn_ka), ("camera", orbit)];

fn move_light(scene: &Scene, step: u32) -> Option<Scene> {
    let mut scene = scene.clone();
    let by = 0.01 * f64::from(step) * scene.camera.distance();
    let light = scene.lights.first_mut()?;
    match light.kind {
        LightKind::Directional => light.direction.x += 0.01 * f64::from(step) * light.direction.length(),
        _ => light.position.x += by.max(light.position.length() * 1e-3 * f64::from(step)),
    }
    Some(scene)
}

fn turn_n(scene: &Scene, step: u32) -> Option<Scene> {
    let mut scene = scene.clone();
    let n = &mut scene.material.n;
    *n = if n.is_finite() { *n * 0.9 + 0.1 * f64::from(step) } else { 1000.0 + f64::from(step) };
    Some(scene)
}

fn turn_ka(scene: &Scene, step: u32) -> Option<Scene> {
    let mut scene = scene.clone();
    scene.material.ka = scene.material.ka * 0.9 + Rgb::splat(0.005 * f64::from(step));
    Some(scene)
}

fn orbit(scene: &Scene, step: u32) -> Option<Scene> {
    let mut scene = scene.clone();
    let camera = &mut scene.camera;
    let turn = DQuat::from_axis_angle(camera.up.normalize(), 0.01 * f64::from(step));
    camera.eye = camera.target + turn * (camera.eye - camera.target);
    Some(scene)
}

/// Medians in milliseconds.
struct Figures {
    full: f64,
    stages: Vec<(String, f64)>,
    /// None where the scene has nothing of the kind to change.
    changes: Vec<(&'static str, Option<f64>)>,
    /// Of a frame drawn anew.
    report: Report,
}

fn measure(loaded: &Loaded, frames: u32, bar: &ProgressBar) -> Figures {
    let mut renderer = Renderer::with_clock(nanoseconds);
    renderer.set_model(loaded.model.clone());
    let scene = &loaded.scene;
    let mut times = Vec::new();
    let mut stages: Vec<(String, Vec<u64>)> = Vec::new();
    for frame in 0..WARM_UP + frames {
        renderer.redraw();
        let time = timed(&mut renderer, scene);
        if frame >= WARM_UP {
            times.push(time);
            collect_stages(&mut stages, renderer.report());
            bar.inc(1);
        }
    }
    let report = renderer.report().clone();
    let changes = CHANGES.map(|(name, change)| (name, measure_change(&mut renderer, scene, change, frames, bar)));
    Figures {
        full: median_ms(&mut times),
        stages: stages.into_iter().map(|(name, mut times)| (name, median_ms(&mut times))).collect(),
        changes: changes.to_vec(),
        report,
    }
}

fn measure_change(
    renderer: &mut Renderer,
    scene: &Scene,
    change: Change,
    frames: u32,
    bar: &ProgressBar,
) -> Option<f64> {
    let mut times = Vec::new();
    for frame in 0..WARM_UP + frames {
        let time = timed(renderer, &change(scene, 1 + frame % 8)?);
        if frame >= WARM_UP {
            times.push(time);
            bar.inc(1);
        }
    }
    Some(median_ms(&mut times))
}

fn timed(renderer: &mut Renderer, scene: &Scene) -> u64 {
    let began = nanoseconds();
    renderer.render(scene);
    nanoseconds() - began
}

fn collect_stages(stages: &mut Vec<(String, Vec<u64>)>, report: &Report) {
    for run in &report.stages {
        let name = stage_name(run.stage);
        match stages.iter_mut().find(|(known, _)| *known == name) {
            Some((_, times)) => times.push(run.nanoseconds),
            None => stages.push((name, vec![run.nanoseconds])),
        }
    }
}

fn stage_name(stage: shading_lab::render::Stage) -> String {
    match serde_json::to_value(stage) {
        Ok(Value::String(name)) => name,
        _ => format!("{stage:?}"),
    }
}

/// The median of nanoseconds, in milliseconds; of an even number the mean of the middle two.
#[expect(clippy::cast_precision_loss, reason = "2⁵³ ns are a hundred days")]
fn median_ms(times: &mut [u64]) -> f64 {
    times.sort_unstable();
    let middle = times.len() / 2;
    let upper = times.get(middle).copied().unwrap_or(0);
    let lower =
        if times.len().is_multiple_of(2) { middle.checked_sub(1).and_then(|i| times.get(i)).copied() } else { None };
    (lower.unwrap_or(upper) as f64 + upper as f64) / 2.0 * 1e-6
}

fn json(figures: &Figures, loaded: &Loaded, threads: usize, frames: u32) -> Value {
    let median = |ms: &Value| json!({"median_ms": ms});
    let stages: Map<_, _> = figures.stages.iter().map(|(name, ms)| (name.clone(), median(&json!(ms)))).collect();
    let changes: Map<_, _> =
        figures.changes.iter().map(|(name, ms)| ((*name).to_owned(), median(&json!(ms)))).collect();
    json!({
        "scene": loaded.name,
        "full": median(&json!(figures.full)),
        "stages": stages,
        "changes": changes,
        "threads": threads,
        "size": loaded.scene.image.size,
        "triangles": figures.report.triangles,
        "covered": figures.report.covered,
        "evaluations": evaluations(&figures.report),
        "frames": frames,
    })
}

fn evaluations(report: &Report) -> u64 {
    report.stages.iter().map(|run| run.evaluations).sum()
}

fn text(figures: &Figures, loaded: &Loaded, threads: usize, frames: u32) -> String {
    let [width, height] = loaded.scene.image.size;
    let Report { triangles, covered, .. } = figures.report;
    let mut text = format!(
        "{}: {width}×{height}, {triangles} triangles, {covered} pixels covered, {} evaluations\n\
         {threads} threads, median of {frames} frames, ms\n\n",
        loaded.name,
        evaluations(&figures.report),
    );
    let _ = writeln!(text, "everything      {:10.3}", figures.full);
    for (name, ms) in &figures.stages {
        let _ = writeln!(text, "  {name:14}{ms:10.3}");
    }
    text.push_str("\nwhat changed\n");
    for (name, ms) in &figures.changes {
        let ms = ms.map_or_else(|| format!("{:>10}", "-"), |ms| format!("{ms:10.3}"));
        let _ = writeln!(text, "  {name:14}{ms}");
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use shading_lab::scene::presets;

    #[test]
    fn medians_are_in_the_middle() {
        assert_eq!(median_ms(&mut [3_000_000, 1_000_000, 2_000_000]), 2.0);
        assert_eq!(median_ms(&mut [4_000_000, 1_000_000, 2_000_000, 3_000_000]), 2.5);
        assert_eq!(median_ms(&mut [7_000_000]), 7.0);
        assert_eq!(median_ms(&mut []), 0.0);
    }

    #[test]
    fn every_change_changes_one_thing_and_leaves_the_scene_sound() {
        let mut far = Scene::default();
        far.lights[0].position = glam::DVec3::splat(1e20);
        let mut mirror = Scene::default();
        mirror.material.n = f64::INFINITY;
        let lit = presets::ALL.iter().map(|preset| (preset.build)()).filter(|scene| !scene.lights.is_empty());
        for scene in lit.chain([far, mirror]) {
            for (name, change) in CHANGES {
                for step in 1..8 {
                    let (a, b) = (change(&scene, step).expect("a light"), change(&scene, step + 1).expect("a light"));
                    assert_ne!(a, b, "{name}");
                    assert_eq!(a.validate(), Ok(()), "{name}");
                    let parts = [
                        a.lights != b.lights,
                        a.material.n != b.material.n,
                        a.material.ka != b.material.ka,
                        a.camera != b.camera,
                    ];
                    assert_eq!(parts.iter().filter(|&&differs| differs).count(), 1, "{name}");
                }
            }
        }
        assert_eq!(move_light(&Scene { lights: vec![], ..Scene::default() }, 1), None);
    }
}
