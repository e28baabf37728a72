//! The equation above the controls. Its symbols are a table of contents: pointing at one highlights its
//! controls, and a click leads to them.

use crate::analysis::probe::{Letters, equation_letters};
use crate::app::session::Session;
use crate::app::widgets::palette::tone_text;
use crate::app::widgets::typeset::{Piece, RunId, formula, run_ui};
use crate::text::text;
use eframe::egui::{Ui, Visuals, vec2};

/// The size of the equation's letters, in points.
const SIZE: f32 = 18.0;

/// Shows the equation of the session's scene; unused terms are pale.
pub fn equation_ui(ui: &mut Ui, session: &Session) {
    let parts = equation_letters(&session.shown.scene);
    let width = ui.available_width();
    ui.scope(|ui| {
        ui.spacing_mut().item_spacing = vec2(0.0, 2.0);
        ui.set_max_width(width);
        ui.horizontal_wrapped(|ui| {
            for (number, part) in parts.iter().enumerate() {
                let run: Vec<Piece> = part
                    .iter()
                    .flat_map(|letters| pieces(ui.visuals(), letters))
                    .collect();
                let id = RunId {
                    id: ui.scope_id().with(("symbol", number)),
                    name: text!("in-equation"),
                };
                run_ui(ui, &run, SIZE, id);
            }
        });
    });
}

fn pieces(visuals: &Visuals, (letters, tone, absent): &Letters) -> Vec<Piece> {
    let mut pieces = formula(visuals, letters, tone_text(visuals, *tone), |_| {
        String::new()
    });
    for piece in pieces
        .iter_mut()
        .filter(|piece| *absent && piece.symbol.is_some())
    {
        piece.colour = visuals.weak_text_color().gamma_multiply(0.55);
    }
    pieces
}
