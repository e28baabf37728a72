//! The welcome over the picture at the first start: a description of the program, and ways to begin.

use crate::app::session::action::Requests;
use crate::app::session::action::{Action, Turn};
use crate::app::session::window::WindowState;
use crate::text::text;
use eframe::egui::{Align2, Area, Button, Context, Frame, Id, Order, Rect, RichText, Ui, vec2};

/// The picture height below which no text covers it, in points.
const LOW: f32 = 320.0;

/// Shows a card at the bottom of the picture until one of its buttons is clicked.
pub fn welcome_ui(ctx: &Context, window: &mut WindowState, requests: &mut Requests, picture: Rect) {
    if !window.welcome {
        return;
    }
    let width = (picture.width() - 32.0).min(520.0);
    Area::new(Id::unique("welcome"))
        .order(Order::Middle)
        .pivot(Align2::CENTER_BOTTOM)
        .fixed_pos(picture.center_bottom() - vec2(0.0, 16.0))
        .show(ctx, |ui| {
            Frame::window(ui.style()).show(ui, |ui| {
                ui.set_width((width - 32.0).max(0.0));
                card_ui(ui, window, requests, picture.height() < LOW);
            });
        });
}

fn card_ui(ui: &mut Ui, window: &mut WindowState, requests: &mut Requests, low: bool) {
    if !low {
        ui.heading(text!("welcome"));
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
                window.welcome = false;
                window.appearance.welcomed = true;
                requests.extend(action);
            }
        }
    });
}
