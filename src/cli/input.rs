//! Arguments that several commands share.

use super::output::{Failure, note, progress_bar};
use clap::Args;
use clap::builder::{PathBufValueParser, PossibleValue, TypedValueParser};
use glam::DVec2;
use serde::Serialize;
use shading_lab::analysis::report::word;
use shading_lab::document::{LoadError, Loaded, STDOUT, is_picture, load_bytes, load_with};
use shading_lab::lesson::Lesson;
use shading_lab::scene::materials::{self, NamedMaterial};
use shading_lab::scene::parameter::Parameter;
use shading_lab::scene::{CompareView, Image, Pane, Scene, did_you_mean, presets};
use shading_lab::text::{interned, text};
use std::ffi::OsStr;
use std::io::{self, Read};
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::sync::OnceLock;

/// File size in bytes from which on a progress bar is shown while reading.
const LARGE_FILE: u64 = 4 << 20;

/// Name of the standard input and of the standard output on a command line.
const STANDARD: &str = "-";

/// Name of the standard input in messages.
const STDIN: &str = "<stdin>";

/// Maximum size in bytes of a picture from the standard input: more than any picture of this program has.
const MOST_PICTURE: u64 = 1 << 30;

/// Maximum size in bytes of a text: one more than a scene may have, so that its reader can report the error.
const MOST_TEXT: u64 = Scene::MAX_TEXT as u64 + 1;

pub fn is_stdin(path: &Path) -> bool {
    path == Path::new(STANDARD)
}

/// Returns a file's path as messages have it.
pub fn called(path: &Path) -> &Path {
    if is_stdin(path) {
        Path::new(STDIN)
    } else {
        path
    }
}

/// Returns the standard input, limited to the size of a picture or of a text; it is read once however often it is
/// requested.
pub fn stdin() -> Result<Vec<u8>, LoadError> {
    static READ: OnceLock<Result<Vec<u8>, String>> = OnceLock::new();
    let read = || {
        let (mut input, mut bytes) = (io::stdin().lock(), Vec::new());
        let read = input.by_ref().take(MOST_TEXT).read_to_end(&mut bytes);
        let rest = if is_picture(&bytes) {
            MOST_PICTURE - MOST_TEXT
        } else {
            0
        };
        let read = read.and_then(|_| input.take(rest).read_to_end(&mut bytes));
        read.map(|_| bytes).map_err(|error| error.to_string())
    };
    READ.get_or_init(read).clone().map_err(|error| {
        refused(
            Path::new(STDIN),
            text!("cli-input-unreadable", error = error),
        )
    })
}

fn refused(path: &Path, problem: String) -> LoadError {
    LoadError::File {
        path: path.to_owned(),
        line: None,
        problem,
    }
}

/// The scene, with the changes to it.
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
    /// Returns the changes to the scene: first its material, then single keys.
    pub fn overrides(&self) -> Vec<String> {
        let material = self.material.map(assignments).unwrap_or_default();
        material
            .into_iter()
            .chain(self.set.iter().cloned())
            .collect()
    }

    /// Opens the scene, or the default one, with the overrides on both sides of the command's name. Parts of it that
    /// are not drawn are noted on stderr.
    pub fn load(&self, earlier: &[String]) -> Result<Loaded, LoadError> {
        let loaded = self.load_quietly(earlier)?;
        for warning in loaded.warnings() {
            note(&warning);
        }
        Ok(loaded)
    }

    fn load_quietly(&self, earlier: &[String]) -> Result<Loaded, LoadError> {
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
        if Lesson::is_file(source) {
            let name = source.display().to_string();
            return Err(refused(source, text!("cli-scene-is-lesson", name = name)));
        }
        if is_stdin(source) {
            return load_bytes(STDIN, stdin()?, &overrides, &mut progress);
        }
        load_with(source, &overrides, &mut progress)
    }
}

/// Returns a named material as keys of a scene.
fn assignments(named: &NamedMaterial) -> Vec<String> {
    let scene = Scene {
        material: named.material(),
        ..Scene::default()
    };
    let keys = Parameter::all().filter(|parameter| parameter.section() == "material");
    keys.map(|parameter| format!("{}={}", parameter.key, parameter.setting(&scene, 0)))
        .collect()
}

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

/// Joins words as `a, b or c`.
pub fn one_of(words: &[impl AsRef<str>]) -> String {
    let words: Vec<&str> = words.iter().map(AsRef::as_ref).collect();
    match words.split_last() {
        Some((last, others)) if !others.is_empty() => {
            let others = others.join(text!("comma"));
            text!("cli-or", others = others, last = *last)
        }
        _ => words.concat(),
    }
}

#[derive(Args)]
pub struct PaneArguments {
    #[arg(long, value_name = "KEY=VALUE[;KEY=VALUE]")]
    pub pane: Vec<String>,
}

impl PaneArguments {
    /// Adds the panes to the scene; `view` is the way they are shown, unless the scene sets one.
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

/// Parses `WxH`, within the bounds of a picture.
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

/// Parses `X,Y`, whole numbers from the top left.
pub fn parse_pixel(text: &str) -> Result<[u32; 2], String> {
    pair(text, &[','], |_| true).ok_or_else(|| text!("cli-expected-pixel").to_owned())
}

/// Parses `X,Y`, any numbers.
pub fn parse_place(text: &str) -> Result<DVec2, String> {
    let expected = || text!("cli-expected-place").to_owned();
    pair(text, &[','], |value: &f64| value.is_finite())
        .map(DVec2::from_array)
        .ok_or_else(expected)
}

/// Parses two numbers on either side of a separator.
fn pair<T: FromStr>(text: &str, separators: &[char], sound: fn(&T) -> bool) -> Option<[T; 2]> {
    let (first, second) = text.split_once(separators)?;
    let number = |text: &str| text.trim().parse().ok().filter(sound);
    Some([number(first)?, number(second)?])
}

pub fn parse_vertex(text: &str) -> Result<u32, String> {
    text.trim()
        .parse()
        .map_err(|_| text!("cli-expected-vertex").to_owned())
}

/// Parses one of `choices`, by its word in files.
pub fn parse_choice<T: Serialize + Copy>(text: &str, choices: &[T]) -> Result<T, String> {
    let words: Vec<String> = choices.iter().map(word).collect();
    match words.iter().position(|word| word == text.trim()) {
        Some(index) => Ok(choices[index]),
        None => {
            let meant = did_you_mean(text, words.iter().map(String::as_str));
            Err(text!("cli-expected", choices = one_of(&words) + &meant))
        }
    }
}

/// Returns the parser of [`parse_choice`], with its choices known to completions.
pub fn choice<T: Serialize + Copy + Send + Sync + 'static>(
    choices: &'static [T],
) -> impl TypedValueParser<Value = T> {
    Choices(choices)
}

#[derive(Clone)]
struct Choices<T: 'static>(&'static [T]);

impl<T: Serialize + Copy + Send + Sync + 'static> TypedValueParser for Choices<T> {
    type Value = T;

    fn parse_ref(
        &self,
        command: &clap::Command,
        argument: Option<&clap::Arg>,
        value: &OsStr,
    ) -> Result<T, clap::Error> {
        let choices = self.0;
        let parse = move |text: &str| parse_choice(text, choices);
        parse.parse_ref(command, argument, value)
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        let known = |choice| PossibleValue::new(interned(&word(choice)));
        Some(Box::new(self.0.iter().map(known)))
    }
}

/// Refuses a pixel outside a picture of `size`; `argument` is the option that names it.
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

/// Returns whether a path is the standard output, a device or a pipe, whose name implies no format.
pub fn is_device(path: &Path) -> bool {
    if path == Path::new(STDOUT) {
        return true;
    }
    path.metadata()
        .is_ok_and(|metadata| !metadata.is_file() && !metadata.is_dir())
}

/// Parses the name of a file to write; `-` is the standard output.
pub fn output_file() -> impl TypedValueParser<Value = PathBuf> {
    PathBufValueParser::new().map(|path| {
        if path == Path::new(STANDARD) {
            PathBuf::from(STDOUT)
        } else {
            path
        }
    })
}

/// Parses the name of a file to write that has one of these endings, unless it is a device or a pipe; `expected` is
/// the message that names them.
pub fn output_ending_in(
    endings: &'static [&'static str],
    expected: &'static str,
) -> impl TypedValueParser<Value = PathBuf> {
    output_file().try_map(move |path| {
        let ending = path.extension().map(OsStr::to_ascii_lowercase);
        let known = ending.is_some_and(|ending| endings.iter().any(|known| ending == *known));
        if known || is_device(&path) {
            Ok(path)
        } else {
            Err(text!(expected))
        }
    })
}

/// Parses the name of a figure or a table.
pub fn output_name() -> impl TypedValueParser<Value = PathBuf> {
    output_ending_in(&["json", "png", "svg", "csv"], "cli-expected-output")
}

pub fn picture_name() -> impl TypedValueParser<Value = PathBuf> {
    output_ending_in(&["png"], "cli-expected-png")
}
