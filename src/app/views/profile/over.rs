//! The profile over the picture: the line with its ends, the curve above it, and the point at the pointer.

use super::Profiles;
use crate::analysis::profile::lay_out_profile;
use crate::app::session::Session;
use crate::app::session::appearance::ViewName;
use crate::app::session::place::Place;
use crate::app::session::window::WindowState;
use crate::app::widgets::lines::line;
use crate::app::widgets::theme::TEXT;
use crate::figure::palette::{readable, shading};
use eframe::egui::{Color32, Context, Painter, Pos2, Stroke, vec2};
use glam::DVec2;

/// Radius of an end of the line, in points.
const END: f32 = 6.0;
/// Distance within which the pointer is on the line, in points.
const NEAR: f32 = 40.0;
/// Radius of the dot at the pointed position, and half the length of the mark across the line, in points.
const DOT: f32 = 4.0;
const ACROSS: f32 = 26.0;
/// Colour below the curve, which makes the curve's own colour visible on any picture.
const CASING: [u8; 3] = [0x14, 0x16, 0x1a];

/// Records the picture's place and the pointer's position along the line.
///
/// The plots align themselves with the picture and mark the position.
pub fn watch(ctx: &Context, window: &mut WindowState, place: Place, pointer: Option<Pos2>) {
    if !window.shows(ViewName::Profile) {
        return;
    }
    let [from, to] = window.line.pixels(place.size);
    let along = to - from;
    let near = f64::from(NEAR * place.pixels_per_point);
    let share = |at: Pos2| {
        let pixel = place.pixel(at);
        let share = (pixel - from).dot(along) / along.length_squared();
        let aside = pixel.distance(from + along * share);
        ((0.0..=1.0).contains(&share) && aside <= near).then_some(share)
    };
    let pointed = pointer
        .filter(|at| window.drag.is_none() && place.rect.contains(*at))
        .and_then(share);
    let mut profiles: Profiles = window.own.take();
    // The plots may have been drawn before the picture.
    if profiles.picture != Some(place) || profiles.pointed[1] != pointed {
        (profiles.picture, profiles.pointed[1]) = (Some(place), pointed);
        ctx.request_repaint();
    }
    window.own.put(profiles);
}

/// Draws the line white on dark, so that it is visible on any picture.
///
/// In the active pane it also draws the profile above the line and the pointed position.
pub fn paint(
    painter: &Painter,
    session: &Session,
    window: &WindowState,
    place: Place,
    active: bool,
) {
    if !window.shows(ViewName::Profile) {
        return;
    }
    if active {
        curves(painter, session, window, place);
    }
    let dark = |width| Stroke::new(width, Color32::from_black_alpha(150));
    let white = |width| Stroke::new(width, Color32::WHITE);
    let ends = window.line.pixels(place.size).map(|end| place.point(end));
    painter.line_segment(ends, dark(3.5));
    painter.line_segment(ends, white(1.5));
    for end in ends {
        painter.circle(end, END, Color32::from_black_alpha(110), dark(4.0));
        painter.circle_stroke(end, END, white(2.0));
    }
    let profiles: Option<&Profiles> = window.own.get().filter(|_| active);
    if let Some((profiles, share)) = profiles.and_then(|one| Some((one, one.pointed()?))) {
        let [from, to] = ends;
        let at = from + (to - from) * share as f32;
        let across = (to - from).rot90().normalized() * ACROSS;
        let mark = if profiles.aligned {
            // The mark continues in the plot.
            let bottom = Pos2::new(at.x, place.rect.bottom());
            [at - vec2(0.0, ACROSS), bottom]
        } else {
            [at - across, at + across]
        };
        painter.line_segment(mark, dark(3.0));
        painter.line_segment(mark, white(1.0));
        painter.circle(at, DOT, Color32::WHITE, dark(1.5));
    }
}

/// Draws the curves above the line: the intensity solid in the colour of the scene's own shading mode, the perceived brightness
/// dashed.
fn curves(painter: &Painter, session: &Session, window: &WindowState, place: Place) {
    let Some(taken) = window.own.get().and_then(Profiles::profile) else {
        return;
    };
    let own = session.shown.scene.shading.mode;
    let mut traces = taken.traces.iter();
    let Some(trace) = traces.find(|trace| trace.mode == own) else {
        return;
    };
    let side = f64::from(place.size[0].min(place.size[1]));
    let em = f64::from(TEXT * place.pixels_per_point);
    let Some(curves) = lay_out_profile(taken, trace, side, em) else {
        return;
    };
    let draw = |points: &[DVec2], stroke: Stroke, dashes: &[f32]| {
        let points = points.iter().map(|point| place.exact_point(*point));
        line(painter, points, stroke, dashes);
    };
    let [r, g, b] = CASING;
    let dark = Stroke::new(4.5, Color32::from_rgb(r, g, b).gamma_multiply(0.8));
    let white = |width| Stroke::new(width, Color32::WHITE);
    if window.appearance.profile.edges {
        for tick in &curves.ticks {
            draw(tick, dark, &[]);
            draw(tick, white(1.5), &[]);
        }
    }
    if window.appearance.profile.brightness {
        draw(&curves.perceived, dark, &[]);
        draw(&curves.perceived, white(1.6), &[6.0, 4.0]);
    }
    draw(&curves.intensity, dark, &[]);
    let [r, g, b] = readable(shading(own), CASING, 4.5);
    let stroke = Stroke::new(2.4, Color32::from_rgb(r, g, b));
    draw(&curves.intensity, stroke, &[]);
}
