//! The end of a lesson: each question with the answers given to it, what to look at again, and the way to hand in.

use super::data::Course;
use super::handed_in::{cards_ui, mark};
use crate::app::session::action::{Action, Requests, Turn};
use crate::app::widgets::focus::{heading, keep_in_sight};
use crate::lesson::{Answered, Lesson};
use crate::text::text;
use eframe::egui::{Button, Label, RichText, ScrollArea, Ui};
use std::sync::Arc;

/// Shows the results of the open lesson.
pub fn results_ui(ui: &mut Ui, course: &mut Course, requests: &mut Requests) {
    let can_hand_in = course.to_hand_in().is_some();
    let Some(open) = &mut course.open else { return };
    let (lesson, opening) = (Arc::clone(&open.lesson), open.opening);
    let Some(results) = &mut open.results else {
        return;
    };
    let record = course.kept.record(&lesson.name);
    let answer = |step: usize| record.and_then(|record| record.answer(step));
    ScrollArea::vertical()
        .id_salt(("results", opening))
        .auto_shrink(false)
        .show(ui, |ui| {
            // Keeps clear of the scroll bar.
            ui.set_max_width(ui.available_width() - 4.0);
            heading(ui, title(&lesson));
            let questions = asking(&lesson).map(answer);
            let words = summary(questions, lesson.test);
            ui.add(Label::new(RichText::new(words).strong()).wrap());
            if can_hand_in {
                ui.add_space(6.0);
                let words = RichText::new(text!("controls-command-hand-in")).strong();
                let button = ui.add(Button::new(words));
                // The keyboard goes on from here.
                if std::mem::take(&mut results.fresh) {
                    button.request_focus();
                }
                if button.clicked() {
                    requests.ask(Action::HandIn);
                }
            }
            again_ui(ui, &lesson, answer, requests);
            ui.add_space(8.0);
            if !lesson.test
                && let Ok(answers) = &*Arc::clone(&results.answers)
            {
                mark(ui, results, answers, Some(&*lesson));
                cards_ui(ui, results, true);
            }
            ui.add_space(8.0);
            keep_in_sight(ui);
        });
}

/// Returns the title of the page.
pub fn title(lesson: &Lesson) -> &'static str {
    text!(if lesson.test {
        "course-test-end"
    } else {
        "course-results"
    })
}

/// Returns the steps with a question.
fn asking(lesson: &Lesson) -> impl Iterator<Item = usize> {
    let steps = lesson.steps.iter().enumerate();
    steps.filter_map(|(step, of)| of.question.as_ref().map(|_| step))
}

/// Returns whether the first answer was right.
fn at_once(answered: &Answered) -> bool {
    answered.grade.right && answered.tries == 1
}

/// Counts the answers in words; of a `test` without saying how many are right.
fn summary<'a>(questions: impl Iterator<Item = Option<&'a Answered>>, test: bool) -> String {
    let questions: Vec<Option<&Answered>> = questions.collect();
    let count = |holds: fn(&Answered) -> bool| {
        let answered = questions.iter().flatten();
        answered.filter(|answered| holds(answered)).count()
    };
    let answered = count(|_| true);
    if answered == 0 {
        return text!("course-results-none").to_owned();
    }
    if test {
        return text!(
            "course-test-count",
            answered = answered,
            count = questions.len()
        );
    }
    text!(
        "course-results-count",
        answered = answered,
        count = questions.len(),
        right = count(|answered| answered.grade.right),
        first = count(at_once),
        looked = count(|answered| answered.looked_up > 0)
    )
}

/// Shows links to the steps whose first answer was not right, and to those without an answer; in a test to the latter alone.
fn again_ui<'a>(
    ui: &mut Ui,
    lesson: &Lesson,
    answer: impl Fn(usize) -> Option<&'a Answered>,
    requests: &mut Requests,
) {
    let steps: Vec<usize> = asking(lesson)
        .filter(|step| !answer(*step).is_some_and(|answered| lesson.test || at_once(answered)))
        .collect();
    if steps.is_empty() {
        return;
    }
    ui.add_space(6.0);
    ui.label(text!(if lesson.test {
        "course-test-missing"
    } else {
        "course-results-again"
    }));
    for step in steps {
        let title = format!("{}. {}", step + 1, lesson.steps[step].title);
        if ui.link(title).clicked() {
            requests.ask(Action::Course(Turn::To(step)));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lesson::{Answer, Grade};

    #[test]
    fn the_summary_counts_what_was_right_at_once_and_never_praises_an_empty_sheet() {
        let answered = |right: bool, tries: u32, looked_up: u32| Answered {
            step: 0,
            prediction: Answer::Choice(0),
            answer: Answer::Choice(1),
            grade: Grade {
                right,
                ..Grade::default()
            },
            looked_up,
            tries,
            seconds: 1.0,
        };
        let given = [
            answered(true, 1, 0),
            answered(true, 3, 0),
            answered(false, 2, 1),
        ];
        let sheet = given.iter().map(Some).chain([None, None]);
        let words = text!(
            "course-results-count",
            answered = 3,
            count = 5,
            right = 2,
            first = 1,
            looked = 1
        );
        assert_eq!(summary(sheet.clone(), false), words);
        let words = text!("course-test-count", answered = 3, count = 5);
        assert_eq!(
            summary(sheet, true),
            words,
            "a test does not say what is right"
        );
        assert_eq!(
            summary([None, None].into_iter(), false),
            text!("course-results-none")
        );
    }
}
