//! The list of lessons, by topic.

use super::data::{Course, Listed};
use crate::app::session::action::{Action, Requests, Turn};
use crate::app::widgets::card::Card;
use crate::app::widgets::focus::named;
use crate::app::widgets::mark::tick_ui;
use crate::lesson::{TOPICS, are_there, topic_name};
use crate::text::text;
use eframe::egui::accesskit::Role;
use eframe::egui::{Align, Label, Layout, RichText, ScrollArea, Sense, Stroke, Ui, vec2};
use std::time::Duration;

/// The interval at which a web page checks whether its lessons are loaded.
const LOADING: Duration = Duration::from_millis(200);

/// Shows every lesson; a click opens it.
pub fn list_ui(ui: &mut Ui, course: &mut Course, requests: &mut Requests) {
    let own = course.own.as_deref().map(Listed::of);
    let lessons = course.listed().to_vec();
    ScrollArea::vertical()
        .id_salt("lessons")
        .auto_shrink(false)
        .show(ui, |ui| {
            if let Some(handed_in) = &mut course.handed_in
                && ui.link(text!("course-answers")).clicked()
            {
                handed_in.closed = false;
            }
            if let Some(own) = &own {
                ui.label(RichText::new(text!("course-own")).strong());
                // It may have the name of one of the course's.
                if ui.push_id("own", |ui| card_ui(ui, own, course)).inner {
                    requests.ask(Action::Course(Turn::Own));
                }
                ui.add_space(8.0);
            }
            if !are_there() {
                ui.label(text!("course-loading"));
                ui.ctx().request_repaint_after(LOADING);
            }
            let mut topics: Vec<&str> = Vec::new();
            for lesson in &lessons {
                if !topics.contains(&&*lesson.topic) {
                    topics.push(&lesson.topic);
                }
            }
            topics.sort_by_key(|topic| {
                TOPICS
                    .iter()
                    .position(|known| known == topic)
                    .unwrap_or(TOPICS.len())
            });
            for topic in topics {
                ui.label(RichText::new(topic_name(topic)).strong());
                for lesson in lessons.iter().filter(|lesson| lesson.topic == topic) {
                    if card_ui(ui, lesson, course) {
                        requests.ask(Action::Course(Turn::Open(lesson.name.clone())));
                    }
                }
                ui.add_space(8.0);
            }
            if lessons.is_empty() && own.is_none() {
                ui.label(text!("course-none"));
            }
            if ui.link(text!("course-open-own")).clicked() {
                requests.ask(Action::Open);
            }
            ui.add_space(8.0);
        });
}

/// Shows a lesson's title above a sentence about it, with its minutes and how far it is done. Returns whether
/// it was clicked.
fn card_ui(ui: &mut Ui, lesson: &Listed, course: &Course) -> bool {
    let record = course.kept.record(&lesson.name);
    let answers = record.map_or(&[][..], |record| &record.answers[..]);
    let right = answers
        .iter()
        .filter(|answered| lesson.test || answered.grade.right)
        .count();
    // A lesson with questions is done once all are answered rightly, a test once all are answered.
    let done = right == lesson.questions && (right > 0 || course.kept.done.contains(&lesson.name));
    let left = course.kept.left.get(&lesson.name);
    let begun = left.is_some_and(|step| *step > 0);
    let card = Card {
        id: ui.scope_id().with(&lesson.name),
        pad: vec2(10.0, 7.0),
        sense: Sense::click(),
        line: Stroke::NONE,
    };
    let response = card.show(ui, Layout::top_down(Align::Min), |ui| {
        ui.spacing_mut().item_spacing.y = 2.0;
        ui.horizontal(|ui| {
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                let minutes = text!("course-minutes", count = lesson.minutes);
                ui.label(RichText::new(minutes).weak());
                if done {
                    tick_ui(ui, 16.0, ui.visuals().hyperlink_color);
                } else if !answers.is_empty() {
                    let count = lesson.questions;
                    let words = if lesson.test {
                        text!("course-test-count", answered = right, count = count)
                    } else {
                        text!("course-answers-right", right = right, count = count)
                    };
                    ui.label(RichText::new(words).color(ui.visuals().hyperlink_color));
                } else if begun {
                    ui.label(
                        RichText::new(text!("course-begun")).color(ui.visuals().hyperlink_color),
                    );
                }
                ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                    ui.add(Label::new(RichText::new(&lesson.title).strong()).wrap());
                });
            });
        });
        if !lesson.about.is_empty() {
            ui.add(Label::new(RichText::new(&lesson.about).weak()).wrap());
        }
    });
    let state = if done { text!("course-done") } else { "" };
    let name = format!("{} {state}", lesson.title);
    named(response, Role::Button, name.trim()).clicked()
}
