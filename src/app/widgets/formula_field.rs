//! A field for a formula, with its names and signs as buttons, and the formula as textbooks set it.

use super::focus::named;
use super::formula::formula_ui;
use super::theme::NARROW;
use crate::expression::FormulaError;
use crate::figure::typed;
use crate::text::text;
use eframe::egui::accesskit::Role;
use eframe::egui::text::{CCursor, CCursorRange};
use eframe::egui::text_edit::TextEditState;
use eframe::egui::{
    Button, Context, Id, KeyboardShortcut, Label, Response, RichText, TextEdit, TextStyle, Ui,
};
use std::cell::Cell;

/// A field for a formula.
#[derive(Clone, Copy, Debug)]
pub struct FormulaField<'a> {
    /// Identity of the field.
    pub id: Id,
    /// Accessible name.
    pub name: &'a str,
    /// The text of an empty field.
    pub hint: &'static str,
    /// Lines of an empty field.
    pub rows: usize,
    /// Most characters.
    pub longest: usize,
    /// Keys that begin a line.
    pub new_line: KeyboardShortcut,
}

impl FormulaField<'_> {
    /// Shows the field.
    pub fn ui(&self, ui: &mut Ui, typed: &mut String) -> Response {
        let field = TextEdit::multiline(typed)
            .id(self.id)
            .font(TextStyle::Monospace)
            .hint_text(self.hint)
            .char_limit(self.longest)
            .desired_rows(self.rows)
            .desired_width(f32::INFINITY)
            .return_key(self.new_line);
        named(ui.add(field), Role::MultilineTextInput, self.name)
    }

    /// Shows a button for each key, which puts it where the cursor of the field is; `tip` returns what a key means, or an empty
    /// text. Returns whether one was put.
    pub fn keys_ui<'k>(
        &self,
        ui: &mut Ui,
        typed: &mut String,
        keys: impl IntoIterator<Item = &'k str>,
        tip: &dyn Fn(&str) -> String,
    ) -> bool {
        let mut was_put = false;
        for key in keys {
            let button = ui.add(Button::new(RichText::new(key).monospace()));
            let name = text!("course-formula-put", key = key);
            let mut button = named(button, Role::Button, &name);
            if button.hovered() {
                let tip = tip(key);
                if !tip.is_empty() {
                    button = button.on_hover_text(tip);
                }
            }
            if button.clicked() {
                self.put(ui.ctx(), typed, key);
                was_put = true;
            }
        }
        was_put
    }

    /// Inserts a text at the cursor, in place of the selection, and moves the cursor behind it.
    fn put(&self, ctx: &Context, typed: &mut String, key: &str) {
        let mut state = TextEditState::load(ctx, self.id).unwrap_or_default();
        let end = typed.chars().count();
        let range = state.cursor.char_range();
        let range = range.map_or(end..end, |range| {
            let range = range.as_sorted_char_range();
            range.start.0..range.end.0
        });
        let (start, after) = (range.start.min(end), range.end.min(end));
        let before: String = typed.chars().take(start).collect();
        let rest: String = typed.chars().skip(after).collect();
        // Two names side by side would be one.
        let apart =
            before.ends_with(char::is_alphanumeric) && key.starts_with(char::is_alphanumeric);
        let key = if apart {
            format!(" {key}")
        } else {
            key.to_owned()
        };
        let cursor = CCursor::new(start + key.chars().count());
        *typed = before + &key + &rest;
        state.cursor.set_char_range(Some(CCursorRange::one(cursor)));
        state.store(ctx, self.id);
        ctx.memory_mut(|memory| memory.request_focus(self.id));
    }

    /// Forgets what Ctrl + Z in the field would bring back.
    pub fn forget_typed(&self, ctx: &Context) {
        if let Some(mut state) = TextEditState::load(ctx, self.id) {
            state.clear_undoer();
            state.store(ctx, self.id);
        }
    }
}

/// Returns whether signs are hard to type: on a hand-held screen, and with `fingers`.
pub fn wants_signs(ctx: &Context, fingers: bool) -> bool {
    fingers || ctx.content_rect().width() < NARROW
}

/// Shows a typed formula in the notation of textbooks, line by line, with its error below.
pub fn set_ui(ui: &mut Ui, formula: &str, error: Option<&FormulaError>) {
    let count = Cell::new(0);
    let lines = formula.lines().map(typed).filter(|line| !line.is_empty());
    ui.scope(|ui| {
        // The lines are spaced like text, not like rows of controls.
        ui.spacing_mut().interact_size.y = ui.text_style_height(&TextStyle::Body);
        for line in lines {
            ui.horizontal_wrapped(|ui| formula_ui(ui, &line, 0.0, &count, false));
        }
    });
    if let Some(error) = error {
        let words = RichText::new(error.to_string()).color(ui.visuals().error_fg_color);
        ui.add(Label::new(words).wrap());
    }
}
