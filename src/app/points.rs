//! Places in the picture that keep to the scene when the window changes its size.

use glam::DVec2;

/// Where the probe stands: from the picture's middle, in units of the picture's height, so that it keeps to the same
/// place of the scene when the window changes its size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProbePoint(pub DVec2);

impl Default for ProbePoint {
    fn default() -> Self {
        Self(DVec2::new(0.11, -0.13))
    }
}

impl ProbePoint {
    /// The pixel it stands on in a picture of `size` pixels, kept inside.
    pub fn pixel(self, size: [u32; 2]) -> [u32; 2] {
        let [width, height] = size.map(f64::from);
        let inside = |value: f64, side: u32| value.floor().clamp(0.0, f64::from(side.saturating_sub(1))) as u32;
        [inside(self.0.x * height + width * 0.5, size[0]), inside(self.0.y * height + height * 0.5, size[1])]
    }

    /// The probe at the centre of pixel `x`, `y` of a picture of `size` pixels.
    pub fn at(pixel: [u32; 2], size: [u32; 2]) -> Self {
        let [width, height] = size.map(|side| f64::from(side.max(1)));
        let [x, y] = pixel.map(|value| f64::from(value) + 0.5);
        Self(DVec2::new((x - width * 0.5) / height, (y - height * 0.5) / height))
    }

    /// The probe moved by whole pixels, not past the picture's edge.
    pub fn moved(self, by: [i32; 2], size: [u32; 2]) -> Self {
        let [x, y] = self.pixel(size);
        let step = |value: u32, by: i32, side: u32| value.saturating_add_signed(by).min(side.saturating_sub(1));
        Self::at([step(x, by[0], size[0]), step(y, by[1], size[1])], size)
    }
}

/// Where the profile is taken: both ends from the picture's middle in units of its height, like the probe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProfileLine(pub [DVec2; 2]);

impl Default for ProfileLine {
    fn default() -> Self {
        Self([DVec2::new(-0.4, 0.06), DVec2::new(0.4, 0.06)])
    }
}

impl ProfileLine {
    /// Both ends in a picture of `size` pixels, kept inside.
    pub fn pixels(self, size: [u32; 2]) -> [DVec2; 2] {
        let size = DVec2::from_array(size.map(f64::from));
        self.0.map(|end| (end * size.y + 0.5 * size).clamp(DVec2::ZERO, size))
    }

    /// Puts an end at a place of a picture of `size` pixels.
    pub fn put(&mut self, end: usize, pixel: DVec2, size: [u32; 2]) {
        let size = DVec2::from_array(size.map(|side| f64::from(side.max(1))));
        if let Some(end) = self.0.get_mut(end) {
            *end = (pixel.clamp(DVec2::ZERO, size) - 0.5 * size) / size.y;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_probe_returns_to_its_pixel() {
        for size in [[1, 1], [640, 480], [33, 1001]] {
            for pixel in [[0, 0], [size[0] - 1, size[1] - 1], [size[0] / 2, size[1] / 3]] {
                assert_eq!(ProbePoint::at(pixel, size).pixel(size), pixel);
            }
        }
    }

    #[test]
    fn the_probe_stays_in_the_picture() {
        let size = [10, 10];
        assert_eq!(ProbePoint::at([0, 9], size).moved([-1, 1], size).pixel(size), [0, 9]);
        assert_eq!(ProbePoint::at([0, 9], size).moved([3, -2], size).pixel(size), [3, 7]);
        assert_eq!(ProbePoint::default().pixel([0, 0]), [0, 0]);
    }
}
