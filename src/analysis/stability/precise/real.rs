//! Double-double numbers as [`Real`] numbers.

use super::{Precise, precise};
use crate::illumination::Real;

/// The largest tangent whose square does not overflow; the angle of a larger one differs from a right angle by less than 10⁻¹⁰⁰.
const STEEPEST: f64 = 1e100;

/// Returns the other leg of a right triangle with hypotenuse 1: `√((1 − x)(1 + x))`, which loses no digits as x → 1.
fn leg(x: Precise) -> Precise {
    let one = precise(1.0);
    ((one - x) * (one + x)).max(precise(0.0)).sqrt()
}

impl Real for Precise {
    type Scalar = f64;
    type Mask = bool;

    fn constant(self, value: f64) -> Self {
        precise(value)
    }

    fn max(self, other: Self) -> Self {
        if other > self { other } else { self }
    }

    fn min(self, other: Self) -> Self {
        Self::min(self, other)
    }

    fn abs(self) -> Self {
        Self::abs(self)
    }

    fn floor(self) -> Self {
        Self::floor(self)
    }

    fn sqrt(self) -> Self {
        Self::sqrt(self)
    }

    fn inverse_sqrt(self) -> Self {
        precise(1.0) / Real::max(self, precise(f64::MIN_POSITIVE)).sqrt()
    }

    fn exp2(self) -> Self {
        (self * Self::LN_2).exp()
    }

    fn log2(self) -> Self {
        self.ln() / Self::LN_2
    }

    fn log2_one_minus(t: Self) -> Self {
        (precise(1.0) - t).log2()
    }

    fn sin_of_degrees(self) -> Self {
        // The quarter turn nearest to it is taken off first, in degrees, where that is exact.
        let quarters = (self.hi / 90.0).round();
        let (sine, cosine) = (self - precise(90.0) * quarters).to_radians().sin_cos();
        match quarters.rem_euclid(4.0) as u8 {
            0 => sine,
            1 => cosine,
            2 => -sine,
            _ => -cosine,
        }
    }

    fn cos_of_degrees(self) -> Self {
        (self + precise(90.0)).sin_of_degrees()
    }

    fn asin_in_degrees(self) -> Self {
        Self::angle(self, leg(self)).to_degrees()
    }

    fn acos_in_degrees(self) -> Self {
        Self::angle(leg(self), self).to_degrees()
    }

    fn atan_in_degrees(self) -> Self {
        let tangent = Real::max(self, precise(-STEEPEST)).min(precise(STEEPEST));
        let cosine = precise(1.0) / (precise(1.0) + tangent * tangent).sqrt();
        Self::angle(tangent * cosine, cosine).to_degrees()
    }

    fn greater_than(self, other: Self) -> bool {
        self > other
    }

    fn select(mask: bool, if_true: Self, if_false: Self) -> Self {
        if mask { if_true } else { if_false }
    }

    fn any(mask: bool) -> bool {
        mask
    }

    fn mask_of_bits(self, bits: u64) -> bool {
        bits & 1 == 1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the maximum error of a function against the truth over thousands of numbers between −1 and 1, dense at both ends
    /// and at 0; relative to the truth, or absolute where that is below 10⁻¹⁰.
    fn worst(found: impl Fn(Precise) -> Precise, truth: impl Fn(Precise) -> Precise) -> f64 {
        let third = precise(1.0) / precise(3.0);
        let error = |x: Precise| {
            let (found, truth) = (found(x), truth(x));
            let size = f64::from(truth).abs().max(1e-10);
            f64::from(found - truth).abs() / size
        };
        let small = (0..800_i32).map(|k| third * 2.0 * 0.96_f64.powi(k));
        let all = small.flat_map(|x| [x, -x, precise(1.0) - x, x - precise(1.0)]);
        all.map(error).fold(0.0, f64::max)
    }

    #[test]
    fn angles_have_thirty_digits() {
        assert!(worst(|x| x.asin_in_degrees().sin_of_degrees(), |x| x) < 1e-28);
        assert!(worst(|x| x.acos_in_degrees().cos_of_degrees(), |x| x) < 1e-20);
        let right = precise(90.0);
        assert!(worst(|x| x.asin_in_degrees() + x.acos_in_degrees(), |_| right) < 1e-29);
        let tangent = |x: Precise| x.sin_of_degrees() / x.cos_of_degrees();
        assert!(worst(|x| tangent(x.atan_in_degrees()), |x| x) < 1e-28);
        // Angles near 0 keep their relative accuracy: acos x = 2 asin √((1 − x)/2).
        let half = |x: Precise| {
            let sine = ((precise(1.0) - x.abs()) * 0.5).sqrt();
            sine.asin_in_degrees() * 2.0
        };
        assert!(worst(|x| x.abs().acos_in_degrees(), half) < 1e-28);
        let exact =
            |found: Precise, degrees: f64| f64::from(found - precise(degrees)).abs() < 1e-29;
        assert!(exact(precise(0.5).asin_in_degrees(), 30.0));
        assert!(exact(precise(0.5).acos_in_degrees(), 60.0));
        assert!(exact(precise(1.0).atan_in_degrees(), 45.0));
        assert!(exact(precise(-1.0).acos_in_degrees(), 180.0));
        assert_eq!(precise(1.0).acos_in_degrees(), precise(0.0));
        assert!(exact(precise(1e300).atan_in_degrees(), 90.0));
        for (degrees, sine) in [(30.0, 0.5), (150.0, 0.5), (210.0, -0.5), (-750.0, -0.5)] {
            assert!(exact(precise(degrees).sin_of_degrees(), sine), "{degrees}");
            assert!(exact(precise(degrees - 90.0).cos_of_degrees(), sine));
        }
    }

    #[test]
    fn powers_of_two_and_logarithms_have_thirty_digits() {
        let whole = |x: Precise| x * 100.0;
        assert!(worst(|x| whole(x).exp2() * (-whole(x)).exp2(), |_| precise(1.0)) < 1e-29);
        let above_1 = |x: Precise| whole(x) + precise(200.0);
        assert!(worst(|x| above_1(x).exp2().log2(), above_1) < 1e-30);
        let of = |x: Precise| x.exp2();
        assert_eq!(of(precise(1024.5)), precise(f64::INFINITY));
        assert_eq!(of(precise(-2000.0)), precise(0.0));
        let eight = f64::from(of(precise(3.0)) - precise(8.0)).abs();
        assert!(eight < 1e-29, "{eight}");
    }

    #[test]
    fn whole_numbers_comparisons_and_what_overflows_are_those_of_f64() {
        let tiny = precise(1.0) + precise(1e-25);
        assert_eq!(tiny.floor(), precise(1.0));
        assert_eq!((precise(2.0) - precise(1e-25)).floor(), precise(1.0));
        assert_eq!((-tiny).floor(), precise(-2.0));
        assert_eq!(precise(-0.5).floor(), precise(-1.0));
        assert!(tiny.greater_than(precise(1.0)) && !precise(1.0).greater_than(tiny));
        assert_eq!(Real::max(tiny, precise(1.0)), tiny);
        let infinite = precise(1e200) * precise(1e200);
        assert_eq!(infinite, precise(f64::INFINITY));
        assert_eq!(-infinite + precise(1.0), precise(f64::NEG_INFINITY));
        assert_eq!(precise(1.0) / infinite, precise(0.0));
        assert!(f64::from(infinite - infinite).is_nan());
        assert_eq!(precise(0.0).sqrt(), precise(0.0));
        assert_eq!(precise(0.0) * precise(0.0).inverse_sqrt(), precise(0.0));
    }
}
