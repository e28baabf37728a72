//! Numbers as the filled-in equation writes them.

use crate::figure::scientific;
use crate::scene::Rgb;
use crate::text::{fixed, text};
use glam::DVec3;

/// Below this a number with four decimals has lost its digits and is written with a power of ten; from `LARGE` on it is too
/// long to be written out.
const SMALL: f64 = 5e-4;
const LARGE: f64 = 1e5;

/// What `part` is of the whole, in words; nothing where there is no light.
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

/// A number with four digits behind the point, fewer where it is large; very small and very large ones with a power of ten.
pub fn digits(value: f64) -> String {
    with_decimals(value, decimals(value, 4))
}

/// Numbers with their points below each other. Numbers that somebody has chosen have a few digits and show no more; others
/// show at least three that count, as far as there is room.
pub fn digits_below(values: Rgb) -> [String; 3] {
    let values = values.to_array();
    let is_short = |value: &f64, decimals: i32| {
        let scaled = value * 10f64.powi(decimals);
        value.abs() < 1e3 && (scaled - scaled.round()).abs() < 1e-6
    };
    let short = (2..=4).find(|decimals| values.iter().all(|value| is_short(value, *decimals)));
    let count = short.map_or_else(
        || {
            let needed = |value: &f64| {
                decimals(
                    *value,
                    if (SMALL..0.1).contains(&value.abs()) {
                        4
                    } else {
                        3
                    },
                )
            };
            let room = |value: &f64| decimals(*value, 4);
            values
                .iter()
                .map(needed)
                .max()
                .min(values.iter().map(room).min())
                .unwrap_or(4)
        },
        |decimals| decimals as usize,
    );
    values.map(|value| with_decimals(value, count))
}

/// Three numbers as text; one where they are equal.
pub fn triple(values: Rgb) -> String {
    let [red, green, blue] = digits_below(values);
    if red == green && green == blue {
        red
    } else {
        in_channels([&red, &green, &blue])
    }
}

pub fn in_channels([red, green, blue]: [&str; 3]) -> String {
    text!("point-channels", red = red, green = green, blue = blue)
}

/// Decimals behind the point of a number, `most` for one below 10.
fn decimals(value: f64, most: usize) -> usize {
    match value.abs() {
        size if size >= 1000.0 => 0,
        size if size >= 100.0 => 1,
        size if size >= 10.0 => 2,
        _ => most,
    }
}

fn with_decimals(value: f64, decimals: usize) -> String {
    let size = value.abs();
    if value == 0.0 || (SMALL..LARGE).contains(&size) || !size.is_finite() {
        return fixed(value, decimals);
    }
    scientific(value)
}

/// A vector with three decimals.
pub fn coordinates(v: DVec3) -> String {
    let [x, y, z] = v.to_array().map(|part| fixed(part, 3));
    format!("({x}, {y}, {z})")
}
