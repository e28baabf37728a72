//! Numbers, comments and filled templates in the syntax of C and GLSL.

use super::limit::Limit;
use crate::expression::in_name;
use crate::illumination::Scalar;
use crate::text::{Language, in_language};
use glam::DVec3;

/// Formats a single-precision number with a point or an exponent, the shortest that reads back the same: GLSL's
/// `float`.
pub(super) fn float(value: f64) -> String {
    // A negative zero becomes a positive one.
    format!("{:?}", f32::from_f64(value) + 0.0)
}

/// Formats C's `float`.
pub(super) fn c_float(value: f64) -> String {
    float(value) + "f"
}

/// Formats C's `double`.
pub(super) fn c_double(value: f64) -> String {
    format!("{:?}", value + 0.0)
}

/// Formats three components and a fourth as the elements of an array of C's `float`s.
pub(super) fn c_four(v: DVec3, fourth: f64) -> String {
    format!("{}, {}", c_three(v), c_float(fourth))
}

/// Formats three components as the elements of an array of C's `float`s.
pub(super) fn c_three(v: DVec3) -> String {
    v.to_array().map(c_float).join(", ")
}

/// Formats GLSL's `vec3`.
pub(super) fn vec3(v: DVec3) -> String {
    if v.x == v.y && v.y == v.z {
        return format!("vec3({})", float(v.x));
    }
    format!("vec3({})", v.to_array().map(float).join(", "))
}

/// Formats a number for a sentence, with four digits.
pub(super) fn said(value: f64) -> String {
    if value == 0.0 || (1e-3..1e6).contains(&value.abs()) {
        let text = format!("{value:.4}");
        return text.trim_end_matches('0').trim_end_matches('.').to_owned();
    }
    format!("{value:.3e}")
}

/// Returns a typed text as plain ASCII that continues no line: signs and Greek letters as they are typed without them, `?` for
/// anything else.
pub(super) fn ascii(text: &str) -> String {
    let plain = |c: char| match c {
        '·' | '⋅' | '•' => ".".to_owned(),
        '×' => "*".to_owned(),
        '÷' => "/".to_owned(),
        '−' => "-".to_owned(),
        '²' => "^2".to_owned(),
        '³' => "^3".to_owned(),
        '√' => "sqrt".to_owned(),
        '∞' => "inf".to_owned(),
        'π' => "pi".to_owned(),
        '≤' => "<=".to_owned(),
        '≥' => ">=".to_owned(),
        '\t' => " ".to_owned(),
        ' '..='~' if c != '\\' => c.to_string(),
        _ => in_name(c).unwrap_or_else(|| "?".to_owned()),
    };
    text.chars().map(plain).collect()
}

/// Fills each `$name$` of `template` with its value. A line that consists only of a name is removed if its value is
/// empty; the value's last line break is the line's own.
pub(super) fn filled(template: &str, values: &[(&str, &str)]) -> String {
    let mut text = String::new();
    for line in template.lines() {
        let alone = line
            .strip_prefix('$')
            .and_then(|rest| rest.strip_suffix('$'));
        if let Some((_, block)) = values.iter().find(|(name, _)| Some(*name) == alone) {
            text += block;
            if !block.is_empty() && !block.ends_with('\n') {
                text.push('\n');
            }
            continue;
        }
        // Every second piece is a name.
        for (index, piece) in line.split('$').enumerate() {
            let value = values
                .iter()
                .find(|(name, _)| index % 2 == 1 && *name == piece);
            text += value.map_or(piece, |(_, value)| value);
        }
        text.push('\n');
    }
    text
}

/// Returns the head of a text as a comment: a description, and the features that it does not express. Each line
/// begins with `prefix`.
pub(super) fn head(what: &[&str], limits: &[Limit], prefix: &str) -> String {
    let mut lines: Vec<String> = what.iter().map(|&line| line.to_owned()).collect();
    lines.push(String::new());
    if limits.is_empty() {
        lines.push("It expresses the scene completely.".to_owned());
    } else {
        lines.push("What it does not express:".to_owned());
        in_language(Language::English, || {
            lines.extend(limits.iter().map(|limit| format!("- {limit}")));
        });
    }
    let whole = |line: String| format!("{}\n", format!("{prefix}{line}").trim_end());
    lines
        .iter()
        .flat_map(|line| wrap(line, 100))
        .map(whole)
        .collect()
}

/// Wraps `text` to lines of at most `width` characters, the second and later ones indented; code, which is indented,
/// is unchanged.
fn wrap(text: &str, width: usize) -> Vec<String> {
    if text.starts_with(' ') {
        return vec![text.to_owned()];
    }
    let mut lines = vec![String::new()];
    for word in text.split(' ') {
        match lines.last_mut() {
            Some(line) if line.is_empty() => line.push_str(word),
            Some(line) if line.len() + 1 + word.len() <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(format!("  {word}")),
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_literals_in_either_language_and_short_in_sentences() {
        for (value, text) in [
            (1.0, "1.0"),
            (-0.0, "0.0"),
            (0.1, "0.1"),
            (1e-7, "1e-7"),
            (1e300, "3.4028235e38"),
        ] {
            assert_eq!(
                (float(value), c_float(value)),
                (text.to_owned(), format!("{text}f"))
            );
        }
        assert_eq!(
            (c_double(0.1), c_double(1e300)),
            ("0.1".to_owned(), "1e300".to_owned())
        );
        assert_eq!(
            [DVec3::ONE, DVec3::X].map(vec3),
            ["vec3(1.0)", "vec3(1.0, 0.0, 0.0)"]
        );
        let values = [0.0, 40.0, 0.25, 1.0 / 3.0, 1e-9, f64::INFINITY];
        assert_eq!(
            values.map(said),
            ["0", "40", "0.25", "0.3333", "1.000e-9", "inf"]
        );
    }

    #[test]
    fn a_template_has_its_values_and_loses_lines_that_are_empty() {
        let template = "a $x$ and $y$;\n$x$\n$none$\nb\n";
        assert_eq!(
            filled(template, &[("x", "1"), ("y", "2"), ("none", "")]),
            "a 1 and 2;\n1\nb\n"
        );
    }
}
