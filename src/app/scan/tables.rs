//! The tables: P, Q and the pixel with their values, what barycentric interpolation gives, and the edge table.

use super::super::report::table_ui;
use super::ScanView;
use eframe::egui::{RichText, Ui};

pub fn tables_ui(ui: &mut Ui, view: &ScanView) {
    let Some(scan) = view.ready() else { return };
    let step = view.step();
    let point = scan.at(step);
    if point.p.is_some() {
        table_ui(ui, "scan found", &scan.found_table(step), false);
        if point.pixel.is_some() {
            ui.label(RichText::new(scan.compared_name()).weak());
        }
        ui.add_space(8.0);
    }
    ui.label(RichText::new("Edge table").strong());
    table_ui(ui, "scan edges", &scan.edge_table(step), false);
}
