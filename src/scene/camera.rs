//! The camera: where the picture is seen from, and where the equation's viewer stands.

use super::choice::choices;
use glam::DVec3;

#[derive(Clone, Debug, PartialEq)]
pub struct Camera {
    /// Position of the eye, world.
    pub eye: DVec3,
    /// The point looked at, world; the middle of the picture.
    pub target: DVec3,
    /// The direction that appears upwards.
    pub up: DVec3,
    /// The picture's content is turned by this about its middle, counter-clockwise, degrees.
    pub roll: f64,
    pub projection: Projection,
    /// Vertical field of view in degrees, perspective only.
    pub fov_y: f64,
    /// World units seen from bottom to top, orthographic only.
    pub height: f64,
    pub viewer: Viewer,
}

impl Default for Camera {
    fn default() -> Self {
        Self {
            eye: DVec3::new(0.0, 0.0, 4.0),
            target: DVec3::ZERO,
            up: DVec3::Y,
            roll: 0.0,
            projection: Projection::Perspective,
            fov_y: 40.0,
            height: 2.5,
            viewer: Viewer::Local,
        }
    }
}

impl Camera {
    /// Distance from eye to target, world units: the scene's own measure of length.
    pub fn distance(&self) -> f64 {
        let span = self.eye - self.target;
        let largest = span.abs().max_element();
        if largest > 0.0 { (span / largest).length() * largest } else { 1.0 }
    }
}

choices! {
    pub enum Projection {
        Perspective = "perspective", "perspective", "As an eye or a camera sees";
        Orthographic = "orthographic", "orthographic", "Parallel rays: no foreshortening";
    }
}

choices! {
    /// Where the equation's V points.
    pub enum Viewer {
        Local = "local", "at the eye", "V points to the eye from each point";
        Infinite = "infinite", "at infinity", "V is constant, from target to eye";
    }
}
