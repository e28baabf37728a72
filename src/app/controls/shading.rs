//! Where the equation is evaluated, and how values get from vertices to pixels.

use crate::app::row::{About, choice, toggle};
use crate::app::state::AppState;
use crate::app::symbol::Symbol;
use crate::scene::{FlatAt, Interpolation, Shading, ShadingMode};
use eframe::egui::{RichText, Ui};

/// The modes: what they are called and where each evaluates the equation.
pub const MODES: [(ShadingMode, &str, &str); 5] = [
    (ShadingMode::Flat, "Flat", "The equation once a polygon"),
    (
        ShadingMode::Interpolated,
        "Interpolated",
        "The equation at each polygon's corners with the polygon's own normal; the intensity is interpolated",
    ),
    (
        ShadingMode::Gouraud,
        "Gouraud",
        "The equation at the vertices with the vertex normals; the intensity is interpolated (Gouraud 1971)",
    ),
    (ShadingMode::Phong, "Phong", "The equation at every pixel with the interpolated normal (Phong 1975)"),
    (ShadingMode::Exact, "Exact", "The equation at every pixel of the true surface, with its own normal and outline"),
];

pub fn shading_ui(ui: &mut Ui, state: &mut AppState) {
    let AppState { document, lit, .. } = state;
    let has_surface = document.scene.object.kind.has_surface();
    let shading = &mut document.scene.shading;
    let default = Shading::default();
    let what = MODES.iter().find(|(mode, ..)| *mode == shading.mode).map_or("", |(_, _, what)| *what);
    let model = "There is no surface beyond these polygons: here Phong shading, evaluated in double precision";
    let what = if !has_surface && shading.mode == ShadingMode::Exact { model } else { what };
    ui.label(RichText::new(what).weak());
    let symbol = Some(Symbol::Normal);
    if shading.mode == ShadingMode::Flat {
        let tip = "Which point of the polygon lends it its one shade.";
        let about = About { label: "Shade taken", name: "Flat at", tip, symbol, ..About::default() };
        let choices = [
            (FlatAt::Centre, "at the centre", "The mean of the corners, with the polygon's own normal"),
            (FlatAt::VertexMean, "mean of corners", "The mean of the shades at the vertices"),
            (FlatAt::ProvokingVertex, "at the first corner", "The shade of the first vertex, as OpenGL may"),
        ];
        choice(ui, lit, &about, default.flat_at, &choices, &mut shading.flat_at);
    }
    if matches!(shading.mode, ShadingMode::Interpolated | ShadingMode::Gouraud | ShadingMode::Phong) {
        let tip = "How values between the vertices are found.";
        let about = About { label: "Interpolation", tip, symbol, ..About::default() };
        let choices = [
            (Interpolation::Perspective, "perspective-correct", "Linear on the polygon in space"),
            (Interpolation::Affine, "affine", "Linear on the triangle in the picture"),
            (Interpolation::Scanline, "scan line", "Linear along the edges, then along the scan line, in the picture"),
        ];
        choice(ui, lit, &about, default.interpolation, &choices, &mut shading.interpolation);
    }
    if shading.mode == ShadingMode::Phong {
        let tip = "Whether interpolated normals are made unit vectors again. Key 6 forgets to, key 4 remembers.";
        let about = About { label: "Renormalise", tip, symbol, ..About::default() };
        toggle(ui, lit, &about, default.renormalise, &mut shading.renormalise);
    }
}
