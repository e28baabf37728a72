//! The pixel probe: the equation at one pixel, in double precision.

mod construction;
mod digits;
mod filled;
mod letters;
mod overlay;
mod products;
mod report;
mod zero;

pub use construction::{ConstructionStep, WorkedStep};
pub use digits::{digits, digits_below, percent};
pub use filled::{FilledLine, FilledPart, LineValue, Share, law_text, law_words};
pub use letters::{Letters, Tone, equation_letters, plain_formula, specular_vector};
pub(super) use letters::{attenuation_law, exponent};
pub use overlay::{
    Angle, Arc, Arrow, ArrowHead, LightHandle, Overlay, VectorsShown, draw_overlay, draw_vectors,
};
pub use products::{Here, LightHere, Product, TermColumn};
pub use report::{ProbeQuestion, Probed, channels};
pub use zero::{ZeroCause, ZeroCauses};

use crate::illumination::{Equation, LawValues};
use crate::render::{Evaluation, Renderer, Transmission};
use crate::scene::{
    Backfacing, FaceMaterial, LightKind, PatternKind, ReflectionModel, Rgb, Scene, View,
};
use crate::text;
use glam::{DVec2, DVec3};
use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};
use std::borrow::Cow;
use std::ops::RangeInclusive;
use zero::zero_causes;

/// Columns and rows of the grid on which the pixel is searched.
const SEARCH_GRID: u32 = 64;

/// Degrees between the vectors of a drawing with uncrowded letters.
const APART: RangeInclusive<f64> = 15.0..=65.0;

/// The equation at one pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct Probe {
    /// The pixel, (0, 0) top left.
    pub pixel: [u32; 2],
    /// The hit; none where the background is visible.
    pub hit: Option<ProbeHit>,
    /// The Ia whose constant term best approximates the bounce of light in the whole picture, if that is gathered.
    pub ambient_fit: Option<Rgb>,
}

impl Probe {
    /// Returns whether the pixel of `scene` shows the floor, if it does not show the object.
    pub fn beside_is_floor(&self, scene: &Scene) -> bool {
        let view = View::new(&scene.camera, scene.image.size);
        let [x, y] = self.pixel.map(f64::from);
        let (origin, direction) = view.ray(DVec2::new(x, y) + 0.5);
        let above = origin.y - scene.ground.height;
        if !scene.ground.visible || above <= 0.0 || direction.y >= 0.0 {
            return false;
        }
        // The wall behind the object stands on the floor and hides what is farther away.
        let reach = -above / direction.y * direction.dot(view.forward);
        let wall = scene.camera.target + view.forward * scene.backdrop.distance;
        let to_wall = (wall - origin).dot(view.forward);
        scene.backdrop.pattern == PatternKind::None || to_wall <= 0.0 || reach <= to_wall
    }
}

/// The point of the object that the pixel shows.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ProbeHit {
    /// The visible point, world.
    pub position: DVec3,
    /// N there according to the shading mode: the face's, interpolated, or the surface's; of unit length unless the
    /// mode leaves it.
    pub normal: DVec3,
    /// V, unit vector, world.
    pub view: DVec3,
    /// Distance from the eye along the viewing direction, world units.
    pub depth: f64,
    /// Index of the face in the mesh; none where the true surface was hit without one.
    pub face: Option<u32>,
    /// The model's material of the face; none where it is the scene's.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub material: Option<HitMaterial>,
    /// `ka·color·Ia`, or one bounce of light from other surfaces in its place.
    pub ambient: Rgb,
    /// True if `ambient` is light from other surfaces.
    pub bounced: bool,
    /// The colour of the model's vertices here, which tints Od; none where they have none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tint: Option<Rgb>,
    /// Od where the equation is evaluated; the weighted mean if that is at several points.
    #[serde(skip)]
    pub color: Rgb,
    /// Terms of each light of the scene, in its order.
    pub lights: Vec<LightTerms>,
    /// Irefl, the sum of the terms.
    pub reflected: Rgb,
    /// Light that passes through the surface, if any does.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub transmission: Option<Transmission>,
    /// I, the light that leaves the surface: Irefl, or `(1 − kt)·Irefl + kt·Itrans`.
    #[serde(skip)]
    pub intensity: Rgb,
    /// Terms of depth cueing, if there is any.
    #[serde(skip)]
    pub cue: Option<CueTerms>,
    /// The intensity before the display: I, or `s0·I + (1 − s0)·Idc`.
    pub sum: Rgb,
    /// Divisor of the display for the intensity; 1 unless it scales the picture.
    pub divisor: f64,
    /// Stored value of the pixel in the scene's own picture, without the panes of a comparison.
    pub stored: [u8; 3],
}

/// The material that a model gives to a face.
#[derive(Clone, Debug, PartialEq)]
pub struct HitMaterial {
    /// The name in the model.
    pub name: String,
    /// The numbers of the equation and of the light that passes, with the scene's changes.
    pub numbers: FaceMaterial,
}

impl HitMaterial {
    /// Returns the scene as a point shows it that has this material.
    fn scene_of<'s>(this: Option<&Self>, scene: &'s Scene) -> Cow<'s, Scene> {
        let mut own = Cow::Borrowed(scene);
        if let Some(Self { numbers, .. }) = this {
            numbers.clone().replace_in(own.to_mut());
        }
        own
    }
}

impl Serialize for HitMaterial {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self { name, numbers } = self;
        let FaceMaterial {
            material,
            kt,
            relative_ior,
        } = numbers;
        let mut object = serializer.serialize_struct("material", 9)?;
        object.serialize_field("name", name)?;
        object.serialize_field("ka", &material.ka)?;
        object.serialize_field("kd", &material.kd)?;
        object.serialize_field("ks", &material.ks)?;
        object.serialize_field("n", &material.n)?;
        object.serialize_field("color", &material.color)?;
        object.serialize_field("specular_color", &material.specular_color)?;
        object.serialize_field("kt", kt)?;
        object.serialize_field("relative_ior", relative_ior)?;
        object.end()
    }
}

impl ProbeHit {
    /// Returns the scene as this point shows it: its material is the face's, and its colours have the tint.
    pub fn scene_of<'s>(&self, scene: &'s Scene) -> Cow<'s, Scene> {
        let mut own = HitMaterial::scene_of(self.material.as_ref(), scene);
        if let Some(tint) = self.tint {
            let own = own.to_mut();
            own.material.color *= tint;
            own.pattern.color *= tint;
        }
        own
    }
}

/// Depth cueing at a pixel: the intensity is `kept + veil`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CueTerms {
    /// s0 at the pixel's own depth, or interpolated from the vertices, or the mean of theirs where they fade.
    pub scale: f64,
    /// `s0·I`; where intensities fade at vertices, the mean of such products.
    pub kept: Rgb,
    /// `(1 − s0)·Idc`.
    pub veil: Rgb,
}

/// The terms of one light. JSON has its angles in degrees.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LightTerms {
    /// Kind of the source.
    pub kind: LightKind,
    /// Unit vector to the light, world.
    pub l: DVec3,
    /// L mirrored at N, world.
    pub r: DVec3,
    /// Unit vector half-way between L and V, world.
    pub h: DVec3,
    /// N·L, the cosine of θ; not clamped.
    pub n_dot_l: f64,
    /// Angle between N and L, radians.
    #[serde(serialize_with = "in_degrees")]
    pub theta: f64,
    /// Angle between R and V, radians.
    #[serde(serialize_with = "in_degrees")]
    pub phi: f64,
    /// Angle between N and H, radians; N is turned towards the light where surfaces have two sides.
    #[serde(serialize_with = "in_degrees")]
    pub alpha: f64,
    /// The factor f; the mean of an area light's samples.
    pub attenuation: f64,
    /// The share of its intensity that a spot light sends in this direction; 1 for other lights.
    pub spot: f64,
    /// W(θ) per channel; 1 where it is constant.
    #[serde(rename = "w")]
    pub reflectance: Rgb,
    /// The angle of incidence that W depends on, radians: from L to N, or to H for the models that mirror at H.
    #[serde(serialize_with = "in_degrees")]
    pub incidence: f64,
    /// The share of the light that is not in shadow, of an area light's samples and of the places of evaluation; 1
    /// where no ray is followed: without shadows, on surfaces turned away, and for lights that add nothing to the whole
    /// picture.
    pub reached: f64,
    /// `f·Ip·kd·color·(N·L)` as it enters the sum.
    pub diffuse: Rgb,
    /// `f·Ip·ks·W·S` as it enters the sum.
    pub specular: Rgb,
    /// Causes why `diffuse` is 0, if it is.
    pub diffuse_zero: ZeroCauses,
    /// Causes why `specular` is 0, if it is.
    pub specular_zero: ZeroCauses,
    /// The lines of the scene's own law with their values at the pixel itself; none for the models that are built in. Its part
    /// is `diffuse`, and `specular` is 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub law: Option<LawValues>,
}

impl LightTerms {
    /// Returns the angle whose cosine a model raises or distributes, with its letter: φ, or α between N and H.
    pub fn lobe_angle(&self, model: ReflectionModel) -> (&'static str, f64) {
        match model {
            ReflectionModel::Phong | ReflectionModel::Formula => ("φ", self.phi),
            ReflectionModel::Blinn | ReflectionModel::CookTorrance => ("α", self.alpha),
        }
    }

    /// Returns the reason why the diffuse term is 0, in a clause; none if it adds something.
    pub fn why_no_diffuse(&self) -> Option<String> {
        self.diffuse_zero.clauses("Kd·Od")
    }

    /// Returns the reason why the specular term is 0, in a clause; none if it adds something.
    pub fn why_no_specular(&self) -> Option<String> {
        self.specular_zero.clauses(if self.reflectance == Rgb::ONE {
            "Ks·Os"
        } else {
            "Ks·Os·W"
        })
    }

    /// Returns the reason why the light adds nothing, in a clause; none if it adds something.
    pub fn why_nothing(&self) -> Option<String> {
        let (diffuse, specular) = (self.why_no_diffuse()?, self.why_no_specular()?);
        Some(if self.law.is_some() || diffuse == specular {
            diffuse
        } else {
            text!("point-zero-both", diffuse = diffuse, specular = specular)
        })
    }

    /// Returns the reason why the light adds nothing in a word or two.
    pub fn why_nothing_in_short(&self) -> Option<&'static str> {
        self.why_nothing()?;
        let one = (self.law.is_some() || self.diffuse_zero == self.specular_zero)
            && self.diffuse_zero.first() == self.diffuse_zero;
        Some(
            self.diffuse_zero
                .short()
                .filter(|_| one)
                .unwrap_or(text!("point-zero-nothing")),
        )
    }
}

fn in_degrees<S: Serializer>(radians: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_f64(radians.to_degrees())
}

/// Evaluates the equation at pixel (`x`, `y`) of `scene`, drawing it first if it is not the picture last drawn.
///
/// The sum is the picture's value there, up to rounding to single precision: it is evaluated where the shading mode
/// evaluates it. Where that is not at the pixel (flat, interpolated and Gouraud shading), `diffuse` and `specular`
/// are the weighted sums over those places, while the vectors and angles are those at the pixel itself, with the
/// normal that the mode has there. A pixel outside the picture sees nothing.
///
/// ```
/// use shading_lab::analysis::probe::probe;
/// use shading_lab::render::Renderer;
/// use shading_lab::scene::Scene;
///
/// let mut scene = Scene::default();
/// scene.image.size = [64, 64];
/// let mut renderer = Renderer::default();
/// let hit = probe(&mut renderer, &scene, 36, 28).hit.expect("the sphere");
/// assert!((hit.normal.length() - 1.0).abs() < 1e-6);
/// let light = &hit.lights[0];
/// assert!((light.n_dot_l - light.theta.cos()).abs() < 1e-6);
///
/// assert!(probe(&mut renderer, &scene, 0, 0).hit.is_none(), "the background");
/// ```
pub fn probe(renderer: &mut Renderer, scene: &Scene, x: u32, y: u32) -> Probe {
    let stored = renderer.render(scene).pixel(x, y);
    let hit = stored
        .zip(renderer.evaluation(x, y))
        .map(|(stored, evaluation)| {
            let material = renderer.model_material(scene, evaluation.material);
            let material = material.map(|(name, numbers)| HitMaterial { name, numbers });
            let own = HitMaterial::scene_of(material.as_ref(), scene);
            let scene = &*own;
            let mixture = renderer.mixture(x, y);
            let bounced = mixture.and_then(|mixture| mixture.bounced);
            // Where light bounces, the picture's equation has no ambient term.
            let with_ambient = |equation: Equation<f64>| match bounced {
                Some(_) => equation.without_ambient(),
                None => equation,
            };
            let equation = with_ambient(renderer.equation(scene));
            let shining = renderer.shining_equations(scene);
            let shining: Vec<_> = shining.into_iter().map(with_ambient).collect();
            let equations = [&equation, &shining[evaluation.material]];
            let lights = (0..scene.lights.len())
                .map(|light| light_terms(scene, equations, &evaluation, light))
                .collect();
            // Od where the equation is evaluated, unless it is part of the coefficients.
            let color: Rgb = evaluation
                .points
                .iter()
                .map(|site| equation.pattern_color(site.point) * site.tint * site.weight)
                .sum();
            let tint = renderer.is_tinted().then(|| {
                let points = evaluation.points.iter();
                points.map(|site| site.tint * site.weight).sum()
            });
            let constant = Rgb::from_array(equation.ambient) * color;
            let scattered = bounced.unwrap_or(Rgb::ZERO);
            let reflected = evaluation.intensity(&shining) + scattered;
            let transmission = mixture.and_then(|mixture| mixture.transmission);
            let kt = scene.transparency.kt;
            let mixed = |reflected: Rgb, s0: f64| {
                transmission.map_or(reflected, |through| {
                    reflected * (1.0 - kt) + through.seen * (s0 * kt)
                })
            };
            let intensity = mixed(reflected, 1.0);
            let cue = evaluation.cue.map(|_| {
                let scale = evaluation.scale();
                let reflected = evaluation.kept(&shining) + scale * scattered;
                CueTerms {
                    scale,
                    kept: mixed(reflected, scale),
                    veil: evaluation.veil(),
                }
            });
            ProbeHit {
                position: evaluation.position,
                normal: evaluation.normal,
                view: equation.view_at(evaluation.position),
                depth: evaluation.depth,
                face: evaluation.face,
                material,
                tint,
                ambient: constant + scattered,
                bounced: bounced.is_some(),
                color: match tint {
                    _ if equation.has_pattern() => color,
                    Some(tint) => scene.material.color * tint,
                    None => scene.material.color,
                },
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
    Probe {
        pixel: [x, y],
        hit,
        ambient_fit,
    }
}

fn light_terms(
    scene: &Scene,
    [equation, shining]: [&Equation<f64>; 2],
    evaluation: &Evaluation<'_>,
    light: usize,
) -> LightTerms {
    let here = equation.respond_world(light, evaluation.position, evaluation.normal, None);
    let (mut diffuse, mut specular, mut reached) = (Rgb::ZERO, Rgb::ZERO, 0.0);
    for site in &evaluation.points {
        let response = site.respond(shining, light);
        diffuse += site.weight * response.diffuse;
        specular += site.weight * response.specular;
        reached += site.weight * response.reached;
    }
    let left_out = shining.sources_of(light).is_empty();
    let [diffuse_zero, specular_zero] = zero_causes(
        scene,
        [equation, shining],
        evaluation,
        light,
        [diffuse, specular],
    );
    let n_dot_l = evaluation.normal.dot(here.l);
    let flips = scene.reflection.backfacing == Backfacing::Flip && n_dot_l < 0.0;
    let facing = if flips {
        -evaluation.normal
    } else {
        evaluation.normal
    };
    let tint: Rgb = evaluation
        .points
        .iter()
        .map(|site| site.tint * site.weight)
        .sum();
    let color = if equation.has_pattern() {
        equation.pattern_color(evaluation.position)
    } else {
        scene.material.color
    };
    let place = (evaluation.position, evaluation.normal);
    LightTerms {
        kind: scene.lights[light].kind,
        l: here.l,
        r: here.r,
        h: here.h,
        n_dot_l,
        theta: angle(evaluation.normal, here.l),
        phi: angle(here.r, here.v),
        alpha: angle(facing, here.h),
        attenuation: here.attenuation,
        spot: here.spot,
        reflectance: here.reflectance,
        incidence: here.incidence,
        reached: if left_out { 1.0 } else { reached },
        diffuse,
        specular,
        diffuse_zero,
        specular_zero,
        law: equation.law_values(scene, light, place, color * tint),
    }
}

/// Returns the angle between two vectors in radians, exact to rounding for small and for straight angles too (Kahan).
fn angle(a: DVec3, b: DVec3) -> f64 {
    let (a, b) = (a.normalize_or_zero(), b.normalize_or_zero());
    2.0 * (a - b).length().atan2((a + b).length())
}

/// Finds the clearest pixel of a coarse grid, the nearest to the picture's middle: with vectors well apart, or lit, or
/// any.
pub fn clearest_pixel(renderer: &mut Renderer, scene: &Scene) -> Probe {
    let middle = scene.image.size.map(|side| side / 2);
    let mut grid: Vec<[u32; 2]> = middles(scene, SEARCH_GRID).collect();
    grid.dedup();
    let distance = |[x, y]: &[u32; 2]| {
        let (dx, dy) = (
            u64::from(x.abs_diff(middle[0])),
            u64::from(y.abs_diff(middle[1])),
        );
        dx * dx + dy * dy
    };
    grid.sort_by_key(distance);
    let mut best = (
        Clarity::Background,
        Probe {
            pixel: middle,
            hit: None,
            ambient_fit: None,
        },
    );
    for [x, y] in grid {
        let probed = probe(renderer, scene, x, y);
        let clarity = Clarity::of(&probed);
        if clarity > best.0 {
            best = (clarity, probed);
        }
        if best.0 == Clarity::Apart {
            break;
        }
    }
    best.1
}

/// Returns the middles of the cells of a grid of `count` columns and rows over the picture, row by row.
fn middles(scene: &Scene, count: u32) -> impl Iterator<Item = [u32; 2]> {
    let [width, height] = scene.image.size;
    let middles = move |side: u32| (0..count).map(move |i| (2 * i + 1) * side / (2 * count));
    middles(height).flat_map(move |y| middles(width).map(move |x| [x, y]))
}

/// Finds a pixel on the flank of the brightest highlight, where R, V and φ are meaningful: of a grid the one with about
/// half of the maximum; without a highlight the brightest by diffuse light, and none without an object.
pub fn pixel_beside_highlight(renderer: &mut Renderer, scene: &Scene) -> Option<[u32; 2]> {
    let mut found = Vec::new();
    for [x, y] in middles(scene, 24) {
        if let Some(hit) = probe(renderer, scene, x, y).hit {
            let sum = |part: fn(&LightTerms) -> Rgb| -> f64 {
                hit.lights
                    .iter()
                    .map(|light| part(light).max_element())
                    .sum()
            };
            // Towards the outline the vectors lie in one line on the screen.
            let faces = hit.normal.normalize_or_zero().dot(hit.view) > 0.35;
            found.push((
                [x, y],
                faces,
                sum(|light| light.specular),
                sum(|light| light.diffuse),
            ));
        }
    }
    let most = found
        .iter()
        .map(|(.., specular, _)| *specular)
        .fold(0.0, f64::max);
    let worth = |(_, faces, specular, diffuse): &([u32; 2], bool, f64, f64)| {
        let clear = f64::from(*faces);
        if most > 0.02 {
            clear - (specular / most - 0.5).abs()
        } else {
            clear + diffuse
        }
    };
    found
        .iter()
        .max_by(|a, b| worth(a).total_cmp(&worth(b)))
        .map(|(pixel, ..)| *pixel)
}

/// Explanatory value of a drawing at a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Clarity {
    Background,
    /// No light reaches the point.
    Dark,
    Lit,
    /// Lit, near the highlight but not in it: N, L, R and V point in distinct directions.
    Apart,
}

impl Clarity {
    fn of(probed: &Probe) -> Self {
        let Some(hit) = &probed.hit else {
            return Self::Background;
        };
        let Some(light) = hit.lights.iter().find(|light| light.n_dot_l > 0.0) else {
            return Self::Dark;
        };
        let angles = [light.theta, light.phi, hit.normal.angle_between(hit.view)];
        if angles
            .iter()
            .all(|angle| APART.contains(&angle.to_degrees()))
        {
            Self::Apart
        } else {
            Self::Lit
        }
    }
}
