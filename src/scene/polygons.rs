//! Polygons listed in the scene itself, and the conditions under which they can be drawn.
//!
//! A polygon is examined as it appears along its own normal (Newell's): it need not be plane, but seen that way it must
//! have an area, and its edges may meet only in its corners. A straight corner counts as a corner, so that a vertex of one
//! polygon may lie on the edge of another.

use super::Object;
use super::format::list_of;
use super::parameter::{LEAST_LENGTH, at_most};
use super::shared::Shared;
use super::validation::{Checks, direction_outside, point_outside};
use crate::text::text;
use glam::{DVec2, DVec3};
use std::sync::LazyLock;

/// The part of a polygon's extent below which two edges touch: the rounding of a distance.
const TOUCH: f64 = 1e-9;

/// Polygons over shared vertices.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Polygons {
    /// The vertices, world.
    pub vertices: Shared<DVec3>,
    /// The vertices of each polygon, counter-clockwise from outside.
    pub faces: Shared<Shared<u32>>,
    /// One normal for each vertex, of any length but zero; or none.
    pub normals: Shared<DVec3>,
}

/// The polygons of a scene that has none of its own: a quadrilateral of four unequal sides.
static QUADRILATERAL: LazyLock<Polygons> = LazyLock::new(|| {
    let corners = [[-0.9, -0.6], [0.7, -0.8], [0.85, 0.4], [-0.5, 0.75]];
    Polygons {
        vertices: corners
            .into_iter()
            .map(|[x, y]| DVec3::new(x, y, 0.0))
            .collect(),
        faces: Shared::from(vec![Shared::from(vec![0, 1, 2, 3])]),
        normals: Shared::default(),
    }
});

impl Object {
    /// The most vertices of polygons in a scene, and the most polygons: their text is then shorter than
    /// [`Scene::MAX_TEXT`](super::Scene::MAX_TEXT).
    pub const MAX_POLYGONS: usize = 1 << 14;

    /// The most corners of a polygon in a scene.
    pub const MAX_CORNERS: usize = 256;

    /// The most corners of all polygons in a scene.
    pub const MAX_ALL_CORNERS: usize = 1 << 16;

    /// Returns the polygons of the kind `polygons`: those of the scene, or a quadrilateral where it has none.
    pub fn polygons(&self) -> Polygons {
        if self.vertices.is_empty() && self.faces.is_empty() {
            return QUADRILATERAL.clone();
        }
        Polygons {
            vertices: self.vertices.clone(),
            faces: self.faces.clone(),
            normals: self.vertex_normals.clone(),
        }
    }

    /// Returns the scene's own vertices for changing them. Where it has none it first gets those that are shown.
    pub fn vertices_mut(&mut self) -> &mut [DVec3] {
        self.own_polygons();
        self.vertices.make_mut()
    }

    /// Copies the result of [`Object::polygons`] into the scene, so that it can be edited.
    pub fn own_polygons(&mut self) {
        let shown = self.polygons();
        self.vertices = shown.vertices;
        self.faces = shown.faces;
        self.vertex_normals = shown.normals;
    }

    /// Reports the problems of the polygons, whether or not they are shown.
    pub(super) fn check_polygons(&self, checks: &mut Checks) {
        let Self {
            vertices,
            faces,
            vertex_normals,
            ..
        } = self;
        let mut sound = true;
        for (key, count) in [
            ("object.vertices", vertices.len()),
            ("object.faces", faces.len()),
        ] {
            if count > Self::MAX_POLYGONS {
                checks.value(key, list_of(count), at_most(Self::MAX_POLYGONS));
                sound = false;
            }
        }
        let corners: usize = faces.iter().map(|face| face.len()).sum();
        if corners > Self::MAX_ALL_CORNERS {
            checks.value(
                "object.faces",
                text!("found-corners", count = corners),
                at_most(Self::MAX_ALL_CORNERS),
            );
            sound = false;
        }
        if !sound {
            return;
        }
        for (v, vertex) in vertices.iter().enumerate() {
            sound &= checks.within(&format!("object.vertices.{v}"), point_outside(*vertex));
        }
        for (v, normal) in vertex_normals.iter().enumerate() {
            checks.within(
                &format!("object.vertex_normals.{v}"),
                direction_outside(*normal),
            );
        }
        if !vertex_normals.is_empty() && vertex_normals.len() != vertices.len() {
            let expected = text!("expected-vertex-normals", count = vertices.len());
            checks.value(
                "object.vertex_normals",
                list_of(vertex_normals.len()),
                expected,
            );
        }
        if faces.is_empty() && !vertices.is_empty() {
            checks.found("object.faces", text!("problem-no-faces"));
        }
        for (f, face) in faces.iter().enumerate() {
            check_face(&format!("object.faces.{f}"), face, vertices, sound, checks);
        }
    }
}

/// Reports the problems of a polygon; its shape is examined only if the vertices are valid.
fn check_face(key: &str, face: &[u32], vertices: &[DVec3], sound: bool, checks: &mut Checks) {
    if !(3..=Object::MAX_CORNERS).contains(&face.len()) {
        let expected = text!("expected-corners", most = Object::MAX_CORNERS);
        return checks.value(key, list_of(face.len()), expected);
    }
    let mut known = true;
    for (k, &v) in face
        .iter()
        .enumerate()
        .filter(|&(_, &v)| v as usize >= vertices.len())
    {
        known = false;
        let expected = match vertices.len() {
            0 => text!("expected-no-polygon").to_owned(),
            count => text!("expected-vertex", last = count - 1),
        };
        checks.value(&format!("{key}.{k}"), v.to_string(), expected);
    }
    if let Some(&twice) = face
        .iter()
        .enumerate()
        .find_map(|(k, v)| face[..k].contains(v).then_some(v))
    {
        return checks.value(
            key,
            text!("found-vertex-twice", vertex = twice),
            text!("expected-vertex-once"),
        );
    }
    if known
        && sound
        && let Some((found, expected)) = unsound(face, vertices)
    {
        checks.value(key, found, expected);
    }
}

impl Polygons {
    /// Finds the first polygon that cannot be drawn after vertex `moved` has been moved; only those that have it are examined.
    pub fn spoilt_by(&self, moved: u32) -> Option<usize> {
        let known = |face: &[u32]| {
            face.len() >= 3 && face.iter().all(|&v| (v as usize) < self.vertices.len())
        };
        let spoilt = |face: &[u32]| {
            face.contains(&moved) && known(face) && unsound(face, &self.vertices).is_some()
        };
        self.faces.iter().position(|face| spoilt(face))
    }
}

/// Tells why a polygon of different, known vertices cannot be drawn: its fault, and what was expected.
fn unsound(face: &[u32], vertices: &[DVec3]) -> Option<(String, &'static str)> {
    let no_area = || (text!("found-no-area").to_owned(), text!("expected-area"));
    let first = vertices[face[0] as usize];
    let mut offsets: Vec<DVec3> = face.iter().map(|&v| vertices[v as usize] - first).collect();
    let extent = offsets
        .iter()
        .map(|offset| offset.abs().max_element())
        .fold(0.0, f64::max);
    if extent < LEAST_LENGTH {
        return Some(no_area());
    }
    offsets.iter_mut().for_each(|offset| *offset /= extent);
    let area = area_vector(offsets.iter().copied());
    if let Some([i, j]) = meeting_edges(&flattened(&offsets, area)) {
        let end = |k: usize| face[(k + 1) % face.len()];
        let found = text!(
            "found-edges-meet",
            first = face[i],
            first_end = end(i),
            second = face[j],
            second_end = end(j)
        );
        return Some((found, text!("expected-no-crossing")));
    }
    (area.length() < TOUCH).then(no_area)
}

/// Returns the points seen along `axis`, in any frame; along z where it is zero.
fn flattened(points: &[DVec3], axis: DVec3) -> Vec<DVec2> {
    let (u, v) = axis.normalize_or(DVec3::Z).any_orthonormal_pair();
    points
        .iter()
        .map(|p| DVec2::new(p.dot(u), p.dot(v)))
        .collect()
}

/// Finds two edges of a polygon about 1 across that meet elsewhere than in the corner between them.
fn meeting_edges(points: &[DVec2]) -> Option<[usize; 2]> {
    let count = points.len();
    let edge = |k: usize| [points[k], points[(k + 1) % count]];
    for i in 0..count {
        for j in i + 1..count {
            let ([a, b], [c, d]) = (edge(i), edge(j));
            let apart = if j == i + 1 || (i == 0 && j == count - 1) {
                // Neighbours, which fold where the far end of one lies on the other.
                let [before, corner, after] = if j == i + 1 { [a, b, d] } else { [c, d, b] };
                distance_to(before, [corner, after]).min(distance_to(after, [before, corner]))
            } else {
                distance([a, b], [c, d])
            };
            if apart <= TOUCH {
                return Some([i, j]);
            }
        }
    }
    None
}

/// Returns the distance between two segments; 0 where they cross.
fn distance([a, b]: [DVec2; 2], [c, d]: [DVec2; 2]) -> f64 {
    let side = |p: DVec2, q: DVec2, r: DVec2| (q - p).perp_dot(r - p);
    let cross = side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0;
    if cross {
        return 0.0;
    }
    let ends = [
        distance_to(a, [c, d]),
        distance_to(b, [c, d]),
        distance_to(c, [a, b]),
        distance_to(d, [a, b]),
    ];
    ends.into_iter().fold(f64::INFINITY, f64::min)
}

/// Returns the distance of a point from a segment.
fn distance_to(point: DVec2, [from, to]: [DVec2; 2]) -> f64 {
    let along = to - from;
    let squared = along.length_squared();
    let t = if squared > 0.0 {
        ((point - from).dot(along) / squared).clamp(0.0, 1.0)
    } else {
        0.0
    };
    point.distance(from + along * t)
}

/// Returns the area of a polygon times its unit normal, by Newell's formula ½ Σ pᵢ × pᵢ₊₁. The points are taken relative to
/// the first one, which keeps the digits of a small polygon far from the origin.
pub(crate) fn area_vector(mut points: impl Iterator<Item = DVec3>) -> DVec3 {
    let Some(first) = points.next() else {
        return DVec3::ZERO;
    };
    let mut sum = DVec3::ZERO;
    let mut previous = DVec3::ZERO;
    for point in points {
        let current = point - first;
        sum += previous.cross(current);
        previous = current;
    }
    sum / 2.0
}
