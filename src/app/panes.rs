//! Panes in the window: where they are on the screen, and what stands over them.

use super::engine::Engine;
use super::letter::letter;
use super::palette;
use super::place::Place;
use super::state::{AppState, Grip};
use crate::analysis::{caption, pane_areas};
use crate::figure::palette::Vector;
use crate::scene::CompareView;
use eframe::egui::{
    Align2, Color32, Painter, Pos2, Rect, Stroke, StrokeKind, TextStyle, Ui, pos2, vec2,
};
use glam::DVec2;

/// Points between a caption and the edge of its pane.
const MARGIN: f32 = 10.0;
/// Radius of the wipe's handle, points.
const KNOB: f32 = 9.0;

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

/// Whether a point is on the line of a wipe, within `reach`.
pub fn on_wipe(state: &AppState, panes: &[PanePlace], point: Pos2, reach: f32) -> bool {
    let between = |pair: &[PanePlace]| (pair[0].seen.max.x - point.x).abs() <= reach;
    state.document.scene.compare.view == CompareView::Wipe && panes.windows(2).any(between)
}

/// Draws over panes that are compared.
pub fn paint(ui: &Ui, state: &AppState, engine: &Engine, panes: &[PanePlace], whole: Place) {
    let figures = &engine.figures;
    if figures.len() != panes.len() || figures.len() < 2 {
        return;
    }
    let font = TextStyle::Body.resolve(ui.style());
    let write = |painter: &Painter, align: Align2, rect: Rect, text: &str| {
        letter(
            painter,
            align.pos_in_rect(&rect),
            align,
            text,
            &font,
            Color32::WHITE,
        );
    };
    let painter = ui.painter().with_clip_rect(whole.rect);
    let rect = whole.rect.shrink(MARGIN);
    let lines: Vec<[String; 2]> = figures
        .iter()
        .map(|one| caption(one, figures.last()))
        .collect();
    match state.document.scene.compare.view {
        CompareView::Single => {}
        CompareView::Panes => {
            for (pane, [name, measured]) in panes.iter().zip(&lines) {
                let rect = pane.seen.shrink(MARGIN);
                let painter = painter.with_clip_rect(pane.seen);
                write(&painter, Align2::LEFT_TOP, rect, name);
                // In a narrow pane a line each.
                let width = painter
                    .layout_no_wrap(measured.clone(), font.clone(), Color32::WHITE)
                    .size()
                    .x;
                let text = if width > rect.width() {
                    measured.replace("   ", "\n")
                } else {
                    measured.clone()
                };
                write(&painter, Align2::LEFT_BOTTOM, rect, &text);
                if pane.pane == state.panes.active {
                    let stroke = Stroke::new(2.0, palette::vector(Vector::T));
                    painter.rect_stroke(pane.seen, 0.0, stroke, StrokeKind::Inside);
                }
            }
        }
        CompareView::Wipe => {
            write(&painter, Align2::LEFT_TOP, rect, &lines[0][0]);
            write(&painter, Align2::RIGHT_TOP, rect, &lines[1][0]);
            write(&painter, Align2::LEFT_BOTTOM, rect, &lines[0][1]);
            write(&painter, Align2::RIGHT_BOTTOM, rect, &lines[1][1]);
            let held = state.drag.is_some_and(|drag| drag.grip == Grip::Wipe);
            wipe(&painter, wipe_line(state, whole), whole, held);
        }
        CompareView::Difference => {
            write(
                &painter,
                Align2::LEFT_TOP,
                rect,
                &format!("{} − {}", lines[0][0], lines[1][0]),
            );
            let Some(error) = figures[0].error else {
                return;
            };
            let words = format!(
                "mean {:.4}   RMS {:.4}   greatest {:.4}",
                error.mean, error.rms, error.greatest
            );
            write(
                &painter,
                Align2::LEFT_TOP,
                rect.translate(vec2(0.0, 1.4 * font.size)),
                &words,
            );
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
