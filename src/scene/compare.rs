//! Several pictures of one scene side by side: each pane is the scene with a few of its keys replaced.

use super::choice::Choice;
use super::choice::choices;
use super::problem::{Cause, Place, Problem, SceneError};
use super::{Display, Scene, ShadingMode};

/// What is compared and how. The first pane is the scene itself; the last one is what the others are measured against.
#[derive(Clone, Debug, PartialEq)]
pub struct Compare {
    pub view: CompareView,
    /// Where a wipe's line stands, 0 (left) to 1: the scene is seen to its left, the last pane to its right.
    pub wipe: f64,
    pub difference: DifferenceKind,
    /// What the difference is multiplied by before it is shown, 1 to [`Compare::MAX_GAIN`].
    pub gain: f64,
    /// The panes beside the scene itself, at most [`Compare::MAX_PANES`].
    pub panes: Vec<Pane>,
}

impl Compare {
    /// Most panes beside the scene itself.
    pub const MAX_PANES: usize = 3;
    /// Greatest gain of the difference picture.
    pub const MAX_GAIN: f64 = 64.0;
    /// Most keys that one pane replaces.
    pub const MAX_SETTINGS: usize = 64;
}

impl Default for Compare {
    fn default() -> Self {
        let (view, difference) = (CompareView::Single, DifferenceKind::Signed);
        Self { view, wipe: 0.5, difference, gain: 8.0, panes: vec![] }
    }
}

choices! {
    /// How the panes are shown.
    pub enum CompareView {
        Single = "single", "single", "The scene alone";
        Panes = "panes", "panes", "The scene and its panes side by side";
        Wipe = "wipe", "wipe", "The scene and the last pane on either side of a line";
        Difference = "difference", "difference", "The scene minus the last pane";
    }
}

choices! {
    /// What a difference picture shows of each pixel's difference d.
    pub enum DifferenceKind {
        Signed = "signed", "signed", "gain·d of the luminance, from blue (darker) through white to orange (brighter)";
        Absolute = "absolute", "absolute", "gain·|d| of each channel";
        FalseColor = "false-color", "false colour", "gain·|d| of the channel that differs most, from dark blue to yellow";
    }
}

/// A pane: what is different in it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Pane {
    /// What it is called; empty names it by what is different.
    pub name: String,
    /// Keys of the scene with their values, each as `--set` takes it: `shading.mode=exact`.
    pub set: Vec<String>,
}

impl Pane {
    /// Most characters of a pane's name.
    pub const MAX_NAME: usize = 64;

    /// A pane in which these keys have other values.
    pub fn of(settings: &[&str]) -> Self {
        Self { name: String::new(), set: settings.iter().map(|&setting| setting.to_owned()).collect() }
    }

    /// The value that it gives to `key`, as written.
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

    /// Lets `key` follow the scene again.
    pub fn take(&mut self, key: &str) {
        self.set.retain(|setting| setting.split_once('=').is_none_or(|(name, _)| name.trim() != key));
    }
}

impl Scene {
    /// How many panes there are, the scene itself counted.
    pub fn pane_count(&self) -> usize {
        1 + self.compare.panes.len()
    }

    /// The panes that its view shows, by their numbers from 0.
    pub fn shown_panes(&self) -> Vec<usize> {
        let last = self.compare.panes.len();
        match self.compare.view {
            _ if last == 0 => vec![0],
            CompareView::Single => vec![0],
            CompareView::Panes => (0..=last).collect(),
            CompareView::Wipe | CompareView::Difference => vec![0, last],
        }
    }

    /// The scene that a pane shows, 0 the scene itself; it compares nothing further.
    ///
    /// # Errors
    /// What is wrong with the pane's settings. A scene that [`Scene::validate`] accepts has none. A number past the last
    /// pane is the last one's.
    pub fn pane(&self, index: usize) -> Result<Self, SceneError> {
        let alone = Self { compare: Compare::default(), ..self.clone() };
        let last = self.compare.panes.len();
        match index.min(last).checked_sub(1).and_then(|index| self.compare.panes.get(index)) {
            None => Ok(alone),
            Some(pane) => alone.with_overrides(&pane.set),
        }
    }

    /// What a pane is called: its name, or what is different in it.
    pub fn pane_name(&self, index: usize) -> String {
        let pane = index.checked_sub(1).and_then(|index| self.compare.panes.get(index));
        if let Some(pane) = pane.filter(|pane| !pane.name.is_empty()) {
            return pane.name.clone();
        }
        let shading = self.pane(index).map_or_else(|_| self.shading.clone(), |scene| scene.shading);
        let mut words = vec![mode_name(shading.mode, shading.renormalise).to_owned()];
        for setting in pane.iter().flat_map(|pane| &pane.set) {
            let Some((key, value)) = setting.split_once('=') else { continue };
            let (section, name) = key.trim().rsplit_once('.').unwrap_or(("", key.trim()));
            let value = value.trim().trim_matches(['"', '\'']);
            match name {
                "mode" | "renormalise" => {}
                "segments" | "rings" => words.push(format!("{value} {name}")),
                "interpolation" | "model" | "normals" | "weighting" | "by" => words.push(value.to_owned()),
                _ if section.is_empty() => words.push(format!("{name} {value}")),
                _ => words.push(format!("{} {value}", name.replace('_', " "))),
            }
        }
        words.join(", ")
    }

    /// Whether what the display clamps is to be compared clamped.
    pub fn clamps(&self) -> bool {
        let Display { overflow, encoding: _ } = self.display;
        overflow == super::Overflow::Clamp
    }
}

/// The name of a shading mode.
fn mode_name(mode: ShadingMode, renormalise: bool) -> &'static str {
    if mode == ShadingMode::Phong && !renormalise { "Phong, not renormalised" } else { mode.label() }
}

/// Tables and keys that all panes share.
const SHARED: [&str; 5] = ["version", "camera", "image", "compare", "object.path"];

/// What is wrong with the panes of a scene that is otherwise sound, as keys and causes.
pub(super) fn problems(scene: &Scene) -> Vec<(String, Cause)> {
    let mut found = Vec::new();
    let panes = &scene.compare.panes;
    if panes.len() > Compare::MAX_PANES {
        let expected = format!("at most {} beside the scene itself", Compare::MAX_PANES);
        let cause = Cause::Value { found: format!("a list of {}", panes.len()), expected };
        return vec![("compare.pane".to_owned(), cause)];
    }
    if scene.compare.view != CompareView::Single && panes.is_empty() {
        let cause = Cause::Conflict { is: "compares with nothing", expected: "a [[compare.pane]]" };
        found.push(("compare.view".to_owned(), cause));
    }
    for (index, pane) in panes.iter().enumerate() {
        found.extend(pane_problems(scene, index, pane));
    }
    found
}

fn pane_problems(scene: &Scene, index: usize, pane: &Pane) -> Vec<(String, Cause)> {
    let key = format!("compare.pane.{index}");
    if pane.set.len() > Compare::MAX_SETTINGS {
        let expected = format!("at most {}", Compare::MAX_SETTINGS);
        return vec![(format!("{key}.set"), Cause::Value { found: format!("a list of {}", pane.set.len()), expected })];
    }
    let shared = |setting: &String| {
        let name = setting.split_once('=').map_or("", |(name, _)| name.trim());
        SHARED
            .iter()
            .any(|shared| name.strip_prefix(shared).is_some_and(|rest| rest.is_empty() || rest.starts_with('.')))
    };
    if let Some(at) = pane.set.iter().position(shared) {
        let expected = "a key that panes may differ in (they share camera, image and model)".into();
        let found = format!("{:?}", pane.set[at]);
        return vec![(format!("{key}.set.{at}"), Cause::Value { found, expected })];
    }
    let Err(error) = scene.pane(index + 1) else { return vec![] };
    let placed = |problem: &Problem| {
        let at = pane.set.iter().position(|setting| matches!(&problem.place, Place::Override(text) if text == setting));
        let key = at.map_or_else(|| format!("{key}.set"), |at| format!("{key}.set.{at}"));
        (key, Cause::Other(problem.in_words()))
    };
    error.problems().iter().map(placed).collect()
}
