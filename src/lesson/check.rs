//! The check of a lesson by the engine.

use super::{Answer, Budget, Lab, Lesson, LessonError, LessonProblem, Step};
use crate::scene::parameter::Parameter;
use crate::text::{excerpt, text};

/// Loads every scene, fills in every number and finds the answer of every question.
///
/// # Errors
/// Everything that is wrong, with its line.
pub fn check(lesson: &Lesson) -> Result<(), LessonError> {
    let mut problems = Vec::new();
    let budget = Budget::of_file();
    for step in &lesson.steps {
        if let Err(error) = check_step(lesson, step, &budget) {
            problems.extend(error.problems);
        }
        if budget.is_spent() {
            break;
        }
    }
    if problems.is_empty() {
        Ok(())
    } else {
        Err(LessonError { problems })
    }
}

fn check_step(lesson: &Lesson, step: &Step, budget: &Budget) -> Result<(), LessonError> {
    let staged = step.stage.load(lesson.folder.as_deref())?;
    let lab = Lab::within(&staged, budget);
    let place = lab.place(&staged);
    let mut problems = Vec::new();
    let mut take = |line: u64, words: String| problems.push(LessonProblem { line, words });
    for word in &step.stage.controls {
        if word != "light" && Parameter::by_word(word).is_none() {
            take(
                step.stage.line_number,
                text!("lesson-no-control", name = excerpt(word)),
            );
        }
    }
    if let Err((line, words)) = step.text.filled(&place) {
        take(line, words);
    }
    if let Some(question) = &step.question {
        let texts = [&question.ask, &question.why];
        for prose in texts.into_iter().chain(question.names()) {
            if let Err((line, words)) = prose.filled(&place) {
                take(line, words);
            }
        }
        let solved = question.solve(place, 1).and_then(|right| {
            let grade = question.grade(&Answer::right(&right), &right, place);
            if grade.is_some_and(|grade| grade.right) {
                question.kind.check(&right, place)
            } else {
                Err(text!("lesson-not-right").to_owned())
            }
        });
        if let Err(words) = solved {
            take(question.line, text!("lesson-question", words = words));
        }
    }
    if problems.is_empty() {
        Ok(())
    } else {
        Err(LessonError { problems })
    }
}
