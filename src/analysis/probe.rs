//! The pixel probe: the equation at one pixel, in double precision.

mod clearest;
mod overlay;
mod report;
mod terms;
mod zero;

pub use clearest::clearest_pixel;
pub use overlay::{Angle, Arc, Arrow, ArrowHead, LightHandle, Overlay, draw_overlay};
pub use report::{ProbeQuestion, Probed, through_words};
pub use terms::{Column, Factor, Here, LightHere, Product};
pub use zero::{ZeroCause, ZeroCauses};

use crate::illumination::Equation;
use crate::render::{Evaluation, Renderer, Transmission};
use crate::scene::{LightKind, ReflectionModel, Rgb, Scene};
use glam::DVec3;
use zero::zero_causes;

/// The equation at one pixel.
#[derive(Clone, Debug)]
pub struct Probe {
    /// The pixel, (0, 0) top left.
    pub pixel: [u32; 2],
    /// Nothing where the background is seen.
    pub hit: Option<ProbeHit>,
    /// The Ia whose constant term stands best for the bounce of light in the whole picture, where that is gathered.
    pub ambient_fit: Option<Rgb>,
}

/// What the pixel shows of the object.
#[derive(Clone, Debug)]
pub struct ProbeHit {
    /// The point seen, world.
    pub position: DVec3,
    /// N at that point as the shading mode has it: the face's own, or interpolated, or the true surface's. Unit length
    /// unless the mode leaves it otherwise.
    pub normal: DVec3,
    /// V, unit, world.
    pub view: DVec3,
    /// Distance from the eye along the viewing direction, world units.
    pub depth: f64,
    /// Index of the face in the mesh; none where the true surface was met without one.
    pub face: Option<u32>,
    /// `ka·color·Ia`, or what one bounce of light from other surfaces puts in its place.
    pub ambient: Rgb,
    /// Whether `ambient` is light from other surfaces.
    pub bounced: bool,
    /// One per light of the scene, in its order.
    pub lights: Vec<LightTerms>,
    /// Irefl: what the terms add up to.
    pub reflected: Rgb,
    /// What passes through the surface, where any light does.
    pub transmission: Option<Transmission>,
    /// I, what the surface sends out: Irefl, or `(1 − kt)·Irefl + kt·Itrans`.
    pub intensity: Rgb,
    /// What depth cueing makes of it, where there is any.
    pub cue: Option<CueTerms>,
    /// The intensity before the display: I, or `s0·I + (1 − s0)·Idc`.
    pub sum: Rgb,
    /// What the display divides the intensity by; 1 unless it scales the picture.
    pub divisor: f64,
    /// The stored value of the pixel in the scene's own picture, without the panes of a comparison.
    pub stored: [u8; 3],
}

/// Depth cueing at a pixel: the intensity is `kept + veil`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CueTerms {
    /// s0: at the pixel's own depth, or interpolated from the vertices; where intensities fade at vertices, the mean of
    /// theirs.
    pub scale: f64,
    /// `s0·I`; where intensities fade at vertices, the mean of such products.
    pub kept: Rgb,
    /// `(1 − s0)·Idc`.
    pub veil: Rgb,
}

/// One light's part.
#[derive(Clone, Debug)]
pub struct LightTerms {
    pub kind: LightKind,
    /// Unit vector to the light, world.
    pub l: DVec3,
    /// L mirrored at N, world.
    pub r: DVec3,
    /// Half-way between L and V, world, unit.
    pub h: DVec3,
    pub n_dot_l: f64,
    /// Angle between N and L, radians.
    pub theta: f64,
    /// Angle between R and V, radians (between N and H for the models that measure those).
    pub phi: f64,
    /// The factor f; the mean of an area light's samples.
    pub attenuation: f64,
    /// The part of its intensity that a spot light sends this way; 1 for other lights.
    pub spot: f64,
    /// W(θ) per channel; 1 where it is constant.
    pub reflectance: Rgb,
    /// The angle of incidence that W depends on, radians: between L and N, or between L and H for the models that mirror
    /// at H.
    pub incidence: f64,
    /// The part of the light that is not in shadow: of an area light's samples, and of the places of evaluation. Where no ray
    /// is followed, nothing is known to stand before it: with shadows switched off, where the surface is turned away from
    /// the light, and where the light adds nothing to the whole picture.
    pub reached: f64,
    /// `f·Ip·kd·color·(N·L)` as it enters the sum.
    pub diffuse: Rgb,
    /// `f·Ip·ks·W·S` as it enters the sum.
    pub specular: Rgb,
    /// Why `diffuse` is 0, if it is.
    pub diffuse_zero: ZeroCauses,
    /// Why `specular` is 0, if it is.
    pub specular_zero: ZeroCauses,
}

impl LightTerms {
    /// Why the diffuse term is 0, in a clause; nothing where it adds something.
    pub fn why_no_diffuse(&self) -> Option<String> {
        (!self.diffuse_zero.is_empty()).then(|| self.diffuse_zero.clauses("Kd·Od"))
    }

    /// Why the specular term is 0 likewise.
    pub fn why_no_specular(&self) -> Option<String> {
        let coefficient = if self.reflectance == Rgb::ONE { "Ks·Os" } else { "Ks·Os·W" };
        (!self.specular_zero.is_empty()).then(|| self.specular_zero.clauses(coefficient))
    }

    /// Why the light adds nothing, in a clause; nothing where it adds something.
    pub fn why_nothing(&self) -> Option<String> {
        let (diffuse, specular) = (self.why_no_diffuse()?, self.why_no_specular()?);
        Some(if diffuse == specular { diffuse } else { format!("{diffuse}, and {specular}") })
    }

    /// The same in a word or two.
    pub fn why_nothing_in_short(&self) -> Option<&'static str> {
        self.why_nothing()?;
        let one = self.diffuse_zero == self.specular_zero && self.diffuse_zero.first() == self.diffuse_zero;
        Some(self.diffuse_zero.iter().next().filter(|_| one).map_or("adds nothing", ZeroCause::short))
    }
}

/// Evaluates the equation at pixel (`x`, `y`) of `scene`, drawing it first if it is not the picture last drawn.
///
/// The sum is what the picture shows there, to the rounding of single precision: it is evaluated where the shading mode
/// evaluates it. Where that is not at the pixel (flat, interpolated and Gouraud shading), `diffuse` and `specular` are the
/// weighted sums over those places, while the vectors and angles are those at the pixel itself, with the normal that the
/// mode has there. A pixel outside the picture sees nothing.
pub fn probe(renderer: &mut Renderer, scene: &Scene, x: u32, y: u32) -> Probe {
    let frame = renderer.render(scene);
    let stored = frame.pixel(x, y);
    let hit = stored.zip(renderer.evaluation(x, y)).map(|(stored, evaluation)| {
        let (equation, shining) = (renderer.equation(scene), renderer.shining_equation(scene));
        let equations = [&equation, &shining];
        let lights = (0..scene.lights.len()).map(|light| light_terms(scene, equations, &evaluation, light)).collect();
        let mixture = renderer.mixture(x, y);
        let bounced = mixture.and_then(|mixture| mixture.bounced);
        let constant = ambient(&equation, &evaluation);
        let difference = bounced.unwrap_or(Rgb::ZERO);
        let reflected = (evaluation.intensity(&shining) + difference).max(Rgb::ZERO);
        let transmission = mixture.and_then(|mixture| mixture.transmission);
        let kt = scene.transparency.kt;
        let mixed = |reflected: Rgb, s0: f64| {
            transmission.map_or(reflected, |through| reflected * (1.0 - kt) + through.seen * (s0 * kt))
        };
        let intensity = mixed(reflected, 1.0);
        let cue = evaluation.cue.map(|_| {
            let scale = evaluation.scale();
            let reflected = (evaluation.kept(&shining) + scale * difference).max(Rgb::ZERO);
            CueTerms { scale, kept: mixed(reflected, scale), veil: evaluation.veil() }
        });
        ProbeHit {
            position: evaluation.position,
            normal: evaluation.normal,
            view: equation.view_at(evaluation.position),
            depth: evaluation.depth,
            face: evaluation.face,
            ambient: constant + difference,
            bounced: bounced.is_some(),
            lights,
            reflected,
            transmission,
            intensity,
            cue,
            sum: cue.map_or(intensity, |cue| cue.kept + cue.veil),
            divisor: renderer.report().divisor,
            stored,
        }
    });
    let ambient_fit = renderer.report().ambient_fit.map(Rgb::from_array);
    Probe { pixel: [x, y], hit, ambient_fit }
}

/// The constant ambient term where the equation is evaluated.
fn ambient(equation: &Equation<f64>, evaluation: &Evaluation<'_>) -> Rgb {
    let color: Rgb = evaluation.points.iter().map(|site| equation.pattern_color(site.point) * site.weight).sum();
    Rgb::from_array(equation.ambient) * color
}

/// One light's part; the second equation has only the sources that the picture is shaded with.
fn light_terms(
    scene: &Scene,
    [equation, shining]: [&Equation<f64>; 2],
    evaluation: &Evaluation<'_>,
    light: usize,
) -> LightTerms {
    let here = equation.respond_world(light, evaluation.position, evaluation.normal, None);
    let (mut diffuse, mut specular, mut reached) = (Rgb::ZERO, Rgb::ZERO, 0.0);
    for site in &evaluation.points {
        let response = shining.respond_world(light, site.point, site.normal, site.reached);
        diffuse += site.weight * response.diffuse;
        specular += site.weight * response.specular;
        reached += site.weight * response.reached;
    }
    let left_out = shining.sources_of(light).is_empty();
    let [diffuse_zero, specular_zero] = zero_causes(scene, [equation, shining], evaluation, light, [diffuse, specular]);
    let phi = match scene.reflection.model {
        ReflectionModel::Phong => angle(here.r, here.v),
        ReflectionModel::Blinn | ReflectionModel::CookTorrance => angle(evaluation.normal, here.h),
    };
    LightTerms {
        kind: scene.lights[light].kind,
        l: here.l,
        r: here.r,
        h: here.h,
        n_dot_l: evaluation.normal.dot(here.l),
        theta: angle(evaluation.normal, here.l),
        phi,
        attenuation: here.attenuation,
        spot: here.spot,
        reflectance: here.reflectance,
        incidence: here.incidence,
        reached: if left_out { 1.0 } else { reached },
        diffuse,
        specular,
        diffuse_zero,
        specular_zero,
    }
}

/// Angle between two vectors in radians, exact to rounding for small and for straight angles too (Kahan).
fn angle(a: DVec3, b: DVec3) -> f64 {
    let (a, b) = (a.normalize_or_zero(), b.normalize_or_zero());
    2.0 * (a - b).length().atan2((a + b).length())
}
