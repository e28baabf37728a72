//! Where the panes are on the screen.

use super::super::place::Place;
use super::super::state::AppState;
use crate::analysis::pane_areas;
use crate::scene::CompareView;
use eframe::egui::{Pos2, Rect, vec2};

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
    let alone = |pane| PanePlace { pane, place: whole, seen: whole.rect };
    if shown.len() < 2 {
        return shown.into_iter().map(alone).collect();
    }
    match scene.compare.view {
        CompareView::Panes => {
            let areas = pane_areas(shown.len(), whole.size);
            let placed = shown.into_iter().zip(areas).map(|(pane, area)| {
                let ppp = whole.pixels_per_point;
                let [x, y] = area.min.map(|v| v as f32 / ppp);
                let [width, height] = area.size.map(|v| v as f32 / ppp);
                let rect = Rect::from_min_size(whole.rect.min + vec2(x, y), vec2(width, height));
                PanePlace { pane, place: Place { rect, size: area.size, pixels_per_point: ppp }, seen: rect }
            });
            placed.collect()
        }
        CompareView::Wipe => {
            let line = wipe_line(state, whole);
            let mut panes: Vec<PanePlace> = shown.into_iter().map(alone).collect();
            if let [left, right] = &mut panes[..] {
                left.seen.max.x = line;
                right.seen.min.x = line;
            }
            panes
        }
        CompareView::Single | CompareView::Difference => shown.into_iter().map(alone).collect(),
    }
}

/// Where the line of a wipe is on the screen.
pub fn wipe_line(state: &AppState, whole: Place) -> f32 {
    let column = (state.document.scene.compare.wipe * f64::from(whole.size[0])).round() as f32;
    whole.rect.min.x + column / whole.pixels_per_point
}

/// The pane at a point of the screen: the active one where several are, or where it is nearest.
pub fn pane_at(panes: &[PanePlace], active: usize, point: Pos2) -> Option<PanePlace> {
    let hit = |pane: &&PanePlace| pane.seen.contains(point);
    panes.iter().filter(hit).find(|pane| pane.pane == active).or_else(|| panes.iter().find(hit)).copied()
}

/// Whether a point is on the line of a wipe, within `reach`.
pub fn on_wipe(state: &AppState, panes: &[PanePlace], point: Pos2, reach: f32) -> bool {
    let between = |pair: &[PanePlace]| (pair[0].seen.max.x - point.x).abs() <= reach;
    state.document.scene.compare.view == CompareView::Wipe && panes.windows(2).any(between)
}
