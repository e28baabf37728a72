//! What the engine finds wrong with a lesson.

use super::solve::{matched_settings, picture_difference};
use super::{Answer, Budget, Kind, Lab, Lesson, LessonError, LessonProblem, Solution, Step};
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
        let mut texts = vec![&question.ask, &question.why];
        match &question.kind {
            Kind::Choice { options, .. } => texts.extend(options.iter().map(|option| &option.text)),
            Kind::Order { items, .. } => texts.extend(items.iter().map(|item| &item.text)),
            Kind::Curve { x_name, y_name, .. } => texts.extend([x_name, y_name]),
            _ => {}
        }
        for prose in texts {
            if let Err((line, words)) = prose.filled(&place) {
                take(line, words);
            }
        }
        let solved = question.solve(place, 1).and_then(|solution| {
            let grade = Answer::right(&solution).grade(question, &solution, place);
            match grade {
                Some(grade) if grade.right => {}
                _ => return Err(text!("lesson-not-right").to_owned()),
            }
            if let (
                Kind::Match {
                    controls,
                    tolerance,
                    ..
                },
                Solution::Match(values),
            ) = (&question.kind, &solution)
            {
                let target = place.under(&matched_settings(controls, values))?;
                if picture_difference(&place, &target)? < 2.0 * tolerance {
                    return Err(text!("lesson-match-same").to_owned());
                }
            }
            Ok(())
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
