//! A match: settings that make a picture like another one.

use super::kind::{AnyKind, Predictions, Printed, QuestionKind};
use super::number::{control_line, short_number, with_unit};
use crate::analysis::comparison::{LinearPicture, error_figures};
use crate::bits::SplitMix64;
use crate::figure::short;
use crate::lesson::control::{
    along, control_name, control_unit, long_control_name, settable_to, share, slider, value_of,
};
use crate::lesson::html::{Html, element};
use crate::lesson::page::picture;
use crate::lesson::read::keys::{KeyReader, Keys};
use crate::lesson::{Hint, LabPlace};
use crate::render::Frame;
use crate::text::{fixed, listed, text};

/// Settings that make a picture like another one.
#[derive(Clone, Debug, PartialEq)]
pub struct Match {
    /// The keys of the controls, one to eight.
    pub controls: Vec<String>,
    /// The origin of the values that are right.
    pub values: MatchValues,
    /// The largest root mean square of the difference that counts as right.
    pub tolerance: f64,
}

/// The origin of the values of a picture to be matched.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MatchValues {
    /// The question's settings.
    Given,
    /// A seed.
    Random,
}

impl Match {
    /// Returns the settings that give its controls these values.
    pub fn settings(&self, values: &[f64]) -> Vec<String> {
        let pairs = self.controls.iter().zip(values);
        pairs
            .map(|(control, value)| format!("{control}={value}"))
            .collect()
    }

    /// Returns the values as words, by the names of the controls.
    fn listed(
        &self,
        values: &[f64],
        name: fn(&str) -> String,
        number: impl Fn(f64) -> String,
    ) -> String {
        let pairs = self.controls.iter().zip(values);
        listed(pairs.map(|(control, value)| {
            let value = with_unit(&number(*value), control_unit(control));
            format!("{} = {value}", name(control))
        }))
    }
}

impl AnyKind for Match {
    fn controls(&self) -> &[String] {
        &self.controls
    }

    fn uses_picture(&self) -> bool {
        true
    }

    fn shows_target(&self) -> bool {
        true
    }

    fn is_drawn_at_random(&self) -> bool {
        self.values == MatchValues::Random
    }
}

impl QuestionKind for Match {
    /// The values of the controls.
    type Answer = Vec<f64>;
    type Solution = Vec<f64>;

    const MODEL_KEYS: &[&str] = &["set"];

    fn read(keys: &Keys, reader: &mut KeyReader<'_, '_>) -> Option<Self> {
        if !(1..=8).contains(&keys.controls.len()) {
            reader.missing("controls");
            return None;
        }
        let mut known = true;
        for control in &keys.controls {
            known &= reader.slides(reader.at, control);
        }
        let tolerance = reader.positive("tolerance", keys.tolerance.or(Some(0.01)));
        known.then_some(())?;
        Some(Self {
            controls: keys.controls.clone(),
            values: if keys.set.is_empty() {
                MatchValues::Random
            } else {
                MatchValues::Given
            },
            tolerance: tolerance?,
        })
    }

    fn solve(&self, place: LabPlace<'_>, seed: u64) -> Result<Vec<f64>, String> {
        match self.values {
            MatchValues::Given => {
                let scene = place.scene();
                let values = self.controls.iter().map(|key| value_of(&scene, key));
                values.collect()
            }
            MatchValues::Random => Ok(random_values(&self.controls, seed)),
        }
    }

    /// Checks that the picture is not like the target before anything is set.
    fn check(&self, right: &Vec<f64>, place: LabPlace<'_>) -> Result<(), String> {
        let target = place.under(&self.settings(right))?;
        if picture_difference(&place, &target)? < 2.0 * self.tolerance {
            return Err(text!("lesson-match-same").to_owned());
        }
        Ok(())
    }

    fn right(right: &Vec<f64>) -> Vec<f64> {
        right.clone()
    }

    fn fits(&self, given: &Vec<f64>) -> bool {
        let mut pairs = self.controls.iter().zip(given);
        given.len() == self.controls.len() && pairs.all(|(key, x)| settable_to(key, *x))
    }

    fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// Returns the root mean square of the difference of the two pictures.
    fn distance(&self, given: &Vec<f64>, model: &Vec<f64>, place: LabPlace<'_>) -> Option<f64> {
        if given.len() != self.controls.len() {
            return None;
        }
        let under = |values: &[f64]| place.under(&self.settings(values)).ok();
        picture_difference(&under(given)?, &under(model)?).ok()
    }

    /// Returns the control that is farthest from its right value, along its slider.
    fn fault(&self, given: &Vec<f64>, right: &Vec<f64>, _: LabPlace<'_>) -> Option<Hint> {
        let off = |(control, key): (usize, &String)| {
            let (_, _, slider) = slider(key)?;
            let off = share(&slider, *given.get(control)?) - share(&slider, *right.get(control)?);
            Some((control, off))
        };
        let controls = self.controls.iter().enumerate().filter_map(off);
        let (control, off) = controls.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))?;
        let high = off > 0.0;
        Some(Hint::Control { control, high })
    }

    fn short(given: &Vec<f64>) -> String {
        let values: Vec<String> = given.iter().map(|value| short_number(*value)).collect();
        values.join(" ")
    }

    fn words(&self, given: &Vec<f64>, _: &[String]) -> String {
        self.listed(given, control_name, short)
    }

    fn solution_words(&self, right: &Vec<f64>, _: &[String]) -> String {
        self.listed(right, long_control_name, |value| fixed(value, 2))
    }

    fn blank(&self, printed: &Printed<'_>, right: Option<&Vec<f64>>) -> Result<Html, String> {
        let figure = |frame: &Frame, words: &str| {
            let caption = element("figcaption").with(words);
            element("figure").with(picture(frame, "")).with(caption)
        };
        let start = figure(printed.picture, text!("class-start"));
        let mut pair = element("div").class("pair").with(start);
        if let Some(right) = right {
            let place = printed.place.under(printed.set)?;
            let target = place.under(&self.settings(right))?.counted_picture()?;
            let words = text!("class-target", seed = printed.seed.to_string());
            pair = pair.with(figure(&target, &words));
        }
        let lines: Html = self.controls.iter().map(|key| control_line(key)).collect();
        Ok(Html::new().line(pair).with(lines))
    }

    fn chart(&self, _: &Predictions<'_, Vec<f64>, Vec<f64>>) -> Html {
        Html::new()
    }
}

/// Draws values in the middle four fifths of each control's slider.
fn random_values(controls: &[String], seed: u64) -> Vec<f64> {
    let mut random = SplitMix64(seed);
    controls
        .iter()
        .map(|control| {
            let share = 0.1 + 0.8 * (random.next_u64() >> 11) as f64 / (1u64 << 53) as f64;
            let value = slider(control).map_or(share, |(_, _, slider)| along(&slider, share));
            // As many digits as can be set.
            (value * 1e3).round() / 1e3
        })
        .collect()
}

/// Returns the root mean square of the difference of the pictures of two scenes.
fn picture_difference(a: &LabPlace<'_>, b: &LabPlace<'_>) -> Result<f64, String> {
    let width = a.scene().image.size[0];
    Ok(picture_distance(width, &a.linear()?, &b.linear()?))
}

/// Returns the root mean square of the difference of two pictures of linear intensities, as shown.
pub fn picture_distance(width: u32, a: &[[f32; 4]], b: &[[f32; 4]]) -> f64 {
    let picture = |pixels| LinearPicture {
        width,
        pixels,
        clamps: true,
    };
    error_figures(picture(a), picture(b)).rms
}
