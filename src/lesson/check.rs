//! The check of a lesson by the engine.

use super::{
    Answer, AnswerKey, Budget, Lab, LabPlace, Lesson, LessonError, LessonProblem, Prose, Question,
    Step,
};
use crate::scene::parameter::Parameter;
use crate::text::{excerpt, fixed, text};
use glam::DVec2;

/// The least distance of a wrong model from the right answer, in tolerances: below it a right answer that is rounded would be
/// taken for the wrong one.
const APART: f64 = 0.5;

/// Loads every scene, fills in every number, finds the answer of every question and grades those of its wrong models. Returns
/// remarks: how far the wrong models are from the right answers, and which questions have none.
///
/// # Errors
/// Everything that is wrong, with its line.
pub fn check(lesson: &Lesson) -> Result<Vec<LessonProblem>, LessonError> {
    let (mut problems, mut remarks) = (Vec::new(), Vec::new());
    let budget = Budget::of_file();
    for step in &lesson.steps {
        match check_step(lesson, step, &budget) {
            Ok(found) => remarks.extend(found),
            Err(error) => problems.extend(error.problems),
        }
        if budget.is_spent() {
            break;
        }
    }
    problems
        .is_empty()
        .then_some(remarks)
        .ok_or(LessonError { problems })
}

fn check_step(
    lesson: &Lesson,
    step: &Step,
    budget: &Budget,
) -> Result<Vec<LessonProblem>, LessonError> {
    let staged = step.stage.load(lesson.folder.as_deref())?;
    let lab = Lab::within(&staged, budget);
    let place = lab.place(&staged);
    let line = step.stage.line_number;
    let mut problems = Vec::new();
    let mut remarks = Vec::new();
    for word in &step.stage.controls {
        if word != "light" && Parameter::by_word(word).is_none() {
            let words = text!("lesson-no-control", name = excerpt(word));
            problems.push(LessonProblem::new(line, words));
        }
    }
    let unfilled = |prose: &Prose| prose.filled(&place).err();
    problems.extend([&step.text, &step.after].into_iter().filter_map(unfilled));
    if let Some(question) = &step.question {
        let texts = [&question.ask, &question.why].into_iter();
        let texts = texts.chain(question.names()).chain(question.says());
        problems.extend(texts.filter_map(unfilled));
        match check_question(question, place) {
            Ok(found) => remarks = found,
            Err(LessonProblem { line, words }) => {
                let words = text!("lesson-question", words = words);
                problems.push(LessonProblem::new(line, words));
            }
        }
    }
    let is_outside = |probe: DVec2| place.pixel(probe).is_none();
    if problems.is_empty() && staged.shown.probe.is_some_and(is_outside) {
        problems.push(LessonProblem::new(line, text!("lesson-probe-outside")));
    }
    problems
        .is_empty()
        .then_some(remarks)
        .ok_or(LessonError { problems })
}

/// Checks that the right answer of a question is graded as right, and those of its wrong models as wrong.
fn check_question(
    question: &Question,
    place: LabPlace<'_>,
) -> Result<Vec<LessonProblem>, LessonProblem> {
    let here = |words: String| LessonProblem::new(question.line, words);
    let key = question.solve_all(place, 1).map_err(here)?;
    let grade = question.grade(&Answer::right(&key.right), &key, place);
    if !grade.is_some_and(|grade| grade.right) {
        return Err(here(text!("lesson-not-right").to_owned()));
    }
    question.kind.check(&key.right, place).map_err(here)?;
    let mut remarks = Vec::new();
    for (index, wrong) in question.wrong.iter().enumerate() {
        let number = index + 1;
        let apart = check_wrong(question, index, &key, place).map_err(|words| {
            let words = text!("lesson-wrong", number = number, words = words);
            LessonProblem::new(wrong.line, words)
        })?;
        let words = text!("lesson-apart", number = number, apart = fixed(apart, 1));
        remarks.push(LessonProblem::new(wrong.line, words));
    }
    if !question.knows_wrong() {
        remarks.push(here(text!("lesson-no-wrong").to_owned()));
    }
    Ok(remarks)
}

/// Checks that the answer of a wrong model is graded as that, and returns how many tolerances it is from the right one.
fn check_wrong(
    question: &Question,
    index: usize,
    key: &AnswerKey,
    place: LabPlace<'_>,
) -> Result<f64, String> {
    let wrong = &key.wrong[index];
    let there = place.under(&question.set)?;
    let apart = question.kind.separation(wrong, &key.right, there);
    let apart = apart.ok_or_else(|| text!("lesson-wrong-unfit").to_owned())?;
    if apart < APART {
        let (apart, least) = (fixed(apart, 2), fixed(APART, 1));
        return Err(text!("lesson-wrong-near", apart = apart, least = least));
    }
    let grade = question.grade(&Answer::right(wrong), key, place);
    match grade.and_then(|grade| grade.model) {
        Some(model) if model == index => Ok(apart),
        Some(other) => Err(text!("lesson-wrong-same", other = other + 1)),
        // It agrees with itself, unless an answer like it cannot be graded.
        None => Err(text!("lesson-wrong-unfit").to_owned()),
    }
}
