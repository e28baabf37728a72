//! The scene in fixed-function OpenGL 1.x: what was computed before there were shaders.
//!
//! In: a scene and its polygons. Out: C that sets up camera, lights and material, and with it a whole program that draws
//! the polygons off screen.

mod camera;
pub(super) mod fog;
pub(super) mod lamps;
mod lights;
pub(super) mod material;
mod program;

use super::{Export, ExportError, Part, comment, export_mesh, head, limits};
use crate::geometry::{Mesh, VertexMesh};
use crate::scene::Scene;

/// Most triangles that are written out as C: about 100 MB of text.
pub const MAX_PROGRAM_TRIANGLES: usize = 1_000_000;

/// The part that is worth copying: `set_up_camera(width, height)`, `set_up_lights()` and `set_up_material()` in C99, to
/// be called in this order with an OpenGL context current. The mesh gives the distances that the depth buffer spans.
pub fn opengl_c_snippet(scene: &Scene, mesh: &Mesh) -> Export {
    let mesh = export_mesh(scene, mesh);
    let mut limits = limits::fixed_function(scene, &mesh);
    limits.push(limits::VERTEX_CLAMP.to_owned());
    let text = format!("{}\n#include <GL/gl.h>\n\n{}", opening(&SNIPPET, &limits), functions(scene, &mesh));
    Export { parts: vec![Part { title: "C", ending: "c", text }], limits }
}

/// A whole program in C99: the same functions, the polygons and a `main` that draws them off screen through EGL and
/// writes a binary PPM picture to the path it is given.
///
/// # Errors
/// A mesh of more than [`MAX_PROGRAM_TRIANGLES`] triangles.
pub fn opengl_c(scene: &Scene, mesh: &Mesh) -> Result<Export, ExportError> {
    let triangles = mesh.triangle_count();
    if triangles > MAX_PROGRAM_TRIANGLES {
        return Err(ExportError::MeshTooLarge { triangles });
    }
    let mesh = export_mesh(scene, mesh);
    let limits = limits::fixed_function(scene, &mesh);
    let (before, after) = (program::INCLUDES, program::text(scene, &mesh));
    let text = format!("{}\n{before}\n{}\n{after}", opening(&PROGRAM, &limits), functions(scene, &mesh));
    Ok(Export { parts: vec![Part { title: "C", ending: "c", text }], limits })
}

const SNIPPET: [&str; 4] = [
    "A scene of shading-lab in fixed-function OpenGL. Call, with a context current and in this order:",
    "    set_up_camera(width, height); set_up_lights(); set_up_material();",
    "Then draw polygons with unit normals, counter-clockwise from outside. The equation, per channel:",
    "    I = Ka*Od*Ia + sum over the lights of f*Ip*[Kd*Od*(N.L) + Ks*Os*(N.H)^n], where N.L > 0",
];

const PROGRAM: [&str; 4] = [
    "A scene of shading-lab in fixed-function OpenGL: a whole program, which draws off screen.",
    "    cc -std=c99 -Wall -Wextra scene.c -o scene -lEGL -lGL && ./scene picture.ppm",
    "(Debian: apt install libegl-dev libgl-dev libgl1-mesa-dri.) The equation, per channel:",
    "    I = Ka*Od*Ia + sum over the lights of f*Ip*[Kd*Od*(N.L) + Ks*Os*(N.H)^n], where N.L > 0",
];

fn opening(what: &[&str], limits: &[String]) -> String {
    format!("/*\n{} */\n", comment(&head(what, limits), " * "))
}

fn functions(scene: &Scene, mesh: &VertexMesh) -> String {
    let (camera, lights) = (camera::text(scene, mesh), lights::text(scene, mesh));
    format!("{camera}\n{lights}\n{}", material::text(scene, mesh))
}
