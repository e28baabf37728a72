//! The validity of a scene: every value is within the limits of its parameter, and no two contradict each other.

use super::camera::Camera;
use super::compare;
use super::format::{is_grey, list_of};
use super::light::Attenuation;
use super::object::ObjectKind;
use super::parameter::{GREATEST_LENGTH, Kind, LEAST_LENGTH, Limits, Parameter, Unit, at_most};
use super::problem::{Cause, ProblemLocation, SceneError, UnlocatedProblem};
use super::{Image, Reflection, Rgb, Scene};
use crate::text::text;
use glam::DVec3;
use std::fmt;

/// The smallest distance of eye and target as a part of their distance from the origin: of the 16 digits of an `f64`, 6 are
/// left for the viewing direction.
const LEAST_SEPARATION: f64 = 1e-10;

/// The sine of the smallest angle between the viewing direction and the direction that appears upwards.
const LEAST_TILT: f64 = 1e-6;

impl Scene {
    /// The most lights in a scene. Each adds a term to every pixel.
    pub const MAX_LIGHTS: usize = 1000;

    /// The most points that all lights together are replaced by.
    pub const MAX_LIGHT_SAMPLES: u64 = 4096;

    /// The most pixels times light samples of a picture with shadows: a gigabyte of bits.
    pub const MAX_SHADOW_BITS: u64 = 1 << 33;

    /// Checks every number and their combinations.
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
        SceneError::check(self.range_problems(), |_| ProblemLocation::Scene)
    }

    /// Returns the problems that [`Scene::validate`] reports.
    pub(super) fn range_problems(&self) -> Vec<UnlocatedProblem> {
        let mut checks = Checks::default();
        if self.version != Self::VERSION {
            checks.found.push(UnlocatedProblem::new(
                "version",
                Cause::version(self.version),
            ));
        }
        if self.lights.len() > Self::MAX_LIGHTS {
            checks.value(
                "light",
                list_of(self.lights.len()),
                at_most(Self::MAX_LIGHTS),
            );
        }
        for parameter in Parameter::all() {
            for index in 0..parameter.count(self).min(Self::MAX_LIGHTS) {
                checks.within(&parameter.key(index), parameter.outside(self, index));
            }
        }
        self.check_camera(&mut checks);
        self.check_image(&mut checks);
        self.check_path(&mut checks);
        self.object.check_polygons(&mut checks);
        self.object.check_materials(&mut checks);
        self.check_attenuation(&mut checks);
        self.check_law(&mut checks);
        let cue = &self.depth_cueing;
        if checks.sound("depth_cueing.front")
            && checks.sound("depth_cueing.back")
            && cue.front >= cue.back
        {
            checks.found("depth_cueing.back", text!("problem-depth-cueing"));
        }
        self.check_samples(&mut checks);
        if checks.found.is_empty() {
            compare::problems(self)
        } else {
            checks.found
        }
    }

    fn check_camera(&self, checks: &mut Checks) {
        let &Camera {
            eye, target, up, ..
        } = &self.camera;
        if !checks.sound("camera.eye") || !checks.sound("camera.target") {
            return;
        }
        let scale = eye.length().max(target.length());
        let forward = target - eye;
        if forward.length() <= (LEAST_SEPARATION * scale).max(LEAST_LENGTH) {
            checks.found("camera.eye", text!("problem-eye-target"));
        } else if checks.sound("camera.up")
            && forward.normalize().cross(up.normalize()).length() < LEAST_TILT
        {
            checks.found("camera.up", text!("problem-up-parallel"));
        }
    }

    fn check_image(&self, checks: &mut Checks) {
        let [width, height] = self.image.size;
        let expected = if [width, height]
            .iter()
            .any(|side| !(1..=Image::MAX_SIDE).contains(side))
        {
            text!("expected-sides", side = Image::MAX_SIDE)
        } else if u64::from(width) * u64::from(height) > Image::MAX_PIXELS {
            text!("expected-pixels", pixels = Image::MAX_PIXELS)
        } else {
            return;
        };
        checks.value("image.size", format!("[{width}, {height}]"), expected);
    }

    fn check_path(&self, checks: &mut Checks) {
        match &self.object.path {
            Some(path) if path.to_str().is_none() => {
                let found = format!("{:?}", path.to_string_lossy());
                checks.value("object.path", found, text!("expected-unicode-path"));
            }
            Some(path) if path.as_os_str().is_empty() => {
                checks.value(
                    "object.path",
                    text!("found-empty"),
                    text!("expected-model-path"),
                );
            }
            None if self.object.kind == ObjectKind::Obj => {
                checks.found("object.path", text!("problem-path-missing"));
            }
            _ => {}
        }
    }

    fn check_law(&self, checks: &mut Checks) {
        if !checks.sound("reflection.formula") || self.reflection.formula == Reflection::PHONG {
            return;
        }
        if let Err(error) = self.reflection.law() {
            checks.found("reflection.formula", &error.to_string());
        }
    }

    fn check_attenuation(&self, checks: &mut Checks) {
        for (index, light) in self.lights.iter().take(Self::MAX_LIGHTS).enumerate() {
            let sound = ["c1", "c2", "c3"]
                .iter()
                .all(|name| checks.sound(&format!("light.{index}.{name}")));
            let zero = light.c1 + light.c2 + light.c3 == 0.0;
            if sound && light.attenuation == Attenuation::Quadratic && zero {
                checks.found(
                    &format!("light.{index}.c1"),
                    text!("problem-attenuation-zero"),
                );
            }
        }
    }

    /// Checks that area lights do not have too many samples together, also for the bits of their shadows.
    fn check_samples(&self, checks: &mut Checks) {
        let samples: u64 = self
            .lights
            .iter()
            .map(|light| u64::from(light.sample_count()))
            .sum();
        if samples > Self::MAX_LIGHT_SAMPLES {
            checks.value(
                "light",
                text!("found-samples", count = samples),
                text!("range-at-most", count = Self::MAX_LIGHT_SAMPLES),
            );
        }
        let pixels: u64 = self
            .image
            .size
            .iter()
            .map(|side| u64::from(*side))
            .product();
        if self.shading.shadows && samples.saturating_mul(pixels) > Self::MAX_SHADOW_BITS {
            checks.found("image.size", text!("problem-shadow-pixels"));
        }
    }
}

#[derive(Default)]
pub(super) struct Checks {
    found: Vec<UnlocatedProblem>,
}

impl Checks {
    /// Adds a problem of `key`; `words` follow the key in the message.
    pub(super) fn found(&mut self, key: &str, words: &str) {
        self.found
            .push(UnlocatedProblem::new(key, Cause::Key(words.to_owned())));
    }

    pub(super) fn value(
        &mut self,
        key: &str,
        found: impl fmt::Display,
        expected: impl fmt::Display,
    ) {
        self.found
            .push(UnlocatedProblem::new(key, Cause::value(found, expected)));
    }

    /// Returns whether no problem of a key has been found.
    fn sound(&self, key: &str) -> bool {
        self.found.iter().all(|problem| problem.key != key)
    }

    /// Returns whether a value is within its limits, and reports it if not: `outside` then holds the value and what was expected.
    pub(super) fn within(&mut self, key: &str, outside: Option<(String, String)>) -> bool {
        if let Some((found, expected)) = &outside {
            self.value(key, found, expected);
        }
        outside.is_none()
    }
}

impl Parameter {
    /// Returns the value and what was expected, if it is outside its limits.
    pub(super) fn outside(&self, scene: &Scene, index: usize) -> Option<(String, String)> {
        let in_unit = |limits: Limits| match self.unit {
            Some(Unit::Degrees) => text!("expected-degrees", range = limits.to_string()),
            _ => limits.to_string(),
        };
        let channels = |value: Rgb, limits: Limits| {
            let sound = value
                .to_array()
                .iter()
                .all(|channel| limits.contains(*channel));
            (!sound).then(|| {
                (
                    triple(value),
                    text!("expected-channels", range = limits.to_string()),
                )
            })
        };
        let one = |value: f64, limits: Limits| {
            (!limits.contains(value)).then(|| (format_number(value), in_unit(limits)))
        };
        match self.kind {
            // Written as one number where the channels agree, as it was typed.
            Kind::Coefficient(at, limits, _) if is_grey(*(at.get)(scene, index)?) => {
                one((at.get)(scene, index)?.x, limits)
            }
            Kind::Number(at, limits, _) => one(*(at.get)(scene, index)?, limits),
            Kind::Whole(at, limits, _) => {
                let (value, limits) = (*(at.get)(scene, index)?, limits(scene));
                (!limits.contains(value.into())).then(|| (value.to_string(), limits.to_string()))
            }
            Kind::Pair(at, limits, _) => (at.get)(scene, index)?
                .iter()
                .find_map(|&side| one(side, limits)),
            Kind::Coefficient(at, limits, _)
            | Kind::Channels(at, limits, _)
            | Kind::Colour(at, limits) => channels(*(at.get)(scene, index)?, limits),
            Kind::Direction(at, needed) if needed(scene, index) => {
                direction_outside(*(at.get)(scene, index)?)
            }
            Kind::Point(at) | Kind::Direction(at, _) => point_outside(*(at.get)(scene, index)?),
            Kind::Text(at, longest) | Kind::Lines(at, longest) => {
                let text = (at.get)(scene, index)?;
                let has_lines = matches!(self.kind, Kind::Lines(..));
                let unfit =
                    |c: char| c.is_control() && !(has_lines && matches!(c, '\n' | '\r' | '\t'));
                let sound = text.chars().count() <= longest && !text.chars().any(unfit);
                let found = || format!("{:?}", text.chars().take(20).collect::<String>());
                (!sound).then(|| (found(), self.range_text()))
            }
            Kind::Choice(_) | Kind::Switch(_) | Kind::Other(..) => None,
        }
    }
}

pub(super) fn point_outside(value: DVec3) -> Option<(String, String)> {
    let sound = value
        .to_array()
        .iter()
        .all(|&x| Limits::COORDINATE.contains(x));
    (!sound).then(|| {
        (
            triple(value),
            text!(
                "expected-coordinates",
                greatest = format_number(GREATEST_LENGTH)
            ),
        )
    })
}

pub(super) fn direction_outside(value: DVec3) -> Option<(String, String)> {
    let short = || {
        (
            triple(value),
            text!("expected-direction", least = format_number(LEAST_LENGTH)),
        )
    };
    point_outside(value).or_else(|| (value.length() < LEAST_LENGTH).then(short))
}

impl fmt::Display for Limits {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            &Self::FINITE => f.write_str(text!("range-finite")),
            Self { least, greatest } => f.write_str(&text!(
                "range-between",
                least = format_number(*least),
                greatest = format_number(*greatest)
            )),
        }
    }
}

fn triple(value: DVec3) -> String {
    format!("[{}]", value.to_array().map(format_number).join(", "))
}

/// Returns a number as a scene's author would write it.
fn format_number(value: f64) -> String {
    if value.is_nan() {
        return "nan".to_owned();
    }
    if value != 0.0 && !(1e-6..1e9).contains(&value.abs()) {
        format!("{value:e}")
    } else {
        value.to_string()
    }
}
