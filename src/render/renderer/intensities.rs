//! The equation at the points that a picture needs, where these are vertices or faces.

use super::Renderer;
use super::inputs::IntensityInputs;
use crate::illumination::Equation;
use crate::render::Stage;
use crate::render::cue::Cue;
use crate::render::interpolate::Sources;
use crate::render::lens::Lens;
use crate::render::plan::{Cued, Per, Plan};
use crate::render::points::{PointShading, face_points};
use crate::render::rays::RayInputs;
use crate::scene::Scene;

impl Renderer {
    /// Intensities at vertices or faces.
    pub(super) fn shade_points(&mut self, scene: &Scene, plan: &Plan, lens: &Lens, equation: &Equation<f32>) {
        self.traced = (false, 0);
        self.report.points = 0;
        if plan.per == Per::Pixel {
            self.note(Stage::VertexShading, false, 0, 0);
            return;
        }
        let reach = if plan.shadows { self.reach_points(scene, plan, lens) } else { None };
        let began = (self.clock)();
        let at_faces = plan.per == Per::Face;
        let model = &self.model.output;
        if at_faces {
            self.faces.update(self.model.stamp(), |_, faces| *faces = face_points(model));
        }
        let count = if at_faces { model.face_count() } else { model.vertex_count };
        let bits = self.rays.reach(plan);
        let faces = &self.faces.output;
        let (position, normal) = if at_faces { (&faces.0, &faces.1) } else { (&model.position, &model.normal) };
        let cue = Cue::of(scene, plan, lens).filter(|_| plan.cued == Cued::AtPoints);
        let (per, double) = (plan.per, plan.double);
        let inputs = IntensityInputs { model: self.model.stamp(), equation: equation.clone(), per, double, reach, cue };
        let level = self.level;
        let ran = self.intensity.update(inputs, |inputs, intensity| {
            let shading = PointShading {
                level,
                equation: &inputs.equation,
                origin: model.origin,
                unit: lens.unit,
                eye: lens.eye,
                radius: model.radius,
                position,
                normal,
                intensity: &mut *intensity,
                reach: bits,
            };
            if plan.double {
                let mut equation = Equation::<f64>::in_units(scene, lens.unit);
                equation.retain_lights(|light| plan.lights[light]);
                shading.run_in_double(&equation);
            } else {
                inputs.equation.form().dispatch(shading);
            }
            if let Some(cue) = &inputs.cue {
                cue.fade_points(model.origin, position, intensity);
            }
        });
        self.report.points = count as u64;
        self.note(Stage::VertexShading, ran, began, if ran { self.report.points } else { 0 });
    }

    /// Which sources reach the points where the equation is evaluated; the run, where there are shadows.
    fn reach_points(&mut self, scene: &Scene, plan: &Plan, lens: &Lens) -> Option<u64> {
        let began = (self.clock)();
        let model = &self.model.output;
        let (placed, clipped, _) = &self.placed.output;
        let sources = Sources { model, clipped, placed, carried: &[] };
        let inputs =
            RayInputs { level: self.level, scene, plan, lens, sources, surface: None, object: self.model.stamp() };
        let at_faces = plan.per == Per::Face;
        let count = if at_faces { model.face_count() } else { model.vertex_count };
        #[expect(clippy::cast_possible_truncation, reason = "vertices and faces are counted in 32 bits")]
        let point = |index: usize| {
            let index = index as u32;
            if at_faces {
                (model.face_centre(index), model.face_normal(index))
            } else {
                (model.position(index), model.normal(index))
            }
        };
        let ran = self.rays.reach_points(&inputs, count, point);
        self.traced = (ran, if ran { (self.clock)().saturating_sub(began) } else { 0 });
        plan.shadows.then(|| self.rays.stamps()[0])
    }
}
