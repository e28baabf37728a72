//! Content on a card that can be clicked.

use eframe::egui::epaint::RectShape;
use eframe::egui::{
    Id, Layout, Rect, Response, Sense, Shape, Stroke, StrokeKind, Ui, UiBuilder, Vec2, vec2,
};

/// A card as wide as the available space, and as high as its content, but at least as high as a control.
pub struct Card {
    pub id: Id,
    /// The space around the content, in points.
    pub pad: Vec2,
    /// The gestures that the card takes; one that can be clicked is highlighted under the pointer.
    pub sense: Sense,
    /// The line around it.
    pub line: Stroke,
}

impl Card {
    /// Shows the card. Its content is below it for the pointer: a click anywhere is one on the card.
    pub fn show(self, ui: &mut Ui, layout: Layout, content: impl FnOnce(&mut Ui)) -> Response {
        let outer = ui.available_rect_before_wrap();
        // The background is painted below the content once its size is known.
        let ground = ui.painter().add(Shape::Noop);
        let inner = vec2(outer.width() - 2.0 * self.pad.x, f32::INFINITY);
        let inner = Rect::from_min_size(outer.min + self.pad, inner);
        let builder = UiBuilder::new().id_salt(self.id).max_rect(inner);
        let mut inside = ui.new_child(builder.layout(layout));
        content(&mut inside);
        let height = inside.min_rect().max.y + self.pad.y - outer.min.y;
        let size = vec2(outer.width(), height.max(ui.spacing().interact_size.y));
        let rect = Rect::from_min_size(outer.min, size);
        ui.advance_cursor_after_rect(rect);
        let response = ui.interact(rect, self.id, self.sense);
        let visuals = ui.visuals();
        let fill = if self.sense.senses_click() && response.hovered() {
            visuals.widgets.hovered.bg_fill
        } else {
            visuals.faint_bg_color
        };
        let card = RectShape::new(rect, 6.0, fill, self.line, StrokeKind::Inside);
        ui.painter().set(ground, card);
        response
    }
}
