//! A formula: a field to type it in, the formula as a textbook sets it, and its names and signs as buttons.

use super::widget::{Widget, WidgetContext};
use crate::app::course::parts::{error_ui, right_colour};
use crate::app::course::prose::caption_ui;
use crate::app::system;
use crate::app::widgets::focus::{named, one_stop};
use crate::lesson::{Answer, FORMULA_SIGNS, Formula, Kind, Question, Solution};
use crate::scene::Scene;
use crate::text::text;
use eframe::egui::accesskit::Role;
use eframe::egui::text::{CCursor, CCursorRange};
use eframe::egui::text_edit::TextEditState;
use eframe::egui::{
    Context, Event, Id, Key, KeyboardShortcut, Modifiers, RichText, TextEdit, TextStyle, Ui,
};

/// The width of a window that is a phone's, in points.
const NARROW: f32 = 600.0;

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
        let (entered, id) = self.field_ui(ui, asked);
        if !asked.revealed {
            let row = ui.horizontal_wrapped(|ui| {
                let names = formula.names.iter().map(|name| &*name.name);
                self.keys_ui(ui, id, names) | self.signs_ui(ui, id)
            });
            one_stop(ui, row.response.rect);
            asked.changed |= row.inner;
        }
        if !self.typed.trim().is_empty() {
            let set = Formula::set(&self.typed);
            ui.push_id("typed", |ui| caption_ui(ui, asked.markdown, &set));
            if let Err(error) = formula.function(self.typed.trim()) {
                error_ui(ui, &error.to_string());
            }
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
    /// Shows the field. Returns whether Enter was pressed in it, and its identity.
    fn field_ui(&mut self, ui: &mut Ui, asked: &mut WidgetContext<'_>) -> (bool, Id) {
        // Enter checks the answer; Shift+Enter begins a line.
        let line = KeyboardShortcut::new(Modifiers::SHIFT, Key::Enter);
        let field = TextEdit::multiline(&mut self.typed)
            .font(TextStyle::Monospace)
            .hint_text(text!("course-formula"))
            .char_limit(Formula::MOST_CHARACTERS)
            .desired_rows(1)
            .desired_width(f32::INFINITY)
            .return_key(line);
        let field = ui.add_enabled(!asked.revealed, field);
        let field = named(field, Role::MultilineTextInput, text!("course-answer"));
        asked.changed |= field.changed();
        let entered = ui.input(|input| {
            // An input method ends the composition of a word by the same key.
            let composes = input
                .events
                .iter()
                .any(|event| matches!(event, Event::Ime(_)));
            input.key_pressed(Key::Enter) && input.modifiers.is_none() && !composes
        });
        (entered && field.has_focus(), field.id)
    }

    /// Shows a button for each of several texts, which puts it where the cursor is. Returns whether one was.
    fn keys_ui<'k>(&mut self, ui: &mut Ui, id: Id, keys: impl Iterator<Item = &'k str>) -> bool {
        let mut put = false;
        for key in keys {
            let button = ui.button(RichText::new(key).monospace());
            let button = named(
                button,
                Role::Button,
                &text!("course-formula-put", key = key),
            );
            if button.clicked() {
                self.put(ui.ctx(), id, key);
                put = true;
            }
        }
        put
    }

    /// Shows the signs where they are hard to type.
    fn signs_ui(&mut self, ui: &mut Ui, id: Id) -> bool {
        let narrow = ui.ctx().content_rect().width() < NARROW;
        (narrow || system::fingers(ui.ctx())) && self.keys_ui(ui, id, FORMULA_SIGNS.into_iter())
    }

    /// Puts a text where the cursor is, in place of what is selected, and goes on after it.
    fn put(&mut self, ctx: &Context, id: Id, key: &str) {
        let mut state = TextEditState::load(ctx, id).unwrap_or_default();
        let end = self.typed.chars().count();
        let range = state.cursor.char_range();
        let range = range.map_or(end..end, |range| {
            let range = range.as_sorted_char_range();
            range.start.0..range.end.0
        });
        let (start, after) = (range.start.min(end), range.end.min(end));
        let before: String = self.typed.chars().take(start).collect();
        let rest: String = self.typed.chars().skip(after).collect();
        // Two names side by side would be one.
        let apart =
            before.ends_with(char::is_alphanumeric) && key.starts_with(char::is_alphanumeric);
        let key = if apart {
            format!(" {key}")
        } else {
            key.to_owned()
        };
        let cursor = CCursor::new(start + key.chars().count());
        self.typed = before + &key + &rest;
        state.cursor.set_char_range(Some(CCursorRange::one(cursor)));
        state.store(ctx, id);
        ctx.memory_mut(|memory| memory.request_focus(id));
    }
}
