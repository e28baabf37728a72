//! The latest notice or warning over the picture, if there is no bottom bar to show it.

use super::layout::NARROW;
use super::notice::{expire, said_ui};
use crate::app::session::Session;
use crate::app::session::window::WindowState;
use eframe::egui::{Align2, Area, Context, Frame, Id, Order, TextWrapMode, vec2};

/// The distance above the rail at the bottom of a narrow window, in points.
const LIFT: f32 = 72.0;

/// Shows the notice or warning over the picture, if there is no bottom bar for it and no dialog.
pub fn toast_ui(ctx: &Context, session: &mut Session, window: &mut WindowState, dialog: bool) {
    expire(ctx, session, window);
    let width = ctx.content_rect().width();
    let alone = window.picture_alone || window.enlarged || window.embedded.is_some();
    let barred = !alone && window.appearance.stages && width >= NARROW;
    if barred || dialog || session.said().is_none() {
        return;
    }
    Area::new(Id::unique("toast"))
        .order(Order::Foreground)
        .interactable(session.notice.is_none())
        .anchor(Align2::CENTER_BOTTOM, vec2(0.0, -LIFT))
        .show(ctx, |ui| {
            Frame::popup(ui.style()).show(ui, |ui| {
                ui.set_max_width((width - 48.0).clamp(0.0, 420.0));
                ui.horizontal(|ui| said_ui(ui, session, TextWrapMode::Wrap));
            });
        });
}
