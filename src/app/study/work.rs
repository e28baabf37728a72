//! Measures beside the window; what is known so far is shared with it.

use super::super::document::Document;
use super::super::errand::Errand;
use super::Choices;
use crate::analysis::{Plot, Study, StudyQuestion, Watch, study, study_plot};
use crate::figure::{Drawing, PlotStyle};
use crate::jobs::nanoseconds as clock;
use eframe::egui::Context;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

/// The window is drawn at most this often for new points, so that drawing it disturbs the times little.
const PAUSE: Duration = Duration::from_millis(250);

/// The tab's state.
#[derive(Debug, Default)]
pub struct StudyView {
    pub choices: Choices,
    /// What was last said about a point that was chosen.
    pub told: Option<String>,
    work: Option<Errand<(), Study>>,
    shared: Arc<Shared>,
    pub(super) study: Option<Study>,
    pub(super) plot: Option<Plot>,
    /// Laid out for this style and width.
    pub(super) drawing: Option<(Drawing, PlotStyle, f32)>,
}

/// Between the window and the work.
#[derive(Debug, Default)]
struct Shared {
    cancel: AtomicBool,
    news: Mutex<News>,
}

#[derive(Debug, Default)]
struct News {
    share: f32,
    /// What is known, until the window takes it.
    study: Option<Study>,
}

struct Watching<'a> {
    shared: &'a Shared,
    repaint: Context,
}

impl Watch<Study> for Watching<'_> {
    fn at(&self, share: f32) -> bool {
        self.shared.news.lock().unwrap_or_else(PoisonError::into_inner).share = share;
        self.repaint.request_repaint_after(PAUSE);
        !self.shared.cancel.load(Ordering::Relaxed)
    }

    fn found(&self, study: &Study) {
        self.shared.news.lock().unwrap_or_else(PoisonError::into_inner).study = Some(study.clone());
    }
}

impl StudyView {
    /// Begins to measure the document at a picture of `size`.
    pub fn start(&mut self, ctx: &Context, document: &Document, size: [u32; 2], request: StudyQuestion) {
        let (mut scene, model) = (document.scene.clone(), document.model.clone());
        scene.image.size = size;
        let shared = Arc::new(Shared::default());
        self.shared = Arc::clone(&shared);
        (self.study, self.plot, self.drawing, self.told) = (None, None, None, None);
        let repaint = ctx.clone();
        self.work = Some(Errand::new(ctx, (), move || {
            study(&scene, model, &request, clock, &Watching { shared: &shared, repaint })
        }));
    }

    /// Ends the work after its present frame.
    pub fn stop(&self) {
        self.shared.cancel.store(true, Ordering::Relaxed);
    }

    /// How far it is, from 0 to 1, while it runs.
    pub fn progress(&self) -> Option<f32> {
        self.work.as_ref().map(|_| self.shared.news.lock().unwrap_or_else(PoisonError::into_inner).share)
    }

    /// Takes what is new.
    pub fn receive(&mut self) {
        let news = self.shared.news.lock().unwrap_or_else(PoisonError::into_inner).study.take();
        let over = Errand::take(&mut self.work);
        if let Some(((), None)) = &over {
            self.told = Some("The study ended without a result.".to_owned());
        }
        let Some(study) = over.and_then(|((), answer)| answer).or(news) else { return };
        if let Some(omitted) = study.omitted.first().filter(|_| study.rows.is_empty()) {
            self.told = Some(format!("Nothing to measure: {}.", omitted.reason));
        }
        self.plot = study_plot(&study);
        self.drawing = None;
        self.study = Some(study);
    }

    /// What is known.
    pub fn study(&self) -> Option<&Study> {
        self.study.as_ref()
    }
}

impl Drop for StudyView {
    fn drop(&mut self) {
        self.stop();
    }
}
