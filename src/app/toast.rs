//! What was last done, over the picture for a while, where there is no bottom bar to say it.

use super::layout::NARROW;
use super::state::AppState;
use eframe::egui::{Align2, Area, Context, Frame, Id, Label, Order, RichText, vec2};
use std::time::Duration;

/// How long it stands there, seconds.
const SECONDS: f64 = 4.0;
/// Above the rail at the bottom of a narrow window, points.
const LIFT: f32 = 72.0;

/// What is being told, and since when.
#[derive(Debug, Default)]
struct Told {
    text: Option<String>,
    since: f64,
}

/// Tells the state's notice, and forgets it when it has been told.
pub fn toast_ui(ctx: &Context, state: &mut AppState) {
    let width = ctx.content_rect().width();
    let alone = state.picture_alone || state.enlarged || state.embedded.is_some();
    if !alone && state.look.stages && width >= NARROW {
        return;
    }
    let now = ctx.input(|input| input.time);
    let mut told: Told = state.own.take();
    if told.text != state.notice {
        told.text.clone_from(&state.notice);
        told.since = now;
    }
    let left = told.since + SECONDS - now;
    if let Some(text) = told
        .text
        .as_ref()
        .filter(|_| left > 0.0 && state.dialog.is_none())
    {
        Area::new(Id::unique("toast"))
            .order(Order::Foreground)
            .interactable(false)
            .anchor(Align2::CENTER_BOTTOM, vec2(0.0, -LIFT))
            .show(ctx, |ui| {
                Frame::popup(ui.style()).show(ui, |ui| {
                    ui.set_max_width((width - 48.0).clamp(0.0, 420.0));
                    ui.add(Label::new(RichText::new(text).strong()).wrap());
                });
            });
        ctx.request_repaint_after(Duration::from_secs_f64(left));
    } else if left <= 0.0 {
        state.notice = None;
    }
    state.own.put(told);
}
