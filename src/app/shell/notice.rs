//! The latest notice or warning in a line: in the bottom bar, or over the picture if there is no bar.

use crate::app::session::Session;
use crate::app::session::action::{Action, Requests};
use crate::app::widgets::focus::live;
use crate::app::widgets::sign::{Sign, sign_button};
use crate::text::text;
use eframe::egui::{Context, Label, RichText, TextWrapMode, Ui};
use std::time::Duration;

/// The duration of a notice, in seconds.
const SECONDS: f64 = 4.0;

/// Removes an expired notice; requests a repaint for the frame in which it expires, and none after it. One that is given
/// again starts again.
pub fn expire(ctx: &Context, session: &mut Session) {
    let Some(notice) = &mut session.notice else {
        return;
    };
    let now = ctx.input(|input| input.time);
    let left = *notice.since.get_or_insert(now) + SECONDS - now;
    if left > 0.0 {
        ctx.request_repaint_after(Duration::from_secs_f64(left));
    } else {
        session.notice = None;
        ctx.request_repaint();
    }
}

/// Shows the notice or the warning, wrapped or on one line. A notice may offer an action; a warning can be dismissed.
pub fn said_ui(ui: &mut Ui, session: &mut Session, requests: &mut Requests, wrap: TextWrapMode) {
    if let Some(notice) = &session.notice {
        let name = match notice.offer {
            Some(Action::ShowFolder(_)) => text!("notice-folder"),
            _ => text!("controls-command-undo"),
        };
        let offer = notice.offer.clone().filter(|_| ui.button(name).clicked());
        live(&ui.add(Label::new(&notice.text).wrap_mode(wrap)));
        if let Some(action) = offer {
            requests.ask(action);
            session.notice = None;
        }
    } else if let Some(warning) = &session.warning {
        let words = RichText::new(warning).color(ui.visuals().warn_fg_color);
        let dismissed = sign_button(ui, Sign::Close, text!("dismiss"));
        live(&ui.add(Label::new(words).wrap_mode(wrap)));
        if dismissed {
            session.warning = None;
        }
    }
}
