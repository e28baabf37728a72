//! A question's widget: all that the course asks of one.

use crate::app::session::Session;
use crate::app::session::window::WindowState;
use crate::figure::short;
use crate::lesson::{Answer, Question, Solution, Staged};
use crate::scene::Scene;
use crate::text::text;
use eframe::egui::Ui;
use egui_commonmark::CommonMarkCache;
use glam::DVec2;

/// A question's widget, with the answer that is being made in it.
pub trait Widget {
    /// Takes up an answer that was given before.
    fn take_up(&mut self, _given: &Answer) {}

    /// Shows the widget. Returns whether Enter was pressed in it.
    fn ui(&mut self, ui: &mut Ui, asked: &mut Asked<'_>) -> bool;

    /// Returns the answer, where there is a whole one; `scene` is that of the window.
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

    /// Returns the place that is marked in the picture, from its middle in units of its shorter side.
    fn mark(&self) -> Option<DVec2> {
        None
    }

    /// Marks a place in the picture.
    fn put_mark(&mut self, _place: DVec2) {}

    /// Returns the place on the step's line that the pointer is on, from 0 to 1.
    fn along(&self) -> Option<f64> {
        None
    }
}

/// A question that is asked, with what its widget may read and change.
pub struct Asked<'a> {
    /// The question.
    pub question: &'a Question,
    /// The texts of options or items, or the names of axes, with their numbers.
    pub names: &'a [String],
    /// The right answer, once it is known.
    pub solution: Option<&'a Solution>,
    /// The right answer is shown.
    pub revealed: bool,
    /// The step's scene.
    pub staged: Option<&'a Staged>,
    /// The opening of the lesson, and the step.
    pub step: (u64, usize),
    /// The texts that were laid out.
    pub markdown: &'a mut CommonMarkCache,
    /// The scene of the window.
    pub scene: &'a Scene,
    /// The state that outlives the step.
    pub window: &'a mut WindowState,
    /// The answer has changed.
    pub changed: bool,
}

impl<'a> Asked<'a> {
    /// Returns the right answer, where it is shown.
    pub fn right(&self) -> Option<&'a Solution> {
        self.solution.filter(|_| self.revealed)
    }
}

/// Shows the right number, and the student's.
pub fn numbers_ui(ui: &mut Ui, question: &Question, right: &Solution, given: &Answer) {
    let own = match given {
        Answer::Value(own) | Answer::Settings(own) => short(*own),
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
