//! Explains the plan term by term: how often each was evaluated in the last picture, or why it was left out.
//!
//! A line that counts evaluations is really evaluated, however little it adds. Counts are of a frame in which every stage runs.

use super::frame::{Report, Stage};
use super::plan::{Cued, NO_LIGHT, Per, Plan, casts_shadows, not_cued, silences, stiff};
use crate::illumination::{Equation, SpecularForm};
use crate::render::model::Model;
use crate::scene::{
    AmbientSource, Backfacing, Encoding, LightKind, Material, ObjectKind, Overflow, PatternKind,
    Reflectance, Rgb, Scene, Viewer,
};
use serde::Serialize;

/// One term of the equation, or one step of a stage.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Term {
    pub stage: Stage,
    pub name: String,
    /// How often it is evaluated.
    pub per: Per,
    /// How many times in all.
    pub evaluations: u64,
    /// Why it is left out.
    pub omitted: Option<&'static str>,
    /// What is left out of it, or why it is not left out where that could be expected.
    pub note: Option<&'static str>,
}

impl Term {
    fn noted(self, note: &'static str) -> Self {
        Self {
            note: self.omitted.is_none().then_some(note),
            ..self
        }
    }
}

/// What the last picture was drawn from.
pub struct Account<'a> {
    pub scene: &'a Scene,
    pub plan: &'a Plan,
    pub model: &'a Model,
    pub report: &'a Report,
    /// Triangles of the picture that show their back.
    pub backs: u64,
    /// Colours that flat shading makes ready: one for each triangle's runs that follow each other.
    pub inks: u64,
}

/// Why no light is reflected specularly.
fn no_specular(material: &Material) -> &'static str {
    if material.ks == Rgb::ZERO {
        "Ks is 0"
    } else if material.ks * material.specular_color == Rgb::ZERO {
        "Ks·Os is 0"
    } else {
        "no light has a colour that Ks·Os reflects"
    }
}

const SURFACE: &str = "rays meet the true surface";

impl Account<'_> {
    /// All terms and steps, in the order of the stages.
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
        name: &str,
        (per, evaluations): (Per, u64),
        omitted: Option<&'static str>,
    ) -> Term {
        let (per, evaluations) = if omitted.is_some() {
            (Per::None, 0)
        } else {
            (per, evaluations)
        };
        Term {
            stage,
            name: name.to_owned(),
            per,
            evaluations,
            omitted,
            note: None,
        }
    }

    fn geometry(&self) -> Vec<Term> {
        let Report {
            vertices,
            triangles,
            candidates,
            clipped,
            ..
        } = *self.report;
        let backs = self.backs;
        let surface = self.plan.true_surface.then_some(SURFACE);
        let whole = (clipped == 0).then_some("nothing in sight crosses the near plane");
        let culled = self.plan.cull.then_some("a closed solid hides them");
        let none = (backs == 0).then_some("none is in the picture");
        let mesh = if self.scene.object.kind == ObjectKind::Obj {
            "vertices of the model"
        } else {
            "tessellation"
        };
        let transform = |name, count, omitted| self.term(Stage::Transform, name, count, omitted);
        vec![
            self.term(Stage::Geometry, mesh, (Per::Vertex, vertices), None),
            self.term(
                Stage::Geometry,
                "vertex normals",
                (Per::Vertex, vertices),
                None,
            ),
            transform("to the picture", (Per::Vertex, vertices), surface),
            transform("which side is seen", (Per::Face, triangles), surface),
            transform("clipping", (Per::Face, clipped), surface.or(whole)),
            transform(
                "triangles",
                (Per::Face, candidates - backs.min(candidates)),
                surface,
            )
            .noted("those without a pixel's centre in their bounds are dropped"),
            transform(
                "back faces",
                (Per::Face, backs),
                surface.or(culled).or(none),
            ),
        ]
    }

    fn coverage(&self) -> Vec<Term> {
        let (surface, drawn) = (self.plan.true_surface, self.report.drawn);
        let single = (!self.plan.depth_test).then_some("a convex solid shows one layer");
        let rays = (!surface).then_some("polygons stand for the surface");
        let hit = surface.then_some(SURFACE);
        let cover =
            |name, count, omitted| self.term(Stage::Coverage, name, (Per::Pixel, count), omitted);
        vec![
            cover("rays to the surface", self.pixels(), rays),
            cover("coverage", drawn, hit)
                .noted("by scan line: only pixels inside a triangle are visited"),
            cover("depth test", drawn, hit.or(single)),
        ]
    }

    fn rays(&self) -> Vec<Term> {
        let scene = self.scene;
        let (per, points) = self.shading_points();
        let shadows = (!self.plan.shadows).then(|| {
            casts_shadows(scene, self.model, &self.plan.lights).unwrap_or("nothing casts a shadow")
        });
        let lights = scene
            .lights
            .iter()
            .zip(&self.plan.lights)
            .filter(|(_, kept)| **kept);
        let sources: u64 = lights
            .map(|(light, _)| u64::from(light.sample_count().max(1)))
            .sum();
        let opaque = (scene.transparency.kt == 0.0).then_some("Kt is 0");
        let plain = (!self.plan.composes).then_some("the background is plain");
        let constant =
            (scene.ambient.source == AmbientSource::Constant).then_some("Ia is constant");
        let term = |name, count, omitted| self.term(Stage::Rays, name, count, omitted);
        vec![
            term("shadows", (per, points * sources), shadows)
                .noted("one question a source; rays that are proven free are not followed"),
            term("transmission", (Per::Pixel, self.report.covered), opaque),
            term(
                "surroundings",
                (
                    Per::Pixel,
                    self.pixels() - self.report.covered.min(self.pixels()),
                ),
                plain,
            ),
            term("one bounce", (Per::Pixel, self.pixels()), constant)
                .noted("gathered at some of the pixels and carried to the others"),
        ]
    }

    /// The equation, wherever it is evaluated.
    fn equation(&self) -> Vec<Term> {
        let (scene, kept) = (self.scene, !self.plan.leaves_out);
        let count = self.shading_points();
        let term = |name: &str, count, omitted| self.term(self.stage(), name, count, omitted);
        let dark = (!self.plan.lights.contains(&true)).then_some(NO_LIGHT);
        let mut equation = Equation::<f64>::new(scene);
        equation.retain_lights(|light| self.plan.lights[light]);
        let no_specular =
            (equation.form() == SpecularForm::None && !kept).then(|| no_specular(&scene.material));
        let infinite = scene.camera.viewer == Viewer::Infinite;
        let constant = (scene.pattern.kind == PatternKind::None).then_some("one colour everywhere");
        let clamped = (scene.reflection.backfacing == Backfacing::Clamp)
            .then_some("surfaces turned away get none");
        let unit = (self.plan.per != Per::Pixel).then_some("unit vectors by construction");
        let short = (!self.plan.renormalise).then_some("switched off");
        let mut terms = vec![
            term("N of unit length", count, unit.or(short)),
            term("place of the point", count, None),
            term(
                "V",
                if infinite { (Per::Frame, 1) } else { count },
                dark.or(no_specular),
            ),
            term("pattern", count, constant),
            term(
                "ambient",
                if constant.is_some() {
                    (Per::Frame, 1)
                } else {
                    count
                },
                None,
            ),
            term("turning N to the light", count, dark.or(clamped)),
        ];
        if self.plan.true_surface {
            terms[0] = terms[0]
                .clone()
                .noted("of unit length but for a rounding, which could turn a code value");
        }
        if constant.is_some()
            && scene.material.ka * scene.material.color * scene.ambient.color == Rgb::ZERO
        {
            terms[4] = term("ambient", count, Some("Ka·Od·Ia is 0"));
        }
        if scene.ambient.source == AmbientSource::Bounce {
            terms[4] = term("ambient", count, Some("one bounce takes its place"));
        }
        let enough = (!self.plan.double).then_some("single precision does");
        let stiff = stiff(scene, self.model)
            .unwrap_or("polygons are all there is of the object: shown exactly");
        terms.push(term("double precision", count, enough).noted(stiff));
        for light in 0..scene.lights.len() {
            terms.extend(self.light(light, &equation, no_specular));
        }
        terms
    }

    /// What the equation asks of one light.
    fn light(
        &self,
        index: usize,
        equation: &Equation<f64>,
        no_specular: Option<&'static str>,
    ) -> Vec<Term> {
        let (scene, kept) = (self.scene, !self.plan.leaves_out);
        let light = &scene.lights[index];
        let sources = &equation.sources[equation.sources_of(index)];
        let silent = silences(scene, self.model)[index].filter(|_| !self.plan.lights[index]);
        let (per, points) = self.shading_points();
        let times = sources.len() as u64;
        let each = (per, points * times);
        let term = |what: &str, count, omitted: Option<&'static str>| {
            self.term(
                self.stage(),
                &format!("light {}: {what}", index + 1),
                count,
                silent.or(omitted),
            )
        };
        let parallel = sources.iter().all(crate::illumination::Source::is_parallel);
        let attenuates = kept || sources.iter().any(crate::illumination::Source::attenuates);
        let colour = if scene.pattern.kind == PatternKind::None {
            Rgb::ZERO
        } else {
            scene.pattern.color
        };
        let matt = scene.material.kd * (scene.material.color + colour) == Rgb::ZERO && !kept;
        let matt = matt.then_some(if scene.material.kd == Rgb::ZERO {
            "Kd is 0"
        } else {
            "Kd·Od is 0"
        });
        let spot = (light.kind != LightKind::Spot).then_some("it is no spot light");
        let law = (scene.material.reflectance == Reflectance::Constant).then_some("it is constant");
        vec![
            term("L", if parallel { (Per::Frame, times) } else { each }, None),
            term("attenuation", each, (!attenuates).then_some("f is the same everywhere")),
            term("cone", each, spot),
            term("N·L", each, None).noted("evaluated also where the light is behind: its sign tells"),
            term("diffuse", each, matt),
            term("specular", each, no_specular).noted(
                "skipped where N·L ≤ 0 in a whole vector of points, and the power where it changes no sum in single \
                 precision; what is less than half a code value is kept, since it could turn one",
            ),
            term("W(θ)", each, no_specular.or(law)),
        ]
    }

    fn interpolation(&self) -> Vec<Term> {
        let (plan, covered) = (self.plan, self.report.covered);
        let surface = plan.true_surface.then_some(SURFACE);
        let flat = (!plan.carries).then_some("a face has one colour");
        let double = plan
            .pixels_in_double()
            .then_some("each pixel is evaluated in double precision");
        let none = surface.or(flat).or(double);
        let linear = (!plan.perspective).then_some("interpolation is linear in the picture");
        let shortened = (plan.per == Per::Pixel && plan.renormalise)
            .then_some("N is made a unit vector all the same");
        let fading = match plan.cued {
            Cued::Nowhere | Cued::AtPoints => self.shading_points(),
            Cued::AtVertices => (Per::Vertex, self.report.vertices),
            Cued::AtPixels => (Per::Pixel, covered),
        };
        let uncued = (plan.cued == Cued::Nowhere)
            .then(|| not_cued(self.scene, self.model).unwrap_or("switched off"));
        let term = |name, count, omitted| self.term(Stage::Interpolation, name, count, omitted);
        vec![
            term("carried to the pixels", (Per::Pixel, covered), none),
            term(
                "division by depth",
                (Per::Pixel, covered),
                none.or(linear).or(shortened),
            ),
            term("depth cueing", fading, uncued),
        ]
    }

    fn display(&self) -> Vec<Term> {
        let (plan, display) = (self.plan, &self.scene.display);
        let points = if plan.carries {
            self.report.covered
        } else {
            self.inks
        };
        let (per, points) = if plan.carries || plan.whole_picture {
            (Per::Pixel, points)
        } else {
            (Per::Face, points)
        };
        let count = if plan.whole_picture {
            self.pixels()
        } else {
            points
        };
        let raw = (display.encoding == Encoding::Raw).then_some("raw: value × 255");
        let clamped = (display.overflow == Overflow::Clamp).then_some("values above 1 are clamped");
        let single = (!plan.whole_picture).then_some("each pixel is stored as it is shaded");
        let mixed = (!plan.composes).then_some("the picture is the equation's alone");
        let by_faces =
            (per == Per::Face).then_some("once for each triangle in sight, in each band of rows");
        let term = |name, count, omitted| self.term(Stage::Display, name, count, omitted);
        vec![
            term("mixing", (Per::Pixel, self.pixels()), mixed),
            term("picture kept linear", (Per::Pixel, self.pixels()), single),
            term("overflow", (Per::Pixel, self.pixels()), clamped),
            term("sRGB encoding", (per, count), raw).noted("by its formula: no table is needed"),
            Term {
                note: by_faces,
                ..term("rounding to code values", (per, count), None)
            },
        ]
    }

    /// The stage that evaluates the equation.
    fn stage(&self) -> Stage {
        if self.plan.per == Per::Pixel {
            Stage::PixelShading
        } else {
            Stage::VertexShading
        }
    }

    /// How often the equation is evaluated, and how many times.
    fn shading_points(&self) -> (Per, u64) {
        let Report {
            points, covered, ..
        } = *self.report;
        (
            self.plan.per,
            if self.plan.per == Per::Pixel {
                covered
            } else {
                points
            },
        )
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
