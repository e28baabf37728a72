//! The picture in words, for those who do not see it: what is shown, where its light comes from, and where it is brightest.

use crate::app::engine::Engine;
use crate::app::session::Session;
use crate::app::session::window::WindowState;
use crate::render::Frame;
use crate::scene::{Choice as _, Light, LightKind, ReflectionModel, Scene, View};
use crate::text::{Language, language, text};
use glam::DVec3;

/// The specular coefficient below which a surface is called matt.
const MATT: f64 = 0.02;
/// The exponent from which a glossy surface is called shiny.
const SHINY: f64 = 100.0;
/// The part of a side, on either side of its middle, that still counts as the middle.
const MIDDLE: f64 = 1.0 / 6.0;
/// The sine of the angle up to which a light comes from neither side.
const STRAIGHT: f64 = 0.25;
/// The chroma below which a colour is a grey, and the grey values of white and black.
const GREY: f64 = 0.15;
const WHITE: f64 = 0.85;
const BLACK: f64 = 0.15;
/// The hues in the order of the circle, 60° each, red first.
const HUES: [&str; 6] = [
    "picture-red",
    "picture-yellow",
    "picture-green",
    "picture-cyan",
    "picture-blue",
    "picture-magenta",
];
/// Maximum number of lights whose direction is described.
const MOST: usize = 3;

/// The parts of a picture's description.
#[derive(Clone)]
pub struct Described {
    /// The picture and the language that it is about.
    of: (u64, Language),
    /// A sentence about the picture.
    pub picture: String,
    /// A sentence about the pixel at the probe.
    pub probe: String,
}

/// Returns the description of the active pane's picture; it is made only once the picture or the probe has changed.
pub fn described(session: &Session, window: &mut WindowState, engine: &Engine) -> Described {
    let of = (engine.revision, language());
    let known = window.own.get().filter(|known: &&Described| known.of == of);
    if let Some(known) = known {
        return known.clone();
    }
    let frame = engine.frame();
    let new = Described {
        of,
        picture: describe(&session.shown.scene, frame),
        probe: probed(frame, window.probe.pixel([frame.width, frame.height])),
    };
    window.own.put(new.clone());
    new
}

/// Returns a sentence about the picture of `scene`.
fn describe(scene: &Scene, frame: &Frame) -> String {
    let size = [frame.width, frame.height];
    let view = View::new(&scene.camera, size);
    let soloing = scene.soloing();
    let lights = scene.lights.iter().filter(|light| light.shines(soloing));
    let from: Vec<&str> = lights
        .take(MOST)
        .map(|light| direction(light, scene, &view))
        .collect();
    let light = match from.len() {
        0 => text!("picture-unlit").to_owned(),
        _ => text!("picture-lit", from = from.join(text!("picture-and"))),
    };
    let bright = match brightest(frame) {
        Some([x, y]) => text!("picture-brightest-at", place = place(x, y)),
        None => text!("picture-dark").to_owned(),
    };
    text!(
        "picture-description",
        surface = surface(scene),
        colour = colour(scene.material.color),
        object = scene.object.kind.label(),
        mode = scene.shading.mode.label(),
        light = light,
        bright = bright
    )
}

fn surface(scene: &Scene) -> &'static str {
    let material = &scene.material;
    if scene.reflection.model == ReflectionModel::Formula {
        text!("picture-by-formula")
    } else if material.ks.max_element() < MATT {
        text!("picture-matt")
    } else if material.n < SHINY {
        text!("picture-glossy")
    } else {
        text!("picture-shiny")
    }
}

fn colour(colour: DVec3) -> &'static str {
    let (most, least) = (colour.max_element(), colour.min_element());
    if most - least < GREY {
        return match most {
            most if most > WHITE => text!("picture-white"),
            most if most < BLACK => text!("picture-black"),
            _ => text!("picture-grey"),
        };
    }
    let [r, g, b] = colour.to_array();
    let sixth = match most {
        most if most <= r => (g - b) / (most - least),
        most if most <= g => 2.0 + (b - r) / (most - least),
        _ => 4.0 + (r - g) / (most - least),
    };
    if (0.25..0.75).contains(&sixth) {
        return text!("picture-orange");
    }
    text!(HUES[sixth.rem_euclid(6.0).round() as usize % 6])
}

/// Returns where a light comes from, as seen by the viewer.
fn direction(light: &Light, scene: &Scene, view: &View) -> &'static str {
    let way = match light.kind {
        LightKind::Directional => -light.direction,
        _ => light.position - scene.camera.target,
    };
    let way = way.normalize_or_zero();
    let [right, up] = [view.right, view.up].map(|axis| sign(way.dot(axis)));
    if way.dot(view.forward) > STRAIGHT {
        text!("picture-behind")
    } else if right.abs() + up.abs() < 0.5 {
        text!("picture-front")
    } else {
        place(right, -up)
    }
}

fn sign(part: f64) -> f64 {
    if part.abs() < STRAIGHT {
        0.0
    } else {
        part.signum()
    }
}

/// Returns the name of a place: −1 is left or above, 1 right or below.
fn place(x: f64, y: f64) -> &'static str {
    let third = |side: f64| usize::from(side > 0.0) + usize::from(side >= 0.0);
    let names = [
        ["picture-upper-left", "picture-top", "picture-upper-right"],
        ["picture-left", "picture-middle", "picture-right"],
        [
            "picture-lower-left",
            "picture-bottom",
            "picture-lower-right",
        ],
    ];
    text!(names[third(y)][third(x)])
}

/// Returns the place of the brightest pixel that differs from the first, which shows the background: the side of the middle
/// that it lies on, or 0 about the middle. Of several it is their mean; `None` if all are black.
fn brightest(frame: &Frame) -> Option<[f64; 2]> {
    let background = frame.pixels.first()?;
    let sum = |pixel: &[u8; 4]| {
        let parts = pixel[..3].iter().map(|&part| u32::from(part));
        if pixel == background {
            0
        } else {
            parts.sum::<u32>()
        }
    };
    let sums = frame.pixels.iter().map(sum);
    let most = sums.max().filter(|most| *most > 0)?;
    let width = frame.width.max(1) as usize;
    let pixels = frame.pixels.iter().enumerate();
    let (mut count, mut at) = (0.0, [0.0; 2]);
    for (index, _) in pixels.filter(|(_, pixel)| sum(pixel) == most) {
        count += 1.0;
        at[0] += (index % width) as f64;
        at[1] += (index / width) as f64;
    }
    let side = |sum: f64, side: u32| {
        let share = (sum / count + 0.5) / f64::from(side.max(1)) - 0.5;
        if share.abs() < MIDDLE {
            0.0
        } else {
            share.signum()
        }
    };
    Some([side(at[0], frame.width), side(at[1], frame.height)])
}

/// Returns a sentence about the pixel at the probe.
fn probed(frame: &Frame, [x, y]: [u32; 2]) -> String {
    let [red, green, blue] = frame.pixel(x, y).unwrap_or_default();
    text!(
        "picture-probed",
        x = x,
        y = y,
        red = red,
        green = green,
        blue = blue
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::Renderer;
    use crate::scene::presets;

    #[test]
    fn a_picture_is_told_by_its_surface_colour_shape_light_and_brightest_place() {
        let mut scene = presets::find("sphere").expect("a built-in scene").scene();
        scene.image.size = [90, 90];
        scene.material.ks = DVec3::ZERO;
        scene.material.color = DVec3::new(0.9, 0.1, 0.1);
        scene.lights.truncate(1);
        scene.lights[0].kind = LightKind::Directional;
        scene.lights[0].direction = DVec3::new(3.0, -3.0, -1.0);
        let mut renderer = Renderer::default();
        let words = describe(&scene, renderer.render(&scene));
        for part in [
            "matt",
            "red",
            "sphere",
            "lit from the upper left",
            "brightest at the upper left",
        ] {
            assert!(words.contains(part), "{words}: {part}");
        }
        scene.reflection.model = ReflectionModel::Formula;
        let words = describe(&scene, renderer.render(&scene));
        assert!(words.contains("formula-lit red sphere"), "{words}");
        scene.lights[0].direction = DVec3::new(0.0, 0.0, -1.0);
        let words = describe(&scene, renderer.render(&scene));
        assert!(words.contains("brightest at the middle"), "{words}");
        scene.lights.clear();
        scene.ambient.color = DVec3::ZERO;
        let words = describe(&scene, renderer.render(&scene));
        assert!(
            words.contains("no light") && words.contains("black"),
            "{words}"
        );
    }
}
