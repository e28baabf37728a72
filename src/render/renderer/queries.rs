//! What can be asked about the last picture.

use super::cue::Cue;
use super::frame::{Frame, Report};
use super::pipeline::{Drawn, Renderer, Samples};
use super::plan::Plan;
use super::ray_nodes::{RayInputs, SeenAt};
use super::reference::{Evaluation, Reference};
use crate::geometry::Mesh;
use crate::illumination::Equation;
use crate::render::lens::Lens;
use crate::render::raster::{PlacedTriangles, UNPLACED};
use crate::render::rays::Transmission;
use crate::scene::{Rgb, Scene};
use glam::DVec2;
use std::sync::Arc;

/// What is mixed into the equation's value at a pixel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mixture {
    /// Where light passes through the surface.
    pub transmission: Option<Transmission>,
    /// What light from other surfaces has in excess of the constant ambient term that it takes the place of.
    pub bounced: Option<Rgb>,
}

/// The centre of a pixel.
fn centre([x, y]: [u32; 2]) -> DVec2 {
    DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5)
}

impl Renderer {
    /// The last picture.
    pub fn frame(&self) -> &Frame {
        &self.picture.output.frame
    }

    /// The last picture before the display, row by row: linear red, green, blue, and the part of the pixel that shows the
    /// object. Empty unless [`Renderer::keep_linear`] asked for it or the display needed all of it.
    pub fn linear(&self) -> &[[f32; 4]] {
        &self.picture.output.linear
    }

    /// What the last call of [`Renderer::render`] did.
    pub fn report(&self) -> &Report {
        &self.report
    }

    /// The plan of the last picture.
    pub fn plan(&self) -> Option<&Plan> {
        self.drawn.as_ref().map(|drawn| &drawn.plan)
    }

    /// The polygons of the last picture, before they were given vertex normals; shared, to be kept and known again.
    pub(crate) fn mesh_shown(&self) -> &Arc<Mesh> {
        self.mesh.output.mesh()
    }

    /// Draws `scene`, which is exact, and says whether the picture shows a surface beyond its polygons.
    pub(crate) fn shows_surface(&mut self, scene: &Scene) -> bool {
        self.render(scene);
        self.plan().is_some_and(|plan| plan.true_surface)
    }

    /// Draws the scene and returns it before the display: linear red, green, blue, and 1 where the object is seen.
    pub(crate) fn linear_picture(&mut self, scene: &Scene) -> Vec<[f32; 4]> {
        self.draw(scene, Samples { size: scene.image.size, offset: DVec2::ZERO, linear: true });
        let linear = self.linear().to_vec();
        self.redraw();
        linear
    }

    /// The equation of `scene`, whose picture is the last one, in double precision.
    pub(crate) fn equation(&self, scene: &Scene) -> Equation<f64> {
        Equation::in_units(scene, self.facts().unit(&scene.camera))
    }

    /// The same with the lights that the picture is shaded with.
    pub(crate) fn shining_equation(&self, scene: &Scene) -> Equation<f64> {
        let mut equation = self.equation(scene);
        if let Some(plan) = self.plan() {
            equation.retain_lights(|light| plan.lights[light]);
        }
        equation
    }

    /// Where the equation is evaluated for a pixel of the last picture; nothing where the background is seen.
    pub(crate) fn evaluation(&self, x: u32, y: u32) -> Option<Evaluation<'_>> {
        self.evaluation_seen(centre([x, y]))
    }

    /// The same for any place of the last picture, on the polygon that its pixel sees.
    pub(crate) fn evaluation_seen(&self, place: DVec2) -> Option<Evaluation<'_>> {
        let reference = self.reference()?;
        if reference.plan.true_surface {
            return reference.of_surface(place);
        }
        let triangle = self.coverage().triangle_at([place.x as u32, place.y as u32])?;
        Some(reference.of_triangle(triangle, place))
    }

    /// The model's triangle that a pixel of the last picture sees.
    pub(crate) fn triangle_at(&self, pixel: [u32; 2]) -> Option<u32> {
        let triangle = self.coverage().triangle_at(pixel)?;
        Some(self.triangles().whole(triangle) as u32)
    }

    /// I where `triangle` is seen at `place` in the picture of `scene`, which casts no shadows and has the last picture's
    /// model: only its vertices are placed anew. Nothing where the triangle would have to be clipped.
    pub(crate) fn intensity_turned(
        &self,
        scene: &Scene,
        equation: &Equation<f64>,
        triangle: u32,
        place: DVec2,
    ) -> Option<Rgb> {
        let (facts, model, size) = (self.facts(), &self.model.output, scene.image.size);
        let plan = Plan::for_scene(scene, &facts);
        let lens = Lens::new(&scene.camera, size, DVec2::ZERO, facts.unit(&scene.camera));
        let mut turned = PlacedTriangles::default();
        turned.placed.run(self.level, &lens, model, size[1]);
        let triangles = turned.triangles(model);
        let whole = triangles.corners(triangle).iter().all(|corner| corner[0] != UNPLACED);
        let reference =
            Reference { scene, plan: &plan, lens: &lens, triangles, surface: None, visibility: None, cue: None };
        whole.then(|| reference.of_triangle(triangle, place).intensity(equation))
    }

    /// What evaluations of the last picture read.
    pub(super) fn reference(&self) -> Option<Reference<'_>> {
        let Drawn { scene, plan, lens } = self.drawn.as_ref()?;
        let (surface, visibility) = (self.surface.output.as_ref(), self.rays.visibility(plan));
        let cue = Cue::for_plan(scene, plan, lens);
        Some(Reference { scene, plan, lens, triangles: self.triangles(), surface, visibility, cue })
    }

    /// What is mixed into the equation's value at a pixel of the last picture that shows the object.
    pub(crate) fn mixture(&self, x: u32, y: u32) -> Option<Mixture> {
        let Drawn { scene, plan, lens } = self.drawn.as_ref()?;
        if !plan.composes {
            return None;
        }
        let (triangles, surface) = (self.triangles(), self.surface.output.as_ref());
        let inputs = RayInputs { level: self.level, scene, plan, lens, triangles, surface, object: 0 };
        let seen = if plan.true_surface {
            SeenAt::Surface(self.coverage().fragment_at([x, y])?)
        } else {
            SeenAt::Triangle(self.coverage().triangle_at([x, y])?)
        };
        let passes = scene.transparency.kt > 0.0;
        let transmission = if passes { self.rays.transmission_at(&inputs, centre([x, y]), seen) } else { None };
        Some(Mixture { transmission, bounced: self.rays.bounced_at(scene, x, y) })
    }
}
