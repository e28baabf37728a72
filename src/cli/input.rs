//! Arguments that several commands share.

use super::output::{Failure, progress_bar};
use clap::Args;
use clap::builder::{PathBufValueParser, TypedValueParser};
use glam::DVec2;
use serde::Serialize;
use shading_lab::analysis::{Format, word};
use shading_lab::document::{Loaded, load_with};
use shading_lab::scene::materials::{self, NamedMaterial};
use shading_lab::scene::parameter::Parameter;
use shading_lab::scene::{CompareView, Image, Pane, Scene, nearest, presets};
use shading_lab::text::text;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// Files from this many bytes on get a progress bar while they are read.
const LARGE_FILE: u64 = 4 << 20;

/// Which scene, and what is different in it.
#[derive(Args)]
pub struct SceneArguments {
    #[arg(value_name = "SCENE")]
    pub source: Option<PathBuf>,
    #[arg(long, value_name = "KEY=VALUE", allow_hyphen_values = true)]
    pub set: Vec<String>,
    #[arg(long, value_name = "NAME", value_parser = parse_material)]
    pub material: Option<&'static NamedMaterial>,
}

impl SceneArguments {
    /// What is different in the scene: first its material, then single keys.
    pub fn overrides(&self) -> Vec<String> {
        let material = self.material.map(assignments).unwrap_or_default();
        material
            .into_iter()
            .chain(self.set.iter().cloned())
            .collect()
    }

    /// Opens the scene, or the default one, with the overrides of both sides of the command's name.
    pub fn load(&self, earlier: &[String]) -> Result<Loaded, Failure> {
        let own = self.overrides();
        let overrides: Vec<&String> = earlier.iter().chain(&own).collect();
        let mut bar = None;
        let mut progress = |read: u64, total: u64| {
            if total >= LARGE_FILE {
                bar.get_or_insert_with(|| progress_bar(total, text!("cli-reading")))
                    .set_position(read);
            }
        };
        let source = self
            .source
            .as_deref()
            .unwrap_or(Path::new(presets::DEFAULT));
        if source.extension().is_some_and(|ending| ending == "md") {
            let name = source.display().to_string();
            let problem = text!("cli-scene-is-lesson", name = &*name);
            return Err(Failure::input(format!("{name}: {problem}")));
        }
        let loaded = load_with(source, &overrides, &mut progress);
        if let Some(bar) = bar {
            bar.finish_and_clear();
        }
        Ok(loaded?)
    }
}

/// A named material as keys of a scene.
fn assignments(named: &NamedMaterial) -> Vec<String> {
    let scene = Scene {
        material: named.material(),
        ..Scene::default()
    };
    let keys = Parameter::all().filter(|parameter| parameter.section() == "material");
    keys.map(|parameter| format!("{}={}", parameter.key, parameter.setting(&scene, 0)))
        .collect()
}

/// Takes a whole number of a range.
pub fn whole<T: TryFrom<u32> + Clone + Send + Sync + 'static>(
    range: RangeInclusive<u32>,
) -> impl Fn(&str) -> Result<T, String> + Clone + Send + Sync + 'static {
    move |text| {
        let number = text.parse().ok().filter(|number| range.contains(number));
        let (low, high) = (range.start().to_string(), range.end().to_string());
        number
            .and_then(|number| T::try_from(number).ok())
            .ok_or_else(|| text!("cli-expected-whole", low = low, high = high))
    }
}

fn parse_material(text: &str) -> Result<&'static NamedMaterial, String> {
    materials::find(text).ok_or_else(|| {
        let meant = did_you_mean(text, materials::NAMED.iter().map(|named| named.name));
        text!("cli-no-material", meant = meant)
    })
}

fn did_you_mean<'a>(text: &str, known: impl Iterator<Item = &'a str>) -> String {
    nearest(text, known)
        .map(|meant| text!("document-did-you-mean", name = meant))
        .unwrap_or_default()
}

/// `a, b or c`.
pub fn one_of(words: &[impl AsRef<str>]) -> String {
    let words: Vec<&str> = words.iter().map(AsRef::as_ref).collect();
    match words.split_last() {
        Some((last, others)) if !others.is_empty() => {
            let others = others.join(text!("cli-comma"));
            text!("cli-or", others = others, last = *last)
        }
        _ => words.concat(),
    }
}

/// Which panes there are beside the scene itself.
#[derive(Args)]
pub struct PaneArguments {
    #[arg(long, value_name = "KEY=VALUE[;KEY=VALUE]")]
    pub pane: Vec<String>,
}

impl PaneArguments {
    /// Puts the panes into the scene; `view` is how they are shown, unless the scene says.
    pub fn apply(&self, scene: &mut Scene, view: Option<CompareView>) -> Result<(), Failure> {
        if !self.pane.is_empty() {
            let settings = |text: &String| {
                text.split(';')
                    .map(|setting| setting.trim().to_owned())
                    .collect()
            };
            scene.compare.panes = self
                .pane
                .iter()
                .map(|text| Pane {
                    name: String::new(),
                    set: settings(text),
                })
                .collect();
            if scene.compare.view == CompareView::Single {
                scene.compare.view = CompareView::Panes;
            }
        }
        scene.compare.view = view.unwrap_or(scene.compare.view);
        scene.validate().map_err(Failure::input)
    }
}

/// `WxH`, in the bounds of a picture.
pub fn parse_size(text: &str) -> Result<[u32; 2], String> {
    let expected = || text!("cli-expected-size", most = Image::MAX_SIDE);
    let size = pair(text, &['x', 'X', '×'], |side| {
        (1..=Image::MAX_SIDE).contains(side)
    })
    .ok_or_else(expected)?;
    if u64::from(size[0]) * u64::from(size[1]) > Image::MAX_PIXELS {
        return Err(text!("cli-too-many-pixels", most = Image::MAX_PIXELS));
    }
    Ok(size)
}

/// `X,Y`, whole numbers from the top left.
pub fn parse_pixel(text: &str) -> Result<[u32; 2], String> {
    pair(text, &[','], |_| true).ok_or_else(|| text!("cli-expected-pixel").to_owned())
}

/// `X,Y`, any numbers.
pub fn parse_place(text: &str) -> Result<DVec2, String> {
    let expected = || text!("cli-expected-place").to_owned();
    pair(text, &[','], |value: &f64| value.is_finite())
        .map(DVec2::from_array)
        .ok_or_else(expected)
}

/// Two numbers on either side of a separator.
fn pair<T: FromStr>(text: &str, separators: &[char], sound: fn(&T) -> bool) -> Option<[T; 2]> {
    let (first, second) = text.split_once(separators)?;
    let number = |text: &str| text.trim().parse().ok().filter(sound);
    Some([number(first)?, number(second)?])
}

/// The number of a vertex.
pub fn parse_vertex(text: &str) -> Result<u32, String> {
    text.trim()
        .parse()
        .map_err(|_| text!("cli-expected-vertex").to_owned())
}

/// One of `choices`, by its word in files.
pub fn parse_choice<T: Serialize + Copy>(text: &str, choices: &[T]) -> Result<T, String> {
    let words: Vec<String> = choices.iter().map(word).collect();
    match words.iter().position(|word| word == text.trim()) {
        Some(index) => Ok(choices[index]),
        None => {
            let (meant, words) = (
                did_you_mean(text, words.iter().map(String::as_str)),
                one_of(&words),
            );
            Err(text!("cli-expected", choices = words + &meant))
        }
    }
}

/// Refuses a pixel outside a picture of `size`; `argument` is what names it.
pub fn inside_picture(
    argument: &str,
    [x, y]: [u32; 2],
    [width, height]: [u32; 2],
) -> Result<(), Failure> {
    if x < width && y < height {
        return Ok(());
    }
    let (right, bottom) = (width - 1, height - 1);
    Err(Failure::input(text!(
        "cli-outside-picture",
        what = format!("{argument} {x},{y}"),
        last = format!("{right},{bottom}")
    )))
}

pub fn is_device(path: &Path) -> bool {
    path.metadata()
        .is_ok_and(|metadata| !metadata.is_file() && !metadata.is_dir())
}

/// The name of a figure or a table.
pub fn output_name() -> impl TypedValueParser<Value = PathBuf> {
    PathBufValueParser::new().try_map(|path| match Format::from_path(&path) {
        None if !is_device(&path) => Err(text!("cli-expected-output")),
        _ => Ok(path),
    })
}

/// The name of a picture: its ending says PNG, or it is a device or a pipe.
pub fn picture_name() -> impl TypedValueParser<Value = PathBuf> {
    PathBufValueParser::new().try_map(|path| {
        let picture = Format::from_path(&path) == Some(Format::Png) || is_device(&path);
        if picture {
            Ok(path)
        } else {
            Err(text!("cli-expected-png"))
        }
    })
}
