//! Arithmetic in number fields, such as `1/3`, `2*pi`, `1e-3`, `sqrt(2)` and `inf`.

use crate::expression::arithmetic;

/// Evaluates the arithmetic in `text`. Returns `None` if it is not arithmetic or its value is not a number.
pub fn evaluate(text: &str) -> Option<f64> {
    let text = text.replace([' ', '\u{2009}', '\u{a0}', '°'], "");
    // The decimal comma of many languages.
    arithmetic(&text.replace(',', ".").to_lowercase())
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
