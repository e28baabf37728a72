//! The layout of a row: label, control and the button that resets it.

use crate::app::widgets::focus::{self, named};
use crate::app::widgets::letter::text_width;
use crate::app::widgets::strip::strip;
use crate::app::widgets::symbol::{self, Symbol};
use crate::scene::parameter::Parameter;
use crate::text;
use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align, Button, Color32, Label, Layout, Rect, Response, RichText, Sense, TextStyle, Ui,
    UiBuilder, pos2, vec2,
};

/// Minimum and maximum width of a panel's labels, in points, and their share of the row's width in between.
const LABEL: [f32; 2] = [101.0, 152.0];
const LABEL_SHARE: f32 = 0.36;
/// Minimum scale of a label's type where the label does not fit.
const LEAST_LABEL: f32 = 0.85;
/// Space between a label and its control, in points.
const GAP: f32 = 4.0;
/// Width of the letter in front of a label, in points.
const LETTER: f32 = 24.0;
/// Width kept for the reset button, in points.
pub const RESET: f32 = 20.0;
/// Width kept beside a label for the field and the switch of a slider below it, in points.
pub const BESIDE: f32 = FIELD + 38.0;
/// Width of a number's field, in points.
pub const FIELD: f32 = 66.0;

/// Description of a row.
#[derive(Clone, Debug, Default)]
pub struct About<'a> {
    /// Letter in front of the label, as in the equation.
    pub letter: &'a str,
    /// Colour of the letter; `None` is ordinary text.
    pub tint: Option<Color32>,
    /// Label in words.
    pub label: &'a str,
    /// Accessible name; the label if empty.
    pub name: &'a str,
    /// Meaning of the value, with its unit.
    pub tip: &'a str,
    /// Symbol of the equation that the row controls.
    pub symbol: Option<Symbol>,
    /// Parameter that the row controls.
    pub parameter: Option<&'static Parameter>,
    /// Reason why the control has no effect at present.
    pub idle: Option<&'a str>,
    /// Width that the control needs, in points. If the row is too narrow for it beside the label, the control goes below the
    /// label. Infinite for a slider with a line of its own, whose field is beside the label ([`BESIDE`]).
    pub room: f32,
}

impl About<'_> {
    /// Returns the accessible name.
    pub fn name(&self) -> &str {
        if self.name.is_empty() {
            self.label
        } else {
            self.name
        }
    }
}

/// Shows a row for a value, which `control` edits and resetting sets to `default`.
pub fn value_row<T: PartialEq>(
    ui: &mut Ui,
    about: &About<'_>,
    default: T,
    value: &mut T,
    control: impl FnOnce(&mut Ui, &mut T),
) {
    if row(ui, about, *value != default, |ui| control(ui, value)) {
        *value = default;
    }
}

/// Lays out one row, fills it with `control`, and returns whether to reset it.
///
/// The reset button is shown while the row has been `changed`.
pub fn row(ui: &mut Ui, about: &About<'_>, changed: bool, control: impl FnOnce(&mut Ui)) -> bool {
    let size = vec2(ui.available_width(), ui.spacing().interact_size.y);
    let [least, greatest] = LABEL;
    let label_width = (LABEL_SHARE * size.x).clamp(least, greatest);
    // A control that needs a little more width takes it from a shorter label.
    let left = size.x - RESET - about.room;
    let stacked = left < label_width && left < least_width(ui, about);
    // Below its label a control has the whole width, under the words if it can.
    let (label_width, from, to, lines) = if stacked {
        let from = (size.x - about.room).clamp(0.0, LETTER);
        let field = if about.room.is_infinite() {
            BESIDE
        } else {
            0.0
        };
        (size.x - RESET - field, from, 0.0, 2.0)
    } else {
        let width = label_width.min(left);
        (width, width, RESET, 1.0)
    };
    let (rect, _) = strip(ui, lines * size.y, Sense::hover());
    let is_lit = |symbol| symbol::is_lit(ui.ctx(), symbol);
    if let Some(symbol) = about.symbol.filter(|_| ui.rect_contains_pointer(rect)) {
        symbol::light_up(ui.ctx(), symbol);
    }
    if about.symbol.is_some_and(is_lit) {
        let fill = ui.visuals().widgets.hovered.bg_fill.gamma_multiply(0.55);
        ui.painter()
            .rect_filled(rect.expand2(vec2(4.0, 2.0)), 6.0, fill);
    }
    let label_rect = Rect::from_min_size(rect.min, vec2(label_width, size.y));
    let reset_here = label(ui, about, changed, label_rect);
    let inner = Rect::from_min_max(
        pos2(rect.min.x + from, rect.max.y - size.y),
        pos2(rect.max.x - to, rect.max.y),
    );
    let mut child = part(
        ui,
        about.name(),
        inner,
        Layout::left_to_right(Align::Center),
    );
    if about.idle.is_some() {
        child.disable();
    }
    control(&mut child);
    if let Some(reason) = about.idle {
        ui.interact(
            inner,
            ui.scope_id().with((about.name(), "idle")),
            Sense::hover(),
        )
        .on_hover_text(reason);
    }
    if symbol::is_found(ui.ctx(), about.parameter, about.symbol) {
        ui.scroll_to_rect(rect, Some(Align::Center));
    }
    let by_key = focus::resets(ui, rect);
    let reset_rect = Rect::from_min_max(
        pos2(rect.max.x - RESET, rect.min.y),
        rect.right_top() + vec2(0.0, size.y),
    );
    let by_pointer = changed && reset(ui, about, reset_rect);
    by_pointer || reset_here || by_key
}

/// Returns a child `Ui` for a part of a row in `rect`. Its widgets keep their identity when other rows come and go.
fn part(
    ui: &mut Ui,
    salt: impl std::hash::Hash + std::fmt::Debug,
    rect: Rect,
    layout: Layout,
) -> Ui {
    let mut child = ui.new_child(
        UiBuilder::new()
            .scope_id(ui.scope_id().with(salt))
            .max_rect(rect)
            .layout(layout),
    );
    child.spacing_mut().item_spacing.x = 6.0;
    child
}

/// Shows the label, and returns whether a double click on it resets the row.
fn label(ui: &mut Ui, about: &About<'_>, changed: bool, rect: Rect) -> bool {
    let mut child = part(
        ui,
        (about.name(), "label"),
        rect,
        Layout::left_to_right(Align::Center),
    );
    child.spacing_mut().item_spacing.x = 0.0;
    let mut response: Option<Response> = None;
    if !about.letter.is_empty() {
        let tint = about
            .tint
            .unwrap_or_else(|| child.visuals().strong_text_color());
        let text = RichText::new(about.letter).color(tint).strong();
        let words = Label::new(text).sense(Sense::CLICK);
        let size = vec2(LETTER, rect.height());
        let layout = Layout::left_to_right(Align::Center);
        let letter = child.allocate_ui_with_layout(size, layout, |ui| ui.add(words));
        child.advance_cursor_after_rect(Rect::from_min_size(letter.response.rect.min, size));
        response = Some(letter.inner);
    }
    if !about.label.is_empty() {
        let colour = if about.idle.is_some() {
            child.visuals().weak_text_color()
        } else {
            child.visuals().text_color()
        };
        let size = fitting(&child, about.label);
        let text = RichText::new(about.label).color(colour).size(size);
        let words = child.add(Label::new(text).truncate().sense(Sense::CLICK));
        response = Some(response.map_or(words.clone(), |letter| letter | words));
    }
    response.is_some_and(|response| {
        response
            .on_hover_text(about.idle.unwrap_or(about.tip))
            .double_clicked()
            && changed
    })
}

fn reset(ui: &mut Ui, about: &About<'_>, rect: Rect) -> bool {
    let mut child = part(
        ui,
        (about.name(), "reset"),
        rect,
        Layout::right_to_left(Align::Center),
    );
    let weak = child.visuals().weak_text_color();
    // For the pointer and for screen readers only: Tab would otherwise stop at it between two fields.
    let button = Button::new(RichText::new("↺").color(weak))
        .frame(false)
        .sense(Sense::CLICK);
    let response = child.add(button).on_hover_text(text!("controls-reset-tip"));
    let name = text!("controls-reset", name = about.name());
    named(response, Role::Button, &name).clicked()
}

/// Returns the font size at which `label` fits into the rest of the line. A long label is set a little smaller.
fn fitting(ui: &Ui, label: &str) -> f32 {
    let size = TextStyle::Body.resolve(ui.style()).size;
    let width = text_width(ui, label);
    (size * (ui.available_width() - GAP) / width.max(1.0)).clamp(LEAST_LABEL * size, size)
}

/// Returns the minimum width of letter and label, in points.
fn least_width(ui: &Ui, about: &About<'_>) -> f32 {
    let letter = if about.letter.is_empty() { 0.0 } else { LETTER };
    letter + LEAST_LABEL * text_width(ui, about.label) + GAP
}
