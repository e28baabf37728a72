//! Text with a dark edge that keeps it readable on any picture, and text with subscripts and superscripts.

use crate::figure::Set;
use eframe::egui::text::{LayoutJob, TextFormat};
use eframe::egui::{Align, Align2, Color32, FontId, Painter, Pos2, TextStyle, Ui, vec2};

/// Size of text with subscripts, points.
const LETTERED: f32 = 14.0;

/// Paints `text` at `at`, aligned by `align`.
pub fn letter(
    painter: &Painter,
    at: Pos2,
    align: Align2,
    text: &str,
    font: &FontId,
    colour: Color32,
) {
    let dark = Color32::from_black_alpha(200);
    for shift in [
        vec2(-1.0, 0.0),
        vec2(1.0, 0.0),
        vec2(0.0, -1.0),
        vec2(0.0, 1.0),
        vec2(1.0, 1.0),
        vec2(-1.0, -1.0),
    ] {
        painter.text(at + shift, align, text, font.clone(), dark);
    }
    painter.text(at, align, text, font.clone(), colour);
    // Bright letters in the light theme's thinner text: painted twice, they cover as much as the dark theme's.
    if !painter.ctx().global_style().visuals.dark_mode {
        painter.text(at, align, text, font.clone(), colour);
    }
}

/// Returns the width of a line of text, in points.
pub fn text_width(ui: &Ui, text: &str) -> f32 {
    let font = TextStyle::Body.resolve(ui.style());
    let galley = ui
        .painter()
        .layout_no_wrap(text.to_owned(), font, Color32::PLACEHOLDER);
    galley.size().x
}

/// Lays out text with subscript digits and superscript powers, which the fonts lack.
pub fn lettered(text: &str, colour: Color32) -> LayoutJob {
    set(text, FontId::proportional(LETTERED), colour)
}

/// Lays out text with subscripts and superscripts in the given font.
pub fn set(text: &str, font_id: FontId, color: Color32) -> LayoutJob {
    let mut job = LayoutJob::default();
    let format = TextFormat {
        font_id,
        color,
        valign: Align::Center,
        ..TextFormat::default()
    };
    append(&mut job, text, &format);
    job
}

/// Splits text into runs of letters that are set alike, each as the first of them.
pub fn runs(text: &str) -> Vec<(Set, String)> {
    let mut runs: Vec<(Set, String)> = Vec::new();
    for set in text.chars().map(Set::of) {
        match runs.last_mut().filter(|(last, _)| last.rise == set.rise) {
            Some((_, run)) => run.push(set.letter),
            None => runs.push((set, set.letter.to_string())),
        }
    }
    runs
}

/// Appends text with subscripts and superscripts to a layout job.
pub fn append(job: &mut LayoutJob, text: &str, format: &TextFormat) {
    for (set, run) in runs(text) {
        let mut format = format.clone();
        format.font_id.size *= set.size;
        if set.rise != 0.0 {
            format.valign = if set.rise < 0.0 {
                Align::BOTTOM
            } else {
                Align::TOP
            };
        }
        job.append(&run, 0.0, format);
    }
}
