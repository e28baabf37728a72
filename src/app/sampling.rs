//! The error of an area light's points, worked out beside the window: the interface never waits for it.

use super::document::{Document, same_model};
use super::errand::Errand;
use crate::analysis::{SamplingError, sampling_error_with};
use crate::geometry::Mesh;
use crate::render::Renderer;
use crate::scene::{Display, Scene};
use eframe::egui::Context;
use std::sync::Arc;

/// What is known of an area light's error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Finding {
    /// It is being worked out, or waits until the scene rests.
    Waiting,
    /// The light does not shine, or the object is not seen.
    Nothing,
    Error(SamplingError),
}

/// Works out one error at a time.
#[derive(Debug, Default)]
pub struct Sampling {
    /// What was asked for in the last frame: what rests is the same again.
    last: Option<Question>,
    known: Option<(Question, Option<SamplingError>)>,
    work: Option<Errand<Question, Option<SamplingError>>>,
}

#[derive(Clone, Debug)]
struct Question {
    scene: Scene,
    model: Option<Arc<Mesh>>,
    light: usize,
}

impl Question {
    fn of(document: &Document, light: usize) -> Self {
        let mut scene = document.scene.clone();
        // What the error does not depend on.
        scene.display = Display::default();
        scene.lights.iter_mut().for_each(|light| light.name.clear());
        Self { scene, model: document.model.clone(), light }
    }

    fn same(&self, other: &Self) -> bool {
        same_model(self.model.as_ref(), other.model.as_ref()) && self.light == other.light && self.scene == other.scene
    }

    fn answer(&self) -> Option<SamplingError> {
        let mut renderer = Renderer::default();
        renderer.set_model(self.model.clone());
        sampling_error_with(&mut renderer, &self.scene, self.light)
    }
}

impl Sampling {
    /// The error of the area light of index `light`. Where it is not known, it is worked out as soon as the scene has
    /// been the same for two frames and no pointer is held.
    pub fn ask(&mut self, ctx: &Context, document: &Document, light: usize) -> Finding {
        self.take();
        let question = Question::of(document, light);
        if let Some((_, error)) = self.known.as_ref().filter(|(known, _)| known.same(&question)) {
            return error.map_or(Finding::Nothing, Finding::Error);
        }
        let rests = self.last.as_ref().is_some_and(|last| last.same(&question));
        let held = ctx.input(|input| input.pointer.any_down());
        if !rests {
            ctx.request_repaint();
            self.last = Some(question);
        } else if !held && self.work.is_none() {
            self.work = Some(Errand::new(ctx, question.clone(), move || question.answer()));
        }
        Finding::Waiting
    }

    /// Takes what the thread has brought.
    fn take(&mut self) {
        if let Some((question, error)) = Errand::take(&mut self.work) {
            self.known = Some((question, error.flatten()));
        }
    }
}
