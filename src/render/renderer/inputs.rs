//! What the steps of a frame read.

use super::plan::{Cued, Plan};
use crate::geometry::Surface;
use crate::illumination::Equation;
use crate::render::lens::Lens;
use crate::render::raster::Triangles;
use crate::render::rays::Visibility;
use crate::scene::{DepthCueing, Scene};
use fearless_simd::Level;
use glam::{DVec3, Vec3};

/// What the steps of a frame read, and whoever evaluates a pixel of it again.
#[derive(Clone, Copy)]
pub struct Inputs<'a> {
    pub level: Level,
    pub scene: &'a Scene,
    pub plan: &'a Plan,
    pub lens: &'a Lens,
    pub triangles: Triangles<'a>,
    pub surface: Option<&'a Surface>,
    /// Which sources are seen from which pixels, faces or vertices, where there are shadows.
    pub visibility: Option<&'a Visibility>,
    pub cue: Option<Cue>,
}

impl Inputs<'_> {
    /// The equation in double precision with the lights that the picture is shaded with.
    pub fn equation(&self) -> Equation<f64> {
        let mut equation = Equation::in_units(self.scene, self.lens.unit);
        equation.retain_lights(|light| self.plan.lights[light]);
        equation
    }
}

/// Depth cueing: the law, and the eye from which depths are measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cue {
    pub law: DepthCueing,
    eye: DVec3,
    forward: DVec3,
}

impl Cue {
    /// The cue of a scene, where the plan has any.
    pub fn for_plan(scene: &Scene, plan: &Plan, lens: &Lens) -> Option<Self> {
        let cue = Self { law: scene.depth_cueing, eye: lens.eye, forward: lens.forward };
        (plan.cued != Cued::Nowhere).then_some(cue)
    }

    /// s0 at a point, world.
    pub fn at(&self, point: DVec3) -> f64 {
        self.law.scale_at((point - self.eye).dot(self.forward))
    }

    /// Idc.
    pub fn color(&self) -> Vec3 {
        self.law.color.as_vec3()
    }
}
