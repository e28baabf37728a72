//! The rows as a table, and the orders of convergence.

use crate::analysis::{Setting, Study, StudyRow};
use crate::scene::Interpolation;
use eframe::egui::{Align, Button, Grid, Layout, RichText, Ui, vec2};

/// Widths of the columns, points.
const NAME: f32 = 164.0;
const NUMBER: f32 = 58.0;
/// Height of a row.
const ROW: f32 = 21.0;

/// The table; returns the setting whose row is clicked.
pub fn table_ui(ui: &mut Ui, study: &Study) -> Option<Setting> {
    let mut asked = None;
    ui.add_space(6.0);
    ui.label(RichText::new("Errors in code values, 1/255 of linear intensity; times in ms").weak());
    Grid::new("study").num_columns(3).spacing([4.0, 2.0]).min_row_height(ROW).show(ui, |ui| {
        for (index, head) in ["", "RMS", "time"].into_iter().enumerate() {
            cell(ui, RichText::new(head).weak(), if index == 0 { NAME } else { NUMBER });
        }
        ui.end_row();
        for row in &study.rows {
            if name_ui(ui, row) {
                asked = Some(row.setting);
            }
            for value in [255.0 * row.error_rms, row.time_ms] {
                cell(ui, RichText::new(brief(value)).monospace(), NUMBER);
            }
            ui.end_row();
        }
    });
    asked
}

fn name_ui(ui: &mut Ui, row: &StudyRow) -> bool {
    let setting = &row.setting;
    let how = match setting.interpolation {
        Some(Interpolation::Affine) => ", affine",
        Some(Interpolation::Scanline) => ", scan line",
        Some(Interpolation::Perspective) | None => "",
    };
    let name = format!("{}{how} {}×{}", setting.method.title(), setting.segments, setting.rings);
    let text = RichText::new(name);
    let text = if row.pareto { text.strong() } else { text };
    let front = if row.pareto { "On the front of Pareto: nothing else is both faster and nearer. " } else { "" };
    let go =
        if row.scalar { "A historic method: it cannot be shown in the picture" } else { "Shows it in the picture" };
    let says = format!(
        "{front}n = {}, at most {} and 99 % within {} code values before the display, RMS {} as shown, {} pixels of the \
         outline, {} evaluations. {go}",
        setting.n,
        brief(255.0 * row.error_max),
        brief(255.0 * row.error_p99),
        brief(255.0 * row.error_rms_shown),
        row.outline_pixels,
        row.evaluations
    );
    ui.allocate_ui_with_layout(vec2(NAME, ROW), Layout::left_to_right(Align::Center), |ui| {
        ui.set_min_width(NAME);
        ui.add(Button::new(text).frame(false).truncate()).on_hover_text(says).clicked()
    })
    .inner
}

fn cell(ui: &mut Ui, text: RichText, width: f32) {
    ui.allocate_ui_with_layout(vec2(width, ROW), Layout::right_to_left(Align::Center), |ui| {
        ui.set_min_width(width);
        ui.label(text);
    });
}

/// Three digits.
fn brief(value: f64) -> String {
    let decimals = if value >= 100.0 {
        0
    } else if value >= 10.0 {
        1
    } else if value >= 1.0 {
        2
    } else {
        3
    };
    format!("{value:.decimals$}")
}

/// The orders of the greatest error; those of the root mean square under the pointer.
pub fn orders_ui(ui: &mut Ui, study: &Study) {
    let fitted: Vec<_> = study.series.iter().filter(|series| series.order.is_some()).collect();
    if !fitted.is_empty() {
        ui.add_space(8.0);
        ui.label(RichText::new("Order of convergence").strong());
        let tip = "The error goes as the spacing of the vertices to this power; ± 95 % by Student's t";
        ui.label(RichText::new("of the greatest error, ± 95 %").weak()).on_hover_text(tip);
        Grid::new("orders").num_columns(2).spacing([8.0, 2.0]).min_row_height(ROW).show(ui, |ui| {
            for series in fitted {
                let affine = if series.interpolation == Some(Interpolation::Affine) { ", affine" } else { "" };
                let n = if study.series.iter().any(|other| other.n != series.n) {
                    format!(", n = {}", series.n)
                } else {
                    String::new()
                };
                ui.label(format!("{}{affine}{n}", series.method.title()));
                let [order, rms] = [series.order, series.order_rms].map(|fit| {
                    fit.map_or_else(|| "–".to_owned(), |fit| format!("{:.2} ± {:.2}", fit.slope, fit.confidence))
                });
                ui.label(RichText::new(order).monospace()).on_hover_text(format!("of the RMS: {rms}"));
                ui.end_row();
            }
        });
    }
    for omitted in &study.omitted {
        ui.label(RichText::new(format!("Not measured: {}: {}.", omitted.method.title(), omitted.reason)).weak());
    }
}
