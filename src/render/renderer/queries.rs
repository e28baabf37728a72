//! Queries about the last picture.

use super::frame::Frame;
use super::pipeline::{PlannedFrame, Renderer};
use super::plan::{Inputs, Per, Plan, equations};
use super::ray_nodes::Mixture;
use super::reference::{Evaluation, WeightedPoint};
use crate::illumination::{Equation, Scalar};
use crate::render::face_materials::{any_transmits, for_each_material};
use crate::render::lens::{Lens, NEAR, pixel_centre};
use crate::render::raster::{PlacedTriangles, UNPLACED};
use crate::scene::{FaceMaterial, Rgb, Scene};
use glam::{DVec2, DVec3};
use std::collections::HashMap;

/// A polygon of the last picture, as it is shaded.
#[derive(Clone, Debug)]
pub(crate) struct Polygon<'a> {
    /// Its corners, counter-clockwise from outside, each with its normal in the shading mode.
    pub corners: Vec<WeightedPoint<'a>>,
    /// The triangles that it is drawn as, by the numbers of its corners.
    pub triangles: Vec<[usize; 3]>,
    /// The points where flat shading evaluates the equation.
    pub flat: Vec<WeightedPoint<'a>>,
    /// True if all of it lies beyond the near plane.
    pub before_the_eye: bool,
}

impl Renderer {
    /// Returns the last picture.
    pub fn frame(&self) -> &Frame {
        &self.picture.output.frame
    }

    /// Returns the last picture before the display, row by row: linear red, green, blue, and the part of the pixel that
    /// shows the object, above 1 if the scene's own law is undefined there. Empty unless [`Renderer::keep_linear`] was called or the display needed all of it.
    pub fn linear(&self) -> &[[f32; 4]] {
        &self.picture.output.linear
    }

    /// Returns the plan of the last picture.
    pub fn plan(&self) -> Option<&Plan> {
        self.drawn.as_ref().map(|drawn| &drawn.plan)
    }

    /// Draws `scene`, whose mode is exact, and returns whether the picture shows a surface beyond its polygons.
    pub(crate) fn shows_surface(&mut self, scene: &Scene) -> bool {
        self.render(scene);
        self.plan().is_some_and(|plan| plan.true_surface)
    }

    /// Draws the scene and returns it before the display: linear red, green, blue, and 1 where the object is visible.
    pub(crate) fn linear_picture(&mut self, scene: &Scene) -> Vec<[f32; 4]> {
        self.draw(scene, scene.image.size, DVec2::ZERO, true);
        let linear = self.linear().to_vec();
        self.redraw();
        linear
    }

    /// Returns what `each` makes of `scene`, whose picture is the last one, with each of the materials that its faces have, by
    /// [`Evaluation::material`].
    pub(crate) fn for_each_material<T>(
        &self,
        scene: &Scene,
        each: impl FnMut(&Scene) -> T,
    ) -> Vec<T> {
        for_each_material(
            scene,
            &self.model.output.face_materials.materials(scene),
            each,
        )
    }

    /// Returns the equation of each material, with the lights that the picture of `scene`, the last one, is shaded with.
    pub(crate) fn shining_equations<T: Scalar>(&self, scene: &Scene) -> Vec<Equation<T>> {
        let model = &self.model.output;
        let materials = model.face_materials.materials(scene);
        let unit = model.unit(&scene.camera);
        let all = vec![true; scene.lights.len()];
        let kept = self.plan().map_or(&all, |plan| &plan.lights);
        equations(scene, &materials, unit, kept)
    }

    /// Returns the number of pixels of the last picture that show each material.
    pub(super) fn pixels_of(&self, planned: &PlannedFrame) -> Vec<u64> {
        let mut counts = vec![0; planned.materials.len()];
        if let [all] = &mut counts[..] {
            *all = self.report().covered;
            return counts;
        }
        let (model, triangles) = (&self.model.output, self.inputs(planned).triangles);
        let bands = self.coverage(&planned.scene).bands;
        for run in bands.iter().flat_map(|band| &band.runs) {
            let material = model.face_materials.of_face(triangles.face(run.triangle));
            counts[material] += u64::from(run.x1 - run.x0);
        }
        counts
    }

    /// Returns Kt at each pixel of a picture that shows several materials, row by row; nothing where all have the same.
    pub(super) fn transparencies(&self, planned: &PlannedFrame) -> Vec<f32> {
        let materials = &planned.materials;
        if materials.len() == 1 || !any_transmits(materials) {
            return vec![];
        }
        let [width, height] = planned.scene.image.size.map(|side| side as usize);
        let mut all = vec![0.0; width * height];
        let (model, triangles) = (&self.model.output, self.inputs(planned).triangles);
        for band in self.coverage(&planned.scene).bands {
            let first = band.place.first_row as usize;
            for run in &band.runs {
                let own = model.face_materials.of_face(triangles.face(run.triangle));
                let line = (first + usize::from(run.row)) * width;
                let [x0, x1] = [run.x0, run.x1].map(|x| line + usize::from(x));
                all[x0..x1].fill(materials[own].kt as f32);
            }
        }
        all
    }

    /// Returns the number of evaluations of the equation with each material in a frame of the last picture.
    pub(super) fn counts_of(&self, planned: &PlannedFrame) -> Vec<u64> {
        let (model, report) = (&self.model.output, self.report());
        let per_pixel = planned.plan.per == Per::Pixel;
        let mut counts = vec![0; planned.materials.len()];
        let mut add = |material: usize, count: u64| counts[material] += count;
        match planned.plan.per {
            Per::Pixel if model.face_materials.faces.is_empty() => add(0, report.covered),
            _ if model.face_materials.faces.is_empty() => add(0, report.points),
            Per::Pixel => counts = self.pixels_of(planned),
            Per::Face => {
                let faces = &model.face_materials.faces;
                faces.iter().for_each(|own| add(usize::from(*own), 1));
            }
            _ => {
                let vertices = &model.vertex_materials[..model.vertex_count];
                vertices.iter().for_each(|own| add(usize::from(*own), 1));
            }
        }
        // At points, each part of the picture has an evaluation of its own.
        let sum: u64 = counts.iter().sum();
        let parts = if per_pixel || sum == 0 {
            1
        } else {
            report.points / sum
        };
        counts.into_iter().map(|count| count * parts).collect()
    }

    /// Returns the names of the model's materials in the last picture, empty for the scene's, each with the number of evaluations
    /// of the equation with it; nothing for an object without materials of its own.
    pub fn material_counts(&self) -> Vec<(String, u64)> {
        let face_materials = &self.model.output.face_materials;
        let Some(planned) = self.drawn.as_ref().filter(|_| !face_materials.is_empty()) else {
            return vec![];
        };
        let counts = self.counts_of(planned).into_iter().enumerate();
        let name = |index| face_materials.name(index).unwrap_or_default().to_owned();
        counts.map(|(index, count)| (name(index), count)).collect()
    }

    /// Returns whether the vertices of the last picture's object have colours.
    pub(crate) fn is_tinted(&self) -> bool {
        self.model.output.is_tinted()
    }

    /// Returns the equation of `scene`, whose picture is the last one, in double precision with its own material.
    pub(crate) fn equation(&self, scene: &Scene) -> Equation<f64> {
        Equation::in_units(scene, self.model.output.unit(&scene.camera))
    }

    /// Returns the index of the material of a face of the last picture.
    pub(crate) fn material_of(&self, face: u32) -> usize {
        self.model.output.face_materials.of_face(face)
    }

    /// Returns the name in the model of a material by its index, and its numbers in `scene`; `None` for the scene's own.
    pub(crate) fn model_material(
        &self,
        scene: &Scene,
        index: usize,
    ) -> Option<(String, FaceMaterial)> {
        let name = self.model.output.face_materials.name(index)?.to_owned();
        let material = self
            .model
            .output
            .face_materials
            .materials(scene)
            .swap_remove(index);
        Some((name, material))
    }

    /// Returns the inputs for evaluating the last picture's pixels.
    pub(super) fn last(&self) -> Option<Inputs<'_>> {
        self.drawn.as_ref().map(|drawn| self.inputs(drawn))
    }

    /// Returns the evaluation of a pixel of the last picture; `None` where it shows the background.
    pub(crate) fn evaluation(&self, x: u32, y: u32) -> Option<Evaluation<'_>> {
        self.evaluation_seen(pixel_centre(x as usize, y as usize))
    }

    /// Returns the evaluation at any point of the last picture, on the polygon that its pixel shows.
    pub(crate) fn evaluation_seen(&self, place: DVec2) -> Option<Evaluation<'_>> {
        let last = self.last()?;
        if last.plan.true_surface {
            return last.of_surface(place);
        }
        Some(last.of_triangle(self.seen([place.x as u32, place.y as u32])?, place))
    }

    /// Returns the model's triangle that a pixel of the last picture shows.
    pub(crate) fn triangle_at(&self, pixel: [u32; 2]) -> Option<u32> {
        let triangle = self.seen(pixel)?;
        Some(self.last()?.triangles.whole(triangle) as u32)
    }

    /// Returns the triangle that a pixel of the last picture shows, one of the model's or of the clipper's.
    fn seen(&self, pixel: [u32; 2]) -> Option<u32> {
        self.coverage(&self.drawn.as_ref()?.scene)
            .triangle_at(pixel)
    }

    /// Returns I where `triangle` is visible in the picture of `scene`, which has the last model and no shadows; `None` if
    /// it is clipped.
    pub(crate) fn intensity_turned(
        &self,
        scene: &Scene,
        equations: &[Equation<f64>],
        triangle: u32,
        place: DVec2,
    ) -> Option<Rgb> {
        let (model, size) = (&self.model.output, scene.image.size);
        let plan = Plan::for_scene(scene, model);
        let lens = Lens::new(&scene.camera, size, DVec2::ZERO, model.unit(&scene.camera));
        let mut turned = PlacedTriangles::default();
        turned.placed.run(self.level(), &lens, model, size[1]);
        let triangles = turned.triangles(model);
        let whole = triangles
            .corners(triangle)
            .iter()
            .all(|corner| corner[0] != UNPLACED);
        let inputs = Inputs {
            level: self.level(),
            scene,
            plan: &plan,
            lens: &lens,
            materials: &model.face_materials.materials(scene),
            triangles,
            surface: None,
            visibility: None,
        };
        whole.then(|| inputs.of_triangle(triangle, place).intensity(equations))
    }

    /// Returns the light mixed into the equation's value at a pixel of the last picture that shows the object.
    pub(crate) fn mixture(&self, x: u32, y: u32) -> Option<Mixture> {
        let PlannedFrame { scene, plan, .. } = self.drawn.as_ref()?;
        let last = self.last().filter(|_| plan.composes)?;
        self.rays.mixture_at(&last, self.coverage(scene), [x, y])
    }

    pub(crate) fn polygon_count(&self) -> usize {
        if self.drawn.is_some() {
            self.model.output.face_count()
        } else {
            0
        }
    }

    /// Returns face `face` of the last picture's object, if there is one of that index.
    pub(crate) fn polygon(&self, face: u32) -> Option<Polygon<'_>> {
        let last = self
            .last()
            .filter(|last| (face as usize) < last.triangles.model.face_count())?;
        let corners = last.corner_points(face);
        let before_the_eye = corners
            .iter()
            .all(|at| last.lens.view_from_world(at.point).z >= NEAR);
        let model = last.triangles.model;
        let numbers: HashMap<u32, usize> = model.face(face).iter().copied().zip(0..).collect();
        let triangles = model.triangles_of(face).iter();
        Some(Polygon {
            triangles: triangles
                .map(|vertices| vertices.map(|v| numbers[&v]))
                .collect(),
            flat: last.flat_points(face),
            corners,
            before_the_eye,
        })
    }

    /// Returns the polygon that a pixel of the last picture shows, or that stands for the true surface there.
    pub(crate) fn polygon_at(&self, x: u32, y: u32) -> Option<u32> {
        let last = self.last()?;
        if !last.plan.true_surface {
            return self.evaluation(x, y)?.face;
        }
        let (model, lens) = (last.triangles.model, last.lens);
        let (origin, along) = lens.ray(pixel_centre(x as usize, y as usize));
        let distance = |vertices: &[u32; 3]| {
            let [a, b, c] = vertices.map(|v| (model.position(v) - lens.eye) / lens.unit);
            distance_to([a, b, c], origin, along).filter(|distance| *distance >= NEAR)
        };
        let hits = model.triangles.iter().zip(&model.faces);
        let hits = hits.filter_map(|(vertices, face)| Some((distance(vertices)?, *face)));
        hits.min_by(|a, b| a.0.total_cmp(&b.0))
            .map(|(_, face)| face)
    }
}

/// Returns the distance along a ray to a triangle, in lengths of its direction (Möller and Trumbore 1997).
fn distance_to([a, b, c]: [DVec3; 3], origin: DVec3, along: DVec3) -> Option<f64> {
    let (e1, e2, from) = (b - a, c - a, origin - a);
    let (p, q) = (along.cross(e2), from.cross(e1));
    let determinant = e1.dot(p);
    let [u, v, distance] = [from.dot(p), along.dot(q), e2.dot(q)].map(|part| part / determinant);
    (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && distance.is_finite()).then_some(distance)
}
