//! The state of the view: the scan of the polygon under the probe, the present step, and whether it plays.

use crate::analysis::scan::{Scan, lay_out_scan, scan_room};
use crate::app::engine::Engine;
use crate::app::session::action::Walk;
use crate::app::session::document::same_model;
use crate::figure::{Drawing, PlotStyle};
use crate::geometry::Mesh;
use crate::scene::Scene;
use eframe::egui::Context;
use glam::DVec2;
use std::ops::RangeInclusive;
use std::sync::Arc;

/// Longest pause after which playing catches up, in seconds. After a longer one it goes on from where it was.
const PAUSED: f64 = 0.5;

/// The scan as the window shows it.
#[derive(Debug)]
pub struct ScanView {
    /// Number of rows of enlarged pixels.
    pub rows: u32,
    /// Steps per second.
    pub speed: f64,
    step: usize,
    playing: Playing,
    /// Revision of the engine when it was last read, and the number of rows then.
    seen: Option<(u64, u32)>,
    taken: Option<Taken>,
    /// Step, style, width and maximum height that the drawing was laid out for.
    laid_out: Option<(usize, PlotStyle, [f32; 2])>,
    /// Drawing of the step, once it is laid out.
    pub drawing: Option<Drawing>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Playing {
    No,
    /// Playing starts with the next frame.
    Begins,
    /// Time at which the next step is due, in seconds.
    Until(f64),
}

/// A scan, with the input that it was made from.
#[derive(Debug)]
struct Taken {
    scene: Scene,
    model: Option<Arc<Mesh>>,
    face: u32,
    rows: u32,
    answer: Result<Arc<Scan>, String>,
}

impl Default for ScanView {
    fn default() -> Self {
        Self {
            rows: Scan::USUAL_ROWS,
            speed: 4.0,
            step: 0,
            playing: Playing::No,
            seen: None,
            taken: None,
            laid_out: None,
            drawing: None,
        }
    }
}

impl ScanView {
    /// Range of the speed, in steps per second.
    pub const SPEEDS: RangeInclusive<f64> = 0.5..=60.0;

    /// Scans the polygon under the probe if the polygon or the scene has changed.
    ///
    /// Another polygon begins at the pixel under the probe. The same polygon in another view stays at a step like the one before.
    pub fn update(&mut self, engine: &Engine, model: Option<&Arc<Mesh>>) {
        let now = Some((engine.revision, self.rows));
        // Positions differ in a picture that is drawn coarser while something is dragged.
        if self.seen == now || engine.coarser() > 1 {
            return;
        }
        self.seen = now;
        let (Some(face), Some(scene)) = (engine.probed_face(), engine.drawn()) else {
            self.taken = None;
            self.playing = Playing::No;
            return;
        };
        let before = self
            .taken
            .take()
            .filter(|taken| taken.face == face && same_model(taken.model.as_ref(), model));
        if before
            .as_ref()
            .is_some_and(|taken| taken.rows == self.rows && taken.scene == *scene)
        {
            self.taken = before;
            return;
        }
        self.laid_out = None;
        let Some(answer) = engine.scan(face, self.rows) else {
            return;
        };
        let answer = answer.map(Arc::new).map_err(|error| error.to_string());
        if let Ok(scan) = &answer {
            let old = before.as_ref().and_then(|taken| taken.answer.as_ref().ok());
            self.step = match (old, engine.probed()) {
                (Some(old), _) => scan.step_like(old, self.step),
                (None, Some(probe)) if self.playing == Playing::No => {
                    let [x, y] = probe.pixel.map(|side| f64::from(side) + 0.5);
                    scan.step_near(scan.grid.from_picture(DVec2::new(x, y)))
                }
                _ => 0,
            };
        }
        self.taken = Some(Taken {
            scene: scene.clone(),
            model: model.cloned(),
            face,
            rows: self.rows,
            answer,
        });
    }

    /// Returns the scan, or the reason why there is none; `None` if there is no polygon.
    pub fn scan(&self) -> Option<&Result<Arc<Scan>, String>> {
        self.taken.as_ref().map(|taken| &taken.answer)
    }

    /// Returns the scan, if there is one.
    pub fn ready(&self) -> Option<&Scan> {
        self.scan()?.as_deref().ok()
    }

    /// Returns the present step.
    pub fn step(&self) -> usize {
        self.ready().map_or(0, |scan| self.step.min(scan.last()))
    }

    /// Goes to a step and stays there.
    pub fn go_to(&mut self, step: usize) {
        self.step = step;
        self.playing = Playing::No;
    }

    /// Returns whether the steps advance by themselves.
    pub fn is_playing(&self) -> bool {
        self.playing != Playing::No
    }

    /// Goes to the step that `walk` leads to, or starts or stops playing.
    pub fn walk(&mut self, walk: Walk) {
        let Some(scan) = self.ready() else { return };
        let (step, last) = (self.step(), scan.last());
        let plays = walk == Walk::Play && !self.is_playing();
        let to = match walk {
            Walk::First => 0,
            Walk::Back(level) => scan.back(step, level),
            Walk::Forward(level) => scan.forward(step, level),
            Walk::Last => last,
            Walk::Play if step == last && plays => 0,
            Walk::Play => step,
        };
        self.go_to(to);
        self.playing = if plays { Playing::Begins } else { Playing::No };
    }

    /// Takes the steps that are due, and requests a repaint for the time of the next one. Requests none if nothing plays.
    pub fn play(&mut self, ctx: &Context) {
        let Some(last) = self.ready().map(Scan::last) else {
            return;
        };
        let (now, gap) = (ctx.input(|input| input.time), 1.0 / self.speed);
        let mut due = match self.playing {
            Playing::No => return,
            Playing::Begins => now + gap,
            Playing::Until(due) if now - due <= PAUSED => due,
            Playing::Until(_) => now,
        };
        while due <= now && self.step < last {
            self.step += 1;
            due += gap;
        }
        if self.step >= last {
            self.playing = Playing::No;
            return;
        }
        self.playing = Playing::Until(due);
        ctx.request_repaint_after_secs((due - now).max(0.0) as f32);
    }

    /// Lays out the drawing of the present step, unless step, size and style are unchanged.
    pub fn lay_out(&mut self, room: [f32; 2], style: PlotStyle) {
        let key = Some((self.step(), style, room));
        if self.laid_out == key {
            return;
        }
        self.laid_out = key;
        self.drawing = self.ready().map(|scan| {
            let [width, tallest] = room.map(f64::from);
            let room = scan_room(scan, width, tallest, &style);
            lay_out_scan(scan, self.step(), room, &style)
        });
    }
}
