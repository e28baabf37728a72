//! The scene's own polygons: how many there are, how they are edited, and the chosen vertex in numbers.

use crate::app::handles::vertex::{MOST, go};
use crate::app::row::{About, NumberRow, SliderRange, vector, whole};
use crate::app::state::AppState;
use eframe::egui::{RichText, Ui};

pub fn polygons_ui(ui: &mut Ui, state: &mut AppState) {
    let AppState { shown, lit, vertex, .. } = state;
    let object = &mut shown.scene.object;
    let polygons = object.polygons();
    let count = polygons.vertices.len();
    let faces = polygons.faces.len();
    ui.label(format!("{count} vertices, {faces} {}", if faces == 1 { "face" } else { "faces" }));
    let how = if count <= MOST {
        "Drag a vertex in the picture; with Shift along the line of sight. Faces are edited in the scene file."
    } else {
        "Vertices and faces are edited in the scene file."
    };
    ui.label(RichText::new(how).weak());
    *vertex = (*vertex).min(count.saturating_sub(1));
    let Some(at) = polygons.vertices.get(*vertex).copied() else { return };
    let mut number = u32::try_from(*vertex).unwrap_or(u32::MAX);
    let last = (count - 1) as f64;
    let range = SliderRange { limits: 0.0..=last, decimals: 0, ..SliderRange::linear(0.0..=last) };
    let tip = "The vertex whose place is given below, by its number in the scene file.";
    let about = About { label: "Vertex", tip, ..About::default() };
    whole(ui, lit, &NumberRow { about, range, default: 0.0 }, &mut number);
    *vertex = number as usize;
    let tip =
        "Where the vertex is; world units. It goes no farther than its polygons allow without crossing themselves.";
    let about = About { label: "Place", name: "Vertex place", tip, ..About::default() };
    let mut to = at;
    vector(ui, lit, &about, at, &mut to);
    if to != at {
        go(object, number, to, f64::MIN_POSITIVE);
    }
}
