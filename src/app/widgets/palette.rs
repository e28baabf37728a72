//! The colours that carry meaning: one for each vector and one for each term of the equation.
//!
//! The interface itself is grey, so that a colour on the screen always refers to a letter. A term takes the colour of
//! the vector that determines it: diffuse light that of L, specular light that of R (of H in Blinn's model). Ambient
//! light has no direction and stays neutral.

use crate::analysis::probe::Tone;
use crate::figure::palette::{self, Rgb8, Vector};
use eframe::egui::{Color32, Ui, Visuals};

/// Minimum contrast of text required by WCAG 2.2 (success criterion 1.4.3).
pub const READABLE: f64 = 4.5;

/// Returns a vector's colour as drawn in pictures.
pub fn vector(vector: Vector) -> Color32 {
    let [r, g, b] = vector.colour();
    Color32::from_rgb(r, g, b)
}

/// Returns a vector's colour as text on a panel, a window, a row of a table or a control.
pub fn vector_text(visuals: &Visuals, letter: Vector) -> Color32 {
    // A control is the background closest to text in lightness, in both themes.
    readable(vector(letter), visuals.widgets.inactive.bg_fill)
}

/// Returns the colour of right answers.
pub fn right_colour(ui: &Ui) -> Color32 {
    vector_text(ui.visuals(), Vector::V)
}

/// Returns the colour of a part of the equation as text on a panel.
pub fn tone_text(visuals: &Visuals, tone: Tone) -> Color32 {
    match tone {
        Tone::Plain => visuals.text_color(),
        Tone::Weak => visuals.weak_text_color(),
        Tone::Strong => visuals.strong_text_color(),
        Tone::Of(vector) => vector_text(visuals, vector),
    }
}

/// Moves `colour` towards black or white just far enough to be readable on `background`.
pub fn readable(colour: Color32, background: Color32) -> Color32 {
    let [r, g, b] = palette::readable(rgb(colour), rgb(background), READABLE);
    Color32::from_rgb(r, g, b)
}

/// Converts a colour to that of drawings.
pub fn rgb(colour: Color32) -> Rgb8 {
    [colour.r(), colour.g(), colour.b()]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::widgets::theme;

    fn contrast(a: Color32, b: Color32) -> f64 {
        palette::contrast(rgb(a), rgb(b))
    }

    /// Returns `colour` painted over `background` with the opacity `share`.
    fn over(colour: Color32, background: Color32, share: f32) -> Color32 {
        let mix =
            |a: u8, b: u8| (f32::from(a) * share + f32::from(b) * (1.0 - share)).round() as u8;
        let ([r, g, b], [x, y, z]) = (rgb(colour), rgb(background));
        Color32::from_rgb(mix(r, x), mix(g, y), mix(b, z))
    }

    #[test]
    fn every_text_is_readable_wherever_it_stands_in_both_themes() {
        for visuals in [theme::dark_visuals(), theme::light_visuals()] {
            let widgets = &visuals.widgets;
            let surfaces = [
                ("a panel", visuals.panel_fill),
                ("a window", visuals.window_fill),
                ("a well", visuals.extreme_bg_color),
                ("a row of a table", visuals.faint_bg_color),
                ("a control", widgets.inactive.bg_fill),
            ];
            let under_pointer = [("a control under the pointer", widgets.hovered.bg_fill)];
            let texts = [
                ("text", visuals.text_color()),
                ("weak text", visuals.weak_text_color()),
                ("strong text", visuals.strong_text_color()),
                ("a link", visuals.hyperlink_color),
                ("a warning", visuals.warn_fg_color),
                ("an error", visuals.error_fg_color),
            ];
            let on_all = texts.iter().flat_map(|text| {
                surfaces
                    .iter()
                    .chain(&under_pointer)
                    .map(move |surface| (*text, *surface))
            });
            let letters = Vector::ALL.into_iter().flat_map(|letter| {
                let text = (letter.letter(), vector_text(&visuals, letter));
                surfaces.iter().map(move |surface| (text, *surface))
            });
            let selection = visuals.selection;
            let own = [
                (
                    ("what is chosen", selection.stroke.color),
                    ("its fill", selection.bg_fill),
                ),
                (
                    ("text", widgets.active.fg_stroke.color),
                    ("a pressed control", widgets.active.bg_fill),
                ),
            ];
            let disabled = surfaces.map(|surface| {
                let text = over(visuals.text_color(), surface.1, visuals.disabled_alpha);
                (("what is disabled", text), surface)
            });
            for ((text, colour), (surface, background)) in
                on_all.chain(letters).chain(own).chain(disabled)
            {
                let ratio = contrast(colour, background);
                assert!(
                    ratio >= READABLE,
                    "{text} on {surface} has contrast {ratio:.2}, dark {}",
                    visuals.dark_mode
                );
            }
            assert!(contrast(visuals.text_color(), visuals.panel_fill) >= 7.0);
            // The focus ring and the selection stand out from the panel (WCAG 2.2, 1.4.11).
            for colour in [visuals.hyperlink_color, selection.bg_fill] {
                assert!(contrast(colour, visuals.panel_fill) >= 3.0, "{colour:?}");
            }
        }
    }
}
