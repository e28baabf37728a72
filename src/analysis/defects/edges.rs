//! Defects of edges: the polygonal silhouette, and edges with a vertex on one side only.

use super::{Measurement, goes_on, interpolates};
use crate::analysis::Watch;
use crate::analysis::perception::luminance;
use crate::geometry::Mesh;
use crate::illumination::Equation;
use crate::render::{Piece, Renderer};
use crate::scene::{Projection, Rgb, Scene, ShadingMode, View};
use glam::{DVec2, DVec3};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// Number of samples along an edge of the outline, its middle among them.
const OUTLINE_SAMPLES: u32 = 7;
/// Distance of an outline from the background outside and from the object inside at which these must appear, pixels.
const OUTLINE: f64 = 1.5;
/// First and longest step in search of the true outline, pixels: nothing as wide as a pixel is skipped.
const STEPS: [f64; 2] = [0.25, 1.0];
/// Maximum number of outline edges examined: of more, every second, every third and so on.
const MOST_OUTLINE: usize = 2048;
/// Precision of the true outline's position, pixels.
const PRECISION: f64 = 1e-3;
/// Number of samples along an edge with an unshared vertex.
const SAMPLES: u32 = 200;
/// Share of an edge's length within which a vertex lies on it.
const ON: f64 = 1e-6;
/// Distance from the edge at which its two sides are sampled, pixels.
const BESIDE: f64 = 0.25;
/// Maximum number of examined pairs of a vertex and an edge on borders.
const MOST: usize = 20_000_000;
/// Maximum work on measured edges, in corners examined; of more, every second, every third and so on is measured.
const MOST_WORK: usize = 40_000_000;
/// Minimum number of edges measured in any case.
const LEAST_EDGES: usize = 16;
/// Cost of a light source at a place of an edge, in corners.
const PER_SOURCE: usize = 20;

/// Distance of the polygons' outline from the true surface's.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Silhouette {
    /// Maximum distance between the two outlines across the polygons' edges, pixels.
    pub greatest: f64,
    /// Its end on the polygons' outline, pixels.
    pub polygon: DVec2,
    /// Its end on the true outline, pixels.
    pub surface: DVec2,
    /// Number of outline edges examined.
    pub edges: usize,
}

/// Jump of the luminance at a vertex that is not shared.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SharedVertices {
    /// Number of edges with a vertex that one of their sides does not share.
    pub edges: usize,
    /// Number of them that were measured: all, or an even choice where there are very many.
    pub measured: usize,
    /// Maximum jump of the luminance across such an edge.
    pub greatest: f64,
    /// Position of that jump, pixels.
    pub at: DVec2,
    /// Samples along that edge: the place from 0 to 1, and the luminance on the side without the vertex and with it.
    pub samples: Vec<[f64; 3]>,
    /// Position of the vertex on that edge, from 0 to 1.
    pub vertex: f64,
}

/// Returns the edges of a face, as pairs of points, the lower index first.
fn edges_of(mesh: &Mesh, face: usize) -> impl Iterator<Item = [u32; 2]> {
    let corners = mesh.face(face);
    let pairs = corners.iter().zip(corners.iter().cycle().skip(1));
    pairs.map(|(a, b)| [a.position.min(b.position), a.position.max(b.position)])
}

/// Returns the edges that belong to exactly one of the faces accepted by `counts`, sorted.
fn edges_of_one(mesh: &Mesh, counts: impl Fn(usize) -> bool + Sync) -> Vec<[u32; 2]> {
    let faces = (0..mesh.face_count())
        .into_par_iter()
        .filter(|f| counts(*f));
    let mut all: Vec<[u32; 2]> = faces.flat_map_iter(|f| edges_of(mesh, f)).collect();
    all.par_sort_unstable();
    all.chunk_by(|a, b| a == b)
        .filter(|alike| alike.len() == 1)
        .map(|alike| alike[0])
        .collect()
}

fn world(mesh: &Mesh, point: u32) -> DVec3 {
    mesh.origin + mesh.positions[point as usize].as_dvec3()
}

/// Measures the distance between the polygons' outline and the true surface's.
pub fn silhouette(
    renderer: &mut Renderer,
    scene: &Scene,
    watch: &dyn Watch<()>,
) -> Measurement<Silhouette> {
    let mut drawn = scene.clone();
    drawn.shading.mode = ShadingMode::Flat;
    let seen: Vec<bool> = renderer
        .linear_picture(&drawn)
        .iter()
        .map(|pixel| pixel[3] > 0.0)
        .collect();
    let size = scene.image.size;
    // Whether the pixel at a place shows the object; none outside the picture.
    let shown = |place: DVec2| {
        let inside = place.cmpge(DVec2::ZERO).all()
            && place.cmplt(DVec2::from_array(size.map(f64::from))).all();
        inside.then(|| seen[place.y as usize * size[0] as usize + place.x as usize])
    };
    let mut edges = outline(renderer.mesh_shown(), scene);
    let every = edges.len().div_ceil(MOST_OUTLINE).max(1);
    edges = edges.into_iter().step_by(every).collect();
    drawn.shading.mode = ShadingMode::Exact;
    if !renderer.shows_surface(&drawn) {
        return Err("picture-missing-surface");
    }
    let renderer = &*renderer;
    let sees = |place: DVec2| renderer.evaluation_at(place, None).is_some();
    let reach = DVec2::from_array(size.map(f64::from)).length();
    let of_edge = |&[a, b]: &[DVec2; 2]| {
        if !watch.progress(0.0) {
            return None;
        }
        let along = b - a;
        let across = along.perp().try_normalize()?;
        let samples = (1..=OUTLINE_SAMPLES)
            .map(|i| a + along * (f64::from(i) / f64::from(OUTLINE_SAMPLES + 1)));
        let found = samples.filter_map(|place| {
            let outwards = match (
                shown(place + OUTLINE * across)?,
                shown(place - OUTLINE * across)?,
            ) {
                (false, true) => across,
                (true, false) => -across,
                _ => return None,
            };
            let distance = distance(place, outwards, reach, shown, sees)?;
            Some((distance, place, outwards))
        });
        found.max_by(|a, b| a.0.abs().total_cmp(&b.0.abs()))
    };
    let found: Vec<(f64, DVec2, DVec2)> = edges.par_iter().filter_map(of_edge).collect();
    goes_on(watch, 0.0)?;
    let edges = found.len();
    let larger = |a: (f64, _, _), b: (f64, _, _)| if b.0.abs() > a.0.abs() { b } else { a };
    let greatest = found.into_iter().reduce(larger);
    let (distance, polygon, outwards) = greatest.ok_or("picture-missing-outline")?;
    Ok(Silhouette {
        greatest: distance.abs(),
        polygon,
        surface: polygon + distance * outwards,
        edges,
    })
}

/// Returns the edges of the mesh that have a visible front face on one side only, as pairs of points in the picture.
fn outline(mesh: &Mesh, scene: &Scene) -> Vec<[DVec2; 2]> {
    let view = View::new(&scene.camera, scene.image.size);
    let front = |f: usize| {
        let towards = match scene.camera.projection {
            Projection::Perspective => view.eye - mesh.face_centre(f),
            Projection::Orthographic => -view.forward,
        };
        mesh.face_normal(f).dot(towards) > 0.0
    };
    let place = |point: u32| view.project(world(mesh, point)).map(|(pixel, _)| pixel);
    edges_of_one(mesh, front)
        .into_iter()
        .filter_map(|[a, b]| Some([place(a)?, place(b)?]))
        .collect()
}

/// Finds the distance of the true outline from `place` along `outwards`, negative inside; none if there is none within
/// `reach` or before the outline of another part of the object: `shown` tells where the polygons are.
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
        if far > reach || (far > OUTLINE && shown(at(far)) == Some(inside)) {
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

/// A T-vertex: a vertex on an edge of a face that does not have it.
#[derive(Clone, Copy, Debug)]
struct TVertex {
    face: u32,
    ends: [DVec3; 2],
    vertex: DVec3,
}

/// Finds the T-vertices; an edge with a face on either side has none, since both faces end at its ends.
fn t_vertices(mesh: &Mesh) -> Measurement<Vec<TVertex>> {
    // If every edge has a face on either side, there is none to examine.
    let open = if mesh.closed {
        Vec::new()
    } else {
        edges_of_one(mesh, |_| true)
    };
    let mut points: Vec<u32> = open.iter().flatten().copied().collect();
    points.sort_unstable();
    points.dedup();
    if points.len().saturating_mul(open.len()) > MOST {
        return Err("picture-missing-borders");
    }
    let mut faces = vec![0; open.len()];
    for f in 0..mesh.face_count() {
        for edge in edges_of(mesh, f).filter_map(|edge| open.binary_search(&edge).ok()) {
            faces[edge] = f;
        }
    }
    let mut found = Vec::new();
    for (edge, f) in open.iter().zip(faces) {
        let ends = edge.map(|end| world(mesh, end));
        let along = ends[1] - ends[0];
        let own = |vertex: DVec3| {
            mesh.face(f)
                .iter()
                .any(|corner| world(mesh, corner.position) == vertex)
        };
        for &point in &points {
            let vertex = world(mesh, point);
            let from = vertex - ends[0];
            let t = from.dot(along) / along.length_squared();
            let on = t > ON && t < 1.0 - ON && (from - t * along).length() < ON * along.length();
            if on && !own(vertex) {
                found.push(TVertex {
                    face: f as u32,
                    ends,
                    vertex,
                });
            }
        }
    }
    Ok(found)
}

/// Measures the largest jump of the luminance at a T-vertex.
pub fn shared_vertices(
    renderer: &mut Renderer,
    scene: &Scene,
    watch: &dyn Watch<()>,
) -> Measurement<SharedVertices> {
    interpolates(scene)?;
    renderer.render(scene);
    let mesh = renderer.mesh_shown();
    let found = t_vertices(mesh)?;
    if found.is_empty() {
        return Err("picture-missing-unshared");
    }
    let edges = found.len();
    let equations = renderer.shining_equations(scene);
    let each =
        mesh.corners.len() + SAMPLES as usize * PER_SOURCE * (1 + equations[0].sources.len());
    let every = edges.div_ceil((MOST_WORK / each).max(LEAST_EDGES));
    let count = edges.div_ceil(every);
    let mut greatest: Option<SharedVertices> = None;
    for (index, edge) in found.iter().step_by(every).enumerate() {
        goes_on(watch, index as f32 / count as f32)?;
        if let Some(measured) = along(renderer, scene, &equations, edge, [edges, count])
            && greatest
                .as_ref()
                .is_none_or(|before| measured.greatest > before.greatest)
        {
            greatest = Some(measured);
        }
    }
    greatest.ok_or("picture-missing-edge")
}

/// Samples the luminance on both sides of an edge.
fn along(
    renderer: &Renderer,
    scene: &Scene,
    equations: &[Equation<f64>],
    edge: &TVertex,
    [edges, measured]: [usize; 2],
) -> Option<SharedVertices> {
    let view = View::new(&scene.camera, scene.image.size);
    let place = |point: DVec3| view.project(point).map(|(place, _)| place);
    let [a, b, vertex] = [
        place(edge.ends[0])?,
        place(edge.ends[1])?,
        place(edge.vertex)?,
    ];
    let vertex = (vertex - a).dot(b - a) / (b - a).length_squared();
    let across = (b - a).perp().try_normalize()?;
    let sides = [1.0, -1.0]
        .map(|way| renderer.section(a + way * BESIDE * across, b + way * BESIDE * across));
    let piece = |side: &[Piece], s: f64| {
        side.iter()
            .find(|piece| (piece.from..piece.to).contains(&s))
            .copied()
    };
    let value = |place: DVec2, piece: &Piece| {
        let evaluation = renderer.evaluation_at(place, Some(piece))?;
        Some(luminance(evaluation.intensity(equations).max(Rgb::ZERO)))
    };
    let mut samples = Vec::new();
    let (mut greatest, mut at) = (0.0, a.lerp(b, vertex));
    let mut along: Vec<f64> = (0..=SAMPLES)
        .map(|i| f64::from(i) / f64::from(SAMPLES))
        .chain([vertex])
        .collect();
    along.sort_by(f64::total_cmp);
    for s in along {
        let place = a.lerp(b, s);
        let [Some(p), Some(q)] = [piece(&sides[0], s), piece(&sides[1], s)] else {
            continue;
        };
        let (Some(u), Some(v)) = (value(place, &p), value(place, &q)) else {
            continue;
        };
        // First the side without the vertex.
        let (without, with) = if p.face == edge.face { (u, v) } else { (v, u) };
        samples.push([s, without, with]);
        if (u - v).abs() > greatest {
            (greatest, at) = ((u - v).abs(), place);
        }
    }
    (!samples.is_empty()).then_some(SharedVertices {
        edges,
        measured,
        greatest,
        at,
        samples,
        vertex,
    })
}
