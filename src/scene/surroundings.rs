//! What is not the object: the pattern on it, its transparency, the ground under it and the wall behind it.

use super::Rgb;
use super::choice::choices;

/// A second colour of the surface, laid out by object coordinates, so that no picture file is needed.
#[derive(Clone, Debug, PartialEq)]
pub struct Pattern {
    pub kind: PatternKind,
    /// Od where the pattern lies; the material's colour is seen between.
    pub color: Rgb,
    /// Width of one field, world units.
    pub scale: f64,
}

impl Default for Pattern {
    fn default() -> Self {
        Self { kind: PatternKind::None, color: Rgb::new(0.95, 0.92, 0.85), scale: 0.25 }
    }
}

choices! {
    /// The patterns. Fields are counted from the origin, the first of them centred there.
    pub enum PatternKind {
        None = "none", "none", "No pattern";
        Checker = "checker", "checker", "Cubes, every other one coloured";
        Stripes = "stripes", "stripes", "Level layers";
        Rings = "rings", "rings", "Shells about the axis";
    }
}

/// Light that passes through the surface: `I = (1 − kt)·Irefl + kt·Itrans`.
#[derive(Clone, Debug, PartialEq)]
pub struct Transparency {
    /// Kt, the part of the transmitted light, 0 (opaque) to 1.
    pub kt: f64,
    /// η, the index of refraction inside relative to that outside.
    pub ior: f64,
    pub through: Through,
}

impl Default for Transparency {
    fn default() -> Self {
        Self { kt: 0.0, ior: 1.5, through: Through::Solid }
    }
}

choices! {
    /// How far a transmitted ray is followed.
    pub enum Through {
        Surface = "surface", "one surface", "Refracted once: what lies behind is inside the material as well";
        Solid = "solid", "solid", "Refracted on its way in and out, and reflected inside where it cannot leave";
    }
}

/// A level floor that receives light and shadows: it is seen from above, behind the object, and before what of the wall is
/// farther away.
#[derive(Clone, Debug, PartialEq)]
pub struct Ground {
    pub visible: bool,
    /// Its y coordinate, world.
    pub height: f64,
    /// Ambient coefficient.
    pub ka: f64,
    /// Diffuse coefficient.
    pub kd: f64,
    /// Od of the floor.
    pub color: Rgb,
}

impl Default for Ground {
    fn default() -> Self {
        Self { visible: false, height: -1.0, ka: 0.1, kd: 0.7, color: Rgb::new(0.8, 0.8, 0.8) }
    }
}

/// A patterned wall behind the object, upright to the viewing direction, without end. Between the pattern it has the
/// background's colour; it hides what of the ground lies beyond it.
#[derive(Clone, Debug, PartialEq)]
pub struct Backdrop {
    /// None: there is no wall.
    pub pattern: PatternKind,
    pub color: Rgb,
    /// Width of one field, world units.
    pub scale: f64,
    /// How far it stands behind the camera's target, world units.
    pub distance: f64,
}

impl Default for Backdrop {
    fn default() -> Self {
        Self { pattern: PatternKind::None, color: Rgb::new(0.85, 0.83, 0.78), scale: 0.4, distance: 2.0 }
    }
}
