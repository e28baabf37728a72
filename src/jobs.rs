//! Work in the background: plain data is given to a thread, which returns an answer. Nothing else starts threads, except a live
//! class (`class`), which has its own. A web page has no threads: there a worker does work that has [codecs](Work::CODECS), and the
//! rest is done between two frames.
//!
//! A [`Job`] is one piece of work with its progress; [`Background`] answers one question after the other and keeps
//! the latest answer.

#[cfg(target_arch = "wasm32")]
mod page;
#[cfg(target_arch = "wasm32")]
mod worker;

use crate::analysis::codec::Codec;
use crate::analysis::{Question, Subject, Watch};
use crate::geometry::Mesh;
use crate::scene::Scene;
use crate::text::{in_language, language, text};
#[cfg(not(target_arch = "wasm32"))]
use rayon::{ThreadPool, ThreadPoolBuilder};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::fmt::{self, Debug, Formatter};
use std::sync::atomic::{AtomicBool, AtomicU32, AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, Sender, TryRecvError, channel};
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};
use std::time::Duration;
use web_time::Instant;

#[cfg(target_arch = "wasm32")]
pub use worker::{Served, serve, served};

/// The kind of a worker's message, sent as a number.
#[cfg(target_arch = "wasm32")]
#[derive(Clone, Copy)]
enum MessageKind {
    /// The progress.
    Share,
    /// The part of the answer known so far.
    SoFar,
    /// The answer.
    Answer,
    /// The reason why there is none.
    Failure,
}

/// Minimum interval between displays of progress: drawing the window disturbs measurements.
const PAUSE: Duration = Duration::from_millis(200);

/// Returns the nanoseconds since the first call.
pub fn nanoseconds() -> u64 {
    static START: OnceLock<Instant> = OnceLock::new();
    u64::try_from(START.get_or_init(Instant::now).elapsed().as_nanos()).unwrap_or(u64::MAX)
}

/// Does work with a thread pool of its own for its parallel parts, so that it does not wait for work in the background.
pub fn at_once<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    #[cfg(not(target_arch = "wasm32"))]
    {
        static POOL: OnceLock<Option<ThreadPool>> = OnceLock::new();
        let threads = ThreadPoolBuilder::new().num_threads(rayon::current_num_threads());
        if let Some(pool) = POOL.get_or_init(|| threads.build().ok()) {
            return pool.install(work);
        }
    }
    work()
}

/// Work to be done in the background.
pub trait Work: Send + Sync + Sized + 'static {
    /// The type of the answer.
    type Answer: Clone + Send + Sync + 'static;

    /// Encodings of the work and of its answer, for a worker of a web page. Work without them is done on the page.
    const CODECS: Option<(Codec<Self>, Codec<Self::Answer>)> = None;

    /// Does the work; an error is the reason why there is no answer, in a sentence.
    fn run(&self, watch: &dyn Watch<Self::Answer>) -> Result<Self::Answer, String>;
}

/// Finished work, with its answer or the reason why there is none.
pub type Answered<W> = (Arc<W>, Result<<W as Work>::Answer, String>);

/// Work in progress. Dropping it cancels it.
pub struct Job<W: Work> {
    /// The work.
    pub work: Arc<W>,
    progress: Arc<Progress<W::Answer>>,
    over: Receiver<Result<W::Answer, String>>,
    /// Number of the order sent to a worker.
    #[cfg(target_arch = "wasm32")]
    sent: Option<u64>,
}

/// A message from a job.
#[derive(Clone, Debug)]
pub enum News<A> {
    /// The part of the answer known so far.
    SoFar(A),
    /// The answer, or the reason why there is none.
    Over(Result<A, String>),
}

struct Progress<A> {
    cancel: AtomicBool,
    /// Share of the work done, in thousandths.
    share: AtomicU32,
    /// Nanoseconds that the work took on a thread of this process, once it is over.
    took: AtomicU64,
    /// The latest intermediate answer, until it is taken, which may be after a long time.
    so_far: Mutex<Option<A>>,
}

impl<A> Default for Progress<A> {
    fn default() -> Self {
        Self {
            cancel: AtomicBool::default(),
            share: AtomicU32::default(),
            took: AtomicU64::default(),
            so_far: Mutex::new(None),
        }
    }
}

impl<A> Progress<A> {
    fn so_far(&self) -> MutexGuard<'_, Option<A>> {
        self.so_far.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// A callback that asks the caller to check again after a while.
type Wake = Arc<dyn Fn(Duration) + Send + Sync>;

/// The job's side of its progress.
struct Reporter<A> {
    progress: Arc<Progress<A>>,
    over: Sender<Result<A, String>>,
    wake: Wake,
}

impl<A: Clone + Send + Sync> Watch<A> for Reporter<A> {
    fn progress(&self, share: f32) -> bool {
        self.progress
            .share
            .store((1000.0 * share) as u32, Ordering::Relaxed);
        (self.wake)(PAUSE);
        !self.progress.cancel.load(Ordering::Relaxed)
    }

    fn found(&self, so_far: &A) {
        *self.progress.so_far() = Some(so_far.clone());
    }
}

impl<A> Drop for Reporter<A> {
    /// Wakes the caller even if the work panics: then the channel is closed without an answer.
    fn drop(&mut self) {
        (self.wake)(Duration::ZERO);
    }
}

/// The receiver of a worker's messages about a job.
#[cfg(target_arch = "wasm32")]
struct Listener<W: Work> {
    progress: Arc<Progress<W::Answer>>,
    over: Sender<Result<W::Answer, String>>,
    /// The answer in case the worker is stopped.
    latest: Option<W::Answer>,
    answers: Codec<W::Answer>,
}

#[cfg(target_arch = "wasm32")]
impl<W: Work> Listener<W> {
    fn listen(
        mut self,
        wake: impl Fn(Duration) + 'static,
    ) -> impl FnMut(page::WorkerMessage<'_>) + 'static {
        let ended = || text!("render-job-ended").to_owned();
        move |message| {
            let over = match message {
                page::WorkerMessage::At(share) => {
                    let thousandths = (1000.0 * share) as u32;
                    self.progress.share.store(thousandths, Ordering::Relaxed);
                    None
                }
                page::WorkerMessage::SoFar(answer) => {
                    self.latest = (self.answers.from_bytes)(answer).or(self.latest.take());
                    self.progress.so_far().clone_from(&self.latest);
                    None
                }
                page::WorkerMessage::Over(answer) => {
                    Some((self.answers.from_bytes)(answer).ok_or_else(ended))
                }
                page::WorkerMessage::Failed(why) => Some(Err(why)),
                page::WorkerMessage::Stopped => Some(self.latest.take().ok_or_else(ended)),
            };
            // The receiver may be gone; then the answer is dropped.
            let _ = over.map(|answer| self.over.send(answer));
            wake(Duration::ZERO);
        }
    }
}

impl<W: Work> Job<W> {
    /// Starts work on a thread. `wake` is called, with the time to wait, when there is news.
    pub fn start(work: W, wake: impl Fn(Duration) + Send + Sync + 'static) -> Self {
        let (sender, over) = channel();
        let (work, progress) = (Arc::new(work), Arc::new(Progress::default()));
        #[cfg(target_arch = "wasm32")]
        if let Some((codec, answers)) = W::CODECS {
            let listener = Listener::<W> {
                progress: Arc::clone(&progress),
                over: sender,
                latest: None,
                answers,
            };
            let name = std::any::type_name::<W>();
            let sent = page::send(name, (codec.to_bytes)(&work), listener.listen(wake));
            return Self {
                work,
                progress,
                over,
                sent: Some(sent),
            };
        }
        let job = Self {
            work: Arc::clone(&work),
            progress: Arc::clone(&progress),
            over,
            #[cfg(target_arch = "wasm32")]
            sent: None,
        };
        let reporter = Reporter {
            progress,
            over: sender,
            wake: Arc::new(wake),
        };
        let language = language();
        let run = move || {
            if !reporter.progress.cancel.load(Ordering::Relaxed) {
                let began = Instant::now();
                let answer = in_language(language, || work.run(&reporter));
                let took = u64::try_from(began.elapsed().as_nanos()).unwrap_or(u64::MAX);
                reporter.progress.took.store(took, Ordering::Relaxed);
                // The receiver may be gone; then the answer is dropped.
                let _ = reporter.over.send(answer);
            }
        };
        #[cfg(not(target_arch = "wasm32"))]
        std::thread::spawn(run);
        #[cfg(target_arch = "wasm32")]
        page::later(run);
        job
    }

    /// Returns the share of the work done, from 0 to 1.
    pub fn share(&self) -> f32 {
        self.progress.share.load(Ordering::Relaxed) as f32 / 1000.0
    }

    /// Asks the job to end soon with its results so far.
    pub fn cancel(&self) {
        self.progress.cancel.store(true, Ordering::Relaxed);
        #[cfg(target_arch = "wasm32")]
        self.sent.into_iter().for_each(page::cancel);
    }

    /// Returns the latest news since the last call.
    pub fn news(&self) -> Option<News<W::Answer>> {
        match self.over.try_recv() {
            Ok(over) => Some(News::Over(over)),
            Err(TryRecvError::Empty) => self.progress.so_far().take().map(News::SoFar),
            Err(TryRecvError::Disconnected) => {
                Some(News::Over(Err(text!("render-job-ended").to_owned())))
            }
        }
    }

    /// Waits until the job is over. A page cannot wait: there work that has not begun never will.
    pub fn wait(self) {
        // Neither its result nor a panic matters here.
        #[cfg(not(target_arch = "wasm32"))]
        let _ = self.over.recv();
    }

    /// Takes a job out of `slot` when it is over.
    pub fn take(slot: &mut Option<Self>) -> Option<Answered<W>> {
        let Some(News::Over(answer)) = slot.as_ref()?.news() else {
            return None;
        };
        slot.take().map(|job| (Arc::clone(&job.work), answer))
    }
}

impl<W: Work> Drop for Job<W> {
    fn drop(&mut self) {
        self.cancel();
    }
}

impl<W: Work> Debug for Job<W> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.debug_struct("Job")
            .field("share", &self.share())
            .finish_non_exhaustive()
    }
}

/// The latest answer, and the work on the next one.
pub struct Background<W: Work> {
    known: Option<Answered<W>>,
    job: Option<Job<W>>,
    /// Time that the answer took on a thread of this process.
    took: Duration,
    /// True if the work of the answer was cancelled.
    stopped: bool,
}

impl<W: Work> Default for Background<W> {
    fn default() -> Self {
        Self {
            known: None,
            job: None,
            took: Duration::ZERO,
            stopped: false,
        }
    }
}

impl<W: Work> Debug for Background<W> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.debug_struct("Background")
            .field("known", &self.known.is_some())
            .field("job", &self.job)
            .finish()
    }
}

impl<W: Work> Background<W> {
    /// Answers `work`, after any current work, unless it is the `same` as the latest answer's; returns whether there is
    /// news.
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

    /// Starts `work` in place of any current work.
    pub fn start(&mut self, work: W, wake: impl Fn(Duration) + Send + Sync + 'static) {
        self.job = Some(Job::start(work, wake));
    }

    /// Takes any news; returns whether there was any.
    pub fn take(&mut self) -> bool {
        let Some(job) = &self.job else { return false };
        let Some(news) = job.news() else { return false };
        let work = Arc::clone(&job.work);
        match news {
            News::SoFar(answer) => self.known = Some((work, Ok(answer))),
            News::Over(answer) => {
                self.known = Some((work, answer));
                self.took = Duration::from_nanos(job.progress.took.load(Ordering::Relaxed));
                self.stopped = job.progress.cancel.load(Ordering::Relaxed);
                self.job = None;
            }
        }
        true
    }

    /// Cancels the current work and forgets the answer, unless they belong to the wanted question.
    pub fn keep_only(&mut self, same: impl Fn(&W) -> bool) {
        self.known.take_if(|(known, _)| !same(known));
        self.job.take_if(|job| !same(&job.work));
    }

    /// Returns the latest answer, or the reason why there is none.
    pub fn known(&self) -> Option<&Result<W::Answer, String>> {
        self.known.as_ref().map(|(_, answer)| answer)
    }

    /// Returns the latest answer.
    pub fn answer(&self) -> Option<&W::Answer> {
        self.known()?.as_ref().ok()
    }

    /// Returns the work of the latest answer.
    pub fn answered(&self) -> Option<&W> {
        self.known.as_ref().map(|(work, _)| &**work)
    }

    /// Returns the share of the work done, from 0 to 1, while it runs.
    pub fn progress(&self) -> Option<f32> {
        self.job.as_ref().map(Job::share)
    }

    /// Returns the time that the latest answer took on a thread of this process; zero before there is one.
    pub fn took(&self) -> Duration {
        self.took
    }

    /// Asks the current work to end soon with its results so far.
    pub fn stop(&self) {
        self.job.iter().for_each(Job::cancel);
    }

    /// Returns whether the latest answer is that of cancelled work.
    pub fn stopped(&self) -> bool {
        self.stopped && self.job.is_none()
    }
}

/// A question about a scene in a picture of some size.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Request<Q> {
    /// The question.
    pub question: Q,
    /// The scene.
    pub scene: Scene,
    /// The mesh of an object of kind `obj`.
    #[serde(
        serialize_with = "model_to_bytes",
        deserialize_with = "model_from_bytes"
    )]
    pub model: Option<Arc<Mesh>>,
    size: [u32; 2],
}

impl<Q: PartialEq> Request<Q> {
    /// Creates a request about a scene with a picture of `size` pixels.
    pub fn new(question: Q, scene: &Scene, model: Option<&Arc<Mesh>>, size: [u32; 2]) -> Self {
        Self {
            question,
            scene: scene.clone(),
            model: model.cloned(),
            size,
        }
    }

    /// Returns whether this equals what [`Self::new`] would create; models are compared by address.
    pub fn is(
        &self,
        question: &Q,
        scene: &Scene,
        model: Option<&Arc<Mesh>>,
        size: [u32; 2],
    ) -> bool {
        self.question == *question
            && self.size == size
            && self.model.as_ref().map(Arc::as_ptr) == model.map(Arc::as_ptr)
            && self.scene == *scene
    }

    /// Returns the subject: the scene with the requested picture size, and the model.
    pub fn subject(&self) -> Subject {
        let mut scene = self.scene.clone();
        scene.image.size = self.size;
        Subject {
            scene,
            model: self.model.clone(),
            clock: nanoseconds,
        }
    }
}

/// Serializes a model, which is sent with the question.
pub(crate) fn model_to_bytes<S: Serializer>(
    model: &Option<Arc<Mesh>>,
    into: S,
) -> Result<S::Ok, S::Error> {
    model.as_deref().serialize(into)
}

/// Deserializes a model that [`model_to_bytes`] serialized.
pub(crate) fn model_from_bytes<'de, D: Deserializer<'de>>(
    from: D,
) -> Result<Option<Arc<Mesh>>, D::Error> {
    let model: Option<Mesh> = Deserialize::deserialize(from)?;
    Ok(model.map(Arc::new))
}

impl<Q: Question> Work for Request<Q> {
    type Answer = Q::Answer;

    const CODECS: Option<(Codec<Self>, Codec<Q::Answer>)> = match Q::CODEC {
        Some(answers) => Some((Codec::plain(), answers)),
        None => None,
    };

    fn run(&self, watch: &dyn Watch<Q::Answer>) -> Result<Q::Answer, String> {
        self.question.answer(&self.subject(), watch)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rayon::prelude::*;
    use std::sync::atomic::AtomicUsize;

    /// Work that keeps all its threads until it may end.
    #[derive(Default)]
    struct Waiting {
        begun: AtomicUsize,
        may_end: AtomicBool,
    }

    impl Work for Arc<Waiting> {
        type Answer = ();

        fn run(&self, _: &dyn Watch<()>) -> Result<(), String> {
            let threads = 0..rayon::current_num_threads();
            threads.into_par_iter().with_max_len(1).for_each(|_| {
                self.begun.fetch_add(1, Ordering::Relaxed);
                while !self.may_end.load(Ordering::Relaxed) {
                    std::thread::sleep(Duration::from_millis(1));
                }
            });
            Ok(())
        }
    }

    #[test]
    fn what_is_done_at_once_does_not_wait_for_the_background() {
        let waiting = Arc::new(Waiting::default());
        let job = Job::start(Arc::clone(&waiting), |_| {});
        while waiting.begun.load(Ordering::Relaxed) < rayon::current_num_threads() {
            std::thread::sleep(Duration::from_millis(1));
        }
        let (sender, done) = channel();
        std::thread::spawn(move || {
            let sum: i32 = at_once(|| (1..=100).into_par_iter().sum());
            sender.send(sum).unwrap_or_default();
        });
        let in_time = done.recv_timeout(Duration::from_secs(20));
        waiting.may_end.store(true, Ordering::Relaxed);
        job.wait();
        assert_eq!(in_time, Ok(5050));
    }
}
