//! From a [`Scene`] to the text of a scene file.

use super::super::{Attenuation, Light, LightKind, Rgb, Scene};
use glam::DVec3;
use serde::Serialize;
use std::path::PathBuf;

pub fn write(scene: &Scene) -> String {
    let Scene { version, camera, image, object, material, reflection, shading, display, ambient, lights } = scene;
    let mut object = object.clone();
    object.path = object.path.map(|path| PathBuf::from(path.to_string_lossy().into_owned()));
    let mut text = format!("# A scene of shading-lab\nversion = {version}\n");
    if lights.is_empty() {
        text.push_str("light = []\n");
    }
    section(&mut text, "[camera]", camera);
    section(&mut text, "[image]", image);
    section(&mut text, "[object]", &object);
    section(&mut text, "[material]", material);
    section(&mut text, "[reflection]", reflection);
    section(&mut text, "[shading]", shading);
    section(&mut text, "[display]", display);
    section(&mut text, "[ambient]", ambient);
    for light in lights {
        section(&mut text, "[[light]]", &WrittenLight::from(light));
    }
    text
}

fn section(text: &mut String, head: &str, keys: &impl Serialize) {
    let keys = toml::to_string(keys).expect("numbers, words, lists of numbers and valid Unicode all have a TOML form");
    text.extend(["\n", head, "\n", keys.as_str()]);
}

/// A light's keys as they are written: those that it reads, and those that differ from their default.
#[derive(Serialize)]
struct WrittenLight {
    kind: LightKind,
    #[serde(skip_serializing_if = "Option::is_none")]
    position: Option<DVec3>,
    #[serde(skip_serializing_if = "Option::is_none")]
    direction: Option<DVec3>,
    color: Rgb,
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

impl From<&Light> for WrittenLight {
    fn from(light: &Light) -> Self {
        let &Light { kind, position, direction, color, attenuation, k, c1, c2, c3 } = light;
        let default = Light::default();
        let reads_k = matches!(attenuation, Attenuation::Viewer | Attenuation::Light);
        let quadratic = attenuation == Attenuation::Quadratic;
        Self {
            kind,
            position: keep(position, default.position, kind == LightKind::Point),
            direction: keep(direction, default.direction, kind == LightKind::Directional),
            color,
            attenuation,
            k: keep(k, default.k, reads_k),
            c1: keep(c1, default.c1, quadratic),
            c2: keep(c2, default.c2, quadratic),
            c3: keep(c3, default.c3, quadratic),
        }
    }
}

fn keep<T: PartialEq>(value: T, default: T, read: bool) -> Option<T> {
    (read || value != default).then_some(value)
}
