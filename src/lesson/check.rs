//! The check of a lesson by the engine.

use super::{
    Answer, AnswerKey, Budget, Lab, LabPlace, Lesson, LessonError, LessonProblem, Question, Step,
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
    if problems.is_empty() {
        Ok(remarks)
    } else {
        Err(LessonError { problems })
    }
}

fn check_step(
    lesson: &Lesson,
    step: &Step,
    budget: &Budget,
) -> Result<Vec<LessonProblem>, LessonError> {
    let staged = step.stage.load(lesson.folder.as_deref())?;
    let lab = Lab::within(&staged, budget);
    let place = lab.place(&staged);
    let mut problems = Vec::new();
    let mut remarks = Vec::new();
    let mut take = |line: u64, words: String| problems.push(LessonProblem { line, words });
    for word in &step.stage.controls {
        if word != "light" && Parameter::by_word(word).is_none() {
            take(
                step.stage.line_number,
                text!("lesson-no-control", name = excerpt(word)),
            );
        }
    }
    for prose in [&step.text, &step.after] {
        if let Err((line, words)) = prose.filled(&place) {
            take(line, words);
        }
    }
    if let Some(question) = &step.question {
        let texts = [&question.ask, &question.why].into_iter();
        for prose in texts.chain(question.names()).chain(question.says()) {
            if let Err((line, words)) = prose.filled(&place) {
                take(line, words);
            }
        }
        match check_question(question, place) {
            Ok(found) => remarks = found,
            Err((line, words)) => take(line, text!("lesson-question", words = words)),
        }
    }
    let is_outside = |probe: DVec2| place.pixel(probe).is_none();
    if problems.is_empty() && staged.shown.probe.is_some_and(is_outside) {
        problems.push(LessonProblem {
            line: step.stage.line_number,
            words: text!("lesson-probe-outside").to_owned(),
        });
    }
    if problems.is_empty() {
        Ok(remarks)
    } else {
        Err(LessonError { problems })
    }
}

/// Checks that the right answer of a question is graded as right, and those of its wrong models as wrong.
fn check_question(
    question: &Question,
    place: LabPlace<'_>,
) -> Result<Vec<LessonProblem>, (u64, String)> {
    let here = |words| (question.line, words);
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
            (
                wrong.line,
                text!("lesson-wrong", number = number, words = words),
            )
        })?;
        let apart = fixed(apart, 1);
        remarks.push(LessonProblem {
            line: wrong.line,
            words: text!("lesson-apart", number = number, apart = apart),
        });
    }
    if !question.knows_wrong() {
        remarks.push(LessonProblem {
            line: question.line,
            words: text!("lesson-no-wrong").to_owned(),
        });
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
