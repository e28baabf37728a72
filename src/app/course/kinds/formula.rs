//! A formula: a field to type it in, the formula as a textbook sets it, and its names and signs as buttons.

use super::widget::{Widget, WidgetContext};
use crate::app::course::prose::caption_ui;
use crate::app::system;
use crate::app::widgets::focus::one_stop;
use crate::app::widgets::formula_field::{FormulaField, set_ui, wants_signs};
use crate::app::widgets::palette::right_colour;
use crate::lesson::{Answer, FORMULA_SIGNS, Formula, Kind, Question, Solution};
use crate::scene::Scene;
use crate::text::text;
use eframe::egui::{Event, Key, KeyboardShortcut, Modifiers, RichText, Ui};

/// A field for a formula, with the text typed in it.
#[derive(Default)]
pub struct FormulaWidget {
    typed: String,
}

impl Widget for FormulaWidget {
    fn take_up(&mut self, given: &Answer) {
        if let Answer::Formula(text) = given {
            self.typed.clone_from(text);
        }
    }

    fn ui(&mut self, ui: &mut Ui, asked: &mut WidgetContext<'_>) -> bool {
        let Kind::Formula(formula) = &asked.question.kind else {
            return false;
        };
        let field = FormulaField {
            id: ui.scope_id().with(("formula", asked.step)),
            name: text!("course-answer"),
            hint: text!("course-formula"),
            rows: 1,
            longest: Formula::MOST_CHARACTERS,
            // Enter checks the answer; Shift+Enter begins a line.
            new_line: KeyboardShortcut::new(Modifiers::SHIFT, Key::Enter),
        };
        let entered = self.field_ui(ui, &field, asked);
        if !asked.revealed {
            let names = formula.names.iter().map(|name| &*name.name);
            let wants_signs = wants_signs(ui.ctx(), system::fingers(ui.ctx()));
            let signs = FORMULA_SIGNS.into_iter().filter(|_| wants_signs);
            let row = ui.horizontal_wrapped(|ui| {
                field.keys_ui(ui, &mut self.typed, names.chain(signs), &|_| String::new())
            });
            one_stop(ui, row.response.rect);
            asked.changed |= row.inner;
        }
        if !self.typed.trim().is_empty() {
            let error = formula.function(self.typed.trim()).err();
            set_ui(ui, &self.typed, error.as_ref());
        }
        if let Some(Solution::Formula(right)) = asked.right() {
            ui.horizontal_wrapped(|ui| {
                ui.label(RichText::new(text!("course-formula-right")).color(right_colour(ui)));
                ui.push_id("right", |ui| {
                    caption_ui(ui, asked.markdown, &Formula::set(right));
                });
            });
        }
        entered
    }

    fn answer(&self, question: &Question, _: &Scene) -> Option<Answer> {
        let Kind::Formula(formula) = &question.kind else {
            return None;
        };
        let typed = self.typed.trim();
        formula.function(typed).ok()?;
        Some(Answer::Formula(typed.to_owned()))
    }
}

impl FormulaWidget {
    /// Shows the field. Returns whether Enter was pressed in it.
    fn field_ui(
        &mut self,
        ui: &mut Ui,
        field: &FormulaField<'_>,
        asked: &mut WidgetContext<'_>,
    ) -> bool {
        let shown = ui.add_enabled_ui(!asked.revealed, |ui| field.ui(ui, &mut self.typed));
        let field = shown.inner;
        asked.changed |= field.changed();
        let entered = ui.input(|input| {
            // An input method ends the composition of a word by the same key.
            let composes = input
                .events
                .iter()
                .any(|event| matches!(event, Event::Ime(_)));
            input.key_pressed(Key::Enter) && input.modifiers.is_none() && !composes
        });
        entered && field.has_focus()
    }
}
