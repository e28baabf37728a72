//! The camera as two matrices: from the world to the eye, and from the eye to the picture.

use super::super::number::{c_double, said};
use super::fog;
use crate::geometry::VertexMesh;
use crate::scene::{Camera, Projection, Scene, View};
use glam::DVec3;
use std::fmt::Write;

/// What is nearer than this many camera distances is not drawn.
const NEAR: f64 = 1e-3;

/// Room before the nearest and behind the farthest vertex.
const MARGIN: f64 = 1.01;

pub(super) fn text(scene: &Scene, mesh: &VertexMesh) -> String {
    let camera = &scene.camera;
    let view = View::new(camera, scene.image.size);
    let [near, far] = planes(camera, &view, mesh).map(c_double);
    let eye = camera.eye.to_array().map(said).join(", ");
    let target = camera.target.to_array().map(said).join(", ");
    let (scale, scale_means, projection) = projection(camera);
    let mut text = String::new();
    let columns = columns(&view);
    let _ = write!(
        text,
        "/* The eye at ({eye}) looks at ({target}). Matrices are stored by columns. */
void set_up_camera(int width, int height) {{
    const double z_near = {near}, z_far = {far}; /* depths that are drawn */
    const double scale = {scale}; /* {scale_means} */
    const double projection[16] = {{
{projection}
    }};
    /* The rows are the directions to the right, up and backwards; the last column moves the eye to the origin. */
    const double eye_from_world[16] = {{
{columns}
    }};

    glViewport(0, 0, width, height);
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixd(projection);
    glMatrixMode(GL_MODELVIEW);
    glLoadMatrixd(eye_from_world);
{}}}
",
        fog::text(scene)
    );
    text
}

/// The depths that the depth buffer spans: those of the vertices, as far as they are in front of the eye.
pub(in super::super) fn planes(camera: &Camera, view: &View, mesh: &VertexMesh) -> [f64; 2] {
    let nearest = NEAR * camera.distance();
    let depth = |p: &glam::Vec3| (mesh.origin + p.as_dvec3() - view.eye).dot(view.forward);
    let (least, greatest) =
        mesh.positions.iter().map(depth).fold((f64::INFINITY, 0.0_f64), |(low, high), d| (low.min(d), high.max(d)));
    let near = if least.is_finite() { (least / MARGIN).max(nearest) } else { nearest };
    [near, (greatest * MARGIN).max(2.0 * near)]
}

/// The projection's scale, what it means, and its matrix.
fn projection(camera: &Camera) -> (String, String, &'static str) {
    match camera.projection {
        Projection::Perspective => {
            let means = format!("cot(fov_y/2), fov_y = {} degrees", said(camera.fov_y));
            let matrix = "        scale * height / width, 0.0, 0.0, 0.0,
        0.0, scale, 0.0, 0.0,
        0.0, 0.0, -(z_far + z_near) / (z_far - z_near), -1.0,
        0.0, 0.0, -2.0 * z_far * z_near / (z_far - z_near), 0.0";
            (c_double(1.0 / (0.5 * camera.fov_y.to_radians()).tan()), means, matrix)
        }
        Projection::Orthographic => {
            let means = format!("2/height, {} units are seen from bottom to top", said(camera.height));
            let matrix = "        scale * height / width, 0.0, 0.0, 0.0,
        0.0, scale, 0.0, 0.0,
        0.0, 0.0, -2.0 / (z_far - z_near), 0.0,
        0.0, 0.0, -(z_far + z_near) / (z_far - z_near), 1.0";
            (c_double(2.0 / camera.height), means, matrix)
        }
    }
}

fn columns(view: &View) -> String {
    let backward = -view.forward;
    let column = |x: f64, y: f64, z: f64, w: &str| format!("        {}, {w}", [x, y, z].map(c_double).join(", "));
    let of = |axis: DVec3| [axis.dot(view.right), axis.dot(view.up), axis.dot(backward)];
    let [x, y, z] = [DVec3::X, DVec3::Y, DVec3::Z].map(of).map(|[a, b, c]| column(a, b, c, "0.0"));
    let [a, b, c] = of(-view.eye);
    [x, y, z, column(a, b, c, "1.0")].join(",\n")
}
