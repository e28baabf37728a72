//! From the sum to the stored pixel: what is above 1, the encoding, the rounding.

use super::notation::Notation;
use super::outline::{Line, Says, line_ui};
use crate::analysis::ProbeHit;
use crate::render::srgb;
use crate::scene::{Display, Encoding, Overflow};
use eframe::egui::{RichText, Ui};
use glam::DVec3;

/// The display's steps.
pub fn stored_ui(ui: &mut Ui, display: &Display, hit: &ProbeHit, notation: &Notation) {
    let over = hit.sum.max_element() > 1.0;
    let line = |ui: &mut Ui, sign, name: &str, says, colour| {
        line_ui(ui, &Line { sign, name, says, colour, flat: true, lettered: false });
    };
    let mut shown = Some(hit.sum.max(DVec3::ZERO));
    match display.overflow {
        Overflow::Clamp if over => {
            shown = shown.map(|sum| sum.min(DVec3::ONE));
            line(ui, "", "clamped to 1", Says::sum(shown.unwrap_or_default()), notation.plain());
        }
        Overflow::Mark if over => {
            shown = None;
            ui.label(RichText::new("Above 1: hatched in black and white.").weak());
        }
        Overflow::Scale => {
            shown = shown.map(|sum| sum / hit.divisor);
            if hit.divisor > 1.0 {
                let greatest = format!("Divided by {:.3}, the picture's greatest value:", hit.divisor);
                ui.label(RichText::new(greatest).weak());
                line(ui, "", "scaled", Says::sum(shown.unwrap_or_default()), notation.plain());
            }
        }
        Overflow::Clamp | Overflow::Mark => {}
    }
    if let Some(shown) = shown {
        let encoded = match display.encoding {
            Encoding::Raw => shown,
            Encoding::Srgb => DVec3::from_array(shown.to_array().map(srgb)),
        };
        if display.encoding == Encoding::Srgb {
            line(ui, "", "sRGB", Says::sum(encoded), notation.plain());
        }
        let codes = encoded.to_array().map(|value| format!("{:.1}", 255.0 * value));
        line(ui, "", "× 255", Says::Channels(codes), notation.plain());
    }
    let stored = hit.stored.map(|code| code.to_string());
    line(ui, "=", "stored", Says::Channels(stored), notation.strong());
}
