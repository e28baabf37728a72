//! Panes in the window: their positions on the screen, and their captions, which move and choose them.

use super::handles;
use crate::analysis::comparison::{PaneFigures, caption, error_line, pane_areas};
use crate::app::course::Course;
use crate::app::engine::Engine;
use crate::app::session::Session;
use crate::app::session::action::{Action, Requests};
use crate::app::session::place::Place;
use crate::app::session::window::{Grip, WindowState};
use crate::app::views::compare::menu_ui;
use crate::app::widgets::letter::{letter, set};
use crate::app::widgets::lines::cased;
use crate::app::widgets::{focus, palette};
use crate::figure::palette::Vector;
use crate::figure::with_raised_n;
use crate::scene::{AmbientSource, CompareView, View};
use crate::text;
use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align2, Color32, CursorIcon, FontId, Galley, Painter, Popup, Pos2, Rect, Sense, Stroke,
    StrokeKind, TextStyle, Ui, Vec2, pos2, vec2,
};
use glam::DVec2;
use std::sync::Arc;

/// The distance between a caption and the edge of its pane, in points.
const MARGIN: f32 = 10.0;
/// The minimum height of a pane with figures over its picture, in points.
const LEAST_CAPTIONED: f32 = 150.0;
/// The minimum width of a picture in which figures are beside the scale of a difference, in points.
const LEAST_BESIDE: f32 = 600.0;
/// The radius of the wipe's handle, in points.
const KNOB: f32 = 9.0;
/// The margin around a handle that captions leave free, in points.
const CLEAR: f32 = 16.0;
/// The distance between a caption's text and the edge of its background, in points; [`GROUND`] is the
/// background's opacity.
const PADDING: Vec2 = vec2(6.0, 3.0);
const GROUND: u8 = 170;
/// The minimum scale of a caption's type in a narrow pane; [`NAME_LINES`] is the maximum number of lines of a
/// name.
const LEAST_TYPE: f32 = 0.7;
const NAME_LINES: usize = 3;

/// A pane with the place of its picture. In a wipe or a difference, two panes share one place.
#[derive(Clone, Copy, Debug)]
pub struct PanePlace {
    /// The pane's number.
    pub pane: usize,
    pub place: Place,
    /// The visible part of the pane.
    pub seen: Rect,
}

/// Returns the panes displayed within `whole`.
pub fn places(session: &Session, whole: Place) -> Vec<PanePlace> {
    let scene = &session.document().scene;
    let shown = scene.shown_panes();
    if shown.len() > 1 && scene.compare.view == CompareView::Panes {
        let areas = pane_areas(shown.len(), whole.size);
        let placed = shown.into_iter().zip(areas).map(|(pane, area)| {
            let points = |pixels: [u32; 2]| {
                vec2(pixels[0] as f32, pixels[1] as f32) / whole.pixels_per_point
            };
            let rect = Rect::from_min_size(whole.rect.min + points(area.min), points(area.size));
            PanePlace {
                pane,
                place: Place {
                    rect,
                    size: area.size,
                    ..whole
                },
                seen: rect,
            }
        });
        return placed.collect();
    }
    let mut panes: Vec<_> = shown
        .into_iter()
        .map(|pane| PanePlace {
            pane,
            place: whole,
            seen: whole.rect,
        })
        .collect();
    if let ([left, right], CompareView::Wipe) = (&mut panes[..], scene.compare.view) {
        let line = wipe_line(session, whole);
        (left.seen.max.x, right.seen.min.x) = (line, line);
    }
    panes
}

/// Returns the horizontal position of a wipe's line on the screen.
pub fn wipe_line(session: &Session, whole: Place) -> f32 {
    let column = (session.document().scene.compare.wipe * f64::from(whole.size[0])).round() as f32;
    whole.rect.min.x + column / whole.pixels_per_point
}

/// Returns the pane at a point of the screen; if several panes share it, the active one.
pub fn pane_at(panes: &[PanePlace], active: usize, point: Pos2) -> Option<PanePlace> {
    let hit = |pane: &&PanePlace| pane.seen.contains(point);
    panes
        .iter()
        .filter(hit)
        .find(|pane| pane.pane == active)
        .or_else(|| panes.iter().find(hit))
        .copied()
}

/// Returns whether the overlays of a pane's picture are drawn: of panes that share a place, only those of the
/// active one.
pub fn is_overlaid(session: &Session, pane: usize) -> bool {
    session.document().scene.compare.view == CompareView::Panes || pane == session.panes.active
}

/// Returns whether a point is on the line of a wipe, within `reach`.
pub fn on_wipe(session: &Session, panes: &[PanePlace], point: Pos2, reach: f32) -> bool {
    let between = |pair: &[PanePlace]| (pair[0].seen.max.x - point.x).abs() <= reach;
    session.document().scene.compare.view == CompareView::Wipe && panes.windows(2).any(between)
}

/// Shows the captions of compared panes, and the marks drawn with them.
pub fn captions_ui(
    ui: &Ui,
    session: &Session,
    window: &WindowState,
    course: &Course,
    requests: &mut Requests,
    engine: &Engine,
    (panes, whole): (&[PanePlace], Place),
) {
    let grips = |pane: &PanePlace| {
        let view = View::new(&session.panes.scene(pane.pane).camera, pane.place.size);
        handles::grips(session, window, course, &view, pane.place)
    };
    let figures = &engine.figures;
    let hidden = course.hides();
    let font = TextStyle::Body.resolve(ui.style());
    let compared = figures.len() == panes.len() && figures.len() > 1;
    for pane in panes {
        halves(ui, session, pane, compared, &font);
    }
    if !compared {
        return;
    }
    let painter = ui.painter().with_clip_rect(whole.rect);
    let rect = whole.rect.shrink(MARGIN);
    match session.document().scene.compare.view {
        CompareView::Single => {}
        CompareView::Panes => {
            for (pane, one) in panes.iter().zip(figures) {
                let painter = painter.with_clip_rect(pane.seen);
                if pane.pane == session.panes.active {
                    let stroke = Stroke::new(2.0, palette::vector(Vector::T));
                    painter.rect_stroke(pane.seen, 0.0, stroke, StrokeKind::Inside);
                }
                let room = pane.seen.shrink(MARGIN);
                let at = (room, Align2::LEFT_TOP);
                let name = name_ui(ui, session, requests, panes, pane, &one.name, at);
                // A small pane shows its picture; the figures are in the view beside it.
                if room.height() < LEAST_CAPTIONED || hidden {
                    continue;
                }
                let text = caption_in(&painter, one, figures, &font, room);
                let corners = [Align2::LEFT_BOTTOM, Align2::RIGHT_BOTTOM];
                measured(&painter, &grips(pane), (room, name), &text, corners, &font);
            }
        }
        CompareView::Wipe => {
            let sides = [
                (Align2::LEFT_TOP, Align2::LEFT_BOTTOM),
                (Align2::RIGHT_TOP, Align2::RIGHT_BOTTOM),
            ];
            // Of equal width, wherever the line is.
            let half = vec2(0.5 * rect.width() - MARGIN, rect.height());
            for ((pane, one), (top, bottom)) in panes.iter().zip(figures).zip(sides) {
                let room = top.align_size_within_rect(half, rect);
                let name = name_ui(ui, session, requests, panes, pane, &one.name, (room, top));
                if hidden {
                    continue;
                }
                let text = caption_in(&painter, one, figures, &font, room);
                let corners = [bottom, bottom];
                measured(&painter, &grips(pane), (room, name), &text, corners, &font);
            }
            let held = window.drag.is_some_and(|drag| drag.grip == Grip::Wipe);
            wipe(&painter, wipe_line(session, whole), whole, held);
        }
        CompareView::Difference => {
            let Some(error) = figures.iter().find_map(|one| one.error) else {
                return;
            };
            let title = with_raised_n(&format!("{} − {}", figures[0].name, figures[1].name));
            let width = rect.width() - 2.0 * PADDING.x;
            let galley = fitting(&painter, &[title], &font, width);
            let name = Rect::from_min_size(rect.min, galley.size() + 2.0 * PADDING);
            plate(&painter, galley, name);
            if hidden {
                return;
            }
            let line = error_line(&error);
            let parts: Vec<String> = line.split("   ").map(str::to_owned).collect();
            if rect.width() < LEAST_BESIDE {
                // The scale occupies the bottom.
                let galley = fitting(&painter, &parts, &font, width);
                let at = name.left_bottom() + vec2(0.0, 4.0);
                let below = Rect::from_min_size(at, galley.size() + 2.0 * PADDING);
                plate(&painter, galley, below);
            } else {
                let (grips, corners) = (grips(&panes[0]), [Align2::LEFT_BOTTOM; 2]);
                measured(&painter, &grips, (rect, name), &parts, corners, &font);
            }
            if let Some([x, y]) = error.at {
                // A small square round the maximum difference.
                let centre = whole.point(DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5));
                let square = Rect::from_center_size(centre, vec2(16.0, 16.0));
                for stroke in cased([4.0, 1.5], [150, 255]) {
                    painter.rect_stroke(square, 0.0, stroke, StrokeKind::Middle);
                }
            }
        }
    }
}

/// Names the halves of a picture that compares two kinds of ambient light.
fn halves(ui: &Ui, session: &Session, pane: &PanePlace, captioned: bool, font: &FontId) {
    if session.panes.scene(pane.pane).ambient.source != AmbientSource::Split {
        return;
    }
    let painter = ui.painter().with_clip_rect(pane.seen);
    let place = pane.place.rect;
    let top = if captioned { 1.9 * font.size } else { 0.0 };
    for (way, text) in [
        (-0.25, text!("picture-half-constant")),
        (0.25, text!("picture-half-bounce")),
    ] {
        let x = place.center().x + way * place.width();
        let at = pos2(x, place.min.y + MARGIN + top);
        // A text wider than its half has one word per line.
        let line = painter.layout_no_wrap(text.to_owned(), font.clone(), Color32::WHITE);
        let text = if line.size().x > 0.5 * place.width() - MARGIN {
            text.replace(' ', "\n")
        } else {
            text.to_owned()
        };
        let (align, white) = (Align2::CENTER_TOP, Color32::WHITE);
        letter(&painter, at, align, &text, font, white);
    }
    let x = place.center().x;
    for stroke in cased([3.0, 1.0], [110, 170]) {
        painter.line_segment([pos2(x, place.min.y), pos2(x, place.max.y)], stroke);
    }
}

/// Lays out a name with the sign of a menu. A name too wide loses the sign, gets smaller type, and wraps, so
/// that the part that distinguishes the panes can be read.
fn name_galley(ui: &Ui, name: &str, room: f32) -> Arc<Galley> {
    let font = TextStyle::Body.resolve(ui.style());
    let name = with_raised_n(name);
    let lay = |text: &str, font: &FontId| {
        let job = set(text, font.clone(), Color32::WHITE);
        ui.painter().layout_job(job)
    };
    let signed = lay(&format!("{name} ▾"), &font);
    if signed.size().x <= room {
        return signed;
    }
    let width = lay(&name, &font).size().x;
    let font = smaller(&font, room / width.max(1.0));
    let mut job = set(&name, font, Color32::WHITE);
    (job.wrap.max_width, job.wrap.max_rows) = (room.max(1.0), NAME_LINES);
    ui.painter().layout_job(job)
}

/// Returns the font scaled by `share`, but not below the readable minimum.
fn smaller(font: &FontId, share: f32) -> FontId {
    FontId {
        size: font.size * share.clamp(LEAST_TYPE, 1.0),
        ..font.clone()
    }
}

/// Shows a pane's name; a drag moves the pane to the place of another, and a click opens its menu. Returns
/// the name's rectangle.
fn name_ui(
    ui: &Ui,
    session: &Session,
    requests: &mut Requests,
    panes: &[PanePlace],
    pane: &PanePlace,
    name: &str,
    (room, align): (Rect, Align2),
) -> Rect {
    let mark = if pane.pane == session.document().scene.reference_pane() {
        "◆ "
    } else {
        ""
    };
    let galley = name_galley(ui, &format!("{mark}{name}"), room.width() - 2.0 * PADDING.x);
    let rect = align.align_size_within_rect(galley.size() + 2.0 * PADDING, room);
    let id = focus::picture_id().with(("caption", pane.pane));
    let response = ui.interact(rect, id, Sense::click_and_drag());
    let label = text!("picture-caption", number = pane.pane + 1, name = name);
    let response = focus::named(response, Role::Button, &label)
        .on_hover_text(text!("picture-caption-tip"))
        .on_hover_cursor(CursorIcon::Grab);
    let alpha = if response.hovered() { 210 } else { GROUND };
    let painter = ui.painter().with_clip_rect(pane.seen);
    painter.rect_filled(rect, 4.0, Color32::from_black_alpha(alpha));
    painter.galley(rect.min + PADDING, galley.clone(), Color32::WHITE);
    if response.clicked() {
        requests.ask(Action::Activate(pane.pane));
    }
    Popup::menu(&response).show(|ui| menu_ui(ui, session, requests, pane.pane));
    let apart = session.document().scene.compare.view == CompareView::Panes;
    if let Some(at) = response.interact_pointer_pos().filter(|_| apart) {
        let target = panes.iter().find(|other| other.seen.contains(at));
        let target = target.filter(|other| other.pane != pane.pane);
        if response.dragged() {
            ui.ctx().set_cursor_icon(CursorIcon::Grabbing);
            // The caption follows the pointer, over everything.
            let painter = ui.painter().with_clip_rect(ui.max_rect());
            if let Some(target) = target {
                let stroke = Stroke::new(3.0, palette::vector(Vector::L));
                painter.rect_stroke(target.seen, 0.0, stroke, StrokeKind::Inside);
            }
            let shown = Rect::from_center_size(at, rect.size());
            painter.rect_filled(shown, 4.0, Color32::from_black_alpha(210));
            painter.galley(shown.min + PADDING, galley, Color32::WHITE);
        }
        if let Some(target) = target.filter(|_| response.drag_stopped()) {
            requests.ask(Action::MovePane(pane.pane, target.pane));
        }
    }
    rect
}

/// Lays out the parts of a caption on one line, or, if that is too wide, on a line each, in smaller type if
/// necessary.
fn fitting(painter: &Painter, parts: &[String], font: &FontId, room: f32) -> Arc<Galley> {
    // As in a pane's name, the n of a power is raised.
    let lay = |text: String, font: FontId| painter.layout_job(set(&text, font, Color32::WHITE));
    let line = lay(parts.join("   "), font.clone());
    if line.size().x <= room {
        return line;
    }
    let lines = lay(parts.join("\n"), font.clone());
    if lines.size().x <= room {
        return lines;
    }
    let font = smaller(font, room / lines.size().x);
    let mut job = set(&parts.join("\n"), font, Color32::WHITE);
    job.wrap.max_width = room.max(1.0);
    painter.layout_job(job)
}

/// Returns the caption of a pane. If it is too wide even in small type, leaves out the reference's value,
/// which the reference's own pane shows.
fn caption_in(
    painter: &Painter,
    one: &PaneFigures,
    all: &[PaneFigures],
    font: &FontId,
    room: Rect,
) -> Vec<String> {
    let whole = caption(one, all);
    let small = smaller(font, 0.0);
    let lines = painter.layout_no_wrap(whole.join("\n"), small, Color32::WHITE);
    if lines.size().x > room.width() - 2.0 * PADDING.x {
        return caption(one, &[]);
    }
    whole
}

/// Draws text on a dark background, which keeps it readable on any picture.
fn plate(painter: &Painter, galley: Arc<Galley>, rect: Rect) {
    painter.rect_filled(rect, 4.0, Color32::from_black_alpha(GROUND));
    painter.galley(rect.min + PADDING, galley, Color32::WHITE);
}

/// Writes a pane's measurements into a corner or below its name, wherever there is no handle.
fn measured(
    painter: &Painter,
    grips: &[(Grip, Pos2)],
    (room, name): (Rect, Rect),
    parts: &[String],
    corners: [Align2; 2],
    font: &FontId,
) {
    let galley = fitting(painter, parts, font, room.width() - 2.0 * PADDING.x);
    let size = galley.size() + 2.0 * PADDING;
    let free = |rect: Rect| {
        let near = rect.expand(CLEAR);
        !grips.iter().any(|(_, at)| near.contains(*at))
    };
    let below = if corners[0].x() == eframe::egui::Align::Max {
        Align2::RIGHT_TOP
    } else {
        Align2::LEFT_TOP
    };
    let under = Rect::from_min_max(pos2(room.min.x, name.max.y + 4.0), room.max);
    let places = [(corners[0], room), (corners[1], room), (below, under)];
    let found = places
        .into_iter()
        .find(|(align, room)| free(align.align_size_within_rect(size, *room)));
    let (align, room) = found.unwrap_or(places[0]);
    plate(painter, galley, align.align_size_within_rect(size, room));
}

/// Draws the line of a wipe with its handle.
fn wipe(painter: &Painter, x: f32, whole: Place, held: bool) {
    let ends = [pos2(x, whole.rect.min.y), pos2(x, whole.rect.max.y)];
    let white = |width| Stroke::new(width, Color32::WHITE);
    painter.line_segment(ends, Stroke::new(4.0, Color32::from_black_alpha(150)));
    painter.line_segment(ends, white(1.5));
    let centre = pos2(x, whole.rect.center().y);
    let radius = if held { KNOB + 2.0 } else { KNOB };
    painter.circle(centre, radius, Color32::from_black_alpha(190), white(2.0));
    for way in [-1.0, 1.0] {
        let tip = centre + vec2(way * 0.65 * radius, 0.0);
        let back = vec2(-way * 0.35 * radius, 0.35 * radius);
        painter.line_segment([tip, tip + back], white(1.5));
        painter.line_segment([tip, tip + vec2(back.x, -back.y)], white(1.5));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use eframe::egui::__run_test_ui;

    #[test]
    fn a_name_too_wide_for_its_pane_is_shown_whole() {
        __run_test_ui(|ui| {
            let wide = |text: &str| {
                let font = TextStyle::Body.resolve(ui.style());
                let line = ui
                    .painter()
                    .layout_no_wrap(text.to_owned(), font, Color32::WHITE);
                line.size().x
            };
            let name = "Vertex normals: averaged";
            let room = wide(name);
            assert!(name_galley(ui, name, 1.5 * room).text().ends_with('▾'));
            let raised = name_galley(ui, "Phong  (R·V)^n", 9.0 * room);
            assert_eq!(raised.text(), "Phong  (R·V)n ▾", "n is above the line");
            for share in [1.0, 0.8, 0.5] {
                let galley = name_galley(ui, name, share * room);
                assert!(!galley.elided && galley.text() == name, "{share}");
                assert!(galley.size().x <= share * room + 1.0, "{share}");
                assert_eq!(galley.rows.len() > 1, share < LEAST_TYPE, "{share}");
            }
        });
    }
}
