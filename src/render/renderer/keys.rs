//! What each step reads: it runs again when this differs from the last time.

use super::cue::{Cue, CueKey};
use super::plan::Per;
use crate::illumination::Equation;
use crate::render::lens::Lens;
use crate::scene::{AmbientSource, Display, FlatAt, NormalSource, ObjectKind, Polygons, Weighting};

#[derive(PartialEq)]
pub struct MeshKey {
    pub kind: ObjectKind,
    pub segments: u32,
    pub rings: u32,
    /// Which model is shown, for an object that shows one.
    pub given: u64,
    /// The scene's own polygons.
    pub polygons: Option<Polygons>,
}

#[derive(PartialEq)]
pub struct ModelKey {
    pub mesh: u64,
    pub normals: NormalSource,
    pub weighting: Weighting,
}

#[derive(PartialEq)]
pub struct PlacedKey {
    pub model: u64,
    pub lens: Lens,
    pub size: [u32; 2],
    pub cull: bool,
}

#[derive(PartialEq)]
pub struct PointsKey {
    pub model: u64,
    pub equation: Equation<f32>,
    pub per: Per,
    pub double: bool,
    /// The run of the shadow rays, where there are shadows.
    pub visibility: Option<u64>,
    /// Where intensities fade at the points.
    pub cue: Option<Cue>,
}

#[derive(PartialEq)]
pub struct CoverageKey {
    pub size: [u32; 2],
    /// The stamp of the placed triangles, or of the true surface.
    pub source: u64,
    /// Rays to the true surface depend on the lens; placed triangles have taken it in.
    pub lens: Option<Lens>,
    pub depth_test: bool,
}

#[derive(PartialEq)]
pub struct InterpolationKey {
    pub coverage: u64,
    /// The stamp of what the vertices carry.
    pub source: u64,
    pub per: Per,
    /// Pixels that are evaluated in double precision are brought nothing.
    pub carries: bool,
    pub perspective: bool,
    pub scanline: bool,
    pub flat_at: Option<FlatAt>,
}

#[derive(PartialEq)]
pub struct PictureKey {
    pub interpolation: u64,
    pub equation: Option<Equation<f32>>,
    pub background: [f64; 3],
    pub display: Display,
    pub whole_picture: bool,
    pub renormalise: bool,
    pub double: bool,
    /// Whether shadow bits are read: they are kept while shadows are off.
    pub shadows: bool,
    /// The runs of the rays.
    pub rays: Option<[u64; 3]>,
    /// How what is seen beyond is mixed in.
    pub composition: Option<(f64, AmbientSource)>,
    /// What s0 at the pixels is made from.
    pub cue: Option<CueKey>,
}
