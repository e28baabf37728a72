//! The window as a figure in another page: the picture, and below it the controls that the link names.

use crate::app::controls::named::{Named, rows_ui};
use crate::app::course::Course;
use crate::app::engine::Engine;
use crate::app::picture::{self, Room};
use crate::app::session::Session;
use crate::app::session::action::{Action, Requests};
use crate::app::session::window::{Figure, WindowState};
use crate::app::widgets::focus::keep_in_sight;
use crate::scene::Choice as _;
use crate::text::text;
use eframe::egui::{CentralPanel, Frame, Panel, ScrollArea, Ui};

/// The minimum fraction of the height that the picture keeps.
const PICTURE: f32 = 0.45;
/// Maximum number of controls whose sliders have the whole width.
const FEW: usize = 3;

/// Shows the picture and the controls below it, or why the link could not be opened. Returns the size available to the
/// picture, if there is one.
pub fn embedded_ui(
    ui: &mut Ui,
    session: &mut Session,
    window: &mut WindowState,
    course: &mut Course,
    requests: &mut Requests,
    engine: &mut Engine,
) -> Option<Room> {
    let Figure {
        controls: words,
        problem,
    } = window.embedded.clone().unwrap_or_default();
    if let Some(problem) = problem {
        CentralPanel::default().show(ui, |ui| {
            ui.strong(text!("link-not-opened"));
            ui.label(problem);
        });
        return None;
    }
    let controls: Vec<Named> = words.iter().filter_map(|word| Named::find(word)).collect();
    let footer = ui.spacing().interact_size.y + 16.0;
    let most = (1.0 - PICTURE) * ui.available_height() - footer;
    Panel::bottom("embedded").show(ui, |ui| {
        ui.add_space(4.0);
        if !controls.is_empty() {
            ScrollArea::vertical()
                .max_height(most)
                .min_scrolled_height(0.0)
                .auto_shrink([false, true])
                .show(ui, |ui| {
                    rows_ui(ui, session, &controls, controls.len() <= FEW);
                    keep_in_sight(ui);
                });
        }
        for word in words.iter().filter(|word| Named::find(word).is_none()) {
            let words = text!("embed-unknown", name = word.as_str());
            ui.colored_label(ui.visuals().error_fg_color, words);
        }
        ui.horizontal(|ui| {
            ui.weak(session.shown.scene.shading.mode.label());
            let link = ui.link(text!("embed-open"));
            if link.on_hover_text(text!("embed-open.tip")).clicked() {
                requests.ask(Action::OpenPage);
            }
        });
        ui.add_space(2.0);
    });
    session.commit();
    let shown = CentralPanel::default().frame(Frame::NONE).show(ui, |ui| {
        picture::picture_ui(ui, session, window, course, requests, engine)
    });
    Some(shown.inner)
}
