//! The scene as a vertex and a fragment shader in GLSL 3.30: the equation of this program, term by term.
//!
//! Phong and exact shading evaluate the equation in the fragment shader, the other modes in the vertex shader: the text of
//! the equation is the same.

mod cue;
mod equation;
mod lights;
mod stages;

use super::{Export, Part, comment, head, limits};
use crate::scene::Scene;

/// A pair of shaders, `#version 330 core`, that evaluates the scene's equation where its shading mode does. They need
/// positions (location 0) and unit normals (location 1) in the world and nothing else: the uniforms have the scene's
/// values as defaults.
pub fn glsl_330(scene: &Scene) -> Export {
    let limits = limits::shaders(scene);
    let equation = format!("{}\n{}\n{}", equation::constants(scene), equation::terms(scene), lights::text(scene));
    let [in_vertex, in_fragment] = if stages::per_pixel(scene) { ["", &equation] } else { [&*equation, ""] };
    let (inputs, vertex, fragment) = (stages::inputs(scene), stages::vertex(scene), stages::fragment(scene));
    let vertex = format!("{}\n{inputs}{in_vertex}{vertex}", opening(VERTEX, scene, &limits));
    let fragment = format!("{}\n{in_fragment}{fragment}", opening(FRAGMENT, scene, &limits));
    let parts = vec![
        Part { title: "vertex shader", ending: "vert", text: vertex },
        Part { title: "fragment shader", ending: "frag", text: fragment },
    ];
    Export { parts, limits }
}

const VERTEX: &str = "A scene of shading-lab: the vertex shader of a pair.";
const FRAGMENT: &str = "A scene of shading-lab: the fragment shader of a pair.";

/// The version, which must come first, and what to know before reading on.
fn opening(what: &str, scene: &Scene, limits: &[String]) -> String {
    let host = stages::host(scene);
    format!(
        "#version 330 core\n{}",
        comment(&head(&[what, &host, "The equation, per channel:", EQUATION], limits), "// ")
    )
}

const EQUATION: &str = "    I = Ka*Od*Ia + sum over the lights of f*Ip*[Kd*Od*(N.L) + Ks*Os*W*S], where N.L > 0";
