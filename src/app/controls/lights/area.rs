//! An area light's shape, and the points that it is replaced by.

use crate::app::document::Document;
use crate::app::row::{About, NumberRow, Rail, choice, number, whole};
use crate::app::sampling::{Finding, Sampling};
use crate::app::symbol::{Lit, Symbol};
use crate::scene::{AreaShape, GREATEST_LENGTH, Light};
use eframe::egui::{RichText, Ui};

/// What the sliders of lengths span, world units.
const LENGTHS: std::ops::RangeInclusive<f64> = 0.0..=4.0;

pub fn area_ui(ui: &mut Ui, lit: &mut Lit, name: &str, light: &mut Light) {
    let (default, symbol) = (Light::default(), Some(Symbol::Light));
    let row_name = format!("{name} shape");
    let tip = "What the light looks like.";
    let about = About { label: "Shape", name: &row_name, tip, symbol, ..About::default() };
    let shapes = [
        (AreaShape::Rectangle, "rectangle", "A window or a panel; its points shine to all sides"),
        (AreaShape::Sphere, "sphere", "A globe"),
    ];
    choice(ui, lit, &about, default.shape, &shapes, &mut light.shape);
    let [width, height] = &mut light.extent;
    let lengths: &mut [(&str, &str, &mut f64, f64)] = match light.shape {
        AreaShape::Rectangle => &mut [
            ("Width", "The rectangle's level side; world units.", width, default.extent[0]),
            ("Height", "The rectangle's other side; world units.", height, default.extent[1]),
        ],
        AreaShape::Sphere => &mut [("Radius", "The sphere's; world units.", &mut light.radius, default.radius)],
    };
    for (label, tip, value, default) in lengths {
        let row_name = format!("{name} {}", label.to_lowercase());
        let about = About { label, name: &row_name, tip, symbol, ..About::default() };
        let rail = Rail { limits: 0.0..=GREATEST_LENGTH, ..Rail::linear(LENGTHS) };
        number(ui, lit, &NumberRow { about, rail, default: *default }, value);
    }
    let row_name = format!("{name} samples");
    let tip = "N, the points that stand for the light, spread evenly over it; 1 to 1024. The work grows with N, the error falls about as 1/N.";
    let about = About { letter: "N", label: "points", name: &row_name, tip, symbol, ..About::default() };
    let greatest = f64::from(Light::MAX_SAMPLES);
    let rail = Rail { limits: 1.0..=greatest, decimals: 0, ..Rail::logarithmic(1.0..=greatest) };
    whole(ui, lit, &NumberRow { about, rail, default: f64::from(default.samples) }, &mut light.samples);
}

/// The error of the present number of points, in a line that is always there.
pub fn error_ui(ui: &mut Ui, sampling: &mut Sampling, document: &Document, index: usize) {
    let Some(light) = document.scene.lights.get(index) else { return };
    let text = match sampling.ask(ui.ctx(), document, index) {
        Finding::Waiting => "…".to_owned(),
        Finding::Nothing => "no error: this light does not reach the picture".to_owned(),
        Finding::Error(error) => {
            let (rms, greatest) = (percent(error.rms), percent(error.greatest));
            format!("N = {}: error {rms} (rms), {greatest} greatest", light.samples)
        }
    };
    let tip = "The difference to 4096 points, of white, over a small picture without shadows: the root mean square and the greatest of its channels.";
    ui.label(RichText::new(text).weak()).on_hover_text(tip);
}

/// A part of white with two digits that mean something.
fn percent(part: f64) -> String {
    let percent = part * 100.0;
    match percent {
        p if p < 0.001 => "under 0.001 %".to_owned(),
        p if p < 0.01 => format!("{p:.4} %"),
        p if p < 0.1 => format!("{p:.3} %"),
        p if p < 1.0 => format!("{p:.2} %"),
        p if p < 10.0 => format!("{p:.1} %"),
        p => format!("{p:.0} %"),
    }
}

#[cfg(test)]
mod tests {
    use super::percent;

    #[test]
    fn an_error_has_two_digits() {
        for (part, text) in
            [(0.0, "under 0.001 %"), (0.000_041, "0.0041 %"), (0.004_1, "0.41 %"), (0.012, "1.2 %"), (0.29, "29 %")]
        {
            assert_eq!(percent(part), text);
        }
    }
}
