//! Defects inside the outline: the perspective distortion, the dependence on orientation, and unrepresentative vertex
//! normals.

use super::{Measurement, interpolates};
use crate::analysis::comparison::{ErrorFigures, LinearPicture, error_figures};
use crate::analysis::perception::{luminance, pixel_luminance};
use crate::analysis::probe::probe;
use crate::figure::Area;
use crate::geometry::angle;
use crate::illumination::Equation;
use crate::render::Renderer;
use crate::scene::{Interpolation, NormalSource, Projection, Rgb, Scene, ShadingMode, View};
use glam::{DVec2, DVec3};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::mem;

/// Degrees between two samples of a rotated picture.
const STEP: u32 = 3;
/// Side of the rotated pictures: places in them differ by at least 1/256 of a pixel.
const SIDE: u32 = 256;
/// Minimum ratio of the depths of an edge's ends for it to run away from the eye, and minimum visible displacement of its
/// middle, pixels.
const LEAST_RATIO: f64 = 1.5;
const LEAST_DISPLACEMENT: f64 = 4.0;
/// Share of a depth within which two are the same.
const SAME_DEPTH: f64 = 0.01;
/// Number of faces per task.
const CHUNK: usize = 4096;

/// Error of interpolating in the picture a quantity that is linear in space.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PerspectiveDistortion {
    /// The interpolation compared with the perspective-correct one: the scene's own, or affine if that is correct.
    pub interpolation: Interpolation,
    /// Difference over the picture.
    pub error: ErrorFigures,
    /// The visible edge whose middle in the picture is farthest from its middle in space.
    pub edge: Option<DeepEdge>,
}

/// An edge that runs away from the eye.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct DeepEdge {
    /// Its near end and its far one in the picture, pixels.
    pub ends: [DVec2; 2],
    /// Their depths, world units.
    pub depths: [f64; 2],
}

impl DeepEdge {
    /// Returns the place in the picture at a fraction of the edge in space.
    pub fn in_space(&self, t: f64) -> DVec2 {
        let [near, far] = self.depths;
        let [a, b] = self.ends;
        a.lerp(b, t * far / (near + t * (far - near)))
    }

    /// Returns the distance between both middles, pixels.
    fn displacement(&self) -> f64 {
        self.in_space(0.5)
            .distance(self.ends[0].midpoint(self.ends[1]))
    }

    /// Finds the visible edge of the largest displacement in the picture of `scene` that `renderer` last drew.
    fn find(renderer: &Renderer, scene: &Scene) -> Option<Self> {
        let size = scene.image.size;
        let picture = Area::from_size(DVec2::from_array(size.map(f64::from)));
        let view = View::new(&scene.camera, size);
        let mesh = renderer.mesh_shown();
        let mut found: Option<Self> = None;
        for face in 0..mesh.face_count() {
            let to_eye = view.eye - mesh.face_centre(face);
            if mesh.face_normal(face).dot(to_eye) <= 0.0 {
                continue;
            }
            let points: Vec<DVec3> = mesh.face_points(face).collect();
            for (a, b) in points.iter().zip(points.iter().cycle().skip(1)) {
                let (Some(mut a), Some(mut b)) = (view.project(*a), view.project(*b)) else {
                    continue;
                };
                if a.1 > b.1 {
                    mem::swap(&mut a, &mut b);
                }
                let edge = Self {
                    ends: [a.0, b.0],
                    depths: [a.1, b.1],
                };
                let least = found.map_or(LEAST_DISPLACEMENT, |found| found.displacement());
                let inside = edge.ends.iter().all(|end| picture.nearest(*end) == *end);
                let middle = 0.5 * (a.1 + b.1);
                let hidden = || {
                    let seen = renderer.evaluation_seen(edge.in_space(0.5));
                    seen.is_some_and(|seen| seen.depth < (1.0 - SAME_DEPTH) * middle)
                };
                let deep = b.1 > LEAST_RATIO * a.1;
                if inside && deep && edge.displacement() > least && !hidden() {
                    found = Some(edge);
                }
            }
        }
        found
    }
}

/// Measures the difference between intensities interpolated in the picture and perspective-correct ones.
pub fn perspective(renderer: &mut Renderer, scene: &Scene) -> Measurement<PerspectiveDistortion> {
    interpolates(scene)?;
    if scene.camera.projection == Projection::Orthographic {
        return Err("picture-missing-parallel");
    }
    let interpolation = match scene.shading.interpolation {
        Interpolation::Perspective => Interpolation::Affine,
        other => other,
    };
    let [own, correct] = [interpolation, Interpolation::Perspective].map(|interpolation| {
        let mut other = scene.clone();
        other.shading.interpolation = interpolation;
        renderer.linear_picture(&other)
    });
    let picture = |pixels| LinearPicture {
        width: scene.image.size[0],
        pixels,
        clamps: scene.clamps(),
    };
    Ok(PerspectiveDistortion {
        interpolation,
        error: error_figures(picture(&own), picture(&correct)),
        edge: DeepEdge::find(renderer, scene),
    })
}

/// Change of one point's shade while the picture is rotated.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Orientation {
    /// The point followed, world.
    pub point: DVec3,
    /// The picture's own roll, degrees from 0 to 360.
    pub roll: f64,
    /// Luminance at the point for every roll.
    pub samples: Vec<Turned>,
    /// Difference between the maximum and the minimum by scan-line interpolation, and by barycentric weights.
    pub spread: [f64; 2],
}

/// One orientation of the picture.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Turned {
    /// The camera's roll, degrees.
    pub angle: f64,
    /// Luminance by scan-line interpolation; none where the point is not visible.
    pub scanline: Option<f64>,
    /// Luminance by barycentric weights.
    pub barycentric: Option<f64>,
}

/// Measures the change of the intensity at the point seen in `pixel` while the picture is rotated.
pub fn orientation(
    renderer: &mut Renderer,
    scene: &Scene,
    pixel: [u32; 2],
) -> Measurement<Orientation> {
    interpolates(scene)?;
    let missed = "picture-missing-background";
    let point = probe(renderer, scene, pixel[0], pixel[1])
        .hit
        .ok_or(missed)?
        .position;
    let triangle = renderer.triangle_at(pixel).ok_or(missed)?;
    let mut turned = scene.clone();
    turned.image.size = [SIDE; 2];
    // Shadows would be those of the small picture's pixels.
    turned.shading.shadows = false;
    let equations = renderer.shining_equations(&turned);
    let samples: Vec<Turned> = (0..=360 / STEP)
        .map(|step| {
            turned.camera.roll = f64::from(step * STEP);
            let [scanline, barycentric] =
                [Interpolation::Scanline, Interpolation::Affine].map(|interpolation| {
                    turned.shading.interpolation = interpolation;
                    turned_value(renderer, &turned, &equations, triangle, point)
                });
            Turned {
                angle: turned.camera.roll,
                scanline,
                barycentric,
            }
        })
        .collect();
    let spread = |of: fn(&Turned) -> Option<f64>| {
        let values = samples.iter().filter_map(of);
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| {
            (l.min(v), h.max(v))
        });
        (high - low).max(0.0)
    };
    let spread = [
        spread(|turned| turned.scanline),
        spread(|turned| turned.barycentric),
    ];
    Ok(Orientation {
        point,
        roll: scene.camera.roll.rem_euclid(360.0),
        samples,
        spread,
    })
}

/// Returns the luminance of `point` on `triangle`, which is visible there in every rotated picture.
fn turned_value(
    renderer: &Renderer,
    turned: &Scene,
    equations: &[Equation<f64>],
    triangle: u32,
    point: DVec3,
) -> Option<f64> {
    let (place, _) = View::new(&turned.camera, turned.image.size).project(point)?;
    let inside = place.cmpge(DVec2::ZERO).all() && place.max_element() < f64::from(SIDE);
    let intensity = renderer
        .intensity_turned(turned, equations, triangle, place)
        .filter(|_| inside)?;
    Some(luminance(intensity.max(Rgb::ZERO)))
}

/// Quality of the vertex normals as an approximation of the surface's.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct VertexNormals {
    /// Maximum angle between a face and a vertex normal that it is shaded with, degrees.
    pub greatest_angle: f64,
    /// Mean of that angle over the corners of all faces, degrees.
    pub mean_angle: f64,
    /// Standard deviation of the luminance over the object, in the picture.
    pub contrast: f64,
    /// Standard deviation of the luminance in the true picture.
    pub true_contrast: f64,
}

/// Measures the angles between vertex normals and polygons, and the contrast of the luminance with and without averaging.
pub fn vertex_normals(renderer: &mut Renderer, scene: &Scene) -> Measurement<VertexNormals> {
    match scene.shading.mode {
        ShadingMode::Gouraud | ShadingMode::Phong => {}
        ShadingMode::Flat | ShadingMode::Interpolated => return Err("picture-missing-own-normals"),
        ShadingMode::Exact => return Err("picture-missing-exact-normals"),
    }
    let own_contrast = contrast(renderer, scene).ok_or("picture-missing-object")?;
    let mesh = renderer.mesh_shown();
    let vertices = mesh.with_vertex_normals(scene.object.normal_source(), scene.object.weighting);
    let normals = &vertices.normals;
    let of_face = |f: usize| {
        let face = mesh.face_normal(f);
        vertices
            .face(f)
            .iter()
            .filter(move |_| face.length_squared() > 0.0)
            .map(move |&vertex| {
                let normal = normals[vertex as usize].as_dvec3();
                angle(face, normal).to_degrees()
            })
    };
    let chunks = (0..mesh.face_count())
        .into_par_iter()
        .step_by(CHUNK)
        .map(|first| {
            let angles = (first..(first + CHUNK).min(mesh.face_count())).flat_map(of_face);
            angles.fold((0.0f64, 0.0, 0u32), |(most, sum, count), own| {
                (most.max(own), sum + own, count + 1)
            })
        });
    // Added in the order of the faces, in whatever order they were finished.
    let chunks: Vec<(f64, f64, u32)> = chunks.collect();
    let add = |a: (f64, f64, u32), b: &(f64, f64, u32)| (a.0.max(b.0), a.1 + b.1, a.2 + b.2);
    let (greatest_angle, sum, count) = chunks.iter().fold((0.0, 0.0, 0), add);
    let mut truth = scene.clone();
    truth.shading.mode = ShadingMode::Exact;
    if !renderer.shows_surface(&truth) {
        // Such an object has no surface beyond its polygons: each has its own normal.
        (truth.shading.mode, truth.object.normals) = (ShadingMode::Phong, NormalSource::Facet);
    }
    let true_contrast = contrast(renderer, &truth).unwrap_or_default();
    Ok(VertexNormals {
        greatest_angle,
        mean_angle: sum / f64::from(count.max(1)),
        contrast: own_contrast,
        true_contrast,
    })
}

/// Returns the standard deviation of the luminance over the pixels that show the object.
fn contrast(renderer: &mut Renderer, scene: &Scene) -> Option<f64> {
    let (mut count, mut mean, mut squares) = (0.0, 0.0, 0.0);
    for pixel in renderer
        .linear_picture(scene)
        .iter()
        .filter(|pixel| pixel[3] > 0.0)
    {
        // Welford 1962: the mean and the squares about it in one pass.
        let value = pixel_luminance(pixel);
        count += 1.0;
        let off = value - mean;
        mean += off / count;
        squares += off * (value - mean);
    }
    (count > 0.0).then(|| (squares / count).sqrt())
}
