//! `explain`: the plan of a frame, and the work that it saves.

use super::bench::{CHANGES, WARM_UP, median_ms, stage_name};
use super::failure::Failure;
use super::input::{SceneArguments, nanoseconds, parse_size};
use super::output::{print, print_json, progress_bar};
use super::sheet::write_text;
use clap::Args;
use serde_json::{Map, Value, json};
use shading_lab::document::Loaded;
use shading_lab::render::{Renderer, Stage, Term};
use shading_lab::table::Table;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::PathBuf;

#[derive(Args)]
pub struct Explain {
    #[command(flatten)]
    scene: SceneArguments,
    /// Width and height in pixels, instead of the scene's
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    size: Option<[u32; 2]>,
    /// Frames for each time
    #[arg(long, value_name = "N", default_value_t = 15, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    frames: u32,
    /// The terms, a row each
    #[arg(long, value_name = "FILE.csv")]
    csv: Option<PathBuf>,
    /// Print one JSON object; times in milliseconds
    #[arg(long)]
    json: bool,
}

impl Explain {
    pub fn run(self, earlier: &[String]) -> Result<(), Failure> {
        let mut loaded = self.scene.load(earlier)?;
        loaded.scene.image.size = self.size.unwrap_or(loaded.scene.image.size);
        let told = Told::of(&loaded, self.frames);
        if let Some(path) = &self.csv {
            write_text(path, &told.csv())?;
        }
        if self.json {
            return print_json(&told.json(&loaded, self.frames));
        }
        if self.csv.is_some() { Ok(()) } else { print(&told.text(&loaded, self.frames)) }
    }
}

/// What is told of a frame.
struct Told {
    terms: Vec<Term>,
    /// Median times of the stages, milliseconds.
    stages: Vec<(Stage, f64)>,
    /// Median times by the plan and with everything left in, milliseconds.
    times: [f64; 2],
    /// Evaluations likewise.
    evaluations: [u64; 2],
    /// For each kind of change the stages that run again; none where the scene has nothing to change.
    changes: Vec<(&'static str, Option<Vec<Stage>>)>,
}

impl Told {
    fn of(loaded: &Loaded, frames: u32) -> Self {
        let scene = &loaded.scene;
        let mut renderers = [false, true].map(|nothing| {
            let mut renderer = Renderer::with_clock(nanoseconds);
            renderer.set_model(loaded.model.clone());
            renderer.leave_nothing_out(nothing);
            renderer
        });
        let mut times: [Vec<u64>; 2] = Default::default();
        let mut stages: Vec<(Stage, Vec<u64>)> = Vec::new();
        let bar = progress_bar(u64::from(WARM_UP + frames), "measuring");
        for frame in 0..WARM_UP + frames {
            for (which, (renderer, times)) in renderers.iter_mut().zip(&mut times).enumerate() {
                renderer.redraw();
                renderer.render(scene);
                let report = renderer.report();
                if frame < WARM_UP {
                    continue;
                }
                times.push(report.nanoseconds);
                for run in report.stages.iter().filter(|_| which == 0) {
                    match stages.iter_mut().find(|(stage, _)| *stage == run.stage) {
                        Some((_, times)) => times.push(run.nanoseconds),
                        None => stages.push((run.stage, vec![run.nanoseconds])),
                    }
                }
            }
            bar.inc(1);
        }
        bar.finish_and_clear();
        let count = |renderer: &Renderer| renderer.terms().iter().map(|term| term.evaluations).sum();
        let [planned, all] = &mut renderers;
        let evaluations = [count(planned), count(all)];
        Self {
            terms: planned.terms(),
            stages: stages.into_iter().map(|(stage, mut times)| (stage, median_ms(&mut times))).collect(),
            times: times.map(|mut times| median_ms(&mut times)),
            evaluations,
            changes: CHANGES.map(|(name, change)| (name, run_again(planned, |step| change(scene, step)))).to_vec(),
        }
    }

    /// A stage's time and its share of all.
    fn time(&self, stage: Stage) -> Option<(f64, f64)> {
        let whole: f64 = self.stages.iter().map(|(_, ms)| ms).sum();
        let (_, ms) = self.stages.iter().find(|(known, _)| *known == stage)?;
        Some((*ms, if whole > 0.0 { ms / whole } else { 0.0 }))
    }

    fn json(&self, loaded: &Loaded, frames: u32) -> Value {
        let stages: Map<_, _> = self
            .stages
            .iter()
            .map(|(stage, ms)| (stage_name(*stage), json!({"time_ms": ms, "share": self.time(*stage).map(|t| t.1)})))
            .collect();
        let names = |stages: &Vec<Stage>| stages.iter().map(|stage| stage_name(*stage)).collect::<Vec<_>>();
        let changes: BTreeMap<_, _> =
            self.changes.iter().map(|(name, stages)| (*name, stages.as_ref().map(names))).collect();
        let ([planned, all], [planned_ms, all_ms]) = (self.evaluations, self.times);
        json!({
            "scene": loaded.name,
            "size": loaded.scene.image.size,
            "frames": frames,
            "terms": self.terms,
            "stages": stages,
            "saved": {
                "evaluations": {"plan": planned, "all": all, "ratio": ratio(all as f64, planned as f64)},
                "time": {"plan_ms": planned_ms, "all_ms": all_ms, "ratio": ratio(all_ms, planned_ms)},
            },
            "changes": changes,
        })
    }

    fn csv(&self) -> String {
        let mut table = Table::new("stage,name,per,evaluations,omitted,note");
        for Term { stage, name, per, evaluations, omitted, note } in &self.terms {
            let per = format!("{per:?}").to_lowercase();
            let [omitted, note] = [omitted, note].map(|words| words.unwrap_or_default());
            table.row(&[&stage_name(*stage), name, &per, evaluations, &omitted, &note]);
        }
        table.into_csv()
    }

    fn text(&self, loaded: &Loaded, frames: u32) -> String {
        let [width, height] = loaded.scene.image.size;
        let mut text = format!("{}: {width}×{height}, median of {frames} frames drawn anew\n", loaded.name);
        let mut last = None;
        for term in &self.terms {
            if last.replace(term.stage) != Some(term.stage) {
                let time = self
                    .time(term.stage)
                    .map_or_else(String::new, |(ms, share)| format!("{ms:9.3} ms  {:4.1} %", 100.0 * share));
                let _ = writeln!(text, "\n{:47}{time}", stage_name(term.stage));
            }
            let Term { name, per, evaluations, omitted, note, .. } = term;
            let per = format!("{per:?}").to_lowercase();
            match omitted {
                Some(reason) => writeln!(text, "  {name:32}left out: {reason}"),
                None => writeln!(
                    text,
                    "  {name:32}{per:6}{evaluations:14}{}",
                    note.map(|n| format!("  {n}")).unwrap_or_default()
                ),
            }
            .unwrap_or_default();
        }
        let ([planned, all], [planned_ms, all_ms]) = (self.evaluations, self.times);
        let _ = write!(
            text,
            "\nwork saved                    plan   all left in     ratio\n  \
             evaluations        {planned:13}{all:14}{:10.2}\n  \
             ms a frame         {planned_ms:13.3}{all_ms:14.3}{:10.2}\n\n\
             what runs again\n",
            ratio(all as f64, planned as f64),
            ratio(all_ms, planned_ms),
        );
        for (name, stages) in &self.changes {
            let names = stages.as_ref().map(|stages| stages.iter().map(|stage| stage_name(*stage)).collect::<Vec<_>>());
            let _ = writeln!(text, "  {name:14}{}", names.map_or_else(|| "-".to_owned(), |names| names.join(", ")));
        }
        text
    }
}

fn ratio(all: f64, planned: f64) -> f64 {
    if planned > 0.0 { all / planned } else { 1.0 }
}

/// The stages that run when a scene of one change follows another.
fn run_again(renderer: &mut Renderer, change: impl Fn(u32) -> Option<shading_lab::scene::Scene>) -> Option<Vec<Stage>> {
    renderer.render(&change(1)?);
    renderer.render(&change(2)?);
    Some(renderer.report().stages.iter().filter(|run| run.ran).map(|run| run.stage).collect())
}
