//! `shading-lab bench`: the median time of a frame and of its stages.
//!
//! A full frame starts from the tessellated mesh, as a graphics card starts from its vertex buffers: transform, coverage,
//! interpolation, shading and display all run. The changes are frames in which one slider has moved.

use super::output::{print, print_json};
use super::{Failure, SceneArguments, nanoseconds, progress_bar};
use crate::render::{Renderer, Report};
use crate::scene::{LightKind, Scene};
use clap::Args;
use glam::DQuat;
use serde_json::{Map, Value, json};
use std::collections::BTreeMap;
use std::fmt::Write;

/// Frames before the measured ones: caches, buffers and threads settle.
const WARM_UP: u32 = 3;

#[derive(Debug, Args)]
pub(super) struct Arguments {
    #[command(flatten)]
    scene: SceneArguments,
    /// Measured frames of each kind
    #[arg(long, value_name = "N", default_value_t = 31, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    frames: u32,
    /// Threads; without it one for each of the machine's
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1024))]
    threads: Option<u32>,
    /// Prints JSON
    #[arg(long)]
    json: bool,
}

/// A slider that is moved to and fro.
struct Change {
    name: &'static str,
    /// Alters the scene in frame `index`, so that it differs from the frame before.
    apply: fn(&mut Scene, &Scene, u32),
}

/// A factor that is another one in every frame.
fn wobble(frame: u32) -> f64 {
    1.0 + 0.01 * f64::from(frame % 7 + 1)
}

const CHANGES: [Change; 4] = [
    Change {
        name: "light",
        apply: |scene, original, frame| {
            for (light, original) in scene.lights.iter_mut().zip(&original.lights) {
                match light.kind {
                    LightKind::Point => light.position = original.position * wobble(frame),
                    LightKind::Directional => light.direction.x = original.direction.x + wobble(frame),
                }
            }
        },
    },
    Change {
        name: "n",
        apply: |scene, original, frame| {
            let n = if original.material.n.is_finite() { original.material.n.max(1.0) } else { 1e6 };
            scene.material.n = n * wobble(frame);
        },
    },
    Change {
        name: "ka",
        apply: |scene, original, frame| scene.material.ka = (original.material.ka + 0.01) * wobble(frame),
    },
    Change {
        name: "camera",
        apply: |scene, original, frame| {
            let turn = DQuat::from_axis_angle(original.camera.up.normalize(), 0.02 * f64::from(frame % 7 + 1));
            scene.camera.eye = original.camera.target + turn * (original.camera.eye - original.camera.target);
        },
    },
];

/// Medians in milliseconds.
struct Measured {
    full: f64,
    stages: BTreeMap<String, f64>,
    changes: Vec<(&'static str, f64)>,
    report: Report,
    threads: usize,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let loaded = arguments.scene.load()?;
    let threads = arguments.threads.unwrap_or(0) as usize;
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().map_err(|error| Failure::other(&error))?;
    let mut renderer = Renderer::with_clock(nanoseconds);
    renderer.set_model(loaded.model);
    let measured = pool.install(|| measure(&mut renderer, &loaded.scene, arguments.frames));
    let size = loaded.scene.image.size;
    if arguments.json { print_json(&as_json(&measured, size)) } else { print(&as_text(&measured, size)) }
}

fn measure(renderer: &mut Renderer, scene: &Scene, frames: u32) -> Measured {
    let bar = progress_bar("measuring");
    bar.set_length(u64::from(frames + WARM_UP) * (1 + CHANGES.len() as u64));
    let mut full = Vec::new();
    let mut stages: BTreeMap<String, Vec<u64>> = BTreeMap::new();
    let mut report = Report::default();
    for frame in 0..frames + WARM_UP {
        renderer.redraw();
        renderer.render(scene);
        bar.inc(1);
        if frame < WARM_UP {
            continue;
        }
        report = renderer.report().clone();
        full.push(report.nanoseconds);
        for run in &report.stages {
            stages.entry(stage_name(run.stage)).or_default().push(run.nanoseconds);
        }
    }
    let changes = CHANGES
        .iter()
        .map(|change| {
            let mut changed = scene.clone();
            let mut times = Vec::new();
            for frame in 0..frames + WARM_UP {
                (change.apply)(&mut changed, scene, frame);
                renderer.render(&changed);
                bar.inc(1);
                if frame >= WARM_UP {
                    times.push(renderer.report().nanoseconds);
                }
            }
            (change.name, median(&mut times))
        })
        .collect();
    bar.finish_and_clear();
    Measured {
        full: median(&mut full),
        stages: stages.into_iter().map(|(name, mut times)| (name, median(&mut times))).collect(),
        changes,
        report,
        threads: rayon::current_num_threads(),
    }
}

fn stage_name(stage: crate::render::Stage) -> String {
    serde_json::to_value(stage).ok().and_then(|value| value.as_str().map(str::to_owned)).unwrap_or_default()
}

/// The median in milliseconds.
#[expect(clippy::cast_precision_loss, reason = "nanoseconds of a frame")]
fn median(times: &mut [u64]) -> f64 {
    times.sort_unstable();
    times.get(times.len() / 2).map_or(0.0, |time| *time as f64 / 1e6)
}

fn evaluations(report: &Report) -> u64 {
    report.stages.iter().map(|run| run.evaluations).sum()
}

fn as_json(measured: &Measured, size: [u32; 2]) -> Value {
    let times = |pairs: &mut dyn Iterator<Item = (String, f64)>| -> Map<String, Value> {
        pairs.map(|(name, time)| (name, json!({ "median_ms": time }))).collect()
    };
    json!({
        "full": { "median_ms": measured.full },
        "stages": times(&mut measured.stages.iter().map(|(name, time)| (name.clone(), *time))),
        "changes": times(&mut measured.changes.iter().map(|(name, time)| ((*name).to_owned(), *time))),
        "threads": measured.threads,
        "size": size,
        "triangles": measured.report.triangles,
        "covered": measured.report.covered,
        "evaluations": evaluations(&measured.report),
    })
}

fn as_text(measured: &Measured, [width, height]: [u32; 2]) -> String {
    let mut text = String::new();
    let report = &measured.report;
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "{width}x{height}, {} triangles, {} pixels covered, {} evaluations, {} thread(s); medians in milliseconds\n",
        report.triangles,
        report.covered,
        evaluations(report),
        measured.threads
    );
    let _ = writeln!(text, "{:<20}{:>9.3}", "full frame", measured.full);
    for (name, time) in &measured.stages {
        let _ = writeln!(text, "  {name:<18}{time:>9.3}");
    }
    for (name, time) in &measured.changes {
        let _ = writeln!(text, "{:<20}{time:>9.3}", format!("{name} moved"));
    }
    text
}
