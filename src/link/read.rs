//! From a link to its scene. Links are untrusted: length, unpacked size and settings are bounded.

use super::encoding::{after, decoded, from_base64};
use super::shown::Shown;
use super::{DEFAULTS, Link, LinkError, LinkProblem, MOST_LINK, MOST_QUERY, MOST_TEXT};
use crate::scene::{
    Compare, Pane, Problem, ProblemLocation, Scene, SceneError, did_you_mean, presets,
};
use crate::text::text;
use miniz_oxide::inflate::TINFLStatus;
use miniz_oxide::inflate::decompress_to_vec_with_limit;

/// The keys of a link.
const KEYS: [&str; 11] = [
    "scene", "lights", "pane", "set", "view", "probe", "line", "lesson", "step", "embed",
    "controls",
];

/// Keys that messengers, mailing lists and advertisers append to links; they are ignored, and so are all that begin
/// with `utm_`.
const APPENDED: [&str; 16] = [
    "fbclid", "gclid", "dclid", "gbraid", "wbraid", "msclkid", "twclid", "ttclid", "yclid", "igsh",
    "igshid", "mc_cid", "mc_eid", "srsltid", "_ga", "_gl",
];

/// The key of a model's file.
const MODEL: &str = "object.path";

/// Name of a scene that is not based on a built-in one.
const NAME: &str = "link";

/// Returns whether a text is meant as a link: it begins like a web address, or with `?` or `#scene=`.
pub fn is_link(text: &str) -> bool {
    let text = bare(text);
    let starts = ["https://", "http://", "file://", "?", "#scene="];
    starts.into_iter().any(|start| after(text, start).is_some())
}

/// Returns the text of a link without the characters that surround it in a letter.
fn bare(text: &str) -> &str {
    let text = text.trim();
    let inner = text
        .strip_prefix('<')
        .and_then(|rest| rest.strip_suffix('>'));
    inner.unwrap_or(text)
}

/// Reads a link, ignoring the part before `?`.
///
/// # Examples
/// ```
/// use shading_lab::link::{Shown, read, write};
/// use shading_lab::scene::presets;
///
/// let mut scene = presets::find("highlight").expect("a built-in scene").scene();
/// scene.material.n = 5.0;
/// let written = write("https://example.org/lab/", &scene, None, &Shown::default())?;
/// assert_eq!(written.link, "https://example.org/lab/?scene=highlight&set=material.n=5");
/// assert_eq!(read(&written.link)?.scene, scene);
///
/// let error = read("?scene=highlight&set=material.m=5").expect_err("there is no such key");
/// assert_eq!(error.problems[0].key, "material.m");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Guarantees
/// The scene is one that [`Scene::validate`] accepts, and names no file.
///
/// # Errors
/// Unknown keys of a link or a scene, and invalid values, each with its position.
pub fn read(text: &str) -> Result<Link, LinkError> {
    let text = bare(text);
    let reader = Reader { text };
    if text.len() > MOST_LINK {
        let words = text!("link-too-long", limit = MOST_LINK >> 10);
        return Err(reader.wrong("scene", 0, &words));
    }
    let (before, fragment) = split(text, '#');
    let (_, query) = split(before, '?');
    let mut parts = Parts::default();
    if let Some((at, query)) = query {
        if query.len() > MOST_QUERY {
            let words = text!("link-query-too-long", limit = MOST_QUERY >> 10);
            return Err(reader.wrong("scene", at, &words));
        }
        reader.query(at, query, &mut parts)?;
    }
    if let Some((at, fragment)) = fragment {
        reader.fragment(at, fragment, &mut parts)?;
    }
    reader.scene(parts)
}

/// Splits a text at a mark; returns the part before it, and the part after it with its offset.
fn split(text: &str, mark: char) -> (&str, Option<(usize, &str)>) {
    let Some((before, after)) = text.split_once(mark) else {
        return (text, None);
    };
    (before, Some((text.len() - after.len(), after)))
}

/// The parts of a link, each with its offset.
#[derive(Default)]
struct Parts {
    scene: Option<(usize, String)>,
    lights: Option<(usize, usize)>,
    panes: Option<(usize, Vec<Pane>)>,
    set: Vec<(usize, String)>,
    /// The text of a scene file.
    file: Option<(usize, String)>,
    shown: Shown,
}

struct Reader<'t> {
    text: &'t str,
}

impl Reader<'_> {
    /// Returns the number of the character at an offset, from 1.
    fn position(&self, offset: usize) -> usize {
        let before = self.text.as_bytes().get(..offset).unwrap_or_default();
        // Bytes that begin a character.
        1 + before.iter().filter(|byte| **byte & 0xC0 != 0x80).count()
    }

    /// Returns an error about a key, which `words` follow.
    fn wrong(&self, key: &str, offset: usize, words: &str) -> LinkError {
        let key = if key.is_empty() { "=" } else { key };
        let shown: String = key.chars().take(80).flat_map(char::escape_debug).collect();
        LinkError {
            problems: vec![LinkProblem {
                words: keyed(&shown, words),
                key: shown,
                position: self.position(offset),
            }],
        }
    }

    fn expected(&self, key: &str, offset: usize, found: &str, expected: &str) -> LinkError {
        let found: String = found
            .chars()
            .take(80)
            .flat_map(char::escape_debug)
            .collect();
        let words = text!(
            "problem-value",
            found = format!("\"{found}\""),
            expected = expected
        );
        self.wrong(key, offset, &words)
    }

    fn query(&self, start: usize, query: &str, parts: &mut Parts) -> Result<(), LinkError> {
        let mut seen: Vec<&'static str> = Vec::new();
        let mut next = start;
        for pair in query.split('&') {
            let at = next;
            next += pair.len() + 1;
            if pair.is_empty() {
                continue;
            }
            let (key, value) = pair.split_once('=').unwrap_or((pair, ""));
            let key = decoded(key).unwrap_or_else(|_| key.to_owned());
            if APPENDED.contains(&&*key) || key.starts_with("utm_") {
                continue;
            }
            let Some(known) = KEYS.into_iter().find(|known| *known == key) else {
                let meant = did_you_mean(&key, KEYS);
                let words = text!("link-unknown-key", keys = KEYS.join(", "), meant = meant);
                return Err(self.wrong(&key, at, &words));
            };
            if seen.contains(&known) && !["set", "pane"].contains(&known) {
                return Err(self.wrong(known, at, text!("link-twice")));
            }
            seen.push(known);
            let begins = at + pair.len() - value.len();
            let value = decoded(value)
                .map_err(|offset| self.wrong(known, begins + offset, text!("link-not-encoded")))?;
            self.pair(at, known, value, parts)?;
        }
        Ok(())
    }

    fn pair(
        &self,
        at: usize,
        key: &str,
        value: String,
        parts: &mut Parts,
    ) -> Result<(), LinkError> {
        match key {
            "scene" => parts.scene = Some((at, value)),
            "set" => parts.set.push((at, value)),
            "lights" => {
                let count = value
                    .parse()
                    .ok()
                    .filter(|count| *count <= Scene::MAX_LIGHTS);
                let expected = text!("range-between", least = 0, greatest = Scene::MAX_LIGHTS);
                let count = count.ok_or_else(|| self.expected(key, at, &value, &expected))?;
                parts.lights = Some((at, count));
            }
            "pane" => {
                let (_, panes) = parts.panes.get_or_insert_with(|| (at, vec![]));
                if panes.len() > Compare::MAX_PANES {
                    return Err(self.wrong(key, at, text!("link-many-panes")));
                }
                if !value.is_empty() {
                    let settings = value.split(';').map(|setting| setting.trim().to_owned());
                    panes.push(Pane {
                        set: settings.collect(),
                        ..Pane::default()
                    });
                }
            }
            _ => {
                if let Some(Err(expected)) = parts.shown.take(key, &value) {
                    return Err(self.expected(key, at, &value, &expected));
                }
            }
        }
        Ok(())
    }

    /// Parses the part after `#`: a scene file, or nothing. Browsers keep their search text after `:~:`.
    fn fragment(&self, at: usize, fragment: &str, parts: &mut Parts) -> Result<(), LinkError> {
        let fragment = split(fragment, ':').0;
        if fragment.is_empty() {
            return Ok(());
        }
        let Some(packed) = fragment.strip_prefix("scene=") else {
            let key = format!("#{}", fragment.split('=').next().unwrap_or_default());
            return Err(self.wrong(&key, at, text!("link-unknown-fragment")));
        };
        for (other, key) in [
            (parts.scene.as_ref().map(|(at, _)| *at), "scene"),
            (parts.lights.map(|(at, _)| at), "lights"),
            (parts.panes.as_ref().map(|(at, _)| *at), "pane"),
            (parts.set.first().map(|(at, _)| *at), "set"),
        ] {
            if let Some(other) = other {
                return Err(self.wrong(key, other, text!("link-beside-file")));
            }
        }
        let wrong = |words: &str| self.wrong("#scene", at, words);
        let bytes = from_base64(packed).ok_or_else(|| wrong(text!("link-not-base64")))?;
        let unpacked =
            decompress_to_vec_with_limit(&bytes, MOST_TEXT).map_err(|error| {
                match error.status {
                    TINFLStatus::HasMoreOutput => {
                        wrong(&text!("link-unpacks-to-more", limit = MOST_TEXT >> 10))
                    }
                    _ => wrong(text!("link-not-packed")),
                }
            })?;
        let file = String::from_utf8(unpacked).map_err(|_| wrong(text!("link-not-packed")))?;
        parts.file = Some((at, file));
        Ok(())
    }

    fn scene(&self, parts: Parts) -> Result<Link, LinkError> {
        if let Some((at, file)) = &parts.file {
            let scene = Scene::parse(file, NAME).map_err(|error| self.in_file(*at, &error))?;
            self.no_model(&scene, *at)?;
            return Ok(Link {
                scene,
                name: NAME.to_owned(),
                shown: parts.shown,
            });
        }
        let (name, base) = self.base(parts.scene.as_ref())?;
        let mut scene = base.clone();
        if let Some((_, count)) = parts.lights {
            scene.lights.resize(count, Default::default());
        }
        if let Some((_, panes)) = &parts.panes {
            scene.compare.panes.clone_from(panes);
        }
        let settings: Vec<&str> = parts.set.iter().map(|(_, setting)| &**setting).collect();
        let scene = scene
            .with_overrides(&settings)
            .map_err(|error| self.in_settings(&parts, &error))?;
        self.no_model(&scene, 0)?;
        let name = if scene.about == base.about {
            name
        } else {
            NAME
        };
        Ok(Link {
            scene,
            name: name.to_owned(),
            shown: parts.shown,
        })
    }

    /// Returns the scene on which the link is based: the default one if it names none.
    fn base(&self, named: Option<&(usize, String)>) -> Result<(&'static str, Scene), LinkError> {
        let Some((at, name)) = named else {
            return Ok((presets::LINK_BASE, presets::link_base()));
        };
        if name == DEFAULTS {
            return Ok((NAME, Scene::default()));
        }
        let preset = presets::find(name).ok_or_else(|| {
            let names = presets::ALL.iter().map(|preset| preset.name);
            let expected = text!(
                "link-expected-scene",
                meant = did_you_mean(name, names.chain([DEFAULTS]))
            );
            self.expected("scene", *at, name, &expected)
        })?;
        Ok((preset.name, preset.scene()))
    }

    /// Refuses a model: a link cannot carry a file, and must not make its reader's program open one.
    fn no_model(&self, scene: &Scene, at: usize) -> Result<(), LinkError> {
        match scene.object.path {
            None => Ok(()),
            Some(_) => Err(self.wrong(MODEL, at, text!("link-no-file"))),
        }
    }

    fn in_file(&self, at: usize, error: &SceneError) -> LinkError {
        let in_line = |problem: &Problem| {
            let line = match problem.place {
                ProblemLocation::Line { line, .. } => line,
                _ => 1,
            };
            text!("link-line", line = line, words = words(problem))
        };
        self.located(error, "#scene", |_| at, in_line)
    }

    fn in_settings(&self, parts: &Parts, error: &SceneError) -> LinkError {
        let place = |problem: &Problem| {
            let set = |text: &String| parts.set.iter().rfind(|(_, setting)| setting == text);
            let own = match &problem.place {
                ProblemLocation::Override(text) => set(text).map(|(at, _)| *at),
                _ => None,
            };
            let in_panes = problem.key.starts_with("compare");
            let panes = || parts.panes.as_ref().map(|(at, _)| *at).filter(|_| in_panes);
            let scene = || parts.scene.as_ref().map(|(at, _)| *at);
            own.or_else(panes).or_else(scene).unwrap_or(0)
        };
        self.located(error, "set", place, words)
    }

    /// Returns the problems of a scene, each with its place in the link; `whole` is the key of those without one.
    fn located(
        &self,
        error: &SceneError,
        whole: &str,
        place: impl Fn(&Problem) -> usize,
        words: impl Fn(&Problem) -> String,
    ) -> LinkError {
        let problem = |problem: &Problem| LinkProblem {
            key: if problem.key.is_empty() {
                whole
            } else {
                &problem.key
            }
            .to_owned(),
            position: self.position(place(problem)),
            words: words(problem),
        };
        LinkError {
            problems: error.problems().iter().map(problem).collect(),
        }
    }
}

/// Describes a problem, with the key. Where a link asks for a model, the problem is not the missing path.
fn words(problem: &Problem) -> String {
    match &*problem.key {
        MODEL => keyed(MODEL, text!("link-no-file")),
        "" => keyed("set", &problem.words()),
        _ => problem.words(),
    }
}

/// Returns a key and the words that follow it.
fn keyed(key: &str, words: &str) -> String {
    format!("`{key}` {words}")
}
