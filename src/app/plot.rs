//! Plots painted by the window, with their values under the pointer.

use super::drawing::{colour_of, drawing_ui, paint_text, screen};
use super::lines;
use super::theme::TEXT;
use crate::analysis::Plot;
use crate::figure::{Drawing, Paper, PlotStyle, Text, short};
use eframe::egui::{Color32, CornerRadius, Painter, Pos2, Rect, Sense, Stroke, StrokeKind, Ui, Vec2, pos2, vec2};
use glam::DVec2;

/// Size of letters in the plots, in that of the window's text.
const LETTERS: f64 = 0.9;
/// Height of the part of a plot that grows with its width: over straight axes, and of a half disc.
const ASPECT: [f64; 2] = [0.55, 0.5];
/// Height of all that does not: of labels about the plot, and of a line of the legend; in letters.
const LINES: [f64; 2] = [7.5, 1.4];

/// How plots are drawn in a panel.
pub fn plot_style(ui: &Ui) -> PlotStyle {
    PlotStyle { paper: paper(ui), text: LETTERS * f64::from(TEXT), titled: false }
}

fn paper(ui: &Ui) -> Paper {
    let visuals = ui.visuals();
    let rgb = |colour: Color32| [colour.r(), colour.g(), colour.b()];
    Paper {
        ground: rgb(visuals.panel_fill),
        text: rgb(visuals.text_color()),
        weak: rgb(visuals.weak_text_color()),
        grid: rgb(visuals.widgets.noninteractive.bg_stroke.color),
    }
}

pub fn height(plot: &Plot, width: f64, letters: f64) -> f64 {
    #[expect(clippy::cast_precision_loss, reason = "a plot has few curves and marks")]
    let lines = (plot.curves.len() + plot.marks.len()) as f64;
    width * ASPECT[usize::from(plot.kind.is_polar())] + letters * (LINES[0] + LINES[1] * lines)
}

pub fn plot_ui(ui: &mut Ui, plot: &Plot, drawing: &Drawing, style: &PlotStyle) {
    let Some((response, painter)) = drawing_ui(ui, drawing, Sense::hover(), || described(plot)) else { return };
    let rect = response.rect;
    if let Some(at) = response.hover_pos() {
        let local = at - rect.min;
        if let Some(x) = drawing.x_at(DVec2::new(local.x.into(), local.y.into())) {
            reading(ui, &painter, plot, drawing, x, (rect, at), style);
        }
    }
}

/// The plot in words, for those who do not see it.
fn described(plot: &Plot) -> String {
    let marks: Vec<&str> = plot.marks.iter().map(|mark| mark.label.as_str()).collect();
    let parts = [plot.title.as_str(), plot.note.as_str()].into_iter().chain(marks);
    parts.collect::<Vec<_>>().join("; ")
}

/// The values of all curves at `x`, beside the pointer and as dots.
fn reading(
    ui: &Ui,
    painter: &Painter,
    plot: &Plot,
    drawing: &Drawing,
    x: f64,
    (rect, pointer): (Rect, Pos2),
    style: &PlotStyle,
) {
    let visuals = ui.visuals();
    let Some((_, ends)) = drawing.place([x, 0.0]) else { return };
    let ends = ends.map(|end| lines::exact(rect.min) + end);
    lines::line(painter, ends, Stroke::new(1.0, visuals.text_color()), &[]);
    let unit = if plot.x.degrees { "°" } else { "" };
    let symbol = plot.x.name.split(',').next().unwrap_or_default();
    let line = |text: String, colour| Text::new(text, DVec2::ZERO, style.text, colour);
    let mut lines = vec![line(format!("{symbol} = {}{unit}", short(x)), style.paper.text)];
    for curve in &plot.curves {
        let Some(y) = curve.at(x) else { continue };
        lines.push(line(format!("{}: {}", curve.name, short(y)), style.paper.letters(curve.ink)));
        let at = drawing.place([x, y]).map(|(at, _)| screen(at, rect.min));
        if let Some(at) = at.filter(|at| y <= plot.y.high && rect.contains(*at)) {
            painter.circle_filled(at, 3.0, colour_of(style.paper.line(curve.ink), 1.0));
        }
    }
    boxed(ui, painter, &lines, (rect, pointer));
}

/// Lines of text in a box beside the pointer, inside `rect`.
pub fn boxed(ui: &Ui, painter: &Painter, lines: &[Text], (rect, pointer): (Rect, Pos2)) {
    let row = lines.first().map_or(0.0, |text| 1.4 * text.size as f32);
    let width = lines.iter().map(|text| text.width() as f32).fold(0.0, f32::max);
    let size = vec2(width, row * lines.len() as f32) + Vec2::splat(12.0);
    let right = pointer.x + 14.0 + size.x <= rect.max.x;
    let x = if right { pointer.x + 14.0 } else { (pointer.x - 14.0 - size.x).max(rect.min.x) };
    let y = (pointer.y - 0.5 * size.y).clamp(rect.min.y, (rect.max.y - size.y).max(rect.min.y));
    let area = Rect::from_min_size(pos2(x, y), size);
    let visuals = ui.visuals();
    let outline = visuals.widgets.noninteractive.bg_stroke;
    painter.rect(area, CornerRadius::same(4), visuals.window_fill, outline, StrokeKind::Inside);
    for (index, text) in lines.iter().enumerate() {
        let at = area.min + vec2(6.0, 6.0 + row * (index as f32 + 0.75));
        paint_text(painter, text, at);
    }
}
