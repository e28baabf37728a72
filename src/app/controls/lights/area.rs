//! The error of the points that stand for an area light.

use crate::app::document::Document;
use crate::app::sampling::{Finding, Sampling};
use eframe::egui::{RichText, Ui};

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
