//! A question, which is answered before the right answer can be seen.

use super::data::Course;
use super::feedback::feedback_ui;
use super::kinds::WidgetContext;
use super::parts::{card, error_ui, waiting_ui};
use super::prose::prose_ui;
use super::work::Prepared;
use crate::app::session::Session;
use crate::app::session::action::{Action, Requests};
use crate::app::session::window::WindowState;
use crate::app::widgets::focus::live;
use crate::app::widgets::symbol::{self, Symbol};
use crate::lesson::Term;
use crate::text::text;
use eframe::egui::{Align, Button, Id, Label, RichText, Ui, UiBuilder};

/// Shows the step's question with its current answer, and the right one once it may be seen.
pub fn question_ui(
    ui: &mut Ui,
    course: &mut Course,
    session: &mut Session,
    window: &mut WindowState,
    requests: &mut Requests,
) {
    let shown = card(ui).show(ui, |ui| {
        ui.set_width(ui.available_width());
        contents_ui(ui, course, session, window, requests);
    });
    if let Some(open) = &mut course.open {
        let rect = shown.response.rect;
        open.draft.top = Some(rect.min.y);
        if std::mem::take(&mut open.draft.seek) {
            ui.scroll_to_rect(rect, Some(Align::Min));
        }
    }
    if course.revealed()
        && let Some(open) = &course.open
        && let Some(term) = open.question().and_then(|question| question.term)
    {
        symbol::light_up_otherwise(ui.ctx(), symbol_of(term));
    }
}

/// Returns the symbol of the equation whose pointing highlights a term.
fn symbol_of(term: Term) -> Symbol {
    match term {
        Term::Ambient => Symbol::Ka,
        Term::Diffuse => Symbol::Kd,
        Term::Specular => Symbol::Ks,
        Term::Attenuation => Symbol::Attenuation,
        Term::Transmission => Symbol::Kt,
        Term::Lights => Symbol::Lights,
    }
}

/// Shows the question, the widget of its answer, and the feedback.
fn contents_ui(
    ui: &mut Ui,
    course: &mut Course,
    session: &mut Session,
    window: &mut WindowState,
    requests: &mut Requests,
) {
    let revealed = course.revealed();
    let model = course.answered().and_then(|answered| answered.grade.model);
    let now = ui.input(|input| input.time);
    let Some(open) = &mut course.open else { return };
    open.draft.seen.get_or_insert(now);
    ui.label(RichText::new(text!("course-question")).weak());
    let known = match open.prepared.get(&open.step) {
        Some(Ok(known)) => known,
        Some(Err(_)) => return,
        None => return waiting_ui(ui, text!("course-preparing")),
    };
    ui.push_id("ask", |ui| prose_ui(ui, &mut open.markdown, &known.ask));
    ui.add_space(4.0);
    let question = open.lesson.steps[open.step].question.as_ref();
    let (Some(question), Some(widget)) = (question, &mut open.draft.widget) else {
        return;
    };
    let mut asked = WidgetContext {
        question,
        names: &known.names,
        solution: known.right(),
        wrong: known.wrong(model.filter(|_| revealed)),
        revealed,
        test: open.lesson.test,
        staged: open.staged.as_deref(),
        step: (open.opening, open.step),
        markdown: &mut open.markdown,
        scene: &session.document().scene,
        window,
        changed: false,
    };
    let entered = widget.ui(ui, &mut asked);
    if asked.changed {
        (open.draft.grade, open.draft.touched) = (None, true);
    }
    ui.add_space(6.0);
    if open.lesson.test {
        course.keep(&session.document().scene, now);
        return kept_ui(ui, course);
    }
    if !revealed {
        check_ui(ui, course, session, requests, entered);
    }
    feedback_ui(ui, course, session);
}

/// Shows whether a test has the answer.
fn kept_ui(ui: &mut Ui, course: &Course) {
    let words = match course.answered() {
        Some(_) => text!("course-kept"),
        None => text!("course-not-kept"),
    };
    live(&ui.add(Label::new(RichText::new(words).weak()).wrap()));
}

/// Shows the buttons that grade the answer and show the right one.
fn check_ui(
    ui: &mut Ui,
    course: &mut Course,
    session: &Session,
    requests: &mut Requests,
    entered: bool,
) {
    let Some(open) = &course.open else { return };
    if let Some(Ok(Prepared {
        key: Some(Err(why)),
        ..
    })) = open.known()
    {
        return error_ui(ui, why);
    }
    let answer = open.answer(&session.document().scene);
    let ready = answer.is_some() && open.solution().is_some() && open.staged.is_some();
    let given = course.answered();
    // The last grade belongs to another answer.
    let stale = answer.is_some() && given.map(|given| &given.answer) != answer.as_ref();
    let given = given.is_some();
    let mut check = false;
    let mut show = false;
    let mut typed = entered;
    // The buttons stay the same ones between press and release, whatever appears above them.
    let own = UiBuilder::new().scope_id(Id::unique("course-check"));
    ui.scope_builder(own, |ui| {
        ui.horizontal_wrapped(|ui| {
            let button = Button::new(RichText::new(text!("course-check")).strong());
            let button = ui.add_enabled(ready, button);
            check = button.clicked() || (entered && ready);
            typed |= button.has_focus();
            if given {
                let button = ui.button(text!("course-show-answer"));
                typed |= button.has_focus();
                show = button
                    .on_hover_text(text!("course-show-answer.tip"))
                    .clicked();
            }
        });
    });
    if answer.is_some() && open.solution().is_none() {
        waiting_ui(ui, text!("course-solving"));
    }
    if check
        && let Some(answer) = answer
        && let Some(grade) = open.grade(&answer)
    {
        let now = ui.input(|input| input.time);
        course.put(answer, grade, now);
        ui.ctx().request_repaint();
    }
    if stale
        && !check
        && let Some(open) = &mut course.open
    {
        open.draft.grade = None;
    }
    if show {
        course.look_up();
        ui.ctx().request_repaint();
    }
    if course.revealed() {
        if let Some(open) = &mut course.open {
            open.draft.onward = typed;
        }
        requests.ask(Action::ShowAnswer);
    }
}
