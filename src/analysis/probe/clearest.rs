//! The pixel to explain where none is asked for.

use super::{Probe, probe};
use crate::render::Renderer;
use crate::scene::Scene;
use std::ops::RangeInclusive;

/// The pixel is sought on a grid of this many columns and rows.
const SEARCH_GRID: u32 = 64;

/// Degrees between the vectors of a drawing whose letters do not crowd.
const APART: RangeInclusive<f64> = 15.0..=65.0;

/// The clearest pixel to explain, of those of a coarse grid the nearest to the picture's middle: one whose vectors are well
/// apart; or else a lit one; or else one of the object.
pub fn clearest_pixel(renderer: &mut Renderer, scene: &Scene) -> Probe {
    let [width, height] = scene.image.size;
    let middle = [width / 2, height / 2];
    let middles = |side: u32| (0..SEARCH_GRID).map(move |i| (2 * i + 1) * side / (2 * SEARCH_GRID));
    let mut grid: Vec<[u32; 2]> = middles(height).flat_map(|y| middles(width).map(move |x| [x, y])).collect();
    grid.dedup();
    let distance = |[x, y]: &[u32; 2]| {
        let (dx, dy) = (u64::from(x.abs_diff(middle[0])), u64::from(y.abs_diff(middle[1])));
        dx * dx + dy * dy
    };
    grid.sort_by_key(distance);
    let mut best = (Clarity::Background, Probe { pixel: middle, hit: None, ambient_fit: None });
    for [x, y] in grid {
        let probed = probe(renderer, scene, x, y);
        let clarity = Clarity::of(&probed);
        if clarity > best.0 {
            best = (clarity, probed);
        }
        if best.0 == Clarity::Apart {
            break;
        }
    }
    best.1
}

/// How much a drawing at a pixel explains.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Clarity {
    Background,
    /// No light reaches the point.
    Dark,
    Lit,
    /// Lit, near the highlight but not in it: N, L, R and V point in directions of their own.
    Apart,
}

impl Clarity {
    fn of(probed: &Probe) -> Self {
        let Some(hit) = &probed.hit else { return Self::Background };
        let Some(light) = hit.lights.iter().find(|light| light.n_dot_l > 0.0) else { return Self::Dark };
        let angles = [light.theta, light.phi, hit.normal.angle_between(hit.view)];
        if angles.iter().all(|angle| APART.contains(&angle.to_degrees())) { Self::Apart } else { Self::Lit }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::presets;

    #[test]
    fn without_a_pixel_one_is_found_whose_vectors_are_apart() {
        for name in ["sphere", "teapot", "torus", "three-lights"] {
            let scene = presets::find(name).expect("a scene").scene();
            let probed = clearest_pixel(&mut Renderer::default(), &scene);
            assert_eq!(Clarity::of(&probed), Clarity::Apart, "{name}");
        }
        let mut dark = Scene { lights: vec![], ..Scene::default() };
        dark.image.size = [3, 2];
        assert_eq!(Clarity::of(&clearest_pixel(&mut Renderer::default(), &dark)), Clarity::Dark);
        dark.camera.target = dark.camera.eye * 2.0;
        let missed = clearest_pixel(&mut Renderer::default(), &dark);
        assert_eq!((missed.pixel, missed.hit.is_none()), ([1, 1], true));
    }
}
