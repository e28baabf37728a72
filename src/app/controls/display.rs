//! From intensities to the screen.

use crate::app::engine::Engine;
use crate::app::row::{About, choice, colour};
use crate::app::stages::grouped;
use crate::app::state::AppState;
use crate::app::symbol::Symbol;
use crate::scene::{Display, Encoding, Image, Overflow};
use eframe::egui::{RichText, Ui};

pub fn display_ui(ui: &mut Ui, state: &mut AppState, engine: &Engine) {
    let AppState { document, lit, .. } = state;
    let scene = &mut document.scene;
    let default = Display::default();
    let symbol = Some(Symbol::Intensity);
    let about = About {
        label: "If I > 1",
        name: "Overflow",
        tip: "What happens to intensities that the display cannot show.",
        symbol,
        ..About::default()
    };
    let choices = [
        (Overflow::Clamp, "shown as 1", ""),
        (Overflow::Scale, "scale the picture", "The whole picture is divided by its greatest value"),
        (Overflow::Mark, "hatched", "Where a channel is above 1, a hatching says so"),
    ];
    choice(ui, lit, &about, default.overflow, &choices, &mut scene.display.overflow);
    overflow_ui(ui, engine.report().overflowing);
    let about = About {
        letter: "I",
        label: "encoding",
        name: "Encoding",
        tip: "From linear intensity to the stored value.",
        symbol,
        ..About::default()
    };
    let choices = [
        (Encoding::Raw, "value × 255", "The textbooks' way"),
        (Encoding::Srgb, "sRGB", "The transfer function of IEC 61966-2-1: light on the screen is proportional to I"),
    ];
    choice(ui, lit, &about, default.encoding, &choices, &mut scene.display.encoding);
    let about = About { label: "Background", tip: "What is seen beside the object; linear.", ..About::default() };
    colour(ui, lit, &about, Image::default().background, &mut scene.image.background);
}

/// How many pixels the policy is about.
fn overflow_ui(ui: &mut Ui, pixels: u64) {
    let text = match pixels {
        0 => "No pixel is above 1".to_owned(),
        1 => "1 pixel is above 1".to_owned(),
        many => format!("{} pixels are above 1", grouped(many)),
    };
    ui.label(RichText::new(text).weak());
}
