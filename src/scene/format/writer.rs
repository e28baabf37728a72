//! From a [`Scene`] to the text of a scene file.

use super::super::{
    AreaShape, Attenuation, Compare, CompareView, DifferenceKind, Light, LightKind, Object, Rgb, Scene,
};
use glam::DVec3;
use serde::Serialize;
use std::fmt::{Debug, Write};
use std::path::PathBuf;

pub fn write(scene: &Scene) -> String {
    let Scene { version, about, camera, image, object, material, pattern, transparency, .. } = scene;
    let Scene { reflection, shading, display, ground, backdrop, depth_cueing, ambient, lights, compare, .. } = scene;
    let mut object = object.clone();
    object.path = object.path.map(|path| PathBuf::from(path.to_string_lossy().into_owned()));
    let mut text = format!("# A scene of shading-lab\nversion = {version}\n");
    if lights.is_empty() {
        text.push_str("light = []\n");
    }
    unless_default(&mut text, "[about]", about);
    section(&mut text, "[camera]", camera);
    section(&mut text, "[image]", image);
    let Object { vertices, faces, vertex_normals, .. } = object.clone();
    (object.vertices, object.faces, object.vertex_normals) = Default::default();
    section(&mut text, "[object]", &object);
    lines(&mut text, "vertices", vertices.iter().map(|v| v.to_array()));
    lines(&mut text, "faces", faces.iter());
    lines(&mut text, "vertex_normals", vertex_normals.iter().map(|n| n.to_array()));
    section(&mut text, "[material]", material);
    unless_default(&mut text, "[pattern]", pattern);
    unless_default(&mut text, "[transparency]", transparency);
    section(&mut text, "[reflection]", reflection);
    section(&mut text, "[shading]", shading);
    section(&mut text, "[display]", display);
    unless_default(&mut text, "[ground]", ground);
    unless_default(&mut text, "[backdrop]", backdrop);
    unless_default(&mut text, "[depth_cueing]", depth_cueing);
    section(&mut text, "[ambient]", ambient);
    for light in lights {
        section(&mut text, "[[light]]", &WrittenLight::from(light));
    }
    let &Compare { view, wipe, difference, gain, ref panes } = compare;
    if *compare != Compare::default() {
        section(&mut text, "[compare]", &WrittenCompare { view, wipe, difference, gain });
    }
    for pane in panes {
        section(&mut text, "[[compare.pane]]", pane);
    }
    text
}

/// What is compared, without the panes, which are sections of their own.
#[derive(Serialize)]
struct WrittenCompare {
    view: CompareView,
    wipe: f64,
    difference: DifferenceKind,
    gain: f64,
}

/// A section that is left out where all of it has its default.
fn unless_default<T: Serialize + Default + PartialEq>(text: &mut String, head: &str, keys: &T) {
    if *keys != T::default() {
        section(text, head, keys);
    }
}

fn section(text: &mut String, head: &str, keys: &impl Serialize) {
    let keys = toml::to_string(keys).expect("numbers, words, lists of numbers and valid Unicode all have a TOML form");
    text.extend(["\n", head, "\n", keys.as_str()]);
}

/// A list with each element on a line of its own, if there is any.
fn lines(text: &mut String, key: &str, elements: impl ExactSizeIterator<Item: Debug>) {
    if elements.len() > 0 {
        text.extend([key, " = [\n"]);
        for element in elements {
            // Numbers and lists of them look alike in Rust and in TOML.
            let _ = writeln!(text, "    {element:?},");
        }
        text.push_str("]\n");
    }
}

/// A light's keys as they are written: those that it reads, and those that differ from their default.
#[derive(Serialize)]
struct WrittenLight<'a> {
    #[serde(skip_serializing_if = "str::is_empty")]
    name: &'a str,
    kind: LightKind,
    #[serde(skip_serializing_if = "Option::is_none")]
    mute: Option<bool>,
    #[serde(skip_serializing_if = "Option::is_none")]
    solo: Option<bool>,
    #[serde(skip_serializing_if = "Option::is_none")]
    position: Option<DVec3>,
    #[serde(skip_serializing_if = "Option::is_none")]
    direction: Option<DVec3>,
    color: Rgb,
    #[serde(skip_serializing_if = "Option::is_none")]
    cone: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    exponent: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    softness: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    shape: Option<AreaShape>,
    #[serde(skip_serializing_if = "Option::is_none")]
    extent: Option<[f64; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    radius: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    samples: Option<u32>,
    attenuation: Attenuation,
    #[serde(skip_serializing_if = "Option::is_none")]
    k: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    c1: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    c2: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    c3: Option<f64>,
}

impl<'a> From<&'a Light> for WrittenLight<'a> {
    fn from(light: &'a Light) -> Self {
        let default = Light::default();
        let kind = light.kind;
        let (spot, area) = (kind == LightKind::Spot, kind == LightKind::Area);
        let rectangle = area && light.shape == AreaShape::Rectangle;
        let reads_k = matches!(light.attenuation, Attenuation::Viewer | Attenuation::Light);
        let quadratic = light.attenuation == Attenuation::Quadratic;
        Self {
            name: &light.name,
            kind,
            mute: keep(light.mute, default.mute, false),
            solo: keep(light.solo, default.solo, false),
            position: keep(light.position, default.position, kind.has_position()),
            direction: keep(light.direction, default.direction, light.has_direction()),
            color: light.color,
            cone: keep(light.cone, default.cone, spot),
            exponent: keep(light.exponent, default.exponent, spot),
            softness: keep(light.softness, default.softness, spot),
            shape: keep(light.shape, default.shape, area),
            extent: keep(light.extent, default.extent, rectangle),
            radius: keep(light.radius, default.radius, area && !rectangle),
            samples: keep(light.samples, default.samples, area),
            attenuation: light.attenuation,
            k: keep(light.k, default.k, reads_k),
            c1: keep(light.c1, default.c1, quadratic),
            c2: keep(light.c2, default.c2, quadratic),
            c3: keep(light.c3, default.c3, quadratic),
        }
    }
}

fn keep<T: PartialEq>(value: T, default: T, read: bool) -> Option<T> {
    (read || value != default).then_some(value)
}
