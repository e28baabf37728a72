//! The vertices of a scene's own polygons in the picture: small diamonds to drag.
//!
//! A vertex moves in the plane through it that is parallel to the picture. Before a polygon would cross
//! itself, the vertex stops as near to the pointer as it can.

use crate::app::controls::vertices::{MOST_HANDLES, move_vertex};
use crate::app::session::Session;
use crate::app::session::place::{Place, tidy};
use crate::app::session::window::{Grip, WindowState};
use crate::app::widgets::letter::letter;
use crate::app::widgets::palette;
use crate::figure::palette::Vector;
use crate::scene::{Object, ObjectKind, Scene, View};
use eframe::egui::{Align2, Color32, FontId, Painter, Pos2, Shape, Stroke, vec2};
use glam::DVec2;

/// The distance from a diamond's centre to its corners, in points.
const RADIUS: f32 = 6.0;
/// The maximum distance to the pointer at which a vertex shows its number, in points.
const NEAR: f32 = 40.0;

/// Returns the positions of the visible vertices, with their numbers.
pub fn seen(session: &Session, view: &View, place: Place) -> Vec<(u32, Pos2)> {
    let object = &session.shown.scene.object;
    let vertices = object.polygons().vertices;
    if object.kind != ObjectKind::Polygons || vertices.len() > MOST_HANDLES {
        return Vec::new();
    }
    let points = vertices
        .iter()
        .zip(0..)
        .filter_map(|(vertex, v)| Some((v, place.seen(view, *vertex)?)));
    points.filter(|(_, at)| place.rect.contains(*at)).collect()
}

/// Moves vertex `v` parallel to the picture until it is at `pixel`.
pub fn drag_to(object: &mut Object, v: u32, view: &View, pixel: DVec2) {
    let Some(from) = object.polygons().vertices.get(v as usize).copied() else {
        return;
    };
    let depth = (from - view.eye).dot(view.forward);
    if depth > 0.0 {
        let unit = view.world_per_pixel(depth);
        move_vertex(object, v, tidy(view.unproject(pixel, depth), unit), unit);
    }
}

/// Moves vertex `v` towards the viewer by `step` of the target's distance.
pub fn push(scene: &mut Scene, v: u32, view: &View, step: f64) {
    let unit = scene.camera.distance();
    let Some(from) = scene.object.polygons().vertices.get(v as usize).copied() else {
        return;
    };
    let to = tidy(from - view.forward * (step * unit), unit * 1e-3);
    move_vertex(&mut scene.object, v, to, unit * 1e-3);
}

/// Draws the diamonds, white with a dark rim so that they are visible on any picture, the chosen one filled;
/// those near the pointer have their numbers.
pub fn paint(
    painter: &Painter,
    session: &Session,
    window: &WindowState,
    view: &View,
    place: Place,
    pointer: Option<Pos2>,
) {
    for (v, at) in seen(session, view, place) {
        let held = window.drag.is_some_and(|drag| drag.grip == Grip::Vertex(v));
        let chosen = held || session.vertex == v as usize;
        let ways = [
            vec2(RADIUS, 0.0),
            vec2(0.0, RADIUS),
            vec2(-RADIUS, 0.0),
            vec2(0.0, -RADIUS),
        ];
        let corners = ways.map(|way| at + way).to_vec();
        let fill = if chosen {
            palette::vector(Vector::N)
        } else {
            Color32::from_black_alpha(110)
        };
        let halo = Stroke::new(4.0, Color32::from_black_alpha(150));
        let rim = Stroke::new(1.5, Color32::WHITE);
        painter.add(Shape::closed_line(corners.clone(), halo));
        painter.add(Shape::convex_polygon(corners, fill, rim));
        if held || pointer.is_some_and(|pointer| pointer.distance(at) <= NEAR) {
            let (below, font) = (at + vec2(0.0, RADIUS + 11.0), FontId::proportional(14.0));
            let (align, white) = (Align2::CENTER_CENTER, Color32::WHITE);
            letter(painter, below, align, &v.to_string(), &font, white);
        }
    }
}
