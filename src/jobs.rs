//! Work in the background: plain data is given to a thread, which brings an answer back. Nothing else starts threads.
//!
//! A [`Job`] is one piece of work with its progress; [`Background`] asks one question after the other and keeps the latest
//! answer. Work and answers are data, so that a worker of a web page can stand in for the thread.

mod asked;
mod background;

pub use asked::Asked;
pub use background::Background;

use crate::analysis::Watch;
use std::fmt::{self, Debug, Formatter};
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::sync::mpsc::{Receiver, Sender, TryRecvError, channel};
use std::sync::{Arc, OnceLock};
use std::thread;
use std::time::{Duration, Instant};

/// Progress is shown this often at most: to draw the window disturbs what is measured.
const PAUSE: Duration = Duration::from_millis(200);

/// Nanoseconds since the first call.
pub fn nanoseconds() -> u64 {
    static START: OnceLock<Instant> = OnceLock::new();
    u64::try_from(START.get_or_init(Instant::now).elapsed().as_nanos()).unwrap_or(u64::MAX)
}

/// Something to be done.
pub trait Work: Send + Sync + 'static {
    type Answer: Clone + Send + Sync + 'static;

    /// Does it.
    ///
    /// # Errors
    /// Why there is no answer, in a sentence.
    fn run(&self, watch: &dyn Watch<Self::Answer>) -> Result<Self::Answer, String>;
}

/// Work that is done, with its answer or why there is none.
pub type Answered<W> = (Arc<W>, Result<<W as Work>::Answer, String>);

/// Work under way. Dropping it cancels it.
pub struct Job<W: Work> {
    pub work: Arc<W>,
    progress: Arc<Progress>,
    news: Receiver<News<W::Answer>>,
}

/// What comes from a job.
pub enum News<A> {
    /// What is known so far.
    SoFar(A),
    Over(Result<A, String>),
}

#[derive(Debug, Default)]
struct Progress {
    cancel: AtomicBool,
    /// In thousandths.
    share: AtomicU32,
}

/// Asks whoever waits to look again after a while.
type Wake = Arc<dyn Fn(Duration) + Send + Sync>;

/// The job's side of it.
struct Teller<A> {
    progress: Arc<Progress>,
    news: Sender<News<A>>,
    wake: Wake,
}

impl<A: Clone + Send + Sync> Watch<A> for Teller<A> {
    fn at(&self, share: f32) -> bool {
        self.progress.share.store((1000.0 * share) as u32, Ordering::Relaxed);
        (self.wake)(PAUSE);
        !self.progress.cancel.load(Ordering::Relaxed)
    }

    fn found(&self, so_far: &A) {
        // The receiver may be gone; dropping the answer is fine.
        let _ = self.news.send(News::SoFar(so_far.clone()));
    }
}

impl<W: Work> Job<W> {
    /// Starts on a thread. `wake` is called, with how long to wait, when there is something to take.
    pub fn start(work: W, wake: impl Fn(Duration) + Send + Sync + 'static) -> Self {
        let (sender, news) = channel();
        let (work, progress) = (Arc::new(work), Arc::new(Progress::default()));
        let job = Self { work: Arc::clone(&work), progress: Arc::clone(&progress), news };
        let teller = Teller { progress, news: sender, wake: Arc::new(wake) };
        thread::spawn(move || {
            // Its end is noticed even if it panics: then the channel is closed without an answer.
            let _wake = WakeAtEnd(Arc::clone(&teller.wake));
            let answer = work.run(&teller);
            let _ = teller.news.send(News::Over(answer));
        });
        job
    }

    /// How far it is, from 0 to 1.
    #[expect(clippy::cast_precision_loss, reason = "a share for the eye")]
    pub fn share(&self) -> f32 {
        self.progress.share.load(Ordering::Relaxed) as f32 / 1000.0
    }

    /// Asks it to end soon with what it has.
    pub fn cancel(&self) {
        self.progress.cancel.store(true, Ordering::Relaxed);
    }

    pub fn is_cancelled(&self) -> bool {
        self.progress.cancel.load(Ordering::Relaxed)
    }

    /// The latest that has come since the last call.
    pub fn news(&self) -> Option<News<W::Answer>> {
        let mut latest = None;
        loop {
            match self.news.try_recv() {
                Ok(News::SoFar(answer)) => latest = Some(News::SoFar(answer)),
                Ok(over) => return Some(over),
                Err(TryRecvError::Empty) => return latest,
                Err(TryRecvError::Disconnected) => {
                    return Some(News::Over(Err("It ended without a result.".to_owned())));
                }
            }
        }
    }

    /// Waits until it is over.
    pub fn wait(self) {
        while self.news.recv().is_ok_and(|news| matches!(news, News::SoFar(_))) {}
    }

    /// Takes a job out of `slot` when it is over.
    pub fn take(slot: &mut Option<Self>) -> Option<Answered<W>> {
        let Some(News::Over(answer)) = slot.as_ref()?.news() else { return None };
        slot.take().map(|job| (Arc::clone(&job.work), answer))
    }
}

struct WakeAtEnd(Wake);

impl Drop for WakeAtEnd {
    fn drop(&mut self) {
        (self.0)(Duration::ZERO);
    }
}

impl<W: Work> Drop for Job<W> {
    fn drop(&mut self) {
        self.cancel();
    }
}

impl<W: Work> Debug for Job<W> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.debug_struct("Job").field("progress", &self.progress).finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Clone, Copy, PartialEq)]
    enum Sum {
        To(u64),
        Panic,
        Endless,
    }

    impl Work for Sum {
        type Answer = u64;

        fn run(&self, watch: &dyn Watch<u64>) -> Result<u64, String> {
            match self {
                Self::To(0) => Err("nothing to add".to_owned()),
                Self::To(last) => Ok((1..=*last).sum()),
                Self::Panic => std::panic::panic_any("no answer"),
                Self::Endless => {
                    while watch.at(0.25) {
                        watch.found(&3);
                    }
                    Ok(7)
                }
            }
        }
    }

    fn outcome(mut slot: Option<Job<Sum>>) -> Result<u64, String> {
        loop {
            if let Some((_, answer)) = Job::take(&mut slot) {
                assert!(slot.is_none());
                return answer;
            }
            thread::yield_now();
        }
    }

    #[test]
    fn the_clock_does_not_go_back() {
        let first = nanoseconds();
        assert!(nanoseconds() >= first);
    }

    #[test]
    fn an_answer_comes_back_or_why_there_is_none() {
        let ask = |work| outcome(Some(Job::start(work, |_| ())));
        assert_eq!(ask(Sum::To(4)), Ok(10));
        assert_eq!(ask(Sum::To(0)), Err("nothing to add".to_owned()));
        assert!(ask(Sum::Panic).is_err());
    }

    #[test]
    fn a_job_says_how_far_it_is_and_can_be_cancelled() {
        let job = Job::start(Sum::Endless, |_| ());
        while !matches!(job.news(), Some(News::SoFar(3))) {
            thread::yield_now();
        }
        assert_eq!(job.share(), 0.25);
        job.cancel();
        assert_eq!(outcome(Some(job)), Ok(7));
    }

    #[test]
    fn the_latest_question_is_answered_and_a_known_one_not_asked_again() {
        let mut sums = Background::default();
        let mut ask = |last| loop {
            sums.ask(|_| (), |work| *work == Sum::To(last), || Sum::To(last));
            if let Some(answer) = sums.known().filter(|_| sums.progress().is_none()) {
                return answer.clone();
            }
            thread::yield_now();
        };
        assert_eq!((ask(4), ask(5), ask(5)), (Ok(10), Ok(15), Ok(15)));
    }
}
