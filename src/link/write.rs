//! From a scene to its link.

use super::encoding::{base64, encoded, ended};
use super::shown::Shown;
use super::{DEFAULTS, MOST_READABLE, MOST_TEXT, WriteError, read};
use crate::scene::parameter::{Parameter, defaults};
use crate::scene::{ObjectKind, Pane, Scene, presets};
use miniz_oxide::deflate::compress_to_vec;
use std::path::PathBuf;

/// A link, and the part that it cannot carry.
#[derive(Clone, Debug, PartialEq)]
pub struct Written {
    /// The link, at most 2000 characters before `#`.
    pub link: String,
    /// The model's file, which the link omits: the teapot takes its place.
    pub left_out: Option<PathBuf>,
}

/// Compression level, from 0 to 10.
const EFFORT: u8 = 9;

/// Writes the link to a scene on a page, whose address may be empty. `origin` is the built-in scene that it was made
/// from; without one it is based on the one with the fewest differences.
///
/// # Errors
/// A scene with too many polygons, or one that [`Scene::validate`] refuses.
pub fn write(
    page: &str,
    scene: &Scene,
    origin: Option<&str>,
    shown: &Shown,
) -> Result<Written, WriteError> {
    let (scene, left_out) = portable(scene);
    let written = |link| Written {
        link,
        left_out: left_out.clone(),
    };
    let is_same = |link: &str| read(link).map(|link| is_same(&link.scene, &scene));
    if let Some(settings) = settings(&scene, origin) {
        let pairs = [settings, shown.pairs()].concat().join("&");
        let link = format!("{page}?{}", ended(pairs));
        if link.len() <= MOST_READABLE && is_same(&link) == Ok(true) {
            return Ok(written(link));
        }
    }
    let text = scene.to_toml();
    if text.len() > MOST_TEXT {
        return Err(WriteError::TooLarge);
    }
    let pairs = shown.pairs();
    let question = if pairs.is_empty() { "" } else { "?" };
    let link = format!(
        "{page}{question}{}#scene={}",
        pairs.join("&"),
        packed(&text)
    );
    match is_same(&link) {
        Err(error) => Err(WriteError::Unsound(error)),
        Ok(_) => Ok(written(link)),
    }
}

/// Returns the scene without its model, and the model's file, if that was shown.
fn portable(scene: &Scene) -> (Scene, Option<PathBuf>) {
    let mut scene = scene.clone();
    let path = scene.object.path.take();
    let is_model = |pane: &Pane| {
        pane.value("object.kind")
            .is_some_and(|kind| kind.contains("obj"))
    };
    let in_pane = scene.compare.panes.iter().any(is_model);
    let shown = scene.object.kind == ObjectKind::Obj;
    if shown {
        scene.object = presets::link_base().object;
    }
    scene
        .compare
        .panes
        .iter_mut()
        .filter(|pane| is_model(pane))
        .for_each(|pane| pane.take("object.kind"));
    (scene, path.filter(|_| shown || in_pane))
}

/// Returns whether two scenes are identical to the last bit.
fn is_same(a: &Scene, b: &Scene) -> bool {
    a.differences(b).next().is_none()
}

/// Returns the encoded settings that turn a built-in scene into this one; none where settings cannot express it.
fn settings(scene: &Scene, origin: Option<&str>) -> Option<Vec<String>> {
    let (name, mut base) = origin
        .and_then(presets::find)
        .map_or_else(|| nearest(scene), |preset| (preset.name, preset.scene()));
    let mut pairs = vec![format!("scene={name}")];
    let count = scene.lights.len();
    if base.lights.len() != count {
        base.lights.resize(count, Default::default());
        pairs.push(format!("lights={count}"));
    }
    let sets = |scene: &Scene| -> Vec<Vec<String>> {
        scene
            .compare
            .panes
            .iter()
            .map(|pane| pane.set.clone())
            .collect()
    };
    let panes = sets(scene);
    if sets(&base) != panes {
        let written: Option<Vec<_>> = panes.iter().map(|set| pane(set)).collect();
        let written = written?;
        if written.is_empty() {
            pairs.push("pane=".to_owned());
        }
        pairs.extend(written);
        let pane = |set| Pane {
            set,
            ..Pane::default()
        };
        base.compare.panes = panes.into_iter().map(pane).collect();
    }
    for (parameter, index) in base.differences(scene) {
        pairs.push(setting(parameter, scene, index)?);
    }
    Some(pairs)
}

fn setting(parameter: &Parameter, scene: &Scene, index: usize) -> Option<String> {
    let value = parameter.short_setting(scene, index)?;
    Some(format!("set={}={}", parameter.key(index), encoded(&value)))
}

/// Returns the settings of a pane, separated by semicolons.
fn pane(set: &[String]) -> Option<String> {
    let apart = |setting: &String| {
        !setting.is_empty() && setting.trim() == setting && !setting.contains(';')
    };
    let sound = !set.is_empty() && set.iter().all(apart);
    sound.then(|| format!("pane={}", encoded(&set.join(";"))))
}

/// Returns the built-in scene, or the one of all defaults, from which this one differs in the fewest keys.
fn nearest(scene: &Scene) -> (&'static str, Scene) {
    let built_in = presets::ALL
        .iter()
        .map(|preset| (preset.name, preset.scene()));
    let all = built_in.chain([(DEFAULTS, defaults().clone())]);
    let nearest = all.min_by_key(|(_, base)| base.differences(scene).count());
    nearest.unwrap_or_else(|| (DEFAULTS, defaults().clone()))
}

/// Compresses a text. The last character of the result is a letter or a digit: messengers consider another the end of
/// a sentence.
fn packed(text: &str) -> String {
    let mut bytes = compress_to_vec(text.as_bytes(), EFFORT);
    let packed = base64(&bytes);
    if !packed.ends_with(['-', '_']) {
        return packed;
    }
    // Bytes after the end of the compressed text are not read.
    bytes.push(0);
    base64(&bytes)
}
