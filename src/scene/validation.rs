//! What a valid scene is: every value within the limits of its parameter, and no two that contradict each other.

use super::compare;
use super::limits::{GREATEST_LENGTH, LEAST_LENGTH};
use super::parameter::{Kind, Limits, Parameter, is_grey};
use super::problem::{Cause, Place, Problem, SceneError};
use super::{
    AmbientSource, Attenuation, Camera, DepthCueing, Image, Light, Material, Object, ObjectKind, Pattern, PatternKind,
    Rgb, Scene, Transparency,
};
use glam::DVec3;
use std::fmt;
use std::ops::RangeInclusive;

/// Greatest ambient term in a picture that shows one bounce in its right half in place of it: the bounce is added as a difference,
/// in single precision.
const GREATEST_SPLIT: f64 = 1e4;

/// Eye and target are two points when they are further apart than this part of their distance from the origin: of the
/// 16 digits of an `f64`, 6 are left for the viewing direction.
const LEAST_SEPARATION: f64 = 1e-10;

/// Sine of the smallest angle between the viewing direction and the direction that appears upwards.
const LEAST_TILT: f64 = 1e-6;

impl Scene {
    /// Most lights in a scene. Each adds a term to every pixel.
    pub const MAX_LIGHTS: usize = 1000;

    /// Most points that all lights together are replaced by.
    pub const MAX_LIGHT_SAMPLES: u64 = 4096;

    /// Most pixels times light samples of a picture with shadows: a gigabyte of bits.
    pub const MAX_SHADOW_BITS: u64 = 1 << 33;

    /// Checks every number and what they are together.
    ///
    /// # Guarantees
    /// `Ok` says that every number is finite (`material.n` may be infinite) and in the range that its section documents,
    /// that eye and target are different points and `up` points across the line between them, that directions are not
    /// zero, that a model has a path, in Unicode, and that polygons are over known vertices and do not cross
    /// themselves.
    ///
    /// # Errors
    /// Every number that is out of range and every contradiction, with its key.
    pub fn validate(&self) -> Result<(), SceneError> {
        let problem = |(key, cause)| Problem { place: Place::Scene, key, cause };
        SceneError::check(self.range_problems().into_iter().map(problem).collect())
    }

    /// What [`Scene::validate`] reports, as keys and causes.
    pub(super) fn range_problems(&self) -> Vec<(String, Cause)> {
        let mut checks = Checks::default();
        if self.version != Self::VERSION {
            checks.found("version", Cause::Version { found: self.version.to_string() });
        }
        if self.lights.len() > Self::MAX_LIGHTS {
            checks.value("light", format!("a list of {}", self.lights.len()), format!("at most {}", Self::MAX_LIGHTS));
        }
        for parameter in Parameter::all() {
            let count = parameter.count(self).min(Self::MAX_LIGHTS);
            (0..count).for_each(|index| checks.parameter(parameter, self, index));
        }
        self.camera.check(&mut checks);
        self.image.check(&mut checks);
        self.object.check(&mut checks);
        self.depth_cueing.check(&mut checks);
        for (index, light) in self.lights.iter().take(Self::MAX_LIGHTS).enumerate() {
            light.check(&mut checks, index);
        }
        if self.ambient.source == AmbientSource::Split && self.greatest_ambient() > GREATEST_SPLIT {
            let is = "is so bright that beside the ambient term one bounce is lost to rounding";
            let expected = "an ambient term of at most 10000, or `ambient.source` \"constant\" or \"bounce\"";
            checks.found("ambient.color", Cause::Conflict { is, expected });
        }
        self.check_samples(&mut checks);
        if checks.problems.is_empty() {
            checks.problems = compare::problems(self);
        }
        checks.problems
    }

    /// Whether area lights have not too many samples together, also for the bits of their shadows.
    fn check_samples(&self, checks: &mut Checks) {
        let samples: u64 = self.lights.iter().map(|light| u64::from(light.sample_count())).sum();
        if samples > Self::MAX_LIGHT_SAMPLES {
            let expected = format!("at most {}", Self::MAX_LIGHT_SAMPLES);
            checks.value("light", format!("{samples} samples in all"), expected);
        }
        let pixels: u64 = self.image.size.iter().map(|side| u64::from(*side)).product();
        if self.shading.shadows && samples.saturating_mul(pixels) > Self::MAX_SHADOW_BITS {
            let expected = "a smaller picture, fewer samples of area lights, or no shadows";
            checks.found("image.size", Cause::Conflict { is: "has too many pixels for so many shadows", expected });
        }
    }

    /// The greatest constant ambient term of the object and the ground, in any channel.
    fn greatest_ambient(&self) -> f64 {
        let Self { material, pattern, ground, ambient, .. } = self;
        let patterned = if pattern.kind == PatternKind::None { Rgb::ZERO } else { pattern.color };
        let object = material.ka * material.color.max(patterned);
        let floor = if ground.visible { ground.color * ground.ka } else { Rgb::ZERO };
        (object.max(floor) * ambient.color).max_element()
    }
}

impl Camera {
    /// Degrees. Below, a pixel is narrower than single precision resolves; above, the picture is all rim.
    pub const FOV_Y: RangeInclusive<f64> = 1e-3..=179.0;

    fn check(&self, checks: &mut Checks) {
        let &Self { eye, target, up, .. } = self;
        if !checks.sound("camera.eye") || !checks.sound("camera.target") {
            return;
        }
        let scale = eye.length().max(target.length());
        let forward = target - eye;
        if forward.length() <= (LEAST_SEPARATION * scale).max(LEAST_LENGTH) {
            let cause =
                Cause::Conflict { is: "is the same point as `camera.target`", expected: "two different points" };
            checks.found("camera.eye", cause);
        } else if checks.sound("camera.up") && forward.normalize().cross(up.normalize()).length() < LEAST_TILT {
            let is = "is parallel to the viewing direction";
            checks.found("camera.up", Cause::Conflict { is, expected: "a direction across it" });
        }
    }
}

impl Image {
    /// Most pixels in a picture: 16384 × 8192, half a gigabyte as stored.
    pub const MAX_PIXELS: u64 = 1 << 27;

    fn check(&self, checks: &mut Checks) {
        let [width, height] = self.size;
        if [width, height].iter().any(|side| !(1..=Self::MAX_SIDE).contains(side)) {
            let expected = format!("sides of 1 to {} pixels", Self::MAX_SIDE);
            checks.value("image.size", format!("[{width}, {height}]"), expected);
        } else if u64::from(width) * u64::from(height) > Self::MAX_PIXELS {
            let expected = format!("at most {} pixels in all", Self::MAX_PIXELS);
            checks.value("image.size", format!("[{width}, {height}]"), expected);
        }
    }
}

impl Object {
    /// Fewest polygons round the axis: fewer than three enclose nothing. A plane's are counted across it, and so are a
    /// corrugated sheet's slopes, at least one up and one down.
    pub fn min_segments(&self) -> u32 {
        match self.kind {
            ObjectKind::Plane => 1,
            ObjectKind::Corrugated => 2,
            _ => 3,
        }
    }

    /// Fewest polygons along the axis: a sphere needs both of its caps, the tube of a torus encloses something.
    pub fn min_rings(&self) -> u32 {
        match self.kind {
            ObjectKind::Sphere => 2,
            ObjectKind::Torus => 3,
            _ => 1,
        }
    }

    fn check(&self, checks: &mut Checks) {
        match &self.path {
            Some(path) if path.to_str().is_none() => {
                let found = format!("{:?}", path.to_string_lossy());
                checks.value("object.path", found, "a path in Unicode, as a scene file can hold it");
            }
            Some(path) if path.as_os_str().is_empty() => checks.value("object.path", "empty", "the path of a model"),
            None if self.kind == ObjectKind::Obj => {
                let expected = "the path of a model since `object.kind` is \"obj\"";
                checks.found("object.path", Cause::Conflict { is: "is missing", expected });
            }
            _ => {}
        }
        self.check_polygons(checks);
    }
}

impl Material {
    /// Greatest reflection coefficient. Above 1 a surface sends out more than it receives, which is no physics but
    /// shows what overflows; the bound keeps every product far from the end of single precision.
    pub const MAX_COEFFICIENT: f64 = 1e6;

    /// Below, the highlight is narrower than single precision tells directions apart; above, slopes pass 45° mostly.
    pub const ROUGHNESS: RangeInclusive<f64> = 1e-3..=1.0;

    /// Indices of refraction: no material known lies outside.
    pub const IOR: RangeInclusive<f64> = 0.01..=100.0;
}

impl Light {
    /// Degrees from a spot light's axis to the edge of its cone.
    pub const CONE: RangeInclusive<f64> = 0.1..=90.0;

    /// Greatest exponent of a spot light: its beam is then 4° wide.
    pub const MAX_EXPONENT: f64 = 1e3;

    /// Most characters of a light's name.
    pub const MAX_NAME: usize = 64;

    fn check(&self, checks: &mut Checks, index: usize) {
        let key = |name: &str| format!("light.{index}.{name}");
        let sound = ["c1", "c2", "c3"].iter().all(|name| checks.sound(&key(name)));
        if sound && self.attenuation == Attenuation::Quadratic && self.c1 + self.c2 + self.c3 == 0.0 {
            let expected = "one of c1, c2, c3 above 0";
            checks.found(&key("c1"), Cause::Conflict { is: "is 0 like `c2` and `c3`", expected });
        }
    }
}

impl Pattern {
    /// World units. Fields narrower than the least are not told apart in single precision.
    pub const SCALE: RangeInclusive<f64> = 1e-4..=1e4;
}

impl Transparency {
    /// Indices of refraction, either way through the surface.
    pub const IOR: RangeInclusive<f64> = 0.1..=10.0;
}

impl DepthCueing {
    fn check(&self, checks: &mut Checks) {
        let sound = checks.sound("depth_cueing.front") && checks.sound("depth_cueing.back");
        if sound && self.front >= self.back {
            let expected = "a greater one";
            checks.found("depth_cueing.back", Cause::Conflict { is: "is not beyond `depth_cueing.front`", expected });
        }
    }
}

/// The problems found so far.
#[derive(Default)]
pub(super) struct Checks {
    problems: Vec<(String, Cause)>,
}

impl Checks {
    pub(super) fn found(&mut self, key: &str, cause: Cause) {
        self.problems.push((key.to_owned(), cause));
    }

    pub(super) fn value(&mut self, key: &str, found: impl Into<String>, expected: impl Into<String>) {
        self.found(key, Cause::Value { found: found.into(), expected: expected.into() });
    }

    /// Whether nothing has been found wrong with a key.
    fn sound(&self, key: &str) -> bool {
        self.problems.iter().all(|(found, _)| found != key)
    }

    /// Whether a parameter's value is within its limits.
    fn parameter(&mut self, parameter: &Parameter, scene: &Scene, index: usize) {
        if let Some((found, expected)) = parameter.outside(scene, index) {
            self.value(&parameter.key(index), found, expected);
        }
    }

    pub(super) fn point(&mut self, key: &str, value: DVec3) -> bool {
        let outside = point_outside(value);
        let sound = outside.is_none();
        outside.into_iter().for_each(|(found, expected)| self.value(key, found, expected));
        sound
    }

    pub(super) fn direction(&mut self, key: &str, value: DVec3) -> bool {
        let outside = direction_outside(value);
        let sound = outside.is_none();
        outside.into_iter().for_each(|(found, expected)| self.value(key, found, expected));
        sound
    }
}

impl Parameter {
    /// What its value is and what was expected instead, where it is outside its limits.
    fn outside(&self, scene: &Scene, index: usize) -> Option<(String, String)> {
        let unit = if self.unit == "degrees" { " degrees" } else { "" };
        let channels = |value: Rgb, limits: Limits| {
            let sound = value.to_array().iter().all(|channel| limits.contains(*channel));
            (!sound).then(|| (triple(value), format!("{limits} in each channel")))
        };
        let one =
            |value: f64, limits: Limits| (!limits.contains(value)).then(|| (number(value), format!("{limits}{unit}")));
        match &self.kind {
            // One number where the channels agree, as it was typed.
            Kind::Coefficient { at, limits, .. } if (at.get)(scene, index).is_some_and(|value| is_grey(*value)) => {
                one((at.get)(scene, index)?.x, *limits)
            }
            Kind::Number { at, limits, .. } => one(*(at.get)(scene, index)?, *limits),
            Kind::Whole { at, limits, .. } => {
                let (value, limits) = (*(at.get)(scene, index)?, limits(scene));
                (!limits.contains(value.into())).then(|| (value.to_string(), limits.to_string()))
            }
            Kind::Pair { at, limits, .. } => (at.get)(scene, index)?.iter().find_map(|&side| one(side, *limits)),
            Kind::Coefficient { at, limits, .. } | Kind::Channels { at, limits, .. } | Kind::Colour { at, limits } => {
                channels(*(at.get)(scene, index)?, *limits)
            }
            Kind::Point(at) => point_outside(*(at.get)(scene, index)?),
            Kind::Direction { at, needed } if needed(scene, index) => direction_outside(*(at.get)(scene, index)?),
            Kind::Direction { at, .. } => point_outside(*(at.get)(scene, index)?),
            Kind::Text { at, longest } => {
                let text = (at.get)(scene, index)?;
                let sound = text.chars().count() <= *longest && !text.chars().any(char::is_control);
                let found = || format!("{:?}", text.chars().take(20).collect::<String>());
                (!sound).then(|| (found(), format!("at most {longest} characters in one line")))
            }
            Kind::Choice(_) | Kind::Switch(_) | Kind::Other { .. } => None,
        }
    }
}

fn point_outside(value: DVec3) -> Option<(String, String)> {
    let sound = value.to_array().iter().all(|&x| Limits::COORDINATE.contains(x));
    (!sound).then(|| (triple(value), format!("coordinates up to {}", number(GREATEST_LENGTH))))
}

fn direction_outside(value: DVec3) -> Option<(String, String)> {
    let short = || (triple(value), format!("a direction, of length {} or more", number(LEAST_LENGTH)));
    point_outside(value).or_else(|| (value.length() < LEAST_LENGTH).then(short))
}

impl fmt::Display for Limits {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            &Self::FINITE => f.write_str("a finite number"),
            Self { least, greatest } => write!(f, "{} to {}", number(*least), number(*greatest)),
        }
    }
}

fn triple(value: DVec3) -> String {
    format!("[{}, {}, {}]", number(value.x), number(value.y), number(value.z))
}

/// A number as a scene's author would write it.
fn number(value: f64) -> String {
    if value.is_nan() {
        return "nan".to_owned();
    }
    if value != 0.0 && !(1e-6..1e9).contains(&value.abs()) { format!("{value:e}") } else { value.to_string() }
}
