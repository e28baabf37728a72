//! The cards of options and items.

use crate::app::course::parts::{cross, right_colour};
use crate::app::course::prose::caption_ui;
use crate::app::widgets::focus::switch_named;
use crate::app::widgets::sign::tick;
use eframe::egui::accesskit::Role;
use eframe::egui::epaint::RectShape;
use eframe::egui::{
    Align, Id, Layout, Rect, Response, Sense, Shape, Stroke, StrokeKind, TextStyle, Ui, UiBuilder,
    vec2,
};
use egui_commonmark::CommonMarkCache;

/// The height of a one-line option, in points.
pub const CHOICE: f32 = 22.0;
/// The size of the mark behind an option, in points.
const MARK: f32 = 16.0;

/// A card with text, a mark in front of it, and one behind it if the answer is known.
pub struct Card<'a> {
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

impl Card<'_> {
    /// Shows the card with a mark in front of its text.
    pub fn show(
        &self,
        ui: &mut Ui,
        cache: &mut CommonMarkCache,
        front: impl FnOnce(&mut Ui),
    ) -> Response {
        let width = ui.available_width();
        let outer = ui.available_rect_before_wrap();
        let ground = ui.painter().add(Shape::Noop);
        // In the middle of a card that is high enough for touch; buttons centre their own text.
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
            // The first line is level with the mark in front.
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
            caption_ui(ui, cache, self.words);
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
            // Tab continues from here.
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
