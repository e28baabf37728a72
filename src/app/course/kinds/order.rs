//! An order: cards moved by dragging or by their buttons, the smallest first.

use super::card::OptionCard;
use super::widget::{Widget, WidgetContext};
use crate::app::course::prose::prose_ui;
use crate::app::system;
use crate::app::widgets::focus::named;
use crate::lesson::{Answer, Question, Solution};
use crate::scene::Scene;
use crate::text::text;
use eframe::egui::accesskit::Role;
use eframe::egui::{Align, Button, CursorIcon, Layout, RichText, Sense, Ui, vec2};

/// The items in their current order.
pub struct OrderWidget {
    order: Vec<usize>,
}

impl OrderWidget {
    /// Arranges the lesson's items in reverse, rotated by a number of places that `seed` decides.
    pub fn new(count: usize, seed: u64) -> Self {
        let turn = seed as usize % count.max(1);
        let order = (0..count).rev().map(|item| (item + turn) % count);
        Self {
            order: order.collect(),
        }
    }
}

impl Widget for OrderWidget {
    fn take_up(&mut self, given: &Answer) {
        if let Answer::Order(order) = given {
            self.order.clone_from(order);
        }
    }

    fn ui(&mut self, ui: &mut Ui, asked: &mut WidgetContext<'_>) -> bool {
        let revealed = asked.revealed;
        let right = match asked.right() {
            Some(Solution::Order(right)) => Some(right),
            _ => None,
        };
        ui.label(RichText::new(text!("course-order")).weak());
        let order = self.order.clone();
        let mut moved: Option<(usize, usize)> = None;
        let mut places = Vec::new();
        let mut dragged = None;
        for (place, item) in order.iter().enumerate() {
            let Some(words) = asked.names.get(*item) else {
                continue;
            };
            let card = OptionCard {
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
                // As high as the buttons, whose signs are at mid-height.
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
            let response = card.show(ui, asked.markdown, ways);
            places.push(response.rect);
            // Behind the buttons, so that they keep their clicks.
            let handle = response
                .rect
                .with_min_x(response.rect.min.x + 2.0 * ui.spacing().interact_size.y + 16.0);
            // Fingers scroll over the cards, and have the buttons.
            if !revealed && !system::fingers(ui.ctx()) {
                let drag = ui.interact(handle, card.id.with("drag"), Sense::drag());
                let drag = drag.on_hover_cursor(CursorIcon::Grab);
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
        if let Some((from, to)) = moved.filter(|(from, to)| from.max(to) < &self.order.len()) {
            let item = self.order.remove(from);
            self.order.insert(to, item);
            asked.changed = true;
        }
        if let Some(right) = right.filter(|right| **right != self.order) {
            ui.add_space(4.0);
            ui.label(RichText::new(text!("course-right-order")).strong());
            for (place, item) in right.iter().enumerate() {
                let words = asked.names.get(*item).map_or("", |words| words);
                let words = format!("{}\\. {words}", place + 1);
                ui.push_id(("right", place), |ui| {
                    prose_ui(ui, asked.markdown, &words);
                });
            }
        }
        false
    }

    fn answer(&self, _: &Question, _: &Scene) -> Option<Answer> {
        Some(Answer::Order(self.order.clone()))
    }
}
