//! How well vertex normals stand for the surface.

use super::Finding;
use crate::analysis::luminance;
use crate::render::Renderer;
use crate::scene::{NormalSource, Rgb, Scene, ShadingMode};
use serde::Serialize;

/// What unrepresentative vertex normals do.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct VertexNormals {
    /// Greatest angle between a face and a vertex normal that it is shaded with, degrees.
    pub greatest_angle: f64,
    /// Its mean over the corners of all faces.
    pub mean_angle: f64,
    /// Standard deviation of the luminance over the object, in the picture.
    pub contrast: f64,
    /// The same in the true picture.
    pub true_contrast: f64,
}

pub(super) fn measure(renderer: &mut Renderer, scene: &Scene) -> Finding<VertexNormals> {
    match scene.shading.mode {
        ShadingMode::Gouraud | ShadingMode::Phong => {}
        ShadingMode::Flat | ShadingMode::Interpolated => return Err("this shading uses the polygons' own normals"),
        ShadingMode::Exact => return Err("exact shading uses the surface's own normals"),
    }
    let contrast = contrast(renderer, scene).ok_or("the object is not in the picture")?;
    let mesh = renderer.mesh();
    let vertices = mesh.with_vertex_normals(scene.object.normals, scene.object.weighting);
    let (mut greatest, mut sum, mut count) = (0.0f64, 0.0, 0u32);
    for f in 0..mesh.face_count() {
        let face = mesh.face_normal(f);
        let range = vertices.starts[f] as usize..vertices.starts[f + 1] as usize;
        for &vertex in vertices.indices[range].iter().filter(|_| face.length_squared() > 0.0) {
            let normal = vertices.normals[vertex as usize].as_dvec3();
            let angle = face.cross(normal).length().atan2(face.dot(normal)).to_degrees();
            greatest = greatest.max(angle);
            sum += angle;
            count += 1;
        }
    }
    let mut truth = scene.clone();
    truth.shading.mode = ShadingMode::Exact;
    if !renderer.shows_surface(&truth) {
        // Beyond its polygons such an object is nothing: each has its own normal.
        truth.shading.mode = ShadingMode::Phong;
        truth.object.normals = NormalSource::Facet;
    }
    let true_contrast = self::contrast(renderer, &truth).unwrap_or_default();
    let mean_angle = sum / f64::from(count.max(1));
    Ok(VertexNormals { greatest_angle: greatest, mean_angle, contrast, true_contrast })
}

/// Standard deviation of the luminance over the pixels that show the object.
fn contrast(renderer: &mut Renderer, scene: &Scene) -> Option<f64> {
    renderer.keep_linear(true);
    renderer.render(scene);
    renderer.keep_linear(false);
    let seen = renderer.linear().iter().filter(|pixel| pixel[3] > 0.0);
    let (mut count, mut mean, mut squares) = (0.0, 0.0, 0.0);
    for [r, g, b, _] in seen {
        // Welford 1962: the mean and the squares about it in one pass.
        let value = luminance(Rgb::new((*r).into(), (*g).into(), (*b).into()));
        count += 1.0;
        let off = value - mean;
        mean += off / count;
        squares += off * (value - mean);
    }
    (count > 0.0).then(|| (squares / count).sqrt())
}
