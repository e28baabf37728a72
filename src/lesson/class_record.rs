//! The record of a live class: a file of lines of JSON, in the order in which things happened.
//!
//! ```text
//! {"line":"class","version":1,"lesson":"mach-bands",…}          the first line: what the class is about
//! {"line":"student","student":1,"token":"3f…","name":"Ada"}     before a student's first answer, and for a new name
//! {"line":"pace","step":2,"phase":"ask","round":1}              the lecturer has gone on
//! {"line":"answer","student":1,"step":2,"round":1,"answer":{"choice":0},"sent":1795660000000,"seconds":21.4}
//! ```
//! Steps, rounds and students are counted from 1. Of several answers of a student in a round the one counts that was sent last. A last
//! line that was not written to its end was never acknowledged, and counts as not written.

use super::hand_in::{HandIn, LONGEST, clean, clean_name, digest, is_built_in};
use super::{Answer, Answered, Grade, Lesson, Record};
use crate::text::{Language, language, text};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The version of the format.
const VERSION: u32 = 1;
/// The most students.
const MAX_STUDENTS: u32 = 100_000;
/// The most rounds of a question.
pub const MAX_ROUNDS: u32 = 20;

/// The state of a step of the lesson.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Phase {
    /// The question is open: it may be answered, and answers may be changed.
    #[default]
    Ask,
    /// The class is over.
    Closed,
    /// The answers of the class are shown.
    Spread,
    /// The step is explained, or asks nothing.
    Explain,
}

/// The step and phase of the class.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Pace {
    /// The step of the lesson, from 1.
    pub step: usize,
    /// The phase of that step.
    pub phase: Phase,
    /// The number of times that its question has been asked, from 1.
    pub round: u32,
}

/// A line of the record.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "line", rename_all = "lowercase")]
#[non_exhaustive]
pub enum ClassLine {
    /// The first one.
    Class(ClassHead),
    /// A student.
    Student {
        /// The student's number, from 1.
        student: u32,
        /// The secret by which the student's phone is known.
        token: String,
        /// The student's name; may be empty.
        #[serde(default)]
        name: String,
    },
    /// The lecturer has gone on.
    Pace(Pace),
    /// An answer.
    Answer {
        /// The student's number, from 1.
        student: u32,
        /// The answer.
        #[serde(flatten)]
        given: RoundAnswer,
    },
}

/// The lesson of a class.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ClassHead {
    /// The version of the format.
    pub version: u32,
    /// The lesson's name.
    pub lesson: String,
    /// Its title.
    pub title: String,
    /// The digest of its text.
    pub digest: String,
    /// The language of the class.
    pub language: Language,
    /// The seed of what is drawn at random, the same for all students.
    pub seed: u64,
    /// The class's part of the address.
    pub code: String,
    /// The lesson's text; none of a lesson that comes with the program.
    pub source: Option<String>,
}

impl ClassHead {
    /// Describes a class about a lesson in the current language.
    pub fn new(lesson: &Lesson, seed: u64, code: &str) -> Self {
        Self {
            version: VERSION,
            lesson: lesson.name.clone(),
            title: lesson.title.clone(),
            digest: digest([&lesson.source]),
            language: language(),
            seed,
            code: code.to_owned(),
            source: (!is_built_in(lesson)).then(|| lesson.source.clone()),
        }
    }

    /// Returns whether the lesson's text, if it is included, matches the digest.
    fn is_whole(&self) -> bool {
        let source = self.source.as_ref();
        source.is_none_or(|source| {
            source.len() <= Lesson::MAX_TEXT && digest([source]) == self.digest
        })
    }

    /// Returns whether `lesson` has exactly the text that the class is about.
    pub fn is_of(&self, lesson: &Lesson) -> bool {
        self.lesson == lesson.name && digest([&lesson.source]) == self.digest
    }
}

/// An answer of a student in a round.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RoundAnswer {
    /// The step, from 1.
    pub step: usize,
    /// The round of its question, from 1.
    pub round: u32,
    /// The answer.
    pub answer: Answer,
    /// The time at which it was sent by the phone's clock, in milliseconds; 0 if the phone does not say.
    #[serde(default)]
    pub sent: u64,
    /// The time since the round was opened, in seconds.
    #[serde(default)]
    pub seconds: f64,
}

/// A student of a class.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ClassStudent {
    /// The secret by which the student's phone is known; empty where the record does not say.
    pub token: String,
    /// The student's name; may be empty.
    pub name: String,
    /// The answers that count, by step and round.
    pub answers: BTreeMap<(usize, u32), RoundAnswer>,
}

impl ClassStudent {
    /// Returns whether an answer counts: it was not sent before the one that is known.
    pub fn takes(&self, given: &RoundAnswer) -> bool {
        let known = self.answers.get(&(given.step, given.round));
        known.is_none_or(|known| known.sent <= given.sent)
    }

    /// Puts an answer in its place, if it counts.
    pub fn put(&mut self, given: RoundAnswer) {
        if self.takes(&given) {
            self.answers.insert((given.step, given.round), given);
        }
    }

    /// Returns the answers as those of a hand-in: the first round's is the prediction, the last round's the answer.
    fn record(&self, head: &ClassHead) -> Record {
        let mut record = Record::new(&head.lesson, head.seed);
        let mut answers = self.answers.values().peekable();
        while let Some(first) = answers.next() {
            let (mut last, mut tries) = (first, 1);
            while let Some(next) = answers.next_if(|next| next.step == first.step) {
                (last, tries) = (next, tries + 1);
            }
            record.put(Answered {
                step: first.step - 1,
                prediction: first.answer.clone(),
                answer: last.answer.clone(),
                grade: Grade::default(),
                looked_up: 0,
                tries,
                seconds: last.seconds.clamp(0.0, LONGEST),
            });
        }
        record
    }
}

/// A record that has been read.
#[derive(Clone, Debug, PartialEq)]
pub struct ClassRecord {
    /// The lesson of the class.
    pub head: ClassHead,
    /// The students in the order of their first answers.
    pub students: Vec<ClassStudent>,
    /// The last state of each step, in the order in which the lecturer went on; the last one is that of the class.
    pub paces: Vec<Pace>,
    /// The length of the lines that are whole, in bytes.
    pub length: u64,
}

impl ClassRecord {
    /// The largest file, in bytes: a thousand students who draw fifty curves, and change each of them once.
    pub const MAX_BYTES: u64 = 128 << 20;

    /// Returns whether a file is a record, by its first bytes.
    pub fn begins(bytes: &[u8]) -> bool {
        bytes.starts_with(br#"{"line":"class""#)
    }

    /// Reads a record.
    ///
    /// # Errors
    /// The problem, with its line.
    pub fn read(bytes: &[u8]) -> Result<Self, String> {
        if bytes.len() as u64 > Self::MAX_BYTES {
            let most = Self::MAX_BYTES >> 20;
            return Err(text!("class-record-too-long", most = most));
        }
        let whole = bytes.iter().rposition(|byte| *byte == b'\n');
        let bytes = &bytes[..whole.map_or(0, |last| last + 1)];
        let mut lines = bytes.split_inclusive(|byte| *byte == b'\n').enumerate();
        let read = |(index, line): (usize, &[u8])| {
            serde_json::from_slice(line).map_err(|error| {
                // The place within the line is its column.
                let error = error.to_string().replace(" at line 1 ", " at ");
                text!("class-record-line", line = index + 1, error = error)
            })
        };
        let head = match lines.next().map(read).transpose()? {
            Some(ClassLine::Class(head)) if head.version != VERSION => {
                return Err(text!("class-version", version = VERSION));
            }
            Some(ClassLine::Class(head)) if head.is_whole() => head,
            Some(ClassLine::Class(_)) => return Err(text!("class-changed").to_owned()),
            _ => return Err(text!("class-record-head").to_owned()),
        };
        let mut record = Self {
            head,
            students: Vec::new(),
            paces: Vec::new(),
            length: bytes.len() as u64,
        };
        for (index, line) in lines {
            let taken = record.take(read((index, line))?);
            taken.map_err(|error| text!("class-record-line", line = index + 1, error = error))?;
        }
        Ok(record)
    }

    /// Takes a line after the first.
    fn take(&mut self, line: ClassLine) -> Result<(), String> {
        match line {
            ClassLine::Class(_) => return Err(text!("class-record-second").to_owned()),
            ClassLine::Student {
                student,
                token,
                name,
            } => {
                let known = self.student(student)?;
                (known.token, known.name) = (token, clean_name(&name));
            }
            // A class that is over can be gone on with.
            ClassLine::Pace(pace) if pace.phase == Phase::Closed => {}
            ClassLine::Pace(pace) => {
                self.paces.retain(|known| known.step != pace.step);
                self.paces.push(pace);
            }
            ClassLine::Answer { student, given } => {
                let steps = 1..=Lesson::MAX_STEPS;
                if !steps.contains(&given.step) || !(1..=MAX_ROUNDS).contains(&given.round) {
                    return Err(text!("class-unfit").to_owned());
                }
                self.student(student)?.put(given);
            }
        }
        Ok(())
    }

    /// Returns the student with a number, who may be new.
    fn student(&mut self, number: u32) -> Result<&mut ClassStudent, String> {
        if !(1..=MAX_STUDENTS).contains(&number) {
            return Err(text!("class-record-student", most = MAX_STUDENTS));
        }
        let index = number as usize - 1;
        if self.students.len() <= index {
            self.students.resize_with(index + 1, Default::default);
        }
        Ok(&mut self.students[index])
    }

    /// Returns the answers of each student as if they had been handed in.
    pub fn hand_ins(&self) -> Vec<HandIn> {
        let hand_in = |student: &ClassStudent| HandIn {
            name: student.name.clone(),
            title: clean(&self.head.title, 2 * super::MAX_NAME),
            language: self.head.language,
            digest: self.head.digest.clone(),
            source: self.head.source.clone(),
            record: student.record(&self.head),
        };
        self.students.iter().map(hand_in).collect()
    }
}
