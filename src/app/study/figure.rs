//! The plot, whose points can be chosen.

use super::super::drawing::drawing_ui;
use super::super::plot::{boxed, height, plot_style};
use crate::analysis::{Setting, StudyRow, study_point};
use crate::figure::{Drawing, Plot, PlotStyle, Text, lay_out};
use eframe::egui::{CursorIcon, Pos2, Rect, Sense, Ui, pos2};
use glam::DVec2;

/// A point is meant within this many points of the pointer.
const NEAR: f32 = 16.0;

/// A plot laid out for a style and a width.
pub type LaidOut = (Drawing, PlotStyle, f32);

/// The plot; returns the setting whose point is clicked.
pub fn figure_ui(ui: &mut Ui, plot: &Plot, laid_out: &mut Option<LaidOut>, rows: &[StudyRow]) -> Option<Setting> {
    let style = plot_style(ui);
    let width = ui.available_width();
    let kept = laid_out.take().filter(|(_, laid, wide)| *laid == style && *wide == width);
    let (drawing, ..) = &*laid_out.insert(kept.unwrap_or_else(|| {
        let room = DVec2::new(width.into(), height(plot, width.into(), style.text) + 0.3 * f64::from(width));
        (lay_out(plot, room, &style), style, width)
    }));
    ui.add_space(6.0);
    let words_for_readers = || format!("{}; {}", plot.title, plot.note);
    let (response, painter) = drawing_ui(ui, drawing, Sense::click(), words_for_readers)?;
    let rect = response.rect;
    let pointer = response.hover_pos()?;
    let row = nearest(rows, drawing, rect, pointer)?;
    ui.ctx().set_cursor_icon(CursorIcon::PointingHand);
    let lines: Vec<Text> =
        words(row).into_iter().map(|line| Text::new(line, DVec2::ZERO, style.text, style.paper.text)).collect();
    boxed(ui, &painter, &lines, (rect, pointer));
    response.clicked().then_some(row.setting)
}

/// The row whose point is nearest to the pointer.
fn nearest<'a>(rows: &'a [StudyRow], drawing: &Drawing, rect: Rect, pointer: Pos2) -> Option<&'a StudyRow> {
    let away = |row: &StudyRow| {
        let (at, _) = drawing.place(study_point(row)?)?;
        Some(pos2(rect.min.x + at.x as f32, rect.min.y + at.y as f32).distance(pointer))
    };
    let near = rows.iter().filter_map(|row| Some((row, away(row)?))).filter(|(_, away)| *away <= NEAR);
    near.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(row, _)| row)
}

/// A row in a few lines.
fn words(row: &StudyRow) -> [String; 4] {
    let setting = &row.setting;
    let go = if row.scalar { "a historic method: cannot be shown" } else { "click to show it" };
    [
        format!("{}, n = {}", setting.title(), setting.n),
        format!("RMS {:.3}, greatest {:.2} code values", 255.0 * row.error_rms, 255.0 * row.error_max),
        format!("{:.3} ms ± {:.3}, {} evaluations", row.time_ms, row.spread_ms, row.evaluations),
        go.to_owned(),
    ]
}
