//! What stands over the panes: their names and figures, which of them is active, and the line of a wipe.

use super::super::engine::Engine;
use super::super::letter::letter;
use super::super::palette;
use super::super::place::Place;
use super::super::state::{AppState, Drag};
use super::place::{PanePlace, wipe_line};
use crate::analysis::caption;
use crate::figure::palette::Vector;
use crate::scene::CompareView;
use eframe::egui::{Align2, Color32, Painter, Pos2, Stroke, StrokeKind, TextStyle, Ui, pos2, vec2};

/// Points between a caption and the edge of its pane.
const MARGIN: f32 = 10.0;
/// Radius of the wipe's handle, points.
const KNOB: f32 = 9.0;

/// Draws over panes that are compared.
pub fn paint(ui: &Ui, state: &AppState, engine: &Engine, panes: &[PanePlace], whole: Place) {
    let figures = engine.figures();
    if figures.len() != panes.len() || figures.len() < 2 {
        return;
    }
    let painter = ui.painter().with_clip_rect(whole.rect);
    let font = TextStyle::Body.resolve(ui.style());
    let lines: Vec<[String; 2]> = figures.iter().map(|one| caption(one, figures.last())).collect();
    match state.document.scene.compare.view {
        CompareView::Single => {}
        CompareView::Panes => {
            for (pane, [name, measured]) in panes.iter().zip(&lines) {
                let rect = pane.seen.shrink(MARGIN);
                let painter = painter.with_clip_rect(pane.seen);
                letter(&painter, rect.left_top(), Align2::LEFT_TOP, name, &font, Color32::WHITE);
                // In a narrow pane a line each.
                let width = painter.layout_no_wrap(measured.clone(), font.clone(), Color32::WHITE).size().x;
                let text = if width > rect.width() { measured.replace("   ", "\n") } else { measured.clone() };
                letter(&painter, rect.left_bottom(), Align2::LEFT_BOTTOM, &text, &font, Color32::WHITE);
                if pane.pane == state.panes.active {
                    let stroke = Stroke::new(2.0, palette::vector(Vector::T));
                    painter.rect_stroke(pane.seen, 0.0, stroke, StrokeKind::Inside);
                }
            }
        }
        CompareView::Wipe => {
            let rect = whole.rect.shrink(MARGIN);
            letter(&painter, rect.left_top(), Align2::LEFT_TOP, &lines[0][0], &font, Color32::WHITE);
            letter(&painter, rect.right_top(), Align2::RIGHT_TOP, &lines[1][0], &font, Color32::WHITE);
            letter(&painter, rect.left_bottom(), Align2::LEFT_BOTTOM, &lines[0][1], &font, Color32::WHITE);
            letter(&painter, rect.right_bottom(), Align2::RIGHT_BOTTOM, &lines[1][1], &font, Color32::WHITE);
            wipe(&painter, wipe_line(state, whole), whole, state.drag == Drag::Wipe);
        }
        CompareView::Difference => {
            let rect = whole.rect.shrink(MARGIN);
            let name = format!("{} − {}", lines[0][0], lines[1][0]);
            letter(&painter, rect.left_top(), Align2::LEFT_TOP, &name, &font, Color32::WHITE);
            let Some(error) = figures[0].error else { return };
            let words = format!("mean {:.4}   RMS {:.4}   greatest {:.4}", error.mean, error.rms, error.greatest);
            letter(
                &painter,
                rect.left_top() + vec2(0.0, 1.4 * font.size),
                Align2::LEFT_TOP,
                &words,
                &font,
                Color32::WHITE,
            );
            if let Some([x, y]) = error.at {
                let centre = whole.point(glam::DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5));
                greatest(&painter, centre);
            }
        }
    }
}

/// The mark of the greatest difference: a small cross in a square.
fn greatest(painter: &Painter, at: Pos2) {
    for stroke in [Stroke::new(4.0, Color32::from_black_alpha(150)), Stroke::new(1.5, Color32::WHITE)] {
        let square = eframe::egui::Rect::from_center_size(at, vec2(16.0, 16.0));
        painter.rect_stroke(square, 0.0, stroke, StrokeKind::Middle);
    }
}

/// The line of a wipe with its handle.
fn wipe(painter: &Painter, x: f32, whole: Place, held: bool) {
    let ends = [pos2(x, whole.rect.min.y), pos2(x, whole.rect.max.y)];
    painter.line_segment(ends, Stroke::new(4.0, Color32::from_black_alpha(150)));
    painter.line_segment(ends, Stroke::new(1.5, Color32::WHITE));
    let centre = pos2(x, whole.rect.center().y);
    let radius = if held { KNOB + 2.0 } else { KNOB };
    painter.circle(centre, radius, Color32::from_black_alpha(190), Stroke::new(2.0, Color32::WHITE));
    for way in [-1.0, 1.0] {
        let tip = centre + vec2(way * 0.65 * radius, 0.0);
        let back = vec2(-way * 0.35 * radius, 0.35 * radius);
        painter.line_segment([tip, tip + back], Stroke::new(1.5, Color32::WHITE));
        painter.line_segment([tip, tip + vec2(back.x, -back.y)], Stroke::new(1.5, Color32::WHITE));
    }
}
