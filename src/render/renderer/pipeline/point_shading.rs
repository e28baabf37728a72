//! The step in which the equation is evaluated at vertices or faces.

use super::{PlannedFrame, Renderer};
use crate::render::renderer::frame::Stage;
use crate::render::renderer::plan::{Cued, Per};
use crate::render::renderer::points::{
    PointIntensities, face_points, shade_points, shade_points_in_double,
};
use std::mem::take;

impl Renderer {
    /// Evaluates the equation at vertices or faces, where the mode evaluates it there. Returns whether that is done for all of
    /// them.
    pub(super) fn points(&mut self, planned: &PlannedFrame) -> bool {
        let PlannedFrame {
            scene,
            plan,
            lens,
            parts,
            ..
        } = planned;
        self.report.points = 0;
        if plan.per == Per::Pixel {
            return true;
        }
        let at_faces = plan.per == Per::Face;
        let count = if at_faces {
            self.model.output.face_count()
        } else {
            self.model.output.vertex_count
        };
        if plan.shadows {
            let began = self.now();
            let mut rays = take(&mut self.rays);
            let ran = rays.shadow_points(&self.inputs(planned), self.model.stamp, count);
            self.rays = rays;
            self.note(Stage::Rays, ran, began, 0);
        }
        let began = self.now();
        if at_faces {
            self.faces.update(self.model.stamp, |faces| {
                *faces = face_points(&self.model.output);
            });
        }
        let cue =
            (plan.cued == Cued::AtPoints).then_some((scene.depth_cueing, lens.eye, lens.forward));
        let visibility = plan.shadows.then(|| self.rays.stamps()[0]);
        let key = (
            self.model.stamp,
            parts.clone(),
            plan.per,
            plan.double,
            visibility,
            cue,
        );
        let mut points = take(&mut self.points);
        if points.outdate(key) {
            points.output.resize_with(parts.len(), Default::default);
            points.output.iter_mut().for_each(PointIntensities::begin);
        }
        let (clock, deadline) = (self.clock, self.deadline());
        let passed = || clock.is_some_and(|clock| clock() > deadline);
        let pending = |part: &PointIntensities| part.is_pending();
        let ran = points.output.iter().any(pending);
        if ran {
            let (inputs, model) = (self.inputs(planned), &self.model.output);
            let at = if at_faces {
                self.faces.output.each_ref()
            } else {
                [&model.position, &model.normal, &model.tint]
            };
            let parts = parts.iter().zip(&mut points.output);
            for (part, own) in parts.filter(|(_, own)| own.is_pending()) {
                if plan.double {
                    shade_points_in_double(&inputs, &part.in_double(&inputs), at, own, &passed);
                } else {
                    shade_points(&inputs, &part.equations, at, own, &passed);
                }
                if plan.cued == Cued::AtPoints && !own.is_pending() {
                    inputs.fade_points(model.origin, at[0], &mut own.planes);
                }
            }
        }
        let finished = !points.output.iter().any(pending);
        self.points = points;
        self.report.points = (count * parts.len()) as u64;
        self.note(Stage::VertexShading, ran, began, self.report.points);
        finished
    }
}
