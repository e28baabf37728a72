//! Depth cueing: what is far fades into one colour, as if through fog.

use super::Rgb;
use super::choice::choices;

/// Depth cueing after Foley, van Dam, Feiner and Hughes 1990, section 16.1.4: `I' = s0·I + (1 − s0)·Idc`.
///
/// s0 depends on the depth z, the distance from the eye along the viewing direction: it is [`Self::front_scale`] up to
/// [`Self::front`], [`Self::back_scale`] from [`Self::back`] on, and linear between the two. It is the object that fades;
/// ground, backdrop and background keep their colours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DepthCueing {
    pub by: CuedBy,
    /// The depth at which the cue begins, world units.
    pub front: f64,
    /// The depth at which it is complete, world units, greater than `front`.
    pub back: f64,
    /// s0 at `front` and before, 0 to 1.
    pub front_scale: f64,
    /// s0 at `back` and beyond, 0 to 1.
    pub back_scale: f64,
    /// Idc, what intensities fade into.
    pub color: Rgb,
}

impl Default for DepthCueing {
    fn default() -> Self {
        Self { by: CuedBy::Off, front: 3.0, back: 5.0, front_scale: 1.0, back_scale: 0.0, color: Rgb::ZERO }
    }
}

impl DepthCueing {
    /// s0 at `depth`: what is left of the intensity there.
    pub fn scale_at(&self, depth: f64) -> f64 {
        // 1 at the front, 0 at the back.
        let nearness = ((self.back - depth) / (self.back - self.front)).clamp(0.0, 1.0);
        nearness * self.front_scale + (1.0 - nearness) * self.back_scale
    }
}

choices! {
    /// Where s0 is evaluated.
    pub enum CuedBy {
        /// There is no depth cueing.
        Off = "off", "off", "No fading";
        /// Where intensities live at vertices or faces, they fade there, before they are interpolated; in Phong shading s0
        /// itself is interpolated between the vertices. Exact shading has no vertices and takes each pixel's.
        Vertex = "vertex", "at vertices", "Intensities fade at the vertices; in Phong shading s0 is interpolated";
        /// From each pixel's own depth.
        Pixel = "pixel", "at pixels", "By each pixel's own depth";
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn s0_is_linear_between_its_two_depths_and_constant_beside_them() {
        let cueing = DepthCueing { front_scale: 0.9, back_scale: 0.1, ..DepthCueing::default() };
        for (depth, scale) in [(-1e30, 0.9), (3.0, 0.9), (3.5, 0.7), (4.0, 0.5), (5.0, 0.1), (1e30, 0.1)] {
            assert!((cueing.scale_at(depth) - scale).abs() < 1e-15, "{depth}");
        }
        let step = DepthCueing { back: 3.0 + f64::EPSILON * 2.0, ..DepthCueing::default() };
        assert_eq!([step.scale_at(3.0), step.scale_at(step.back)], [1.0, 0.0]);
    }
}
