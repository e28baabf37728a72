//! The answers of a class: hand-ins and records of live classes sorted by lesson, and graded by the engine. What a hand-in says of its own grades is not read.

mod question;
mod student;

pub use question::ClassQuestion;
pub use student::{Given, Student};

use super::class_record::ClassRecord;
use super::hand_in::{HandIn, digest, read_hand_in};
use super::kinds::kind::counted;
use super::kinds::{short_number, with_unit};
use super::{Answer, Budget, BuiltIn, Kind, Lesson, SameFormula, Solution, Step, find};
use crate::document::open_picture;
use crate::text::{Language, in_language, listed, text};
use question::Failure;
use std::collections::HashMap;
use std::io::{BufRead, Cursor, Read, Seek};
use std::path::PathBuf;

/// A picture that was handed in, or the record of a live class.
#[derive(Clone, Debug)]
pub struct Handed {
    /// The name of its file.
    pub path: PathBuf,
    /// The content; `None` if it is read from the file.
    pub bytes: Option<Vec<u8>>,
}

/// Everything that was handed in.
#[derive(Debug, Default)]
pub struct Class {
    /// The hand-ins, by lesson.
    pub groups: Vec<Group>,
    /// Files that cannot be read or graded.
    pub unreadable: Vec<Unreadable>,
    /// Readable files that do not count: without answers, or handed in again by the same student.
    pub set_aside: Vec<Unreadable>,
}

/// A file that does not count.
#[derive(Clone, Debug)]
pub struct Unreadable {
    /// The file's name.
    pub file: String,
    /// The reason, in the current language.
    pub why: String,
    /// The reason in English, for programs.
    pub english: String,
}

/// The students who worked through the same lesson.
#[derive(Debug)]
pub struct Group {
    /// The lesson.
    pub lesson: Lesson,
    /// Its questions, in their order.
    pub questions: Vec<ClassQuestion>,
    /// The hand-ins, by the names of their files.
    pub students: Vec<Student>,
    /// True if the lesson came inside a hand-in; it may then open no file.
    foreign: bool,
}

impl Unreadable {
    /// Notes a file with the reason, in both languages.
    fn new(file: String, words: impl Fn() -> String) -> Self {
        Self {
            file,
            why: words(),
            english: in_language(Language::English, words),
        }
    }
}

impl Group {
    /// Returns whether the lesson came inside a hand-in.
    pub fn foreign(&self) -> bool {
        self.foreign
    }

    /// Returns the answers to a question, of those who gave one.
    pub fn given(&self, question: usize) -> impl Iterator<Item = &Given> {
        let students = self.students.iter();
        students.filter_map(move |student| student.given.get(question)?.as_ref())
    }

    /// Returns the fraction of the class whose answer to a question is right.
    pub fn share_right(&self, question: usize) -> f64 {
        let right = self.given(question).filter(|given| given.is_right());
        right.count() as f64 / self.students.len().max(1) as f64
    }

    /// Returns the numbers that were predicted, in order; of places, curves and pictures how far they are off.
    pub fn predicted(&self, question: usize) -> Vec<f64> {
        let mut numbers: Vec<f64> = self
            .given(question)
            .filter_map(|given| {
                let number = given.answered.prediction.number();
                number.or(given.predicted?.off)
            })
            .collect();
        numbers.sort_by(f64::total_cmp);
        numbers
    }

    /// Returns the wrong models that first answers agree with, each with how often; the most frequent first.
    pub fn models(&self, question: usize) -> Vec<(usize, usize)> {
        counted(
            self.given(question)
                .filter_map(|given| given.predicted?.model),
        )
    }

    /// Describes how the predicted numbers are spread, or how far the predictions are off; none where they have no
    /// numbers.
    pub fn spread_words(&self, question: usize) -> Option<String> {
        let asked = self.questions.get(question)?.question(&self.lesson)?;
        let own = asked.kind.asks().predicts_number();
        let numbers = self.predicted(question);
        let unit = if own { asked.kind.asks().unit() } else { "" };
        let words = |number: f64| with_unit(&short_number(number), unit);
        let [least, lower, median, upper, greatest] = spread(&numbers)?.map(words);
        let key = |own_key, off_key| if own { own_key } else { off_key };
        Some(if least == greatest {
            let key = key("class-predicted-same", "class-off-same");
            text!(key, value = least)
        } else if numbers.len() < QUARTERED {
            let key = key("class-predicted-few", "class-off-few");
            text!(key, values = listed(numbers.into_iter().map(words)))
        } else {
            text!(
                key("class-predicted", "class-off"),
                least = least,
                lower = lower,
                median = median,
                upper = upper,
                greatest = greatest
            )
        })
    }

    /// Returns the formulas that were predicted, sorted by their meaning; none of another kind of question.
    pub fn formulas(&self, question: usize) -> Vec<SameFormula> {
        let asked = self.questions.get(question);
        let question_of = asked.and_then(|asked| asked.question(&self.lesson));
        let kind = question_of.map(|question| &question.kind);
        let right = asked.and_then(ClassQuestion::solution);
        let (Some(Kind::Formula(kind)), Some(Solution::Formula(right))) = (kind, right) else {
            return Vec::new();
        };
        let given = self.given(question).filter_map(|given| {
            let Answer::Formula(text) = &given.answered.prediction else {
                return None;
            };
            Some((&**text, given.predicted.unwrap_or_default()))
        });
        kind.sorted(given, right)
    }

    /// Returns the answers that were predicted, each with how often; the most frequent first.
    pub fn counted(&self, question: usize) -> Vec<(&Answer, usize)> {
        counted(self.given(question).map(|given| &given.answered.prediction))
    }
}

/// The number of answers from which on quartiles say more than the answers themselves.
const QUARTERED: usize = 5;

/// Returns the smallest, the quartiles and the largest of sorted numbers.
pub fn spread(sorted: &[f64]) -> Option<[f64; 5]> {
    let last = sorted.len().checked_sub(1)?;
    Some([0.0, 0.25, 0.5, 0.75, 1.0].map(|share| {
        let at = share * last as f64;
        let (below, above) = (sorted[at.floor() as usize], sorted[at.ceil() as usize]);
        below + (above - below) * at.fract()
    }))
}

/// Reads files that were handed in and grades them. With a `lesson` all must be answers to that one. With `pictures` those
/// of questions about places are drawn. `progress` is called after each file and each question.
pub fn collect(
    files: &[Handed],
    lesson: Option<&Lesson>,
    pictures: bool,
    progress: &mut dyn FnMut(),
) -> Class {
    let mut class = Class::default();
    for (index, handed) in files.iter().enumerate() {
        if let Err(why) = class.take(index, handed, lesson) {
            let english = in_language(Language::English, || {
                let again = Class::default().take(index, handed, lesson);
                again.err().unwrap_or_else(|| why.clone())
            });
            let file = handed.path.display().to_string();
            class.unreadable.push(Unreadable { file, why, english });
        }
        progress();
    }
    class.set_repeated_aside();
    for group in &mut class.groups {
        group.grade(pictures, progress);
        class.unreadable.extend(group.take_heavy());
    }
    class.groups.retain(|group| !group.students.is_empty());
    class
}

impl Class {
    /// Reads a file and puts it with those of its lesson.
    fn take(
        &mut self,
        index: usize,
        handed: &Handed,
        lesson: Option<&Lesson>,
    ) -> Result<(), String> {
        let file = handed.path.display().to_string();
        let without_name = |error: String| {
            let own = error.strip_prefix(&format!("{file}: ")).map(str::to_owned);
            own.unwrap_or(error)
        };
        let mut hand_ins = match &handed.bytes {
            Some(bytes) => hand_ins(Cursor::new(bytes)),
            None => {
                let opened = open_picture(&handed.path);
                hand_ins(opened.map_err(|error| without_name(error.to_string()))?)
            }
        }?;
        let of_class = hand_ins.len() > 1;
        hand_ins.retain(|(_, hand_in)| !hand_in.record.answers.is_empty());
        if hand_ins.is_empty() {
            let words = || text!("class-empty").to_owned();
            self.set_aside.push(Unreadable::new(file.clone(), words));
        }
        for (number, hand_in) in hand_ins {
            let name = match of_class {
                true => format!("{file}:{number}"),
                false => file.clone(),
            };
            self.take_hand_in(index, name, hand_in, lesson)?;
        }
        Ok(())
    }

    /// Puts a hand-in with those of its lesson.
    fn take_hand_in(
        &mut self,
        index: usize,
        file: String,
        hand_in: HandIn,
        lesson: Option<&Lesson>,
    ) -> Result<(), String> {
        let mut groups = self.groups.iter();
        let place = match groups.position(|group| group.is_of(&hand_in, lesson)) {
            Some(place) => place,
            None => {
                let (lesson, foreign) = lesson_of(&hand_in, lesson)?;
                self.groups.push(Group::new(lesson, foreign));
                self.groups.len() - 1
            }
        };
        // The lecturer's own lesson may have changed since.
        self.groups[place].add(index, file, hand_in, lesson.is_some())
    }

    /// Sets aside what a student handed in before, in another file. Students are known by their names; without a name
    /// each hand-in is one.
    fn set_repeated_aside(&mut self) {
        for group in &mut self.groups {
            let mut last: HashMap<String, (usize, String)> = HashMap::new();
            let named = |student: &&Student| !student.name.is_empty();
            for student in group.students.iter().filter(named) {
                let file = (student.index, student.file.clone());
                last.insert(key_of(&student.name), file);
            }
            let repeated = group.students.extract_if(.., |student| {
                last.get(&key_of(&student.name))
                    .is_some_and(|(index, _)| *index != student.index)
            });
            self.set_aside.extend(repeated.map(|student| {
                let (_, later) = &last[&key_of(&student.name)];
                let words = || text!("class-again", file = later.as_str());
                Unreadable::new(student.file.clone(), words)
            }));
        }
    }
}

/// Reads the answers in a picture, or those of each student in the record of a live class, with the student's number.
fn hand_ins(mut file: impl BufRead + Seek) -> Result<Vec<(usize, HandIn)>, String> {
    if !file.fill_buf().is_ok_and(ClassRecord::begins) {
        let hand_in = read_hand_in(file).map_err(|error| error.to_string())?;
        return Ok(vec![(1, hand_in)]);
    }
    let mut bytes = Vec::new();
    let read = file
        .take(ClassRecord::MAX_BYTES + 1)
        .read_to_end(&mut bytes);
    read.map_err(|error| error.to_string())?;
    let hand_ins = ClassRecord::read(&bytes)?.hand_ins();
    Ok((1..).zip(hand_ins).collect())
}

/// Returns a name without the differences of case and space that people make.
fn key_of(name: &str) -> String {
    let words: Vec<String> = name.split_whitespace().map(str::to_lowercase).collect();
    words.join(" ")
}

/// Returns whether a hand-in answers the present version of a lesson that comes with the program, in any language.
fn is_version_of(hand_in: &HandIn, built_in: &BuiltIn) -> bool {
    let mut languages = Language::ALL.into_iter();
    languages.any(|language| digest([built_in.source(language)]) == hand_in.digest)
}

/// Finds the lesson that a hand-in answers: `lesson` if that is given, else the one inside the hand-in, else the program's own.
/// Returns true with the one inside.
///
/// # Errors
/// A hand-in to another lesson, to another version of it, or to none that is known.
pub fn lesson_of(hand_in: &HandIn, lesson: Option<&Lesson>) -> Result<(Lesson, bool), String> {
    let name = &*hand_in.record.lesson;
    let mut foreign = false;
    let lesson = match (lesson, find(name), &hand_in.source) {
        (Some(lesson), ..) if lesson.name == name => lesson.clone(),
        (Some(lesson), ..) => {
            return Err(text!(
                "class-other-lesson",
                lesson = name,
                expected = &*lesson.name
            ));
        }
        (None, Some(built_in), None) => {
            if !is_version_of(hand_in, built_in) {
                return Err(text!("class-other-version", lesson = name));
            }
            built_in.lesson()
        }
        (None, _, Some(source)) => {
            foreign = true;
            Lesson::read(source, None).map_err(|error| {
                let told = |line: &str| text!("class-bad-lesson", error = line);
                let lines: Vec<_> = error.to_string().lines().map(told).collect();
                lines.join("\n")
            })?
        }
        (None, None, None) => return Err(text!("class-no-lesson", lesson = name)),
    };
    if lesson.name != name {
        return Err(text!("class-no-lesson", lesson = name));
    }
    Ok((lesson, foreign))
}

/// Grades a single hand-in. A `foreign` lesson came inside it, and may open no file. `progress` is called after each question.
///
/// # Errors
/// An answer that fits no question of the lesson.
pub fn mark(
    hand_in: HandIn,
    lesson: Lesson,
    foreign: bool,
    progress: &mut dyn FnMut(),
) -> Result<Group, String> {
    let mut group = Group::new(lesson, foreign);
    group.add(0, String::new(), hand_in, false)?;
    group.grade(false, progress);
    Ok(group)
}

impl Group {
    /// Adds a hand-in. An answer that fits no question is left out where it `may` be, and an error elsewhere.
    fn add(
        &mut self,
        index: usize,
        file: String,
        hand_in: HandIn,
        may: bool,
    ) -> Result<(), String> {
        let mut record = hand_in.record;
        let count = record.answers.len();
        record.fit(&self.lesson);
        if count != record.answers.len() && !may {
            return Err(text!("class-unfit").to_owned());
        }
        let mut given = vec![None; self.questions.len()];
        for answered in record.answers {
            let question = self
                .questions
                .iter()
                .position(|asked| asked.step == answered.step);
            if let Some(question) = question {
                given[question] = Some(Given {
                    answered,
                    grade: None,
                    predicted: None,
                });
            }
        }
        self.students.push(Student {
            index,
            file,
            name: hand_in.name,
            seed: record.seed,
            budget: Budget::of_file(),
            heavy: None,
            given,
        });
        Ok(())
    }

    fn new(lesson: Lesson, foreign: bool) -> Self {
        let asked = |(step, of): (usize, &Step)| {
            let question = of.question.as_ref();
            question.map(|_| ClassQuestion::empty(step))
        };
        let questions = lesson.steps.iter().enumerate().filter_map(asked).collect();
        Self {
            lesson,
            questions,
            students: Vec::new(),
            foreign,
        }
    }

    /// Returns whether a hand-in belongs to it.
    fn is_of(&self, hand_in: &HandIn, lesson: Option<&Lesson>) -> bool {
        let name = self.lesson.name == hand_in.record.lesson;
        name && match (lesson, &hand_in.source) {
            (Some(_), _) => true,
            (None, Some(source)) => self.foreign && self.lesson.source == *source,
            // Any language, but not another version of the lesson.
            (None, None) => {
                let built_in = find(&self.lesson.name);
                !self.foreign && built_in.is_some_and(|built_in| is_version_of(hand_in, built_in))
            }
        }
    }

    /// Grades every answer. A lesson out of a hand-in that takes too much work makes those files too heavy that it came with.
    fn grade(&mut self, pictures: bool, progress: &mut dyn FnMut()) {
        let budget = Budget::of_file();
        let Self {
            lesson,
            questions,
            students,
            foreign,
        } = self;
        for (index, asked) in questions.iter_mut().enumerate() {
            let Some(step) = lesson.steps.get(asked.step) else {
                continue;
            };
            if *foreign && step.stage.names_file() {
                asked.failure = Some(text!("class-needs-lesson").to_owned());
                progress();
                continue;
            }
            match asked.grade(lesson, step, &budget, pictures, (index, &mut *students)) {
                Err(Failure::Heavy(why)) if *foreign => {
                    let heavy = |student: &mut Student| student.heavy = Some((index, why));
                    return students.iter_mut().for_each(heavy);
                }
                Err(failure) => asked.failure = Some(failure.words()),
                Ok(()) => {}
            }
            progress();
        }
    }

    /// Takes out those whose files are too heavy.
    fn take_heavy(&mut self) -> Vec<Unreadable> {
        let heavy = self
            .students
            .extract_if(.., |student| student.heavy.is_some());
        let unreadable = |student: Student| {
            let (question, why) = student.heavy?;
            Some(Unreadable::new(student.file, || {
                let (question, why) = (question + 1, why.to_string());
                text!("class-too-heavy", question = question, why = why)
            }))
        };
        heavy.filter_map(unreadable).collect()
    }
}
