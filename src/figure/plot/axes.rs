//! Round numbers for an axis.

use super::data::Axis;
use crate::figure::text::raised;
use crate::text::{fixed, with_minus};

/// Steps of degrees that divide a right angle.
const DEGREES: [f64; 6] = [5.0, 10.0, 15.0, 30.0, 45.0, 90.0];

/// Maximum number of ticks that fit on an axis.
const MOST: f64 = 40.0;

/// Returns round numbers on `axis` with their texts: about as many as fit, at most twice `MOST` or those of three to
/// a decade. An axis that [`Axis::can_span`] refuses has none.
pub fn ticks(axis: &Axis, max_ticks: f64) -> Vec<(f64, String)> {
    if max_ticks.is_nan() || !Axis::can_span(axis.low, axis.high) {
        return vec![];
    }
    let max_ticks = max_ticks.clamp(1.0, MOST);
    if axis.decades {
        let beyond = axis.low.abs().max(axis.high.abs()) > WIDEST;
        return if beyond {
            vec![]
        } else {
            decades(axis, max_ticks)
        };
    }
    let min_step = (axis.high - axis.low) / max_ticks;
    let step = if axis.degrees {
        let known = DEGREES.into_iter().find(|step| *step >= min_step);
        known.unwrap_or_else(|| 90.0 * round_up(min_step / 90.0))
    } else {
        round_up(min_step)
    };
    let (first, last) = (
        (axis.low / step - 1e-9).ceil() as i64,
        (axis.high / step + 1e-9).floor() as i64,
    );
    (first..=last)
        .map(|i| {
            let value = i as f64 * step;
            (value, written(value, step, axis.degrees))
        })
        .collect()
}

/// Absolute value of a logarithm that no number in double precision reaches.
const WIDEST: f64 = 400.0;

/// Subdivisions of a decade, by the number of ticks that fit.
const MANTISSAS: [&[u8]; 3] = [&[1, 2, 5], &[1, 3], &[1]];

/// Returns the ticks of an axis of logarithms: 1, 2, 5 of each decade, 1 and 3, 1 alone, or that of every few.
fn decades(axis: &Axis, max_ticks: f64) -> Vec<(f64, String)> {
    let span = axis.high - axis.low;
    let mantissas = MANTISSAS
        .into_iter()
        .find(|list| list.len() as f64 * span <= max_ticks)
        .unwrap_or(&[1]);
    let every = (span / max_ticks).ceil().max(1.0) as i32;
    let (first, last) = (axis.low.floor() as i32, axis.high.ceil() as i32);
    let exponents = (first..=last).filter(|exponent| exponent % every == 0);
    let all =
        exponents.flat_map(|exponent| mantissas.iter().map(move |mantissa| (exponent, *mantissa)));
    let value = |(exponent, mantissa): (i32, u8)| f64::from(exponent) + f64::from(mantissa).log10();
    let inside = |tick: &(i32, u8)| (axis.low - 1e-9..=axis.high + 1e-9).contains(&value(*tick));
    // Where only whole decades have ticks, all are written alike.
    let alone = mantissas.len() == 1 && (axis.low < -1.5 || axis.high > 3.5);
    all.filter(inside)
        .map(|tick| (value(tick), power(tick, alone)))
        .collect()
}

/// Formats a mantissa times a power of ten: in digits as long as these are short, or as a power.
fn power((exponent, mantissa): (i32, u8), alone: bool) -> String {
    match exponent {
        0 | 1 if alone => 10u32.pow(exponent.unsigned_abs()).to_string(),
        _ if alone => format!("10{}", raised(exponent)),
        -2..0 => format!(
            "{:.*}",
            exponent.unsigned_abs() as usize,
            f64::from(mantissa) * 10f64.powi(exponent)
        ),
        0..5 => (u32::from(mantissa) * 10u32.pow(exponent.unsigned_abs())).to_string(),
        _ => magnitude(f64::from(mantissa) * 10f64.powi(exponent)),
    }
}

/// Returns the smallest of 1, 2, 5, 10, 20 … that is not less than `value`, which is positive.
pub fn round_up(value: f64) -> f64 {
    let magnitude = 10f64.powf(value.log10().floor());
    let times = [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .find(|times| times * magnitude >= value * (1.0 - 1e-9));
    times.unwrap_or(10.0) * magnitude
}

fn written(value: f64, step: f64, degrees: bool) -> String {
    let decimals = (-(step * (1.0 + 1e-9)).log10().floor()).clamp(0.0, 12.0) as usize;
    let unit = if degrees { "°" } else { "" };
    format_number(value, decimals, (1e-4..1e6).contains(&step)) + unit
}

/// Formats a number with three significant digits, a true minus sign, and no more zeros than it needs.
pub fn short(value: f64) -> String {
    let size = value.abs();
    let decimals = 2i32.saturating_sub(size.log10().floor() as i32).clamp(0, 5) as usize;
    format_number(value, decimals, (1e-3..1e5).contains(&size))
}

fn format_number(value: f64, decimals: usize, plain: bool) -> String {
    if value == 0.0 {
        "0".to_owned()
    } else if plain {
        fixed(value, decimals)
    } else {
        scientific(value)
    }
}

/// Formats a number with at most two significant digits, and a power of ten below 1 and from 10 on: 3, 6.6×10⁵, 10⁻⁷.
pub fn magnitude(value: f64) -> String {
    let text = scientific(value).replace(".0", "");
    match text.strip_suffix("×10⁰") {
        Some(digits) => digits.to_owned(),
        None => text.strip_prefix("1×").unwrap_or(&text).to_owned(),
    }
}

/// Formats very small and very large numbers as in textbooks: 1.2×10⁻⁷.
pub fn scientific(value: f64) -> String {
    let text = format!("{value:.1e}");
    let Some((mantissa, exponent)) = text.split_once('e') else {
        return text;
    };
    format!(
        "{}×10{}",
        with_minus(mantissa),
        raised(exponent.parse().unwrap_or(0))
    )
}
