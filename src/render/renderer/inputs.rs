//! What each stage reads: it runs again when this differs from the last time.

use crate::illumination::Equation;
use crate::render::cue::{Cue, LayerInputs};
use crate::render::lens::Lens;
use crate::render::plan::{Per, Plan};
use crate::scene::{AmbientSource, Display, NormalSource, ObjectKind, Polygons, Scene, Weighting};

#[derive(PartialEq)]
pub(super) struct MeshInputs {
    pub kind: ObjectKind,
    pub segments: u32,
    pub rings: u32,
    pub given: u64,
    /// The scene's own polygons.
    pub polygons: Option<Polygons>,
}

#[derive(PartialEq)]
pub(super) struct ModelInputs {
    pub mesh: u64,
    pub normals: NormalSource,
    pub weighting: Weighting,
}

#[derive(PartialEq)]
pub(super) struct PlacedInputs {
    pub model: u64,
    pub lens: Lens,
    pub size: [u32; 2],
    pub cull: bool,
}

#[derive(PartialEq)]
pub(super) struct IntensityInputs {
    pub model: u64,
    pub equation: Equation<f32>,
    pub per: Per,
    pub double: bool,
    /// The run of the bits, where there are shadows.
    pub reach: Option<u64>,
    /// Where intensities fade at the points.
    pub cue: Option<Cue>,
}

#[derive(PartialEq)]
pub(super) struct CanvasInputs {
    pub bands: u64,
    pub equation: Option<Equation<f32>>,
    pub background: [f64; 3],
    pub display: Display,
    pub whole_picture: bool,
    pub renormalise: bool,
    pub double: bool,
    /// Whether the bits are read: they are kept while shadows are off.
    pub shadows: bool,
    /// The runs of the bits, of what is seen beyond and of what other surfaces scatter.
    pub rays: Option<[u64; 3]>,
    /// How what is seen beyond is mixed in.
    pub composition: Option<(f64, AmbientSource)>,
    /// What s0 at the pixels is made from.
    pub cue: Option<LayerInputs>,
}

impl CanvasInputs {
    pub fn new(scene: &Scene, plan: &Plan, equation: &Equation<f32>, stamps: (u64, [u64; 3])) -> Self {
        let (bands, rays) = stamps;
        Self {
            bands,
            cue: None,
            equation: (plan.per == Per::Pixel).then(|| equation.clone()),
            background: scene.image.background.to_array(),
            display: scene.display.clone(),
            whole_picture: plan.whole_picture,
            renormalise: plan.renormalise,
            double: plan.double,
            shadows: plan.shadows,
            rays: plan.follows_rays().then_some(rays),
            composition: plan.composes.then_some((scene.transparency.kt, scene.ambient.source)),
        }
    }
}
