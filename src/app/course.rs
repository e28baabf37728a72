//! The course: lessons beside the picture, step by step, with questions that are answered before the answer is shown.

mod data;
mod edges;
mod feedback;
mod glide;
mod handed_in;
mod kinds;
mod list;
mod mark;
mod marking;
mod parts;
mod prose;
mod question;
mod results;
mod step;
mod target;
#[cfg(feature = "class")]
mod teaching;
mod work;

pub use data::{Course, Held, SavedProgress};
pub use edges::{paint as paint_edges, watch as watch_edges};
pub use glide::Glide;
use handed_in::handed_in_ui;
#[cfg(target_arch = "wasm32")]
pub use kinds::{Likeness, Target};
pub use mark::paint;
#[cfg(target_arch = "wasm32")]
pub use marking::Marking;
pub use prose::prose_ui;
pub use step::{back_ui, head_ui};
pub use target::as_target;
#[cfg(feature = "class")]
pub use teaching::Teaching;
#[cfg(target_arch = "wasm32")]
pub use work::Prepare;

use crate::app::session::Session;
use crate::app::session::action::Requests;
use crate::app::session::appearance::ViewName;
use crate::app::session::window::WindowState;
use crate::text::text;
use eframe::egui::{Ui, vec2};

/// Shows the list of lessons, or the current step of the open lesson.
pub fn course_ui(
    ui: &mut Ui,
    session: &mut Session,
    window: &mut WindowState,
    course: &mut Course,
    requests: &mut Requests,
) {
    ui.spacing_mut().item_spacing = vec2(8.0, 6.0);
    if course.shown_hand_in().is_some() {
        handed_in_ui(ui, course, session);
    } else if course.open.is_some() {
        step::step_ui(ui, course, session, window, requests);
    } else {
        list::list_ui(ui, course, requests);
    }
}

/// Says, in place of a view, that numbers are hidden.
pub fn hidden_ui(ui: &mut Ui, window: &mut WindowState) {
    ui.add_space(12.0);
    ui.label(text!("course-hidden"));
    if ui.button(text!("course-to-question")).clicked() {
        window.show_view(ViewName::Course);
    }
}
