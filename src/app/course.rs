//! The course: lessons beside the picture, step by step, with questions that are answered before the answer is shown.

mod curve;
mod data;
mod edges;
mod feedback;
mod formula;
mod glide;
mod handed_in;
mod list;
mod mark;
mod marking;
mod matching;
mod parts;
mod prose;
mod question;
mod step;
mod target;
mod work;

use data::Open;
pub use data::{Course, SavedProgress};
pub use edges::{paint as paint_edges, watch as watch_edges};
pub use glide::Glide;
use handed_in::handed_in_ui;
pub use mark::{from_pixel, paint};
#[cfg(target_arch = "wasm32")]
pub use marking::Marking;
#[cfg(target_arch = "wasm32")]
pub use matching::{Likeness, Target};
pub use step::{back_ui, head_ui};
#[cfg(target_arch = "wasm32")]
pub use work::Prepare;

use super::action::{Action, Turn};
use super::appearance::ViewName;
use super::document::{CoursePart, Document, Origin};
use super::engine::Engine;
use super::place::{ProbePoint, ProfileLine};
use super::state::AppState;
use crate::jobs::Background;
use crate::lesson::{LESSONS, Lesson, OVERLAYS, Staged, are_there, find};
use crate::text::text;
use eframe::egui::{Context, Ui, vec2};
use std::sync::Arc;

/// The list of lessons, or the step of the one that is open.
pub fn course_ui(ui: &mut Ui, state: &mut AppState, engine: &Engine) {
    ui.spacing_mut().item_spacing = vec2(8.0, 6.0);
    let mut course = std::mem::take(&mut state.course);
    if course.shown_hand_in().is_some() {
        handed_in_ui(ui, &mut course, state);
    } else if course.open.is_some() {
        step::step_ui(ui, &mut course, state, engine);
    } else {
        list::list_ui(ui, &mut course, state);
    }
    state.course = course;
}

impl AppState {
    /// Opens a lesson at the step that it was left at.
    pub fn open_lesson(&mut self, lesson: Arc<Lesson>, built_in: bool) {
        self.welcome = false;
        self.appearance.welcomed = true;
        self.leave_view();
        let step = self.course.begin(lesson, built_in);
        // The step's own controls stand beside its text.
        self.appearance.controls = false;
        self.picture_alone = false;
        self.turn_to(step);
    }

    /// Does what is asked of the course.
    pub fn turn(&mut self, turn: Turn) {
        let needs_texts = matches!(turn, Turn::Start | Turn::Open(_) | Turn::OpenAt(..));
        if needs_texts && !are_there() {
            // A web page is fetching them.
            self.ask(Action::Course(turn));
            return;
        }
        match turn {
            Turn::Start => match LESSONS.first() {
                Some(first) => self.open_lesson(Arc::new(first.lesson()), true),
                None => self.show_view(ViewName::Course),
            },
            Turn::Open(name) => {
                if let Some(lesson) = find(&name) {
                    self.open_lesson(Arc::new(lesson.lesson()), true);
                }
            }
            Turn::OpenAt(name, step) => {
                self.turn(Turn::Open(name));
                self.turn(Turn::To(step));
            }
            Turn::Own => {
                if let Some(lesson) = self.course.own.clone() {
                    self.open_lesson(lesson, false);
                }
            }
            Turn::Step(by) => {
                let Some(open) = &self.course.open else {
                    return;
                };
                let (step, last) = (open.step, open.lesson.steps.len() - 1);
                match step.checked_add_signed(by) {
                    Some(next) if next > last => self.finish_lesson(),
                    Some(next) => self.turn_to(next),
                    None => self.show_view(ViewName::Course),
                }
            }
            Turn::To(step) => self.turn_to(step),
            Turn::Again => {
                let staged = self
                    .course
                    .open
                    .as_ref()
                    .and_then(|open| open.staged.clone());
                if let Some(staged) = staged {
                    self.show_stage(&staged, false);
                    self.show_view(ViewName::Course);
                }
            }
            Turn::List => self.close_lesson(),
        }
    }

    fn turn_to(&mut self, step: usize) {
        self.course.go(step);
        self.show_view(ViewName::Course);
        let Some(open) = &self.course.open else {
            return;
        };
        if open.current().stage.is_file() {
            // A model may take its time.
            self.ask(Action::LoadStage);
            return;
        }
        match open.current().stage.load(open.lesson.folder.as_deref()) {
            Ok(staged) => self.stage(open.opening, open.step, Ok(Arc::new(staged))),
            Err(error) => self.stage(open.opening, open.step, Err(error.to_string())),
        }
    }

    /// Shows the scene of a step, or why it cannot be shown, if that step is still the present one.
    pub fn stage(&mut self, opening: u64, step: usize, staged: Result<Arc<Staged>, String>) {
        let Some(open) = &mut self.course.open else {
            return;
        };
        if (open.opening, open.step) != (opening, step) {
            return;
        }
        match staged {
            Ok(staged) => {
                open.staged = Some(Arc::clone(&staged));
                self.show_stage(&staged, true);
            }
            Err(why) => open.failed = Some(why),
        }
    }

    /// Shows a step's scene; with the answer's, where that may be seen and is `answered`.
    fn show_stage(&mut self, staged: &Staged, answered: bool) {
        let view = (self.appearance.views, self.appearance.view);
        let before = self.document.scene.clone();
        let lesson = self
            .course
            .open
            .as_ref()
            .map(|open| open.lesson.name.clone());
        let document = Document {
            scene: staged.scene.clone(),
            model: staged.model.clone(),
            origin: match &staged.path {
                Some(path) => Origin::File(path.clone()),
                None => Origin::BuiltIn(staged.name.clone()),
            },
            part: lesson.map_or(CoursePart::None, CoursePart::Step),
        };
        if !self.replace(document) {
            return;
        }
        (self.appearance.views, self.appearance.view) = view;
        self.seek_highlight = false;
        self.probe = staged.shown.probe.map_or(self.probe, ProbePoint);
        self.line = staged.shown.line.map_or(self.line, ProfileLine);
        self.show_overlays();
        if answered && self.course.revealed() {
            self.show_answer();
        }
        self.gliding = Glide::between(&before, &self.document.scene);
    }

    /// Draws over the picture what the step names.
    fn show_overlays(&mut self) {
        let Some(open) = &self.course.open else {
            return;
        };
        let shown = |name: &str| {
            debug_assert!(OVERLAYS.contains(&name));
            open.current().stage.overlays.contains(&name)
        };
        let overlay = &mut self.appearance.overlay;
        overlay.vectors = shown("vectors");
        overlay.angles = open.overlay.angles && !self.course.hides();
        overlay.face_normals = shown("normals");
        overlay.vertex_normals = shown("vertices");
    }

    /// Follows a change of the document into the lesson or out of it: what a lesson hides, locks and draws holds for its own
    /// scenes alone.
    pub fn follow_document(&mut self) {
        let part = &self.document.part;
        self.course.follow_hand_in(part);
        let Some(open) = &mut self.course.open else {
            return;
        };
        let in_view = matches!(part, CoursePart::Step(lesson) if *lesson == open.lesson.name);
        if in_view && !open.in_view {
            open.in_view = true;
            open.overlay = self.appearance.overlay.clone();
            self.show_overlays();
        } else if !in_view {
            self.leave_view();
        }
    }

    /// Draws over the picture again what was drawn before the lesson came into view.
    fn leave_view(&mut self) {
        if let Some(open) = &mut self.course.open
            && std::mem::take(&mut open.in_view)
        {
            self.appearance.overlay = open.overlay.clone();
        }
    }

    /// Moves on towards the scene of the step.
    pub fn glide(&mut self, ctx: &Context) {
        let Some(glide) = &mut self.gliding else {
            return;
        };
        let (scene, last) = glide.now(ctx);
        if last {
            self.gliding = None;
        } else {
            ctx.request_repaint();
        }
        self.document.scene = scene;
        // It is no change that could be lost.
        self.saved.scene.clone_from(&self.document.scene);
        self.derive();
    }

    /// Shows the settings that the right answer is about, and the one that was sought.
    pub fn show_answer(&mut self) {
        let Some(open) = &self.course.open else {
            return;
        };
        let (Some(question), Some(staged)) = (open.question(), &open.staged) else {
            return;
        };
        self.appearance.overlay.angles = open.overlay.angles;
        if !question.kind.asks().controls().is_empty() {
            return;
        }
        if let Ok(scene) = staged.scene.with_overrides(&question.set) {
            self.gliding = Glide::between(&self.document.scene, &scene);
            self.document.scene = scene;
            // The lesson's change is none that could be lost.
            self.saved = self.document.clone();
            self.derive();
        }
    }

    /// Leaves the lesson at its end.
    fn finish_lesson(&mut self) {
        if let Some(open) = &self.course.open {
            let name = open.lesson.name.clone();
            self.course.kept.left.remove(&name);
            self.course.kept.done.insert(name);
        }
        self.close_lesson();
    }

    fn close_lesson(&mut self) {
        self.leave_view();
        self.course.open = None;
        if let Some(handed_in) = &mut self.course.handed_in {
            handed_in.closed = true;
        }
        self.show_view(ViewName::Course);
    }

    /// The lesson follows the language.
    pub fn translate_lesson(&mut self) {
        if let Some(handed_in) = &mut self.course.handed_in {
            // Its texts are in the language before.
            handed_in.work = Background::default();
        }
        let Some(open) = &mut self.course.open else {
            return;
        };
        if let Some(lesson) = find(&open.lesson.name).filter(|_| open.built_in) {
            open.lesson = Arc::new(lesson.lesson());
        }
        self.course.openings += 1;
        open.opening = self.course.openings;
        open.prepared.clear();
    }

    /// Whether the picture is that of a lesson's step.
    pub fn shows_step(&self) -> bool {
        self.course.in_view().is_some()
    }

    /// Whether a lesson is open whose step is not what is shown.
    pub fn has_left_lesson(&self) -> bool {
        self.course.open.as_ref().is_some_and(Open::is_left)
    }

    /// Whether numbers are hidden until a question is answered.
    pub fn hides_numbers(&self) -> bool {
        self.course.hides()
    }
}

/// Says that numbers are hidden, in place of a view.
pub fn hidden_ui(ui: &mut Ui, state: &mut AppState) {
    ui.add_space(12.0);
    ui.label(text!("course-hidden"));
    if ui.button(text!("course-to-question")).clicked() {
        state.show_view(ViewName::Course);
    }
}
