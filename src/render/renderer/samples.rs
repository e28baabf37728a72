//! Pictures with several samples per pixel, and pictures too large to be drawn at once.

use super::display::{Linear, display};
use super::frame::Frame;
use super::pipeline::Renderer;
use crate::scene::{AmbientSource, Overflow, Scene};
use glam::DVec2;

/// The most pixels drawn at once; a larger picture is drawn in strips of at most this many. 3840 × 2160 is drawn at once.
pub(super) const MOST_AT_ONCE: u64 = 1 << 23;
/// The multiple of a strip's rows: the bands' 16, and the 6 after which the marks of overflow repeat.
const STRIDE: u32 = 48;

/// Returns the rows that are drawn at a time: all of them where the picture is small, or where a pixel depends on all others.
pub(super) fn rows_at_once(scene: &Scene) -> u32 {
    let [width, height] = scene.image.size;
    let alone = scene.display.overflow != Overflow::Scale
        && scene.ambient.source == AmbientSource::Constant;
    if !alone || u64::from(width) * u64::from(height) <= MOST_AT_ONCE {
        return height;
    }
    let rows = u32::try_from(MOST_AT_ONCE / u64::from(width)).unwrap_or(height);
    (rows / STRIDE * STRIDE).clamp(STRIDE, height.max(STRIDE))
}

impl Renderer {
    /// Draws with `samples` samples per pixel: the mean of their intensities, each clamped first where the display clamps.
    ///
    /// The memory of a large picture beside its stored pixels is bounded, unless [`Renderer::keep_linear`] requires all of
    /// it. `progress` gets the number of samples done and returns whether to continue; a stopped picture is unfinished.
    pub fn render_supersampled(
        &mut self,
        scene: &Scene,
        samples: u32,
        progress: &mut dyn FnMut(u32) -> bool,
    ) -> Frame {
        let samples = samples.max(1);
        let rows = if self.keeps_linear {
            scene.image.size[1]
        } else {
            rows_at_once(scene)
        };
        if samples == 1 && rows >= scene.image.size[1] {
            return self.render(scene).clone();
        }
        self.render_in_strips(scene, samples, rows, progress)
    }

    fn render_in_strips(
        &mut self,
        scene: &Scene,
        samples: u32,
        rows: u32,
        progress: &mut dyn FnMut(u32) -> bool,
    ) -> Frame {
        let [width, height] = scene.image.size;
        let mut pixels = Vec::with_capacity(width as usize * height as usize);
        let strips = height.div_ceil(rows);
        let mut strip = scene.clone();
        for (index, first) in (0..height).step_by(rows as usize).enumerate() {
            strip.image.size = [width, rows.min(height - first)];
            let mut done = |sample| progress((index as u32 * samples + sample) / strips);
            let finished = self.draw_samples(&strip, samples, [first, height], &mut done);
            pixels.extend_from_slice(&self.frame().pixels);
            if !finished {
                break;
            }
        }
        self.redraw();
        Frame {
            width,
            height,
            pixels,
        }
    }

    /// Draws the mean of samples into the rows from `first` on of a picture of `height` rows; returns false if `progress`
    /// has stopped it.
    fn draw_samples(
        &mut self,
        scene: &Scene,
        samples: u32,
        [first, height]: [u32; 2],
        progress: &mut dyn FnMut(u32) -> bool,
    ) -> bool {
        let size = [scene.image.size[0], height];
        let clamp = scene.display.overflow == Overflow::Clamp;
        let mut sum: Vec<Linear> = Vec::new();
        for sample in 0..samples {
            let offset = sample_offset(sample, samples) + DVec2::new(0.0, f64::from(first));
            self.draw(scene, size, offset, samples > 1);
            let go_on = progress(sample + 1);
            if samples == 1 || !go_on {
                return go_on;
            }
            let linear = &self.picture.output.linear;
            sum.resize(linear.len(), [0.0; 4]);
            for (total, pixel) in sum.iter_mut().zip(linear) {
                for (total, value) in total.iter_mut().zip(pixel) {
                    *total += if clamp { value.min(1.0) } else { *value };
                }
            }
        }
        let factor = 1.0 / samples as f32;
        sum.iter_mut().flatten().for_each(|value| *value *= factor);
        let level = self.level();
        let Frame { width, pixels, .. } = &mut self.picture.output.frame;
        display(level, &sum, *width as usize, &scene.display, pixels);
        self.picture.output.linear = sum;
        true
    }
}

/// Returns the position of sample `index` of `count` relative to the pixel's centre: a lattice of rank 1 with the golden section.
fn sample_offset(index: u32, count: u32) -> DVec2 {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let x = (f64::from(index) + 0.5) / f64::from(count);
    let y = (f64::from(index) * GOLDEN + 0.5).fract();
    DVec2::new(x - 0.5, y - 0.5)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{ReflectionModel, Rgb, presets};

    #[test]
    fn strips_are_the_picture_that_is_drawn_at_once() {
        for name in [
            "sphere",
            "teapot",
            "overflow",
            "glass-ball",
            "shadows",
            "depth-cueing",
            "silhouette",
        ] {
            let mut scene = presets::find(name).expect("a scene").scene();
            scene.image.size = [160, 150];
            for (samples, overflow) in [(1, Overflow::Clamp), (3, Overflow::Mark)] {
                scene.display.overflow = overflow;
                let whole = Renderer::default().render_supersampled(&scene, samples, &mut |_| true);
                let mut told = 0;
                let strips =
                    Renderer::default().render_in_strips(&scene, samples, STRIDE, &mut |done| {
                        told = done;
                        true
                    });
                assert_eq!((strips.width, strips.height, told), (160, 150, samples));
                // Positions in the picture are rounded to 1/256 pixel in single precision, which may fall to either side.
                let far = |(a, b): &(&[u8; 4], &[u8; 4])| {
                    a.iter().zip(*b).any(|(a, b)| a.abs_diff(*b) > 2)
                };
                let differ = strips.pixels.iter().zip(&whole.pixels).filter(far).count();
                assert!(
                    differ <= 12,
                    "{name}: {differ} of {} pixels",
                    whole.pixels.len()
                );
            }
        }
    }

    #[test]
    fn only_what_overflows_or_is_undefined_is_marked() {
        let mut scene = presets::find("sphere").expect("a scene").scene();
        scene.image.size = [120, 120];
        (scene.material.kd, scene.material.ks) = (Rgb::splat(0.3), Rgb::splat(0.2));
        let drawn = |samples: u32, formula: &str, overflow: Overflow| {
            let mut scene = scene.clone();
            scene.display.overflow = overflow;
            if !formula.is_empty() {
                scene.reflection.model = ReflectionModel::Formula;
                scene.reflection.formula = formula.to_owned();
            }
            Renderer::default().render_supersampled(&scene, samples, &mut |_| true)
        };
        let differ = |a: &Frame, b: &Frame| {
            let pairs = a.pixels.iter().zip(&b.pixels);
            pairs.filter(|(a, b)| a != b).count()
        };
        // 0 in the lower half, or undefined there.
        let (half, both) = ("0.1 * sqrt(N.y)", "0.1 * sqrt(max(N.y, 0))");
        for samples in [1, 2, 3, 4, 8, 16, 64] {
            let pair = |formula: &str| {
                let [clamped, marked] =
                    [Overflow::Clamp, Overflow::Mark].map(|policy| drawn(samples, formula, policy));
                differ(&clamped, &marked)
            };
            assert_eq!((pair(""), pair(both)), (0, 0), "{samples}");
            let frame = drawn(samples, half, Overflow::Clamp);
            let shown = frame
                .pixels
                .iter()
                .filter(|pixel| **pixel != frame.pixels[0])
                .count();
            let marked = pair(half);
            assert!(
                marked > shown / 4 && marked < shown * 3 / 5,
                "{samples}: {marked} of {shown}"
            );
        }
    }

    #[test]
    fn a_strip_is_bounded_and_a_picture_that_needs_all_of_itself_is_not_cut() {
        let mut scene = Scene::default();
        scene.image.size = [3840, 2160];
        assert_eq!(rows_at_once(&scene), 2160);
        for size in [[16_384, 8192], [8192, 16_384], [16_384, 513]] {
            scene.image.size = size;
            let rows = rows_at_once(&scene);
            assert!(
                rows.is_multiple_of(STRIDE) && u64::from(rows) * u64::from(size[0]) <= MOST_AT_ONCE,
                "{size:?}"
            );
        }
        scene.display.overflow = Overflow::Scale;
        assert_eq!(rows_at_once(&scene), scene.image.size[1]);
    }
}
