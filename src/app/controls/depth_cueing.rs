//! Depth cueing: where it begins and ends, and what the object fades into.

use crate::app::row::{View, parameter, parameter_with, parameters};
use crate::app::state::AppState;
use crate::scene::parameter::Slider;
use crate::scene::surroundings::{BACK, BACK_SCALE, CUE_COLOR, CUED_BY, FRONT, FRONT_SCALE};
use crate::scene::{CuedBy, DepthCueing, GREATEST_LENGTH, ShadingMode};
use eframe::egui::{RichText, Ui};

pub fn depth_cueing_ui(ui: &mut Ui, state: &mut AppState) {
    let AppState { shown, lit, .. } = state;
    let scene = &mut shown.scene;
    parameter(ui, lit, scene, &CUED_BY);
    if scene.depth_cueing.by == CuedBy::Off {
        return;
    }
    if scene.depth_cueing.by == CuedBy::Vertex && scene.shading.mode == ShadingMode::Exact {
        ui.label(RichText::new("Exact shading has no vertices: each pixel's depth").weak());
    }
    let (before, reach) = (scene.depth_cueing.front, 2.0 * scene.camera.distance());
    for row in [&FRONT, &BACK] {
        let view = View { slider: Some(Slider::linear(0.0, reach)), ..View::default() };
        parameter_with(ui, lit, scene, 0, row, &view);
    }
    let front_moved = scene.depth_cueing.front.to_bits() != before.to_bits();
    part(&mut scene.depth_cueing, front_moved, reach);
    parameters(ui, lit, scene, &[&FRONT_SCALE, &BACK_SCALE, &CUE_COLOR]);
}

/// Keeps the front before the back: the one that moved pushes the other.
fn part(cueing: &mut DepthCueing, front_moved: bool, reach: f64) {
    let gap = (0.005 * reach).max(1e-9 * cueing.front.max(cueing.back));
    if cueing.front < cueing.back {
        return;
    }
    if front_moved {
        cueing.front = cueing.front.min(GREATEST_LENGTH - gap);
        cueing.back = cueing.front + gap;
    } else {
        cueing.back = cueing.back.max(gap);
        cueing.front = (cueing.back - gap).max(0.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;

    #[test]
    fn the_front_stays_before_the_back() {
        for (front, back) in [(7.0, 5.0), (0.0, 0.0), (1e30, 3.0), (3.0, 0.0), (1e-30, 1e-30)] {
            for front_moved in [true, false] {
                for reach in [8.0, 1e-20, 1e20] {
                    let mut scene = Scene::default();
                    (scene.depth_cueing.front, scene.depth_cueing.back) = (front, back);
                    part(&mut scene.depth_cueing, front_moved, reach);
                    assert_eq!(scene.validate(), Ok(()), "{front} {back} {front_moved} {reach}");
                }
            }
        }
    }
}
