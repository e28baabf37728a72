//! Depth cueing: `s0·I + (1 − s0)·Idc`, with s0 where the scene has it.

use super::super::number::{float, vec3};
use crate::scene::{CuedBy, DepthCueing, Scene, ShadingMode, View};
use glam::DVec4;

/// Where s0 is evaluated.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Cue {
    None,
    /// In the vertex shader, where the intensity is.
    Intensity,
    /// In the vertex shader, handed on by itself.
    Carried,
    /// In the fragment shader.
    Fragment,
}

impl Cue {
    pub fn of(scene: &Scene) -> Self {
        let cueing = &scene.depth_cueing;
        if [cueing.front_scale, cueing.back_scale] == [1.0; 2] {
            return Self::None;
        }
        match (cueing.by, scene.shading.mode) {
            (CuedBy::Off, _) => Self::None,
            (CuedBy::Pixel, _) | (_, ShadingMode::Exact) => Self::Fragment,
            (CuedBy::Vertex, ShadingMode::Phong) => Self::Carried,
            (CuedBy::Vertex, _) => Self::Intensity,
        }
    }

    /// What the vertex shader declares.
    pub fn in_vertex(self, scene: &Scene) -> String {
        let law = if self == Self::Fragment { String::new() } else { law(&scene.depth_cueing) };
        match self {
            Self::None => String::new(),
            Self::Intensity => depth(scene) + &law + &fade(&scene.depth_cueing),
            Self::Carried | Self::Fragment => depth(scene) + &law,
        }
    }

    /// What the fragment shader declares.
    pub fn in_fragment(self, scene: &Scene) -> String {
        match self {
            Self::None | Self::Intensity => String::new(),
            Self::Carried => fade(&scene.depth_cueing),
            Self::Fragment => law(&scene.depth_cueing) + &fade(&scene.depth_cueing),
        }
    }
}

fn depth(scene: &Scene) -> String {
    let view = View::new(&scene.camera, scene.image.size);
    let row = DVec4::from((view.forward, -view.forward.dot(view.eye)));
    format!(
        "// The depth of a point, its distance from the eye along the viewing direction; goes with clip_from_world.
uniform vec4 depth_from_world = vec4({});

",
        row.to_array().map(float).join(", ")
    )
}

fn law(cueing: &DepthCueing) -> String {
    let DepthCueing { front, back, front_scale, back_scale, .. } = *cueing;
    format!(
        "// What is left of the intensity at a depth.
float s0_at(float depth) {{
    float nearness = clamp(({} - depth) / {}, 0.0, 1.0);
    return mix({}, {}, nearness);
}}

",
        float(back),
        float(back - front),
        float(back_scale),
        float(front_scale)
    )
}

fn fade(cueing: &DepthCueing) -> String {
    format!(
        "const vec3 Idc = {}; // what intensities fade into

vec3 fade(vec3 I, float s0) {{
    return s0 * I + (1.0 - s0) * Idc;
}}

",
        vec3(cueing.color)
    )
}
