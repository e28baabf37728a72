//! Number formats of the filled-in equation.

use crate::figure::scientific;
use crate::scene::Rgb;
use crate::text::{fixed, text};
use glam::DVec3;

/// Smallest number with digits left in four decimals; from `LARGE` on a number is too long to be written out.
const SMALL: f64 = 5e-4;
const LARGE: f64 = 1e5;

/// Formats the share of `part` in the whole; none where there is no light.
pub fn percent(part: f64, whole: f64) -> Option<String> {
    let share = 100.0 * part / whole;
    (whole > 0.0).then(|| {
        if share > 0.0 && share < 0.1 {
            "< 0.1 %".into()
        } else {
            format!("{share:.1} %")
        }
    })
}

/// Formats a number with four decimals, fewer where it is large; very small and very large ones with a power of ten.
pub fn digits(value: f64) -> String {
    with_decimals(value, decimals(value, 4))
}

/// Formats numbers with aligned decimal points. Numbers that a user has chosen have few digits and show no more;
/// others show at least three significant digits, as far as space allows.
pub fn digits_below(values: Rgb) -> [String; 3] {
    let values = values.to_array();
    let is_short = |value: &f64, decimals: i32| {
        let scaled = value * 10f64.powi(decimals);
        value.abs() < 1e3 && (scaled - scaled.round()).abs() < 1e-6
    };
    let short = (2..=4).find(|decimals| values.iter().all(|value| is_short(value, *decimals)));
    let needed = |value: f64| {
        let small = (SMALL..0.1).contains(&value.abs());
        decimals(value, if small { 4 } else { 3 })
    };
    let count = match short {
        Some(decimals) => decimals as usize,
        None => {
            let needed = values.map(needed).into_iter().max();
            let allowed = values.map(|value| decimals(value, 4)).into_iter().min();
            needed.min(allowed).unwrap_or(4)
        }
    };
    values.map(|value| with_decimals(value, count))
}

/// Formats three numbers; one where they are equal.
pub fn triple(values: Rgb) -> String {
    let [red, green, blue] = digits_below(values);
    if red == green && green == blue {
        red
    } else {
        in_channels([&red, &green, &blue])
    }
}

/// Names the channels of three formatted numbers.
pub fn in_channels([red, green, blue]: [&str; 3]) -> String {
    text!("point-channels", red = red, green = green, blue = blue)
}

/// Returns the number of decimals for a number, `most` for one below 10.
fn decimals(value: f64, most: usize) -> usize {
    match value.abs() {
        size if size >= 1000.0 => 0,
        size if size >= 100.0 => 1,
        size if size >= 10.0 => 2,
        _ => most,
    }
}

/// Formats a number with that many decimals, or with a power of ten if it is very small or very large.
fn with_decimals(value: f64, decimals: usize) -> String {
    let size = value.abs();
    if value == 0.0 || (SMALL..LARGE).contains(&size) || !size.is_finite() {
        return fixed(value, decimals);
    }
    scientific(value)
}

/// Formats a vector with three decimals.
pub fn coordinates(v: DVec3) -> String {
    let [x, y, z] = v.to_array().map(|part| fixed(part, 3));
    format!("({x}, {y}, {z})")
}
