//! Linear intensities in, stored values out.

use crate::illumination::{Lanes, Real};
use crate::scene::{Encoding, Overflow, Rgb};
use fearless_simd::prelude::*;
use rayon::prelude::*;

/// A picture before the display: linear red, green, blue, and 1 where the object is seen.
pub(super) type Linear = [f32; 4];

/// The transfer function of IEC 61966-2-1 for 0 ≤ v ≤ 1.
pub fn srgb(v: f64) -> f64 {
    if v <= 0.003_130_8 { 12.92 * v } else { 1.055 * v.powf(1.0 / 2.4) - 0.055 }
}

/// The stored value of a linear intensity: clamped, encoded, times 255, rounded.
pub(super) fn stored(v: f64, encoding: Encoding) -> u8 {
    let clamped = v.clamp(0.0, 1.0);
    let encoded = match encoding {
        Encoding::Raw => clamped,
        Encoding::Srgb => srgb(clamped),
    };
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 255")]
    {
        (encoded * 255.0 + 0.5) as u8
    }
}

/// The stored pixel of a linear colour.
pub(crate) fn stored_pixel(color: Rgb, encoding: Encoding) -> [u8; 4] {
    let [r, g, b] = color.to_array().map(|v| stored(v, encoding));
    [r, g, b, 255]
}

/// Intensities already within 0..1 to code values 0..255, not yet rounded.
#[inline(always)]
fn encode<S: Simd>(v: Lanes<S>, encoding: Encoding) -> Lanes<S> {
    if encoding == Encoding::Raw {
        return v * 255.0;
    }
    let low = v * (12.92 * 255.0);
    let root = (v.max(v.constant(1e-6)).log2() * (1.0 / 2.4)).exp2();
    let high = root.mul_add(v.constant(1.055 * 255.0), v.constant(-0.055 * 255.0));
    Lanes::select(v.greater_than(v.constant(0.003_130_8)), high, low)
}

/// Intensities to code values: clamped, encoded, rounded.
#[inline(always)]
fn code<S: Simd>(v: Lanes<S>, encoding: Encoding) -> S::i32s {
    let clamped = v.max(v.constant(0.0)).min(v.constant(1.0));
    S::i32s::truncate_from(encode(clamped, encoding).0 + 0.5)
}

/// The code value of an intensity that is stored as it is, as [`pack`] has it.
#[inline(always)]
pub(super) fn raw(v: f32) -> u8 {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 255")]
    {
        (v.clamp(0.0, 1.0) * 255.0 + 0.5) as u8
    }
}

/// Packs a vector of colours into pixels and returns which lanes overflow. Lanes outside `covered` get `background`.
#[inline(always)]
pub(super) fn pack<S: Simd>(
    simd: S,
    color: [Lanes<S>; 3],
    covered: S::mask32s,
    background: S::i32s,
    encoding: Encoding,
) -> (S::u8s, u64) {
    let one = Lanes::splat(simd, 1.0);
    let peak = color[0].max(color[1]).max(color[2]);
    let over = (peak.greater_than(one) & covered).to_bitmask();
    let [r, g, b] = color;
    let (r, g, b) = (code(r, encoding), code(g, encoding), code(b, encoding));
    let pixel = r | (g << 8) | (b << 16) | S::i32s::simd_from(simd, i32::from_le_bytes([0, 0, 0, 255]));
    (covered.select(pixel, background).bitcast(), over)
}

/// Turns a linear picture of `width` columns into stored pixels by the policies that need to see all of it. Returns what
/// its intensities were divided by.
pub(super) fn display(
    linear: &[Linear],
    width: usize,
    overflow: Overflow,
    encoding: Encoding,
    out: &mut [[u8; 4]],
) -> f64 {
    let peak = || linear.par_iter().flat_map_iter(|p| &p[..3]).copied().reduce(|| 1.0_f32, f32::max);
    let divisor = if overflow == Overflow::Scale { f64::from(peak()) } else { 1.0 };
    let factor = 1.0 / divisor;
    let lines = linear.par_chunks_exact(width).zip(out.par_chunks_exact_mut(width));
    lines.enumerate().for_each(|(row, (line, pixels))| {
        for (column, (color, pixel)) in line.iter().zip(pixels).enumerate() {
            let over = color[..3].iter().any(|&v| v > 1.0);
            *pixel = if overflow == Overflow::Mark && over {
                hatching(column, row)
            } else {
                let [r, g, b] = [0, 1, 2].map(|k| stored(f64::from(color[k]) * factor, encoding));
                [r, g, b, 255]
            };
        }
    });
    divisor
}

/// Black and white diagonal stripes, three pixels wide, which no shading looks like.
fn hatching(x: usize, y: usize) -> [u8; 4] {
    if ((x + y) / 3).is_multiple_of(2) { [0, 0, 0, 255] } else { [255, 255, 255, 255] }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_code_value_survives_its_own_intensity() {
        for code in 0..=255_u8 {
            assert_eq!(stored(f64::from(code) / 255.0, Encoding::Raw), code);
        }
    }

    #[test]
    fn srgb_passes_through_its_published_points() {
        assert!((srgb(0.003_130_8) - 0.040_45).abs() < 1e-5);
        assert!((srgb(1.0) - 1.0).abs() < 1e-12);
        assert!((srgb(0.214_041_14) - 0.5).abs() < 1e-6);
    }
}
