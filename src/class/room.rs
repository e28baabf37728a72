//! The class: its students, their answers, where it is, and what the lecturer can do.

mod lecture;
mod seats;

pub use lecture::Command;

use super::content::{Content, Spread, StepContent};
use super::limits::NAME;
use super::record::{Commit, Recorder};
use super::refusal::{OwnPace, Refusal};
use super::tokens::Token;
use crate::lesson::{
    Answer, ClassHead, ClassLine, ClassRecord, Lesson, Pace, Phase, RoundAnswer, clean,
};
use crate::text::in_language;
use seats::{OwnStep, Seat, Seats, Streams};
use serde::Deserialize;
use std::collections::HashMap;
use std::fmt;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{Sender, channel};
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};
use std::time::Instant;
use tokio::sync::watch;

/// The longest time between the phone's clock and 1970 that is taken, in milliseconds: no phone is from the year 5138.
const LATEST: u64 = 100_000_000_000_000;

/// An answer as a phone sends it.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AnswerRequest {
    /// The step, from 1.
    pub step: usize,
    /// The round of its question, from 1.
    pub round: u32,
    /// The answer.
    pub answer: Answer,
    /// The time at which it was sent by the phone's clock, in milliseconds.
    #[serde(default)]
    pub sent: u64,
}

/// A student in the lecturer's own list.
#[derive(Clone, Debug, PartialEq)]
pub struct StudentRow {
    /// The student's name; may be empty.
    pub name: String,
    /// True if a phone of the student is connected.
    pub connected: bool,
    /// True if the student has answered in this round.
    pub answered: bool,
}

/// A class as the lecturer sees it.
#[derive(Clone, Debug)]
pub struct Snapshot {
    /// A number that grows with every change: snapshots with the same number are equal.
    pub version: u64,
    /// The step and phase of the class.
    pub pace: Pace,
    /// The number of steps.
    pub steps: usize,
    /// True if the step asks something.
    pub asks: bool,
    /// The number of students.
    pub joined: usize,
    /// The number of those whose phone is connected.
    pub connected: usize,
    /// The number of those who have answered in this round.
    pub answered: usize,
    /// True if students go at their own pace.
    pub own_pace: bool,
    /// The number of those who are at another step.
    pub elsewhere: usize,
    /// The answers, once they are shown and graded.
    pub spread: Option<Arc<Spread>>,
    /// The reason why the answers cannot be graded or the step cannot be shown, in a sentence.
    pub problem: Option<String>,
}

#[derive(Debug)]
struct Inner {
    seats: Seats,
    /// The state of each step that was visited.
    paces: HashMap<usize, (Phase, u32)>,
    step: usize,
    furthest: usize,
    ended: bool,
    own_pace: bool,
    opened: Instant,
    spread: Option<Arc<Spread>>,
    problem: Option<String>,
}

/// A live class about a lesson.
#[derive(Debug)]
pub struct Room {
    lesson: Lesson,
    head: ClassHead,
    recorder: Recorder,
    content: Content,
    inner: Mutex<Inner>,
    version: AtomicU64,
    pace: watch::Sender<u64>,
    engine: Sender<()>,
    listener: Listener,
}

/// The listener to every change: the lecturer's window.
#[derive(Default)]
struct Listener(OnceLock<Box<dyn Fn() + Send + Sync>>);

impl fmt::Debug for Listener {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Listener").finish_non_exhaustive()
    }
}

impl Room {
    /// Opens a class with the contents of its record, and has the engine prepare the steps in the background.
    pub fn open(lesson: Lesson, recorder: Recorder, record: ClassRecord) -> Arc<Self> {
        let now = Instant::now();
        let mut inner = Inner {
            seats: Seats::new(record.students, now),
            paces: HashMap::new(),
            step: 1,
            furthest: 1,
            ended: false,
            own_pace: false,
            opened: now,
            spread: None,
            problem: None,
        };
        for pace in &record.paces {
            if (1..=lesson.steps.len()).contains(&pace.step) && pace.phase != Phase::Closed {
                inner.paces.insert(pace.step, (pace.phase, pace.round));
                inner.step = pace.step;
                inner.furthest = inner.furthest.max(pace.step);
            }
        }
        let (engine, jobs) = channel();
        let room = Arc::new(Self {
            content: Content::new(&lesson),
            lesson,
            head: record.head,
            recorder,
            inner: Mutex::new(inner),
            version: AtomicU64::new(0),
            pace: watch::Sender::new(0),
            engine,
            listener: Listener::default(),
        });
        let weak = Arc::downgrade(&room);
        let language = room.head.language;
        std::thread::spawn(move || {
            in_language(language, || {
                while lecture::prepare_next(&weak) {}
                while jobs.recv().is_ok() {
                    if let Some(room) = weak.upgrade() {
                        room.grade();
                    }
                }
            });
        });
        room.ask_engine();
        room
    }

    /// Returns the lesson.
    pub fn lesson(&self) -> &Lesson {
        &self.lesson
    }

    /// Returns the head of the class's record.
    pub fn head(&self) -> &ClassHead {
        &self.head
    }

    /// Returns the steps as the engine prepares them.
    pub(super) fn content(&self) -> &Content {
        &self.content
    }

    /// Returns a step, from 1, once the engine has prepared it; an error is what is wrong with it, in a sentence.
    pub fn step(&self, step: usize) -> Option<Result<Arc<StepContent>, String>> {
        self.content.step(step)
    }

    /// Returns a number that grows with every change.
    pub fn version(&self) -> u64 {
        self.version.load(Ordering::Acquire)
    }

    fn inner(&self) -> MutexGuard<'_, Inner> {
        self.inner.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn changed(&self) {
        self.version.fetch_add(1, Ordering::AcqRel);
        if let Some(tell) = self.listener.0.get() {
            tell();
        }
    }

    /// Has a function called after every change, on the thread that made it; only the first function is kept. It must not call the
    /// class.
    pub fn on_change(&self, tell: impl Fn() + Send + Sync + 'static) {
        let _ = self.listener.0.set(Box::new(tell));
    }

    /// Returns the signal that wakes streams of events when the class goes on.
    pub(super) fn paces(&self) -> watch::Receiver<u64> {
        self.pace.subscribe()
    }

    /// Takes in a student, or finds one again by the token; a name replaces the one before.
    ///
    /// # Errors
    /// The class is full, or too many come at once.
    pub fn join(&self, token: Option<Token>, name: Option<&str>) -> Result<Token, Refusal> {
        let (mut inner, now) = (self.inner(), Instant::now());
        let name = name.map(|name| clean(name, NAME));
        let Ok(seat) = inner.seats.find(token) else {
            let token = inner.seats.join(name, now)?;
            self.changed();
            return Ok(token);
        };
        if !seat.requests.take(now) {
            return Err(Refusal::TooFast);
        }
        if let Some(name) = name.filter(|name| *name != seat.student.name) {
            seat.student.name = name;
            if seat.number.is_some() {
                // The next answer's commit waits for this line too.
                drop(self.recorder.append(&[seat.line()]));
            }
            self.changed();
        }
        Ok(seat.token)
    }

    /// Counts a request of a student, who may not make too many.
    ///
    /// # Errors
    /// No student of this class, or one who asks too fast.
    pub fn admit(&self, token: Option<Token>) -> Result<Token, Refusal> {
        let mut inner = self.inner();
        let seat = inner.seats.find(token)?;
        match seat.requests.take(Instant::now()) {
            true => Ok(seat.token),
            false => Err(Refusal::TooFast),
        }
    }

    /// Takes an answer of a student. It counts at once; [`Commit`] tells when it is on the disk.
    ///
    /// # Errors
    /// The step or its round is not open, or the answer does not fit.
    pub fn answer(&self, token: Token, request: AnswerRequest) -> Result<Commit, Refusal> {
        let mut inner = self.inner();
        let own = self.own(&inner, token)?;
        let open = own.pace.phase == Phase::Ask
            && (own.pace.step, own.pace.round) == (request.step, request.round);
        if !open {
            return Err(Refusal::NotOpen(Box::new(own)));
        }
        let question = self.lesson.steps[request.step - 1].question.as_ref();
        let fits = question.is_some_and(|question| request.answer.fits(&question.kind));
        if !fits || request.sent > LATEST {
            return Err(Refusal::Unfit);
        }
        let (opened, numbered) = (inner.opened, inner.seats.numbered + 1);
        let seat = inner.seats.find(Some(token))?;
        let seconds = seat
            .own
            .map_or(opened, |own| own.since)
            .elapsed()
            .as_secs_f64();
        let given = RoundAnswer {
            step: request.step,
            round: request.round,
            answer: request.answer,
            sent: request.sent,
            seconds: (seconds * 10.0).round() / 10.0,
        };
        let known = seat.student.answers.get(&(given.step, given.round));
        let same =
            known.is_some_and(|known| known.answer == given.answer && known.sent == given.sent);
        if same || !seat.student.takes(&given) {
            return Ok(self.recorder.append(&[]));
        }
        let new = seat.number.is_none();
        let number = *seat.number.get_or_insert(numbered);
        let mut lines = Vec::new();
        if new {
            lines.push(seat.line());
        }
        seat.student.put(given.clone());
        lines.push(ClassLine::Answer {
            student: number,
            given,
        });
        seat.changed.send_modify(|_| {});
        inner.seats.numbered += u32::from(new);
        // Appended while the class is locked, so that the record has what happens in the order in which it happens.
        let commit = self.recorder.append(&lines);
        self.changed();
        Ok(commit)
    }

    /// Returns the state of the class for a student.
    ///
    /// # Errors
    /// No student of this class.
    pub fn own_pace(&self, token: Token) -> Result<OwnPace, Refusal> {
        self.own(&self.inner(), token)
    }

    fn own(&self, inner: &Inner, token: Token) -> Result<OwnPace, Refusal> {
        let index = inner.seats.place(token).ok_or(Refusal::NoStudent)?;
        let seat = &inner.seats.all()[index];
        let pace = self.pace_at(inner, seat.own.map_or(inner.step, |own| own.step));
        let answered = seat.student.answers.get(&(pace.step, pace.round));
        Ok(OwnPace {
            pace,
            steps: self.lesson.steps.len(),
            lecturer: inner.own_pace.then_some(inner.step),
            answered: answered.map(|given| given.answer.clone()),
        })
    }

    /// Takes a student to another step, from 1; at the lecturer's the student follows the lecturer again.
    ///
    /// # Errors
    /// No such step, or the lecturer's pace is everybody's.
    pub fn turn(&self, token: Token, step: usize) -> Result<(), Refusal> {
        let mut inner = self.inner();
        if !inner.own_pace {
            return Err(Refusal::NotYet);
        }
        if !(1..=self.lesson.steps.len()).contains(&step) {
            return Err(Refusal::NoStep);
        }
        let own = OwnStep {
            step,
            since: Instant::now(),
        };
        let away = step != inner.step;
        let seat = inner.seats.find(Some(token))?;
        seat.own = away.then_some(own);
        seat.changed.send_modify(|_| {});
        self.changed();
        Ok(())
    }

    /// Returns the step and phase of the class.
    pub fn pace(&self) -> Pace {
        self.pace_of(&self.inner())
    }

    fn pace_of(&self, inner: &Inner) -> Pace {
        self.pace_at(inner, inner.step)
    }

    fn pace_at(&self, inner: &Inner, step: usize) -> Pace {
        let (phase, round) = self.stand(inner, step);
        Pace {
            step,
            phase: if inner.ended { Phase::Closed } else { phase },
            round,
        }
    }

    /// Returns the phase and round of a step. One that asks nothing is in the phase of its explanation.
    fn stand(&self, inner: &Inner, step: usize) -> (Phase, u32) {
        let asks = self.asks(step);
        let first = (if asks { Phase::Ask } else { Phase::Explain }, 1);
        inner.paces.get(&step).copied().unwrap_or(first)
    }

    fn asks(&self, step: usize) -> bool {
        let step = self.lesson.steps.get(step.wrapping_sub(1));
        step.is_some_and(|step| step.question.is_some())
    }

    /// Allows a student to see a step, or its explanation.
    ///
    /// # Errors
    /// A step that does not exist, or what the lecturer has not shown yet.
    pub fn may_see(&self, step: usize, explanation: bool) -> Result<(), Refusal> {
        let inner = self.inner();
        if !(1..=self.lesson.steps.len()).contains(&step) {
            return Err(Refusal::NoStep);
        }
        let explained = self.stand(&inner, step).0 == Phase::Explain;
        if (step > inner.furthest && !inner.own_pace) || (explanation && !explained) {
            return Err(Refusal::NotYet);
        }
        Ok(())
    }

    /// Returns the class as the lecturer sees it.
    pub fn snapshot(&self) -> Snapshot {
        let inner = self.inner();
        let (pace, seats) = (self.pace_of(&inner), inner.seats.all());
        let problem = match self.content.step(pace.step) {
            Some(Err(problem)) => Some(problem),
            _ => inner.problem.clone(),
        };
        Snapshot {
            version: self.version(),
            pace,
            steps: self.lesson.steps.len(),
            asks: self.asks(pace.step),
            joined: seats.len(),
            connected: seats.iter().filter(|seat| seat.connected > 0).count(),
            answered: seats.iter().filter(|seat| seat.has_answered(pace)).count(),
            own_pace: inner.own_pace,
            elsewhere: seats.iter().filter(|seat| seat.own.is_some()).count(),
            spread: inner.spread.clone(),
            problem,
        }
    }

    /// Returns the students as the lecturer's own list has them: those with names first, by their names.
    pub fn students(&self) -> Vec<StudentRow> {
        let inner = self.inner();
        let pace = self.pace_of(&inner);
        let row = |seat: &Seat| StudentRow {
            name: seat.student.name.clone(),
            connected: seat.connected > 0,
            answered: seat.has_answered(pace),
        };
        let mut rows: Vec<StudentRow> = inner.seats.all().iter().map(row).collect();
        rows.sort_by_cached_key(|row| (row.name.is_empty(), row.name.to_lowercase()));
        rows
    }

    /// Closes the record: nothing that was saved is lost, and nothing more is saved.
    pub(super) fn close(&self) {
        self.recorder.close();
    }

    /// Returns the secrets of the students, in the order in which they came.
    pub(super) fn tokens(&self) -> Vec<Token> {
        self.inner()
            .seats
            .all()
            .iter()
            .map(|seat| seat.token)
            .collect()
    }

    /// Opens a stream of events for a student; [`Self::leave`] closes it.
    pub(super) fn enter(&self, token: Token) -> Result<(u64, watch::Receiver<Streams>), Refusal> {
        let mut inner = self.inner();
        let seat = inner.seats.find(Some(token))?;
        seat.connected += 1;
        seat.changed.send_modify(|streams| streams.opened += 1);
        let receiver = seat.changed.subscribe();
        let number = receiver.borrow().opened;
        self.changed();
        Ok((number, receiver))
    }

    /// Notes that a stream of events is closed.
    pub(super) fn leave(&self, token: Token) {
        if let Ok(seat) = self.inner().seats.find(Some(token)) {
            seat.connected = seat.connected.saturating_sub(1);
        }
        self.changed();
    }
}
