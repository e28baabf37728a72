//! The live class: the address for the phones, how many have answered, the answers over one another, and what the lecturer does next.
//! The window is on the wall, so names stand in it only where the lecturer wants them, and the right answer only once it is explained or
//! asked for.

mod answers;
mod charts;
mod layer;

use crate::app::course::{Course, Teaching};
use crate::app::session::action::{Action, ClassAction, Requests};
use crate::app::session::appearance::ViewName;
use crate::app::session::window::WindowState;
use crate::app::widgets::code::qr_code_ui;
use crate::app::widgets::focus::{heading, keep_in_sight, live, named};
use crate::class::{Command, Snapshot, StepContent};
use crate::lesson::{Phase, Step, without_marks};
use crate::text::text;
use answers::{Answers, answers_ui, words_ui};
use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align, Button, Frame, Label, Layout, Panel, ProgressBar, RichText, ScrollArea, Sense,
    TextureHandle, Ui, vec2,
};
use egui_commonmark::CommonMarkCache;
use layer::Layer;
use std::sync::Arc;

/// The size of what the last row has to read, in points: of the address, of the counts, and of the question.
const ADDRESS: f32 = 22.0;
const COUNT: f32 = 20.0;
/// The share of the view's width that the code has once the class is under way, and its least side in points.
const CODE: f32 = 0.3;
const LEAST_CODE: f32 = 110.0;
/// The height of the view below which the code makes way for the answers, in points.
const LOW: f32 = 400.0;

/// The state of the view.
#[derive(Default)]
pub struct ClassView {
    markdown: CommonMarkCache,
    /// The picture of a step, from 1, that clicks are shown in.
    picture: Option<(usize, TextureHandle)>,
    /// The answers of the last two rounds.
    layers: [Layer; 2],
}

/// Shows the class that is going on, or how to start one.
pub fn class_ui(
    ui: &mut Ui,
    own: &mut ClassView,
    window: &mut WindowState,
    course: &mut Course,
    requests: &mut Requests,
) {
    ui.spacing_mut().item_spacing = vec2(8.0, 6.0);
    let open = course.open.as_ref().map(|open| open.lesson.title.clone());
    let Some(class) = &mut course.class else {
        return start_ui(ui, window, open.as_deref(), requests);
    };
    let seen = class.seen();
    Panel::bottom("class-commands")
        .frame(Frame::NONE)
        .resizable(false)
        .show(ui, |ui| commands_ui(ui, class, &seen, requests));
    if class.joining {
        return joining_ui(ui, class, &seen);
    }
    let area = ScrollArea::vertical().id_salt(("class", seen.pace.step));
    area.auto_shrink(false).show(ui, |ui| {
        ui.set_max_width(ui.available_width() - 4.0);
        step_ui(ui, own, class, &seen, requests);
        ui.add_space(8.0);
        keep_in_sight(ui);
    });
}

/// Offers to teach the open lesson.
fn start_ui(ui: &mut Ui, window: &mut WindowState, open: Option<&str>, requests: &mut Requests) {
    ui.add_space(8.0);
    ui.add(Label::new(text!("wall-about")).wrap());
    ui.add_space(4.0);
    let Some(title) = open else {
        if ui.button(text!("wall-choose")).clicked() {
            window.show_view(ViewName::Course);
        }
        return;
    };
    let words = RichText::new(text!("wall-teach", title = title)).strong();
    if ui.add(Button::new(words).wrap()).clicked() {
        requests.ask(Action::Class(ClassAction::Teach));
    }
}

/// Fills the view with the address, for those who join: beside its code in a low view, else below it.
fn joining_ui(ui: &mut Ui, class: &mut Teaching, seen: &Snapshot) {
    let room = ui.available_size();
    let beside = room.x > 1.5 * room.y;
    let (side, layout, align) = if beside {
        let layout = Layout::left_to_right(Align::Min);
        (room.y.min(0.5 * room.x), layout, Align::Min)
    } else {
        // Two lines of the address and one of the count stand below.
        let layout = Layout::top_down(Align::Center);
        (room.x.min(room.y - 6.0 * ADDRESS), layout, Align::Center)
    };
    let area = ScrollArea::vertical().id_salt("joining");
    area.auto_shrink(false).show(ui, |ui| {
        ui.with_layout(layout, |ui| {
            if address_code_ui(ui, class, side.max(LEAST_CODE)) {
                class.joining = false;
            }
            ui.with_layout(Layout::top_down(align), |ui| {
                address_ui(ui, class.live.address());
                joined_ui(ui, seen);
                for note in class.live.notes() {
                    ui.add(Label::new(RichText::new(sentence(note)).weak()).wrap());
                }
            });
        });
    });
}

/// Returns a note, which is written as the terminal shows it, as a sentence.
fn sentence(note: &str) -> String {
    let mut letters = note.chars();
    let first = letters.next().into_iter().flat_map(char::to_uppercase);
    let note: String = first.chain(letters).collect();
    text!("wall-note", note = note)
}

fn address_ui(ui: &mut Ui, address: &str) {
    let words = RichText::new(address).size(ADDRESS).strong();
    ui.add(Label::new(words).wrap().selectable(true));
}

fn joined_ui(ui: &mut Ui, seen: &Snapshot) {
    let words = text!("wall-joined", count = seen.joined);
    live(&ui.label(RichText::new(words).size(COUNT)));
}

/// Shows the address as a code; returns whether it was clicked.
fn address_code_ui(ui: &mut Ui, class: &Teaching, side: f32) -> bool {
    let Some(code) = &class.code else {
        return false;
    };
    let name = text!("wall-code", address = class.live.address());
    let shown = qr_code_ui(ui, code, side).interact(Sense::click());
    named(shown, Role::Button, &name).clicked()
}

/// Shows where the class is, its question, and its answers once they are shown.
fn step_ui(
    ui: &mut Ui,
    own: &mut ClassView,
    class: &mut Teaching,
    seen: &Snapshot,
    requests: &mut Requests,
) {
    let room = Arc::clone(class.live.room());
    let Some(step) = room.lesson().steps.get(seen.pace.step.wrapping_sub(1)) else {
        return;
    };
    head_ui(ui, class, seen, step);
    if let Some(problem) = &seen.problem {
        let words = RichText::new(problem).color(ui.visuals().error_fg_color);
        ui.add(Label::new(words).wrap());
    }
    let Some(Ok(content)) = room.step(seen.pace.step) else {
        return;
    };
    if let Some(asked) = &content.asked {
        ui.push_id("ask", |ui| words_ui(ui, &mut own.markdown, &asked.ask));
        ui.add_space(4.0);
    }
    shown_ui(ui, own, class, (seen, step, &content));
    students_ui(ui, class, seen, requests);
}

/// Shows the number of the step and of those who have answered, beside the address.
fn head_ui(ui: &mut Ui, class: &mut Teaching, seen: &Snapshot, step: &Step) {
    let room = vec2(ui.available_width(), ui.clip_rect().height());
    let side = (CODE * room.min_elem()).max(LEAST_CODE);
    let full = room.y < LOW && seen.spread.is_some();
    ui.with_layout(Layout::right_to_left(Align::Min), |ui| {
        if !full && address_code_ui(ui, class, side) {
            class.joining = true;
        }
        ui.vertical(|ui| {
            let count = text!("wall-step", step = seen.pace.step, count = seen.steps);
            ui.horizontal_wrapped(|ui| {
                ui.label(RichText::new(count).weak());
                heading(ui, &without_marks(&step.title));
            });
            if seen.asks {
                count_ui(ui, seen);
            } else {
                joined_ui(ui, seen);
            }
            if seen.pace.round > 1 {
                ui.label(RichText::new(text!("wall-round", round = seen.pace.round)).weak());
            }
            if !full {
                ui.label(RichText::new(class.live.address()).weak());
            }
        });
    });
    ui.add_space(4.0);
}

/// Shows how many have answered, of how many.
fn count_ui(ui: &mut Ui, seen: &Snapshot) {
    let words = text!(
        "wall-answered",
        answered = seen.answered,
        joined = seen.joined
    );
    live(&ui.label(RichText::new(words).size(COUNT)));
    if seen.elsewhere > 0 {
        let words = text!("wall-elsewhere", count = seen.elsewhere);
        ui.label(RichText::new(words).weak());
    }
    let share = seen.answered as f32 / seen.joined.max(1) as f32;
    ui.add(ProgressBar::new(share).desired_height(8.0));
}

/// Shows the answers, and what explains them.
fn shown_ui(
    ui: &mut Ui,
    own: &mut ClassView,
    class: &mut Teaching,
    (seen, step, content): (&Snapshot, &Step, &StepContent),
) {
    let (Some(question), Some(asked)) = (&step.question, &content.asked) else {
        return;
    };
    let explained = seen.pace.phase == Phase::Explain;
    if let Some(spread) = &seen.spread {
        let right = explained || class.right;
        let mut answers = Answers {
            question,
            asked,
            spread,
            right,
            step: seen.pace.step,
            markdown: &mut own.markdown,
            picture: &mut own.picture,
            layers: &mut own.layers,
        };
        answers_ui(ui, &mut answers);
        if !explained {
            ui.checkbox(&mut class.right, text!("wall-right"));
        }
    }
    if !explained {
        return;
    }
    if let Some(solution) = asked.solution()
        && !question.kind.asks().is_drawn()
    {
        let right = question.kind.short_solution(solution);
        ui.label(RichText::new(text!("class-solution", right = right)).strong());
    }
    ui.push_id("why", |ui| words_ui(ui, &mut own.markdown, &asked.why));
}

/// Shows the lecturer's own list, closed unless it is wanted.
fn students_ui(ui: &mut Ui, class: &mut Teaching, seen: &Snapshot, requests: &mut Requests) {
    ui.add_space(6.0);
    let list = ui.collapsing(text!("wall-students"), |ui| {
        ui.checkbox(&mut class.names, text!("wall-names"));
        let mut own_pace = seen.own_pace;
        let switch = ui.checkbox(&mut own_pace, text!("wall-own-pace"));
        if switch.on_hover_text(text!("wall-own-pace.tip")).changed() {
            let command = Command::OwnPace(own_pace);
            requests.ask(Action::Class(ClassAction::Perform(command)));
        }
        let rows = class.live.room().students();
        let unnamed = rows.iter().filter(|row| row.name.is_empty()).count();
        for row in rows
            .iter()
            .filter(|row| !row.name.is_empty() && class.names)
        {
            let words = RichText::new(&row.name);
            let words = if row.answered { words.strong() } else { words };
            ui.label(if row.connected { words } else { words.weak() });
        }
        let away = rows.iter().filter(|row| !row.connected).count();
        ui.label(RichText::new(text!("wall-unnamed", count = unnamed, away = away)).weak());
    });
    named(list.header_response, Role::Button, text!("wall-students"));
}

/// Shows the buttons; what the remote's key would do is emphasised.
fn commands_ui(ui: &mut Ui, class: &mut Teaching, seen: &Snapshot, requests: &mut Requests) {
    let phase = seen.pace.phase;
    let (first, last) = (seen.pace.step <= 1, seen.pace.step >= seen.steps);
    let asks = seen.asks && phase != Phase::Closed;
    let open = asks && phase != Phase::Explain;
    let buttons = [
        ("wall-back", Command::Back, phase != Phase::Closed && !first),
        (
            "wall-show",
            Command::ShowAnswers,
            asks && phase == Phase::Ask,
        ),
        ("wall-again", Command::AskAgain, asks && phase != Phase::Ask),
        ("wall-explain", Command::Explain, open),
        ("wall-next", Command::Next, phase != Phase::Closed && !last),
    ];
    let onward = Teaching::onward(seen);
    ui.add_space(4.0);
    ui.horizontal_wrapped(|ui| {
        for (key, command, enabled) in buttons {
            let words = RichText::new(text!(key));
            let words = if command == onward {
                words.strong()
            } else {
                words
            };
            if ui.add_enabled(enabled, Button::new(words)).clicked() {
                requests.ask(Action::Class(ClassAction::Perform(command)));
            }
        }
        let joining = ui.selectable_label(class.joining, text!("wall-address"));
        if joining.clicked() {
            class.joining = !class.joining;
        }
        let end = Button::new(text!("wall-end"));
        if ui.add(end).on_hover_text(text!("wall-end.tip")).clicked() {
            requests.ask(Action::Class(ClassAction::End));
        }
    });
    ui.add_space(4.0);
}
