//! The reference: the picture's values, one pixel at a time in double precision.
//!
//! The modes differ only in where the equation is evaluated; so a pixel's value is a weighted sum of the equation at a few
//! points, and [`Evaluation`] lists them: one at the face's centre, three at vertices, one at the pixel.

use super::plan::{Cued, Inputs, Per};
use crate::illumination::{Equation, LightAt, Reached};
use crate::render::lens::NEAR;
use crate::render::model::Model;
use crate::render::raster::{Crossing, Outline, SHORTEST_NORMAL, SUBPIXELS, crossing_pair, meet};
use crate::render::rays::BLOCK;
use crate::scene::{FlatAt, Rgb, ShadingMode};
use glam::{DVec2, DVec3};

/// The points where the equation is evaluated for a pixel, with their weights.
#[derive(Clone, Debug)]
pub(crate) struct Evaluation<'a> {
    /// The point that the pixel shows, world.
    pub position: DVec3,
    /// N at the pixel, according to the mode.
    pub normal: DVec3,
    /// The distance along the viewing direction, world units.
    pub depth: f64,
    pub face: Option<u32>,
    /// The index of the face's material, of which `equations` below have one each.
    pub material: usize,
    /// Idc, where intensities fade with the depth.
    pub cue: Option<Rgb>,
    pub points: Vec<WeightedPoint<'a>>,
}

/// A point where the equation is evaluated.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WeightedPoint<'a> {
    pub weight: f64,
    /// The point, world.
    pub point: DVec3,
    pub normal: DVec3,
    /// The colour that tints Od.
    pub tint: Rgb,
    /// s0, the fraction of its intensity that remains; 1 where nothing fades.
    pub scale: f64,
    /// The lights that reach it; all of them where there are no shadows.
    pub reached: Option<Reached<'a>>,
}

impl WeightedPoint<'_> {
    /// Returns I.
    pub fn value(&self, equation: &Equation<f64>) -> Rgb {
        equation.illuminate_tinted((self.point, self.normal), self.tint, None, self.reached)
    }

    /// Returns the contribution of a light.
    ///
    /// # Panics
    /// If there is no such light.
    pub fn respond(&self, equation: &Equation<f64>, light: usize) -> LightAt {
        equation.respond_tinted(light, (self.point, self.normal), self.tint, self.reached)
    }
}

impl Evaluation<'_> {
    /// Returns whether the scene's own law is undefined at one of the points.
    pub fn is_undefined(&self, equations: &[Equation<f64>]) -> bool {
        let equation = &equations[self.material];
        let undefined = |at: &WeightedPoint<'_>| {
            equation.is_undefined((at.point, at.normal), at.tint, at.reached)
        };
        self.points.iter().any(undefined)
    }

    pub fn intensity(&self, equations: &[Equation<f64>]) -> Rgb {
        let equation = &equations[self.material];
        self.points
            .iter()
            .map(|at| at.value(equation) * at.weight)
            .sum()
    }

    /// Returns the part of I that remains at the pixel: each point's share fades by its own s0.
    pub fn kept(&self, equations: &[Equation<f64>]) -> Rgb {
        let equation = &equations[self.material];
        self.points
            .iter()
            .map(|at| at.value(equation) * (at.weight * at.scale))
            .sum()
    }

    pub fn scale(&self) -> f64 {
        self.points.iter().map(|at| at.weight * at.scale).sum()
    }

    /// Returns the light that replaces the faded intensity: `(1 − s0)·Idc`.
    pub fn veil(&self) -> Rgb {
        self.cue
            .map_or(Rgb::ZERO, |color| color * (1.0 - self.scale()))
    }

    /// Returns I at the pixel after depth cueing, before the display.
    pub fn shown(&self, equations: &[Equation<f64>]) -> Rgb {
        self.kept(equations) + self.veil()
    }
}

impl<'a> Inputs<'a> {
    /// Returns the evaluation of the pixel whose sample lies at `place`, if it meets the true surface.
    pub fn of_surface(&self, place: DVec2) -> Option<Evaluation<'a>> {
        let (position, hit) = meet(self.lens, self.surface?, place)?;
        let depth = (position - self.lens.eye).dot(self.lens.forward);
        let (normal, reached) = (hit.normal, self.visible_at_pixel(place));
        let points = vec![self.point((position, normal), Rgb::ONE, reached)];
        Some(Evaluation {
            position,
            normal,
            depth,
            face: None,
            material: 0,
            cue: self.cue_color(),
            points,
        })
    }

    /// Returns the evaluation of the pixel whose sample lies at `place` and shows `triangle`, one of the model's or of the
    /// clipper's.
    pub fn of_triangle(&self, triangle: u32, place: DVec2) -> Evaluation<'a> {
        let face = self.triangles.face(triangle);
        let (carried, key) = self.carried(triangle, place);
        let depth = self.lens.depth_from_key(key);
        let (point, direction) = self.lens.ray(place);
        let position = self.lens.world(point + direction * depth);
        let depth = depth * self.lens.unit;
        let normal = self.pixel_normal(face, &carried);
        // s0 of the whole pixel, where it is not that of each point where the equation is evaluated.
        let whole = match self.plan.cued {
            Cued::Nowhere | Cued::AtPoints => None,
            Cued::AtPixels => Some(self.scale(position)),
            Cued::AtVertices => Some(
                carried
                    .iter()
                    .map(|&(v, weight)| weight * self.scale(self.model().position(v)))
                    .sum(),
            ),
        };
        let mut points = match self.scene.shading.mode {
            ShadingMode::Phong | ShadingMode::Exact => {
                let tint = self.model().mean_tint(&carried);
                vec![self.point((position, normal), tint, self.visible_at_pixel(place))]
            }
            ShadingMode::Interpolated | ShadingMode::Gouraud => carried
                .iter()
                .map(|&(v, weight)| self.vertex_point(v, weight))
                .collect(),
            ShadingMode::Flat => self.flat_points(face),
        };
        if let Some(scale) = whole {
            points.iter_mut().for_each(|at| at.scale = scale);
        }
        Evaluation {
            position,
            normal,
            depth,
            face: Some(face),
            material: self.model().face_materials.of_face(face),
            cue: self.cue_color(),
            points,
        }
    }

    fn cue_color(&self) -> Option<Rgb> {
        (self.plan.cued != Cued::Nowhere).then_some(self.scene.depth_cueing.color)
    }

    pub fn corner_points(&self, face: u32) -> Vec<WeightedPoint<'a>> {
        self.model()
            .face(face)
            .iter()
            .map(|&v| self.vertex_point(v, 1.0))
            .collect()
    }

    /// Returns the points where flat shading evaluates the equation for a face.
    pub fn flat_points(&self, face: u32) -> Vec<WeightedPoint<'a>> {
        let corners = self.model().face(face);
        let share = 1.0 / corners.len().max(1) as f64;
        match self.scene.shading.flat_at {
            FlatAt::Centre => {
                let place = (
                    self.model().face_centre(face),
                    self.model().face_normal(face),
                );
                let tint = self.model().face_tint(face);
                vec![self.point(place, tint, self.visible_at_point(face))]
            }
            FlatAt::VertexMean => corners
                .iter()
                .map(|&v| self.vertex_point(v, share))
                .collect(),
            FlatAt::ProvokingVertex => corners
                .iter()
                .take(1)
                .map(|&v| self.vertex_point(v, 1.0))
                .collect(),
        }
    }

    fn vertex_point(&self, v: u32, weight: f64) -> WeightedPoint<'a> {
        let place = (self.model().position(v), self.model().normal(v));
        let point = self.point(place, self.model().tint(v), self.visible_at_point(v));
        WeightedPoint { weight, ..point }
    }

    fn point(
        &self,
        (point, normal): (DVec3, DVec3),
        tint: Rgb,
        reached: Option<Reached<'a>>,
    ) -> WeightedPoint<'a> {
        WeightedPoint {
            weight: 1.0,
            point,
            normal,
            tint,
            scale: self.scale(point),
            reached,
        }
    }

    fn visible_at_pixel(&self, place: DVec2) -> Option<Reached<'a>> {
        let visibility = self.visibility.filter(|_| self.plan.per == Per::Pixel)?;
        visibility.at(place.y as usize, place.x as usize)
    }

    /// Returns the sources that reach a vertex, or a face where the equation is evaluated at faces.
    fn visible_at_point(&self, index: u32) -> Option<Reached<'a>> {
        let visibility = self.visibility.filter(|_| self.plan.per != Per::Pixel)?;
        visibility.at(index as usize / BLOCK, index as usize % BLOCK)
    }

    fn pixel_normal(&self, face: u32, carried: &[(u32, f64)]) -> DVec3 {
        if matches!(
            self.scene.shading.mode,
            ShadingMode::Flat | ShadingMode::Interpolated
        ) {
            return self.model().face_normal(face);
        }
        let normal: DVec3 = carried
            .iter()
            .map(|&(v, weight)| self.model().normal(v) * weight)
            .sum();
        if self.plan.renormalise {
            normal / normal.length().max(SHORTEST_NORMAL)
        } else {
            normal
        }
    }

    /// Returns the weights by which values are carried from the model's vertices to a position, and the depth key there.
    ///
    /// Corners are at their exact positions, unless the picture's grid decides what the pixel shows, as in a polygon hardly
    /// wider than the grid: there they are at the picture's positions. Pixels that are evaluated here do not use the grid.
    fn carried(&self, triangle: u32, place: DVec2) -> (Vec<(u32, f64)>, f64) {
        /// The change of a weight, a quarter of a code value, beyond which the grid decides.
        const MOVED: f64 = 1.0 / 1024.0;
        let pair = self.plan.scanline.then(|| self.pair(triangle, place));
        let by = |grid| match &pair {
            Some(pair) => self.weights(&self.along_line(pair, place, grid)),
            None => self.weights(&self.over_triangle(triangle, place, grid)),
        };
        let exact = by(false);
        if self.plan.pixels_in_double() {
            return exact;
        }
        let grid = by(true);
        let of = |weights: &[(u32, f64)], vertex| {
            weights
                .iter()
                .find(|(v, _)| *v == vertex)
                .map_or(0.0, |(_, w)| *w)
        };
        let same = |&(v, _): &(u32, f64)| (of(&exact.0, v) - of(&grid.0, v)).abs() <= MOVED;
        if exact.0.iter().chain(&grid.0).all(same) {
            exact
        } else {
            grid
        }
    }

    /// Returns P and Q on the picture's grid.
    fn pair(&self, triangle: u32, place: DVec2) -> [Crossing; 2] {
        let place = place * f64::from(SUBPIXELS);
        let mut crossings = Vec::new();
        Outline::of(&self.triangles, triangle).cross(
            &self.triangles.placed.places,
            place.y,
            &mut crossings,
        );
        let corner = Crossing {
            x: place.x,
            ends: [self.triangles.vertices(triangle)[0]; 2],
            alpha: 0.0,
        };
        crossing_pair(&crossings, place.x)
            .map_or([corner; 2], |pair| pair.map(|crossing| *crossing))
    }

    /// Returns the ends of the edges that P and Q lie on, with their weights (Gouraud 1971).
    fn along_line(
        &self,
        pair: &[Crossing; 2],
        place: DVec2,
        grid: bool,
    ) -> Vec<(ProjectedVertex, f64)> {
        let [p, q] = pair.map(|Crossing { ends, alpha, .. }| {
            let [a, b] = ends.map(|v| self.corner(v, grid));
            let exact = (place.y - a.place.y) / (b.place.y - a.place.y);
            let alpha = if exact.is_finite() {
                exact.clamp(0.0, 1.0)
            } else {
                alpha
            };
            (
                a.place.x + alpha * (b.place.x - a.place.x),
                [(a, 1.0 - alpha), (b, alpha)],
            )
        });
        let t = if q.0 > p.0 {
            ((place.x - p.0) / (q.0 - p.0)).clamp(0.0, 1.0)
        } else {
            0.0
        };
        let shared = |corners: [(ProjectedVertex, f64); 2], share: f64| {
            corners.map(|(corner, weight)| (corner, weight * share))
        };
        [shared(p.1, 1.0 - t), shared(q.1, t)].concat()
    }

    /// Returns the corners of a triangle, with their weights in the picture; its middle stands for one that is seen edge-on.
    fn over_triangle(
        &self,
        triangle: u32,
        place: DVec2,
        grid: bool,
    ) -> Vec<(ProjectedVertex, f64)> {
        let corners = self
            .triangles
            .vertices(triangle)
            .map(|v| self.corner(v, grid));
        let [a, b, c] = corners.map(|corner| corner.place);
        let area = (b - a).perp_dot(c - a);
        let w1 = (place - a).perp_dot(c - a) / area;
        let w2 = (b - a).perp_dot(place - a) / area;
        let sound = w1.is_finite() && w2.is_finite();
        let weights = if sound {
            [1.0 - w1 - w2, w1, w2]
        } else {
            [1.0 / 3.0; 3]
        };
        corners.into_iter().zip(weights).collect()
    }

    /// Returns a vertex of the model or of the clipper as a corner in the picture.
    fn corner(&self, vertex: u32, grid: bool) -> ProjectedVertex {
        let view = |v: u32| self.lens.view_from_world(self.model().position(v));
        let view = match self.triangles.cut(vertex) {
            None => view(vertex),
            Some(cut) => cut
                .vertices
                .iter()
                .zip(cut.weights)
                .map(|(&v, weight)| view(v) * weight)
                .sum(),
        };
        let view = DVec3 {
            z: view.z.max(NEAR),
            ..view
        };
        let place = if grid {
            let place = self.triangles.placed.places[vertex as usize];
            DVec2::from_array(place.map(f64::from)) / f64::from(SUBPIXELS)
        } else {
            self.lens.picture_from_view(view)
        };
        ProjectedVertex {
            vertex,
            place,
            key: self.lens.key_from_depth(view.z),
        }
    }

    /// Returns weights over the model's vertices, and the depth key, from weights in the picture.
    fn weights(&self, seen: &[(ProjectedVertex, f64)]) -> (Vec<(u32, f64)>, f64) {
        let key: f64 = seen
            .iter()
            .map(|(corner, weight)| weight * corner.key)
            .sum();
        let key = key.max(self.lens.least_key());
        let mut weights: Vec<(u32, f64)> = Vec::with_capacity(4);
        let mut add =
            |vertex: u32, weight: f64| match weights.iter_mut().find(|(v, _)| *v == vertex) {
                Some((_, sum)) => *sum += weight,
                None => weights.push((vertex, weight)),
            };
        for (corner, weight) in seen {
            let weight = if self.plan.perspective {
                weight * corner.key / key
            } else {
                *weight
            };
            match self.triangles.cut(corner.vertex) {
                None => add(corner.vertex, weight),
                Some(cut) => cut
                    .vertices
                    .iter()
                    .zip(cut.weights)
                    .for_each(|(&v, part)| add(v, weight * part)),
            }
        }
        (weights, key)
    }

    fn model(&self) -> &'a Model {
        self.triangles.model
    }
}

/// A vertex in the picture, pixels, with its depth key.
#[derive(Clone, Copy, Debug)]
struct ProjectedVertex {
    vertex: u32,
    place: DVec2,
    key: f64,
}
