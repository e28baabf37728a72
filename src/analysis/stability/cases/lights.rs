//! Lights where they hardly can be, and more light than numbers hold.

use super::super::{Case, Condition, Topic};
use super::{lamp, polygons, scene, square};
use crate::scene::{Attenuation, Light, LightKind, Rgb, Scene};
use glam::DVec3;

pub const CASES: &[Case] = &[
    Case {
        name: "light-on-the-surface",
        title: "A light on the surface, where a pixel looks",
        topic: Topic::Lights,
        wrong: "L is the zero vector divided by its length: no number.",
        robust: "Lengths are lifted to a shortest one before they divide; a zero vector stays zero and has no N·L.",
        condition: None,
        subject: scene(|| {
            let mut scene = square();
            scene.lights = vec![lamp(0.0, 0.0, 0.0), Light { color: Rgb::splat(0.5), ..lamp(1.0, 2.0, 3.0) }];
            scene
        }),
    },
    Case {
        name: "attenuation-0",
        title: "f = 1/d² as d → 0",
        topic: Topic::Lights,
        wrong: "f is infinite and N·L zero, and their product no number; a rounding away it is white.",
        robust: "d is lifted to a shortest length; what lies in the light's own plane is not lit, however near.",
        condition: Some(Condition { value: 2.0, of: "of f in d, relative to f; its slope is without bound" }),
        subject: scene(|| {
            let mut scene = corner();
            let color = Rgb::splat(0.3);
            scene.lights = vec![Light { color, attenuation: Attenuation::InverseSquare, ..lamp(0.0, 0.0, 0.0) }];
            scene
        }),
    },
    Case {
        name: "light-at-1e30",
        title: "A point light at 10³⁰",
        topic: Topic::Lights,
        wrong: "The square of the distance overflows: L is zero, and the object dark.",
        robust: "A light farther than 10⁹ camera distances shines in parallel; its direction is found in double precision.",
        condition: None,
        subject: scene(|| {
            let mut scene = square();
            scene.lights = vec![lamp(0.5e30, 0.25e30, 1e30)];
            scene
        }),
    },
    Case {
        name: "narrow-cone",
        title: "A spot light's cone of 0.1°",
        topic: Topic::Lights,
        wrong: "Compares cosines, which are 1 − 1.5·10⁻⁶ at the edge: 26 steps of single precision from the axis to it.",
        robust: "Compares 1 − cos, half the square of the chord.",
        condition: Some(Condition { value: 6.6e5, of: "of the angle in its cosine: 2/θ²" }),
        subject: scene(|| {
            let mut scene = square();
            scene.camera.eye = DVec3::new(0.0, 0.0, 0.02);
            let (position, direction) = (DVec3::new(0.25, 0.5, 3.0), DVec3::new(-0.25, -0.5, -3.0));
            let (kind, cone, exponent) = (LightKind::Spot, 0.1, 0.0);
            scene.lights = vec![Light { kind, cone, exponent, position, direction, ..Light::default() }];
            scene
        }),
    },
    Case {
        name: "a-million-lights",
        title: "The light of a million lamps",
        topic: Topic::Lights,
        wrong: "The intensity times 255 is cast to a byte: of a value past 255 the lowest 8 bits remain.",
        robust: "Clamped before it is stored.",
        condition: None,
        subject: scene(|| {
            let mut scene = near();
            scene.lights[0].color = Rgb::splat(1e6);
            scene
        }),
    },
    Case {
        name: "overflow",
        title: "An intensity past the end of single precision",
        topic: Topic::Lights,
        wrong: "Infinity, and infinity times the 0 of a channel that the surface does not reflect: no number.",
        robust: "The coefficients of light and surface are multiplied in double precision and rounded into the range of single; \
                 a channel that is 0 stays 0.",
        condition: None,
        subject: scene(|| {
            let mut scene = near();
            scene.material.color = Rgb::new(1.0, 0.0, 0.0);
            (scene.material.kd, scene.material.ks) = (Rgb::splat(1e6), Rgb::ZERO);
            scene.lights[0].color = Rgb::splat(1e30);
            scene.lights[0].attenuation = Attenuation::InverseSquare;
            scene.lights[0].position = DVec3::new(0.3, 0.2, 0.002);
            scene
        }),
    },
];

/// The square with a light near it.
fn near() -> Scene {
    let mut scene = square();
    scene.lights = vec![lamp(0.4, 0.3, 0.7)];
    scene
}

/// A floor and a wall at right angles, seen so that the picture's centre looks at the origin, on the floor.
fn corner() -> Scene {
    let floor = [[-1.0, 0.0, 1.0], [1.0, 0.0, 1.0], [1.0, 0.0, -0.5], [-1.0, 0.0, -0.5]];
    let wall = [[-1.0, 0.0, -0.5], [1.0, 0.0, -0.5], [1.0, 1.25, -0.5], [-1.0, 1.25, -0.5]];
    let mut scene = polygons(&[floor, wall].concat(), &[&[0, 1, 2, 3], &[4, 5, 6, 7]]);
    scene.camera.eye = DVec3::new(0.0, 2.0, 3.5);
    scene
}
