//! A question of a lesson as a class was asked it: its numbers filled in, solved, and the answers to it graded.

use super::student::{Given, Student};
use crate::lesson::{
    Answer, AnswerKey, Answered, Budget, Lab, LabPlace, Lesson, LessonProblem, Question, Solution,
    Step, TooHeavy,
};
use crate::render::Frame;

/// A question of the lesson, with its numbers filled in.
#[derive(Debug)]
pub struct ClassQuestion {
    /// The step, from 0.
    pub step: usize,
    /// The question, in CommonMark.
    pub ask: String,
    /// The explanation of the right answer; may be empty.
    pub why: String,
    /// The texts of options or items.
    pub options: Vec<String>,
    /// The explanation of each wrong model, or of each option of a choice.
    pub says: Vec<String>,
    /// The right answer and those of the wrong models; `None` if each student has others, or after a [`Self::failure`].
    pub key: Option<AnswerKey>,
    /// The reason why there is no right answer.
    pub failure: Option<String>,
    /// The picture that the students saw, for a question about a place in it.
    pub picture: Option<Frame>,
}

/// The reason why a question is not graded.
pub(super) enum Failure {
    Question(String),
    Heavy(TooHeavy),
}

impl Failure {
    pub(super) fn words(self) -> String {
        match self {
            Self::Question(words) => words,
            Self::Heavy(why) => why.to_string(),
        }
    }
}

impl ClassQuestion {
    /// Returns the right answer, where all students have the same.
    pub fn solution(&self) -> Option<&Solution> {
        self.key.as_ref().map(|key| &key.right)
    }

    /// Returns the question itself.
    pub fn question<'l>(&self, lesson: &'l Lesson) -> Option<&'l Question> {
        lesson.steps.get(self.step)?.question.as_ref()
    }

    /// Solves the question, fills in its numbers, and grades what the students answered to question `index`.
    pub(super) fn grade(
        &mut self,
        lesson: &Lesson,
        step: &Step,
        budget: &Budget,
        pictures: bool,
        (index, students): (usize, &mut Vec<Student>),
    ) -> Result<(), Failure> {
        let Some(question) = &step.question else {
            return Ok(());
        };
        let staged = step.stage.load(lesson.folder.as_deref());
        let staged = staged.map_err(|error| {
            let words: Vec<_> = error.lines().map(|(_, words)| words).collect();
            Failure::Question(words.join("\n"))
        })?;
        let lab = Lab::within(&staged, budget);
        let place = lab.place(&staged);
        let prepared = self.prepare(question, place, pictures);
        if let Some(heavy) = lab.refused() {
            return Err(Failure::Heavy(heavy));
        }
        prepared.map_err(Failure::Question)?;
        let answers = students.iter_mut().filter_map(|student| {
            let Student {
                seed,
                budget,
                heavy,
                given,
                ..
            } = student;
            Some((*seed, budget, heavy, given.get_mut(index)?.as_mut()?))
        });
        for (seed, budget, heavy, given) in answers {
            lab.bill(budget);
            let graded = self.grade_answer(question, place, seed, given);
            match lab.refused() {
                Some(why) => *heavy = Some((index, why)),
                None => graded.map_err(Failure::Question)?,
            }
        }
        Ok(())
    }

    /// Fills in the numbers, draws what is needed and finds the right answer, where all students have the same.
    fn prepare(
        &mut self,
        question: &Question,
        place: LabPlace<'_>,
        pictures: bool,
    ) -> Result<(), String> {
        if let Ok(filled) = Self::filled(self.step, question, place) {
            *self = filled;
        }
        if pictures && question.kind.asks().asks_place() {
            self.picture = Some(place.counted_picture()?);
        }
        if !question.kind.asks().is_drawn_at_random() {
            self.key = Some(question.solve_all(place, 0)?);
        }
        Ok(())
    }

    fn grade_answer(
        &self,
        question: &Question,
        place: LabPlace<'_>,
        seed: u64,
        given: &mut Given,
    ) -> Result<(), String> {
        let own;
        let key = match &self.key {
            Some(key) => key,
            None => {
                own = question.solve_all(place, seed)?;
                &own
            }
        };
        // What cannot be graded, such as half a curve, is not right.
        let grade = |answer: &Answer| question.grade(answer, key, place).unwrap_or_default();
        let Answered {
            answer, prediction, ..
        } = &given.answered;
        given.grade = Some(grade(answer));
        given.predicted = if answer == prediction {
            given.grade
        } else {
            Some(grade(prediction))
        };
        Ok(())
    }

    /// Fills in the numbers of a step's question and solves it for a live class, which has one right answer.
    ///
    /// # Errors
    /// The reason why there is none, in a sentence.
    pub fn live(
        step: usize,
        question: &Question,
        place: LabPlace<'_>,
        seed: u64,
    ) -> Result<Self, String> {
        let filled = Self::filled(step, question, place).map_err(|problem| problem.words)?;
        let picture = question.kind.asks().asks_place();
        let picture = picture.then(|| place.counted_picture()).transpose()?;
        Ok(Self {
            key: Some(question.solve_all(place, seed)?),
            picture,
            ..filled
        })
    }

    /// Fills in the numbers in the texts of a step's question.
    pub(in crate::lesson) fn filled(
        step: usize,
        question: &Question,
        place: LabPlace<'_>,
    ) -> Result<Self, LessonProblem> {
        let options = question.kind.asks().options().into_iter();
        let options: Result<_, _> = options.map(|prose| prose.filled(&place)).collect();
        let says = question.says().into_iter();
        let says: Result<_, _> = says.map(|prose| prose.filled(&place)).collect();
        Ok(Self {
            ask: question.ask.filled(&place)?,
            why: question.why.filled(&place)?,
            options: options?,
            says: says?,
            ..Self::empty(step)
        })
    }

    pub(super) fn empty(step: usize) -> Self {
        Self {
            step,
            ask: String::new(),
            why: String::new(),
            options: Vec::new(),
            says: Vec::new(),
            key: None,
            failure: None,
            picture: None,
        }
    }
}
