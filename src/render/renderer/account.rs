//! The account of the plan, term by term: how often each was evaluated in the last picture, or why it was left out.
//!
//! A line that counts evaluations is really evaluated, however little it adds. Counts are of a frame in which every stage runs.

use super::frame::{FrameReport, Stage};
use super::pipeline::{PlannedFrame, Renderer};
use super::plan::{Cued, NO_LIGHT, Per, Plan, casts_shadows, not_cued, silences, stiff};
use crate::illumination::{Equation, LawPart, Source, SpecularForm, Unneeded};
use crate::render::face_materials::{any_transmits, for_each_material};
use crate::render::model::Model;
use crate::render::raster::Band;
use crate::scene::{
    AmbientSource, Backfacing, Encoding, FaceMaterial, LightKind, Material, ObjectKind, Overflow,
    PatternKind, Reflectance, Rgb, Scene, Viewer,
};
use crate::text::{Message, text};
use serde::{Serialize, Serializer};
use std::fmt::{self, Display, Formatter};

/// One term of the equation, or one step of a stage.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Term {
    /// The stage that evaluates it.
    pub stage: Stage,
    /// The step of the stage or part of the equation, with its light.
    pub name: TermName,
    /// The frequency of its evaluation.
    pub per: Per,
    /// The number of evaluations in total.
    pub evaluations: u64,
    /// The reason why it is left out.
    pub omitted: Option<Message>,
    /// The part of it that is left out, or the reason why it is not left out where that could be expected.
    pub note: Option<Message>,
}

impl Term {
    fn noted(self, note: Message) -> Self {
        Self {
            note: self.omitted.is_none().then_some(note),
            ..self
        }
    }
}

/// The name of a term: a step of a stage, or a part of the equation, of one light if it has a number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TermName {
    word: Word,
    light: Option<usize>,
}

/// The name of a term.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Word {
    /// A letter of the equation, or a message of the catalogue.
    Known(&'static str),
    /// A part of the scene's own law.
    OfLaw(String),
}

impl TermName {
    /// Returns the light that it belongs to, counted from 0.
    pub fn light(&self) -> Option<usize> {
        self.light
    }

    /// Returns its name among the parts of its light.
    pub fn part(&self) -> &str {
        match &self.word {
            Word::Known(message) if message.starts_with("render-") => text!(message),
            Word::Known(letter) => letter,
            Word::OfLaw(text) => text,
        }
    }
}

impl Display for TermName {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self.light {
            Some(light) => {
                let (light, term) = (light + 1, self.part());
                f.write_str(&text!("render-term-of-light", light = light, term = term))
            }
            None => f.write_str(self.part()),
        }
    }
}

impl Serialize for TermName {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

/// The inputs of the last picture.
struct Account<'a> {
    scene: &'a Scene,
    plan: &'a Plan,
    model: &'a Model,
    report: &'a FrameReport,
    /// The number of the picture's triangles that show their back.
    backs: u64,
    /// The number of colours that flat shading prepares: one for each sequence of runs of one face.
    inks: u64,
    /// The materials of the faces, and the number of evaluations of the equation with each.
    materials: Vec<FaceMaterial>,
    counts: Vec<u64>,
    /// The number of pixels that show each of them.
    pixels: Vec<u64>,
}

impl Renderer {
    /// Returns the terms and steps of the last picture: how often each is evaluated, or why it is left out.
    pub fn terms(&self) -> Vec<Term> {
        let Some(planned) = &self.drawn else {
            return Vec::new();
        };
        let PlannedFrame {
            scene, plan, parts, ..
        } = planned;
        let culled = plan.cull || plan.true_surface;
        let backs = if culled {
            0
        } else {
            self.placed.output.backs(&self.model.output)
        };
        let inks = if plan.carries {
            0
        } else {
            let triangles = self.placed.output.triangles(&self.model.output);
            let count = |band: &Band| band.runs_by_face(&triangles).count() as u64;
            self.bands.output.iter().map(count).sum::<u64>() * parts.len() as u64
        };
        Account {
            scene,
            plan,
            model: &self.model.output,
            report: self.report(),
            backs,
            inks,
            materials: planned.materials.clone(),
            counts: self.counts_of(planned),
            pixels: self.pixels_of(planned),
        }
        .terms()
    }
}

/// Tells why no light is reflected specularly.
fn no_specular(material: &Material) -> Message {
    if material.ks == Rgb::ZERO {
        Message("render-why-ks-zero")
    } else if material.ks * material.specular_color == Rgb::ZERO {
        Message("render-why-ks-os-zero")
    } else {
        Message("render-why-no-specular-colour")
    }
}

/// The reason why the terms of the models that are built in are left out.
const OWN_LAW: Message = Message("render-why-own-law");

const SURFACE: Message = Message("render-why-true-surface");

impl Account<'_> {
    /// Returns all terms and steps, in the order of the stages.
    pub fn terms(&self) -> Vec<Term> {
        let mut shading = [self.equation(), self.interpolation()];
        if self.plan.per == Per::Pixel {
            shading.reverse();
        }
        [
            self.geometry(),
            self.coverage(),
            self.rays(),
            shading.concat(),
            self.display(),
        ]
        .concat()
    }

    fn term(
        &self,
        stage: Stage,
        word: &'static str,
        (per, evaluations): (Per, u64),
        omitted: Option<Message>,
    ) -> Term {
        let (per, evaluations) = if omitted.is_some() {
            (Per::None, 0)
        } else {
            (per, evaluations)
        };
        Term {
            stage,
            name: TermName {
                word: Word::Known(word),
                light: None,
            },
            per,
            evaluations,
            omitted,
            note: None,
        }
    }

    fn geometry(&self) -> Vec<Term> {
        let FrameReport {
            vertices,
            triangles,
            candidates,
            clipped,
            ..
        } = *self.report;
        let backs = self.backs;
        let surface = self.plan.true_surface.then_some(SURFACE);
        let whole = (clipped == 0).then_some(Message("render-why-nothing-clipped"));
        let culled = self.plan.cull.then_some(Message("render-why-closed-solid"));
        let none = (backs == 0).then_some(Message("render-why-no-backs"));
        let mesh = if self.scene.object.kind == ObjectKind::Obj {
            "render-term-model-vertices"
        } else {
            "render-term-tessellation"
        };
        let transform = |name, count, omitted| self.term(Stage::Transform, name, count, omitted);
        vec![
            self.term(Stage::Geometry, mesh, (Per::Vertex, vertices), None),
            self.term(
                Stage::Geometry,
                "render-term-vertex-normals",
                (Per::Vertex, vertices),
                None,
            ),
            transform("render-term-projection", (Per::Vertex, vertices), surface),
            transform("render-term-facing", (Per::Face, triangles), surface),
            transform(
                "render-term-clipping",
                (Per::Face, clipped),
                surface.or(whole),
            ),
            transform(
                "render-term-triangles",
                (Per::Face, candidates - backs.min(candidates)),
                surface,
            )
            .noted(Message("render-why-small-triangles")),
            transform(
                "render-term-back-faces",
                (Per::Face, backs),
                surface.or(culled).or(none),
            ),
        ]
    }

    fn coverage(&self) -> Vec<Term> {
        let (surface, drawn) = (self.plan.true_surface, self.report.drawn);
        let single = (!self.plan.depth_test).then_some(Message("render-why-one-layer"));
        let rays = (!surface).then_some(Message("render-why-polygons-drawn"));
        let hit = surface.then_some(SURFACE);
        let cover =
            |name, count, omitted| self.term(Stage::Coverage, name, (Per::Pixel, count), omitted);
        vec![
            cover("render-term-surface-rays", self.pixels(), rays),
            cover("render-term-coverage", drawn, hit).noted(Message("render-why-by-scan-line")),
            cover("render-term-depth-test", drawn, hit.or(single)),
        ]
    }

    fn rays(&self) -> Vec<Term> {
        let scene = self.scene;
        let (per, points) = self.shading_points();
        let shadows = (!self.plan.shadows).then(|| {
            casts_shadows(scene, self.model, &self.plan.lights)
                .unwrap_or(Message("render-why-no-shadows"))
        });
        let lights = scene
            .lights
            .iter()
            .zip(&self.plan.lights)
            .filter(|(_, kept)| **kept);
        let sources: u64 = lights
            .map(|(light, _)| u64::from(light.sample_count().max(1)))
            .sum();
        let opaque = (!any_transmits(&self.materials)).then_some(Message("render-why-opaque"));
        let clear = self.materials.iter().zip(&self.pixels);
        let clear = clear
            .filter(|(own, _)| own.kt > 0.0)
            .map(|(_, count)| count);
        let plain = (!self.plan.composes).then_some(Message("render-why-plain-background"));
        let constant = (scene.ambient.source == AmbientSource::Constant)
            .then_some(Message("render-why-constant-ambient"));
        let term = |name, count, omitted| self.term(Stage::Rays, name, count, omitted);
        vec![
            term("render-term-shadows", (per, points * sources), shadows)
                .noted(Message("render-why-shadow-rays")),
            term(
                "render-term-transmission",
                (Per::Pixel, clear.sum()),
                opaque,
            ),
            term(
                "render-term-surroundings",
                (
                    Per::Pixel,
                    self.pixels() - self.report.covered.min(self.pixels()),
                ),
                plain,
            ),
            term("render-term-bounce", (Per::Pixel, self.pixels()), constant)
                .noted(Message("render-why-bounce-sampled")),
        ]
    }

    fn equation(&self) -> Vec<Term> {
        let (scene, kept) = (self.scene, !self.plan.leaves_out);
        let count = self.shading_points();
        let term = |name, count, omitted| self.term(self.stage(), name, count, omitted);
        let dark = (!self.plan.lights.contains(&true)).then_some(NO_LIGHT);
        let equations = for_each_material(scene, &self.materials, |scene| {
            let mut equation = Equation::<f64>::new(scene);
            equation.retain_lights(|light| self.plan.lights[light]);
            equation
        });
        let [first, ..] = &self.materials[..] else {
            return vec![];
        };
        let shines = |material: usize| kept || equations[material].form() != SpecularForm::None;
        let no_specular = (!(0..equations.len()).any(shines)).then(|| no_specular(&first.material));
        let each = self.materials.len() as u64;
        let infinite = scene.camera.viewer == Viewer::Infinite;
        let constant =
            (scene.pattern.kind == PatternKind::None).then_some(Message("render-why-no-pattern"));
        let own = scene.reflection.is_own_law().then_some(OWN_LAW);
        let clamped = (scene.reflection.backfacing == Backfacing::Clamp)
            .then_some(Message("render-why-back-clamped"));
        let black = |own: &FaceMaterial| {
            own.material.ka * own.material.color * scene.ambient.color == Rgb::ZERO
        };
        let no_ambient = match scene.ambient.source {
            AmbientSource::Bounce => Some(Message("render-why-bounce-instead")),
            _ if constant.is_some() && self.materials.iter().all(black) => {
                Some(Message("render-why-ka-zero"))
            }
            _ => None,
        };
        let unit =
            (self.plan.per != Per::Pixel).then_some(Message("render-why-unit-by-construction"));
        let short = (!self.plan.renormalise).then_some(Message("render-why-switched-off"));
        let mut terms = vec![
            term("render-term-normalise", count, unit.or(short)),
            term("render-term-position", count, None),
            term(
                "V",
                if infinite {
                    (Per::Frame, each)
                } else {
                    self.points_of(shines)
                },
                dark.or(no_specular),
            ),
            term("render-term-pattern", count, constant),
            term(
                "render-term-ambient",
                if constant.is_some() {
                    (Per::Frame, each)
                } else {
                    count
                },
                no_ambient,
            ),
            term("render-term-flip", count, dark.or(own).or(clamped)),
        ];
        if self.plan.true_surface {
            terms[0] = terms[0]
                .clone()
                .noted(Message("render-why-unit-but-rounding"));
        }
        if self.model.is_tinted() {
            terms.push(term("render-term-vertex-colours", count, None));
        }
        let enough = (!self.plan.double).then_some(Message("render-why-single-precision"));
        let stiff = stiff(scene, self.model).unwrap_or(Message("render-why-polygons-exact"));
        terms.push(term("render-term-double-precision", count, enough).noted(stiff));
        for light in 0..scene.lights.len() {
            terms.extend(self.light(light, &equations, no_specular));
        }
        terms.extend(self.law(&equations));
        terms
    }

    /// Returns the operations of the scene's own law, by the parts of its text, of all lights together.
    fn law(&self, equations: &[Equation<f64>]) -> Vec<Term> {
        let (per, _) = self.shading_points();
        let mut parts: Vec<(&LawPart, [u64; 4])> = vec![];
        for (material, equation) in equations.iter().enumerate() {
            let (_, points) = self.points_of(|own| own == material);
            let sources = equation.sources.len() as u64;
            let times = [1, sources, points, points * sources];
            for part in equation.law_parts().unwrap_or_default() {
                let own = std::array::from_fn(|rate| u64::from(part.counts[rate]) * times[rate]);
                match parts.iter_mut().find(|(known, _)| known.text == part.text) {
                    Some((_, counts)) => counts
                        .iter_mut()
                        .zip(own)
                        .for_each(|(all, own)| *all += own),
                    None => parts.push((part, own)),
                }
            }
        }
        let mut terms = vec![];
        for (part, counts) in parts {
            let mut term = |count, omitted| {
                terms.push(Term {
                    name: TermName {
                        word: Word::OfLaw(part.text.clone()),
                        light: None,
                    },
                    ..self.term(self.stage(), "", count, omitted)
                });
            };
            match part.unneeded {
                Some(Unneeded::WithoutEffect) => {
                    term((per, 0), Some(Message("render-why-changes-nothing")));
                }
                Some(Unneeded::Unused) => term((per, 0), Some(Message("render-why-unused"))),
                None => {
                    let rates = [Per::Frame, Per::Light, per, per].into_iter().zip(counts);
                    rates
                        .filter(|(_, count)| *count > 0)
                        .for_each(|count| term(count, None));
                }
            }
        }
        terms
    }

    fn light(
        &self,
        index: usize,
        equations: &[Equation<f64>],
        no_specular: Option<Message>,
    ) -> Vec<Term> {
        let (scene, kept, equation) = (self.scene, !self.plan.leaves_out, &equations[0]);
        let light = &scene.lights[index];
        let sources = &equation.sources[equation.sources_of(index)];
        let silent = silences(scene, self.model)[index].filter(|_| !self.plan.lights[index]);
        let (per, points) = self.shading_points();
        let times = sources.len() as u64;
        let each = (per, points * times);
        let term = |word, count, omitted: Option<Message>| Term {
            name: TermName {
                word: Word::Known(word),
                light: Some(index),
            },
            ..self.term(self.stage(), word, count, silent.or(omitted))
        };
        let parallel = sources.iter().all(Source::is_parallel);
        let attenuates = kept || sources.iter().any(Source::attenuates);
        let colour = if scene.pattern.kind == PatternKind::None {
            Rgb::ZERO
        } else {
            scene.pattern.color
        };
        let materials = &self.materials;
        let diffuses = |material: usize| {
            let own = &materials[material].material;
            kept || own.kd * (own.color + colour) != Rgb::ZERO
        };
        let shines = |material: usize| kept || equations[material].form() != SpecularForm::None;
        let by_angle = |material: usize| {
            shines(material) && materials[material].material.reflectance != Reflectance::Constant
        };
        let times_points = |holds: &dyn Fn(usize) -> bool| {
            let (per, points) = self.points_of(holds);
            (per, points * times)
        };
        let matt = !(0..materials.len()).any(diffuses);
        let matt = matt.then_some(
            if materials.iter().all(|own| own.material.kd == Rgb::ZERO) {
                Message("render-why-kd-zero")
            } else {
                Message("render-why-kd-od-zero")
            },
        );
        let own = scene.reflection.is_own_law().then_some(OWN_LAW);
        let (matt, no_specular) = (own.or(matt), own.or(no_specular));
        let spot = (light.kind != LightKind::Spot).then_some(Message("render-why-no-spotlight"));
        let law = materials
            .iter()
            .all(|own| own.material.reflectance == Reflectance::Constant)
            .then_some(Message("render-why-constant-reflectance"));
        vec![
            term("L", if parallel { (Per::Frame, times) } else { each }, None),
            term(
                "render-term-attenuation",
                each,
                (!attenuates).then_some(Message("render-why-constant-attenuation")),
            ),
            term("render-term-cone", each, spot),
            term("N·L", each, own).noted(Message("render-why-sign-of-n-l")),
            term("render-term-diffuse", times_points(&diffuses), matt),
            term("render-term-specular", times_points(&shines), no_specular)
                .noted(Message("render-why-specular-skipped")),
            term("W(θ)", times_points(&by_angle), no_specular.or(law)),
        ]
    }

    fn interpolation(&self) -> Vec<Term> {
        let (plan, covered) = (self.plan, self.report.covered);
        let surface = plan.true_surface.then_some(SURFACE);
        let flat = (!plan.carries).then_some(Message("render-why-one-colour-face"));
        let double = plan
            .pixels_in_double()
            .then_some(Message("render-why-pixels-in-double"));
        let none = surface.or(flat).or(double);
        let linear = (!plan.perspective).then_some(Message("render-why-linear-in-picture"));
        let shortened = (plan.per == Per::Pixel && plan.renormalise)
            .then_some(Message("render-why-n-renormalised"));
        let fading = match plan.cued {
            Cued::Nowhere | Cued::AtPoints => self.shading_points(),
            Cued::AtVertices => (Per::Vertex, self.report.vertices),
            Cued::AtPixels => (Per::Pixel, covered),
        };
        let uncued = (plan.cued == Cued::Nowhere).then(|| {
            not_cued(self.scene, self.model).unwrap_or(Message("render-why-switched-off"))
        });
        let term = |name, count, omitted| self.term(Stage::Interpolation, name, count, omitted);
        vec![
            term("render-term-interpolated", (Per::Pixel, covered), none),
            term(
                "render-term-perspective",
                (Per::Pixel, covered),
                none.or(linear).or(shortened),
            ),
            term("render-term-depth-cueing", fading, uncued),
        ]
    }

    fn display(&self) -> Vec<Term> {
        let (plan, display) = (self.plan, &self.scene.display);
        let points = if plan.carries {
            self.report.covered
        } else {
            self.inks
        };
        let per = if plan.carries || plan.whole_picture {
            Per::Pixel
        } else {
            Per::Face
        };
        let count = if plan.whole_picture {
            self.pixels()
        } else {
            points
        };
        let raw = (display.encoding == Encoding::Raw).then_some(Message("render-why-raw-encoding"));
        let clamped =
            (display.overflow == Overflow::Clamp).then_some(Message("render-why-overflow-clamped"));
        let single = (!plan.whole_picture).then_some(Message("render-why-stored-at-once"));
        let mixed = (!plan.composes).then_some(Message("render-why-equation-only"));
        let by_faces = (per == Per::Face).then_some(Message("render-why-once-per-polygon"));
        let term = |name, count, omitted| self.term(Stage::Display, name, count, omitted);
        vec![
            term("render-term-mixing", (Per::Pixel, self.pixels()), mixed),
            term(
                "render-term-linear-picture",
                (Per::Pixel, self.pixels()),
                single,
            ),
            term("render-term-overflow", (Per::Pixel, self.pixels()), clamped),
            term("render-term-srgb", (per, count), raw).noted(Message("render-why-by-formula")),
            Term {
                note: by_faces,
                ..term("render-term-rounding", (per, count), None)
            },
        ]
    }

    fn stage(&self) -> Stage {
        if self.plan.per == Per::Pixel {
            Stage::PixelShading
        } else {
            Stage::VertexShading
        }
    }

    /// Returns the frequency of the equation's evaluation, and the number of evaluations with materials for which `holds` does.
    fn points_of(&self, holds: impl Fn(usize) -> bool) -> (Per, u64) {
        let counts = self.counts.iter().enumerate();
        let points = counts
            .filter(|(material, _)| holds(*material))
            .map(|(_, count)| count);
        (self.plan.per, points.sum())
    }

    /// Returns the frequency of the equation's evaluation, and the number of evaluations.
    fn shading_points(&self) -> (Per, u64) {
        let points = match self.plan.per {
            Per::Pixel => self.report.covered,
            _ => self.report.points,
        };
        (self.plan.per, points)
    }

    fn pixels(&self) -> u64 {
        self.scene
            .image
            .size
            .iter()
            .map(|side| u64::from(*side))
            .product()
    }
}
