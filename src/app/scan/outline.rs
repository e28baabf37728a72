//! The polygon in question, outlined in the picture, with the part of it that the scan line has reached.

use super::super::lines::{line, outline};
use super::super::look::NumbersTab;
use super::super::place::Place;
use super::super::state::AppState;
use super::ScanView;
use eframe::egui::{Color32, Painter, Stroke};
use glam::DVec2;

/// Draws the outline white on dark, so that it shows on any picture.
pub fn paint(painter: &Painter, state: &AppState, place: Place) {
    let Some(view) = state.own.get::<ScanView>().filter(|_| state.shows(NumbersTab::ScanLine)) else { return };
    let Some(scan) = view.ready() else { return };
    let at = |grid: DVec2| place.exact_point(scan.grid.to_picture(grid));
    let corners: Vec<DVec2> = scan.corners.iter().map(|corner| at(corner.place)).collect();
    for stroke in [Stroke::new(4.0, Color32::from_black_alpha(150)), Stroke::new(1.75, Color32::WHITE)] {
        outline(painter, &corners, stroke);
    }
    let point = scan.at(view.step());
    if let Some(span) = point.span {
        let ends = [span.p.x, span.q.x].map(|x| at(DVec2::new(x, point.line.at())));
        line(painter, ends, Stroke::new(3.0, Color32::from_black_alpha(150)), &[]);
        line(painter, ends, Stroke::new(1.25, Color32::WHITE), &[]);
    }
}
