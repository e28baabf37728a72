//! One question after the other, the latest answer kept.

use super::{Answered, Job, News, Work};
use std::fmt::{self, Debug, Formatter};
use std::sync::Arc;
use std::time::Duration;

/// The answer that is known, and the work on the next one.
pub struct Background<W: Work> {
    known: Option<Answered<W>>,
    job: Option<Job<W>>,
    /// Whether the work that the answer is of was cancelled.
    stopped: bool,
}

impl<W: Work> Default for Background<W> {
    fn default() -> Self {
        Self { known: None, job: None, stopped: false }
    }
}

impl<W: Work> Debug for Background<W> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.debug_struct("Background").field("known", &self.known.is_some()).field("job", &self.job).finish()
    }
}

impl<W: Work> Background<W> {
    /// Answers `work` in the background unless that is the `same` as what is known; the work under way is done first. Returns
    /// whether something new has come.
    pub fn ask(
        &mut self,
        wake: impl Fn(Duration) + Send + Sync + 'static,
        same: impl Fn(&W) -> bool,
        work: impl FnOnce() -> W,
    ) -> bool {
        let new = self.take();
        if self.job.is_none() && !self.known.as_ref().is_some_and(|(known, _)| same(known)) {
            self.start(work(), wake);
        }
        new
    }

    /// Begins `work` in place of whatever is under way.
    pub fn start(&mut self, work: W, wake: impl Fn(Duration) + Send + Sync + 'static) {
        self.job = Some(Job::start(work, wake));
    }

    /// Takes what has come; returns whether that is anything.
    pub fn take(&mut self) -> bool {
        let Some((work, cancelled, news)) =
            self.job.as_ref().and_then(|job| Some((Arc::clone(&job.work), job.is_cancelled(), job.news()?)))
        else {
            return false;
        };
        match news {
            News::SoFar(answer) => self.known = Some((work, Ok(answer))),
            News::Over(answer) => {
                self.known = Some((work, answer));
                self.stopped = cancelled;
                self.job = None;
            }
        }
        true
    }

    /// Cancels the work under way and forgets the answer, where these are not of the question wanted.
    pub fn keep_only(&mut self, same: impl Fn(&W) -> bool) {
        self.known.take_if(|(known, _)| !same(known));
        self.job.take_if(|job| !same(&job.work));
    }

    /// The answer last known, or why there is none.
    pub fn known(&self) -> Option<&Result<W::Answer, String>> {
        self.known.as_ref().map(|(_, answer)| answer)
    }

    /// The answer last known.
    pub fn answer(&self) -> Option<&W::Answer> {
        self.known()?.as_ref().ok()
    }

    /// What that is the answer to.
    pub fn answered(&self) -> Option<&W> {
        self.known.as_ref().map(|(work, _)| &**work)
    }

    /// How far the work is, from 0 to 1, while it runs.
    pub fn progress(&self) -> Option<f32> {
        self.job.as_ref().map(Job::share)
    }

    /// Ends the work soon; what it has found by then is its answer.
    pub fn stop(&self) {
        self.job.iter().for_each(Job::cancel);
    }

    /// Whether the answer is that of work that was stopped.
    pub fn stopped(&self) -> bool {
        self.stopped && self.job.is_none()
    }
}
