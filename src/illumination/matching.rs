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
