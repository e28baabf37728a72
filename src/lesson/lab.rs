//! The engine behind a lesson: what its expressions ask of a scene.
//!
//! The quantities are what the analyses print for programs, under the names of their commands. Pictures are drawn for them with
//! at most [`Lab::SIDE`] pixels at the shorter side, so that a step is ready while its text is being read.

use super::Staged;
use super::budget::{Account, Budget, TooHeavy, triangles_of};
use crate::analysis::comparison::{LinearPicture, error_figures};
use crate::analysis::conditions::ConditionsQuestion;
use crate::analysis::curves::highlight_half_width;
use crate::analysis::defects::DefectsQuestion;
use crate::analysis::perception::luminance;
use crate::analysis::plan::PlanQuestion;
use crate::analysis::probe::{Probe, Probed, probe};
use crate::analysis::profile::{Profile, ProfileQuestion, profile};
use crate::analysis::{Answer, Question, ReportContext, Subject, unwatched};
use crate::expression::{Expression, Part, Quantities, Todo, Value};
use crate::geometry::Mesh;
use crate::render::{Frame, Renderer};
use crate::scene::{ReflectionModel, Rgb, Scene, ShadingMode, pixel_to_place, place_to_pixel};
use crate::text::{excerpt, text};
use glam::DVec2;
use serde_json::{Value as Json, json};
use std::cell::{Cell, RefCell};
use std::collections::HashMap;
use std::fmt;
use std::sync::Arc;

/// The scenes of a step, with the answers of the engine about them.
pub struct Lab {
    model: Option<Arc<Mesh>>,
    inner: RefCell<Inner>,
    account: RefCell<Account>,
    /// The step's probe, and whether it was measured.
    probe: Option<DVec2>,
    probe_measured: Cell<bool>,
}

struct Inner {
    renderer: Renderer,
    scenes: Vec<Arc<Scene>>,
    /// The one that the renderer has drawn last.
    drawn: Option<usize>,
    /// The scene that settings make of another one.
    derived: HashMap<(usize, String), usize>,
    known: HashMap<String, Arc<Json>>,
}

impl fmt::Debug for Lab {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Lab").finish_non_exhaustive()
    }
}

/// A scene of a lab with a probe and a line, at which quantities are taken.
#[derive(Clone, Copy, Debug)]
pub struct LabPlace<'l> {
    lab: &'l Lab,
    scene: usize,
    probe: Option<DVec2>,
    line: Option<[DVec2; 2]>,
    /// The abscissa of a curve.
    x: Option<f64>,
}

/// The quantities that there are.
const QUANTITIES: [&str; 9] = [
    "probe",
    "profile",
    "conditions",
    "defects",
    "explain",
    "error",
    "beside_phong",
    "picture",
    "scene",
];

/// The work of analyses, in pictures: of a profile for each mode, and of all the others.
const PROFILE: u64 = 2;
const CONDITIONS: u64 = 10;
const DEFECTS: u64 = 40;
const EXPLAIN: u64 = 90;
/// The work of a defect at each of a mesh's triangles, and of how many at most an even choice is measured.
const DEFECT: u64 = 240_000;
const MEASURED: u64 = 4096;
/// The work of a probe where the picture is drawn.
const PROBE: u64 = 20_000;
/// The work of an operation of an expression, and of an entry of a list.
const OPERATION: u64 = 32;
/// The work of an operation of a formula at a point.
const FORMULA: u64 = 8;
/// The work of another scene, which bounds how many are kept; of putting a setting into it, and of each letter of that.
const SCENE: u64 = 300_000;
const SETTING: u64 = 10_000;
const LETTER: u64 = 32;

fn no_clock() -> u64 {
    0
}

impl Lab {
    /// The shorter side of its pictures, pixels; smaller ones stay as they are.
    pub const SIDE: u32 = 480;
    /// The most answers that are kept: those of single pixels are many.
    const KEPT: usize = 2000;

    /// Creates a lab with the scene of a step, which may do the work of a file.
    pub fn new(staged: &Staged) -> Self {
        Self::within(staged, &Budget::of_file())
    }

    /// Creates a lab with the scene of a step, whose work is counted against that of the lesson's file.
    pub fn within(staged: &Staged, budget: &Budget) -> Self {
        let mut scene = staged.scene.clone();
        let [width, height] = scene.image.size;
        let shorter = width.min(height).max(1);
        if shorter > Self::SIDE {
            let scaled = |side: u32| {
                ((u64::from(side) * u64::from(Self::SIDE) / u64::from(shorter)) as u32)
                    .min(4 * Self::SIDE)
            };
            scene.image.size = [scaled(width), scaled(height)];
        }
        let renderer = Renderer::with_clock(no_clock).with_model(staged.model.clone());
        Self {
            model: staged.model.clone(),
            inner: RefCell::new(Inner {
                renderer,
                scenes: vec![Arc::new(scene)],
                drawn: None,
                derived: HashMap::new(),
                known: HashMap::new(),
            }),
            account: RefCell::new(Account::new(budget.clone())),
            probe: staged.shown.probe,
            probe_measured: Cell::new(false),
        }
    }

    /// Returns whether a number was taken at the step's probe.
    pub fn probe_measured(&self) -> bool {
        self.probe_measured.get()
    }

    /// Counts the work that follows against another budget, as a step of its own.
    pub(super) fn bill(&self, budget: &Budget) {
        self.account.replace(Account::new(budget.clone()));
    }

    /// Returns the work done so far, as [`Budget`] counts it.
    pub fn work(&self) -> u64 {
        self.account.borrow().spent()
    }

    /// Returns why no more work is done.
    pub fn refused(&self) -> Option<TooHeavy> {
        self.account.borrow().refused()
    }

    fn spend(&self, work: u64) -> Result<(), String> {
        let spent = self.account.borrow_mut().spend(work);
        spent.map_err(|refused| refused.to_string())
    }

    fn spend_pictures(&self, scene: &Scene, times: u64) -> Result<(), String> {
        let model = self.model.as_deref();
        let spent = self
            .account
            .borrow_mut()
            .spend_pictures(scene, model, times);
        spent.map_err(|refused| refused.to_string())
    }

    /// Lets the renderer, which has the model of the step, draw its scene or its panes with so many samples a pixel.
    ///
    /// # Errors
    /// More work than there may be.
    pub(super) fn with_renderer<T>(
        &self,
        samples: u32,
        draw: impl FnOnce(&mut Renderer, &Scene) -> T,
    ) -> Result<T, String> {
        let scene = Arc::clone(&self.inner.borrow().scenes[0]);
        for pane in 0..=scene.compare.panes.len() {
            let pane = scene.pane(pane).map_err(|error| error.to_string())?;
            // One more for the figures in the captions.
            self.spend_pictures(&pane, u64::from(samples) + 1)?;
        }
        let inner = &mut *self.inner.borrow_mut();
        inner.drawn = None;
        Ok(draw(&mut inner.renderer, &scene))
    }

    /// Returns the step's scene with its probe and line.
    pub fn place(&self, staged: &Staged) -> LabPlace<'_> {
        LabPlace {
            lab: self,
            scene: 0,
            probe: staged.shown.probe,
            line: staged.shown.line,
            x: None,
        }
    }
}

impl LabPlace<'_> {
    /// Returns the scene.
    pub fn scene(&self) -> Arc<Scene> {
        Arc::clone(&self.lab.inner.borrow().scenes[self.scene])
    }

    /// Goes to the scene with other settings.
    ///
    /// # Errors
    /// Settings that it does not have.
    pub fn under(self, settings: &[String]) -> Result<Self, String> {
        if settings.is_empty() {
            return Ok(self);
        }
        let key = (self.scene, settings.join(";"));
        let known = self.lab.inner.borrow().derived.get(&key).copied();
        if let Some(scene) = known {
            return Ok(Self { scene, ..self });
        }
        let text = settings.iter().map(String::len).sum::<usize>() as u64;
        self.lab
            .spend(SCENE + SETTING * settings.len() as u64 + LETTER * text)?;
        let size = self.scene().image.size;
        let mut made = self
            .scene()
            .with_overrides(settings)
            .map_err(|error| error.to_string())?;
        made.image.size = size;
        let mut inner = self.lab.inner.borrow_mut();
        let scene = inner.scenes.len();
        inner.scenes.push(Arc::new(made));
        inner.derived.insert(key, scene);
        Ok(Self { scene, ..self })
    }

    /// Moves the probe.
    #[must_use]
    pub fn probing(self, place: DVec2) -> Self {
        Self {
            probe: Some(place),
            ..self
        }
    }

    /// Goes to an abscissa of a curve.
    #[must_use]
    pub(super) fn over(self, x: f64) -> Self {
        Self { x: Some(x), ..self }
    }

    /// Returns the place of a pixel's centre.
    pub(super) fn place_of(&self, [x, y]: [u32; 2]) -> DVec2 {
        let centre = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
        pixel_to_place(centre, self.size())
    }

    /// Returns the size of the picture, in pixels.
    pub(super) fn size(&self) -> DVec2 {
        DVec2::from_array(self.scene().image.size.map(f64::from))
    }

    /// Returns the pixel of a place; none outside the picture.
    pub(super) fn pixel(&self, place: DVec2) -> Option<[u32; 2]> {
        let size = self.size();
        let at = place_to_pixel(place, size).floor();
        let inside = at.cmpge(DVec2::ZERO).all() && at.cmplt(size).all();
        inside.then_some([at.x as u32, at.y as u32])
    }

    /// Evaluates an expression, whose operations count as work.
    pub(super) fn number(&self, expression: &Expression) -> Result<f64, String> {
        self.lab.spend(OPERATION * expression.size() as u64)?;
        expression.number(self)
    }

    /// Counts so many operations of formulas as work.
    pub(super) fn spend_operations(&self, count: usize) -> Result<(), String> {
        self.lab.spend(FORMULA * count as u64)
    }

    /// Returns why no more work is done.
    pub(super) fn refused(&self) -> Option<TooHeavy> {
        self.lab.refused()
    }

    /// Calls `draw` with the renderer and the scene, at the work of so many pictures.
    fn render<T>(
        &self,
        pictures: u64,
        draw: impl FnOnce(&mut Renderer, &Scene) -> T,
    ) -> Result<T, String> {
        let scene = self.scene();
        self.lab.spend_pictures(&scene, pictures)?;
        let inner = &mut *self.lab.inner.borrow_mut();
        inner.drawn = Some(self.scene);
        Ok(draw(&mut inner.renderer, &scene))
    }

    /// Draws the linear intensities of every pixel; the fourth component is 0 where there is no object.
    pub(super) fn linear(&self) -> Result<Vec<[f32; 4]>, String> {
        self.render(1, |renderer, scene| renderer.linear_picture(scene))
    }

    /// Draws the picture as it is shown.
    pub(crate) fn counted_picture(&self) -> Result<Frame, String> {
        self.render(1, |renderer, scene| renderer.render(scene).clone())
    }

    /// Draws the picture as it is shown, whatever work that is.
    pub fn picture(&self) -> Frame {
        let scene = self.scene();
        let inner = &mut *self.lab.inner.borrow_mut();
        inner.drawn = Some(self.scene);
        inner.renderer.render(&scene).clone()
    }

    /// Takes the profile along the line in some modes.
    pub(super) fn profile(&self, modes: &[ShadingMode]) -> Result<Profile, String> {
        let question = self.profile_question(modes)?;
        let draw = |renderer: &mut Renderer, scene: &Scene| profile(renderer, scene, &question);
        let profile = self.render(PROFILE * modes.len() as u64, draw)?;
        profile.map_err(|error| error.to_string())
    }

    fn profile_question(&self, modes: &[ShadingMode]) -> Result<ProfileQuestion, String> {
        let line = self
            .line
            .ok_or_else(|| text!("lesson-no-line").to_owned())?;
        let size = self.size();
        let [from, to] = line.map(|place| place_to_pixel(place, size).clamp(DVec2::ZERO, size));
        Ok(ProfileQuestion {
            modes: modes.to_vec(),
            ..ProfileQuestion::new(from, to)
        })
    }

    /// Prepares the scene for an analysis at the work of so many pictures.
    fn subject(&self, pictures: u64) -> Result<Subject, String> {
        let scene = self.scene();
        self.lab.spend_pictures(&scene, pictures)?;
        Ok(Subject {
            scene: Scene::clone(&scene),
            model: self.lab.model.clone(),
            clock: no_clock,
        })
    }

    /// Returns the JSON of an analysis, kept for the next time.
    fn known(&self, name: &str) -> Result<Arc<Json>, String> {
        let place = match name {
            "probe" => {
                let place = self
                    .probe
                    .ok_or_else(|| text!("lesson-no-probe").to_owned())?;
                if self.lab.probe == Some(place) {
                    self.lab.probe_measured.set(true);
                }
                let pixel = self.pixel(place);
                let [x, y] = pixel.ok_or_else(|| text!("lesson-probe-outside").to_owned())?;
                format!("{x},{y}")
            }
            "profile" => format!("{:?}", self.line),
            _ => String::new(),
        };
        let key = format!("{name} {} {place}", self.scene);
        if let Some(known) = self.lab.inner.borrow().known.get(&key) {
            return Ok(Arc::clone(known));
        }
        let found = Arc::new(self.find(name)?);
        let known = &mut self.lab.inner.borrow_mut().known;
        if known.len() >= Lab::KEPT {
            known.clear();
        }
        known.insert(key, Arc::clone(&found));
        Ok(found)
    }

    /// Probes a pixel. Where the picture of another scene was drawn last, what is drawn anew counts.
    fn probed(&self, [x, y]: [u32; 2]) -> Result<Probe, String> {
        let (scene, model) = (self.scene(), self.lab.model.as_deref());
        let inner = &mut *self.lab.inner.borrow_mut();
        let account = &mut *self.lab.account.borrow_mut();
        let drawn = inner.drawn == Some(self.scene);
        if !drawn {
            let afforded = account.afford(&scene, model);
            afforded.map_err(|refused| refused.to_string())?;
        }
        let probe = probe(&mut inner.renderer, &scene, x, y);
        inner.drawn = Some(self.scene);
        if !drawn {
            let spent = account.spend_drawn(&scene, model, inner.renderer.report());
            spent.map_err(|refused| refused.to_string())?;
        }
        Ok(probe)
    }

    fn find(&self, name: &str) -> Result<Json, String> {
        let scene = self.scene();
        let about = ReportContext {
            name: "",
            scene: &scene,
        };
        let object = |answer: &dyn Answer| answer.object(&about);
        Ok(match name {
            "probe" => {
                let pixel = self.probe.and_then(|place| self.pixel(place));
                let [x, y] = pixel.unwrap_or_default();
                self.lab.spend(PROBE)?;
                let probe = self.probed([x, y])?;
                if probe.hit.is_none() {
                    return Err(text!("lesson-probe-misses").to_owned());
                }
                object(&Probed {
                    probe,
                    sampling: Vec::new(),
                    light: None,
                })
            }
            "profile" => {
                let mut modes = ProfileQuestion::MODES.to_vec();
                modes.push(ShadingMode::Interpolated);
                let question = self.profile_question(&modes)?;
                let subject = self.subject(PROFILE * modes.len() as u64)?;
                object(&question.answer(&subject, &unwatched)?)
            }
            "conditions" => {
                object(&ConditionsQuestion.answer(&self.subject(CONDITIONS)?, &unwatched)?)
            }
            "defects" => {
                let question = DefectsQuestion { pixel: None };
                let subject = self.subject(DEFECTS)?;
                let triangles = triangles_of(&scene, self.lab.model.as_deref());
                self.lab.spend(DEFECT * triangles.min(MEASURED))?;
                object(&question.answer(&subject, &unwatched)?)
            }
            "explain" => {
                let question = PlanQuestion { frames: 1 };
                object(&question.answer(&self.subject(EXPLAIN)?, &unwatched)?)
            }
            "error" | "beside_phong" => {
                let mut other = Scene::clone(&scene);
                if name == "error" {
                    other.shading.mode = ShadingMode::Exact;
                } else {
                    other.reflection.model = ReflectionModel::Phong;
                }
                let own = self.linear()?;
                self.lab.spend_pictures(&other, 1)?;
                let inner = &mut *self.lab.inner.borrow_mut();
                inner.drawn = None;
                let reference = inner.renderer.linear_picture(&other);
                let picture = |pixels| LinearPicture {
                    width: scene.image.size[0],
                    pixels,
                    clamps: scene.clamps(),
                };
                let figures = error_figures(picture(&own), picture(&reference));
                json!(figures)
            }
            "picture" => {
                let seen: Vec<f64> = self
                    .linear()?
                    .iter()
                    .filter(|pixel| pixel[3] > 0.0)
                    .map(|&[r, g, b, _]| luminance(Rgb::new(r.into(), g.into(), b.into())))
                    .collect();
                let count = seen.len().max(1) as f64;
                json!({
                    "pixels": seen.len(),
                    "mean": seen.iter().sum::<f64>() / count,
                    "greatest": seen.iter().copied().fold(0.0, f64::max),
                    "least": seen.iter().copied().fold(f64::INFINITY, f64::min),
                    "clipped": seen.iter().filter(|value| **value > 1.0).count(),
                })
            }
            _ => {
                let values: Result<Json, _> = toml::from_str(&scene.to_toml());
                values.map_err(|error| error.to_string())?
            }
        })
    }
}

impl Quantities for LabPlace<'_> {
    fn quantity(&self, name: &str, parts: &[Part]) -> Result<Value, String> {
        match (name, self.x) {
            ("x", Some(x)) if parts.is_empty() => return Ok(Value::Number(x)),
            ("half_width", _) if parts.is_empty() => {
                return Ok(Value::Number(
                    highlight_half_width(&self.scene()).to_degrees(),
                ));
            }
            _ => {}
        }
        if !QUANTITIES.contains(&name) {
            return Err(text!("expression-unknown", name = excerpt(name)));
        }
        let found = self.known(name)?;
        let value = part_of(&found, name, parts)?;
        self.lab.spend(OPERATION * length(&value))?;
        Ok(value)
    }

    fn with(&self, settings: &str, todo: Todo<'_>) -> Result<Value, String> {
        let settings = settings.split(';').map(|setting| setting.trim().to_owned());
        let settings: Vec<_> = settings.filter(|setting| !setting.is_empty()).collect();
        todo(&self.under(&settings)?)
    }

    fn at(&self, x: f64, y: f64, todo: Todo<'_>) -> Result<Value, String> {
        todo(&self.probing(DVec2::new(x, y)))
    }
}

/// Returns the value that the parts lead to.
fn part_of(json: &Json, path: &str, parts: &[Part]) -> Result<Value, String> {
    let Some((part, rest)) = parts.split_first() else {
        return plain(json).ok_or_else(|| text!("lesson-no-number", path = path));
    };
    let (next, name) = match part {
        Part::All => {
            let entries = json
                .as_array()
                .ok_or_else(|| text!("lesson-no-list", path = path))?;
            let path = format!("{path}[*]");
            let parts: Result<Vec<_>, _> = entries
                .iter()
                .map(|entry| part_of(entry, &path, rest))
                .collect();
            return parts.map(Value::List);
        }
        Part::Index(index) => (json.get(index), format!("{path}[{index}]")),
        Part::Name(name) => {
            let named = |entry: &&Json| entry.get("name").and_then(Json::as_str) == Some(name);
            let entry = json
                .as_array()
                .and_then(|entries| entries.iter().find(named));
            (json.get(name).or(entry), format!("{path}.{name}"))
        }
    };
    match next {
        Some(next) => part_of(next, &name, rest),
        None => Err(text!("lesson-no-part", path = excerpt(&name))),
    }
}

/// Counts the numbers in a value.
fn length(value: &Value) -> u64 {
    match value {
        Value::List(values) => values.iter().map(length).sum(),
        _ => 1,
    }
}

fn plain(json: &Json) -> Option<Value> {
    match json {
        Json::Bool(holds) => Some(Value::Truth(*holds)),
        Json::Number(number) => number.as_f64().map(Value::Number),
        Json::Array(entries) => entries
            .iter()
            .map(plain)
            .collect::<Option<_>>()
            .map(Value::List),
        _ => None,
    }
}
