//! The colours that carry meaning: one for each vector and one for each term of the equation.
//!
//! The interface itself is grey, so that a colour on the screen always says which letter is meant. A term takes the
//! colour of the vector that makes it: diffuse light that of L, specular light that of R (of H for Blinn's model);
//! ambient light comes from nowhere in particular and stays neutral.

use crate::analysis::Tone;
use crate::figure::palette::{self, Rgb8, Vector};
use eframe::egui::{Color32, Visuals};

/// Contrast that WCAG 2.2 asks of text (success criterion 1.4.3).
pub const READABLE: f64 = 4.5;

/// A vector's colour as drawn in pictures.
pub fn vector(vector: Vector) -> Color32 {
    let [r, g, b] = vector.colour();
    Color32::from_rgb(r, g, b)
}

/// A vector's colour as text on a panel.
pub fn vector_text(visuals: &Visuals, letter: Vector) -> Color32 {
    readable(vector(letter), visuals.panel_fill)
}

/// A part of the equation as text on a panel.
pub fn tone_text(visuals: &Visuals, tone: Tone) -> Color32 {
    match tone {
        Tone::Plain => visuals.text_color(),
        Tone::Weak => visuals.weak_text_color(),
        Tone::Strong => visuals.strong_text_color(),
        Tone::Of(vector) => vector_text(visuals, vector),
    }
}

/// `colour`, moved towards black or white no further than it takes to be read on `background`.
pub fn readable(colour: Color32, background: Color32) -> Color32 {
    let [r, g, b] = palette::readable(rgb(colour), rgb(background), READABLE);
    Color32::from_rgb(r, g, b)
}

fn rgb(colour: Color32) -> Rgb8 {
    [colour.r(), colour.g(), colour.b()]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::theme;

    fn contrast(a: Color32, b: Color32) -> f64 {
        palette::contrast(rgb(a), rgb(b))
    }

    #[test]
    fn every_letter_is_readable_in_both_themes() {
        for visuals in [theme::dark_visuals(), theme::light_visuals()] {
            for letter in Vector::ALL {
                let ratio = contrast(vector_text(&visuals, letter), visuals.panel_fill);
                assert!(
                    ratio >= READABLE,
                    "{} has contrast {ratio}",
                    letter.letter()
                );
            }
            assert!(contrast(visuals.text_color(), visuals.panel_fill) >= 7.0);
            assert!(contrast(visuals.weak_text_color(), visuals.panel_fill) >= READABLE);
        }
    }
}
