//! `bench`: the time of a frame.
//!
//! Every figure is the median over the frames asked for, after frames that are not counted: of everything drawn anew,
//! with its stages, and of frames in which a single thing changed since the frame before. Of a scene that compares panes all that
//! it shows are drawn.

mod growth;

use super::failure::Failure;
use super::input::{SceneArguments, nanoseconds, parse_size};
use super::output::{print, print_json, progress_bar};
use clap::Args;
use glam::DQuat;
use growth::Growth;
use indicatif::ProgressBar;
use serde_json::{Map, Value, json};
use shading_lab::analysis::panes_on_sheet;
use shading_lab::document::Loaded;
use shading_lab::render::{Memory, Renderer, Report, coarseness, coarser_size};
use shading_lab::scene::{LightKind, Object, ObjectKind, Rgb, Scene};
use std::fmt::Write;

/// Frames that warm caches and buffers up before any is counted.
pub const WARM_UP: u32 = 2;

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
    /// Measure also how the time grows with the pixels, up to 8 million, and with the triangles, up to 4 million
    #[arg(long)]
    growth: bool,
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
        let more = if self.growth { growth::most_frames(self.frames) } else { 0 };
        let bar = progress_bar(u64::from(self.frames) * (1 + CHANGES.len() as u64) + more, "measuring");
        let figures = pool.install(|| Figures {
            growth: self.growth.then(|| growth::measure(&loaded, self.frames, &bar)),
            ..measure(&loaded, self.frames, &bar)
        });
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
pub type Change = fn(&Scene, u32) -> Option<Scene>;

/// Each makes the scene's frame of a number; consecutive numbers up to 8 give different scenes.
pub const CHANGES: [(&str, Change); 5] =
    [("light", move_light), ("n", turn_n), ("ka", turn_ka), ("camera", orbit), ("tessellation", divide)];

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

fn divide(scene: &Scene, step: u32) -> Option<Scene> {
    let mut scene = scene.clone();
    let object = &mut scene.object;
    if object.kind == ObjectKind::Obj {
        return None;
    }
    // The teapot and the cube are cut anew at every fourth segment only.
    let finer = object.segments + 4 * step;
    object.segments = if finer <= Object::MAX_DIVISIONS { finer } else { object.segments - 4 * step };
    Some(scene)
}

/// Medians in milliseconds.
struct Figures {
    full: f64,
    stages: Vec<(String, f64)>,
    /// None where the scene has nothing of the kind to change.
    changes: Vec<(&'static str, Option<Changed>)>,
    /// Of a frame drawn anew; of a scene that compares panes the first one's.
    report: Report,
    memory: Memory,
    growth: Option<Growth>,
}

/// What a change costs.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Changed {
    whole: f64,
    /// While something is dragged: by what the sides of the picture are divided, and what that takes.
    dragged: (u32, f64),
}

/// The panes that a scene shows, a renderer each.
struct Panes(Vec<Renderer>);

impl Panes {
    fn new(loaded: &Loaded) -> Self {
        let shown = panes_on_sheet(&loaded.scene).len();
        let renderer = |_| {
            let mut renderer = Renderer::with_clock(nanoseconds);
            renderer.set_model(loaded.model.clone());
            renderer.keep_linear(shown > 1);
            renderer
        };
        Self((0..shown).map(renderer).collect())
    }

    /// Draws all panes, their sides divided by `coarser`, and says how long that took.
    fn draw(&mut self, scene: &Scene, coarser: u32) -> u64 {
        let mut time = 0;
        for ((index, size), renderer) in panes_on_sheet(scene).into_iter().zip(&mut self.0) {
            let mut shown = scene.pane(index).unwrap_or_else(|_| scene.clone());
            shown.image.size = coarser_size(size, coarser);
            let began = nanoseconds();
            renderer.render(&shown);
            time += nanoseconds() - began;
        }
        time
    }

    /// The first one's figures.
    fn figures(&self) -> (Report, Memory) {
        self.0.first().map(|first| (first.report().clone(), first.memory())).unwrap_or_default()
    }
}

fn measure(loaded: &Loaded, frames: u32, bar: &ProgressBar) -> Figures {
    let mut panes = Panes::new(loaded);
    let scene = &loaded.scene;
    let mut times = Vec::new();
    let mut stages: Vec<(String, Vec<u64>)> = Vec::new();
    for frame in 0..WARM_UP + frames {
        panes.0.iter_mut().for_each(Renderer::redraw);
        let time = panes.draw(scene, 1);
        if frame >= WARM_UP {
            times.push(time);
            panes.0.iter().for_each(|renderer| collect_stages(&mut stages, renderer.report()));
            bar.inc(1);
        }
    }
    let (report, mut memory) = panes.figures();
    let changes = CHANGES.map(|(name, change)| {
        let whole = measure_change(&mut panes, scene, change, 1, frames, bar);
        let (changed, held) = panes.figures();
        // Of another tessellation the bytes would be divided by this one's triangles.
        if changed.triangles == report.triangles && held.total() > memory.total() {
            memory = held;
        }
        (name, whole.map(|whole| Changed { whole, dragged: dragged(loaded, change, whole, frames) }))
    });
    Figures {
        full: median_ms(&mut times),
        stages: stages.into_iter().map(|(name, mut times)| (name, median_ms(&mut times))).collect(),
        changes: changes.to_vec(),
        report,
        memory,
        growth: None,
    }
}

/// What the window does while something is dragged that takes `whole` milliseconds.
fn dragged(loaded: &Loaded, change: Change, whole: f64, frames: u32) -> (u32, f64) {
    let hidden = ProgressBar::hidden();
    let (mut coarser, mut ms) = (1, whole);
    // Not every stage shrinks with the picture: what is still too slow is drawn coarser.
    loop {
        let next = coarseness((ms * 1e6) as u64 * u64::from(coarser * coarser));
        if next <= coarser {
            return (coarser, ms);
        }
        coarser = next;
        let measured = measure_change(&mut Panes::new(loaded), &loaded.scene, change, coarser, frames, &hidden);
        ms = measured.unwrap_or(ms);
    }
}

/// The median time of a frame in which only `change` differs from the frame before, milliseconds.
fn measure_change(
    panes: &mut Panes,
    scene: &Scene,
    change: Change,
    coarser: u32,
    frames: u32,
    bar: &ProgressBar,
) -> Option<f64> {
    let mut times = Vec::new();
    for frame in 0..WARM_UP + frames {
        let time = panes.draw(&change(scene, 1 + frame % 8)?, coarser);
        if frame >= WARM_UP {
            times.push(time);
            bar.inc(1);
        }
    }
    Some(median_ms(&mut times))
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

pub fn stage_name(stage: shading_lab::render::Stage) -> String {
    match serde_json::to_value(stage) {
        Ok(Value::String(name)) => name,
        _ => format!("{stage:?}"),
    }
}

/// The median of nanoseconds, in milliseconds; of an even number the mean of the middle two.
#[expect(clippy::cast_precision_loss, reason = "2⁵³ ns are a hundred days")]
pub fn median_ms(times: &mut [u64]) -> f64 {
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
    let change = |changed: &Option<Changed>| match changed {
        Some(Changed { whole, dragged: (coarser, ms) }) => {
            json!({"median_ms": whole, "dragged": {"median_ms": ms, "coarser": coarser}})
        }
        None => median(&Value::Null),
    };
    let changes: Map<_, _> =
        figures.changes.iter().map(|(name, changed)| ((*name).to_owned(), change(changed))).collect();
    let each = bytes_each(figures, loaded.scene.image.size);
    let mut told = json!({
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
        "memory": {
            "total_bytes": figures.memory.total(),
            "bytes_per_vertex": each[0],
            "bytes_per_triangle": each[1],
            "bytes_per_pixel": each[2],
        },
    });
    if let Some(growth) = &figures.growth {
        told["growth"] = json!(growth);
    }
    told
}

/// Bytes a vertex, a triangle and a pixel; none where there are no such.
#[expect(clippy::cast_precision_loss, reason = "far fewer bytes than 2⁵³")]
fn bytes_each(figures: &Figures, [width, height]: [u32; 2]) -> [Option<f64>; 3] {
    let Figures { memory, report, .. } = figures;
    let each = |bytes: u64, count: u64| (count > 0).then(|| bytes as f64 / count as f64);
    [
        each(memory.vertices, report.vertices),
        each(memory.triangles, report.triangles),
        each(memory.pixels, u64::from(width) * u64::from(height)),
    ]
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
    text.push_str("\nwhat changed                  while dragged\n");
    for (name, changed) in &figures.changes {
        let words = changed.map_or_else(
            || format!("{:>10}", "-"),
            |Changed { whole, dragged: (coarser, ms) }| match coarser {
                1 => format!("{whole:10.3}{ms:15.3}"),
                _ => format!("{whole:10.3}{ms:15.3}  at 1/{coarser} of the size"),
            },
        );
        let _ = writeln!(text, "  {name:14}{words}");
    }
    text.push_str("\nmemory, bytes each\n");
    for (name, bytes) in ["vertex", "triangle", "pixel"].into_iter().zip(bytes_each(figures, loaded.scene.image.size)) {
        let _ = writeln!(text, "  {name:14}{}", bytes.map_or_else(|| format!("{:>10}", "-"), |b| format!("{b:10.1}")));
    }
    let _ = writeln!(text, "  {:14}{:10.1} MB", "in all", figures.memory.total() as f64 * 1e-6);
    if let Some(growth) = &figures.growth {
        text.push_str(&growth::text(growth));
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
        let lit = presets::ALL.iter().map(|preset| preset.scene()).filter(|scene| !scene.lights.is_empty());
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
                        a.object != b.object,
                    ];
                    assert_eq!(parts.iter().filter(|&&differs| differs).count(), 1, "{name}");
                }
            }
        }
        assert_eq!(move_light(&Scene { lights: vec![], ..Scene::default() }, 1), None);
    }
}
