//! The latest notice or warning, if there is no bottom bar to show it.

use super::layout::NARROW;
use super::notice::{expire, said_ui};
use crate::app::shell::state::AppState;
use eframe::egui::{Align2, Area, Context, Frame, Id, Order, Rect, TextWrapMode, pos2};

/// The minimum height above the picture in which the notice fits, and its distance from the window's edge, in points.
const ABOVE: f32 = 48.0;
const EDGE: f32 = 24.0;

/// Shows the notice or warning if there is no bottom bar for it and no dialog: above the `picture`, over its title, or at
/// the bottom of the window if the picture fills it.
pub fn toast_ui(ctx: &Context, state: &mut AppState, picture: Option<Rect>) {
    let AppState {
        session,
        window,
        dialog,
        requests,
        ..
    } = state;
    expire(ctx, session);
    let screen = ctx.content_rect();
    let alone = window.picture_alone || window.enlarged || window.embedded.is_some();
    let barred = !alone && window.appearance.stages && screen.width() >= NARROW;
    if barred || dialog.is_some() || session.said().is_none() {
        return;
    }
    let above = picture.filter(|picture| !alone && picture.top() >= ABOVE);
    let bottom = above.map_or(screen.bottom() - EDGE, |picture| picture.top());
    let offers = session
        .notice
        .as_ref()
        .is_none_or(|notice| notice.offer.is_some());
    Area::new(Id::unique("toast"))
        .order(Order::Foreground)
        .interactable(offers)
        .pivot(Align2::CENTER_BOTTOM)
        .fixed_pos(pos2(above.unwrap_or(screen).center().x, bottom))
        .constrain(true)
        .show(ctx, |ui| {
            Frame::popup(ui.style()).show(ui, |ui| {
                ui.set_max_width((screen.width() - 2.0 * EDGE).clamp(0.0, 420.0));
                ui.horizontal(|ui| said_ui(ui, session, requests, TextWrapMode::Wrap));
            });
        });
}
