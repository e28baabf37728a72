//! The interface of a question's widget to the course.

use crate::app::session::Session;
use crate::app::session::window::WindowState;
use crate::figure::short;
use crate::lesson::{Answer, Question, Solution, Staged, with_unit};
use crate::scene::Scene;
use crate::text::text;
use eframe::egui::Ui;
use egui_commonmark::CommonMarkCache;
use glam::DVec2;

/// A question's widget, with the answer in the making.
pub trait Widget {
    /// Restores a previous answer.
    fn take_up(&mut self, _given: &Answer) {}

    /// Shows the widget. Returns whether Enter was pressed in it.
    fn ui(&mut self, ui: &mut Ui, asked: &mut WidgetContext<'_>) -> bool;

    /// Returns the answer if it is complete; `scene` is the scene of the window.
    fn answer(&self, question: &Question, scene: &Scene) -> Option<Answer>;

    /// Shows the right answer in words and numbers, beside the student's.
    fn right_ui(
        &self,
        _ui: &mut Ui,
        _question: &Question,
        _right: &Solution,
        _given: &Answer,
        _session: &mut Session,
    ) {
    }

    /// Returns the point marked in the picture: its offset from the centre, in units of the shorter side.
    fn mark(&self) -> Option<DVec2> {
        None
    }

    /// Marks a point in the picture.
    fn put_mark(&mut self, _place: DVec2) {}

    /// Returns the position on the step's line under the pointer, from 0 to 1.
    fn along(&self) -> Option<f64> {
        None
    }
}

/// A question on display, with what its widget may read and change.
pub struct WidgetContext<'a> {
    /// The question.
    pub question: &'a Question,
    /// The texts of options or items, or the names of axes, with their numbers filled in.
    pub names: &'a [String],
    /// The right answer, once it is known.
    pub solution: Option<&'a Solution>,
    /// The answer of the wrong model that the student's agrees with.
    pub wrong: Option<&'a Solution>,
    /// True if the right answer is shown.
    pub revealed: bool,
    /// True in a test, where answers are kept without being checked.
    pub test: bool,
    /// The step's scene.
    pub staged: Option<&'a Staged>,
    /// The number of the lesson's opening, and the step's index.
    pub step: (u64, usize),
    /// The cache of laid-out texts.
    pub markdown: &'a mut CommonMarkCache,
    /// The scene of the window.
    pub scene: &'a Scene,
    /// The state that outlives the step.
    pub window: &'a mut WindowState,
    /// True if the answer has changed.
    pub changed: bool,
}

impl<'a> WidgetContext<'a> {
    /// Returns the right answer, if it is shown.
    pub fn right(&self) -> Option<&'a Solution> {
        self.solution.filter(|_| self.revealed)
    }
}

/// Shows the right number, and the student's.
pub fn numbers_ui(ui: &mut Ui, question: &Question, right: &Solution, given: &Answer) {
    let own = match given {
        Answer::Value(own) | Answer::Settings(own) => {
            with_unit(&short(*own), question.kind.asks().unit())
        }
        _ => String::new(),
    };
    let right = question.kind.words(&Answer::right(right), &[]);
    ui.label(text!("course-values", right = right, own = own));
}

/// Shows a link that puts settings into the scene.
pub fn set_ui(ui: &mut Ui, session: &mut Session, settings: &[String]) {
    if ui.link(text!("course-set-it")).clicked()
        && let Ok(scene) = session.document().scene.with_overrides(settings)
    {
        session.put_scene(scene);
    }
}
