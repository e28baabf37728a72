//! The lecturer's commands, and the engine's work for them.

use super::{Inner, Room};
use crate::class::content::{Spread, graded};
use crate::lesson::{Answer, ClassLine, MAX_ROUNDS, Pace, Phase};
use std::sync::{Arc, Weak};
use std::time::Instant;

/// A command of the lecturer. Commands come from inside the process alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Command {
    /// Shows the answers of the class; none can be given or changed any more.
    ShowAnswers,
    /// Asks the same question in another round.
    AskAgain,
    /// Explains the step.
    Explain,
    /// Goes to the next step.
    Next,
    /// Goes back to the step before.
    Back,
    /// Lets students go at their own pace, or has all follow the lecturer.
    OwnPace(bool),
    /// Ends the class.
    End,
}

impl Room {
    /// Performs a command. Returns whether that was possible now.
    pub fn perform(&self, command: Command) -> bool {
        let mut inner = self.inner();
        let Pace { step, phase, round } = self.pace_of(&inner);
        let asks = self.asks(step);
        let next = match command {
            Command::ShowAnswers if phase == Phase::Ask => (step, Phase::Spread, round),
            Command::AskAgain if asks && phase != Phase::Closed && round < MAX_ROUNDS => {
                (step, Phase::Ask, round + 1)
            }
            Command::Explain if matches!(phase, Phase::Ask | Phase::Spread) => {
                (step, Phase::Explain, round)
            }
            Command::Next if phase != Phase::Closed && step < self.lesson.steps.len() => {
                let (phase, round) = self.stand(&inner, step + 1);
                (step + 1, phase, round)
            }
            Command::Back if phase != Phase::Closed && step > 1 => {
                let (phase, round) = self.stand(&inner, step - 1);
                (step - 1, phase, round)
            }
            Command::OwnPace(allowed) if phase != Phase::Closed => {
                inner.own_pace = allowed;
                inner.seats.gather(|_| allowed);
                self.tell();
                return true;
            }
            Command::End if phase != Phase::Closed => {
                inner.ended = true;
                (step, Phase::Closed, round)
            }
            _ => return false,
        };
        self.go(&mut inner, next);
        true
    }

    /// Goes to a step, phase and round.
    fn go(&self, inner: &mut Inner, (step, phase, round): (usize, Phase, u32)) {
        let pace = Pace { step, phase, round };
        if phase != Phase::Closed {
            inner.paces.insert(step, (phase, round));
        }
        inner.step = step;
        inner.furthest = inner.furthest.max(step);
        inner.seats.gather(|own| own.step != step);
        inner.opened = Instant::now();
        (inner.spread, inner.problem) = (None, None);
        drop(self.recorder.append(&[ClassLine::Pace(pace)]));
        self.tell();
        self.ask_engine();
    }

    /// Tells the phones and the window that the class has gone on.
    fn tell(&self) {
        self.changed();
        self.pace.send_modify(|count| *count += 1);
    }

    pub(super) fn ask_engine(&self) {
        // The engine lives as long as the room.
        let _ = self.engine.send(());
    }

    /// Has the engine grade what is to be shown.
    pub(super) fn grade(&self) {
        let pace = self.pace();
        if !matches!(pace.phase, Phase::Spread | Phase::Explain) || !self.asks(pace.step) {
            return;
        }
        let content = match self.content.step(pace.step) {
            Some(Ok(content)) => content,
            Some(Err(problem)) => return self.graded(pace, Err(problem)),
            None => return,
        };
        let rounds = (1..=pace.round).map(|round| self.answers(pace.step, round));
        let spread = graded(&self.lesson, &content, pace.step, rounds.collect());
        self.graded(pace, spread);
    }

    fn graded(&self, pace: Pace, spread: Result<Spread, String>) {
        let mut inner = self.inner();
        // The lecturer may have gone on in the meantime.
        if self.pace_of(&inner) != pace {
            return;
        }
        match spread {
            Ok(spread) => inner.spread = Some(Arc::new(spread)),
            Err(problem) => inner.problem = Some(problem),
        }
        self.changed();
    }

    /// Returns the answers in a round of a step, both from 1, with the students' numbers.
    fn answers(&self, step: usize, round: u32) -> Vec<(u32, Answer)> {
        let inner = self.inner();
        let mut answers: Vec<(u32, Answer)> = inner
            .seats
            .all()
            .iter()
            .filter_map(|seat| {
                let given = seat.student.answers.get(&(step, round))?;
                Some((seat.number?, given.answer.clone()))
            })
            .collect();
        answers.sort_by_key(|(student, _)| *student);
        answers
    }
}

/// Prepares the first step that is not prepared, from the present one on. Returns false if there is none, or the class is over.
pub(super) fn prepare_next(room: &Weak<Room>) -> bool {
    let Some(room) = room.upgrade() else {
        return false;
    };
    let (now, count) = (room.pace().step, room.lesson.steps.len());
    let order = (0..count).map(|ahead| (now - 1 + ahead) % count + 1);
    let mut missing = order.filter(|step| room.content.step(*step).is_none());
    let Some(step) = missing.next() else {
        return false;
    };
    room.content.prepare(&room.lesson, room.head.seed, step);
    room.changed();
    room.grade();
    true
}
