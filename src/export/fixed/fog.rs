//! Depth cueing, which is OpenGL's linear fog: a part of `set_up_camera()`.
//!
//! Fog mixes with f = (end − z)/(end − start), clamped to 0..1, at every pixel. So a ramp of s0 from 1 to 0 is said exactly;
//! any other one where the object does not leave it.

use super::super::holding;
use super::super::number::{c_float, c_four, said};
use crate::geometry::VertexMesh;
use crate::scene::{CuedBy, DepthCueing, Scene, View};

/// The calls; nothing where no depth is cued.
pub(super) fn text(scene: &Scene) -> String {
    let cueing = &scene.depth_cueing;
    let Some([start, end]) = ramp(cueing) else { return String::new() };
    let depths = format!("s0 is {} at {}", said(cueing.front_scale), said(cueing.front));
    format!(
        "
    const GLfloat fog_color[] = {{{}}}; /* Idc */
    glEnable(GL_FOG); /* depth cueing: s0*I + (1 - s0)*Idc */
    glFogi(GL_FOG_MODE, GL_LINEAR);
    glFogf(GL_FOG_START, {}); /* the depth where s0 would be 1: {depths} */
    glFogf(GL_FOG_END, {}); /* the depth where s0 would be 0: it is {} at {} */
    glFogfv(GL_FOG_COLOR, fog_color);
    glHint(GL_FOG_HINT, GL_NICEST); /* at every pixel */
",
        c_four(cueing.color, 1.0),
        c_float(start),
        c_float(end),
        said(cueing.back_scale),
        said(cueing.back)
    )
}

/// The depths where the ramp of s0 has the values 1 and 0.
fn ramp(cueing: &DepthCueing) -> Option<[f64; 2]> {
    let DepthCueing { front, back, front_scale, back_scale, .. } = *cueing;
    let fall = front_scale - back_scale;
    let at = |s0: f64| front + (front_scale - s0) / fall * (back - front);
    (cueing.by != CuedBy::Off && fall != 0.0).then(|| [at(1.0), at(0.0)])
}

/// What fog does not say.
pub(in super::super) fn limits(scene: &Scene, mesh: &VertexMesh) -> Vec<String> {
    let cueing = &scene.depth_cueing;
    let DepthCueing { front, back, front_scale, back_scale, .. } = *cueing;
    if cueing.by == CuedBy::Off || [front_scale, back_scale] == [1.0; 2] {
        return Vec::new();
    }
    let view = View::new(&scene.camera, scene.image.size);
    let depth = |p: &glam::Vec3| (mesh.origin + p.as_dvec3() - view.eye).dot(view.forward);
    let leaves = mesh.positions.iter().map(depth).any(|depth| {
        let whole = |s0: f64| s0 == 0.0 || s0 == 1.0;
        (depth < front && !whole(front_scale)) || (depth > back && !whole(back_scale))
    });
    let flat = front_scale == back_scale;
    holding([
        (flat, "Depth cueing by the same s0 everywhere: OpenGL's fog depends on the depth. There is none."),
        (!flat && leaves, "Depth cueing: s0 goes on to 1 and to 0 beyond its two depths."),
        (!flat && cueing.by == CuedBy::Vertex, "Depth cueing at vertices: OpenGL's fog is evaluated at every pixel."),
        (!flat && cueing.color.max_element() > 1.0, "Depth cueing: OpenGL clamps fog's colour to 1."),
    ])
}
