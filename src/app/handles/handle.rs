//! The kinds of handles.

use eframe::egui::Vec2;

/// How far a marker keeps from the picture's edge, points.
pub const MARGIN: f32 = 22.0;

/// How a light shows in the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Handle {
    /// A point light in the picture.
    Point,
    /// A directional light; `front` on the viewer's side of the sphere.
    Directional { front: bool },
    /// A light that is not in the picture; the unit vector points to where it is.
    Edge(Vec2),
    /// Where the chosen light's axis goes; `front` where that is nearer to the viewer than the light.
    Aim { front: bool },
    /// The edge of the chosen spot light's cone; the unit vector points away from its axis.
    Rim(Vec2),
}
