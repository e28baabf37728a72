//! Depth cueing: where it begins and ends, and what the object fades into.

use crate::app::row::{About, NumberRow, Rail, choice, colour, number};
use crate::app::state::AppState;
use crate::app::symbol::{Lit, Symbol};
use crate::scene::{CuedBy, DepthCueing, GREATEST_LENGTH, ShadingMode};
use eframe::egui::{RichText, Ui};

pub fn mist_ui(ui: &mut Ui, state: &mut AppState) {
    let AppState { document, lit, .. } = state;
    let scene = &mut document.scene;
    let (default, cueing) = (DepthCueing::default(), &mut scene.depth_cueing);
    let about = About {
        label: "Depth cueing",
        tip: "What is far fades into one colour, as if through mist: s0·I + (1 − s0)·Idc is seen.",
        symbol: Some(Symbol::Depth),
        ..About::default()
    };
    let choices = [
        (CuedBy::Off, "off", ""),
        (CuedBy::Vertex, "at vertices", "Intensities fade at the vertices; in Phong shading s0 is interpolated"),
        (CuedBy::Pixel, "at pixels", "By each pixel's own depth"),
    ];
    choice(ui, lit, &about, default.by, &choices, &mut cueing.by);
    if cueing.by == CuedBy::Off {
        return;
    }
    if cueing.by == CuedBy::Vertex && scene.shading.mode == ShadingMode::Exact {
        ui.label(RichText::new("Exact shading has no vertices: each pixel's depth").weak());
    }
    depths_ui(ui, lit, 2.0 * scene.camera.distance(), cueing);
    scales_ui(ui, lit, cueing);
    let tip = "Idc: red, green and blue, linear. That of the background lets the object vanish in it.";
    let about =
        About { letter: "Idc", label: "colour", name: "Mist colour", tip, symbol: about.symbol, idle: None, ..about };
    colour(ui, lit, &about, default.color, &mut cueing.color);
}

fn depths_ui(ui: &mut Ui, lit: &mut Lit, reach: f64, cueing: &mut DepthCueing) {
    let (default, before) = (DepthCueing::default(), cueing.front);
    let rows = [
        ("begins at", "Mist begins at", "The depth where fading begins;", default.front, &mut cueing.front),
        ("complete at", "Mist complete at", "The depth where fading is complete;", default.back, &mut cueing.back),
    ];
    for (label, name, what, default, value) in rows {
        let tip = format!("{what} depth is the distance from the eye along the line of sight, world units.");
        let about = About { letter: "z", label, name, tip: &tip, symbol: Some(Symbol::Depth), ..About::default() };
        let rail = Rail { limits: 0.0..=GREATEST_LENGTH, ..Rail::linear(0.0..=reach) };
        number(ui, lit, &NumberRow { about, rail, default }, value);
    }
    part(cueing, cueing.front.to_bits() != before.to_bits(), reach);
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

fn scales_ui(ui: &mut Ui, lit: &mut Lit, cueing: &mut DepthCueing) {
    let default = DepthCueing::default();
    let rows = [
        ("in front", "s0 in front", "where the mist begins", default.front_scale, &mut cueing.front_scale),
        ("at the back", "s0 at the back", "where the mist is complete", default.back_scale, &mut cueing.back_scale),
    ];
    for (label, name, place, default, value) in rows {
        let tip = format!("s0: what is left of the intensity {place}. No unit, 0 to 1.");
        let about = About { letter: "s0", label, name, tip: &tip, symbol: Some(Symbol::Depth), ..About::default() };
        let rail = Rail { limits: 0.0..=1.0, ..Rail::linear(0.0..=1.0) };
        number(ui, lit, &NumberRow { about, rail, default }, value);
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
