//! Settings: one of the step's controls is the answer.

use super::widget::{Widget, WidgetContext, numbers_ui, set_ui};
use crate::app::session::Session;
use crate::lesson::{Answer, Question, Solution, value_of};
use crate::scene::Scene;
use crate::text::text;
use eframe::egui::{RichText, Ui};

/// A hint to the control, which holds its value itself.
pub struct SettingsWidget;

impl Widget for SettingsWidget {
    fn ui(&mut self, ui: &mut Ui, asked: &mut WidgetContext<'_>) -> bool {
        if asked.revealed {
            return false;
        }
        let words = if asked.test {
            text!("course-settings.test")
        } else {
            text!("course-settings")
        };
        ui.label(RichText::new(words).weak());
        false
    }

    fn answer(&self, question: &Question, scene: &Scene) -> Option<Answer> {
        let control = question.kind.asks().controls().first()?;
        value_of(scene, control).ok().map(Answer::Settings)
    }

    fn right_ui(
        &self,
        ui: &mut Ui,
        question: &Question,
        right: &Solution,
        given: &Answer,
        session: &mut Session,
    ) {
        numbers_ui(ui, question, right, given);
        if let (Solution::Settings(right), [control]) = (right, question.kind.asks().controls()) {
            set_ui(ui, session, &[format!("{control}={right}")]);
        }
    }
}
