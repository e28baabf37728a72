//! Numbers as the filled-in equation shows them: aligned, with the digits that mean something.

use eframe::egui::text::{LayoutJob, TextFormat};
use eframe::egui::{Align, Color32, FontFamily, FontId};
use glam::DVec3;

/// Below this a number with four decimals has lost its digits and is written with a power of ten.
const SMALL: f64 = 5e-4;
/// From this on a number is too long to be written out.
const LARGE: f64 = 1e5;

/// A number as it is written: digits, and the power of ten behind them where they are very small or very large.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Figure {
    digits: String,
    power: Option<i32>,
}

impl Figure {
    /// `value` with four digits behind the point, fewer where it is large.
    pub fn new(value: f64) -> Self {
        Self::with_decimals(value, decimals_for(value).max(4).min(most_decimals(value)))
    }

    fn with_decimals(value: f64, decimals: usize) -> Self {
        let size = value.abs();
        if value == 0.0 || (SMALL..LARGE).contains(&size) || !size.is_finite() {
            return Self { digits: minus(&format!("{value:.decimals$}")), power: None };
        }
        let text = format!("{value:.1e}");
        let (digits, power) = text.split_once('e').unwrap_or((&text, "0"));
        Self { digits: minus(digits), power: power.parse().ok() }
    }

    /// As plain text, for a screen reader.
    pub fn text(&self) -> String {
        match self.power {
            None => self.digits.clone(),
            Some(power) => format!("{}·10^{}", self.digits, minus(&power.to_string())),
        }
    }

    /// As text of one width for every digit, the power of ten raised.
    pub fn layout(&self, size: f32, colour: Color32) -> LayoutJob {
        let format = |size: f32, valign: Align| TextFormat {
            font_id: FontId::new(size, FontFamily::Monospace),
            color: colour,
            valign,
            ..TextFormat::default()
        };
        let mut job = LayoutJob::default();
        job.append(&self.digits, 0.0, format(size, Align::Center));
        if let Some(power) = self.power {
            job.append("·10", 0.0, format(size * 0.85, Align::Center));
            job.append(&minus(&power.to_string()), 0.0, format(size * 0.68, Align::TOP));
        }
        job
    }
}

/// A column of three numbers with their points below each other. Numbers that somebody has chosen have a few digits and
/// show no more; others show four that count.
pub fn column(values: DVec3) -> [Figure; 3] {
    let values = values.to_array();
    let short = (2..=4).find(|&decimals| values.iter().all(|value| is_short(*value, decimals)));
    let decimals = short.unwrap_or_else(|| {
        let needed = values.iter().map(|value| decimals_for(*value)).max();
        let room = values.iter().map(|value| most_decimals(*value)).min();
        needed.unwrap_or(4).min(room.unwrap_or(4))
    });
    values.map(|value| Figure::with_decimals(value, decimals))
}

/// Three numbers as text; one where they are equal.
pub fn triple(values: DVec3) -> String {
    let [red, green, blue] = column(values).map(|figure| figure.text());
    if red == green && green == blue { red } else { format!("{red} red, {green} green, {blue} blue") }
}

fn is_short(value: f64, decimals: usize) -> bool {
    let scaled = value * 10f64.powi(decimals as i32);
    value.abs() < 1e3 && (scaled - scaled.round()).abs() < 1e-6
}

/// Decimals by which `value` shows at least three digits.
fn decimals_for(value: f64) -> usize {
    match value.abs() {
        size if size >= 1000.0 => 0,
        size if size >= 100.0 => 1,
        size if size >= 10.0 => 2,
        size if (SMALL..0.1).contains(&size) => 4,
        _ => 3,
    }
}

/// Decimals that leave `value` short enough for its column.
fn most_decimals(value: f64) -> usize {
    match value.abs() {
        size if size >= 1000.0 => 0,
        size if size >= 100.0 => 1,
        size if size >= 10.0 => 2,
        _ => 4,
    }
}

fn minus(text: &str) -> String {
    text.replace('-', "−")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(values: [f64; 3]) -> [String; 3] {
        column(DVec3::from_array(values)).map(|figure| figure.text())
    }

    #[test]
    fn chosen_numbers_keep_their_few_digits() {
        assert_eq!(texts([0.12, 0.28, 1.0]), ["0.12", "0.28", "1.00"]);
        assert_eq!(texts([0.125, 0.5, 2.0]), ["0.125", "0.500", "2.000"]);
    }

    #[test]
    fn a_column_has_one_number_of_decimals() {
        assert_eq!(texts([0.812_345, 0.5, 0.25]), ["0.812", "0.500", "0.250"]);
        assert_eq!(texts([0.812_345, 0.012_345, 0.0]), ["0.8123", "0.0123", "0.0000"]);
        assert_eq!(texts([12.3456, 0.333_333, 1.0]), ["12.35", "0.33", "1.00"]);
    }

    #[test]
    fn very_small_and_very_large_numbers_have_a_power_of_ten() {
        assert_eq!(Figure::new(0.000_012_34).text(), "1.2·10^−5");
        assert_eq!(Figure::new(-1.5e20).text(), "−1.5·10^20");
        assert_eq!(Figure::new(0.0).text(), "0.0000");
        assert_eq!(Figure::new(0.554_4).text(), "0.5544");
        assert_eq!(Figure::new(153.0).text(), "153.0");
        assert_eq!(Figure::new(f64::INFINITY).text(), "inf");
    }
}
