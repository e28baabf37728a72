//! Formats of numbers for people.

/// Replaces a number's hyphen by a minus sign.
pub fn with_minus(number: &str) -> String {
    number.replace('-', "−")
}

/// Formats a number with a fixed number of decimals, with a minus sign, and without one before a 0.
pub fn fixed(value: f64, decimals: usize) -> String {
    if value.is_infinite() {
        return if value > 0.0 { "∞" } else { "−∞" }.into();
    }
    let text = format!("{value:.decimals$}");
    let is_zero = !text.contains(|c: char| ('1'..='9').contains(&c) || c == 'N');
    with_minus(if is_zero {
        text.trim_start_matches('-')
    } else {
        &text
    })
}

#[cfg(test)]
mod tests {
    use super::fixed;

    #[test]
    fn a_number_has_a_minus_sign_but_not_before_zero() {
        for (value, text) in [
            (-1.25, "−1.250"),
            (-0.0, "0.000"),
            (-0.0004, "0.000"),
            (0.0006, "0.001"),
            (f64::NEG_INFINITY, "−∞"),
            (f64::NAN, "NaN"),
        ] {
            assert_eq!(fixed(value, 3), text);
        }
    }
}
