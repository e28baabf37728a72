//! Recovery of unsaved work, which is kept in a file as long as there is some, and offered at the next start.
//!
//! Each window has a [`Slot`] of its own.

#[cfg_attr(target_arch = "wasm32", path = "recovery/page.rs")]
mod slot;

use super::appearance::ViewName;
use super::document::{Document, Origin};
use super::place::{ProbePoint, ProfileLine};
use crate::analysis::Watch;
use crate::app::session::Session;
use crate::app::session::window::WindowState;
use crate::app::widgets::background::Task;
use crate::document::load_scene;
use crate::jobs::Job;
use crate::scene::Scene;
use crate::text::text;
use eframe::egui::Context;
use glam::DVec2;
use serde::{Deserialize, Serialize};
use slot::Slot;
use std::path::Path;
use std::time::Duration;

/// Delay before a change is written, together with the changes that follow in that time; seconds.
const PAUSE: f64 = 3.0;
/// The beginning of the first line of a kept scene; [`Around`] follows as JSON.
const HEAD: &str = "# Unsaved work of shading-lab, from ";

/// The state kept beside the scene: its origin, and what was in view.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Around {
    origin: Origin,
    probe: ProbePoint,
    line: ProfileLine,
    view: ViewName,
    /// The pane that was active.
    pane: usize,
}

impl Around {
    fn of(session: &Session, window: &WindowState) -> Self {
        Self {
            origin: session.document().origin.clone(),
            probe: window.probe,
            line: window.line,
            view: window.appearance.view,
            pane: session.panes.active,
        }
    }

    /// Restores what was in view; skips values that no file of this program would contain.
    pub fn apply(&self, session: &mut Session, window: &mut WindowState) {
        let sound = |point: DVec2| point.is_finite() && point.abs().max_element() < 1e6;
        if sound(self.probe.0) {
            window.probe = self.probe;
        }
        if self.line.0.into_iter().all(sound) {
            window.line = self.line;
        }
        window.show_view(self.view);
        if session.document().scene.shown_panes().contains(&self.pane) {
            session.activate(self.pane);
        }
    }
}

/// The kept work of this window, and that of another one which was left behind.
pub struct Recovery {
    own: Slot,
    left: Option<Slot>,
    /// The document as last kept, and the state around it.
    kept: Option<(Document, Around)>,
    /// The time at which the next change is to be kept, seconds.
    due: Option<f64>,
    /// True if this window may have written its file.
    written: bool,
    writing: Option<Job<Task<()>>>,
}

impl Recovery {
    /// Takes a free file in `folder`, and the latest of those left behind. Returns `None` if no file can be created
    /// there.
    pub fn new(folder: &Path) -> Option<Self> {
        let (own, left) = slot::find(folder)?;
        Some(Self {
            own,
            left,
            kept: None,
            due: None,
            written: false,
            writing: None,
        })
    }

    /// Returns the file that was left behind, and the name of the document in it.
    pub fn left(&self) -> Option<(&Path, String)> {
        self.left
            .as_ref()
            .map(|slot| (&*slot.path, around(&slot.path).origin.name()))
    }

    /// Returns whether the work that was left behind is `shown` already.
    pub fn is_left(&self, shown: &Scene) -> bool {
        let left = self.left.as_ref().and_then(|slot| restore(&slot.path).ok());
        left.is_some_and(|(document, ..)| document.scene == *shown)
    }

    /// Takes over the work that was left behind as this window's own.
    pub fn adopt(&mut self) {
        if let Some(slot) = self.left.take() {
            self.forget();
            self.own = slot;
            self.written = true;
        }
    }

    /// Deletes the work that was left behind.
    pub fn delete(&mut self) {
        if let Some(slot) = self.left.take() {
            // A file that cannot be removed is offered again.
            let _ = slot::remove(&slot.path);
        }
    }

    /// Writes the document a while after it has changed, and deletes the file once the document is saved. Nothing runs
    /// in between.
    pub fn keep(
        &mut self,
        ctx: &Context,
        session: &mut Session,
        window: &WindowState,
        leaving: bool,
    ) {
        if let Some((_, Err(error))) = Job::take(&mut self.writing) {
            session.warning = Some(text!("not-kept", error = error));
        }
        if !session.modified() {
            self.forget();
        } else if !self.is_kept(session, window) && !leaving {
            let time = ctx.input(|input| input.time);
            let due = *self.due.get_or_insert(time + PAUSE);
            if time < due || self.writing.is_some() {
                ctx.request_repaint_after(Duration::from_secs_f64((due - time).max(0.1)));
            } else {
                let write = self.writer(session, window);
                let task = Task::new(move |_: &dyn Watch<()>| write());
                self.writing = Some(Job::start(task, |_| ()));
            }
        }
    }

    fn is_kept(&self, session: &Session, window: &WindowState) -> bool {
        let kept = |(document, around): &(Document, Around)| {
            document == session.document() && *around == Around::of(session, window)
        };
        self.kept.as_ref().is_some_and(kept)
    }

    /// Returns a function that writes the document as it is now.
    fn writer(
        &mut self,
        session: &Session,
        window: &WindowState,
    ) -> impl Fn() -> Result<(), String> + use<> {
        self.due = None;
        let around = Around::of(session, window);
        self.kept = Some((session.document().clone(), around.clone()));
        self.written = true;
        let (path, scene) = (self.own.path.clone(), session.document().scene.clone());
        move || {
            let around = serde_json::to_string(&around).unwrap_or_default();
            let text = format!("{HEAD}{around}\n{}", scene.to_toml());
            slot::write(&path, &text)
        }
    }

    /// Writes at once what has changed since the last time, before a page is left.
    pub fn write_now(&mut self, session: &Session, window: &WindowState) {
        if session.modified() && !self.is_kept(session, window) {
            // Nobody is left to be told.
            let _ = self.writer(session, window)();
        }
    }

    /// Deletes the kept work of this window.
    pub fn forget(&mut self) {
        (self.kept, self.due) = (None, None);
        if std::mem::take(&mut self.written) {
            if let Some(writing) = self.writing.take() {
                writing.wait();
            }
            // At worst it is offered once too often.
            let _ = slot::remove(&self.own.path);
        }
    }
}

/// Reads the state around the scene from a file of kept work.
fn around(path: &Path) -> Around {
    let text = slot::read(path);
    let around = text.lines().next().and_then(|line| line.strip_prefix(HEAD));
    around
        .and_then(|around| serde_json::from_str(around).ok())
        .unwrap_or_default()
}

/// Restores from a file of kept work: returns the document, the one that it was made from, and the state around it.
pub fn restore(path: &Path) -> Result<(Document, Document, Around), String> {
    let loaded = load_scene(path).map_err(|error| {
        let path = path.display().to_string();
        text!("work-stays", error = error.to_string(), path = path)
    })?;
    let around = around(path);
    let original = match &around.origin {
        Origin::New => None,
        Origin::BuiltIn(name) => Document::built_in(name),
        Origin::File(path) => load_scene(path).ok().map(Document::from),
    };
    let original = original.unwrap_or_default();
    let document = Document {
        scene: loaded.scene,
        model: loaded.model,
        origin: around.origin.clone(),
        part: original.part.clone(),
    };
    Ok((document, original, around))
}
