//! A function for each light, and `illuminate`, which adds them up.

use super::super::emitter::{Emitter, Place, emitters};
use super::super::number::{float, said, vec3};
use crate::scene::{Attenuation, Light, LightKind, PatternKind, Scene, Viewer};
use glam::DVec3;
use std::fmt::Write;

/// The lights of `scene` and the equation itself.
pub(super) fn text(scene: &Scene) -> String {
    let emitters = emitters(scene);
    let mut text: String = emitters.iter().map(light).collect();
    let view = match scene.camera.viewer {
        Viewer::Local => "normalize(eye - P)",
        Viewer::Infinite => "towards_viewer",
    };
    let color = if scene.pattern.kind == PatternKind::None { "Od" } else { "surface_color(P)" };
    let _ = write!(
        text,
        "// I at the point P with the normal N, before the display.
vec3 illuminate(vec3 P, vec3 N) {{
    vec3 V = {view};
    vec3 color = {color};
    vec3 I = Ka * color * Ia;
"
    );
    for emitter in &emitters {
        let _ = writeln!(text, "    I += light_{}(P, N, V, color);", emitter.index);
    }
    text + "    return I;\n}\n\n"
}

fn light(emitter: &Emitter<'_>) -> String {
    let intensity = vec3(emitter.light.color);
    let (what, direction) = match &emitter.place {
        Place::Among(points) => return area(emitter, points),
        Place::Towards(l) => ("L is the same everywhere", format!("    const vec3 L = {};\n", vec3(*l))),
        Place::At(place) => {
            let to_light = format!("    vec3 to_light = {} - P;\n{DIRECTION}", vec3(*place));
            ("L points to its place from each point", to_light)
        }
    };
    let (head, shine) = (heading(emitter, what), shine(emitter, "return"));
    format!("{head}    const vec3 Ip = {intensity};\n{direction}{shine}}}\n\n")
}

/// The comment and the first line of a light's function.
fn heading(emitter: &Emitter<'_>, what: &str) -> String {
    let (title, index) = (emitter.title(), emitter.index);
    format!("// {title}: {what}.\nvec3 light_{index}(vec3 P, vec3 N, vec3 V, vec3 color) {{\n")
}

/// An area light: the points that stand for it, and a loop over them.
fn area(emitter: &Emitter<'_>, points: &[DVec3]) -> String {
    let (index, count) = (emitter.index, points.len());
    let list: Vec<_> = points.iter().map(|&point| format!("    {}", vec3(point))).collect();
    let body = format!("    vec3 to_light = points_{index}[i] - P;\n{DIRECTION}{}", shine(emitter, "sum +="));
    let body: String = body.lines().map(|line| format!("    {line}\n")).collect();
    format!(
        "const vec3 points_{index}[{count}] = vec3[{count}](
{}
);

{}    const vec3 Ip = {} / {count}.0;
    vec3 sum = vec3(0.0);
    for (int i = 0; i < {count}; i++) {{
{body}    }}
    return sum;
}}

",
        list.join(",\n"),
        heading(emitter, "each point of it has an equal share of its intensity"),
        vec3(emitter.light.color)
    )
}

/// Lengths are lifted a little before anything is divided by them.
const DIRECTION: &str = "    float d = max(length(to_light), 1e-9);\n    vec3 L = to_light / d;\n";

/// f, a spot light's part, and what is reflected of it, which `verb` returns or adds.
fn shine(emitter: &Emitter<'_>, verb: &str) -> String {
    let mut text = falloff(emitter);
    let spot = emitter.light.kind == LightKind::Spot;
    if spot {
        text += &cone(emitter);
    }
    let factor = if spot { "f * spot * Ip" } else { "f * Ip" };
    text + &format!("    {verb} reflected(N, L, V, color, {factor});\n")
}

fn falloff(emitter: &Emitter<'_>) -> String {
    let Light { attenuation, k, c1, c2, c3, .. } = *emitter.light;
    let [k, c1, c2, c3] = [k, c1, c2, c3].map(float);
    let f = match (attenuation, emitter.constant) {
        (_, Some(f)) => float(f),
        (Attenuation::Viewer, _) => format!("1.0 / max(distance(eye, P) + {k}, 1e-9)"),
        (Attenuation::Light, _) => format!("1.0 / max(d + {k}, 1e-9)"),
        (Attenuation::InverseSquare, _) => "1.0 / (d * d)".to_owned(),
        (Attenuation::Quadratic, _) => format!("min(1.0, 1.0 / max({c1} + {c2} * d + {c3} * d * d, 1e-9))"),
        (Attenuation::None, None) => "1.0".to_owned(),
    };
    format!("    float f = {f};\n")
}

/// `(−L·D)^e` inside the cone, nothing outside.
fn cone(emitter: &Emitter<'_>) -> String {
    let light = emitter.light;
    let gap = |degrees: f64| 2.0 * (degrees.to_radians() * 0.5).sin().powi(2);
    let edge = gap(light.cone);
    let fade = edge - gap(light.cone * (1.0 - light.softness));
    let edge_text = float(edge);
    let soft = if light.softness > 0.0 {
        format!("smoothstep(0.0, 1.0, ({edge_text} - gap) / {})", float(fade))
    } else {
        format!("step(gap, {edge_text})")
    };
    format!(
        "    const vec3 D = {}; // along the cone
    vec3 chord = L + D;
    float gap = 0.5 * dot(chord, chord); // 1 - cos of the angle to D
    // (-L.D)^e up to {} degrees from D.
    float spot = pow(max(1.0 - gap, 1e-37), {}) * {soft};
",
        vec3(emitter.axis()),
        said(light.cone),
        float(light.exponent)
    )
}
