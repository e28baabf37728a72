//! A QR code in the window, black on white whatever the theme, with each module on whole pixels so that no edge is blurred.

use crate::figure::QrCode;
use eframe::egui::{Color32, Mesh, Painter, Pos2, Rect, Response, Sense, Shape, Ui, pos2, vec2};

/// Returns the side of a code that fits into `side` points, quiet zone included; points.
pub fn code_side(code: &QrCode, side: f32, pixels_per_point: f32) -> f32 {
    module(code, side, pixels_per_point) * code.side() as f32 / pixels_per_point
}

/// Returns the width of a module in pixels.
fn module(code: &QrCode, side: f32, pixels_per_point: f32) -> f32 {
    (side * pixels_per_point / code.side() as f32)
        .floor()
        .max(1.0)
}

/// Shows a code on white within `side` points.
pub fn qr_code_ui(ui: &mut Ui, code: &QrCode, side: f32) -> Response {
    let size = code_side(code, side, ui.ctx().pixels_per_point());
    let (rect, response) = ui.allocate_exact_size(vec2(size, size), Sense::hover());
    ui.painter().rect_filled(rect, 0.0, Color32::WHITE);
    paint_code(ui.painter(), code, rect.min, side);
    response
}

/// Paints the dark modules of a code on a white background, from its top left corner, within `side` points.
fn paint_code(painter: &Painter, code: &QrCode, at: Pos2, side: f32) {
    let points = painter.pixels_per_point();
    let module = module(code, side, points);
    let whole =
        |start: f32, modules: usize| ((start * points).round() + module * modules as f32) / points;
    let corner = |x: usize, y: usize| pos2(whole(at.x, x), whole(at.y, y));
    let mut mesh = Mesh::default();
    for [x, y, count] in code.runs() {
        let rect = Rect::from_min_max(corner(x, y), corner(x + count, y + 1));
        mesh.add_colored_rect(rect, Color32::BLACK);
    }
    painter.add(Shape::mesh(mesh));
}
