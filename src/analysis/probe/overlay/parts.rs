//! What the vectors of the equation look like in a picture, before anything is drawn.

use crate::figure::palette::Vector;
use glam::DVec2;

/// Among more lights than this only the chosen one is lettered.
pub const LETTERED: usize = 24;

/// How an arrow ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ArrowHead {
    /// In a triangle.
    Plain,
    /// In a dot within a circle: it points at the eye.
    Towards,
    /// In a cross within a circle: it points away from the eye.
    Away,
}

/// A vector of the equation in the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Arrow {
    pub vector: Vector,
    /// The light that it belongs to; none for N and V.
    pub light: Option<usize>,
    /// Where the probe's point appears, pixels.
    pub tail: DVec2,
    /// Where the vector's end appears, which may be outside the picture.
    pub tip: DVec2,
    pub head: ArrowHead,
    /// False for the lights that are not chosen.
    pub emphasised: bool,
}

/// What an arc measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Angle {
    /// Between N and L.
    Theta,
    /// Between N and R, which equals θ.
    Mirror,
    /// Between R and V, or N and H for Blinn's model.
    Phi,
}

/// An arc between two vectors in the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Arc {
    pub angle: Angle,
    /// Points along it, pixels.
    pub points: Vec<DVec2>,
    /// Seen from its edge: only its label is drawn.
    pub edge_on: bool,
}

/// A light's symbol in the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct LightHandle {
    /// Index in the scene.
    pub light: usize,
    /// The symbol's middle.
    pub pixel: DVec2,
    /// Whether the light itself is outside the picture or behind the eye; the symbol then stands at the edge.
    pub outside: bool,
}
