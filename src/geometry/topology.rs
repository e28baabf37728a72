//! Whether a mesh is closed, found from its edges.

use super::mesh::Mesh;
use glam::DVec3;

impl Mesh {
    /// Sets `closed` from the polygons themselves: true if every directed edge occurs once and its opposite once, and
    /// every connected part encloses a positive volume. `convex` becomes false, as it is not looked for.
    ///
    /// Takes time and memory in proportion to the number of corners.
    pub fn with_closedness_detected(mut self) -> Self {
        self.closed = self.face_count() > 0 && self.edges_pair_up() && self.parts_face_outwards();
        self.convex = false;
        self
    }

    /// The volume that the faces enclose, each drawn as a fan; positive when they face outwards. Only a closed mesh has
    /// a meaningful one.
    pub fn signed_volume(&self) -> f64 {
        let reference = self.positions.first().map_or(DVec3::ZERO, |p| p.as_dvec3());
        (0..self.face_count()).map(|f| self.face_volume(f, reference)).sum()
    }

    /// The signed volume of the pyramid from `apex` (relative to the mesh's origin) to face `f`.
    fn face_volume(&self, f: usize, apex: DVec3) -> f64 {
        let mut points = self.face_points(f).map(|p| p - apex);
        let Some(first) = points.next() else { return 0.0 };
        let Some(mut previous) = points.next() else { return 0.0 };
        let mut volume = 0.0;
        for point in points {
            volume += first.dot(previous.cross(point));
            previous = point;
        }
        volume / 6.0
    }

    /// The directed edges of the mesh as pairs of points.
    fn edges(&self) -> impl Iterator<Item = (u32, u32)> {
        (0..self.face_count()).flat_map(|f| {
            let face = self.face(f);
            let next = face.iter().cycle().skip(1);
            face.iter().zip(next).map(|(from, to)| (from.position, to.position))
        })
    }

    fn edges_pair_up(&self) -> bool {
        let (ends, targets) = self.targets_by_start();
        let run = |point: u32| {
            let begin = if point == 0 { 0 } else { ends[point as usize - 1] };
            &targets[begin as usize..ends[point as usize] as usize]
        };
        (0..self.positions.len() as u32).all(|point| {
            let targets = run(point);
            let once = targets.windows(2).all(|pair| pair[0] < pair[1]);
            once && targets.iter().all(|&target| target != point && run(target).binary_search(&point).is_ok())
        })
    }

    /// Where the directed edges from each point lead, sorted, as one list and the end of each point's run in it.
    fn targets_by_start(&self) -> (Vec<u32>, Vec<u32>) {
        let mut ends = vec![0; self.positions.len()];
        self.edges().for_each(|(from, _)| ends[from as usize] += 1);
        let mut begin = 0;
        for end in &mut ends {
            begin += std::mem::replace(end, begin);
        }
        let mut targets = vec![0; self.corners.len()];
        for (from, to) in self.edges() {
            let slot = &mut ends[from as usize];
            targets[*slot as usize] = to;
            *slot += 1;
        }
        let mut begin = 0;
        for &end in &ends {
            targets[begin as usize..end as usize].sort_unstable();
            begin = end;
        }
        (ends, targets)
    }

    fn parts_face_outwards(&self) -> bool {
        let mut parts = Parts::new(self.positions.len());
        self.edges().for_each(|(from, to)| parts.join(from, to));
        let mut volumes = vec![0.0; self.positions.len()];
        for f in 0..self.face_count() {
            if let Some(corner) = self.face(f).first() {
                let part = parts.of(corner.position) as usize;
                volumes[part] += self.face_volume(f, self.positions[part].as_dvec3());
            }
        }
        (0..self.face_count())
            .all(|f| self.face(f).first().is_none_or(|c| volumes[parts.of(c.position) as usize] > 0.0))
    }
}

/// Sets of connected points (union–find with path halving; a set is named by its lowest point).
struct Parts {
    parents: Vec<u32>,
}

impl Parts {
    fn new(points: usize) -> Self {
        Self { parents: (0..points as u32).collect() }
    }

    fn of(&mut self, mut point: u32) -> u32 {
        while self.parents[point as usize] != point {
            let grandparent = self.parents[self.parents[point as usize] as usize];
            self.parents[point as usize] = grandparent;
            point = grandparent;
        }
        point
    }

    fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.of(a), self.of(b));
        self.parents[a.max(b) as usize] = a.min(b);
    }
}
