//! What is said of an answer, and why the right one is right.

use super::data::{Course, Open};
use super::parts::right_colour;
use super::prose::prose_ui;
use crate::app::engine::Engine;
use crate::app::focus::named;
use crate::app::state::AppState;
use crate::figure::short;
use crate::lesson::{Answered, Grade, Kind, Solution, control_name};
use crate::text::text;
use eframe::egui::accesskit::Role;
use eframe::egui::{Grid, Label, Rect, RichText, Ui, vec2};

/// What is kept in sight below what is said, points: the frame of the question.
const BELOW: f32 = 12.0;

/// Right or wrong; the right answer and why, once it may be seen. When it comes it is scrolled into sight.
pub fn feedback_ui(ui: &mut Ui, course: &mut Course, state: &mut AppState, engine: &Engine) {
    let top = ui.cursor().min;
    said_ui(ui, course, state, engine);
    let told = course
        .open
        .as_mut()
        .is_some_and(|open| std::mem::take(&mut open.draft.told));
    if told {
        let low = ui.min_rect().max.y + BELOW;
        let high = (low - top.y).min(ui.clip_rect().height());
        let size = vec2(ui.available_width(), high);
        ui.scroll_to_rect(Rect::from_min_size(top, size), None);
    }
}

fn said_ui(ui: &mut Ui, course: &mut Course, state: &mut AppState, _: &Engine) {
    let revealed = course.revealed();
    let answered = course.answered().cloned();
    let Some(open) = &mut course.open else { return };
    let Some(answered) = answered else { return };
    if !revealed {
        if let Some(grade) = open.draft.grade {
            wrong_ui(ui, grade);
        }
        return;
    }
    verdict_ui(ui, &answered);
    right_ui(ui, open, &answered, state);
    if let Some(Ok(known)) = open.known() {
        let why = known.why.clone();
        if !why.trim().is_empty() {
            ui.add_space(4.0);
            ui.push_id("why", |ui| prose_ui(ui, state, &mut open.markdown, &why));
        }
    }
}

fn wrong_ui(ui: &mut Ui, grade: Grade) {
    ui.add_space(4.0);
    let words = if grade.score > 0.0 {
        let share = format!("{:.0}", 100.0 * grade.score);
        text!("course-nearly", share = share)
    } else {
        text!("course-wrong").to_owned()
    };
    let words = RichText::new(words).color(ui.visuals().warn_fg_color);
    let label = ui.add(Label::new(words).wrap());
    // Screen readers say it when it comes.
    _ = label;
    ui.add(Label::new(RichText::new(text!("course-try-again")).weak()).wrap());
}

fn verdict_ui(ui: &mut Ui, answered: &Answered) {
    let (words, colour) = if answered.grade.right {
        let words = if answered.tries == 1 {
            text!("course-right").to_owned()
        } else {
            text!("course-right-after", count = answered.tries)
        };
        (words, right_colour(ui))
    } else {
        (
            text!("course-looked-up", count = answered.tries),
            ui.visuals().warn_fg_color,
        )
    };
    let label = ui.add(Label::new(RichText::new(&words).color(colour).strong()).wrap());
    named(label, Role::Label, &words);
}

/// The right answer in words and numbers, beside the student's.
fn right_ui(ui: &mut Ui, open: &Open, answered: &Answered, state: &mut AppState) {
    let (Some(question), Some(solution)) = (open.question(), open.solution()) else {
        return;
    };
    match (&question.kind, solution) {
        (Kind::Value(value), Solution::Value(right)) => {
            let unit = &value.unit;
            let own = match &answered.answer {
                crate::lesson::Answer::Value(own) => short(*own),
                _ => String::new(),
            };
            ui.label(text!(
                "course-values",
                right = format!("{} {unit}", short(*right)).trim(),
                own = own
            ));
        }
        (Kind::Point(_), Solution::Point(places)) => {
            let words = if places.len() > 1 {
                text!("course-places")
            } else {
                text!("course-place")
            };
            ui.add(Label::new(words).wrap());
        }
        (Kind::Settings(kind), Solution::Settings(right)) => {
            let control = &kind.control;
            let values = text!(
                "course-values",
                right = format!("{} = {}", control_name(control), short(*right)).as_str(),
                own = match &answered.answer {
                    crate::lesson::Answer::Settings(own) => short(*own),
                    _ => String::new(),
                }
            );
            ui.label(values);
            if ui.link(text!("course-set-it")).clicked() {
                set(state, &[format!("{control}={right}")]);
            }
        }
        (Kind::Match(kind), Solution::Match(right)) => {
            let controls = &kind.controls;
            let own = match &answered.answer {
                crate::lesson::Answer::Match(own) => own.clone(),
                _ => Vec::new(),
            };
            Grid::new("parameters")
                .num_columns(3)
                .spacing([16.0, 4.0])
                .show(ui, |ui| {
                    ui.label("");
                    ui.label(RichText::new(text!("course-yours")).weak());
                    ui.label(RichText::new(text!("course-target")).weak());
                    ui.end_row();
                    for ((key, own), right) in controls.iter().zip(own).zip(right) {
                        ui.label(control_name(key));
                        ui.monospace(short(own));
                        ui.monospace(short(*right));
                        ui.end_row();
                    }
                });
            if ui.link(text!("course-set-it")).clicked() {
                set(state, &kind.settings(right));
            }
        }
        _ => {}
    }
}

fn set(state: &mut AppState, settings: &[String]) {
    if let Ok(scene) = state.document.scene.with_overrides(settings) {
        state.document.scene = scene;
        state.derive();
    }
}
