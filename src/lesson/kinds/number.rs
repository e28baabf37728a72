//! Answers that are numbers: in a few characters, and those of a class over their axis.

use super::kind::Predictions;
use crate::lesson::control::{control_unit, long_control_name};
use crate::lesson::html::{Element, Html, element};
use crate::text::{fixed, text};

/// Returns the line that a student writes a number on.
pub fn blank_line() -> Element {
    element("span").class("blank")
}

/// Returns the line for the value of a control.
pub fn control_line(key: &str) -> Html {
    let name = element("p").with(long_control_name(key)).with(" = ");
    let line = name.with(blank_line()).with(" ").with(control_unit(key));
    Html::new().line(line)
}

/// Returns a number in a few characters.
pub fn short_number(value: f64) -> String {
    let digits = if value.abs() >= 100.0 { 1 } else { 3 };
    let text = fixed(value, digits);
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// Returns a number with its unit.
pub fn with_unit(number: &str, unit: &str) -> String {
    let space = if unit == "°" { "" } else { " " };
    format!("{number}{space}{unit}").trim_end().to_owned()
}

/// Returns how many digits after the point show a difference of the tolerance.
pub fn digits(tolerance: f64) -> usize {
    (0..6)
        .find(|digits| 0.1f64.powi(*digits) <= tolerance * 1.01)
        .unwrap_or(6) as usize
}

/// Returns the predicted numbers as dots over their axis, one above the other, with the band that counts as right; the axis
/// is the `range`, or what they span, without a band.
pub fn number_chart(
    class: &Predictions<'_, f64, f64>,
    range: Option<[f64; 2]>,
    tolerance: f64,
) -> Html {
    const COLUMNS: usize = 60;
    const DOT: f64 = 4.0;
    let mut predicted: Vec<f64> = class.given.iter().map(|(given, _)| **given).collect();
    predicted.sort_by(f64::total_cmp);
    let right = class.right.copied();
    let all = || predicted.iter().copied().chain(right);
    let least = all().fold(f64::INFINITY, f64::min);
    let greatest = all().fold(f64::NEG_INFINITY, f64::max);
    if !(least.is_finite() && greatest.is_finite()) {
        return Html::new();
    }
    let margin = 0.05 * (greatest - least).max(2.0 * tolerance);
    let x = range.unwrap_or([least - margin, greatest + margin]);
    let width = 520.0;
    let along = |value: f64| ((value - x[0]) / (x[1] - x[0])).clamp(0.0, 1.0);
    let mut columns = vec![0usize; COLUMNS];
    let places: Vec<(usize, usize)> = predicted
        .iter()
        .map(|value| {
            let column = ((along(*value) * COLUMNS as f64) as usize).min(COLUMNS - 1);
            columns[column] += 1;
            (column, columns[column])
        })
        .collect();
    let highest = columns.iter().copied().max().unwrap_or(0);
    // Large classes get smaller steps, not a higher drawing.
    let step = (2.0 * DOT).min(200.0 / highest.max(1) as f64);
    let height = (highest.max(4) as f64 * 2.0 * DOT + 6.0).min(210.0);
    let mut svg = element("svg")
        .attribute("viewBox", format!("-30 -4 580 {:.0}", height + 28.0))
        .attribute("width", 580)
        .attribute("role", "img")
        .broken();
    if let Some(right) = right {
        let at = |value: f64| along(value) * width;
        let band = if range.is_some() {
            [at(right - tolerance), at(right + tolerance)]
        } else {
            [at(right); 2]
        };
        let band = element("rect")
            .length("x", band[0])
            .length("width", band[1] - band[0])
            .length("height", height)
            .attribute("fill", "#dcefdc");
        let line = element("path")
            .attribute("d", format!("M{:.1} 0V{height:.1}", at(right)))
            .attribute("stroke", "#2e7d43")
            .attribute("stroke-width", 2);
        svg = svg.with(band).line(line);
    }
    let axis = format!("M0 {height:.1}H{width}");
    svg = svg.line(
        element("path")
            .attribute("d", axis)
            .attribute("stroke", "#555"),
    );
    for index in 0..=4 {
        let value = x[0] + (x[1] - x[0]) * f64::from(index) / 4.0;
        let number = element("text")
            .length("x", along(value) * width)
            .length("y", height + 18.0)
            .attribute("font-size", 13)
            .attribute("text-anchor", "middle");
        svg = svg.line(number.with(short_number(value)));
    }
    for (column, row) in places {
        let dot = element("circle")
            .length("cx", (column as f64 + 0.5) / COLUMNS as f64 * width)
            .length("cy", height - (row as f64 - 0.5) * step)
            .length("r", DOT.min(step))
            .attribute("fill", "#3d73a8");
        svg = svg.line(dot);
    }
    let caption = element("figcaption").with(text!("class-numbers"));
    Html::new().line(element("figure").line(svg).with(caption))
}
