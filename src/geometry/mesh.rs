//! Meshes of n-sided polygons, and the test for whether they are closed.

use super::buckets::Buckets;
use super::concave;
use super::mtl::{ModelMaterial, NO_MATERIAL, Remark};
use crate::scene::area_vector;
use glam::{DVec3, Vec3};
use serde::{Deserialize, Serialize};

/// A corner of a polygon: its point and its given normal.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Corner {
    /// Index into [`Mesh::positions`].
    pub position: u32,
    /// Index into [`Mesh::normals`], or [`NO_NORMAL`].
    pub normal: u32,
}

/// A corner without a given normal.
pub const NO_NORMAL: u32 = u32::MAX;

/// The most steps spent on cutting a mesh's polygons, where one of n corners may take n² steps: some seconds.
const CUTTING_STEPS: u64 = 1 << 32;

/// A corner that knows its point.
pub trait AtPoint: Copy {
    /// Returns the index into [`Mesh::positions`].
    fn point(self) -> usize;
}

impl AtPoint for Corner {
    fn point(self) -> usize {
        self.position as usize
    }
}

impl AtPoint for u32 {
    fn point(self) -> usize {
        self as usize
    }
}

/// The distance from the origin within which single precision resolves a model whose parts are about 10⁻³ apart or more.
pub(crate) const FAR: f64 = 1000.0;

/// Polygons over shared points, as the shape or the file gives them.
///
/// Polygons are counter-clockwise seen from outside. Faces that meet at a point share its position, even at creases, so
/// that averaging sees them all; `normals` may give each corner its own. A polygon is one face whatever its shape; only for
/// drawing is it taken as triangles, see [`Mesh::face_triangles`].
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Mesh<C = Corner> {
    /// The world position of (0, 0, 0) in `positions`: large offsets stay in double precision.
    pub origin: DVec3,
    /// The distinct points, relative to `origin`.
    pub positions: Vec<Vec3>,
    /// Unit normals: the true surface's at the corners, or the file's.
    pub normals: Vec<Vec3>,
    /// The ends of the faces in `corners`: face f has `corners[starts[f]..starts[f + 1]]`. One entry more than faces.
    pub starts: Vec<u32>,
    /// The corners of all faces, face by face.
    pub corners: Vec<C>,
    /// The triangles of faces that a fan from the first corner would not cover: the face, and three indices into `corners`,
    /// in ascending order of faces. [`Mesh::with_concave_faces_cut`] finds them.
    pub cut: Vec<(u32, [u32; 3])>,
    /// The points at which the shape continues beyond its border as its own mirror image in x: averaged normals there are
    /// those of both together.
    pub mirrored: Vec<u32>,
    /// True if every edge has a face on either side and the faces point outwards, so that no back face is seen from outside.
    pub closed: bool,
    /// True if the mesh is closed and convex: from outside no two front faces cover the same pixel.
    pub convex: bool,
    /// The model's materials that faces have, at most [`ModelMaterial::MAX`].
    pub materials: Vec<ModelMaterial>,
    /// The material of each face: an index into `materials`, or [`NO_MATERIAL`](super::NO_MATERIAL). Empty where `materials` is.
    pub face_materials: Vec<u16>,
    /// The colours that tint the surface's own, Od, between the corners that have them.
    pub colors: Vec<Vec3>,
    /// The colour of each corner: an index into `colors`. Empty where these are.
    pub corner_colors: Vec<u32>,
    /// The problems of the file's materials.
    pub remarks: Vec<Remark>,
}

/// A mesh ready to be shaded: a vertex is a point with one normal, at the same index in `positions` and `normals`, and a
/// corner is a vertex.
pub type VertexMesh = Mesh<u32>;

impl<C: AtPoint> Mesh<C> {
    /// Returns the number of polygons.
    pub fn face_count(&self) -> usize {
        self.starts.len().saturating_sub(1)
    }

    /// Returns the number of triangles that the polygons are drawn as.
    pub fn triangle_count(&self) -> usize {
        (0..self.face_count())
            .map(|f| self.face_triangles(f).len())
            .sum()
    }

    /// Returns the corners of face `f`, counter-clockwise from outside.
    ///
    /// # Panics
    /// If there is no face `f`.
    pub fn face(&self, f: usize) -> &[C] {
        &self.corners[self.starts[f] as usize..self.starts[f + 1] as usize]
    }

    /// Returns the triangles that face `f` is drawn as, counter-clockwise from outside: those in `cut`, or else the fan
    /// from its first corner.
    ///
    /// # Panics
    /// If there is no face `f`, or `cut` has a triangle of it whose corners do not exist.
    pub fn face_triangles(&self, f: usize) -> impl ExactSizeIterator<Item = [C; 3]> {
        let cut = &self.cut[self.cut.partition_point(|(face, _)| (*face as usize) < f)..];
        let cut = &cut[..cut.partition_point(|(face, _)| *face as usize == f)];
        let face = self.face(f);
        let count = if cut.is_empty() {
            face.len().saturating_sub(2)
        } else {
            cut.len()
        };
        (0..count).map(move |k| match cut.get(k) {
            Some((_, triangle)) => triangle.map(|c| self.corners[c as usize]),
            None => [face[0], face[k + 1], face[k + 2]],
        })
    }

    /// Returns the material of face `f`: an index into `materials`, or [`NO_MATERIAL`].
    pub fn face_material(&self, f: usize) -> u16 {
        self.face_materials.get(f).copied().unwrap_or(NO_MATERIAL)
    }

    /// Returns the colour of a corner by its index into `corners`: white where it has none.
    pub fn corner_color(&self, corner: usize) -> Vec3 {
        let color = self.corner_colors.get(corner);
        let color = color.and_then(|color| self.colors.get(*color as usize));
        color.copied().unwrap_or(Vec3::ONE)
    }

    /// Drops the materials and colours of the faces: they have the scene's.
    pub(crate) fn drop_materials(&mut self) {
        self.face_materials.clear();
        self.corner_colors.clear();
    }

    /// Returns the points of face `f`, relative to `origin`, in double precision.
    pub(crate) fn face_points(&self, f: usize) -> impl Iterator<Item = DVec3> + Clone {
        self.face(f)
            .iter()
            .map(|corner| self.positions[corner.point()].as_dvec3())
    }

    /// Returns the normal of face `f` by Newell's formula, with the face's area as its length.
    ///
    /// Zero where the area is no more than rounding the corners to single precision can produce, since it then has no
    /// meaningful direction.
    fn area_vector(&self, f: usize) -> DVec3 {
        let area = area_vector(self.face_points(f));
        if area.length() > self.area_rounding(f) {
            area
        } else {
            DVec3::ZERO
        }
    }

    /// Returns the area that rounding the corners to single precision can give face `f`.
    fn area_rounding(&self, f: usize) -> f64 {
        /// Half a unit in the last place of a coordinate, in all of a corner's coordinates, at all corners; twice that.
        const ROUNDING: f64 = 4.0 / (1 << 24) as f64;
        let nothing = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let (low, high) = self.face_points(f).fold(nothing, |(low, high), point| {
            (low.min(point), high.max(point))
        });
        let extent = (high - low).max_element();
        let farthest = low.abs().max(high.abs()).max_element();
        ROUNDING * extent * farthest
    }

    /// Returns the unit normal of face `f`; zero where the face has no area, or none beyond its points' rounding.
    pub fn face_normal(&self, f: usize) -> DVec3 {
        self.area_vector(f).normalize_or_zero()
    }

    /// Returns the unit normal and the area of face `f`; `None` for a face without area, which does not count in an average.
    pub(super) fn normal_and_area(&self, f: usize) -> Option<(DVec3, f64)> {
        let area_vector = self.area_vector(f);
        let area = area_vector.length();
        (area > 0.0).then(|| (area_vector / area, area))
    }

    /// Returns the mean of the points of face `f`, in the world.
    pub fn face_centre(&self, f: usize) -> DVec3 {
        let count = self.face(f).len().max(1) as f64;
        self.origin + self.face_points(f).sum::<DVec3>() / count
    }

    /// Returns the radius of the smallest sphere about `origin` that holds every point.
    pub fn radius(&self) -> f64 {
        let squared = self
            .positions
            .iter()
            .map(|p| p.as_dvec3().length_squared())
            .fold(0.0, f64::max);
        if squared > 0.0 {
            squared.sqrt().next_up()
        } else {
            0.0
        }
    }
}

impl Mesh {
    /// Returns the centre and the radius of a ball that holds every point: the middle of the bounding box, and the distance
    /// from there to the farthest point. The ball of a mesh without points has radius 0 and lies at its origin.
    pub fn ball(&self) -> (DVec3, f64) {
        let Some(&first) = self.positions.first() else {
            return (self.origin, 0.0);
        };
        let (low, high) = self
            .positions
            .iter()
            .fold((first, first), |(low, high), p| (low.min(*p), high.max(*p)));
        let centre = (low.as_dvec3() + high.as_dvec3()) / 2.0;
        let squared = self
            .positions
            .iter()
            .map(|p| p.as_dvec3().distance_squared(centre))
            .fold(0.0, f64::max);
        (self.origin + centre, squared.sqrt())
    }

    /// Centres the mesh and scales it into the unit sphere: the middle of its bounding box comes to the world's origin, the
    /// farthest point to distance 1. A mesh of a single point is only centred; one without points stays as it is.
    pub fn fitted(mut self) -> Self {
        if self.positions.is_empty() {
            return self;
        }
        let (centre, radius) = self.ball();
        let centre = centre - self.origin;
        let scale = if radius > 0.0 { 1.0 / radius } else { 1.0 };
        for position in &mut self.positions {
            *position = ((position.as_dvec3() - centre) * scale).as_vec3();
        }
        self.origin = DVec3::ZERO;
        self
    }

    /// Sets `cut` from the polygons themselves: triangles for each that a fan from its first corner would not cover.
    ///
    /// Every corner belongs to one of the triangles, so that neighbouring polygons share their edges. A polygon stays a fan
    /// if it has no area, or crosses itself so that it has no triangles. So does one of more than 65 536 corners, or of
    /// fewer once others have taken long: the time is bounded.
    pub fn with_concave_faces_cut(mut self) -> Self {
        self.cut.clear();
        let mut points = Vec::new();
        let mut left = CUTTING_STEPS;
        for f in 0..self.face_count() {
            if self.face(f).len() == 3 {
                continue;
            }
            points.clear();
            points.extend(self.face_points(f));
            let area = self.area_vector(f);
            if area == DVec3::ZERO
                || concave::fan_covers(&points, area, self.area_rounding(f))
                || self.is_tangle(f)
            {
                continue;
            }
            let Some(rest) = left.checked_sub((points.len() as u64).pow(2)) else {
                continue;
            };
            left = rest;
            let start = self.starts[f];
            let triangles = concave::triangles(&points, area).into_iter();
            let corners = triangles.map(|triangle| triangle.map(|k| start + k as u32));
            self.cut.extend(corners.map(|corners| (f as u32, corners)));
        }
        self.cut.shrink_to_fit();
        self
    }

    /// Returns whether face `f` visits its points too often to be a simple polygon, or one whose holes are joined to its
    /// border, which visits a point twice. No triangles cover such a tangle, and cutting a large one takes minutes.
    fn is_tangle(&self, f: usize) -> bool {
        let mut points: Vec<u32> = self.face(f).iter().map(|c| c.position).collect();
        let corners = points.len();
        points.sort_unstable();
        points.dedup();
        corners > 2 * points.len()
    }

    /// Sets `closed` from the polygons themselves: true if every directed edge occurs once and its opposite once, and every
    /// connected part encloses a positive volume. `convex` becomes false, as it is not examined.
    ///
    /// Takes time and memory in proportion to the number of corners.
    pub fn with_closedness_detected(mut self) -> Self {
        self.closed = self.face_count() > 0 && self.edges_pair_up() && self.parts_face_outwards();
        self.convex = false;
        self
    }

    /// Returns the volume that the faces enclose, each drawn as a fan; positive when they face outwards. It is meaningful
    /// only for a closed mesh.
    pub fn signed_volume(&self) -> f64 {
        let reference = self.positions.first().map_or(DVec3::ZERO, |p| p.as_dvec3());
        (0..self.face_count())
            .map(|f| self.face_volume(f, reference))
            .sum()
    }

    /// Returns the signed volume of the pyramid from `apex` (relative to the mesh's origin) to face `f`.
    fn face_volume(&self, f: usize, apex: DVec3) -> f64 {
        let mut points = self.face_points(f).map(|p| p - apex);
        let (Some(first), Some(mut previous)) = (points.next(), points.next()) else {
            return 0.0;
        };
        let mut volume = 0.0;
        for point in points {
            volume += first.dot(previous.cross(point));
            previous = point;
        }
        volume / 6.0
    }

    /// Returns the directed edges of the mesh as pairs of points.
    fn edges(&self) -> impl Iterator<Item = (u32, u32)> + Clone {
        (0..self.face_count()).flat_map(|f| {
            let face = self.face(f);
            let next = face.iter().cycle().skip(1);
            face.iter()
                .zip(next)
                .map(|(from, to)| (from.position, to.position))
        })
    }

    fn edges_pair_up(&self) -> bool {
        let count = self.positions.len();
        let mut targets = Buckets::new(count, self.edges());
        (0..count).for_each(|point| targets.at_mut(point).sort_unstable());
        (0..count).all(|point| {
            let own = targets.at(point);
            let returns = |target: u32| {
                targets
                    .at(target as usize)
                    .binary_search(&(point as u32))
                    .is_ok()
            };
            let once = own.windows(2).all(|pair| pair[0] < pair[1]);
            once && own
                .iter()
                .all(|&target| target as usize != point && returns(target))
        })
    }

    fn parts_face_outwards(&self) -> bool {
        let mut parts = Parts::new(self.positions.len());
        self.edges().for_each(|(from, to)| parts.join(from, to));
        let mut volumes = vec![0.0; self.positions.len()];
        for f in 0..self.face_count() {
            if let Some(corner) = self.face(f).first() {
                let part = parts.root(corner.position) as usize;
                volumes[part] += self.face_volume(f, self.positions[part].as_dvec3());
            }
        }
        (0..self.face_count()).all(|f| {
            self.face(f)
                .first()
                .is_none_or(|c| volumes[parts.root(c.position) as usize] > 0.0)
        })
    }
}

/// Sets of connected points (union–find with path halving; a set is named by its lowest point).
struct Parts {
    parents: Vec<u32>,
}

impl Parts {
    fn new(points: usize) -> Self {
        Self {
            parents: (0..points as u32).collect(),
        }
    }

    fn root(&mut self, mut point: u32) -> u32 {
        while self.parents[point as usize] != point {
            let grandparent = self.parents[self.parents[point as usize] as usize];
            self.parents[point as usize] = grandparent;
            point = grandparent;
        }
        point
    }

    fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.root(a), self.root(b));
        self.parents[a.max(b) as usize] = a.min(b);
    }
}
