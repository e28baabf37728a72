//! Formats of numbers for people.

/// Replaces a number's hyphen by a minus sign.
pub fn with_minus(number: &str) -> String {
    number.replace('-', "−")
}

/// Formats a number with a fixed number of decimals and a minus sign, which a 0 never has.
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
