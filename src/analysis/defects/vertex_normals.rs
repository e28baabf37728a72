//! How well vertex normals stand for the surface.

use super::Finding;
use crate::analysis::luminance;
use crate::render::Renderer;
use crate::scene::{NormalSource, Rgb, Scene, ShadingMode};
use rayon::prelude::*;
use serde::Serialize;

/// Faces that one task looks at.
const CHUNK: usize = 4096;

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
    let mesh = renderer.mesh_shown();
    let vertices = mesh.with_vertex_normals(scene.object.normals, scene.object.weighting);
    let normals = &vertices.normals;
    let of_face = |f: usize| {
        let face = mesh.face_normal(f);
        vertices.face(f).iter().filter(move |_| face.length_squared() > 0.0).map(move |&vertex| {
            let normal = normals[vertex as usize].as_dvec3();
            face.cross(normal).length().atan2(face.dot(normal)).to_degrees()
        })
    };
    let chunks = (0..mesh.face_count()).into_par_iter().step_by(CHUNK).map(|first| {
        let angles = (first..(first + CHUNK).min(mesh.face_count())).flat_map(of_face);
        angles.fold((0.0f64, 0.0, 0u32), |(most, sum, count), angle| (most.max(angle), sum + angle, count + 1))
    });
    // Added in the order of the faces, whichever was done first.
    let chunks: Vec<(f64, f64, u32)> = chunks.collect();
    let add = |a: (f64, f64, u32), b: &(f64, f64, u32)| (a.0.max(b.0), a.1 + b.1, a.2 + b.2);
    let (greatest, sum, count) = chunks.iter().fold((0.0, 0.0, 0), add);
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
