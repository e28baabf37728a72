//! Numbers and vectors as C and GLSL write them.

use crate::illumination::Scalar;
use glam::DVec3;

/// A single-precision number with a point or an exponent, the shortest that reads back the same: GLSL's `float`.
pub(super) fn float(value: f64) -> String {
    // A negative zero becomes a positive one.
    format!("{:?}", f32::from_f64(value) + 0.0)
}

/// C's `float`.
pub(super) fn c_float(value: f64) -> String {
    float(value) + "f"
}

/// C's `double`.
pub(super) fn c_double(value: f64) -> String {
    format!("{:?}", f64::from_f64(value) + 0.0)
}

/// Three components and a fourth as the elements of an array of C's `float`s.
pub(super) fn c_four(v: DVec3, fourth: f64) -> String {
    format!("{}, {}", c_three(v), c_float(fourth))
}

/// Three components as the elements of an array of C's `float`s.
pub(super) fn c_three(v: DVec3) -> String {
    v.to_array().map(c_float).join(", ")
}

/// GLSL's `vec3`.
pub(super) fn vec3(v: DVec3) -> String {
    if v.x == v.y && v.y == v.z {
        return format!("vec3({})", float(v.x));
    }
    format!("vec3({})", v.to_array().map(float).join(", "))
}

/// A number in a sentence: four digits.
pub(super) fn said(value: f64) -> String {
    if value == 0.0 || (1e-3..1e6).contains(&value.abs()) {
        let text = format!("{value:.4}");
        return text.trim_end_matches('0').trim_end_matches('.').to_owned();
    }
    format!("{value:.3e}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_literals_in_either_language() {
        for (value, text) in [(1.0, "1.0"), (-0.0, "0.0"), (0.1, "0.1"), (1e-7, "1e-7"), (1e300, "3.4028235e38")] {
            assert_eq!(float(value), text);
            assert_eq!(c_float(value), format!("{text}f"));
        }
        assert_eq!((c_double(0.1), c_double(1e300)), ("0.1".to_owned(), "1e300".to_owned()));
        assert_eq!(vec3(DVec3::ONE), "vec3(1.0)");
        assert_eq!(vec3(DVec3::X), "vec3(1.0, 0.0, 0.0)");
    }

    #[test]
    fn numbers_in_sentences_are_short() {
        assert_eq!([0.0, 40.0, 0.25, 1.0 / 3.0, 1e-9].map(said), ["0", "40", "0.25", "0.3333", "1.000e-9"]);
        assert_eq!(said(f64::INFINITY), "inf");
    }
}
