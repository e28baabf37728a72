//! Triangles to pixels, a scan line at a time: projection, back faces, coverage, the depth test.

use super::kernel::{Corner, Crossing, Kernel, Shade, Span, linear};
use crate::geometry::VertexMesh;
use crate::scene::Scene;
use glam::DVec2;

/// Places are rounded to this part of a pixel, as the engine's are.
const SUBPIXELS: f64 = 256.0;

/// What is nearer to the eye than this many camera distances is left out, with its triangles.
const NEAR: f64 = 1e-3;

pub struct Raster<'a> {
    shade: &'a Shade,
    mesh: &'a VertexMesh,
    corners: Vec<Option<Corner>>,
    width: usize,
    height: usize,
    linear: &'a mut [[f32; 4]],
    keys: &'a mut [f64],
}

impl<'a> Raster<'a> {
    /// Projects the vertices.
    pub fn new(
        scene: &Scene,
        mesh: &'a VertexMesh,
        shade: &'a Shade,
        linear: &'a mut [[f32; 4]],
        keys: &'a mut [f64],
    ) -> Self {
        let near = NEAR * scene.camera.distance();
        let corner = |(position, normal): (&glam::Vec3, &glam::Vec3)| {
            let (at, depth) = shade.view.project(mesh.origin + position.as_dvec3())?;
            let at = (at * SUBPIXELS).round() / SUBPIXELS;
            let key = shade.key_from_depth(depth);
            (depth >= near).then(|| Corner { at, key, normal: normal.as_dvec3() })
        };
        let corners = mesh.positions.iter().zip(&mesh.normals).map(corner).collect();
        let [width, height] = scene.image.size.map(|side| side as usize);
        Self { shade, mesh, corners, width, height, linear, keys }
    }

    /// Draws every triangle; returns the evaluations.
    pub fn run(&mut self, kernel: &mut impl Kernel) -> u64 {
        let mesh = self.mesh;
        // An eye inside a closed solid sees its back faces.
        let eye = self.shade.view.eye - mesh.origin;
        let culls = mesh.closed && eye.length() > mesh.radius();
        let mut evaluations = 0;
        for face in 0..mesh.face_count() {
            let Some((&first, rest)) = mesh.face(face).split_first() else { continue };
            for pair in rest.windows(2) {
                let [a, b, c] = [first, pair[0], pair[1]].map(|vertex| self.corners[vertex as usize]);
                if let (Some(a), Some(b), Some(c)) = (a, b, c) {
                    evaluations += self.triangle(kernel, [a, b, c], culls);
                }
            }
        }
        evaluations
    }

    fn triangle(&mut self, kernel: &mut impl Kernel, corners: [Corner; 3], culls: bool) -> u64 {
        let [a, b, c] = corners.map(|corner| corner.at);
        // Counter-clockwise from outside is clockwise in a picture whose y points downwards.
        let area = (b - a).perp_dot(c - a);
        if area == 0.0 || (culls && area > 0.0) {
            return 0;
        }
        let rows = |y: f64| (y - 0.5).ceil().clamp(0.0, self.height as f64) as usize;
        let (top, bottom) = (rows(a.y.min(b.y).min(c.y)), rows(a.y.max(b.y).max(c.y)));
        let keys = linear([a, b, c], corners.map(|corner| corner.key));
        let mut begun = false;
        let mut pixels = 0;
        for row in top..bottom {
            let y = row as f64 + 0.5;
            let Some(ends) = crossings([a, b, c], y) else { continue };
            let columns = |x: f64| (x - 0.5).ceil().clamp(0.0, self.width as f64) as usize;
            let (from, to) = (columns(ends[0].x), columns(ends[1].x));
            if from >= to {
                continue;
            }
            if !begun {
                begun = true;
                kernel.begin_triangle(&corners);
            }
            let first = DVec2::new(from as f64 + 0.5, y);
            kernel.begin_span(&Span { first, ends });
            pixels += self.span(kernel, row, [from, to], [keys.at(first), keys.x]);
        }
        u64::from(begun) * kernel.evaluations_per_triangle() + pixels * kernel.evaluations_per_pixel()
    }

    /// Draws a span; returns how many of its pixels are in front.
    fn span(
        &mut self,
        kernel: &mut impl Kernel,
        row: usize,
        [from, to]: [usize; 2],
        [mut key, slope]: [f64; 2],
    ) -> u64 {
        let mut seen = 0;
        for column in from..to {
            let index = row * self.width + column;
            if key > self.keys[index] {
                self.keys[index] = key;
                let place = DVec2::new(column as f64 + 0.5, row as f64 + 0.5);
                let [r, g, b] = kernel.pixel(place, key).as_vec3().to_array();
                self.linear[index] = [r, g, b, 1.0];
                seen += 1;
            }
            key += slope;
            kernel.step();
        }
        seen
    }
}

/// Where the line at `y` enters and leaves a triangle: an edge counts from its upper end up to but without its lower one.
fn crossings(corners: [DVec2; 3], y: f64) -> Option<[Crossing; 2]> {
    let mut found: [Option<Crossing>; 2] = [None; 2];
    for from in 0..3 {
        let to = (from + 1) % 3;
        let (a, b) = (corners[from], corners[to]);
        if (a.y <= y) != (b.y <= y) {
            let alpha = (y - a.y) / (b.y - a.y);
            let crossing = Crossing { x: a.x + alpha * (b.x - a.x), from, to, alpha };
            let free = usize::from(found[0].is_some());
            found[free] = Some(crossing);
        }
    }
    let [p, q] = [found[0]?, found[1]?];
    Some(if p.x <= q.x { [p, q] } else { [q, p] })
}
