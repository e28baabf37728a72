//! A question: its answer is given before the right one can be seen.

use super::curve::curve_ui;
use super::data::{Course, Open};
use super::feedback::feedback_ui;
use super::matching::match_ui;
use super::parts::{cross, error_ui, right_colour, waiting_ui};
use super::prose::{caption_ui, prose_ui};
use crate::app::engine::Engine;
use crate::app::focus::{named, picture_id, switch_named};
use crate::app::row::evaluate;
use crate::app::sign::tick;
use crate::app::state::AppState;
use crate::app::symbol::Symbol;
use crate::app::theme::text_field;
use crate::lesson::{Kind, Solution, Term};
use crate::text::text;
use eframe::egui::accesskit::Role;
use eframe::egui::epaint::RectShape;
use eframe::egui::{
    Align, Button, Frame, Id, Key, Label, Layout, Margin, Rect, RichText, Sense, Shape, Stroke,
    StrokeKind, TextStyle, Ui, UiBuilder, vec2,
};
use egui_commonmark::CommonMarkCache;

/// The mark in front of an option or behind it, points.
const MARK: f32 = 16.0;
/// Height of an option of one line, points.
const CHOICE: f32 = 22.0;

/// The question of the step, with its answer so far, and the right one once that may be seen.
pub fn question_ui(ui: &mut Ui, course: &mut Course, state: &mut AppState, engine: &Engine) {
    let stroke = Stroke::new(1.0, ui.visuals().widgets.noninteractive.bg_stroke.color);
    let card = Frame::new()
        .stroke(stroke)
        .corner_radius(8.0)
        .inner_margin(Margin::same(10))
        .show(ui, |ui| {
            ui.set_width(ui.available_width());
            contents_ui(ui, course, state, engine);
        });
    if let Some(open) = &mut course.open {
        let rect = card.response.rect;
        open.draft.top = Some(rect.min.y);
        if std::mem::take(&mut open.draft.seek) {
            ui.scroll_to_rect(rect, Some(Align::Min));
        }
    }
    if course.revealed()
        && state.lit.next.is_none()
        && let Some(open) = &course.open
        && let Some(term) = open.question().and_then(|question| question.term)
    {
        state.lit.next = Some(symbol(term));
    }
}

/// The letter of the equation that a term is lit up by.
fn symbol(term: Term) -> Symbol {
    match term {
        Term::Ambient => Symbol::Ka,
        Term::Diffuse => Symbol::Kd,
        Term::Specular => Symbol::Ks,
        Term::Attenuation => Symbol::Attenuation,
        Term::Transmission => Symbol::Kt,
        Term::Lights => Symbol::Lights,
    }
}

fn contents_ui(ui: &mut Ui, course: &mut Course, state: &mut AppState, engine: &Engine) {
    let revealed = course.revealed();
    let now = ui.input(|input| input.time);
    let Some(open) = &mut course.open else { return };
    open.draft.seen.get_or_insert(now);
    ui.label(RichText::new(text!("course-question")).weak());
    let (ask, names) = match open.known() {
        Some(Ok(known)) => (known.ask.clone(), known.names.clone()),
        Some(Err(_)) => return,
        None => return waiting_ui(ui, text!("course-preparing")),
    };
    ui.push_id("ask", |ui| prose_ui(ui, state, &mut open.markdown, &ask));
    ui.add_space(4.0);
    let Some(question) = open.question().cloned() else {
        return;
    };
    let mut entered = false;
    match &question.kind {
        Kind::Choice(_) => choice_ui(ui, open, state, &names, revealed),
        Kind::Value(value) => entered = value_ui(ui, open, &value.unit, revealed),
        Kind::Point(_) => entered = point_ui(ui, open, revealed),
        Kind::Curve(curve) => {
            let range = (curve.x, curve.y);
            entered = curve_ui(ui, open, range, &names, curve.of.is_profile(), revealed);
        }
        Kind::Settings(_) => {
            ui.label(RichText::new(text!("course-settings")).weak());
        }
        Kind::Order(_) => order_ui(ui, open, state, &names, revealed),
        Kind::Match(kind) => {
            match_ui(ui, open, state, &question, kind, revealed);
        }
    }
    ui.add_space(6.0);
    if !revealed {
        check_ui(ui, course, state, entered);
    }
    feedback_ui(ui, course, state, engine);
}

/// The buttons that grade the answer and show the right one.
fn check_ui(ui: &mut Ui, course: &mut Course, state: &mut AppState, entered: bool) {
    let Some(open) = &course.open else { return };
    let Some(question) = open.question() else {
        return;
    };
    let failed = match open.known() {
        Some(Ok(known)) => match &known.solution {
            Some(Err(why)) => Some(why.clone()),
            _ => None,
        },
        _ => None,
    };
    if let Some(why) = failed {
        return error_ui(ui, &why);
    }
    let answer = open
        .draft
        .answer(&question.kind, &state.document.scene, evaluate);
    let ready = answer.is_some() && open.solution().is_some() && open.staged.is_some();
    let given = course.answered();
    // What was said of another answer.
    let stale = answer.is_some() && given.map(|given| &given.answer) != answer.as_ref();
    let given = given.is_some();
    let mut check = false;
    let mut show = false;
    let mut typed = entered;
    ui.horizontal_wrapped(|ui| {
        let button = Button::new(RichText::new(text!("course-check")).strong());
        let button = ui.add_enabled(ready, button);
        check = button.clicked() || (entered && ready);
        typed |= button.has_focus();
        if given {
            let button = ui.button(text!("course-show-answer"));
            typed |= button.has_focus();
            show = button
                .on_hover_text(text!("course-show-answer.tip"))
                .clicked();
        }
    });
    if answer.is_some() && open.solution().is_none() {
        waiting_ui(ui, text!("course-solving"));
    }
    if check
        && let Some(answer) = answer
        && let Some(grade) = open.grade(&answer)
    {
        let now = ui.input(|input| input.time);
        course.put(answer, grade, now);
        ui.ctx().request_repaint();
    }
    if stale
        && !check
        && let Some(open) = &mut course.open
    {
        open.draft.grade = None;
    }
    if show {
        course.look_up();
        ui.ctx().request_repaint();
    }
    if course.revealed() {
        if let Some(open) = &mut course.open {
            open.draft.onward = typed;
        }
        state.ask(crate::app::action::Action::ShowAnswer);
    }
}

/// A card with text, a mark in front of it, and one behind it where the answer is known. Returns its place and whether it was
/// clicked.
pub struct Card<'a> {
    pub id: Id,
    pub words: &'a str,
    pub role: Role,
    pub on: bool,
    /// Whether it is right, where that is shown.
    pub right: Option<bool>,
    pub enabled: bool,
}

impl Card<'_> {
    pub fn show(
        &self,
        ui: &mut Ui,
        state: &mut AppState,
        cache: &mut CommonMarkCache,
        front: impl FnOnce(&mut Ui),
    ) -> eframe::egui::Response {
        let width = ui.available_width();
        let outer = ui.available_rect_before_wrap();
        let ground = ui.painter().add(Shape::Noop);
        // In the middle of a card that is high enough for fingers; buttons are so themselves.
        let pad = match self.role {
            Role::RadioButton => 0.5 * (ui.spacing().interact_size.y - CHOICE),
            _ => 0.0,
        };
        let pad = pad.max(5.0);
        let room = Rect::from_min_size(
            outer.min + vec2(8.0, pad),
            vec2(width - 16.0, f32::INFINITY),
        );
        let layout = Layout::left_to_right(Align::Min);
        let mut inside = ui.new_child(
            UiBuilder::new()
                .id_salt(self.id)
                .max_rect(room)
                .layout(layout),
        );
        front(&mut inside);
        let line = ui.text_style_height(&TextStyle::Body);
        let lower = (0.5 * (inside.min_rect().height() - line)).max(0.0);
        inside.vertical(|ui| {
            // The first line is level with what stands in front.
            ui.add_space(lower);
            ui.set_width(
                (ui.available_width()
                    - if self.right.is_some() {
                        MARK + 8.0
                    } else {
                        0.0
                    })
                .max(20.0),
            );
            caption_ui(ui, state, cache, self.words);
        });
        let height = inside.min_rect().max.y + pad - outer.min.y;
        let size = vec2(width, height.max(ui.spacing().interact_size.y));
        let rect = Rect::from_min_size(outer.min, size);
        ui.advance_cursor_after_rect(rect);
        let sense = if self.enabled {
            Sense::click_and_drag()
        } else {
            Sense::hover()
        };
        let response = ui.interact(rect, self.id, sense);
        if response.clicked() {
            // Tab goes on from here.
            response.request_focus();
        }
        let response = switch_named(response, self.role, self.on, self.words);
        let visuals = ui.visuals();
        let fill = if self.enabled && response.hovered() {
            visuals.widgets.hovered.bg_fill
        } else {
            visuals.faint_bg_color
        };
        let line = match self.right {
            Some(true) => Stroke::new(2.0, right_colour(ui)),
            Some(false) if self.on => Stroke::new(1.5, visuals.error_fg_color),
            _ if self.on => Stroke::new(1.5, visuals.hyperlink_color),
            _ => Stroke::new(1.0, visuals.widgets.noninteractive.bg_stroke.color),
        };
        ui.painter().set(
            ground,
            RectShape::new(rect, 6.0, fill, line, StrokeKind::Inside),
        );
        let room = Rect::from_center_size(
            rect.right_center() - vec2(8.0 + 0.5 * MARK, 0.0),
            vec2(MARK, MARK),
        );
        match self.right {
            Some(true) => _ = ui.painter().add(tick(room, right_colour(ui))),
            Some(false) if self.on => cross(ui, room.shrink(3.0), visuals.error_fg_color),
            _ => {}
        }
        response
    }
}

fn choice_ui(ui: &mut Ui, open: &mut Open, state: &mut AppState, names: &[String], revealed: bool) {
    let right = match open.solution() {
        Some(Solution::Choice(right)) if revealed => Some(*right),
        _ => None,
    };
    for (index, words) in names.iter().enumerate() {
        let on = open.draft.choice == Some(index);
        let card = Card {
            id: ui.scope_id().with(("option", index)),
            words,
            role: Role::RadioButton,
            on,
            right: right.map(|right| right == index),
            enabled: !revealed,
        };
        let response = card.show(ui, state, &mut open.markdown, |ui| {
            let (rect, _) = ui.allocate_exact_size(vec2(16.0, CHOICE), Sense::hover());
            let visuals = ui.visuals();
            let stroke = Stroke::new(1.5, visuals.text_color());
            ui.painter().circle_stroke(rect.center(), 6.0, stroke);
            if on {
                ui.painter()
                    .circle_filled(rect.center(), 3.5, visuals.hyperlink_color);
            }
        });
        if response.clicked() {
            (open.draft.choice, open.draft.grade) = (Some(index), None);
        }
    }
}

/// A field for a number; whether Enter was pressed in it.
fn value_ui(ui: &mut Ui, open: &mut Open, unit: &str, revealed: bool) -> bool {
    let mut entered = false;
    ui.horizontal(|ui| {
        let field = text_field(&mut open.draft.value)
            .hint_text(text!("course-number"))
            .desired_width(110.0);
        let field = ui.add_enabled(!revealed, field);
        let field = named(field, Role::TextInput, text!("course-answer"));
        if field.changed() {
            open.draft.grade = None;
        }
        entered = field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        if entered {
            // For the next try; what is right gives it to the way on.
            field.request_focus();
        }
        if !unit.is_empty() {
            ui.label(unit);
        }
    });
    let typed = open.draft.value.trim();
    if !typed.is_empty() && evaluate(typed).is_none() {
        let words = RichText::new(text!("course-no-number")).color(ui.visuals().error_fg_color);
        ui.label(words);
    }
    entered
}

/// Where a place is clicked in the picture. Returns whether Enter was pressed there.
fn point_ui(ui: &mut Ui, open: &Open, revealed: bool) -> bool {
    if revealed {
        return false;
    }
    let words = if open.draft.point.is_some() {
        text!("course-point-set")
    } else {
        text!("course-point")
    };
    ui.add(Label::new(RichText::new(words).weak()).wrap());
    ui.memory(|memory| memory.has_focus(picture_id()))
        && ui.input(|input| input.key_pressed(Key::Enter))
}

/// Cards that are moved by dragging or by their buttons, the least first.
fn order_ui(ui: &mut Ui, open: &mut Open, state: &mut AppState, names: &[String], revealed: bool) {
    let right = match open.solution() {
        Some(Solution::Order(right)) if revealed => Some(right.clone()),
        _ => None,
    };
    ui.label(RichText::new(text!("course-order")).weak());
    let order = open.draft.order.clone();
    let mut moved: Option<(usize, usize)> = None;
    let mut places = Vec::new();
    let mut dragged = None;
    for (place, item) in order.iter().enumerate() {
        let Some(words) = names.get(*item) else {
            continue;
        };
        let card = Card {
            id: ui.scope_id().with(("item", *item)),
            words,
            role: Role::ListItem,
            on: false,
            right: right.as_ref().map(|right| right[place] == *item),
            enabled: false,
        };
        let ways = |ui: &mut Ui| {
            if revealed {
                let number = format!("{}.", place + 1);
                ui.label(RichText::new(number).weak());
                return;
            }
            let side = ui.spacing().interact_size.y;
            let size = vec2(2.0 * side + 2.0, side);
            // As high as the buttons, whose signs stand in their middle.
            ui.allocate_ui_with_layout(size, Layout::left_to_right(Align::Center), |ui| {
                ui.spacing_mut().item_spacing.x = 2.0;
                for (sign, to, name) in [
                    ("▲", place.checked_sub(1), "course-up"),
                    (
                        "▼",
                        Some(place + 1).filter(|to| *to < order.len()),
                        "course-down",
                    ),
                ] {
                    let button = Button::new(sign).min_size(vec2(side, side));
                    let response = ui.add_enabled(to.is_some(), button);
                    let name = text!(name, item = words.as_str());
                    if named(response, Role::Button, &name).clicked() {
                        moved = to.map(|to| (place, to));
                    }
                }
            });
        };
        let response = card.show(ui, state, &mut open.markdown, ways);
        places.push(response.rect);
        // Behind the buttons, so that they keep their clicks.
        let handle = response
            .rect
            .with_min_x(response.rect.min.x + 2.0 * ui.spacing().interact_size.y + 16.0);
        if !revealed {
            let drag = ui.interact(handle, card.id.with("drag"), Sense::drag());
            let drag = drag.on_hover_cursor(eframe::egui::CursorIcon::Grab);
            if drag.dragged() {
                dragged = drag.interact_pointer_pos().map(|at| (place, at.y));
            }
        }
    }
    if let Some((from, y)) = dragged {
        let to = places
            .iter()
            .position(|rect| y < rect.max.y)
            .unwrap_or(places.len() - 1);
        moved = moved.or((to != from).then_some((from, to)));
    }
    if let Some((from, to)) = moved.filter(|(from, to)| from.max(to) < &open.draft.order.len()) {
        let item = open.draft.order.remove(from);
        open.draft.order.insert(to, item);
        open.draft.grade = None;
    }
    if let Some(right) = right.filter(|right| *right != open.draft.order) {
        ui.add_space(4.0);
        ui.label(RichText::new(text!("course-right-order")).strong());
        for (place, item) in right.iter().enumerate() {
            let words = names.get(*item).map_or("", |words| words);
            let words = format!("{}\\. {words}", place + 1);
            ui.push_id(("right", place), |ui| {
                prose_ui(ui, state, &mut open.markdown, &words);
            });
        }
    }
}
