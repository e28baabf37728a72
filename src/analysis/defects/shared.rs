//! What happens along an edge where one side has a vertex and the other has none.

use super::{Finding, nothing_interpolated};
use crate::analysis::luminance;
use crate::geometry::Mesh;
use crate::illumination::Equation;
use crate::render::{Piece, Renderer};
use crate::scene::{Rgb, Scene, View};
use glam::{DVec2, DVec3};
use serde::Serialize;
use std::collections::{BTreeSet, HashMap};

/// Samples along an edge.
const SAMPLES: u32 = 200;
/// A vertex is on an edge when it is nearer to it than this share of its length.
const ON: f64 = 1e-6;
/// How far beside the edge the two sides are looked for, pixels.
const BESIDE: f64 = 0.25;
/// Most pairs of a vertex and an edge on borders that are looked at.
const MOST: usize = 20_000_000;

/// The jump at a vertex that is not shared.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SharedVertices {
    /// Edges with a vertex that one of their sides does not share.
    pub edges: usize,
    /// Greatest jump of the luminance across such an edge.
    pub greatest: f64,
    /// Where it is, pixels.
    pub at: DVec2,
    /// Along the edge that has it: the place from 0 to 1, and the luminance on the side that has not the vertex and on the one
    /// that has it.
    pub samples: Vec<[f64; 3]>,
    /// Where the vertex appears on that edge, from 0 to 1.
    pub vertex: f64,
}

/// An edge of a face, and a vertex on it that the face has not.
#[derive(Clone, Copy, Debug)]
struct Touched {
    face: u32,
    ends: [DVec3; 2],
    vertex: DVec3,
}

/// The edges with vertices on them. An edge that has a face on either side has none: both faces end at its ends.
fn touched(mesh: &Mesh) -> Finding<Vec<Touched>> {
    let world = |point: u32| mesh.origin + mesh.positions[point as usize].as_dvec3();
    let mut sides: HashMap<(u32, u32), (usize, u32)> = HashMap::new();
    for f in 0..mesh.face_count() {
        let face = mesh.face(f);
        for (a, b) in face.iter().zip(face.iter().cycle().skip(1)) {
            let key = (a.position.min(b.position), a.position.max(b.position));
            sides.entry(key).or_insert((f, 0)).1 += 1;
        }
    }
    let mut open: Vec<_> =
        sides.into_iter().filter(|(_, (_, faces))| *faces == 1).map(|(key, (f, _))| (key, f)).collect();
    open.sort_unstable();
    let points: BTreeSet<u32> = open.iter().flat_map(|((a, b), _)| [*a, *b]).collect();
    if points.len().saturating_mul(open.len()) > MOST {
        return Err("the object has too many borders to be looked at for unshared vertices");
    }
    let mut found = Vec::new();
    for ((a, b), f) in open {
        let ends = [world(a), world(b)];
        let along = ends[1] - ends[0];
        let own = |point: u32| mesh.face(f).iter().any(|corner| world(corner.position) == world(point));
        for &point in points.iter().filter(|&&point| !own(point)) {
            let from = world(point) - ends[0];
            let t = from.dot(along) / along.length_squared();
            if t > ON && t < 1.0 - ON && (from - t * along).length() < ON * along.length() {
                found.push(Touched { face: f as u32, ends, vertex: world(point) });
            }
        }
    }
    Ok(found)
}

pub(super) fn measure(renderer: &mut Renderer, scene: &Scene) -> Finding<SharedVertices> {
    if let Some(why) = nothing_interpolated(scene) {
        return Err(why);
    }
    renderer.render(scene);
    let touched = touched(renderer.mesh())?;
    if touched.is_empty() {
        return Err("every vertex on an edge is shared by both of its sides");
    }
    let edges = touched.len();
    let measured = touched.iter().filter_map(|edge| along(renderer, scene, edge, edges));
    let greatest = measured.reduce(|a, b| if b.greatest > a.greatest { b } else { a });
    greatest.ok_or("no such edge is seen")
}

/// The luminance on both sides of an edge.
fn along(renderer: &Renderer, scene: &Scene, edge: &Touched, edges: usize) -> Option<SharedVertices> {
    let view = View::new(&scene.camera, scene.image.size);
    let [a, b] = edge.ends.map(|end| view.project(end).map(|(place, _)| place));
    let (a, b) = (a?, b?);
    let (vertex, _) = view.project(edge.vertex)?;
    let vertex = (vertex - a).dot(b - a) / (b - a).length_squared();
    let across = (b - a).perp().try_normalize()?;
    let mut equation = Equation::<f64>::new(scene);
    if let Some(plan) = renderer.plan() {
        equation.retain_lights(|light| plan.lights[light]);
    }
    let sides = [1.0, -1.0].map(|way| renderer.section(a + way * BESIDE * across, b + way * BESIDE * across));
    let piece = |side: &[Piece], s: f64| side.iter().find(|piece| (piece.from..piece.to).contains(&s)).copied();
    let value = |place: DVec2, piece: &Piece| {
        let evaluation = renderer.evaluation_at(place, Some(piece))?;
        Some(luminance(evaluation.intensity(&equation).max(Rgb::ZERO)))
    };
    let mut samples = Vec::new();
    let (mut greatest, mut at) = (0.0, a.lerp(b, vertex));
    let mut along: Vec<f64> = (0..=SAMPLES).map(|i| f64::from(i) / f64::from(SAMPLES)).chain([vertex]).collect();
    along.sort_by(f64::total_cmp);
    for s in along {
        let place = a.lerp(b, s);
        let [Some(p), Some(q)] = [piece(&sides[0], s), piece(&sides[1], s)] else { continue };
        let (Some(u), Some(v)) = (value(place, &p), value(place, &q)) else { continue };
        // First the side that has not the vertex.
        let (without, with) = if p.face == edge.face { (u, v) } else { (v, u) };
        samples.push([s, without, with]);
        if (u - v).abs() > greatest {
            (greatest, at) = ((u - v).abs(), place);
        }
    }
    (!samples.is_empty()).then_some(SharedVertices { edges, greatest, at, samples, vertex })
}
