//! How wide a highlight is, and which n or roughness makes another model's as wide.

/// The angle φ at which cosⁿφ has fallen to one half, radians: half the width of the lobe at half its height. From
/// cos φ = 2^(−1/n); 0 for a mirror, a right angle for n = 0, where nothing falls.
pub fn half_width(n: f64) -> f64 {
    let exponent = std::f64::consts::LN_2 / n;
    // 1 − cos φ = 1 − e^(−x) and φ = 2·asin(√((1 − cos φ)/2)): no digits are lost for large n.
    2.0 * (0.5 * -(-exponent).exp_m1()).sqrt().asin()
}

/// The n of `(N·H)^n` whose highlight is as wide as that of `(R·V)^n` with `n`: in the plane of incidence H turns by half
/// the angle of R, so half its half-width is wanted. About 4n.
pub fn blinn_from_phong(n: f64) -> f64 {
    of_half_width(0.5 * half_width(n), 4.0 * n)
}

/// The inverse of [`blinn_from_phong`], as far as there is one: a half-width over 45° has no n for Phong's model and gives 0.
pub fn phong_from_blinn(n: f64) -> f64 {
    of_half_width(2.0 * half_width(n), 0.25 * n)
}

/// Beckmann's m whose highlight is as narrow as that of `(N·H)^n`: m = √(2/(n + 2)) (Walter et al. 2007, appendix).
pub fn roughness_from_exponent(n: f64) -> f64 {
    (2.0 / (n + 2.0)).sqrt()
}

/// n = −ln 2/ln cos φ, or `narrow` where the angle is too small for its cosine to be told from 1.
fn of_half_width(angle: f64, narrow: f64) -> f64 {
    if angle >= std::f64::consts::FRAC_PI_2 {
        return 0.0;
    }
    let half_sine = (0.5 * angle).sin();
    let n = -std::f64::consts::LN_2 / (-2.0 * half_sine * half_sine).ln_1p();
    if n.is_finite() { n } else { narrow }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn at_the_half_width_the_lobe_is_half_as_high() {
        for n in [0.1, 0.5, 1.0, 5.0, 15.0, 45.0, 1005.0, 1e6, 1e12] {
            let cosine = -2.0 * (0.5 * half_width(n)).sin().powi(2);
            assert!(((n * cosine.ln_1p()).exp() - 0.5).abs() < 1e-9, "n = {n}");
        }
        // The course's exponents, worked out apart: arccos 2^(−1/n).
        for (n, degrees) in [(5.0, 29.477_318), (15.0, 17.284_424), (45.0, 10.030_639), (1005.0, 2.127_734)] {
            assert!((half_width(n).to_degrees() - degrees).abs() < 1e-6, "n = {n}: {}", half_width(n).to_degrees());
        }
        assert_eq!(half_width(f64::INFINITY), 0.0);
        assert!((half_width(0.0) - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
    }

    #[test]
    fn the_two_models_match_each_way() {
        for n in [0.7, 1.0, 10.0, 1005.0, 1e8] {
            let there = blinn_from_phong(n);
            assert!((phong_from_blinn(there) / n - 1.0).abs() < 1e-9, "n = {n}");
            assert!((0.5 * half_width(n) - half_width(there)).abs() < 1e-12 * (1.0 + half_width(n)));
        }
        assert!((blinn_from_phong(1e4) / 4e4 - 1.0).abs() < 1e-3);
        assert_eq!(blinn_from_phong(f64::INFINITY), f64::INFINITY);
        assert_eq!(phong_from_blinn(0.5), 0.0);
    }
}
