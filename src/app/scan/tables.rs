//! The tables: P, Q and the pixel with their values, what barycentric interpolation gives, and the edge table.

use super::ScanView;
use super::formula::{faint, lettered};
use crate::analysis::{Carried, Scan, ScanPoint};
use eframe::egui::text::LayoutJob;
use eframe::egui::{Align, Color32, Grid, Label, Layout, RichText, Ui, WidgetText, vec2};
use glam::DVec3;

/// Height of a table's rows, points.
const ROW: f32 = 21.0;
/// Widths of the columns of the first table: what it is, α, and three values.
const FOUND: [f32; 5] = [74.0, 48.0, 56.0, 56.0, 56.0];
/// Of the edge table: which edge, where it begins and ends, x there, and what x grows by.
const EDGES: [f32; 5] = [74.0, 48.0, 56.0, 56.0, 56.0];
/// Of polygons with more edges the table holds the active ones alone.
const MOST_EDGES: usize = 12;

pub fn tables_ui(ui: &mut Ui, view: &ScanView) {
    let Some(scan) = view.ready() else { return };
    let point = scan.at(view.step());
    if point.p.is_some() {
        found_ui(ui, scan, &point);
        ui.add_space(8.0);
    }
    edges_ui(ui, scan, &point);
}

fn found_ui(ui: &mut Ui, scan: &Scan, point: &ScanPoint<'_>) {
    let plain = ui.visuals().text_color();
    Grid::new("scan found").num_columns(5).spacing([2.0, 1.0]).min_row_height(ROW).show(ui, |ui| {
        let [a, b, c] = scan.carried.components();
        header(ui, ["", "α", a, b, c], &FOUND);
        for (letter, crossing) in [("P", point.p), ("Q", point.q)] {
            let Some(crossing) = crossing else { continue };
            let name = lettered(&format!("{letter} on {}", scan.edge_name(crossing.edge)), plain);
            row(ui, name, Some(crossing.alpha), crossing.value, plain);
        }
        let Some(pixel) = point.pixel else { return };
        row(ui, lettered("pixel", plain), Some(pixel.alpha), pixel.value, ui.visuals().strong_text_color());
        if scan.carried == Carried::Normal {
            header(ui, ["", "", "r", "g", "b"], &FOUND);
            row(ui, lettered("I", plain), None, pixel.intensity, ui.visuals().strong_text_color());
        }
        let weak = ui.visuals().weak_text_color();
        row(ui, lettered("barycentric", weak), None, pixel.barycentric, weak);
        row(ui, lettered("difference", weak), None, pixel.intensity - pixel.barycentric, weak);
    });
    if point.pixel.is_some() {
        ui.label(faint(scan.compared_name()));
    }
}

fn edges_ui(ui: &mut Ui, scan: &Scan, point: &ScanPoint<'_>) {
    ui.label(RichText::new("Edge table").strong());
    let many = scan.edges.len() > MOST_EDGES;
    Grid::new("scan edges").num_columns(5).spacing([2.0, 1.0]).min_row_height(ROW).show(ui, |ui| {
        header(ui, ["", "top", "bottom", "x", "dx/dy"], &EDGES);
        for (index, edge) in scan.edges.iter().enumerate() {
            let active = point.line.active.contains(&index);
            if many && !active {
                continue;
            }
            let colour = if active { ui.visuals().strong_text_color() } else { ui.visuals().weak_text_color() };
            let mark = if active { "■" } else { "□" };
            cell(ui, lettered(&format!("{mark} {}", scan.edge_name(index)), colour), Align::Min, EDGES[0]);
            let values = [edge.y_top, edge.y_bottom, edge.x_top, edge.dx_dy];
            for (value, width) in values.into_iter().zip(&EDGES[1..]) {
                cell(ui, RichText::new(number(value, 2)).monospace().color(colour), Align::Max, *width);
            }
            ui.end_row();
        }
    });
    let words = if many { format!("■ active; {} edges in all", scan.edges.len()) } else { "■ active".to_owned() };
    ui.label(faint(words));
}

fn header(ui: &mut Ui, names: [&str; 5], widths: &[f32; 5]) {
    for (index, (name, width)) in names.into_iter().zip(widths).enumerate() {
        let align = if index == 0 { Align::Min } else { Align::Max };
        cell(ui, faint(name), align, *width);
    }
    ui.end_row();
}

fn row(ui: &mut Ui, name: LayoutJob, alpha: Option<f64>, values: DVec3, colour: Color32) {
    cell(ui, name, Align::Min, FOUND[0]);
    let number_cell = |ui: &mut Ui, text: String, width: f32| {
        cell(ui, RichText::new(text).monospace().color(colour), Align::Max, width);
    };
    number_cell(ui, alpha.map(|alpha| number(alpha, 3)).unwrap_or_default(), FOUND[1]);
    for (value, width) in values.to_array().into_iter().zip(&FOUND[2..]) {
        number_cell(ui, number(value, 4), *width);
    }
    ui.end_row();
}

fn cell(ui: &mut Ui, text: impl Into<WidgetText>, align: Align, width: f32) {
    ui.allocate_ui_with_layout(vec2(width, ROW), Layout::top_down(align), |ui| {
        ui.set_min_width(width);
        ui.add(Label::new(text).extend());
    });
}

/// A number with so many decimals, fewer where it would not fit.
fn number(value: f64, decimals: usize) -> String {
    let decimals = if value.abs() >= 1e3 {
        0
    } else if value.abs() >= 100.0 {
        1
    } else {
        decimals
    };
    format!("{value:.decimals$}").replace('-', "−")
}
