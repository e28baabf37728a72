//! The display: composes the linear picture and converts its intensities to stored values.

use super::parts::bouncing;
use crate::illumination::{BRIGHTEST, LANES, Lanes, Real};
use crate::scene::{Display, Encoding, Overflow, Rgb, Scene};
use fearless_simd::{Level, dispatch, f32x4, i32x4, i32x16, mask32x16, prelude::*, u8x64};
use glam::Vec3;
use rayon::prelude::*;

/// A pixel before the display: linear red, green, blue, and 1 where the object is visible, or [`UNDEFINED`].
pub type Linear = [f32; 4];

/// The fourth number of a visible pixel where the scene's own law is undefined: so large that the mean over samples, too, is above 1
/// if it is undefined at any of them.
pub const UNDEFINED: f32 = 65_536.0;

/// Returns whether the display marks a pixel: it overflows, or it has no value.
pub fn is_marked(pixel: Linear) -> bool {
    // Not by `max`, whose care for NaN costs the web page three comparisons a number.
    pixel.iter().any(|&value| value > 1.0)
}

/// Composes the equation's value, the view beyond and the light that other surfaces scatter; returns the number of
/// pixels that are marked. Where the equation's part has already faded at vertices or faces, `faded` has s0 at each pixel, for
/// the parts added here.
pub fn compose(
    scene: &Scene,
    (kt, each_kt): (f64, &[f32]),
    [seen, bounced]: [&[Vec3]; 2],
    faded: Option<&[f32]>,
    linear: &mut [Linear],
) -> u64 {
    let width = scene.image.size[0] as usize;
    let bouncing = bouncing(scene);
    let veil = scene.depth_cueing.color.as_vec3();
    let whole = linear.par_chunks_mut(width.max(1)).enumerate();
    let overflowing = whole.map(|(row, line)| {
        let mut over = 0;
        for (x, pixel) in line.iter_mut().enumerate() {
            let index = row * width + x;
            let covered = pixel[3] > 0.0;
            let beyond = seen.get(index).copied().unwrap_or(Vec3::ZERO);
            let mut color = if covered {
                Vec3::from_slice(&pixel[..3])
            } else {
                beyond
            };
            let s0 = faded
                .filter(|_| covered)
                .and_then(|faded| faded.get(index))
                .copied()
                .unwrap_or(1.0);
            if let Some(scattered) = bounced.get(index).filter(|_| bouncing.contains(&x)) {
                color += s0 * *scattered;
            }
            let kt = each_kt.get(index).copied().unwrap_or(kt as f32);
            if covered && kt > 0.0 {
                color = color * (1.0 - kt) + (s0 * beyond + (1.0 - s0) * veil) * kt;
            }
            color = color.min(Vec3::splat(BRIGHTEST as f32));
            pixel[..3].copy_from_slice(&color.to_array());
            over += u64::from(is_marked(*pixel));
        }
        over
    });
    overflowing.sum()
}

/// Returns the transfer function of IEC 61966-2-1 for 0 ≤ v ≤ 1.
pub fn srgb(v: f64) -> f64 {
    if v <= 0.003_130_8 {
        12.92 * v
    } else {
        1.055 * v.powf(1.0 / 2.4) - 0.055
    }
}

/// Returns the stored value of a linear intensity: clamped, encoded, times 255, rounded.
pub fn stored(v: f64, encoding: Encoding) -> u8 {
    let clamped = v.clamp(0.0, 1.0);
    let encoded = match encoding {
        Encoding::Raw => clamped,
        Encoding::Srgb => srgb(clamped),
    };
    (encoded * 255.0 + 0.5) as u8
}

pub(crate) fn stored_pixel(color: Rgb, encoding: Encoding) -> [u8; 4] {
    let [r, g, b] = color.to_array().map(|v| stored(v, encoding));
    [r, g, b, 255]
}

/// Converts intensities already within 0..1 to code values 0..255 and a half, to be truncated.
#[inline(always)]
fn encode<S: Simd>(v: Lanes<S>, encoding: Encoding) -> Lanes<S> {
    let half = v.constant(0.5);
    if encoding == Encoding::Raw {
        return v.mul_add(v.constant(255.0), half);
    }
    let low = v.mul_add(v.constant(12.92 * 255.0), half);
    let root = (v.max(v.constant(1e-6)).log2() * (1.0 / 2.4)).exp2();
    let high = root.mul_add(v.constant(1.055 * 255.0), v.constant(0.5 - 0.055 * 255.0));
    Lanes::select(v.greater_than(v.constant(0.003_130_8)), high, low)
}

/// Converts intensities to code values: clamped, encoded, rounded.
#[inline(always)]
fn code<S: Simd>(v: Lanes<S>, encoding: Encoding) -> i32x16<S> {
    let clamped = v.max(v.constant(0.0)).min(v.constant(1.0));
    i32x16::truncate_from(encode(clamped, encoding).0)
}

/// Returns the pixel of a colour that is stored without encoding: bit for bit the result of [`pack`].
#[inline(always)]
pub fn raw<S: Simd>(simd: S, [r, g, b]: [f32; 3]) -> [u8; 4] {
    let color = f32x4::simd_from(simd, [r, g, b, 1.0]).max(0.0).min(1.0);
    let codes: [i32; 4] = i32x4::truncate_from(color.mul_add(255.0, 0.5)).into();
    codes.map(
        #[inline(always)]
        |code| code as u8,
    )
}

/// Packs a vector of colours into pixels and returns which lanes overflow. Lanes outside `covered` get `background`.
#[inline(always)]
pub fn pack<S: Simd>(
    simd: S,
    color: [Lanes<S>; 3],
    covered: mask32x16<S>,
    background: i32x16<S>,
    encoding: Encoding,
) -> (u8x64<S>, u64) {
    let one = Lanes::splat(simd, 1.0);
    let peak = color[0].max(color[1]).max(color[2]);
    let over = (peak.greater_than(one) & covered).to_bitmask();
    let [r, g, b] = color;
    let (r, g, b) = (code(r, encoding), code(g, encoding), code(b, encoding));
    let pixel =
        r | (g << 8) | (b << 16) | i32x16::simd_from(simd, i32::from_le_bytes([0, 0, 0, 255]));
    (covered.select(pixel, background).bitcast(), over)
}

/// Stores a linear picture of `width` columns by the policies that need all of it; returns the divisor of its intensities.
pub fn display(
    level: Level,
    linear: &[Linear],
    width: usize,
    policy: &Display,
    out: &mut [[u8; 4]],
) -> f64 {
    // The fourth component is 1 at most.
    let peak = |line: &[Linear]| dispatch!(level, simd => max_of(simd, line.as_flattened()));
    let divisor = match policy.overflow {
        Overflow::Scale => linear
            .par_chunks_exact(width)
            .map(peak)
            .reduce(|| 1.0, f32::max),
        Overflow::Clamp | Overflow::Mark => 1.0,
    };
    let factor = 1.0 / divisor;
    let lines = linear
        .par_chunks_exact(width)
        .zip(out.par_chunks_exact_mut(width));
    lines.enumerate().for_each(|(row, (line, pixels))| {
        dispatch!(level, simd => store_line(simd, (row, line), factor, policy, pixels));
    });
    f64::from(divisor)
}

/// Returns the largest of some numbers and 1.
#[inline(always)]
fn max_of<S: Simd>(simd: S, values: &[f32]) -> f32 {
    let vectors = values.chunks_exact(LANES);
    let rest = vectors.remainder().iter().copied().fold(1.0, f32::max);
    let mut most = Lanes::splat(simd, rest);
    for vector in vectors {
        most = most.max(Lanes::load(simd, vector));
    }
    most.0.as_slice().iter().copied().fold(rest, f32::max)
}

#[inline(always)]
fn store_line<S: Simd>(
    simd: S,
    (row, line): (usize, &[Linear]),
    factor: f32,
    policy: &Display,
    pixels: &mut [[u8; 4]],
) {
    let (all, nothing) = (mask32x16::splat(simd, true), i32x16::simd_from(simd, 0));
    let mut planes = [[0.0; LANES]; 4];
    for (first, (colors, pixels)) in (0..)
        .step_by(LANES)
        .zip(line.chunks(LANES).zip(pixels.chunks_mut(LANES)))
    {
        separate(simd, colors, &mut planes);
        let [r, g, b, seen] = &planes;
        let color = [
            Lanes::load(simd, r) * factor,
            Lanes::load(simd, g) * factor,
            Lanes::load(simd, b) * factor,
        ];
        let (packed, over) = pack(simd, color, all, nothing, policy.encoding);
        let bytes = pixels.as_flattened_mut();
        bytes.copy_from_slice(&packed.as_slice()[..bytes.len()]);
        if policy.overflow == Overflow::Mark {
            let seen = Lanes::load(simd, seen);
            let undefined = seen.0.simd_gt(seen.constant(1.0).0).to_bitmask();
            let mut marked = (over | undefined) & (u64::MAX >> (64 - pixels.len()));
            while marked != 0 {
                let lane = marked.trailing_zeros() as usize;
                marked &= marked - 1;
                pixels[lane] = hatching(first + lane, row);
            }
        }
    }
}

#[inline(always)]
fn separate<S: Simd>(simd: S, colors: &[Linear], planes: &mut [[f32; LANES]; 4]) {
    let quads = colors.chunks_exact(4);
    let (rest, whole) = (quads.remainder(), colors.len() / 4 * 4);
    for (quad, start) in quads.zip((0..).step_by(4)) {
        let vectors = f32x4::load_four_interleaved(simd, quad.as_flattened());
        for (plane, vector) in planes.iter_mut().zip(vectors) {
            vector.store_slice(&mut plane[start..start + 4]);
        }
    }
    for (color, index) in rest.iter().zip(whole..) {
        for (plane, value) in planes.iter_mut().zip(color) {
            plane[index] = *value;
        }
    }
}

/// Returns the pixel of black and white diagonal stripes, three pixels wide, which no shading looks like.
fn hatching(x: usize, y: usize) -> [u8; 4] {
    if ((x + y) / 3).is_multiple_of(2) {
        [0, 0, 0, 255]
    } else {
        [255, 255, 255, 255]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lanes_store_what_single_numbers_do() {
        assert!((0..=255_u8).all(|code| stored(f64::from(code) / 255.0, Encoding::Raw) == code));
        // A width that fills no vector, and an intensity on either side of each step.
        let linear: Vec<Linear> = (0..37 * 29)
            .map(|k| [0, 1, 2].map(|c| ((k * 7 + c * 311) % 1300) as f32 / 1150.0))
            .map(|[r, g, b]| [r, g, b, 1.0])
            .collect();
        for level in [Level::new(), Level::baseline()] {
            for overflow in [Overflow::Clamp, Overflow::Scale, Overflow::Mark] {
                for encoding in [Encoding::Raw, Encoding::Srgb] {
                    let mut out = vec![[0; 4]; linear.len()];
                    let divisor = display(
                        level,
                        &linear,
                        37,
                        &Display { overflow, encoding },
                        &mut out,
                    );
                    assert_eq!(divisor > 1.1, overflow == Overflow::Scale, "{divisor}");
                    for (index, (color, pixel)) in linear.iter().zip(&out).enumerate() {
                        if overflow == Overflow::Mark && color.iter().any(|&v| v > 1.0) {
                            assert_eq!(*pixel, hatching(index % 37, index / 37));
                            continue;
                        }
                        for channel in 0..3 {
                            let expected = stored(f64::from(color[channel]) / divisor, encoding);
                            assert!(
                                pixel[channel].abs_diff(expected) <= 1,
                                "{color:?}: {pixel:?}, {expected}"
                            );
                        }
                        assert_eq!(pixel[3], 255);
                    }
                }
            }
        }
    }
}
