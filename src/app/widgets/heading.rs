//! The heading of the point and of the scan line: a stored colour and lines of text.

use crate::text::text;
use eframe::egui::accesskit::Role;
use eframe::egui::{Color32, CornerRadius, Sense, Stroke, StrokeKind, Ui, WidgetInfo, vec2};

/// Side of the colour's square, points.
const SWATCH: f32 = 36.0;

/// Shows a stored colour as a square, empty if there is none, with lines of text beside it.
pub fn heading_ui(ui: &mut Ui, stored: Option<[u8; 3]>, lines: impl FnOnce(&mut Ui)) {
    ui.horizontal(|ui| {
        let (rect, response) = ui.allocate_exact_size(vec2(SWATCH, SWATCH), Sense::hover());
        let round = CornerRadius::same(5);
        if let Some([r, g, b]) = stored {
            let painter = ui.painter();
            painter.rect_filled(rect, round, Color32::from_rgb(r, g, b));
            let name = text!("line-colour", r = r, g = g, b = b);
            response.widget_info(|| WidgetInfo::labeled(Role::Image, true, &name));
        } else {
            let stroke = Stroke::new(1.0, ui.visuals().weak_text_color());
            ui.painter()
                .rect_stroke(rect, round, stroke, StrokeKind::Inside);
        }
        ui.vertical(|ui| {
            ui.spacing_mut().item_spacing.y = 1.0;
            lines(ui);
        });
    });
}
