//! The vectors of the illumination equation at a probed point, over a picture.

use super::palette::Vector;
use crate::analysis::{Probe, ProbeHit};
use crate::scene::{ReflectionModel, Scene, View};
use glam::DVec3;
use serde::{Deserialize, Serialize};
use tiny_skia::{Color, LineCap, Paint, PathBuilder, PixmapMut, Stroke, StrokeDash, Transform};

/// What an overlay may show.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum OverlayLayer {
    /// N, L, R, V and, for Blinn's model, H at the probe's point.
    Vectors,
    /// The arcs of θ and φ with their values.
    Angles,
    /// How R comes from L by projection on N.
    Construction,
    /// A sun for each light, an arrow for each directional one.
    Lights,
    /// The vectors once more in a corner, seen from the side: V points at the eye, so in the picture itself it is a point.
    SideView,
}

impl OverlayLayer {
    /// Every layer.
    pub const ALL: [Self; 5] = [Self::Vectors, Self::Angles, Self::Construction, Self::Lights, Self::SideView];
}

/// What surrounds strokes and letters to set them off from the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Halo {
    /// White.
    Light,
    /// Nearly black.
    Dark,
}

/// How an overlay is drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct OverlayOptions {
    pub layers: Vec<OverlayLayer>,
    /// The light whose L is emphasised and whose R, H, θ, φ and construction are shown, by its index in the scene. With
    /// nothing chosen it is the first that the point faces, or else the first.
    pub light: Option<usize>,
    /// Length of a unit vector in world units; nothing makes it a sixth of the picture's height at the point's depth.
    pub length: Option<f64>,
    /// Shows H, and φ between N and H, for every model; without it for Blinn's alone.
    pub half_vector: bool,
    pub halo: Halo,
    /// Multiplies lettering and line widths; 1 suits a picture that fills the screen.
    pub scale: f64,
}

impl Default for OverlayOptions {
    fn default() -> Self {
        Self {
            layers: vec![OverlayLayer::Vectors, OverlayLayer::Angles],
            light: None,
            length: None,
            half_vector: false,
            halo: Halo::Light,
            scale: 1.0,
        }
    }
}

/// Draws the overlay of `probe` on `pixmap`, which holds a picture of `scene` or nothing yet. The camera is fitted to the
/// pixmap's size, so a picture may be drawn larger or smaller than the scene says. Where the probe met nothing only the
/// lights are drawn.
pub fn draw_overlay(pixmap: &mut PixmapMut<'_>, scene: &Scene, probe: &Probe, options: &OverlayOptions) {
    let view = View::new(&scene.camera, [pixmap.width(), pixmap.height()]);
    if let Some(hit) = &probe.hit {
        draw_vectors(pixmap, &view, scene, hit, options);
    }
}

fn draw_vectors(pixmap: &mut PixmapMut<'_>, view: &View, scene: &Scene, hit: &ProbeHit, options: &OverlayOptions) {
    let height = f64::from(pixmap.height());
    let Some((tail, depth)) = view.project(hit.position) else { return };
    let length = options.length.unwrap_or(height / 6.0 * view.world_per_pixel(depth));
    let mut vectors: Vec<(Vector, DVec3)> = vec![(Vector::N, hit.normal), (Vector::V, hit.view)];
    for light in &hit.lights {
        vectors.push((Vector::L, light.l));
        vectors.push((Vector::R, light.r));
        if options.half_vector || scene.reflection.model == ReflectionModel::Blinn {
            vectors.push((Vector::H, light.h));
        }
    }
    let width = (height / 200.0 * options.scale).max(1.0) as f32;
    for (vector, direction) in vectors {
        let Some((tip, _)) = view.project(hit.position + direction * length) else { continue };
        let mut builder = PathBuilder::new();
        builder.move_to(tail.x as f32, tail.y as f32);
        builder.line_to(tip.x as f32, tip.y as f32);
        let Some(path) = builder.finish() else { continue };
        let mut paint = Paint::default();
        let [r, g, b] = vector.colour();
        paint.set_color(Color::from_rgba8(r, g, b, 255));
        let dash = StrokeDash::new(vector.dashes().iter().map(|d| d * width).collect(), 0.0);
        let stroke = Stroke { width, dash, line_cap: LineCap::Butt, ..Stroke::default() };
        pixmap.stroke_path(&path, &paint, &stroke, Transform::identity(), None);
    }
}
