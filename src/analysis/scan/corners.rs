//! The polygon before it is scanned: where its corners appear and what they carry.

use super::{Carried, Rule, Scan, ScanError};
use crate::illumination::Equation;
use crate::render::{Cued, Polygon, Renderer, WeightedPoint};
use crate::scene::{Encoding, Interpolation, Projection, Rgb, Scene, ShadingMode, View};
use glam::{DVec2, DVec3};

/// A polygon with its shading.
pub struct Shaded {
    pub face: u32,
    pub mode: ShadingMode,
    pub carried: Carried,
    pub renormalise: bool,
    pub compared: Rule,
    pub corners: Vec<Seen>,
    pub orthographic: bool,
    equation: Equation<f64>,
    encoding: Encoding,
    /// What the display divides intensities by.
    divisor: f64,
}

/// A corner as it is seen.
#[derive(Clone, Copy, Debug)]
pub struct Seen {
    /// World.
    pub point: DVec3,
    /// Pixels of the picture.
    pub place: DVec2,
    pub depth: f64,
    /// What the corner carries.
    pub value: DVec3,
}

impl Shaded {
    /// Face `face` of `scene`, which `renderer` has drawn last.
    pub fn new(renderer: &Renderer, scene: &Scene, face: u32) -> Result<Self, ScanError> {
        let count = renderer.polygon_count();
        let polygon = renderer.polygon(face).ok_or(match count {
            0 => ScanError::Empty,
            count => ScanError::NoFace { face, count },
        })?;
        let mut equation = Equation::<f64>::new(scene);
        if let Some(plan) = renderer.plan() {
            equation.retain_lights(|light| plan.lights[light]);
        }
        let mode = if scene.shading.mode == ShadingMode::Exact { ShadingMode::Phong } else { scene.shading.mode };
        let carried = match mode {
            ShadingMode::Flat => Carried::Constant,
            ShadingMode::Interpolated | ShadingMode::Gouraud => Carried::Intensity,
            ShadingMode::Phong | ShadingMode::Exact => Carried::Normal,
        };
        let cued = renderer.plan().is_some_and(|plan| plan.cued == Cued::AtPoints);
        let cue = cued.then_some(scene.depth_cueing.color);
        let corners = seen(scene, &polygon, carried, &equation, cue).ok_or(ScanError::BehindTheEye { face })?;
        let compared = match scene.shading.interpolation {
            Interpolation::Perspective => Rule::Perspective,
            Interpolation::Affine | Interpolation::Scanline => Rule::Affine,
        };
        let orthographic = scene.camera.projection == Projection::Orthographic;
        let divisor = renderer.report().divisor;
        let (renormalise, encoding) = (scene.shading.renormalise, scene.display.encoding);
        Ok(Self { face, mode, carried, renormalise, compared, corners, orthographic, equation, encoding, divisor })
    }

    /// Where the corners appear, pixels of the picture.
    pub fn places(&self) -> Vec<DVec2> {
        self.corners.iter().map(|corner| corner.place).collect()
    }

    /// The intensity of a pixel that was given `value` and sees the point `position`.
    pub fn intensity(&self, value: DVec3, position: DVec3) -> Rgb {
        match self.carried {
            Carried::Constant | Carried::Intensity => value,
            Carried::Normal => {
                let normal = if self.renormalise { value.normalize_or_zero() } else { value };
                self.equation.illuminate_world(position, normal, None)
            }
        }
    }

    /// The stored value of an intensity.
    pub fn stored(&self, intensity: Rgb) -> [u8; 3] {
        let [r, g, b, _] = crate::render::stored_pixel(intensity / self.divisor, self.encoding);
        [r, g, b]
    }
}

/// The corners of `polygon` with what they carry, faded towards `cue` where intensities fade at points; nothing where one is
/// not before the eye.
fn seen(
    scene: &Scene,
    polygon: &Polygon<'_>,
    carried: Carried,
    equation: &Equation<f64>,
    cue: Option<Rgb>,
) -> Option<Vec<Seen>> {
    if !polygon.before_the_eye {
        return None;
    }
    let view = View::new(&scene.camera, scene.image.size);
    let evaluated = |site: &WeightedPoint<'_>| {
        let intensity = equation.illuminate_world(site.point, site.normal, site.reached);
        cue.map_or(intensity, |color| intensity * site.scale + color * (1.0 - site.scale))
    };
    let constant: Rgb = polygon.flat.iter().map(|site| evaluated(site) * site.weight).sum();
    let corners = polygon.corners.iter().map(|site| {
        let (place, depth) = view.project(site.point)?;
        let value = match carried {
            Carried::Constant => constant,
            Carried::Intensity => evaluated(site),
            Carried::Normal => site.normal,
        };
        Some(Seen { point: site.point, place, depth, value })
    });
    corners.collect()
}

impl Shaded {
    /// The same polygon as a scan without lines.
    pub fn empty_scan(&self, grid: super::Grid) -> Scan {
        let corners = self.corners.iter().map(|corner| super::ScanCorner {
            place: grid.from_picture(corner.place),
            depth: corner.depth,
            value: corner.value,
        });
        Scan {
            face: self.face,
            mode: self.mode,
            carried: self.carried,
            renormalise: self.renormalise,
            compared: self.compared,
            grid,
            corners: corners.collect(),
            edges: Vec::new(),
            lines: Vec::new(),
            steps: Vec::new(),
        }
    }
}
