//! Marks of answers and choices: ticks, crosses and radio buttons.

use super::palette::right_colour;
use eframe::egui::{Atom, Color32, Rect, Response, Sense, Shape, Stroke, Ui, Vec2, vec2};

/// Returns a tick, or the space for one, as the sign of a button.
pub fn ticked(side: f32, on: bool) -> Atom<'static> {
    Atom::paint(Vec2::splat(side), move |ui, args| {
        if on {
            let colour = ui.visuals().strong_text_color();
            ui.painter().add(tick(args.rect, colour));
        }
    })
}

/// Shows a dot in a ring if `on`, else the ring.
pub fn radio_mark(ui: &mut Ui, size: Vec2, on: bool) {
    let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
    let visuals = ui.visuals();
    let ring = Stroke::new(1.5, visuals.text_color());
    ui.painter().circle_stroke(rect.center(), 6.0, ring);
    if on {
        let colour = visuals.hyperlink_color;
        ui.painter().circle_filled(rect.center(), 3.5, colour);
    }
}

/// Shows a tick in `colour`.
pub fn tick_ui(ui: &mut Ui, side: f32, colour: Color32) {
    let (rect, _) = ui.allocate_exact_size(Vec2::splat(side), Sense::hover());
    ui.painter().add(tick(rect, colour));
}

/// Shows the sign of a right answer, a tick, or of a wrong one, a cross.
pub fn mark_ui(ui: &mut Ui, side: f32, right: bool) -> Response {
    let (rect, response) = ui.allocate_exact_size(Vec2::splat(side), Sense::hover());
    paint_mark(ui, rect, right);
    response
}

/// Paints the sign of a right or a wrong answer within `room`.
pub fn paint_mark(ui: &Ui, room: Rect, right: bool) {
    if right {
        ui.painter().add(tick(room, right_colour(ui)));
        return;
    }
    let cross = room.shrink(3.0);
    let stroke = Stroke::new(1.8, ui.visuals().error_fg_color);
    for ends in [
        [cross.left_top(), cross.right_bottom()],
        [cross.right_top(), cross.left_bottom()],
    ] {
        ui.painter().line_segment(ends, stroke);
    }
}

/// Returns the shape of a tick within `room`.
fn tick(room: Rect, colour: Color32) -> Shape {
    let at = |x: f32, y: f32| room.lerp_inside(vec2(x, y));
    Shape::line(
        vec![at(0.2, 0.55), at(0.4, 0.75), at(0.78, 0.28)],
        Stroke::new(1.8, colour),
    )
}
