//! Letters: on a picture, with a dark edge that keeps them readable on any, and with lowered digits.

use crate::figure::Set;
use eframe::egui::text::{LayoutJob, TextFormat};
use eframe::egui::{Align, Align2, Color32, FontId, Painter, Pos2, vec2};

/// Size of text with lowered digits, points.
const LETTERED: f32 = 14.0;

/// Writes `text` with its `align` at `at`.
pub fn letter(
    painter: &Painter,
    at: Pos2,
    align: Align2,
    text: &str,
    font: &FontId,
    colour: Color32,
) {
    for shift in [
        vec2(-1.0, 0.0),
        vec2(1.0, 0.0),
        vec2(0.0, -1.0),
        vec2(0.0, 1.0),
        vec2(1.0, 1.0),
        vec2(-1.0, -1.0),
    ] {
        painter.text(
            at + shift,
            align,
            text,
            font.clone(),
            Color32::from_black_alpha(200),
        );
    }
    painter.text(at, align, text, font.clone(), colour);
}

/// Text with lowered digits, which the fonts lack.
pub fn lettered(text: &str, colour: Color32) -> LayoutJob {
    let mut job = LayoutJob::default();
    for character in text.chars() {
        let set = Set::of(character);
        let valign = if set.rise < 0.0 {
            Align::BOTTOM
        } else {
            Align::Center
        };
        let font_id = FontId::proportional(LETTERED * set.size);
        let format = TextFormat {
            font_id,
            color: colour,
            valign,
            ..TextFormat::default()
        };
        job.append(&set.letter.to_string(), 0.0, format);
    }
    job
}
