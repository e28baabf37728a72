//! What the probe sees: the pixel, the equation filled in and the vectors.

use super::engine::Engine;
use super::filled::filled_ui;
use super::palette::vector_text;
use super::report::export_ui;
use super::state::AppState;
use crate::analysis::{Here, Probe, ProbeHit, Probed, digits};
use crate::figure::palette::Vector;
use eframe::egui::{Align, Color32, CornerRadius, Grid, Label, Layout, RichText, Sense, Ui, vec2};

/// Height of a table's rows, points.
const ROW: f32 = 21.0;

/// The equation filled in at the probe, with its vectors.
pub fn point_ui(ui: &mut Ui, state: &mut AppState, engine: &Engine) {
    let (Some(probe), Some(scene)) = (engine.probed(), engine.drawn()) else {
        return;
    };
    match &probe.hit {
        None => background_ui(ui, probe),
        Some(hit) => hit_ui(ui, state, probe, Here { scene, hit }),
    }
    export_ui(ui, state, "probe", || {
        let sampling = vec![None; probe.hit.as_ref().map_or(0, |hit| hit.lights.len())];
        Some((
            Box::new(Probed {
                probe: probe.clone(),
                sampling,
            }),
            engine.drawn()?.clone(),
        ))
    });
}

fn background_ui(ui: &mut Ui, probe: &Probe) {
    let [x, y] = probe.pixel;
    ui.label(RichText::new(format!("Pixel {x}, {y}")).strong());
    ui.add_space(4.0);
    ui.label("The probe sees the background. Double-click the object, or drag the ring onto it.");
}

fn hit_ui(ui: &mut Ui, state: &mut AppState, probe: &Probe, here: Here<'_>) {
    pixel_ui(ui, probe, here.hit);
    ui.add_space(8.0);
    filled_ui(ui, state, here);
    ui.add_space(8.0);
    ui.separator();
    let light = state.light.min(here.hit.lights.len().saturating_sub(1));
    vectors_ui(ui, here, light);
}

/// The pixel, its stored colour and where it lies.
fn pixel_ui(ui: &mut Ui, probe: &Probe, hit: &ProbeHit) {
    let [x, y] = probe.pixel;
    let [r, g, b] = hit.stored;
    ui.horizontal(|ui| {
        let (rect, _) = ui.allocate_exact_size(vec2(34.0, 34.0), Sense::hover());
        ui.painter()
            .rect_filled(rect, CornerRadius::same(5), Color32::from_rgb(r, g, b));
        ui.vertical(|ui| {
            ui.spacing_mut().item_spacing.y = 1.0;
            ui.label(RichText::new(format!("Pixel {x}, {y}")).strong());
            let face = hit
                .face
                .map_or_else(|| "true surface".to_owned(), |face| format!("face {face}"));
            ui.label(RichText::new(format!("{face}, depth {:.3}", hit.depth)).weak());
        });
    });
}

/// A cell of a table: words at the left, numbers at the right of columns of one width.
fn cell(ui: &mut Ui, text: RichText, align: Align) {
    let width = if align == Align::Min { 88.0 } else { 66.0 };
    ui.allocate_ui_with_layout(vec2(width, ROW), Layout::top_down(align), |ui| {
        ui.set_min_width(width);
        ui.add(Label::new(text).extend().selectable(true));
    });
}

/// The vectors at the probe and the angles between them, for one light.
fn vectors_ui(ui: &mut Ui, here: Here<'_>, light: usize) {
    let title = if here.hit.lights.len() > 1 {
        format!("Vectors, light {}", light + 1)
    } else {
        "Vectors".to_owned()
    };
    ui.label(RichText::new(title).strong());
    let visuals = ui.visuals().clone();
    let light = here.lights().nth(light);
    Grid::new("vectors")
        .num_columns(4)
        .spacing([4.0, 2.0])
        .min_row_height(ROW)
        .show(ui, |ui| {
            for (head, align) in [
                ("", Align::Min),
                ("x", Align::Max),
                ("y", Align::Max),
                ("z", Align::Max),
            ] {
                cell(ui, RichText::new(head).weak(), align);
            }
            ui.end_row();
            for (vector, _, v) in here
                .vectors()
                .into_iter()
                .chain(light.iter().flat_map(|light| light.vectors()))
            {
                let colour =
                    vector.map_or(visuals.text_color(), |vector| vector_text(&visuals, vector));
                cell(
                    ui,
                    RichText::new(vector.map_or("point", Vector::letter)).color(colour),
                    Align::Min,
                );
                for value in v.to_array() {
                    // Rounded: what is left of a 0 has no digits.
                    let number = digits((value * 1e4).round() / 1e4 + 0.0);
                    cell(
                        ui,
                        RichText::new(number).monospace().color(colour),
                        Align::Max,
                    );
                }
                ui.end_row();
            }
        });
    ui.add_space(6.0);
    Grid::new("angles")
        .num_columns(2)
        .spacing([4.0, 2.0])
        .min_row_height(ROW)
        .show(ui, |ui| {
            for (name, value) in light.iter().flat_map(|light| light.angles()) {
                cell(ui, RichText::new(name), Align::Min);
                cell(ui, RichText::new(value).monospace(), Align::Max);
                ui.end_row();
            }
        });
}
