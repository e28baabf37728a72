//! The rest of a whole program: the polygons as arrays, and `main`.

use super::super::fan;
use super::super::number::{c_double, c_three};
use crate::geometry::VertexMesh;
use crate::scene::{Scene, ShadingMode};
use glam::Vec3;
use std::fmt::Write;

pub(super) const INCLUDES: &str = "#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>
#include <stdio.h>
#include <stdlib.h>
";

/// Off-screen drawing with the names of the arrays below.
const MAIN: &str = include_str!("main.c");

pub(super) fn text(scene: &Scene, mesh: &VertexMesh) -> String {
    let [width, height] = scene.image.size;
    let triangles = triangles(scene, mesh);
    let mut text = format!("enum {{ WIDTH = {width}, HEIGHT = {height}, TRIANGLES = {} }};\n\n", triangles.len());
    let _ = writeln!(text, "static const GLclampf background[] = {{{}}};\n", c_three(scene.image.background));
    text += "/* Where (0, 0, 0) of the positions lies in the world. */\n";
    let _ = writeln!(text, "static const double origin[] = {{{}}};\n", mesh.origin.to_array().map(c_double).join(", "));
    array(&mut text, "positions", &mesh.positions);
    text += "/* N at each vertex, unit. */\n";
    array(&mut text, "normals", &mesh.normals);
    indices(&mut text, scene, &triangles);
    text += MAIN;
    text
}

/// Each polygon fanned from its first vertex. For flat shading that vertex comes last, where OpenGL takes the shade from.
fn triangles(scene: &Scene, mesh: &VertexMesh) -> Vec<[u32; 3]> {
    let flat = scene.shading.mode == ShadingMode::Flat;
    let order = |[a, b, c]: [u32; 3]| if flat { [b, c, a] } else { [a, b, c] };
    fan(mesh).map(order).collect()
}

fn array(text: &mut String, name: &str, vectors: &[Vec3]) {
    let _ = writeln!(text, "static const GLfloat {name}[][3] = {{");
    let vectors = if vectors.is_empty() { &[Vec3::ZERO] } else { vectors };
    for v in vectors {
        let _ = writeln!(text, "    {{{}}},", c_three(v.as_dvec3()));
    }
    text.push_str("};\n\n");
}

fn indices(text: &mut String, scene: &Scene, triangles: &[[u32; 3]]) {
    let order = match scene.shading.mode {
        ShadingMode::Flat => "Each polygon is a fan about its first vertex, which gives the shade and so comes last.",
        _ => "Each polygon is a fan about its first vertex.",
    };
    let _ = writeln!(text, "/* {order} Counter-clockwise from outside. */\nstatic const GLuint triangles[][3] = {{");
    for [a, b, c] in triangles {
        let _ = writeln!(text, "    {{{a}, {b}, {c}}},");
    }
    if triangles.is_empty() {
        text.push_str("    {0, 0, 0},\n");
    }
    text.push_str("};\n\n");
}
