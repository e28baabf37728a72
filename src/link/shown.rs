//! The part of a link beside the scene: the view of it.

use super::encoding::encoded;
use crate::scene::did_you_mean;
use crate::text::text;
use glam::DVec2;

/// The views by their names in links and scene files.
pub const VIEWS: [&str; 9] = [
    "equation",
    "curves",
    "profile",
    "scan-line",
    "compare",
    "defects",
    "plan",
    "study",
    "stability",
];

/// The view of a scene; all of it is optional.
///
/// Positions are relative to the picture's middle, to the right and down, in units of its shorter side, so that they
/// refer to the same point of the scene on a phone and on a projector.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shown {
    /// The view, one of [`VIEWS`].
    pub view: Option<&'static str>,
    /// Position of the probe.
    pub probe: Option<DVec2>,
    /// The line of the profile.
    pub line: Option<[DVec2; 2]>,
    /// True to show only the picture and the named controls, for a page inside another.
    pub embed: bool,
    /// Name of a lesson of the course.
    pub lesson: Option<String>,
    /// Number of a step in the lesson, from 1.
    pub step: Option<u32>,
    /// The controls of an embedded page, as words of lower-case letters, digits, dots and hyphens.
    pub controls: Vec<String>,
}

/// Maximum distance of a position from the picture's middle: no picture is that much longer than wide.
const FARTHEST: f64 = 1e5;
/// Maximum number of a step.
const MOST_STEPS: u32 = 100;
/// Maximum number of named controls.
const MOST_CONTROLS: usize = 64;

impl Shown {
    /// Returns the keys with their values, encoded.
    pub(super) fn pairs(&self) -> Vec<String> {
        let numbers = |key: &str, points: &[DVec2]| {
            let numbers = points.iter().flat_map(|point| point.to_array().map(short));
            format!("{key}={}", numbers.collect::<Vec<_>>().join(","))
        };
        let mut pairs = Vec::new();
        pairs.extend(self.view.map(|view| format!("view={view}")));
        pairs.extend(self.probe.map(|probe| numbers("probe", &[probe])));
        pairs.extend(self.line.as_ref().map(|line| numbers("line", line)));
        pairs.extend(self.lesson.as_ref().map(|name| format!("lesson={name}")));
        pairs.extend(self.step.map(|step| format!("step={step}")));
        pairs.extend(self.embed.then(|| "embed".to_owned()));
        if !self.controls.is_empty() {
            pairs.push(format!("controls={}", encoded(&self.controls.join(","))));
        }
        pairs
    }

    /// Takes a key with its value; none for other keys. The error says what is wrong with the value, in words that
    /// follow the key.
    pub(super) fn take(&mut self, key: &str, value: &str) -> Option<Result<(), String>> {
        Some(match key {
            "view" => VIEWS
                .into_iter()
                .find(|view| *view == value)
                .map(|view| self.view = Some(view))
                .ok_or_else(|| {
                    text!("expected-one-of", words = VIEWS.join(", ")) + &did_you_mean(value, VIEWS)
                }),
            "probe" => places(value)
                .map(|[probe]| self.probe = Some(probe))
                .ok_or_else(|| text!("link-expected-probe").to_owned()),
            "line" => places(value)
                .map(|line| self.line = Some(line))
                .ok_or_else(|| text!("link-expected-line").to_owned()),
            "lesson" => match words(value).as_deref() {
                Some([name]) => {
                    self.lesson = Some(name.clone());
                    Ok(())
                }
                _ => Err(text!("link-expected-lesson").to_owned()),
            },
            "step" => value
                .parse()
                .ok()
                .filter(|step| (1..=MOST_STEPS).contains(step))
                .map(|step| self.step = Some(step))
                .ok_or_else(|| text!("range-between", least = 1, greatest = MOST_STEPS)),
            "embed" => {
                let on = match value {
                    "" | "1" | "true" => Some(true),
                    "0" | "false" => Some(false),
                    _ => None,
                };
                self.embed = on.unwrap_or(self.embed);
                on.map(drop)
                    .ok_or_else(|| text!("expected-bool").to_owned())
            }
            "controls" => words(value)
                .map(|controls| self.controls = controls)
                .ok_or_else(|| text!("link-expected-controls", most = MOST_CONTROLS)),
            _ => return None,
        })
    }
}

/// Formats a coordinate; half a ten-thousandth of a side is less than a pixel of any screen.
fn short(value: f64) -> String {
    let rounded = (value * 1e4).round() / 1e4;
    // Not −0.
    (rounded + 0.0).to_string()
}

/// Parses `N` positions, a pair of numbers each.
fn places<const N: usize>(text: &str) -> Option<[DVec2; N]> {
    let sound = |number: &f64| number.abs() <= FARTHEST;
    let number = |text: &str| text.trim().parse().ok().filter(sound);
    let numbers: Option<Vec<f64>> = text.split(',').take(2 * N + 1).map(number).collect();
    let numbers = numbers.filter(|numbers| numbers.len() == 2 * N)?;
    Some(std::array::from_fn(|at| {
        DVec2::new(numbers[2 * at], numbers[2 * at + 1])
    }))
}

fn words(text: &str) -> Option<Vec<String>> {
    let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || ".-_".contains(c);
    let sound = |word: &&str| !word.is_empty() && word.len() <= 64 && word.chars().all(plain);
    let word = |word: &str| Some(word.trim()).filter(sound).map(str::to_owned);
    if text.is_empty() {
        return Some(Vec::new());
    }
    let words: Option<Vec<_>> = text.split(',').take(MOST_CONTROLS + 1).map(word).collect();
    words.filter(|words| words.len() <= MOST_CONTROLS)
}
