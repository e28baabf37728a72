//! The edges of the polygons, drawn over the picture of steps about polygons.

use crate::analysis::normals::NormalField;
use crate::app::course::Course;
use crate::app::engine::Engine;
use crate::app::session::place::Place;
use crate::app::session::window::WindowState;
use crate::app::widgets::lines::{cased, line};
use crate::scene::View;
use eframe::egui::Painter;
use glam::DVec2;

/// The number of polygons above which no edges are drawn, since they would hide the picture.
const MOST: usize = 6000;

/// The last drawn polygons.
#[derive(Default)]
struct Edges(Option<NormalField>);

/// Updates the polygons of the picture, if the step shows their edges.
pub fn watch(window: &mut WindowState, course: &Course, engine: &Engine) {
    if course.shows_edges() {
        let mut edges: Edges = window.own.take();
        engine.update_field(&mut edges.0);
        window.own.put(edges);
    }
}

/// Draws the outlines of the polygons that face the eye, white on dark, so that they are visible on any
/// picture.
pub fn paint(painter: &Painter, window: &WindowState, course: &Course, view: &View, place: Place) {
    let known: Option<&Edges> = window.own.get();
    let Some(field) = known.and_then(|edges| edges.0.as_ref()) else {
        return;
    };
    if !course.shows_edges() || field.face_count() > MOST {
        return;
    }
    for outline in field.facing_outlines(view) {
        let points: Vec<DVec2> = outline.iter().map(|at| place.exact_point(*at)).collect();
        // Edge by edge: where a polygon is seen almost edge-on, the mitres of a closed line would reach far
        // out.
        for stroke in cased([2.0, 0.8], [70, 130]) {
            let next = points.iter().cycle().skip(1);
            for (from, to) in points.iter().zip(next) {
                line(painter, [*from, *to], stroke, &[]);
            }
        }
    }
}
