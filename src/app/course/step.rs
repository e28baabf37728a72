//! A step: its text, its controls and its question, with the buttons to the previous and next step below.

use super::data::{Course, Open};
use super::parts::{error_ui, waiting_ui};
use super::prose::prose_ui;
use super::question::question_ui;
use super::results::{self, results_ui};
use super::work::{Prepare, Prepared};
use crate::app::controls::named::{Named, rows_ui};
use crate::app::session::Session;
use crate::app::session::action::{Action, Requests, Turn};
use crate::app::session::appearance::ViewName;
use crate::app::session::window::WindowState;
use crate::app::widgets::background::wake;
use crate::app::widgets::focus::{aside, heading, keep_in_sight, named, switch_named};
use crate::app::widgets::strip::strip;
use crate::text::text;
use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align, Button, Frame, Label, Layout, Panel, RichText, ScrollArea, Sense, Stroke, Ui, pos2,
};

/// The radius of the dots that represent the steps, in points.
const DOT: f32 = 3.5;

/// Shows the current step.
pub fn step_ui(
    ui: &mut Ui,
    course: &mut Course,
    session: &mut Session,
    window: &mut WindowState,
    requests: &mut Requests,
) {
    prepare(ui, course);
    Panel::bottom("course-steps")
        .frame(Frame::NONE)
        .resizable(false)
        .show(ui, |ui| ways_ui(ui, course, requests));
    let Some(open) = &mut course.open else { return };
    if open.results.is_some() {
        return results_ui(ui, course, requests);
    }
    let fresh = std::mem::take(&mut open.draft.fresh);
    let mut area = ScrollArea::vertical()
        .id_salt(("step", open.opening, open.step))
        .auto_shrink(false);
    if fresh {
        area = area.vertical_scroll_offset(0.0);
    }
    area.show(ui, |ui| {
        // Keeps clear of the scroll bar.
        ui.set_max_width(ui.available_width() - 4.0);
        body_ui(ui, course, session, window, requests);
        ui.add_space(8.0);
        keep_in_sight(ui);
    });
}

/// Shows a button that scrolls to a question hidden below the visible text; without it the question might be overlooked.
fn down_ui(ui: &mut Ui, open: &mut Open) {
    let button = ui.add(Button::new(format!("▼ {}", text!("course-question"))).truncate());
    let button = named(button, Role::Button, text!("course-to-question"));
    aside(&button);
    if button.clicked() {
        open.draft.seek = true;
        ui.ctx().request_repaint();
    }
}

/// Starts to fill in the numbers and to find the answer in the background, and takes the results.
fn prepare(ui: &Ui, course: &mut Course) {
    let seed = course.seed;
    let Some(open) = &mut course.open else { return };
    if !matches!(open.known(), None | Some(Ok(Prepared { key: None, .. }))) {
        return;
    }
    let (opening, step) = (open.opening, open.step);
    let same = |work: &Prepare| (work.opening, work.step) == (opening, step);
    open.work.keep_only(same);
    open.work.ask(wake(ui.ctx()), same, || Prepare {
        opening,
        step,
        seed,
        source: open.lesson.source.clone(),
        folder: open.lesson.folder.clone(),
    });
    let mut known = open.work.known().cloned();
    if open.work.progress().is_none()
        && let Some(Ok(Prepared { key, .. })) = &mut known
        && key.is_none()
    {
        let none = if open.question().is_some() {
            text!("render-job-ended")
        } else {
            ""
        };
        *key = Some(Err(none.to_owned()));
    }
    if let Some(known) = known {
        open.prepared.insert(step, known);
    }
}

/// Shows the button back to the list, and the title of the lesson or of the answers handed in.
pub fn head_ui(ui: &mut Ui, course: &Course, requests: &mut Requests) {
    let Some(heading) = course.heading() else {
        return;
    };
    let title = RichText::new(heading).weak();
    let back = ui.button(format!("‹ {}", text!("course-lessons")));
    ui.add(Label::new(title).wrap());
    if named(back, Role::Button, text!("course-lessons")).clicked() {
        requests.ask(Action::Course(Turn::List));
    }
}

/// Shows the button back, the button to the next step, and between them the steps as dots, or the way to a question that is out of
/// sight.
fn ways_ui(ui: &mut Ui, course: &mut Course, requests: &mut Requests) {
    let Some(open) = &mut course.open else { return };
    let onward = std::mem::take(&mut open.draft.onward);
    let count = open.lesson.steps.len();
    let ended = open.results.is_some();
    // The page of the results follows the last step.
    let step = if ended { count } else { open.step };
    let asks = open.lesson.steps.iter().any(|step| step.question.is_some());
    let results = results::title(&open.lesson);
    let high = ui.spacing().interact_size.y;
    let below = |top| top + high >= ui.max_rect().min.y;
    let hidden = !ended && open.draft.top.is_some_and(below);
    ui.add_space(4.0);
    ui.horizontal(|ui| {
        let back = ui.add_enabled(step > 0, Button::new(text!("course-back")));
        if back.on_hover_text(text!("course-back.tip")).clicked() {
            requests.ask(Action::Course(Turn::Step(-1)));
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let next = if step + 1 < count {
                text!("course-next")
            } else if asks && !ended {
                results
            } else {
                text!("course-finish")
            };
            let button = Button::new(RichText::new(next).strong());
            let button = ui.add(button).on_hover_text(text!("course-next.tip"));
            if onward {
                button.request_focus();
            }
            if button.clicked() {
                requests.ask(Action::Course(Turn::Step(1)));
            }
            ui.centered_and_justified(|ui| match &mut course.open {
                Some(open) if hidden => down_ui(ui, open),
                _ => dots_ui(ui, course, requests, step, count),
            });
        });
    });
    ui.add_space(2.0);
}

/// Shows a dot for each step, filled for the current step and for those answered rightly, in a test for those answered; in a
/// narrow panel, the step's number instead.
fn dots_ui(ui: &mut Ui, course: &Course, requests: &mut Requests, step: usize, count: usize) {
    let room = ui.available_width();
    let each = (room / count as f32).min(16.0);
    let Some(open) = &course.open else { return };
    let words = if step < count {
        text!("course-step", number = step + 1, count = count)
    } else {
        results::title(&open.lesson).to_owned()
    };
    if each < 9.0 {
        ui.label(words);
        return;
    }
    let (rect, response) = strip(ui, ui.spacing().interact_size.y, Sense::click());
    // For pointers only: Page up and Page down do the same.
    aside(&response);
    let response = switch_named(response, Role::Label, false, &words).on_hover_text(&words);
    let left = rect.center().x - 0.5 * each * count as f32;
    let record = course.kept.record(&open.lesson.name);
    for index in 0..count {
        let at = pos2(left + each * (index as f32 + 0.5), rect.center().y);
        let visuals = ui.visuals();
        let colour = if index == step {
            visuals.strong_text_color()
        } else {
            visuals.weak_text_color()
        };
        let right = record
            .and_then(|record| record.answer(index))
            .is_some_and(|answered| answered.grade.right || open.lesson.test);
        let radius = if index == step { DOT + 1.5 } else { DOT };
        if right || index == step {
            ui.painter().circle_filled(at, radius, colour);
        } else {
            let stroke = Stroke::new(1.2, colour);
            ui.painter().circle_stroke(at, radius, stroke);
        }
    }
    if let Some(at) = response
        .interact_pointer_pos()
        .filter(|_| response.clicked())
    {
        let index = ((at.x - left) / each).floor();
        if index >= 0.0 && (index as usize) < count {
            requests.ask(Action::Course(Turn::To(index as usize)));
        }
    }
}

fn body_ui(
    ui: &mut Ui,
    course: &mut Course,
    session: &mut Session,
    window: &mut WindowState,
    requests: &mut Requests,
) {
    let Some(open) = &mut course.open else { return };
    heading(ui, &open.current().title);
    ui.add_space(2.0);
    if let Some(why) = &open.failed {
        error_ui(ui, why);
    }
    match open.known() {
        Some(Ok(known)) => {
            let words = known.text.clone();
            ui.push_id("text", |ui| prose_ui(ui, &mut open.markdown, &words));
        }
        Some(Err(why)) => error_ui(ui, why),
        None => waiting_ui(ui, text!("course-preparing")),
    }
    ui.add_space(6.0);
    if open.is_left() {
        // The controls and the question are about another scene than the one displayed.
        open.draft.top = None;
        ui.add(Label::new(RichText::new(text!("course-left")).weak()).wrap());
        back_ui(ui, requests);
        return;
    }
    controls_ui(ui, open, session);
    if let Some(view) = open.staged.as_ref().and_then(|staged| staged.shown.view)
        && let Some(key) = ViewName::named(view)
    {
        // The message is named after the view.
        let title = text!(&format!("view-{view}"));
        if ui.link(text!("course-numbers", view = title)).clicked() {
            window.show_view(key);
        }
    }
    if open.question().is_some() {
        ui.add_space(4.0);
        question_ui(ui, course, session, window, requests);
        after_ui(ui, course);
    }
    again_ui(ui, course, session, requests);
}

/// Shows the text that follows the question, once that is answered.
fn after_ui(ui: &mut Ui, course: &mut Course) {
    let revealed = course.revealed();
    let Some(open) = course.open.as_mut().filter(|_| revealed) else {
        return;
    };
    let Some(Ok(known)) = open.known() else {
        return;
    };
    let words = known.after.clone();
    if !words.trim().is_empty() {
        ui.add_space(6.0);
        ui.push_id("after", |ui| prose_ui(ui, &mut open.markdown, &words));
    }
}

/// Shows the controls that the step names, and those of its question.
fn controls_ui(ui: &mut Ui, open: &Open, session: &mut Session) {
    let mut words: Vec<&str> = open
        .current()
        .stage
        .controls
        .iter()
        .map(|word| &**word)
        .collect();
    let own = open.current().asks().map(|asks| asks.controls());
    for key in own.unwrap_or_default() {
        let named = Named::find(key);
        if !words.iter().any(|word| Named::find(word) == named) {
            words.push(key);
        }
    }
    let controls: Vec<Named> = words.into_iter().filter_map(Named::find).collect();
    if controls.is_empty() {
        return;
    }
    ui.push_id("controls", |ui| rows_ui(ui, session, &controls, false));
    session.commit();
    ui.add_space(4.0);
}

/// Shows the button back to the lesson from another scene that was opened since.
pub fn back_ui(ui: &mut Ui, requests: &mut Requests) {
    let back = ui.button(format!("‹ {}", text!("course-return")));
    let back = named(back, Role::Button, text!("course-return"));
    if back.on_hover_text(text!("course-return.tip")).clicked() {
        requests.ask(Action::Course(Turn::Again));
    }
}

/// Shows the link that restores the step's scene, if it was changed.
fn again_ui(ui: &mut Ui, course: &Course, session: &Session, requests: &mut Requests) {
    let Some(open) = &course.open else { return };
    let Some(staged) = &open.staged else { return };
    if session.document().scene == staged.scene {
        return;
    }
    ui.add_space(6.0);
    let back = ui.link(text!("course-again"));
    if back.on_hover_text(text!("course-again.tip")).clicked() {
        requests.ask(Action::Course(Turn::Again));
    }
}
