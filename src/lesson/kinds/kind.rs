//! A kind of question: all that a lesson, its worksheet and a class ask of one.

use crate::lesson::html::Html;
use crate::lesson::page::blank_picture;
use crate::lesson::read::keys::{KeyReader, Keys};
use crate::lesson::{Grade, Hint, LabPlace, Prose};
use crate::render::Frame;

/// The properties of a question that do not depend on the type of its answer.
pub trait AnyKind {
    /// Returns the texts of the options or the items, which have letters.
    fn options(&self) -> Vec<&Prose> {
        Vec::new()
    }

    /// Returns the names of the axes.
    fn axes(&self) -> Vec<&Prose> {
        Vec::new()
    }

    /// Returns the controls that answer it.
    fn controls(&self) -> &[String] {
        &[]
    }

    /// Returns a line that says what is expected, for a terminal.
    fn hint(&self) -> Option<String> {
        None
    }

    /// Returns the unit of the numbers that answer it; may be empty.
    fn unit(&self) -> &str {
        ""
    }

    /// Returns whether its answer is one number.
    fn predicts_number(&self) -> bool {
        false
    }

    /// Returns whether its answer is a drawing.
    fn is_drawn(&self) -> bool {
        false
    }

    /// Returns whether its answer is drawn over the places of the step's line.
    fn follows_line(&self) -> bool {
        false
    }

    /// Returns whether its answer is a place in the picture.
    fn asks_place(&self) -> bool {
        false
    }

    /// Returns whether the picture has a part in the question, and is printed with it.
    fn uses_picture(&self) -> bool {
        false
    }

    /// Returns whether the right answer is part of what is asked.
    fn shows_target(&self) -> bool {
        false
    }

    /// Returns whether each student has another right answer, by the seed.
    fn is_drawn_at_random(&self) -> bool {
        false
    }

    /// Returns whether the chart of a class tells the right answer.
    fn chart_tells(&self) -> bool {
        self.is_drawn()
    }
}

/// A kind of question: how it is read, solved, graded and printed.
pub trait QuestionKind: AnyKind + Sized {
    /// The answer of a student.
    type Answer;
    /// The right answer, or that of a wrong model.
    type Solution;

    /// The keys of a `[[wrong]]` by which a wrong model is given, besides `set`; none where it is given otherwise.
    const MODEL_KEYS: &[&str];

    /// Reads the keys of the kind.
    fn read(keys: &Keys, reader: &mut KeyReader<'_, '_>) -> Option<Self>;

    /// Finds the right answer in a scene; `seed` decides what is drawn at random.
    fn solve(&self, place: LabPlace<'_>, seed: u64) -> Result<Self::Solution, String>;

    /// Finds the answer of a wrong model in a scene: it need not be the only one, but one that can be given.
    fn solve_wrong(&self, place: LabPlace<'_>, seed: u64) -> Result<Self::Solution, String> {
        self.solve(place, seed)
    }

    /// Checks what is the matter with a question whose right answer is graded as right.
    fn check(&self, _right: &Self::Solution, _place: LabPlace<'_>) -> Result<(), String> {
        Ok(())
    }

    /// Returns the right answer as a student would give it.
    fn right(right: &Self::Solution) -> Self::Answer;

    /// Returns whether an answer can be graded: its numbers are finite, its indices exist.
    fn fits(&self, given: &Self::Answer) -> bool;

    /// Returns the largest distance at which an answer counts as the same.
    fn tolerance(&self) -> f64;

    /// Returns the distance of an answer from that of a model; none where it cannot be compared.
    fn distance(
        &self,
        given: &Self::Answer,
        model: &Self::Solution,
        place: LabPlace<'_>,
    ) -> Option<f64>;

    /// Returns the distance of an answer from the right one.
    fn off(
        &self,
        given: &Self::Answer,
        right: &Self::Solution,
        place: LabPlace<'_>,
    ) -> Option<f64> {
        self.distance(given, right, place)
    }

    /// Returns where a wrong answer, which is that of no wrong model, is off.
    fn fault(
        &self,
        given: &Self::Answer,
        right: &Self::Solution,
        place: LabPlace<'_>,
    ) -> Option<Hint>;

    /// Grades an answer: right is what is within the tolerance, and no nearer to a wrong model.
    fn grade(
        &self,
        given: &Self::Answer,
        right: &Self::Solution,
        wrong: &[&Self::Solution],
        place: LabPlace<'_>,
    ) -> Option<Grade> {
        let off = self.off(given, right, place)?;
        let mut grade = Grade::within(off, self.tolerance());
        let far = |model: &&Self::Solution| self.distance(given, model, place);
        let nearest = wrong
            .iter()
            .map(|model| far(model).unwrap_or(f64::INFINITY));
        let nearest = nearest.enumerate().min_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((model, near)) = nearest
            && near < off
        {
            (grade.right, grade.score) = (false, 0.0);
            grade.model = (near <= self.tolerance()).then_some(model);
        }
        if !grade.right && grade.model.is_none() {
            grade.hint = self.fault(given, right, place);
        }
        Some(grade)
    }

    /// Returns the number that an answer is.
    fn number(_given: &Self::Answer) -> Option<f64> {
        None
    }

    /// Returns an answer in a few characters.
    fn short(given: &Self::Answer) -> String;

    /// Returns the right answer in a few characters.
    fn short_solution(&self, right: &Self::Solution) -> String {
        Self::short(&Self::right(right))
    }

    /// Returns an answer in the words of its question.
    fn words(&self, given: &Self::Answer, options: &[String]) -> String;

    /// Returns the right answer in words for print; none of a drawing.
    fn solution_words(&self, right: &Self::Solution, options: &[String]) -> String;

    /// Returns the HTML in which the student answers on a worksheet; with the right answer, where that is known.
    fn blank(&self, printed: &Printed<'_>, right: Option<&Self::Solution>) -> Result<Html, String>;

    /// Returns the HTML of the right answer as a drawing, where that says more than words.
    fn drawing(
        &self,
        _right: &Self::Solution,
        _printed: &Printed<'_>,
    ) -> Result<Option<Html>, String> {
        Ok(None)
    }

    /// Returns the HTML of the first answers of a class.
    fn chart(&self, class: &Predictions<'_, Self::Answer, Self::Solution>) -> Html;
}

/// A question as it is printed on a worksheet.
pub struct Printed<'p> {
    /// The question with its numbers.
    pub ask: &'p str,
    /// The texts of options or items with their numbers.
    pub options: &'p [String],
    /// Settings for the right answer alone.
    pub set: &'p [String],
    /// The step's scene.
    pub place: LabPlace<'p>,
    /// The step's picture.
    pub picture: &'p Frame,
    /// The seed of what is drawn at random.
    pub seed: u64,
    /// True if pictures are left blank.
    pub without_pictures: bool,
}

impl Printed<'_> {
    /// Draws the scene with other settings.
    pub fn picture_under(&self, settings: &[String]) -> Result<Frame, String> {
        if self.without_pictures {
            return Ok(blank_picture());
        }
        self.place.under(settings)?.counted_picture()
    }
}

/// The first answers of a class to a question.
pub struct Predictions<'c, Answer, Solution> {
    /// The answers with their grades.
    pub given: Vec<(&'c Answer, Grade)>,
    /// The right answer, if it is the same for all.
    pub right: Option<&'c Solution>,
    /// The texts of options or items.
    pub options: &'c [String],
    /// The picture, of a question about a place in it.
    pub picture: Option<&'c Frame>,
}

impl<'c, Answer, Solution> Predictions<'c, Answer, Solution> {
    /// Returns the predictions as those of one kind.
    pub fn of_kind<A, S>(
        &self,
        answer: impl Fn(&'c Answer) -> Option<&'c A>,
        solution: impl Fn(&'c Solution) -> Option<&'c S>,
    ) -> Predictions<'c, A, S> {
        let given = self.given.iter();
        Predictions {
            given: given
                .filter_map(|(given, grade)| Some((answer(given)?, *grade)))
                .collect(),
            right: self.right.and_then(solution),
            options: self.options,
            picture: self.picture,
        }
    }
}

impl<Answer: PartialEq, Solution> Predictions<'_, Answer, Solution> {
    /// Returns each answer with how often it was given, the most frequent first.
    pub fn counted(&self) -> Vec<(&Answer, usize)> {
        counted(self.given.iter().map(|(answer, _)| *answer))
    }
}

/// Returns each value with how often it occurs, the most frequent first.
pub fn counted<T: PartialEq>(values: impl Iterator<Item = T>) -> Vec<(T, usize)> {
    let mut counted: Vec<(T, usize)> = Vec::new();
    for value in values {
        match counted.iter_mut().find(|(known, _)| *known == value) {
            Some((_, count)) => *count += 1,
            None => counted.push((value, 1)),
        }
    }
    counted.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
    counted
}
