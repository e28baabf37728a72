//! The welcome below the picture at the first start: a description of the program, and ways to begin.

use crate::app::session::action::{Action, Requests, Turn};
use crate::app::session::window::WindowState;
use crate::app::widgets::focus::heading;
use crate::text::text;
use eframe::egui::{Button, Panel, RichText, Ui};

/// Shows a card below the picture, which is fitted into what is left, until one of its buttons is clicked or a panel
/// is opened. In a `low` window the buttons stand alone.
pub fn welcome_ui(ui: &mut Ui, window: &mut WindowState, requests: &mut Requests, low: bool) {
    if !window.welcome {
        return;
    }
    Panel::bottom("welcome").show(ui, |ui| {
        ui.add_space(6.0);
        card_ui(ui, window, requests, low);
        ui.add_space(6.0);
    });
}

fn card_ui(ui: &mut Ui, window: &mut WindowState, requests: &mut Requests, low: bool) {
    if !low {
        heading(ui, text!("welcome"));
        ui.add_space(2.0);
        ui.label(text!("welcome.sentence"));
        ui.add_space(8.0);
    }
    ui.horizontal_wrapped(|ui| {
        let main = Button::new(RichText::new(text!("course-start")).strong());
        let ways = [
            (main, Some(Action::Course(Turn::Start))),
            (Button::new(text!("welcome-explore")), None),
            (Button::new(text!("welcome-open")), Some(Action::Open)),
        ];
        for (button, action) in ways {
            if ui.add(button).clicked() {
                window.end_welcome();
                requests.extend(action);
            }
        }
    });
}
