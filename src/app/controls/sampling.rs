//! The error of an area light's points, computed in the background.

use crate::analysis::Watch;
use crate::analysis::codec::Codec;
use crate::analysis::sampling::{SamplingError, sampling_error};
use crate::app::session::document::{Document, same_model};
use crate::app::widgets::background::wake;
use crate::jobs::{Background, Request, Work};
use eframe::egui::Context;
use serde::{Deserialize, Serialize};

/// State of the error of an area light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Finding {
    /// The error is being computed, or waits until the scene stops changing.
    Waiting,
    /// The light does not shine, or the object is not visible.
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
        Ok(sampling_error(
            &mut subject.renderer(),
            &subject.scene,
            self.question.0,
        ))
    }
}

/// Background computation of one error at a time.
#[derive(Debug, Default)]
pub struct Sampling {
    /// Request of the last frame. Its repetition means that the scene has stopped changing.
    last: Option<Request<AreaLight>>,
    found: Background<Request<AreaLight>>,
}

impl Sampling {
    /// Returns the error of the area light with index `light`.
    ///
    /// An unknown error is computed as soon as the scene has been the same for two frames and no pointer button is held.
    pub fn ask(&mut self, ctx: &Context, document: &Document, light: usize) -> Finding {
        self.found.take();
        let Document { scene, model, .. } = document;
        let light = AreaLight(light);
        // The error does not depend on the display or on names.
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
