//! The students of a class, each with what is known of the phone.

use crate::class::limits::{Bucket, JOINS, REQUESTS, STREAMS, STUDENTS};
use crate::class::refusal::Refusal;
use crate::class::tokens::Token;
use crate::lesson::{ClassLine, ClassStudent, Pace};
use std::collections::HashMap;
use std::time::Instant;
use tokio::sync::watch;

/// A student, and what is known of the phone.
#[derive(Debug)]
pub struct Seat {
    pub token: Token,
    pub student: ClassStudent,
    /// The number in the record, from 1, from the first answer on.
    pub number: Option<u32>,
    pub requests: Bucket,
    pub connected: usize,
    /// The step that the student has turned to, where it is not the lecturer's.
    pub own: Option<OwnStep>,
    pub changed: watch::Sender<Streams>,
}

/// A step that a student has turned to.
#[derive(Clone, Copy, Debug)]
pub struct OwnStep {
    /// The step, from 1.
    pub step: usize,
    pub since: Instant,
}

/// The signal that wakes the streams of events of a student.
#[derive(Clone, Copy, Debug, Default)]
pub struct Streams {
    /// The number of streams opened so far.
    pub opened: u64,
}

/// The students of a class.
#[derive(Debug)]
pub struct Seats {
    seats: Vec<Seat>,
    by_token: HashMap<Token, usize>,
    joins: Bucket,
    /// The number of students that have a number.
    pub numbered: u32,
}

impl Streams {
    /// Returns whether a stream with this number is one of the latest, which go on.
    pub fn keeps(&self, number: u64) -> bool {
        number + STREAMS > self.opened
    }
}

impl Seat {
    /// Returns the line that introduces the student.
    pub fn line(&self) -> ClassLine {
        ClassLine::Student {
            student: self.number.unwrap_or_default(),
            token: self.token.to_string(),
            name: self.student.name.clone(),
        }
    }

    /// Returns whether the student has answered in the present round.
    pub fn has_answered(&self, pace: Pace) -> bool {
        let answers = &self.student.answers;
        answers.contains_key(&(pace.step, pace.round))
    }
}

impl Seats {
    /// Gives seats to the students of a record, in their order.
    pub fn new(students: Vec<ClassStudent>, now: Instant) -> Self {
        let mut seats = Self {
            seats: Vec::new(),
            by_token: HashMap::new(),
            joins: Bucket::new(JOINS, now),
            numbered: students.len() as u32,
        };
        for (student, number) in students.into_iter().zip(1..) {
            // Who has no token left can answer no more; what was answered still counts.
            let token = Token::read(&student.token);
            let token = token.or_else(|| Token::new().ok());
            if let Some(token) = token.filter(|_| seats.seats.len() < STUDENTS) {
                seats.give(token, student, Some(number), now);
            }
        }
        seats
    }

    /// Returns all students.
    pub fn all(&self) -> &[Seat] {
        &self.seats
    }

    /// Returns a student's place among all.
    pub fn place(&self, token: Token) -> Option<usize> {
        self.by_token.get(&token).copied()
    }

    /// Takes in a new student.
    ///
    /// # Errors
    /// The class is full, or too many come at once.
    pub fn join(&mut self, name: Option<String>, now: Instant) -> Result<Token, Refusal> {
        if !self.joins.take(now) {
            return Err(Refusal::TooFast);
        }
        if self.seats.len() >= STUDENTS && !self.make_room() {
            return Err(Refusal::Full);
        }
        let token = Token::new().map_err(Refusal::Failed)?;
        let student = ClassStudent {
            token: token.to_string(),
            name: name.unwrap_or_default(),
            ..ClassStudent::default()
        };
        self.give(token, student, None, now);
        Ok(token)
    }

    /// Gives a student a seat.
    fn give(&mut self, token: Token, student: ClassStudent, number: Option<u32>, now: Instant) {
        self.by_token.insert(token, self.seats.len());
        self.seats.push(Seat {
            token,
            student,
            number,
            requests: Bucket::new(REQUESTS, now),
            connected: 0,
            own: None,
            changed: watch::Sender::new(Streams::default()),
        });
    }

    /// Finds a student.
    ///
    /// # Errors
    /// No student of this class.
    pub fn find(&mut self, token: Option<Token>) -> Result<&mut Seat, Refusal> {
        let index = token.and_then(|token| self.by_token.get(&token));
        let index = *index.ok_or(Refusal::NoStudent)?;
        Ok(&mut self.seats[index])
    }

    /// Gives up the seat of a student who has never answered and whose phone is gone; false if there is none.
    fn make_room(&mut self) -> bool {
        let idle = |seat: &Seat| seat.number.is_none() && seat.connected == 0;
        let Some(index) = self.seats.iter().position(idle) else {
            return false;
        };
        let gone = self.seats.swap_remove(index);
        self.by_token.remove(&gone.token);
        if let Some(moved) = self.seats.get(index) {
            self.by_token.insert(moved.token, index);
        }
        true
    }

    /// Has the students follow the lecturer again, but for those who stay where they are.
    pub fn gather(&mut self, stays: impl Fn(&OwnStep) -> bool) {
        for seat in &mut self.seats {
            seat.own = seat.own.filter(&stays);
        }
    }
}
