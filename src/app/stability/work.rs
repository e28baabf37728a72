//! Draws the catalogue beside the window, case by case.

use super::super::errand::Errand;
use crate::analysis::{CaseResult, stability, stability_cases};
use crate::render::Renderer;
use eframe::egui::{Context, TextureHandle};
use std::fmt;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, channel};

/// The tab's state.
#[derive(Default)]
pub struct StabilityView {
    pub results: Vec<CaseResult>,
    /// The case that is shown.
    pub chosen: usize,
    /// Why there are no further results.
    pub told: Option<String>,
    /// The pictures of the case that is shown.
    pub(super) shown: Option<[TextureHandle; 3]>,
    work: Option<Work>,
    begun: bool,
}

struct Work {
    errand: Option<Errand<(), ()>>,
    results: Receiver<CaseResult>,
    cancel: Arc<AtomicBool>,
}

impl StabilityView {
    /// Begins when called for the first time; takes what has come since.
    pub fn receive(&mut self, ctx: &Context) {
        if !std::mem::replace(&mut self.begun, true) {
            self.work = Some(Work::start(ctx));
        }
        let Some(work) = &mut self.work else { return };
        let over = Errand::take(&mut work.errand);
        self.results.extend(work.results.try_iter());
        if let Some(((), answer)) = over {
            if answer.is_none() {
                self.told = Some("The catalogue ended before all cases were drawn.".to_owned());
            }
            self.work = None;
        }
    }

    /// Shows another case.
    pub fn choose(&mut self, index: usize) {
        if index != self.chosen {
            (self.chosen, self.shown) = (index, None);
        }
    }
}

impl Work {
    fn start(ctx: &Context) -> Self {
        let (sender, results) = channel();
        let cancel = Arc::new(AtomicBool::new(false));
        let (stop, repaint) = (Arc::clone(&cancel), ctx.clone());
        let errand = Errand::new(ctx, (), move || {
            let mut renderer = Renderer::default();
            for case in stability_cases() {
                if stop.load(Ordering::Relaxed) || sender.send(stability(&mut renderer, case)).is_err() {
                    return;
                }
                repaint.request_repaint();
            }
        });
        Self { errand: Some(errand), results, cancel }
    }
}

impl Drop for Work {
    fn drop(&mut self) {
        self.cancel.store(true, Ordering::Relaxed);
    }
}

impl fmt::Debug for StabilityView {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("StabilityView").field("results", &self.results.len()).field("chosen", &self.chosen).finish()
    }
}
