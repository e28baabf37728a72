//! The plan of a frame: how often each term is evaluated, omissions with their reasons, and the work that they save.

use super::bench::{CHANGES, StageTimes, WARM_UP, change_name, changed, median_ms};
use super::plan_words::{per_words, stage_words};
use super::report::{
    Answer, Column, Part, Report, ReportContext, Table, as_it_is, cells, fixed, grouped, table_of,
    word,
};
use super::{Question, Subject, Watch};
use crate::render::{Renderer, Stage, StageRun, Term};
use crate::scene::Scene;
use crate::text::{Message, text};
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value, json};

/// The question for the plan of a frame.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct PlanQuestion {
    /// Number of frames for each time.
    pub frames: u32,
}

/// A frame's plan, with times only if they were measured.
#[derive(Clone, Debug)]
pub struct FramePlan {
    /// All terms and steps, in the order of the stages.
    pub terms: Vec<Term>,
    /// Runs of the stages in the last frame.
    pub runs: Vec<StageRun>,
    /// The materials of a model, each with its evaluations; the name of the scene's is empty.
    pub materials: Vec<(String, u64)>,
    /// Times with and without the omissions, if they were measured.
    pub measured: Option<Saved>,
}

/// Measured savings of the plan.
#[derive(Clone, Debug, PartialEq)]
pub struct Saved {
    frames: u32,
    /// Median times of the stages, milliseconds.
    stages: Vec<(Stage, f64)>,
    /// Median times with the plan and with nothing omitted, milliseconds.
    times: [f64; 2],
    /// Evaluations with the plan and with nothing omitted.
    evaluations: [u64; 2],
    /// The stages that run again for each kind of change; none where the scene has nothing to change.
    changes: Vec<(&'static str, Option<Vec<Stage>>)>,
}

impl Question for PlanQuestion {
    type Answer = FramePlan;

    fn answer(&self, subject: &Subject, watch: &dyn Watch<FramePlan>) -> Result<FramePlan, String> {
        let (scene, frames) = (&subject.scene, self.frames);
        let mut renderers = [false, true].map(|nothing| {
            let mut renderer = subject.renderer();
            renderer.leave_nothing_out(nothing);
            renderer
        });
        let mut times: [Vec<u64>; 2] = Default::default();
        let mut stages = StageTimes::default();
        for frame in 0..WARM_UP + frames {
            for (which, (renderer, times)) in renderers.iter_mut().zip(&mut times).enumerate() {
                renderer.redraw();
                renderer.render(scene);
                if frame >= WARM_UP {
                    times.push(renderer.report().nanoseconds);
                    if which == 0 {
                        stages.add(renderer.report());
                    }
                }
            }
            watch.progress(frame as f32 / (WARM_UP + frames) as f32);
        }
        let count =
            |renderer: &Renderer| renderer.terms().iter().map(|term| term.evaluations).sum();
        let [planned, all] = &mut renderers;
        let evaluations = [count(planned), count(all)];
        let (terms, runs) = (planned.terms(), planned.report().stages.clone());
        let materials = planned.material_counts();
        let changes = CHANGES.map(|(name, change)| {
            (
                name,
                run_again(planned, |step| changed(scene, change, step)),
            )
        });
        let measured = Some(Saved {
            frames,
            stages: stages.medians(),
            evaluations,
            times: times.map(|mut times| median_ms(&mut times)),
            changes: changes.to_vec(),
        });
        Ok(FramePlan {
            terms,
            runs,
            materials,
            measured,
        })
    }
}

/// Returns the stages that run again after a change.
fn run_again(renderer: &mut Renderer, change: impl Fn(u32) -> Option<Scene>) -> Option<Vec<Stage>> {
    renderer.render(&change(1)?);
    renderer.render(&change(2)?);
    let ran = renderer.report().stages.iter().filter(|run| run.ran);
    Some(ran.map(|run| run.stage).collect())
}

impl Saved {
    /// Returns a stage's time, milliseconds, and its share of the time of all stages.
    fn time(&self, stage: Stage) -> Option<(f64, f64)> {
        let whole: f64 = self.stages.iter().map(|(_, ms)| ms).sum();
        let (_, ms) = self.stages.iter().find(|(known, _)| *known == stage)?;
        Some((*ms, if whole > 0.0 { ms / whole } else { 0.0 }))
    }

    /// Returns the ratios of the work without the plan to that with it: evaluations, and time.
    fn ratios(&self) -> [f64; 2] {
        let ratio = |[planned, all]: [f64; 2]| if planned > 0.0 { all / planned } else { 1.0 };
        [
            ratio(self.evaluations.map(|count| count as f64)),
            ratio(self.times),
        ]
    }

    /// Adds the tables of what the plan saves, and of the stages that changes run again.
    fn describe(&self, report: &mut Report) {
        let heads = [
            "",
            text!("engine-by-plan"),
            text!("engine-all-left-in"),
            text!("engine-ratio"),
        ];
        let mut table = Table::new(heads.map(|head| Column::shown(head, fixed::<3>)));
        let ([planned, all], [planned_ms, all_ms]) = (self.evaluations, self.times);
        let [evaluations, time] = self.ratios();
        table.rows = vec![
            cells![text!("engine-row-evaluations"), planned, all, evaluations],
            cells![text!("engine-row-time"), planned_ms, all_ms, time],
        ];
        let section = report.section(text!("engine-saved"));
        section.push(Part::Table(table));
        let section = report.section(text!("engine-runs-again"));
        section.push(Part::Table(table_of! { change in &self.changes;
            Column::shown("", as_it_is) => change_name(change.0);
            Column::shown("", as_it_is) => change.1.as_deref().map_or_else(|| "–".to_owned(), stage_names);
        }));
    }
}

/// Returns the name of a material to show; the scene's own has an empty one.
fn material_name(name: &str) -> &str {
    if name.is_empty() {
        text!("engine-plan-material-scene")
    } else {
        name
    }
}

/// Returns the names of stages in one line.
fn stage_names(stages: &[Stage]) -> String {
    let names: Vec<&str> = stages.iter().map(|stage| stage_words(*stage).0).collect();
    names.join(", ")
}

impl FramePlan {
    /// Returns a stage's name with its median time, if that was measured, otherwise with whether it ran last.
    fn heading(&self, stage: Stage) -> String {
        let (name, _) = stage_words(stage);
        let run = self.runs.iter().find(|run| run.stage == stage);
        match (&self.measured, run) {
            (Some(saved), _) => match saved.time(stage) {
                Some((ms, share)) => format!("{name}, {ms:.3} ms, {:.1} %", 100.0 * share),
                None => name.to_owned(),
            },
            (None, Some(run)) if run.ran => {
                text!(
                    "engine-ran",
                    stage = name,
                    ms = format!("{:.2}", run.nanoseconds as f64 / 1e6)
                )
            }
            (None, Some(_)) => text!("engine-kept", stage = name),
            (None, None) => text!("engine-not-needed", stage = name),
        }
    }
}

impl Answer for FramePlan {
    fn report(&self, about: &ReportContext<'_>) -> Report {
        let total: u64 = self.terms.iter().map(|term| term.evaluations).sum();
        let mut report = Report::new(match &self.measured {
            Some(Saved { frames, .. }) => {
                text!(
                    "engine-plan-measured",
                    about = about.heading(),
                    frames = *frames
                )
            }
            None => text!("engine-plan-total", count = total, number = grouped(total)),
        });
        for terms in self.terms.chunk_by(|a, b| a.stage == b.stage) {
            let section = report.section(self.heading(terms[0].stage));
            let done = terms.iter().filter(|term| term.omitted.is_none());
            let done: Vec<&Term> = done.collect();
            if !done.is_empty() {
                section.push(Part::Table(table_of! { term in &done;
                    Column::shown("", as_it_is) => term.name.to_string();
                    Column::shown("", as_it_is) => term.evaluations;
                    Column::shown("", as_it_is) => per_words(term.per);
                }));
            }
            for (term, note) in done.iter().filter_map(|term| Some((term, term.note?))) {
                let name = term.name.to_string();
                section.note(text!("engine-note", name = name, note = note.text()));
            }
            for (names, reason) in by_reason(terms) {
                let names = names.join(", ");
                section.note(text!("engine-left-out", names = names, reason = reason));
            }
        }
        if !self.materials.is_empty() {
            let section = report.section(text!("engine-plan-materials"));
            section.push(Part::Table(table_of! { material in &self.materials;
                Column::shown(text!("engine-plan-material"), as_it_is) => material_name(&material.0);
                Column::shown(text!("engine-plan-material-count"), as_it_is) => material.1;
            }));
        }
        if let Some(saved) = &self.measured {
            saved.describe(&mut report);
        }
        report
    }

    fn table(&self) -> Option<Table> {
        Some(table_of! { term in &self.terms;
            Column::key("stage") => word(&term.stage);
            Column::key("name") => term.name.to_string();
            Column::key("per") => word(&term.per);
            Column::key("evaluations") => term.evaluations;
            Column::key("omitted") => term.omitted.map(Message::text);
            Column::key("note") => term.note.map(Message::text);
        })
    }

    fn value(&self, about: &ReportContext<'_>) -> Value {
        let mut object =
            json!({ "scene": about.name, "size": about.scene.image.size, "terms": self.terms });
        if !self.materials.is_empty() {
            let material =
                |(name, count): &(String, u64)| json!({ "name": name, "evaluations": count });
            object["materials"] = self.materials.iter().map(material).collect();
        }
        let Some(saved) = &self.measured else {
            return object;
        };
        let stage = |(stage, ms): &(Stage, f64)| {
            (
                word(stage),
                json!({ "time_ms": ms, "share": saved.time(*stage).map(|(_, share)| share) }),
            )
        };
        let names = |stages: &Vec<Stage>| stages.iter().map(word).collect::<Vec<_>>();
        let change = |(name, stages): &(&str, Option<Vec<Stage>>)| {
            ((*name).to_owned(), json!(stages.as_ref().map(names)))
        };
        let ([planned, all], [planned_ms, all_ms]) = (saved.evaluations, saved.times);
        let [evaluations, time] = saved.ratios();
        object["frames"] = json!(saved.frames);
        object["stages"] = saved.stages.iter().map(stage).collect::<Map<_, _>>().into();
        object["saved"] = json!({
            "evaluations": { "plan": planned, "all": all, "ratio": evaluations },
            "time": { "plan_ms": planned_ms, "all_ms": all_ms, "ratio": time },
        });
        object["changes"] = saved
            .changes
            .iter()
            .map(change)
            .collect::<Map<_, _>>()
            .into();
        object
    }
}

/// Groups the omissions by reason; of several parts of one light only the first names it.
fn by_reason(terms: &[Term]) -> Vec<(Vec<String>, &'static str)> {
    let mut groups: Vec<(Vec<String>, Option<usize>, Message)> = Vec::new();
    for (term, reason) in terms.iter().filter_map(|term| Some((term, term.omitted?))) {
        let light = term.name.light();
        let last = groups.len().saturating_sub(1);
        // Parts of a light join only the group directly before them.
        let from = if light.is_some() { last } else { 0 };
        match groups[from..]
            .iter_mut()
            .find(|(_, of, known)| (*of, *known) == (light, reason))
        {
            Some((names, ..)) => names.push(term.name.part().to_owned()),
            None => groups.push((vec![term.name.to_string()], light, reason)),
        }
    }
    groups
        .into_iter()
        .map(|(names, _, reason)| (names, reason.text()))
        .collect()
}
