//! Comparison of several pictures of one scene: each pane is the scene with a few of its keys replaced.

use super::Scene;
use super::camera::Overflow;
use super::choice::{Choice, choices};
use super::format::list_of;
use super::material::{FORMULA, MODEL, ReflectionModel};
use super::overrides::{is_inside, key_and_value};
use super::parameter::{Limits, Parameter, Reason, Slider, at_most, table};
use super::problem::{Cause, Problem, ProblemLocation, SceneError, UnlocatedProblem};
use super::setting::setting_words;
use super::shading::{self, Interpolation, ShadingMode};
use crate::text::text;

table! {
    /// The panes of a comparison and how they are shown. The first pane is the scene itself; one is the reference against
    /// which the others are measured.
    pub struct Compare = [compare] in compare with (/// The panes beside the scene itself, at most [`Self::MAX_PANES`].
        panes: Vec<Pane> = vec![]) {
        /// The arrangement of the panes.
        COMPARE_VIEW view: CompareView = CompareView::Single, Choice;
        /// Name of the pane that is the scene itself; at most 64 characters.
        SCENE_NAME name: String = String::new(), Text(Pane::MAX_NAME).idle_if(&[NO_PANES]);
        /// Number of the pane against which the others are measured; 0 is the scene itself.
        REFERENCE reference: u32 = 0,
            Whole(|scene| Limits::new(0.0, scene.pane_count() as f64), PANE_NUMBERS).idle_if(&[NO_PANES]);
        /// Position of the line as a fraction of the picture's width. The reference is to its right, the first other pane
        /// to its left.
        WIPE wipe: f64 = 0.5, Number(Limits::UNIT, Slider::UNIT).idle_if(&[NO_WIPE]);
        /// The content of the difference picture.
        DIFFERENCE difference: DifferenceKind = DifferenceKind::Signed, Choice.idle_if(&[NO_DIFFERENCE]);
        /// Factor of the difference, 1 to 64.
        GAIN gain: f64 = 8.0, Number(Limits::new(1.0, Compare::MAX_GAIN), GAINS).idle_if(&[NO_DIFFERENCE]);
    }
}

/// The longest part of a formula in the name of a pane, in characters.
const LONGEST_FORMULA: usize = 32;
const PANE_NUMBERS: Slider = Slider::linear(0.0, 1.0 + Compare::MAX_PANES as f64).decimals(0);
const GAINS: Slider = Slider::logarithmic(1.0, Compare::MAX_GAIN).decimals(1);

const NO_PANES: Reason = (
    |scene, _| scene.compare.panes.is_empty(),
    "picture-idle-one-pane",
);
const NO_WIPE: Reason = (
    |scene, _| scene.compare.view != CompareView::Wipe,
    "idle-no-wipe",
);
const NO_DIFFERENCE: Reason = (
    |scene, _| scene.compare.view != CompareView::Difference,
    "idle-no-difference",
);

impl Compare {
    /// The most panes beside the scene itself.
    pub const MAX_PANES: usize = 5;
    /// The largest gain of the difference picture.
    pub const MAX_GAIN: f64 = 64.0;
    /// The most keys that one pane replaces.
    pub const MAX_SETTINGS: usize = 64;

    /// Returns whether all panes have the same value of a key.
    pub fn shares(key: &str) -> bool {
        let shared = ["version", "camera", "image", "compare", "object.path"];
        shared.iter().any(|shared| is_inside(key, shared))
    }
}

choices! {
    /// The arrangement of the panes.
    pub enum CompareView = "compare" {
        /// The scene alone.
        Single = "single";
        /// All panes side by side.
        Panes = "panes";
        /// The first pane and the reference on either side of a line.
        Wipe = "wipe";
        /// The first pane minus the reference.
        Difference = "difference";
    }
}

choices! {
    /// The content of a difference picture, from each pixel's difference d.
    pub enum DifferenceKind = "difference" {
        /// gain·d of the luminance, from blue (darker) through white to orange (brighter).
        Signed = "signed";
        /// gain·|d| of each channel.
        Absolute = "absolute";
        /// gain·|d| of the channel that differs most, from dark blue to yellow.
        FalseColor = "false-color";
    }
}

table! {
    /// A pane beside the scene itself, given by its differences.
    pub struct Pane = [compare.pane.N] in [compare.panes] {
        /// The pane's name; at most 64 characters.
        PANE_NAME name: String = String::new(), Text(Pane::MAX_NAME);
        /// The differences from the scene, `KEY=VALUE` as `--set` takes it; at most 64.
        PANE_SET set: Vec<String> = vec![], Other("kind-settings", || at_most(Compare::MAX_SETTINGS));
    }
}

impl Pane {
    /// The most characters of a pane's name.
    pub const MAX_NAME: usize = 64;

    /// Returns a pane with these settings.
    pub fn of(settings: &[&str]) -> Self {
        Self {
            name: String::new(),
            set: settings.iter().map(|&setting| setting.to_owned()).collect(),
        }
    }

    /// Returns the value that it gives to `key`, as written.
    pub fn value(&self, key: &str) -> Option<&str> {
        self.set.iter().rev().find_map(|setting| {
            let (name, value) = setting.split_once('=')?;
            (name.trim() == key).then(|| value.trim())
        })
    }

    /// Gives `key` a value of its own.
    pub fn put(&mut self, key: &str, value: &str) {
        self.take(key);
        self.set.push(format!("{key}={value}"));
    }

    /// Makes `key` follow the scene again.
    pub fn take(&mut self, key: &str) {
        self.set.retain(|setting| {
            setting
                .split_once('=')
                .is_none_or(|(name, _)| name.trim() != key)
        });
    }
}

impl Scene {
    /// Returns the number of panes, the scene itself included.
    pub fn pane_count(&self) -> usize {
        1 + self.compare.panes.len()
    }

    /// Returns the numbers, from 0, of the panes that the view shows.
    pub fn shown_panes(&self) -> Vec<usize> {
        let last = self.compare.panes.len();
        match self.compare.view {
            _ if last == 0 => vec![0],
            CompareView::Single => vec![0],
            CompareView::Panes => (0..=last).collect(),
            CompareView::Wipe | CompareView::Difference => {
                let reference = self.reference_pane();
                vec![usize::from(reference == 0), reference]
            }
        }
    }

    /// Returns the number, from 0, of the pane against which the others are measured.
    pub fn reference_pane(&self) -> usize {
        let last = self.compare.panes.len();
        (self.compare.reference as usize)
            .checked_sub(1)
            .map_or(last, |pane| pane.min(last))
    }

    /// Makes a pane the reference.
    pub fn set_reference(&mut self, pane: usize) {
        let last = pane >= self.compare.panes.len();
        #[expect(clippy::cast_possible_truncation, reason = "there are a few panes")]
        let number = if last { 0 } else { pane as u32 + 1 };
        self.compare.reference = number;
    }

    /// Moves a pane to another position. Every pane keeps its picture: the one that becomes first becomes the scene itself,
    /// and the others are given their differences from it.
    ///
    /// # Errors
    /// The problems in the panes' settings; then nothing is moved.
    pub fn move_pane(&mut self, from: usize, to: usize) -> Result<(), SceneError> {
        let count = self.pane_count();
        if from >= count || to >= count {
            return Ok(());
        }
        let mut order: Vec<usize> = (0..count).collect();
        let moved = order.remove(from);
        order.insert(to, moved);
        let scenes = (0..count)
            .map(|pane| self.pane(pane))
            .collect::<Result<Vec<_>, _>>()?;
        let reference = self.reference_pane();
        let base = &scenes[order[0]];
        let panes = order[1..].iter().map(|&old| {
            let mut pane = self.pane_beside(old).cloned().unwrap_or_else(|| Pane {
                name: self.compare.name.clone(),
                ..Pane::default()
            });
            for (parameter, index) in base.differences(&scenes[old]) {
                pane.put(
                    &parameter.key(index),
                    &parameter.setting(&scenes[old], index),
                );
            }
            pane
        });
        let compare = Compare {
            panes: panes.collect(),
            name: self.given_name(order[0]).to_owned(),
            ..self.compare.clone()
        };
        *self = Self {
            compare,
            ..base.clone()
        };
        let reference = order.iter().position(|old| *old == reference);
        self.set_reference(reference.unwrap_or(0));
        Ok(())
    }

    /// Removes a pane; if it is the scene itself, the second pane becomes the scene.
    ///
    /// # Errors
    /// As for [`Self::move_pane`].
    pub fn remove_pane(&mut self, pane: usize) -> Result<(), SceneError> {
        let last = self.compare.panes.len();
        if pane > last || last == 0 {
            return Ok(());
        }
        self.move_pane(pane, last)?;
        let reference = self.reference_pane();
        self.compare.panes.pop();
        self.set_reference(reference.min(last - 1));
        if last == 1 {
            self.compare.view = CompareView::Single;
        }
        Ok(())
    }

    /// Compares all shading modes side by side, measured against the exact one.
    pub fn compare_all_modes(&mut self) {
        let (first, others) = (ShadingMode::VALUES[0], &ShadingMode::VALUES[1..]);
        self.shading.mode = first;
        let pane =
            |mode: &ShadingMode| Pane::of(&[&format!("{}={}", shading::MODE.key, mode.word())]);
        self.compare = Compare {
            view: CompareView::Panes,
            reference: 0,
            panes: others.iter().map(pane).collect(),
            ..self.compare.clone()
        };
    }

    /// Compares the scene with Phong's model by the difference of their pictures. The pane of Phong's model becomes the
    /// reference; where there is none, it is added. Without space for another pane nothing changes.
    pub fn compare_with_phong(&mut self) {
        let phong = Pane::of(&[&format!("{}={}", MODEL.key, ReflectionModel::Phong.word())]);
        let panes = &mut self.compare.panes;
        let known = panes.iter().position(|pane| pane.set == phong.set);
        if known.is_none() && panes.len() >= Compare::MAX_PANES {
            return;
        }
        let place = known.unwrap_or(panes.len());
        if known.is_none() {
            panes.push(phong);
        }
        self.set_reference(place + 1);
        self.compare.view = CompareView::Difference;
    }

    /// Returns the scene that a pane shows, without further panes; 0 is the scene itself. A number past the last pane
    /// counts as the last.
    ///
    /// # Errors
    /// The problems in the pane's settings. A scene that [`Scene::validate`] accepts has none.
    pub fn pane(&self, index: usize) -> Result<Self, SceneError> {
        let alone = Self {
            compare: Compare::default(),
            ..self.clone()
        };
        match self.pane_beside(index.min(self.compare.panes.len())) {
            None => Ok(alone),
            Some(pane) => alone.with_overrides(&pane.set),
        }
    }

    /// Returns the pane of this number; `None` for 0, the scene itself, and past the last pane.
    fn pane_beside(&self, index: usize) -> Option<&Pane> {
        self.compare.panes.get(index.checked_sub(1)?)
    }

    /// Returns the name that a pane has been given, or an empty one.
    fn given_name(&self, index: usize) -> &str {
        match index {
            0 => &self.compare.name,
            _ => self.pane_beside(index).map_or("", |pane| &pane.name),
        }
    }

    /// Returns a pane's name: the one given, or its differences in words.
    pub fn pane_name(&self, index: usize) -> String {
        let given = self.given_name(index);
        if !given.is_empty() {
            return given.to_owned();
        }
        let own = self.pane(index).unwrap_or_else(|_| self.clone());
        // Panes of one mode are named by their other differences, the first one too.
        if self.panes_share_mode() {
            let words = self.settings_apart(&own);
            if !words.is_empty() {
                return words.join(", ");
            }
        }
        let plain = own.shading.mode != ShadingMode::Phong || own.shading.renormalise;
        let mode = if plain {
            own.shading.mode.label()
        } else {
            text!("pane-not-renormalised")
        };
        let settings = self
            .pane_beside(index)
            .into_iter()
            .flat_map(|pane| &pane.set);
        let settings = settings.filter_map(|setting| short_words(setting));
        let words: Vec<String> = std::iter::once(mode.to_owned()).chain(settings).collect();
        words.join(", ")
    }

    /// Returns whether no pane sets a shading mode other than the first pane's.
    fn panes_share_mode(&self) -> bool {
        let mode = self.shading.mode.word();
        let same = |pane: &Pane| {
            pane.value("shading.mode").is_none_or(|set| set == mode)
                && pane.value("shading.renormalise").is_none()
        };
        self.compare.panes.iter().all(same)
    }

    /// Returns in words the values that a pane's scene has for the keys set in any pane.
    fn settings_apart(&self, scene: &Self) -> Vec<String> {
        let settings = self.compare.panes.iter().flat_map(|pane| &pane.set);
        let mut keys: Vec<&str> = Vec::new();
        for (key, _) in settings.filter_map(|setting| key_and_value(setting)) {
            if !keys.contains(&key) {
                keys.push(key);
            }
        }
        let present = keys.into_iter().filter_map(|key| {
            let index = Parameter::of_key(key).and_then(|(_, index)| index);
            let value = Parameter::by_word(key)?.setting(scene, index.unwrap_or(0));
            short_words(&format!("{key}={value}"))
        });
        present.collect()
    }

    /// Returns whether intensities are compared after clamping, as the display clamps them.
    pub fn clamps(&self) -> bool {
        self.display.overflow == Overflow::Clamp
    }
}

/// Returns a setting in few words, if its value says what it is about.
fn short_words(setting: &str) -> Option<String> {
    let (key, value) = setting.split_once('=')?;
    let value = value.trim().trim_matches(['"', '\'']);
    match key.trim() {
        "shading.mode" | "shading.renormalise" => None,
        "object.segments" => Some(text!("pane-segments", count = value)),
        "object.rings" => Some(text!("pane-rings", count = value)),
        "shading.interpolation" => {
            Interpolation::from_word(value).map(|chosen| chosen.label().to_owned())
        }
        "reflection.model" => {
            ReflectionModel::from_word(value).map(|model| model.label().to_owned())
        }
        key if key == FORMULA.key => {
            let known = Scene::default().with_override(setting).ok()?;
            let formula = known.reflection.formula;
            let value = formula.lines().rfind(|line| !line.trim().is_empty())?;
            Some(shortened(value.trim()))
        }
        key => {
            // Only a material's letters are clear without a word.
            let named = Parameter::by_word(key).filter(|one| one.section() == "material");
            let letter = named.map_or("", |parameter| parameter.letter);
            match value.parse::<f64>() {
                Ok(number) if number.is_finite() && !letter.is_empty() => {
                    Some(format!("{letter} = {number}"))
                }
                _ => Some(setting_words(setting)),
            }
        }
    }
}

/// Returns the beginning of a formula, as long as the name of a pane.
fn shortened(formula: &str) -> String {
    match formula.char_indices().nth(LONGEST_FORMULA) {
        Some((end, _)) => format!("{}…", &formula[..end]),
        None => formula.to_owned(),
    }
}

/// Returns the problems of the panes of an otherwise valid scene.
pub(super) fn problems(scene: &Scene) -> Vec<UnlocatedProblem> {
    let Compare { panes, view, .. } = &scene.compare;
    if panes.len() > Compare::MAX_PANES {
        let expected = text!("expected-panes", count = Compare::MAX_PANES);
        let found = list_of(panes.len());
        return vec![UnlocatedProblem::new(
            "compare.pane",
            Cause::value(found, expected),
        )];
    }
    if *view != CompareView::Single && panes.is_empty() {
        let words = text!("problem-nothing-to-compare");
        return vec![UnlocatedProblem::new(
            "compare.view",
            Cause::Key(words.to_owned()),
        )];
    }
    panes
        .iter()
        .enumerate()
        .flat_map(|(index, pane)| pane_problems(scene, index, pane))
        .collect()
}

fn pane_problems(scene: &Scene, index: usize, pane: &Pane) -> Vec<UnlocatedProblem> {
    let key = format!("compare.pane.{index}.set");
    if pane.set.len() > Compare::MAX_SETTINGS {
        let expected = at_most(Compare::MAX_SETTINGS);
        return vec![UnlocatedProblem::new(
            key,
            Cause::value(list_of(pane.set.len()), expected),
        )];
    }
    let shared = |setting: &String| {
        let name = setting.split_once('=').map_or("", |(name, _)| name.trim());
        Compare::shares(name)
    };
    if let Some(at) = pane.set.iter().position(shared) {
        let expected = text!("expected-pane-key");
        return vec![UnlocatedProblem::new(
            format!("{key}.{at}"),
            Cause::value(format_args!("{:?}", pane.set[at]), expected),
        )];
    }
    let Err(error) = scene.pane(index + 1) else {
        return vec![];
    };
    let found = |problem: &Problem| {
        let at = pane.set.iter().position(
            |setting| matches!(&problem.place, ProblemLocation::Override(text) if text == setting),
        );
        let key = at.map_or_else(|| key.clone(), |at| format!("{key}.{at}"));
        let words = UnlocatedProblem::in_words(&problem.key, &problem.cause);
        let sentence = format!("`{key}`: {words}");
        UnlocatedProblem::new(key, Cause::Text(sentence))
    };
    error.problems().iter().map(found).collect()
}
