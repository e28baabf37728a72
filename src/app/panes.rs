//! Panes in the window: where they are on the screen, and their captions, by which they are moved and chosen.

use super::action::Action;
use super::engine::Engine;
use super::focus;
use super::handles;
use super::letter::letter;
use super::palette;
use super::place::Place;
use super::state::{AppState, Grip};
use crate::analysis::{caption, error_line, pane_areas};
use crate::figure::palette::Vector;
use crate::scene::{AmbientSource, CompareView, View};
use crate::text;
use eframe::egui::accesskit::Role;
use eframe::egui::text::{LayoutJob, TextWrapping};
use eframe::egui::{
    Align2, Color32, CursorIcon, FontId, Painter, Popup, Pos2, Rect, Sense, Stroke, StrokeKind,
    TextStyle, Ui, pos2, vec2,
};
use glam::DVec2;

/// Points between a caption and the edge of its pane.
const MARGIN: f32 = 10.0;
/// A pane less high than this has no room for figures over its picture, points.
const LEAST_CAPTIONED: f32 = 150.0;
/// Least width of a picture in which figures stand beside the scale of a difference, points.
const LEAST_BESIDE: f32 = 600.0;
/// Radius of the wipe's handle, points.
const KNOB: f32 = 9.0;
/// Points about a handle that captions leave free.
const CLEAR: f32 = 16.0;
/// Points between a caption's name and the edge of its ground.
const PADDING: [f32; 2] = [6.0, 3.0];

/// A pane and where its picture is shown. In a wipe or a difference two panes share one place.
#[derive(Clone, Copy, Debug)]
pub struct PanePlace {
    /// The pane's number.
    pub pane: usize,
    pub place: Place,
    /// What of it is seen.
    pub seen: Rect,
}

/// The panes that are shown in the room of `whole`.
pub fn places(state: &AppState, whole: Place) -> Vec<PanePlace> {
    let scene = &state.document.scene;
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
        let line = wipe_line(state, whole);
        (left.seen.max.x, right.seen.min.x) = (line, line);
    }
    panes
}

/// Where the line of a wipe is on the screen.
pub fn wipe_line(state: &AppState, whole: Place) -> f32 {
    let column = (state.document.scene.compare.wipe * f64::from(whole.size[0])).round() as f32;
    whole.rect.min.x + column / whole.pixels_per_point
}

/// The pane at a point of the screen: the active one where several are, or where it is nearest.
pub fn pane_at(panes: &[PanePlace], active: usize, point: Pos2) -> Option<PanePlace> {
    let hit = |pane: &&PanePlace| pane.seen.contains(point);
    panes
        .iter()
        .filter(hit)
        .find(|pane| pane.pane == active)
        .or_else(|| panes.iter().find(hit))
        .copied()
}

/// Whether what lies over a pane's picture is drawn: that of one pane only where several share a place.
pub fn is_overlaid(state: &AppState, pane: usize) -> bool {
    state.document.scene.compare.view == CompareView::Panes || pane == state.panes.active
}

/// Whether a point is on the line of a wipe, within `reach`.
pub fn on_wipe(state: &AppState, panes: &[PanePlace], point: Pos2, reach: f32) -> bool {
    let between = |pair: &[PanePlace]| (pair[0].seen.max.x - point.x).abs() <= reach;
    state.document.scene.compare.view == CompareView::Wipe && panes.windows(2).any(between)
}

/// The captions of panes that are compared, and what else stands over them.
pub fn captions_ui(
    ui: &mut Ui,
    state: &mut AppState,
    engine: &Engine,
    panes: &[PanePlace],
    whole: Place,
) {
    let figures = &engine.figures;
    let hidden = state.hides_numbers();
    let font = TextStyle::Body.resolve(ui.style());
    let compared = figures.len() == panes.len() && figures.len() > 1;
    for pane in panes {
        halves(ui, state, pane, compared, &font);
    }
    if !compared {
        return;
    }
    let painter = ui.painter().with_clip_rect(whole.rect);
    let rect = whole.rect.shrink(MARGIN);
    match state.document.scene.compare.view {
        CompareView::Single => {}
        CompareView::Panes => {
            for (pane, one) in panes.iter().zip(figures) {
                let painter = painter.with_clip_rect(pane.seen);
                if pane.pane == state.panes.active {
                    let stroke = Stroke::new(2.0, palette::vector(Vector::T));
                    painter.rect_stroke(pane.seen, 0.0, stroke, StrokeKind::Inside);
                }
                let room = pane.seen.shrink(MARGIN);
                let name = name_ui(ui, state, panes, pane, &one.name, (room, Align2::LEFT_TOP));
                // A small pane shows its picture; the figures stand in the view beside it.
                if room.height() < LEAST_CAPTIONED || hidden {
                    continue;
                }
                let text = fitting(&painter, &caption(one, figures), &font, room.width());
                let corners = [Align2::LEFT_BOTTOM, Align2::RIGHT_BOTTOM];
                measured(&painter, state, pane, (room, name), &text, corners, &font);
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
                let name = name_ui(ui, state, panes, pane, &one.name, (room, top));
                if hidden {
                    continue;
                }
                let text = fitting(&painter, &caption(one, figures), &font, room.width());
                let corners = [bottom, bottom];
                measured(&painter, state, pane, (room, name), &text, corners, &font);
            }
            let held = state.drag.is_some_and(|drag| drag.grip == Grip::Wipe);
            wipe(&painter, wipe_line(state, whole), whole, held);
        }
        CompareView::Difference => {
            let Some(error) = figures.iter().find_map(|one| one.error) else {
                return;
            };
            let title = format!("{} − {}", figures[0].name, figures[1].name);
            let (at, align) = (rect.min, Align2::LEFT_TOP);
            letter(&painter, at, align, &title, &font, Color32::WHITE);
            if hidden {
                return;
            }
            let line = error_line(&error);
            let below = rect.with_min_y(rect.min.y + 1.4 * font.size);
            if rect.width() < LEAST_BESIDE {
                // The scale takes the bottom.
                letter(&painter, below.min, align, &line, &font, Color32::WHITE);
            } else {
                let room = (rect, rect.with_max_y(below.min.y));
                let corners = [Align2::LEFT_BOTTOM; 2];
                measured(&painter, state, &panes[0], room, &line, corners, &font);
            }
            if let Some([x, y]) = error.at {
                // A small square round the greatest difference.
                let centre = whole.point(DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5));
                let square = Rect::from_center_size(centre, vec2(16.0, 16.0));
                for stroke in [
                    Stroke::new(4.0, Color32::from_black_alpha(150)),
                    Stroke::new(1.5, Color32::WHITE),
                ] {
                    painter.rect_stroke(square, 0.0, stroke, StrokeKind::Middle);
                }
            }
        }
    }
}

/// Names the halves of a picture that compares two kinds of ambient light.
fn halves(ui: &Ui, state: &AppState, pane: &PanePlace, captioned: bool, font: &FontId) {
    if state.panes.scene(pane.pane).ambient.source != AmbientSource::Split {
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
        // Word below word where they are wider than their half.
        let line = painter.layout_no_wrap(text.to_owned(), font.clone(), Color32::WHITE);
        let text = if line.size().x > 0.5 * place.width() - MARGIN {
            text.replace(' ', "\n")
        } else {
            text.to_owned()
        };
        letter(
            &painter,
            at,
            Align2::CENTER_TOP,
            &text,
            font,
            Color32::WHITE,
        );
    }
    let x = place.center().x;
    for stroke in [
        Stroke::new(3.0, Color32::from_black_alpha(110)),
        Stroke::new(1.0, Color32::from_white_alpha(170)),
    ] {
        painter.line_segment([pos2(x, place.min.y), pos2(x, place.max.y)], stroke);
    }
}

/// A pane's name, by which it is dragged to the place of another; a click opens its menu. Returns where it stands.
fn name_ui(
    ui: &mut Ui,
    state: &mut AppState,
    panes: &[PanePlace],
    pane: &PanePlace,
    name: &str,
    (room, align): (Rect, Align2),
) -> Rect {
    let font = TextStyle::Body.resolve(ui.style());
    let [x, y] = PADDING;
    let mark = if pane.pane == state.document.scene.reference_pane() {
        "◆ "
    } else {
        ""
    };
    let mut job = LayoutJob::simple_singleline(format!("{mark}{name} ▾"), font, Color32::WHITE);
    job.wrap = TextWrapping::truncate_at_width((room.width() - 2.0 * x).max(1.0));
    let galley = ui.painter().layout_job(job);
    let rect = align.align_size_within_rect(galley.size() + 2.0 * vec2(x, y), room);
    let id = focus::picture_id().with(("caption", pane.pane));
    let response = ui.interact(rect, id, Sense::click_and_drag());
    let label = text!("picture-caption", number = pane.pane + 1, name = name);
    let response = focus::named(response, Role::Button, &label)
        .on_hover_text(text!("picture-caption-tip"))
        .on_hover_cursor(CursorIcon::Grab);
    let alpha = if response.hovered() { 210 } else { 140 };
    let painter = ui.painter().with_clip_rect(pane.seen);
    painter.rect_filled(rect, 4.0, Color32::from_black_alpha(alpha));
    painter.galley(rect.min + vec2(x, y), galley.clone(), Color32::WHITE);
    if response.clicked() {
        state.ask(Action::Activate(pane.pane));
    }
    Popup::menu(&response).show(|ui| menu_ui(ui, state, pane.pane));
    let apart = state.document.scene.compare.view == CompareView::Panes;
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
            painter.galley(shown.min + vec2(x, y), galley, Color32::WHITE);
        }
        if let Some(target) = target.filter(|_| response.drag_stopped()) {
            state.ask(Action::MovePane(pane.pane, target.pane));
        }
    }
    rect
}

/// What can be done with a pane.
pub fn menu_ui(ui: &mut Ui, state: &mut AppState, pane: usize) {
    let scene = &state.document.scene;
    let (last, reference) = (scene.pane_count() - 1, scene.reference_pane());
    let mut asked = None;
    let mut item = |enabled: bool, text: &str, action: Action| {
        let button = eframe::egui::Button::new(text);
        if ui.add_enabled(enabled, button).clicked() {
            asked = Some(action);
            ui.close();
        }
    };
    item(
        pane != reference,
        text!("picture-make-reference"),
        Action::Reference(pane),
    );
    item(
        pane > 0,
        text!("picture-move-earlier"),
        Action::MovePane(pane, pane.saturating_sub(1)),
    );
    item(
        pane < last,
        text!("picture-move-later"),
        Action::MovePane(pane, pane + 1),
    );
    item(
        last > 0,
        text!("picture-remove-pane"),
        Action::RemovePane(pane),
    );
    state.asked.extend(asked);
}

/// Parts of a caption in one line, or where the room is too narrow in a line each.
fn fitting(painter: &Painter, parts: &[String], font: &FontId, room: f32) -> String {
    let line = parts.join("   ");
    let galley = painter.layout_no_wrap(line.clone(), font.clone(), Color32::WHITE);
    if galley.size().x > room {
        parts.join("\n")
    } else {
        line
    }
}

/// Writes what is measured of a pane into one of the corners or below its name, whichever no handle stands in.
fn measured(
    painter: &Painter,
    state: &AppState,
    pane: &PanePlace,
    (room, name): (Rect, Rect),
    text: &str,
    corners: [Align2; 2],
    font: &FontId,
) {
    let size = painter
        .layout_no_wrap(text.to_owned(), font.clone(), Color32::WHITE)
        .size();
    let view = View::new(&state.panes.scene(pane.pane).camera, pane.place.size);
    let grips = handles::grips(state, &view, pane.place);
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
    letter(
        painter,
        align.pos_in_rect(&room),
        align,
        text,
        font,
        Color32::WHITE,
    );
}

/// The line of a wipe with its handle.
fn wipe(painter: &Painter, x: f32, whole: Place, held: bool) {
    let ends = [pos2(x, whole.rect.min.y), pos2(x, whole.rect.max.y)];
    painter.line_segment(ends, Stroke::new(4.0, Color32::from_black_alpha(150)));
    painter.line_segment(ends, Stroke::new(1.5, Color32::WHITE));
    let centre = pos2(x, whole.rect.center().y);
    let radius = if held { KNOB + 2.0 } else { KNOB };
    painter.circle(
        centre,
        radius,
        Color32::from_black_alpha(190),
        Stroke::new(2.0, Color32::WHITE),
    );
    for way in [-1.0, 1.0] {
        let tip = centre + vec2(way * 0.65 * radius, 0.0);
        let back = vec2(-way * 0.35 * radius, 0.35 * radius);
        painter.line_segment([tip, tip + back], Stroke::new(1.5, Color32::WHITE));
        painter.line_segment(
            [tip, tip + vec2(back.x, -back.y)],
            Stroke::new(1.5, Color32::WHITE),
        );
    }
}
