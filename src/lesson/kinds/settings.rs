//! Settings: a state that is reached with one control.

use super::extreme::Extreme;
use super::kind::{AnyKind, Predictions, Printed, QuestionKind};
use super::number::{control_line, digits, number_chart, short_number, with_unit};
use crate::expression::Expression;
use crate::figure::short;
use crate::lesson::control::{
    along, control_name, control_unit, long_control_name, settable, settable_to, slider,
};
use crate::lesson::html::Html;
use crate::lesson::read::keys::{KeyReader, Keys, Most};
use crate::lesson::{Hint, LabPlace};
use crate::scene::parameter::Slider;
use crate::text::{fixed, text};
use toml::Spanned;

/// Values along the slider that are tried.
const TRIED: usize = 49;

/// A setting of one control that makes something so.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// The key of the control.
    pub control: String,
    /// The quantity that reaches the goal.
    pub reach: Expression,
    /// The goal.
    pub goal: Goal,
    /// The tolerance of what is reached, or for an extreme of the control's own value.
    pub tolerance: f64,
}

/// The value that a setting is to reach.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Goal {
    /// This value.
    Equals(Expression),
    /// The largest or the smallest value.
    Extreme(Extreme),
    /// This value of the control itself: what a wrong model sets.
    Value(Expression),
}

impl AnyKind for Settings {
    fn controls(&self) -> &[String] {
        std::slice::from_ref(&self.control)
    }

    fn unit(&self) -> &str {
        control_unit(&self.control)
    }

    fn predicts_number(&self) -> bool {
        true
    }
}

impl QuestionKind for Settings {
    /// The value of the control.
    type Answer = f64;
    type Solution = f64;

    const MODEL_KEYS: &[&str] = &["answer", "equals", "most", "least"];

    fn read(keys: &Keys, reader: &mut KeyReader<'_, '_>) -> Option<Self> {
        let Some(control) = &keys.control else {
            reader.missing("control");
            return None;
        };
        let known = reader.slides(reader.at + control.span().start, control.get_ref());
        let reach = reader.expression("reach", &keys.reach);
        let tolerance = reader.positive("tolerance", keys.tolerance);
        let own = |most: &Option<Spanned<Most>>| {
            matches!(most.as_ref().map(Spanned::get_ref), Some(Most::Own(true)))
        };
        let goals = [
            (keys.most == Some(true) || own(&keys.greatest)).then_some(Extreme::Greatest),
            own(&keys.least).then_some(Extreme::Least),
        ];
        let value = keys.answer.as_ref().filter(|_| keys.is_wrong);
        let goal = match (&keys.equals, value, goals) {
            (Some(_), None, [None, None]) => {
                Goal::Equals(reader.expression("equals", &keys.equals)?)
            }
            (None, Some(_), [None, None]) => {
                Goal::Value(reader.expression("answer", &keys.answer)?)
            }
            (None, None, [Some(extreme), None] | [None, Some(extreme)]) => Goal::Extreme(extreme),
            _ => {
                reader.wrong(text!("lesson-goal"));
                return None;
            }
        };
        known.then_some(())?;
        Some(Self {
            control: control.get_ref().clone(),
            reach: reach?,
            goal,
            tolerance: tolerance?,
        })
    }

    fn solve(&self, place: LabPlace<'_>, _: u64) -> Result<f64, String> {
        let control = &self.control;
        let (_, _, slider) =
            slider(control).ok_or_else(|| text!("lesson-no-value", name = control))?;
        // Not every setting of the slider goes with the rest of the scene.
        let mut tried: Vec<f64> = (0..TRIED)
            .map(|index| along(&slider, index as f64 / (TRIED - 1) as f64))
            .filter(|value| self.under(place, *value).is_ok())
            .collect();
        tried.dedup();
        if tried.is_empty() {
            return Err(text!("lesson-settings-many", count = 0));
        }
        let at = |value: &f64| Ok((*value, self.reached(place, *value)?));
        let tried: Result<Vec<(f64, f64)>, String> = tried.iter().map(at).collect();
        match self.goal {
            Goal::Extreme(_) => {
                // With more digits than the tolerance has, it would depend on the picture's pixels.
                let found = self.summit(place, &slider, &tried?)?;
                let scale = 10f64.powi(digits(self.tolerance) as i32);
                Ok((found * scale).round() / scale)
            }
            _ => self.crossing(place, &slider, &tried?),
        }
    }

    fn solve_wrong(&self, place: LabPlace<'_>, seed: u64) -> Result<f64, String> {
        let Goal::Value(value) = &self.goal else {
            return self.solve(place, seed);
        };
        let value = place.number(value)?;
        self.under(place, value)?;
        Ok(value)
    }

    fn right(right: &f64) -> f64 {
        *right
    }

    fn fits(&self, given: &f64) -> bool {
        settable_to(&self.control, *given)
    }

    fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// Returns the difference of what is reached, or for an extreme of the control's own values.
    fn distance(&self, given: &f64, model: &f64, place: LabPlace<'_>) -> Option<f64> {
        if matches!(self.goal, Goal::Extreme(_)) {
            return Some((given - model).abs());
        }
        let reached = |value: f64| self.reached(place, value).ok();
        Some((reached(*given)? - reached(*model)?).abs())
    }

    fn off(&self, given: &f64, right: &f64, place: LabPlace<'_>) -> Option<f64> {
        match self.goal {
            Goal::Extreme(_) => self.distance(given, right, place),
            _ => Some(self.reached(place, *given).ok()?.abs()),
        }
    }

    fn fault(&self, given: &f64, right: &f64, _: LabPlace<'_>) -> Option<Hint> {
        Some(Hint::Control {
            control: 0,
            high: given > right,
        })
    }

    fn number(given: &f64) -> Option<f64> {
        Some(*given)
    }

    fn short(given: &f64) -> String {
        short_number(*given)
    }

    fn short_solution(&self, right: &f64) -> String {
        with_unit(&short_number(*right), self.unit())
    }

    fn words(&self, given: &f64, _: &[String]) -> String {
        let value = with_unit(&short(*given), self.unit());
        format!("{} = {value}", control_name(&self.control))
    }

    fn solution_words(&self, right: &f64, _: &[String]) -> String {
        let decimals = slider(&self.control).map_or(2, |(.., slider)| slider.decimals.min(2));
        let value = with_unit(&fixed(*right, decimals), self.unit());
        format!("{} = {value}", long_control_name(&self.control))
    }

    fn blank(&self, _: &Printed<'_>, _: Option<&f64>) -> Result<Html, String> {
        Ok(control_line(&self.control))
    }

    fn chart(&self, class: &Predictions<'_, f64, f64>) -> Html {
        number_chart(class, None, self.tolerance)
    }
}

impl Settings {
    /// Sets the control.
    fn under<'l>(&self, place: LabPlace<'l>, value: f64) -> Result<LabPlace<'l>, String> {
        place.under(&[format!("{}={value}", self.control)])
    }

    /// Returns what is reached with a value of the control: 0 or the largest is wanted.
    fn reached(&self, place: LabPlace<'_>, value: f64) -> Result<f64, String> {
        let there = self.under(place, value)?;
        let reached = there.number(&self.reach)?;
        Ok(match &self.goal {
            Goal::Equals(equals) => reached - there.number(equals)?,
            Goal::Extreme(extreme) => extreme.sign() * reached,
            Goal::Value(_) => reached,
        })
    }

    /// Finds the only value of the control with which zero is reached, by bisection.
    fn crossing(
        &self,
        place: LabPlace<'_>,
        slider: &Slider,
        tried: &[(f64, f64)],
    ) -> Result<f64, String> {
        let at = |value: f64| self.reached(place, value);
        let crosses = |pair: &&[(f64, f64)]| (pair[0].1 <= 0.0) != (pair[1].1 <= 0.0);
        let crossings: Vec<_> = tried.windows(2).filter(crosses).collect();
        let [crossing] = crossings[..] else {
            return Err(text!("lesson-settings-many", count = crossings.len()));
        };
        let ((mut low, rising), mut high) = (crossing[0], crossing[1].0);
        for _ in 0..40 {
            let middle = settable(slider, (low + high) / 2.0);
            if middle <= low || middle >= high {
                break;
            }
            if (at(middle)? <= 0.0) == (rising <= 0.0) {
                low = middle;
            } else {
                high = middle;
            }
        }
        let found = if slider.decimals > 0 {
            (low + high) / 2.0
        } else if at(low)?.abs() <= at(high)?.abs() {
            low
        } else {
            high
        };
        if at(found)?.abs() > self.tolerance {
            return Err(text!("lesson-settings-unreachable").to_owned());
        }
        Ok(found)
    }

    /// Finds the only value of the control with which the largest is reached, by ternary search.
    fn summit(
        &self,
        place: LabPlace<'_>,
        slider: &Slider,
        tried: &[(f64, f64)],
    ) -> Result<f64, String> {
        let at = |value: f64| self.reached(place, value);
        let best = (0..tried.len()).max_by(|a, b| tried[*a].1.total_cmp(&tried[*b].1));
        let best = best.unwrap_or(0);
        let (summit, greatest) = tried[best];
        let least = tried.iter().map(|(_, reached)| *reached);
        let least = least.fold(f64::INFINITY, f64::min);
        let nearly = greatest - 0.02 * (greatest - least);
        let alike = tried.iter().any(|(value, reached)| {
            *reached >= nearly && (value - summit).abs() > 2.0 * self.tolerance
        });
        if alike || greatest <= least {
            return Err(text!("lesson-settings-alike").to_owned());
        }
        let (mut low, mut high) = (
            tried[best.saturating_sub(1)].0,
            tried[(best + 1).min(tried.len() - 1)].0,
        );
        for _ in 0..30 {
            let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
            let (a, b) = (settable(slider, a), settable(slider, b));
            if a <= low || b >= high {
                break;
            }
            if at(a)? < at(b)? {
                low = a;
            } else {
                high = b;
            }
        }
        let found = settable(slider, (low + high) / 2.0);
        Ok(if at(found)? >= greatest {
            found
        } else {
            summit
        })
    }
}
