//! What was last done, and what is wrong, in a line: in the bottom bar, or over the picture where there is none.

use crate::app::session::Session;
use crate::app::session::window::WindowState;
use crate::app::widgets::sign::{Sign, sign_button};
use crate::text::text;
use eframe::egui::{Context, Label, RichText, TextWrapMode, Ui};
use std::time::Duration;

/// How long what was done is said, seconds.
const SECONDS: f64 = 4.0;

/// The notice that is said, and since when.
#[derive(Debug, Default)]
struct ShownNotice {
    text: Option<String>,
    since: f64,
}

/// Takes the notice away when it has been said long enough; asks for that one frame and for none after it.
pub fn expire(ctx: &Context, session: &mut Session, window: &mut WindowState) {
    let now = ctx.input(|input| input.time);
    let mut shown: ShownNotice = window.own.take();
    if shown.text != session.notice {
        shown.text.clone_from(&session.notice);
        shown.since = now;
    }
    if shown.text.is_some() {
        let left = shown.since + SECONDS - now;
        if left > 0.0 {
            ctx.request_repaint_after(Duration::from_secs_f64(left));
        } else {
            (session.notice, shown.text) = (None, None);
            ctx.request_repaint();
        }
    }
    window.own.put(shown);
}

/// What there is to say, on lines that wrap or on one; what is wrong can be dismissed.
pub fn said_ui(ui: &mut Ui, session: &mut Session, wrap: TextWrapMode) {
    if let Some(notice) = &session.notice {
        ui.add(Label::new(notice).wrap_mode(wrap));
    } else if let Some(warning) = &session.warning {
        let words = RichText::new(warning).color(ui.visuals().warn_fg_color);
        let dismissed = sign_button(ui, Sign::Close, text!("dismiss"));
        ui.add(Label::new(words).wrap_mode(wrap));
        if dismissed {
            session.warning = None;
        }
    }
}
