//! A QR code in the window, black on white whatever the theme, with each module on whole pixels so that no edge is blurred.

use crate::figure::QrCode;
use eframe::egui::{Color32, Mesh, Painter, Pos2, Rect, Shape, pos2};

/// Returns how large a code within `side` points is, quiet zone included.
pub fn code_side(code: &QrCode, side: f32, pixels_per_point: f32) -> f32 {
    module(code, side, pixels_per_point) * code.side() as f32 / pixels_per_point
}

/// Returns the width of a module in pixels.
fn module(code: &QrCode, side: f32, pixels_per_point: f32) -> f32 {
    (side * pixels_per_point / code.side() as f32)
        .floor()
        .max(1.0)
}

/// Paints the dark modules of a code from its top left corner, on what is white, within `side` points.
pub fn paint_code(painter: &Painter, code: &QrCode, at: Pos2, side: f32) {
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
