//! What a field takes for a number: arithmetic such as `1/3`, `2*pi`, `1e-3`, `sqrt(2)` and `inf`.
//!
//! ```text
//!   sum     = product { (+ | −) product }
//!   product = signed { (* | /) signed }
//!   signed  = { + | − } power
//!   power   = value [ ^ signed ]
//!   value   = number | pi | inf | sqrt ( sum ) | ( sum )
//! ```

/// How deep parentheses, signs and powers may be nested.
const DEPTH: usize = 64;

/// The number that a text stands for; none where it is no arithmetic, or its value is not a number.
pub fn evaluate(text: &str) -> Option<f64> {
    let text = text.replace([' ', '\u{2009}', '\u{a0}', '°'], "");
    // The decimal comma of many languages.
    let text = text.replace(',', ".").to_lowercase();
    let mut rest = Rest(&text);
    let value = rest.sum(DEPTH)?;
    (rest.0.is_empty() && !value.is_nan()).then_some(value)
}

/// What is left of the text.
struct Rest<'a>(&'a str);

impl Rest<'_> {
    /// Takes one of several words or signs; returns its place among them.
    fn take(&mut self, words: &[&str]) -> Option<usize> {
        let place = words.iter().position(|word| self.0.starts_with(word))?;
        self.0 = &self.0[words[place].len()..];
        Some(place)
    }

    fn sum(&mut self, depth: usize) -> Option<f64> {
        let mut value = self.product(depth)?;
        while let Some(sign) = self.take(&["+", "-", "−"]) {
            let next = self.product(depth)?;
            value += if sign == 0 { next } else { -next };
        }
        Some(value)
    }

    fn product(&mut self, depth: usize) -> Option<f64> {
        let mut value = self.signed(depth)?;
        while let Some(sign) = self.take(&["*", "×", "·", "/", "÷"]) {
            let next = self.signed(depth)?;
            value = if sign < 3 { value * next } else { value / next };
        }
        Some(value)
    }

    fn signed(&mut self, depth: usize) -> Option<f64> {
        let depth = depth.checked_sub(1)?;
        match self.take(&["+", "-", "−"]) {
            Some(0) => self.signed(depth),
            Some(_) => self.signed(depth).map(|value| -value),
            None => self.power(depth),
        }
    }

    fn power(&mut self, depth: usize) -> Option<f64> {
        let base = self.value(depth)?;
        match self.take(&["^"]) {
            Some(_) => self.signed(depth).map(|exponent| base.powf(exponent)),
            None => Some(base),
        }
    }

    fn value(&mut self, depth: usize) -> Option<f64> {
        match self.take(&["infinity", "inf", "∞", "pi", "π", "sqrt(", "√(", "("]) {
            Some(0..=2) => Some(f64::INFINITY),
            Some(3..=4) => Some(std::f64::consts::PI),
            Some(found) => {
                let inside = self.sum(depth)?;
                self.take(&[")"])?;
                Some(if found < 7 { inside.sqrt() } else { inside })
            }
            None => self.number(),
        }
    }

    /// Digits with at most one point, and an exponent where digits follow the `e`.
    fn number(&mut self) -> Option<f64> {
        let digits =
            |text: &str| text.len() - text.trim_start_matches(|c: char| c.is_ascii_digit()).len();
        let mut length = digits(self.0);
        if self.0[length..].starts_with('.') {
            length += 1 + digits(&self.0[length + 1..]);
        }
        if let Some(exponent) = self.0[length..].strip_prefix('e') {
            let sign = usize::from(exponent.starts_with(['+', '-']));
            let count = digits(&exponent[sign..]);
            length += if count > 0 { 1 + sign + count } else { 0 };
        }
        let (number, rest) = self.0.split_at(length);
        self.0 = rest;
        number.parse().ok()
    }
}

#[cfg(test)]
mod tests {
    use super::evaluate;
    use proptest::prelude::*;
    use std::f64::consts::{PI, SQRT_2};

    #[test]
    fn arithmetic_is_a_number() {
        for (text, value) in [
            ("1/3", 1.0 / 3.0),
            ("2*pi", 2.0 * PI),
            ("2 · π", 2.0 * PI),
            ("1e-3", 1e-3),
            ("1E3", 1e3),
            ("inf", f64::INFINITY),
            ("-∞", f64::NEG_INFINITY),
            ("-0.5", -0.5),
            ("−3", -3.0),
            ("0,5", 0.5),
            (".5", 0.5),
            ("5.", 5.0),
            ("30°", 30.0),
            ("1 000", 1000.0),
            ("sqrt(2)", SQRT_2),
            ("(1+2)*3 − 4/2", 7.0),
            ("-2^2", -4.0),
            ("2^3^2", 512.0),
            ("2^-1", 0.5),
            ("8/4/2", 1.0),
            ("--1", 1.0),
        ] {
            assert_eq!(evaluate(text), Some(value), "{text}");
        }
    }

    #[test]
    fn what_is_no_number_is_refused() {
        for text in [
            "",
            " ",
            "x",
            "nan",
            "1/",
            "(1",
            "1)",
            "1 + ",
            "2 pi",
            "1..2",
            "e3",
            "1e",
            "sqrt 2",
            "sqrt(-1)",
            "0/0",
            "inf - inf",
            "1/3 m",
            "+",
            "()",
            ".",
            "½",
        ] {
            assert_eq!(evaluate(text), None, "{text}");
        }
        for text in [
            "(".repeat(1_000_000),
            "-".repeat(1_000_000),
            "2^".repeat(1_000_000),
        ] {
            assert_eq!(evaluate(&text), None);
        }
    }

    proptest! {
        #[test]
        fn any_text_is_a_number_or_refused(text in "[-+*/^(). 0-9a-zπ√∞−,]{0,40}|\\PC{0,40}") {
            prop_assert!(evaluate(&text).is_none_or(|value| !value.is_nan()));
        }

        #[test]
        fn numbers_are_themselves(value in proptest::num::f64::NORMAL | proptest::num::f64::ZERO) {
            prop_assert_eq!(evaluate(&format!("{value}")), Some(value));
            prop_assert_eq!(evaluate(&format!("{value:e}")), Some(value));
        }
    }
}
