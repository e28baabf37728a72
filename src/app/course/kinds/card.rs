//! The cards of options and items.

use crate::app::course::prose::caption_ui;
use crate::app::widgets::card::Card;
use crate::app::widgets::focus::switch_named;
use crate::app::widgets::mark::paint_mark;
use crate::app::widgets::palette::right_colour;
use eframe::egui::accesskit::Role;
use eframe::egui::{Align, Id, Layout, Rect, Response, Sense, Stroke, TextStyle, Ui, Vec2, vec2};
use egui_commonmark::CommonMarkCache;

/// The height of a one-line option, in points.
pub const CHOICE: f32 = 22.0;
/// The size of the mark behind an option, in points.
const MARK: f32 = 16.0;

/// A card with text, a mark in front of it, and one behind it if the answer is known.
pub struct OptionCard<'a> {
    /// The identity of the option or item.
    pub id: Id,
    /// The text.
    pub words: &'a str,
    /// The accessibility role, which also decides the padding.
    pub role: Role,
    /// True if the card is chosen.
    pub on: bool,
    /// The grade of the card, if it is shown.
    pub right: Option<bool>,
    /// True if the card can be chosen.
    pub enabled: bool,
}

impl OptionCard<'_> {
    /// Shows the card with a mark in front of its text.
    pub fn show(
        &self,
        ui: &mut Ui,
        cache: &mut CommonMarkCache,
        front: impl FnOnce(&mut Ui),
    ) -> Response {
        // In the middle of a card that is high enough for touch; buttons centre their own text.
        let pad = match self.role {
            Role::RadioButton => 0.5 * (ui.spacing().interact_size.y - CHOICE),
            _ => 0.0,
        };
        let visuals = ui.visuals();
        let line = match self.right {
            Some(true) => Stroke::new(2.0, right_colour(ui)),
            Some(false) if self.on => Stroke::new(1.5, visuals.error_fg_color),
            _ if self.on => Stroke::new(1.5, visuals.hyperlink_color),
            _ => Stroke::new(1.0, visuals.widgets.noninteractive.bg_stroke.color),
        };
        let card = Card {
            id: self.id,
            pad: vec2(8.0, pad.max(5.0)),
            sense: if self.enabled {
                Sense::click_and_drag()
            } else {
                Sense::hover()
            },
            line,
        };
        let response = card.show(ui, Layout::left_to_right(Align::Min), |ui| {
            front(ui);
            let line = ui.text_style_height(&TextStyle::Body);
            let lower = (0.5 * (ui.min_rect().height() - line)).max(0.0);
            let mark = self.right.map_or(0.0, |_| MARK + 8.0);
            ui.vertical(|ui| {
                // The first line is level with the mark in front.
                ui.add_space(lower);
                ui.set_width((ui.available_width() - mark).max(20.0));
                caption_ui(ui, cache, self.words);
            });
        });
        if response.clicked() {
            // Tab continues from here.
            response.request_focus();
        }
        let rect = response.rect;
        let response = switch_named(response, self.role, self.on, self.words);
        let room = rect.right_center() - vec2(8.0 + 0.5 * MARK, 0.0);
        let room = Rect::from_center_size(room, Vec2::splat(MARK));
        if let Some(right) = self.right.filter(|right| *right || self.on) {
            paint_mark(ui, room, right);
        }
        response
    }
}
