//! Lessons in the window: opening, going from step to step, and leaving. A step's scene is opened like any
//! other, so that it is one step of undo.

use super::state::AppState;
use crate::app::course::{Glide, as_target};
use crate::app::session::action::{Action, Turn};
use crate::app::session::appearance::ViewName;
use crate::app::session::document::{CoursePart, Document, Origin};
use crate::app::session::place::{ProbePoint, ProfileLine};
use crate::jobs::Background;
use crate::lesson::{LESSONS, Lesson, OVERLAYS, Staged, are_there, find};
use crate::text::text;
use eframe::egui::Context;
use std::sync::Arc;

impl AppState {
    /// Opens a lesson at the step where it was left.
    pub fn open_lesson(&mut self, lesson: Arc<Lesson>, built_in: bool) {
        self.window.welcome = false;
        self.window.appearance.welcomed = true;
        self.leave_view();
        let step = self.course.begin(lesson, built_in);
        // The step's own controls are beside its text.
        self.window.appearance.controls = false;
        self.window.picture_alone = false;
        self.turn_to(step);
    }

    /// Performs a request to the course.
    pub fn turn(&mut self, turn: Turn) {
        let needs_texts = matches!(turn, Turn::Start | Turn::Open(_) | Turn::OpenAt(..));
        if needs_texts && !are_there() {
            // A web page is still loading the lessons.
            self.requests.ask(Action::Course(turn));
            return;
        }
        match turn {
            Turn::Start => match LESSONS.first() {
                Some(first) => self.open_lesson(Arc::new(first.lesson()), true),
                None => self.window.show_view(ViewName::Course),
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
                    None => self.window.show_view(ViewName::Course),
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
                    self.window.show_view(ViewName::Course);
                }
            }
            Turn::List => self.close_lesson(),
        }
    }

    fn turn_to(&mut self, step: usize) {
        self.course.go(step);
        self.window.show_view(ViewName::Course);
        let Some(open) = &self.course.open else {
            return;
        };
        if open.current().stage.is_file() {
            // Loading a model may take a while.
            self.requests.ask(Action::LoadStage);
            return;
        }
        match open.current().stage.load(open.lesson.folder.as_deref()) {
            Ok(staged) => self.stage(open.opening, open.step, Ok(Arc::new(staged))),
            Err(error) => self.stage(open.opening, open.step, Err(error.to_string())),
        }
    }

    /// Shows the scene of a step, or the reason why it cannot be shown, if that step is still the current
    /// one.
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

    /// Shows a step's scene; if `answered` and the right answer may be seen, with the answer's settings.
    fn show_stage(&mut self, staged: &Staged, answered: bool) {
        let view = (self.window.appearance.views, self.window.appearance.view);
        let before = self.session.document().scene.clone();
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
        (self.window.appearance.views, self.window.appearance.view) = view;
        self.window.seek_highlight = false;
        self.window.probe = staged.shown.probe.map_or(self.window.probe, ProbePoint);
        self.window.line = staged.shown.line.map_or(self.window.line, ProfileLine);
        self.show_overlays();
        if answered && self.course.revealed() {
            self.show_answer();
        }
        self.course.gliding = Glide::between(&before, &self.session.document().scene);
    }

    /// Shows the overlays that the step names.
    fn show_overlays(&mut self) {
        let Some(open) = &self.course.open else {
            return;
        };
        let shown = |name: &str| {
            debug_assert!(OVERLAYS.contains(&name));
            open.current().stage.overlays.contains(&name)
        };
        let overlay = &mut self.window.appearance.overlay;
        overlay.vectors = shown("vectors");
        overlay.angles = open.overlay.angles && !self.course.hides();
        overlay.face_normals = shown("normals");
        overlay.vertex_normals = shown("vertices");
    }

    /// Follows a change of the document into the lesson or out of it: everything that a lesson hides, locks and
    /// draws applies to its own scenes only.
    pub fn follow_document(&mut self) {
        let part = &self.session.document().part;
        self.course.follow_hand_in(part);
        let Some(open) = &mut self.course.open else {
            return;
        };
        let in_view = matches!(part, CoursePart::Step(lesson) if *lesson == open.lesson.name);
        if in_view && !open.in_view {
            open.in_view = true;
            open.overlay = self.window.appearance.overlay.clone();
            self.show_overlays();
        } else if !in_view {
            self.leave_view();
        }
    }

    /// Restores the overlays from before the lesson came into view.
    fn leave_view(&mut self) {
        if let Some(open) = &mut self.course.open
            && std::mem::take(&mut open.in_view)
        {
            self.window.appearance.overlay = open.overlay.clone();
        }
    }

    /// Advances the animation towards the step's scene.
    pub fn glide(&mut self, ctx: &Context) {
        let Some(glide) = &mut self.course.gliding else {
            return;
        };
        let (scene, last) = glide.now(ctx);
        if last {
            self.course.gliding = None;
        } else {
            ctx.request_repaint();
        }
        self.session.show_scene(scene);
    }

    /// Restores the overlay of angles, and shows the settings that the right answer is about, unless the
    /// question has controls of its own.
    pub fn show_answer(&mut self) {
        let Some(open) = &self.course.open else {
            return;
        };
        let (Some(question), Some(staged)) = (open.question(), &open.staged) else {
            return;
        };
        self.window.appearance.overlay.angles = open.overlay.angles;
        if !question.kind.asks().controls().is_empty() {
            return;
        }
        if let Ok(scene) = staged.scene.with_overrides(&question.set) {
            self.course.gliding = Glide::between(&self.session.document().scene, &scene);
            self.session.show_scene(scene);
        }
    }

    /// Closes the lesson at its end, and marks it as done.
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
        self.window.show_view(ViewName::Course);
    }

    /// Translates the lesson into the current language.
    pub fn translate_lesson(&mut self) {
        if let Some(handed_in) = &mut self.course.handed_in {
            // The graded texts are in the previous language.
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

    /// Opens a match whose target is the current scene.
    pub fn set_as_target(&mut self) {
        match as_target(&self.session) {
            Some(lesson) => self.open_lesson(Arc::new(lesson), false),
            None => self.session.notice = Some(text!("course-target-file").into()),
        }
    }
}
