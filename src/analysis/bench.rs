//! The time of a frame: medians over the requested frames, after some that are not counted, of a frame drawn from
//! scratch, with its stages, and of frames in which a single thing changed. For a scene that compares panes, all visible
//! ones are drawn.

mod growth;

pub use growth::Growth;

use super::codec::Codec;
use super::comparison::panes_on_sheet;
use super::plan_words::stage_words;
use super::report::{
    Answer, Column, Part, Report, ReportContext, Table, as_it_is, cells, fixed, word,
};
use super::study::median_and_spread;
use super::{Question, Subject, Watch};
use crate::render::{DrawTime, FrameReport, Memory, Renderer, SimdLevel, Stage, coarser_size};
use crate::scene::{LightKind, Object, ObjectKind, Rgb, Scene};
use crate::text::text;
use fearless_simd::Level;
use glam::DQuat;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value, json};
use std::cell::Cell;

/// Number of uncounted frames that first warm up caches and buffers.
pub(super) const WARM_UP: u32 = 2;

/// The question for the time of a frame.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct BenchQuestion {
    /// Number of frames for each figure.
    pub frames: u32,
    /// True to measure also how the time grows with the pixels and with the triangles.
    pub growth: bool,
    /// SIMD level; without one, the machine's best.
    pub simd: Option<SimdLevel>,
}

/// Median times in milliseconds.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Bench {
    full: f64,
    stages: Vec<(Stage, f64)>,
    /// Times of the changes by name; none where the scene has nothing of the kind to change.
    changes: Vec<(String, Option<Changed>)>,
    /// Figures of a frame drawn from scratch; of a scene that compares panes those of the first.
    drawn: FrameReport,
    memory: Memory,
    growth: Option<Growth>,
    frames: u32,
    threads: usize,
    simd: SimdLevel,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
struct Changed {
    whole: f64,
    /// While the user drags something: the divisor of the picture's sides, and the time.
    dragged: (u32, f64),
}

impl Question for BenchQuestion {
    type Answer = Bench;

    const CODEC: Option<Codec<Bench>> = Some(Codec::plain());

    fn answer(&self, subject: &Subject, watch: &dyn Watch<Bench>) -> Result<Bench, String> {
        let (simd, level) = self.level()?;
        let more = if self.growth {
            growth::most_frames(self.frames)
        } else {
            0
        };
        let total = u64::from(self.frames) * (1 + CHANGES.len() as u64) + more;
        let done = Cell::new(0_u64);
        let count = || {
            done.set(done.get() + 1);
            watch.progress(done.get() as f32 / total as f32);
        };
        let run = Run {
            subject,
            level,
            frames: self.frames,
            count: &count,
        };
        let growth = self.growth.then(|| growth::measure(run));
        Ok(Bench {
            growth,
            ..measure(run, simd)
        })
    }
}

impl BenchQuestion {
    fn level(&self) -> Result<(SimdLevel, Level), String> {
        let available = SimdLevel::available();
        let wanted = |(name, _): &&(SimdLevel, Level)| self.simd.is_none_or(|simd| *name == simd);
        available.iter().find(wanted).copied().ok_or_else(|| {
            let names: Vec<_> = available.iter().map(|(name, _)| word(name)).collect();
            text!(
                "engine-no-simd-level",
                level = self.simd.as_ref().map(word).unwrap_or_default(),
                available = names.join(", ")
            )
        })
    }
}

/// A change of a scene by a number, up to 8 of which give different scenes; none where it has nothing to change.
pub type Change = fn(&mut Scene, f64) -> Option<()>;

/// The small changes whose frames are timed.
pub const CHANGES: [(&str, Change); 5] = [
    ("light", |scene, step| {
        let by = 0.01 * step * scene.camera.distance();
        let light = scene.lights.first_mut()?;
        match light.kind {
            LightKind::Directional => light.direction.x += 0.01 * step * light.direction.length(),
            _ => light.position.x += by.max(light.position.length() * 1e-3 * step),
        }
        Some(())
    }),
    ("n", |scene, step| {
        let n = &mut scene.material.n;
        *n = if n.is_finite() {
            *n * 0.9 + 0.1 * step
        } else {
            1000.0 + step
        };
        Some(())
    }),
    ("ka", |scene, step| {
        scene.material.ka = scene.material.ka * 0.9 + Rgb::splat(0.005 * step);
        Some(())
    }),
    ("camera", |scene, step| {
        let camera = &mut scene.camera;
        let turn = DQuat::from_axis_angle(camera.up.normalize(), 0.01 * step);
        camera.eye = camera.target + turn * (camera.eye - camera.target);
        Some(())
    }),
    ("tessellation", |scene, step| {
        // The teapot and the cube are tessellated differently at every fourth segment only.
        let (object, more) = (&mut scene.object, 4 * step as u32);
        let finer = object.segments + more;
        object.segments = if finer <= Object::MAX_DIVISIONS {
            finer
        } else {
            object.segments - more
        };
        (object.kind != ObjectKind::Obj).then_some(())
    }),
];

/// Describes the subject of a change.
pub(super) fn change_name(name: &str) -> &'static str {
    match name {
        "light" => text!("engine-change-light"),
        "camera" => text!("engine-change-camera"),
        "tessellation" => text!("engine-change-tessellation"),
        "ka" => "Ka",
        _ => "n",
    }
}

/// A subject being measured: at a SIMD level, with a number of frames for each figure, counted one by one.
#[derive(Clone, Copy)]
struct Run<'a> {
    subject: &'a Subject,
    level: Level,
    frames: u32,
    count: &'a dyn Fn(),
}

pub(super) fn changed(scene: &Scene, change: Change, number: u32) -> Option<Scene> {
    let mut scene = scene.clone();
    change(&mut scene, number.into())?;
    Some(scene)
}

/// The panes that a scene shows, with one renderer each.
struct Panes<'a> {
    renderers: Vec<Renderer>,
    run: Run<'a>,
}

impl<'a> Panes<'a> {
    fn new(run: Run<'a>) -> Self {
        let shown = panes_on_sheet(&run.subject.scene).len();
        let renderer = |_| {
            let mut renderer = run.subject.renderer().with_level(run.level);
            renderer.keep_linear(shown > 1);
            renderer
        };
        Self {
            renderers: (0..shown).map(renderer).collect(),
            run,
        }
    }

    /// Draws all panes, their sides divided by `coarser`, and returns the time taken.
    fn draw(&mut self, scene: &Scene, coarser: u32) -> u64 {
        let (mut time, clock) = (0, self.run.subject.clock);
        for ((index, size), renderer) in panes_on_sheet(scene).into_iter().zip(&mut self.renderers)
        {
            let mut shown = scene.pane(index).unwrap_or_else(|_| scene.clone());
            shown.image.size = coarser_size(size, coarser);
            renderer.stand_in(coarser);
            let began = clock();
            renderer.render(&shown);
            time += clock() - began;
        }
        time
    }

    fn figures(&self) -> (FrameReport, Memory) {
        self.renderers
            .first()
            .map(|first| (first.report().clone(), first.memory()))
            .unwrap_or_default()
    }

    /// Measures the median time of a frame in which only `change` differs from the previous frame, milliseconds.
    fn measure_change(&mut self, change: Change, coarser: u32) -> Option<f64> {
        let (run, mut times) = (self.run, Vec::new());
        for frame in 0..WARM_UP + run.frames {
            let scene = changed(&run.subject.scene, change, 1 + frame % 8)?;
            let time = self.draw(&scene, coarser);
            if frame >= WARM_UP {
                times.push(time);
                (run.count)();
            }
        }
        Some(median_ms(&mut times))
    }
}

fn measure(run: Run<'_>, simd: SimdLevel) -> Bench {
    let mut panes = Panes::new(run);
    let mut times = Vec::new();
    let mut stages = StageTimes::default();
    for frame in 0..WARM_UP + run.frames {
        panes.renderers.iter_mut().for_each(Renderer::redraw);
        let time = panes.draw(&run.subject.scene, 1);
        if frame >= WARM_UP {
            times.push(time);
            for renderer in &panes.renderers {
                stages.add(renderer.report());
            }
            (run.count)();
        }
    }
    let (drawn, mut memory) = panes.figures();
    let changes = CHANGES.map(|(name, change)| {
        let whole = panes.measure_change(change, 1);
        let (changed, held) = panes.figures();
        // With another tessellation the bytes would be divided by this one's triangles.
        if changed.triangles == drawn.triangles && held.total() > memory.total() {
            memory = held;
        }
        let changed = whole.map(|whole| Changed {
            whole,
            dragged: dragged(run, change, whole),
        });
        (name.to_owned(), changed)
    });
    Bench {
        full: median_ms(&mut times),
        stages: stages.medians(),
        changes: changes.to_vec(),
        drawn,
        memory,
        growth: None,
        frames: run.frames,
        threads: rayon::current_num_threads(),
        simd,
    }
}

/// Measures the window's resolution and time while the user drags something that takes `whole` milliseconds.
fn dragged(run: Run<'_>, change: Change, whole: f64) -> (u32, f64) {
    let run = Run {
        count: &|| (),
        ..run
    };
    let nanoseconds = |ms: f64| (ms * 1e6) as u64;
    let mut time = DrawTime {
        whole: nanoseconds(whole),
        fixed: 0,
    };
    let (mut coarser, mut ms) = (1, whole);
    // What does not depend on the resolution is known once a coarser picture has been drawn.
    loop {
        let next = time.coarseness();
        if next <= coarser {
            return (coarser, ms);
        }
        coarser = next;
        ms = Panes::new(run)
            .measure_change(change, coarser)
            .unwrap_or(ms);
        time = time.after(coarser, nanoseconds(ms));
    }
}

/// Times of stages over several frames, nanoseconds.
#[derive(Default)]
pub(super) struct StageTimes(Vec<(Stage, Vec<u64>)>);

impl StageTimes {
    pub fn add(&mut self, drawn: &FrameReport) {
        for run in &drawn.stages {
            match self.0.iter_mut().find(|(known, _)| *known == run.stage) {
                Some((_, times)) => times.push(run.nanoseconds),
                None => self.0.push((run.stage, vec![run.nanoseconds])),
            }
        }
    }

    /// Returns the medians in milliseconds.
    pub fn medians(self) -> Vec<(Stage, f64)> {
        self.0
            .into_iter()
            .map(|(stage, mut times)| (stage, median_ms(&mut times)))
            .collect()
    }
}

/// Returns the median of nanoseconds, in milliseconds; of an even number the mean of the middle two.
pub(super) fn median_ms(times: &mut [u64]) -> f64 {
    median_and_spread(times).0
}

impl Bench {
    /// Returns the bytes per vertex, per triangle and per pixel; none where there are none of these.
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
    fn report(&self, about: &ReportContext<'_>) -> Report {
        let counts = text!(
            "engine-bench-counts",
            about = about.heading(),
            triangles = self.drawn.triangles,
            covered = self.drawn.covered,
            evaluations = self.evaluations()
        );
        let measured = text!(
            "engine-bench-measured",
            threads = self.threads,
            simd = word(&self.simd),
            frames = self.frames
        );
        let mut report = Report::new(format!("{counts}\n{measured}"));
        let mut times = Table::new([
            Column::key("what"),
            Column::shown("", as_it_is),
            Column::both("median_ms", "ms", fixed::<3>),
            Column::both("dragged_ms", text!("engine-dragged"), fixed::<3>).extra(),
            Column::both("coarser", text!("engine-coarser"), as_it_is).extra(),
        ]);
        times.rows.push(cells![
            "everything",
            text!("engine-everything"),
            self.full,
            None::<f64>,
            None::<u32>
        ]);
        times.rows.extend(self.stages.iter().map(|(stage, ms)| {
            let (name, _) = stage_words(*stage);
            cells![word(stage), name, *ms, None::<f64>, None::<u32>]
        }));
        times
            .rows
            .extend(self.changes.iter().map(|(name, changed)| {
                let dragged = changed.map(|changed| changed.dragged);
                cells![
                    format!("{name} changed"),
                    text!("engine-changed", what = change_name(name)),
                    changed.map(|changed| changed.whole),
                    dragged.map(|(_, ms)| ms),
                    dragged.map(|(coarser, _)| coarser)
                ]
            }));
        report.section("").push(Part::Table(times));
        let memory = report.section(text!("engine-memory"));
        let each = self.bytes_each(about.scene.image.size);
        let names = [
            "engine-per-vertex",
            "engine-per-triangle",
            "engine-per-pixel",
        ];
        for (name, bytes) in names.into_iter().zip(each) {
            memory.quantity(
                bytes.map_or_else(|| "–".to_owned(), fixed::<1>),
                text!(name),
            );
        }
        memory.quantity(
            format!("{:.1} MB", self.memory.total() as f64 * 1e-6),
            text!("engine-in-all"),
        );
        if let Some(growth) = &self.growth {
            growth.describe(&mut report);
        }
        report
    }

    fn value(&self, about: &ReportContext<'_>) -> Value {
        let stage = |(stage, ms): &(Stage, f64)| (word(stage), json!({ "median_ms": ms }));
        let change = |(name, changed): &(String, Option<Changed>)| {
            let mut figures = json!({ "median_ms": changed.map(|changed| changed.whole) });
            if let Some((coarser, ms)) = changed.map(|changed| changed.dragged) {
                figures["dragged"] = json!({ "median_ms": ms, "coarser": coarser });
            }
            (name.clone(), figures)
        };
        let [vertex, triangle, pixel] = self.bytes_each(about.scene.image.size);
        let mut object = json!({
            "scene": about.name,
            "full": { "median_ms": self.full },
            "stages": self.stages.iter().map(stage).collect::<Map<_, _>>(),
            "changes": self.changes.iter().map(change).collect::<Map<_, _>>(),
            "threads": self.threads,
            "simd": self.simd,
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
