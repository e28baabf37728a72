//! What happens along an edge where one side has a vertex and the other has none.

use super::{Finding, STOPPED, edges_of_one, nothing_interpolated};
use crate::analysis::{Watch, luminance};
use crate::geometry::Mesh;
use crate::illumination::Equation;
use crate::render::{Piece, Renderer};
use crate::scene::{Rgb, Scene, View};
use glam::{DVec2, DVec3};
use serde::Serialize;

/// Samples along an edge.
const SAMPLES: u32 = 200;
/// A vertex is on an edge when it is nearer to it than this share of its length.
const ON: f64 = 1e-6;
/// How far beside the edge the two sides are looked for, pixels.
const BESIDE: f64 = 0.25;
/// Most pairs of a vertex and an edge on borders that are looked at.
const MOST: usize = 20_000_000;
/// Work on the edges that are measured, in corners of the mesh that are looked through; of edges that would take more, every
/// second, every third and so on is measured.
const MOST_WORK: usize = 40_000_000;
/// As many are measured in any case.
const LEAST_EDGES: usize = 16;
/// What a source costs at a place of an edge, in corners.
const PER_SOURCE: usize = 20;

/// The jump at a vertex that is not shared.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SharedVertices {
    /// Edges with a vertex that one of their sides does not share.
    pub edges: usize,
    /// How many of them were measured: all, or an even choice where there are very many.
    pub measured: usize,
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

impl SharedVertices {
    /// How many edges there are, and how many of them were measured if not all.
    pub fn edges_in_words(&self) -> String {
        match (self.edges, self.measured) {
            (1, _) => "1 edge".to_owned(),
            (edges, measured) if measured < edges => format!("{edges} edges, {measured} of them measured"),
            (edges, _) => format!("{edges} edges"),
        }
    }
}

/// The edges with vertices on them. An edge that has a face on either side has none: both faces end at its ends.
fn touched(mesh: &Mesh) -> Finding<Vec<Touched>> {
    let world = |point: u32| mesh.origin + mesh.positions[point as usize].as_dvec3();
    // Where every edge has a face on either side there is none to look at.
    let open = if mesh.closed { Vec::new() } else { edges_of_one(mesh, |_| true) };
    let mut points: Vec<u32> = open.iter().flatten().copied().collect();
    points.sort_unstable();
    points.dedup();
    if points.len().saturating_mul(open.len()) > MOST {
        return Err("the object has too many borders to be looked at for unshared vertices");
    }
    let mut faces = vec![0; open.len()];
    for f in 0..mesh.face_count() {
        let face = mesh.face(f);
        for (a, b) in face.iter().zip(face.iter().cycle().skip(1)) {
            let key = [a.position.min(b.position), a.position.max(b.position)];
            if let Ok(edge) = open.binary_search(&key) {
                faces[edge] = f;
            }
        }
    }
    let mut found = Vec::new();
    for (&[a, b], f) in open.iter().zip(faces) {
        let ends = [world(a), world(b)];
        let along = ends[1] - ends[0];
        let own = |point: u32| mesh.face(f).iter().any(|corner| world(corner.position) == world(point));
        for &point in &points {
            let from = world(point) - ends[0];
            let t = from.dot(along) / along.length_squared();
            let on = t > ON && t < 1.0 - ON && (from - t * along).length() < ON * along.length();
            if on && !own(point) {
                found.push(Touched { face: f as u32, ends, vertex: world(point) });
            }
        }
    }
    Ok(found)
}

pub(super) fn measure(renderer: &mut Renderer, scene: &Scene, watch: &dyn Watch<()>) -> Finding<SharedVertices> {
    if let Some(why) = nothing_interpolated(scene) {
        return Err(why);
    }
    renderer.render(scene);
    let touched = touched(renderer.mesh_shown())?;
    if touched.is_empty() {
        return Err("every vertex on an edge is shared by both of its sides");
    }
    let edges = touched.len();
    let equation = renderer.shining_equation(scene);
    let mesh = renderer.mesh_shown();
    let each = mesh.corners.len() + SAMPLES as usize * PER_SOURCE * (1 + equation.sources.len());
    let every = edges.div_ceil((MOST_WORK / each).max(LEAST_EDGES));
    let count = edges.div_ceil(every);
    let mut greatest: Option<SharedVertices> = None;
    for (index, edge) in touched.iter().step_by(every).enumerate() {
        if !watch.at(index as f32 / count as f32) {
            return Err(STOPPED);
        }
        let measured = along(renderer, scene, &equation, edge, [edges, count]);
        let before = greatest.as_ref().map_or(f64::NEG_INFINITY, |greatest| greatest.greatest);
        greatest = measured.filter(|measured| measured.greatest > before).or(greatest);
    }
    greatest.ok_or("no such edge is seen")
}

/// The luminance on both sides of an edge.
fn along(
    renderer: &Renderer,
    scene: &Scene,
    equation: &Equation<f64>,
    edge: &Touched,
    [edges, measured]: [usize; 2],
) -> Option<SharedVertices> {
    let view = View::new(&scene.camera, scene.image.size);
    let [a, b] = edge.ends.map(|end| view.project(end).map(|(place, _)| place));
    let (a, b) = (a?, b?);
    let (vertex, _) = view.project(edge.vertex)?;
    let vertex = (vertex - a).dot(b - a) / (b - a).length_squared();
    let across = (b - a).perp().try_normalize()?;
    let sides = [1.0, -1.0].map(|way| renderer.section(a + way * BESIDE * across, b + way * BESIDE * across));
    let piece = |side: &[Piece], s: f64| side.iter().find(|piece| (piece.from..piece.to).contains(&s)).copied();
    let value = |place: DVec2, piece: &Piece| {
        let evaluation = renderer.evaluation_at(place, Some(piece))?;
        Some(luminance(evaluation.intensity(equation).max(Rgb::ZERO)))
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
    (!samples.is_empty()).then_some(SharedVertices { edges, measured, greatest, at, samples, vertex })
}
