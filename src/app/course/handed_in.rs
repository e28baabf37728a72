//! Answers that were handed in, beside their picture, with their author, their lesson and a mark for each.

use super::data::Course;
use super::marking::{HandedIn, Marked, MarkedAnswer, MarkedQuestion, Marking};
use super::parts::{card, error_ui, waiting_ui};
use super::prose::prose_ui;
use crate::app::session::Session;
use crate::app::widgets::background::wake;
use crate::app::widgets::focus::{heading, keep_in_sight, named};
use crate::app::widgets::mark::mark_ui;
use crate::lesson::{HandIn, Lesson, how_given};
use crate::text::text;
use eframe::egui::accesskit::Role;
use eframe::egui::{Align, Label, Layout, RichText, ScrollArea, TextStyle, Ui, vec2};
use egui_commonmark::CommonMarkCache;
use std::sync::Arc;

/// The side of the sign for right or wrong, in points.
const SIGN: f32 = 16.0;
/// The width of the label in front of an answer, in points.
const LABEL: f32 = 84.0;

/// Shows the answers, with the marks that are known.
pub fn handed_in_ui(ui: &mut Ui, course: &mut Course, session: &Session) {
    let own = course.own.clone();
    let Some(handed_in) = &mut course.handed_in else {
        return;
    };
    let answers = Arc::clone(&handed_in.answers);
    ScrollArea::vertical()
        .id_salt("handed-in")
        .auto_shrink(false)
        .show(ui, |ui| {
            // Keeps clear of the scroll bar.
            ui.set_max_width(ui.available_width() - 4.0);
            match &*answers {
                Err(why) => {
                    heading(ui, &session.document().origin.name());
                    error_ui(ui, &text!("course-answers-void", why = why.to_string()));
                }
                Ok(answers) => {
                    mark(ui, handed_in, answers, own.as_deref());
                    head_ui(ui, session, answers, handed_in);
                    cards_ui(ui, handed_in, false);
                }
            }
            ui.add_space(8.0);
            keep_in_sight(ui);
        });
}

/// Starts to grade the answers in the background, and takes the grades; `own` is the lesson opened from a file.
pub fn mark(ui: &Ui, handed_in: &mut HandedIn, answers: &HandIn, own: Option<&Lesson>) {
    let work = &mut handed_in.work;
    work.take();
    if work.known().is_none()
        && work.progress().is_none()
        && let Some(marking) = Marking::of(answers, own)
    {
        work.start(marking, wake(ui.ctx()));
    }
}

/// Shows the author, the lesson, and the number of right answers.
fn head_ui(ui: &mut Ui, session: &Session, answers: &HandIn, handed_in: &HandedIn) {
    let marked = handed_in.work.answer();
    let file = session.document().origin.name();
    let name = Some(&answers.name).filter(|name| !name.is_empty());
    heading(ui, name.unwrap_or(&file));
    let title = marked.map_or(&answers.title, |marked| &marked.title);
    ui.add(Label::new(RichText::new(title).weak()).wrap());
    if let Some(Marked {
        right, questions, ..
    }) = marked
    {
        let count = questions.len();
        let words = text!("course-answers-right", right = *right, count = count);
        ui.label(RichText::new(words).strong());
    }
    ui.add_space(6.0);
}

/// Shows a card for each question, once the answers are graded. In the student's `own` lesson a right answer appears only where it
/// was looked up: the lesson may go on.
pub fn cards_ui(ui: &mut Ui, handed_in: &mut HandedIn, own: bool) {
    let HandedIn { work, markdown, .. } = handed_in;
    match work.known() {
        None => waiting_ui(ui, text!("course-answers-marking")),
        Some(Err(why)) => error_ui(ui, &text!("course-answers-void", why = why.as_str())),
        Some(Ok(marked)) => {
            for (index, question) in marked.questions.iter().enumerate() {
                ui.push_id(index, |ui| {
                    question_ui(ui, markdown, (index + 1, question), own);
                });
                ui.add_space(4.0);
            }
        }
    }
}

/// Shows a card with the question, the answer, its mark, and the right answer.
fn question_ui(
    ui: &mut Ui,
    markdown: &mut CommonMarkCache,
    (number, question): (usize, &MarkedQuestion),
    own: bool,
) {
    card(ui).show(ui, |ui| {
        ui.set_width(ui.available_width());
        ui.horizontal(|ui| {
            verdict_ui(ui, question.given.as_ref());
            let words = text!("course-answers-question", number = number);
            ui.label(RichText::new(words).strong());
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                let how = question.given.as_ref().map(details).unwrap_or_default();
                ui.add(Label::new(RichText::new(how).weak()).truncate());
            });
        });
        if let Some(failure) = &question.failure {
            error_ui(ui, failure);
        }
        ui.push_id("ask", |ui| prose_ui(ui, markdown, &question.ask));
        ui.add_space(4.0);
        let given = question.given.as_ref();
        let right = given.is_some_and(|given| given.grade.is_some_and(|grade| grade.right));
        let first = given.and_then(|given| given.first.as_deref());
        let words = given.map(|given| &*given.words);
        let model = given.and_then(|given| given.model.as_deref());
        let shown = !own || given.is_some_and(|given| given.looked_up > 0);
        let solution = question.right.as_deref().filter(|_| !right && shown);
        for (label, words) in [
            (text!("course-answers-first"), first),
            (
                text!("course-answers-given"),
                Some(words.unwrap_or(text!("course-answers-none"))),
            ),
            (text!("course-answers-model"), model),
            (text!("course-answers-solution"), solution),
        ] {
            if let Some(words) = words {
                answer_ui(ui, markdown, label, words);
            }
        }
    });
}

/// Shows the sign for right or wrong, with its word for screen readers; nothing if there is no mark.
fn verdict_ui(ui: &mut Ui, given: Option<&MarkedAnswer>) {
    let Some(grade) = given.and_then(|given| given.grade) else {
        return;
    };
    let word = if grade.right {
        text!("course-mark-right")
    } else {
        text!("course-answers-wrong")
    };
    let response = mark_ui(ui, SIGN, grade.right);
    named(response, Role::Label, word).on_hover_text(word);
}

/// Describes how near a wrong answer is, and after how many tries and how long it was given.
fn details(given: &MarkedAnswer) -> String {
    let mut parts = Vec::new();
    if let Some(grade) = given
        .grade
        .filter(|grade| !grade.right && grade.score > 0.0)
    {
        let share = format!("{:.0}", 100.0 * grade.score);
        parts.push(text!("course-answers-close", share = share));
    }
    parts.extend(how_given(given.tries, given.looked_up, given.seconds));
    parts.join(" · ")
}

fn answer_ui(ui: &mut Ui, markdown: &mut CommonMarkCache, label: &str, words: &str) {
    ui.horizontal_top(|ui| {
        let height = ui.text_style_height(&TextStyle::Body);
        ui.allocate_ui(vec2(LABEL, height), |ui| {
            ui.set_width(LABEL);
            ui.label(RichText::new(label).weak());
        });
        ui.vertical(|ui| ui.push_id(label, |ui| prose_ui(ui, markdown, words)));
    });
}
