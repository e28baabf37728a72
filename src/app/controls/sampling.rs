//! The error of an area light's points, computed in the background.

use crate::analysis::{Codec, SamplingError, Watch, sampling_error_with};
use crate::app::session::document::{Document, same_model};
use crate::app::widgets::background::wake;
use crate::jobs::{Background, Request, Work};
use eframe::egui::Context;
use serde::{Deserialize, Serialize};

/// What is known of an area light's error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Finding {
    /// It is being computed, or waits until the scene rests.
    Waiting,
    /// The light does not shine, or the object is not seen.
    Nothing,
    Error(SamplingError),
}

/// The index of an area light.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct AreaLight(usize);

impl Work for Request<AreaLight> {
    type Answer = Option<SamplingError>;

    const CODECS: Option<(Codec<Self>, Codec<Self::Answer>)> =
        Some((Codec::plain(), Codec::plain()));

    fn run(&self, _: &dyn Watch<Self::Answer>) -> Result<Self::Answer, String> {
        let subject = self.subject();
        Ok(sampling_error_with(
            &mut subject.renderer(),
            &subject.scene,
            self.question.0,
        ))
    }
}

/// Computes one error at a time.
#[derive(Debug, Default)]
pub struct Sampling {
    /// What was asked for in the last frame: what rests is the same again.
    last: Option<Request<AreaLight>>,
    found: Background<Request<AreaLight>>,
}

impl Sampling {
    /// The error of the area light of index `light`. Where it is not known, it is computed as soon as the scene has been the
    /// same for two frames and no pointer is held.
    pub fn ask(&mut self, ctx: &Context, document: &Document, light: usize) -> Finding {
        self.found.take();
        let Document { scene, model, .. } = document;
        let light = AreaLight(light);
        // The error does not depend on the display and on names.
        let same = |asked: &Request<AreaLight>| {
            let mut differences = asked.scene.differences(scene);
            asked.question == light
                && same_model(asked.model.as_ref(), model.as_ref())
                && differences.all(|(parameter, _)| {
                    parameter.section() == "display" || parameter.key == "light.N.name"
                })
        };
        if self.found.answered().is_some_and(same) {
            return self
                .found
                .answer()
                .copied()
                .flatten()
                .map_or(Finding::Nothing, Finding::Error);
        }
        let asked = || Request::new(light, scene, model.as_ref(), scene.image.size);
        if ctx.input(|input| input.pointer.any_down()) {
            return Finding::Waiting;
        }
        if self.last.as_ref().is_some_and(same) {
            self.found.ask(wake(ctx), same, asked);
        } else {
            ctx.request_repaint();
            self.last = Some(asked());
        }
        Finding::Waiting
    }
}
