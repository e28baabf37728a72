//! A value: a field for a number.

use super::widget::{Widget, WidgetContext, numbers_ui};
use crate::app::controls::row::evaluate;
use crate::app::session::Session;
use crate::app::widgets::focus::named;
use crate::app::widgets::theme::text_field;
use crate::lesson::{Answer, Kind, Question, Solution};
use crate::scene::Scene;
use crate::text::text;
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, RichText, Ui};

/// A field for a number, with the text typed in it.
#[derive(Default)]
pub struct ValueWidget {
    typed: String,
}

impl Widget for ValueWidget {
    fn take_up(&mut self, given: &Answer) {
        if let Answer::Value(value) = given {
            self.typed = value.to_string();
        }
    }

    fn ui(&mut self, ui: &mut Ui, asked: &mut WidgetContext<'_>) -> bool {
        let Kind::Value(value) = &asked.question.kind else {
            return false;
        };
        let mut entered = false;
        ui.horizontal(|ui| {
            let field = text_field(&mut self.typed)
                .hint_text(text!("course-number"))
                .desired_width(110.0);
            let field = ui.add_enabled(!asked.revealed, field);
            let field = named(field, Role::TextInput, text!("course-answer"));
            asked.changed |= field.changed();
            entered = field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
            if entered {
                // Ready for the next try; after a right answer the focus moves to the next step's button.
                field.request_focus();
            }
            if !value.unit.is_empty() {
                ui.label(&value.unit);
            }
        });
        let typed = self.typed.trim();
        let wrong = match evaluate(typed) {
            _ if typed.is_empty() => None,
            None => Some(text!("course-no-number").to_owned()),
            Some(number) if (value.from..=value.to).contains(&number) => None,
            Some(_) => asked.question.kind.asks().hint(),
        };
        if let Some(wrong) = wrong {
            ui.label(RichText::new(wrong).color(ui.visuals().error_fg_color));
        }
        entered
    }

    fn answer(&self, _: &Question, _: &Scene) -> Option<Answer> {
        evaluate(&self.typed).map(Answer::Value)
    }

    fn right_ui(
        &self,
        ui: &mut Ui,
        question: &Question,
        right: &Solution,
        given: &Answer,
        _: &mut Session,
    ) {
        numbers_ui(ui, question, right, given);
    }
}
