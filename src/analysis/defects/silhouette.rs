//! How far the polygons' outline is from the true surface's.

use super::{Finding, STOPPED, edges_of_one};
use crate::analysis::Watch;
use crate::geometry::Mesh;
use crate::render::Renderer;
use crate::scene::{Projection, Scene, ShadingMode, View};
use glam::{DVec2, DVec3};
use rayon::prelude::*;
use serde::Serialize;

/// Samples along an edge of the outline, its middle among them.
const SAMPLES: u32 = 7;
/// An outline has the background this far outside and the object this far inside, pixels.
const BESIDE: f64 = 1.5;
/// The first step across an edge in search of the true outline, and the greatest, pixels: no part of the object that is as wide
/// as a pixel is stepped over.
const STEPS: [f64; 2] = [0.25, 1.0];
/// Most edges of the outline that are looked at: of more, every second, every third and so on.
const MOST_EDGES: usize = 2048;
/// To what the place of the true outline is found, pixels.
const PRECISION: f64 = 1e-3;

/// The polygonal silhouette.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Silhouette {
    /// Greatest distance between the two outlines across the polygons' edges, pixels.
    pub greatest: f64,
    /// Where it is on the polygons' outline, pixels.
    pub polygon: DVec2,
    /// Where it is on the true one.
    pub surface: DVec2,
    /// Edges of the outline that were looked at.
    pub edges: usize,
}

/// Edges of the mesh that are seen with a front face on one side only, as pairs of points in the picture.
fn outline(mesh: &Mesh, scene: &Scene, view: &View) -> Vec<[DVec2; 2]> {
    let world = |point: u32| mesh.origin + mesh.positions[point as usize].as_dvec3();
    let front = |f: usize| {
        let towards = match scene.camera.projection {
            Projection::Perspective => view.eye - mesh.face_centre(f),
            Projection::Orthographic => -view.forward,
        };
        mesh.face_normal(f).dot(towards) > 0.0
    };
    let place = |point: DVec3| view.project(point).map(|(pixel, _)| pixel);
    let edges = edges_of_one(mesh, front);
    edges.into_iter().filter_map(|[a, b]| Some([place(world(a))?, place(world(b))?])).collect()
}

/// What of a picture shows the object.
struct Mask {
    seen: Vec<bool>,
    size: [u32; 2],
}

impl Mask {
    /// Whether the pixel at a place shows it; nothing outside the picture.
    fn at(&self, place: DVec2) -> Option<bool> {
        let [width, height] = self.size;
        let inside = place.cmpge(DVec2::ZERO).all() && place.x < f64::from(width) && place.y < f64::from(height);
        inside.then(|| self.seen[place.y as usize * width as usize + place.x as usize])
    }
}

pub(super) fn measure(renderer: &mut Renderer, scene: &Scene, watch: &dyn Watch<()>) -> Finding<Silhouette> {
    let mut polygons = scene.clone();
    polygons.shading.mode = ShadingMode::Flat;
    renderer.keep_linear(true);
    renderer.render(&polygons);
    renderer.keep_linear(false);
    let mask = Mask { seen: renderer.linear().iter().map(|p| p[3] > 0.0).collect(), size: scene.image.size };
    let view = View::new(&scene.camera, scene.image.size);
    let mut edges = outline(renderer.mesh_shown(), scene, &view);
    let every = edges.len().div_ceil(MOST_EDGES).max(1);
    edges = edges.into_iter().step_by(every).collect();
    let mut exact = scene.clone();
    exact.shading.mode = ShadingMode::Exact;
    if !renderer.shows_surface(&exact) {
        return Err("the object has no surface beyond its polygons");
    }
    let renderer = &*renderer;
    let sees = |place: DVec2| renderer.evaluation_at(place, None).is_some();
    let of_edge = |&[a, b]: &[DVec2; 2]| {
        if !watch.at(0.0) {
            return None;
        }
        let along = b - a;
        let across = along.perp().try_normalize()?;
        let samples = (1..=SAMPLES).map(|i| a + along * (f64::from(i) / f64::from(SAMPLES + 1)));
        let found = samples.filter_map(|place| {
            let outwards = match (mask.at(place + BESIDE * across)?, mask.at(place - BESIDE * across)?) {
                (false, true) => across,
                (true, false) => -across,
                _ => return None,
            };
            let reach = DVec2::from_array(scene.image.size.map(f64::from)).length();
            Some((distance(place, outwards, reach, |place| mask.at(place), sees)?, place, outwards))
        });
        found.max_by(|a, b| a.0.abs().total_cmp(&b.0.abs()))
    };
    let found: Vec<(f64, DVec2, DVec2)> = edges.par_iter().filter_map(of_edge).collect();
    if !watch.at(0.0) {
        return Err(STOPPED);
    }
    let edges = found.len();
    let greatest = found.into_iter().reduce(|a, b| if b.0.abs() > a.0.abs() { b } else { a });
    let (distance, polygon, outwards) = greatest.ok_or("no outline of the object is in the picture")?;
    Ok(Silhouette { greatest: distance.abs(), polygon, surface: polygon + distance * outwards, edges })
}

/// How far the true outline is from `place` along `outwards`; negative inside. Nothing where there is none within `reach`, or none
/// before the polygons' outline on the other side, that of another part of the object: `shown` says where the polygons are.
fn distance(
    place: DVec2,
    outwards: DVec2,
    reach: f64,
    shown: impl Fn(DVec2) -> Option<bool>,
    sees: impl Fn(DVec2) -> bool,
) -> Option<f64> {
    let inside = sees(place);
    let way = if inside { 1.0 } else { -1.0 };
    let at = |t: f64| place + way * t * outwards;
    let [first, longest] = STEPS;
    let (mut near, mut far) = (0.0, first);
    while sees(at(far)) == inside {
        if far > reach || (far > BESIDE && shown(at(far)) == Some(inside)) {
            return None;
        }
        near = far;
        far += (0.5 * far).min(longest);
    }
    while far - near > PRECISION {
        let middle = 0.5 * (near + far);
        if sees(at(middle)) == inside {
            near = middle;
        } else {
            far = middle;
        }
    }
    Some(way * 0.5 * (near + far))
}
