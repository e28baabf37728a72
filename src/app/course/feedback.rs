//! The feedback to an answer, and the explanation of the right one.

use super::data::{Course, Open};
use super::prose::prose_ui;
use crate::app::session::Session;
use crate::app::widgets::focus::{live, named};
use crate::app::widgets::palette::right_colour;
use crate::lesson::{Answered, Grade};
use crate::text::text;
use eframe::egui::accesskit::Role;
use eframe::egui::{Label, Rect, RichText, Ui, vec2};

/// The height below the feedback that is kept in view too, in points: the frame of the question.
const BELOW: f32 = 12.0;

/// Shows whether the answer is right, and, once they may be seen, the right answer and its explanation. New
/// feedback is scrolled into view.
pub fn feedback_ui(ui: &mut Ui, course: &mut Course, session: &mut Session) {
    let top = ui.cursor().min;
    said_ui(ui, course, session);
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

fn said_ui(ui: &mut Ui, course: &mut Course, session: &mut Session) {
    let revealed = course.revealed();
    let answered = course.answered().cloned();
    let Some(open) = &mut course.open else { return };
    let Some(answered) = answered else { return };
    if !revealed {
        if let Some(grade) = open.draft.grade {
            wrong_ui(ui, open, grade);
        }
        return;
    }
    verdict_ui(ui, &answered);
    if !answered.grade.right {
        named_ui(ui, open, answered.grade);
    }
    right_ui(ui, open, &answered, session);
    if let Some(Ok(known)) = open.known() {
        let why = known.why.clone();
        if !why.trim().is_empty() {
            ui.add_space(4.0);
            ui.push_id("why", |ui| prose_ui(ui, &mut open.markdown, &why));
        }
    }
}

fn wrong_ui(ui: &mut Ui, open: &mut Open, grade: Grade) {
    ui.add_space(4.0);
    let words = if grade.score > 0.0 {
        let share = format!("{:.0}", 100.0 * grade.score);
        text!("course-nearly", share = share)
    } else {
        text!("course-wrong").to_owned()
    };
    let words = RichText::new(words).color(ui.visuals().warn_fg_color);
    live(&ui.add(Label::new(words).wrap()));
    named_ui(ui, open, grade);
    ui.add(Label::new(RichText::new(text!("course-try-again")).weak()).wrap());
}

/// Shows which wrong model the answer agrees with, or where it is off.
fn named_ui(ui: &mut Ui, open: &mut Open, grade: Grade) {
    let words = match (open.question(), open.known()) {
        (Some(question), Some(Ok(known))) => question.feedback(&grade, &known.says, &known.names),
        _ => None,
    };
    if let Some(words) = words {
        let said = ui.push_id("named", |ui| prose_ui(ui, &mut open.markdown, &words));
        live(&said.inner);
    }
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
    live(&named(label, Role::Label, &words));
}

/// Shows the right answer in words and numbers, beside the student's.
fn right_ui(ui: &mut Ui, open: &Open, answered: &Answered, session: &mut Session) {
    if let (Some(question), Some(right)) = (open.question(), open.solution())
        && let Some(widget) = &open.draft.widget
    {
        widget.right_ui(ui, question, right, &answered.answer, session);
    }
}
