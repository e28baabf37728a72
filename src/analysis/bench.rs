//! The time of a frame.
//!
//! Every figure is the median over the frames asked for, after frames that are not counted: of everything drawn anew,
//! with its stages, and of frames in which a single thing changed since the frame before. Of a scene that compares panes all that
//! it shows are drawn.

mod changes;
mod growth;

pub use changes::{CHANGES, Change};
pub use growth::Growth;

use super::panes_on_sheet;
use super::report::{About, Answer, Column, Part, Report, Table, as_it_is, cells, fixed, word};
use super::{Question, Subject, Watch};
use crate::render::{Memory, Renderer, Report as Drawn, Stage, coarseness, coarser_size};
use crate::scene::Scene;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value, json};
use std::cell::Cell;

/// Frames that warm caches and buffers up before any is counted.
pub const WARM_UP: u32 = 2;

/// The time of a frame.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct BenchQuestion {
    /// Frames for each figure.
    pub frames: u32,
    /// Whether to measure also how the time grows with the pixels and with the triangles.
    pub growth: bool,
}

/// Medians in milliseconds.
#[derive(Clone, Debug)]
pub struct Bench {
    full: f64,
    stages: Vec<(Stage, f64)>,
    /// None where the scene has nothing of the kind to change.
    changes: Vec<(&'static str, Option<Changed>)>,
    /// Of a frame drawn anew; of a scene that compares panes the first one's.
    drawn: Drawn,
    memory: Memory,
    growth: Option<Growth>,
    frames: u32,
    threads: usize,
}

/// What a change costs.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Changed {
    whole: f64,
    /// While something is dragged: by what the sides of the picture are divided, and what that takes.
    dragged: (u32, f64),
}

/// Counts frames for whoever waits.
struct Frames<'a> {
    watch: &'a dyn Watch<()>,
    done: Cell<u64>,
    total: u64,
}

impl Frames<'_> {
    #[expect(clippy::cast_precision_loss, reason = "a share for the eye")]
    fn count(&self) {
        self.done.set(self.done.get() + 1);
        self.watch.at(self.done.get() as f32 / self.total as f32);
    }
}

impl Question for BenchQuestion {
    type Answer = Bench;

    fn answer(&self, subject: &Subject, watch: &dyn Watch<Bench>) -> Result<Bench, String> {
        let more = if self.growth { growth::most_frames(self.frames) } else { 0 };
        let total = u64::from(self.frames) * (1 + CHANGES.len() as u64) + more;
        let frames = Frames { watch: &|share| watch.at(share), done: Cell::new(0), total };
        let growth = self.growth.then(|| growth::measure(subject, self.frames, &frames));
        Ok(Bench { growth, ..measure(subject, self.frames, &frames) })
    }
}

/// The panes that a scene shows, a renderer each.
struct Panes {
    renderers: Vec<Renderer>,
    clock: fn() -> u64,
}

impl Panes {
    fn new(subject: &Subject) -> Self {
        let shown = panes_on_sheet(&subject.scene).len();
        let renderer = |_| {
            let mut renderer = subject.renderer();
            renderer.keep_linear(shown > 1);
            renderer
        };
        Self { renderers: (0..shown).map(renderer).collect(), clock: subject.clock }
    }

    /// Draws all panes, their sides divided by `coarser`, and says how long that took.
    fn draw(&mut self, scene: &Scene, coarser: u32) -> u64 {
        let mut time = 0;
        for ((index, size), renderer) in panes_on_sheet(scene).into_iter().zip(&mut self.renderers) {
            let mut shown = scene.pane(index).unwrap_or_else(|_| scene.clone());
            shown.image.size = coarser_size(size, coarser);
            let began = (self.clock)();
            renderer.render(&shown);
            time += (self.clock)() - began;
        }
        time
    }

    /// The first one's figures.
    fn figures(&self) -> (Drawn, Memory) {
        self.renderers.first().map(|first| (first.report().clone(), first.memory())).unwrap_or_default()
    }

    /// The median time of a frame in which only `change` differs from the frame before, milliseconds.
    fn measure_change(
        &mut self,
        scene: &Scene,
        change: Change,
        coarser: u32,
        frames: u32,
        count: &dyn Fn(),
    ) -> Option<f64> {
        let mut times = Vec::new();
        for frame in 0..WARM_UP + frames {
            let time = self.draw(&change(scene, 1 + frame % 8)?, coarser);
            if frame >= WARM_UP {
                times.push(time);
                count();
            }
        }
        Some(median_ms(&mut times))
    }
}

fn measure(subject: &Subject, frames: u32, counted: &Frames<'_>) -> Bench {
    let mut panes = Panes::new(subject);
    let scene = &subject.scene;
    let mut times = Vec::new();
    let mut stages = StageTimes::default();
    for frame in 0..WARM_UP + frames {
        panes.renderers.iter_mut().for_each(Renderer::redraw);
        let time = panes.draw(scene, 1);
        if frame >= WARM_UP {
            times.push(time);
            panes.renderers.iter().for_each(|renderer| stages.add(renderer.report()));
            counted.count();
        }
    }
    let (drawn, mut memory) = panes.figures();
    let changes = CHANGES.map(|(name, change)| {
        let whole = panes.measure_change(scene, change, 1, frames, &|| counted.count());
        let (changed, held) = panes.figures();
        // Of another tessellation the bytes would be divided by this one's triangles.
        if changed.triangles == drawn.triangles && held.total() > memory.total() {
            memory = held;
        }
        (name, whole.map(|whole| Changed { whole, dragged: dragged(subject, change, whole, frames) }))
    });
    Bench {
        full: median_ms(&mut times),
        stages: stages.medians(),
        changes: changes.to_vec(),
        drawn,
        memory,
        growth: None,
        frames,
        threads: rayon::current_num_threads(),
    }
}

/// What the window does while something is dragged that takes `whole` milliseconds.
fn dragged(subject: &Subject, change: Change, whole: f64, frames: u32) -> (u32, f64) {
    let (mut coarser, mut ms) = (1, whole);
    // Not every stage shrinks with the picture: what is still too slow is drawn coarser.
    loop {
        let next = coarseness((ms * 1e6) as u64 * u64::from(coarser * coarser));
        if next <= coarser {
            return (coarser, ms);
        }
        coarser = next;
        let measured = Panes::new(subject).measure_change(&subject.scene, change, coarser, frames, &|| ());
        ms = measured.unwrap_or(ms);
    }
}

/// Times of stages over several frames, nanoseconds.
#[derive(Default)]
pub(super) struct StageTimes(Vec<(Stage, Vec<u64>)>);

impl StageTimes {
    pub fn add(&mut self, drawn: &Drawn) {
        for run in &drawn.stages {
            match self.0.iter_mut().find(|(known, _)| *known == run.stage) {
                Some((_, times)) => times.push(run.nanoseconds),
                None => self.0.push((run.stage, vec![run.nanoseconds])),
            }
        }
    }

    /// In milliseconds.
    pub fn medians(self) -> Vec<(Stage, f64)> {
        self.0.into_iter().map(|(stage, mut times)| (stage, median_ms(&mut times))).collect()
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

impl Bench {
    /// Bytes a vertex, a triangle and a pixel; none where there are no such.
    #[expect(clippy::cast_precision_loss, reason = "far fewer bytes than 2⁵³")]
    fn bytes_each(&self, [width, height]: [u32; 2]) -> [Option<f64>; 3] {
        let Self { memory, drawn, .. } = self;
        let each = |bytes: u64, count: u64| (count > 0).then(|| bytes as f64 / count as f64);
        [
            each(memory.vertices, drawn.vertices),
            each(memory.triangles, drawn.triangles),
            each(memory.pixels, u64::from(width) * u64::from(height)),
        ]
    }

    fn evaluations(&self) -> u64 {
        self.drawn.stages.iter().map(|run| run.evaluations).sum()
    }
}

impl Answer for Bench {
    fn report(&self, about: &About<'_>) -> Report {
        let Drawn { triangles, covered, .. } = self.drawn;
        let (evaluations, Self { threads, frames, .. }) = (self.evaluations(), self);
        let mut report = Report::new(format!(
            "{}, {triangles} triangles, {covered} pixels covered, {evaluations} evaluations\n\
             {threads} threads, median of {frames} frames, ms",
            about.heading()
        ));
        let mut times = Table::new([
            Column::both("what", "", as_it_is),
            Column::both("median_ms", "ms", fixed::<3>),
            Column::both("dragged_ms", "while dragged", fixed::<3>),
            Column::both("coarser", "at 1/… of the size", as_it_is),
        ]);
        times.rows.push(cells!["everything", self.full, None::<f64>, None::<u32>]);
        times.rows.extend(self.stages.iter().map(|(stage, ms)| cells![word(stage), *ms, None::<f64>, None::<u32>]));
        times.rows.extend(self.changes.iter().map(|(name, changed)| {
            let dragged = changed.map(|changed| changed.dragged);
            let coarser = dragged.map(|(coarser, _)| coarser);
            cells![format!("{name} changed"), changed.map(|changed| changed.whole), dragged.map(|(_, ms)| ms), coarser]
        }));
        report.section("").push(Part::Table(times));
        let memory = report.section("memory, bytes each");
        let each = self.bytes_each(about.scene.image.size);
        for (name, bytes) in ["vertex", "triangle", "pixel"].into_iter().zip(each) {
            memory.quantity(bytes.map_or_else(|| "–".to_owned(), fixed::<1>), name);
        }
        memory.quantity(format!("{:.1} MB", self.memory.total() as f64 * 1e-6), "in all");
        if let Some(growth) = &self.growth {
            growth.describe(&mut report);
        }
        report
    }

    fn json(&self, about: &About<'_>) -> Value {
        let stages: Map<_, _> =
            self.stages.iter().map(|(stage, ms)| (word(stage), json!({ "median_ms": ms }))).collect();
        let change = |(name, changed): &(&str, Option<Changed>)| {
            let figures = match changed {
                Some(Changed { whole, dragged: (coarser, ms) }) => {
                    json!({ "median_ms": whole, "dragged": { "median_ms": ms, "coarser": coarser } })
                }
                None => json!({ "median_ms": null }),
            };
            ((*name).to_owned(), figures)
        };
        let [vertex, triangle, pixel] = self.bytes_each(about.scene.image.size);
        let mut object = json!({
            "scene": about.name,
            "full": { "median_ms": self.full },
            "stages": stages,
            "changes": self.changes.iter().map(change).collect::<Map<_, _>>(),
            "threads": self.threads,
            "size": about.scene.image.size,
            "triangles": self.drawn.triangles,
            "covered": self.drawn.covered,
            "evaluations": self.evaluations(),
            "frames": self.frames,
            "memory": {
                "total_bytes": self.memory.total(),
                "bytes_per_vertex": vertex,
                "bytes_per_triangle": triangle,
                "bytes_per_pixel": pixel,
            },
        });
        if let Some(growth) = &self.growth {
            object["growth"] = json!(growth);
        }
        object
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn medians_are_in_the_middle() {
        assert_eq!(median_ms(&mut [3_000_000, 1_000_000, 2_000_000]), 2.0);
        assert_eq!(median_ms(&mut [4_000_000, 1_000_000, 2_000_000, 3_000_000]), 2.5);
        assert_eq!(median_ms(&mut [7_000_000]), 7.0);
        assert_eq!(median_ms(&mut []), 0.0);
    }
}
