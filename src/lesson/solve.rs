//! The right answer to a question, by the engine.

use super::LabPlace;
use super::question::{CurveOf, Extreme, Find, Goal, Kind, MatchValues, Question, RightIf};
use crate::analysis::comparison::{LinearPicture, error_figures};
use crate::analysis::perception::luminance;
use crate::expression::Expression;
use crate::scene::parameter::{Parameter, Slider};
use crate::scene::{Rgb, ShadingMode};
use crate::text::{fixed, text};
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// How many points of a curve are compared.
pub const CURVE_POINTS: usize = 65;
/// Places along a slider that are tried, and along the picture's shorter side.
const TRIED: usize = 49;

/// The right answer to a question.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub enum Solution {
    /// The number of an option, from 0.
    Choice(usize),
    /// The number.
    Value(f64),
    /// Any of these is right; the first stands for all of them where one is shown.
    Places(Vec<DVec2>),
    /// `[x, y]` at [`CURVE_POINTS`] abscissae, evenly.
    Curve(Vec<[f64; 2]>),
    /// The value of the control.
    Setting(f64),
    /// The items by their numbers from 0, the least first.
    Order(Vec<usize>),
    /// The values of the controls.
    Match(Vec<f64>),
}

impl Question {
    /// Finds the right answer in the scene of a step; `seed` decides what is drawn at random.
    ///
    /// # Errors
    /// Why there is none, or why it is not the only one, in a sentence.
    pub fn solve(&self, place: LabPlace<'_>, seed: u64) -> Result<Solution, String> {
        let solution = self.solution(place, seed);
        // Where single places have no value they are passed over; that must not hide that the rest was never looked at.
        match place.refused() {
            Some(refused) => Err(refused.to_string()),
            None => solution,
        }
    }

    fn solution(&self, place: LabPlace<'_>, seed: u64) -> Result<Solution, String> {
        let place = place.under(&self.set)?;
        match &self.kind {
            Kind::Choice { options, by } => {
                let mut right = Vec::new();
                if let Some((extreme, by)) = by {
                    let value = |set: &[String]| place.under(set)?.number(by);
                    let values: Result<Vec<f64>, String> =
                        options.iter().map(|option| value(&option.set)).collect();
                    return best(&values?, *extreme).map(Solution::Choice);
                }
                for (index, option) in options.iter().enumerate() {
                    let there = place.under(&option.set)?;
                    let holds = match &option.right {
                        Some(RightIf::Said(said)) => *said,
                        Some(RightIf::Holds(holds)) => holds.holds(&there)?,
                        None => false,
                    };
                    right.extend(holds.then_some(index));
                }
                match right[..] {
                    [right] => Ok(Solution::Choice(right)),
                    _ => Err(text!("lesson-right-options", count = right.len())),
                }
            }
            Kind::Value {
                answer,
                tolerance,
                from,
                to,
                ..
            } => {
                let value = place.number(answer)?;
                if value - tolerance < *from || value + tolerance > *to {
                    let value = fixed(value, 4);
                    return Err(text!("lesson-value-outside", value = value));
                }
                Ok(Solution::Value(value))
            }
            Kind::Point { find, tolerance } => find.places(place, *tolerance).map(Solution::Places),
            Kind::Curve {
                x,
                y,
                of,
                tolerance,
                ..
            } => {
                let curve = of.points(place, *x)?;
                let inside = |value: f64| value >= y[0] - 1e-9 && value <= y[1] + 1e-9;
                if let Some([_, value]) = curve.iter().find(|[_, value]| !inside(*value)) {
                    let value = fixed(*value, 4);
                    return Err(text!("lesson-curve-outside", value = value));
                }
                let mean = curve.iter().map(|[_, y]| y).sum::<f64>() / curve.len() as f64;
                let spread = curve.iter().map(|[_, y]| (y - mean).abs()).sum::<f64>();
                if spread / curve.len() as f64 <= tolerance * (y[1] - y[0]) {
                    return Err(text!("lesson-curve-flat").to_owned());
                }
                Ok(Solution::Curve(curve))
            }
            Kind::Settings {
                control,
                reach,
                goal,
                tolerance,
            } => setting(place, control, reach, goal, *tolerance).map(Solution::Setting),
            Kind::Order { items, by } => {
                let value = |set: &[String]| place.under(set)?.number(by);
                let values: Result<Vec<f64>, String> =
                    items.iter().map(|item| value(&item.set)).collect();
                let values = values?;
                let mut order: Vec<usize> = (0..values.len()).collect();
                order.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
                for pair in order.windows(2) {
                    if too_near(values[pair[0]], values[pair[1]]) {
                        return Err(text!("lesson-too-near").to_owned());
                    }
                }
                Ok(Solution::Order(order))
            }
            Kind::Match {
                controls, values, ..
            } => {
                let own = |place: LabPlace<'_>| -> Result<Vec<f64>, String> {
                    let scene = place.scene();
                    controls.iter().map(|key| value_of(&scene, key)).collect()
                };
                let target = match values {
                    MatchValues::Given => own(place)?,
                    MatchValues::Random => random_values(controls, seed),
                };
                Ok(Solution::Match(target))
            }
        }
    }
}

/// Whether two values are so near that one could be taken for the other.
fn too_near(a: f64, b: f64) -> bool {
    (a - b).abs() <= 0.02 * a.abs().max(b.abs())
}

fn best(values: &[f64], extreme: Extreme) -> Result<usize, String> {
    let key = |value: f64| match extreme {
        Extreme::Greatest => -value,
        Extreme::Least => value,
    };
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|a, b| key(values[*a]).total_cmp(&key(values[*b])));
    match order[..] {
        [first, second, ..] if too_near(values[first], values[second]) => {
            Err(text!("lesson-too-near").to_owned())
        }
        [first, ..] => Ok(first),
        [] => Err(text!("lesson-too-near").to_owned()),
    }
}

impl CurveOf {
    fn points(&self, place: LabPlace<'_>, [from, to]: [f64; 2]) -> Result<Vec<[f64; 2]>, String> {
        let x = |index: usize| from + (to - from) * index as f64 / (CURVE_POINTS - 1) as f64;
        match self {
            Self::Expression(of) => (0..CURVE_POINTS)
                .map(|index| Ok([x(index), place.over(x(index)).number(of)?]))
                .collect(),
            Self::Profile(mode) => {
                let profile = place.profile(&[*mode])?;
                let (samples, trace) = (&profile.samples, &profile.traces[0].intensity);
                let at = |t: f64| {
                    let after = samples.partition_point(|sample| sample.t < t);
                    let after = after.clamp(1, samples.len() - 1);
                    let (a, b) = (samples[after - 1].t, samples[after].t);
                    let share = ((t - a) / (b - a)).clamp(0.0, 1.0);
                    trace[after - 1] * (1.0 - share) + trace[after] * share
                };
                if samples.len() < 2 {
                    return Err(text!("line-error-no-length").to_owned());
                }
                Ok((0..CURVE_POINTS)
                    .map(|index| [x(index), at((x(index) - from) / (to - from))])
                    .collect())
            }
        }
    }
}

impl Find {
    fn places(&self, place: LabPlace<'_>, tolerance: f64) -> Result<Vec<DVec2>, String> {
        match self {
            Self::Brightest => brightest(place, 1.0, tolerance),
            Self::Darkest => brightest(place, -1.0, tolerance),
            Self::Corner(mode) => corner(place, *mode, tolerance),
            Self::Extreme(extreme, of) => {
                let sign = if *extreme == Extreme::Greatest {
                    1.0
                } else {
                    -1.0
                };
                let mut values = grid(place, of)?;
                // Between the places of the grid the greatest may lie anywhere: a finer look about the best.
                let best = values
                    .iter()
                    .copied()
                    .max_by(|a, b| (sign * a.1).total_cmp(&(sign * b.1)));
                let best = best.ok_or_else(|| text!("lesson-no-object").to_owned())?;
                let step = 1.0 / (TRIED as f64 * 4.0);
                for (x, y) in (-3..=3).flat_map(|y| (-3..=3).map(move |x| (x, y))) {
                    let there = best.0 + step * DVec2::new(f64::from(x), f64::from(y));
                    let value = place.probing(there).number(of);
                    values.extend(value.ok().map(|value| (there, value)));
                }
                single(values, sign, tolerance)
            }
            Self::Zero(of) => {
                let values = grid(place, of)?;
                let step = 1.5 / TRIED as f64;
                let side = |holds: fn(f64) -> bool| values.iter().filter(move |(_, v)| holds(*v));
                let mut places = Vec::new();
                for (a, over) in side(|value| value > 0.0) {
                    // Where a straight line between the two values is zero.
                    for (b, under) in side(|value| value <= 0.0) {
                        if a.distance(*b) < step {
                            places.push(a.lerp(*b, over / (over - under)));
                        }
                    }
                }
                if places.is_empty() {
                    return Err(text!("lesson-no-zero").to_owned());
                }
                let near = |p: DVec2| places.iter().any(|place| place.distance(p) <= tolerance);
                let covered = values.iter().filter(|(p, _)| near(*p)).count();
                if 2 * covered > values.len() {
                    return Err(text!("lesson-point-anywhere").to_owned());
                }
                // The one that is shown as the right one is typical: not an end of the curve, at the object's outline.
                let middle = places.iter().sum::<DVec2>() / places.len() as f64;
                let off = |place: &DVec2| place.distance_squared(middle);
                places.sort_by(|a, b| off(a).total_cmp(&off(b)));
                Ok(places)
            }
        }
    }
}

/// An expression at places all over the object.
fn grid(place: LabPlace<'_>, of: &Expression) -> Result<Vec<(DVec2, f64)>, String> {
    let size = DVec2::from_array(place.scene().image.size.map(f64::from));
    let half = size / size.min_element() / 2.0;
    let step = 1.0 / TRIED as f64;
    let count = (half / step).ceil();
    let linear = place.linear()?;
    let width = place.scene().image.size[0] as usize;
    let (mut values, mut failure) = (Vec::new(), None);
    for row in -(count.y as i32)..=count.y as i32 {
        for column in -(count.x as i32)..=count.x as i32 {
            let at = step * DVec2::new(f64::from(column), f64::from(row));
            let pixel = (size / 2.0 + at * size.min_element()).floor();
            if pixel.cmplt(DVec2::ZERO).any() || pixel.cmpge(size).any() {
                continue;
            }
            let index = pixel.y as usize * width + pixel.x as usize;
            if linear.get(index).is_none_or(|pixel| pixel[3] == 0.0) {
                continue;
            }
            match place.probing(at).number(of) {
                Ok(value) => values.push((at, value)),
                Err(words) => failure = Some(words),
            }
        }
    }
    match failure {
        Some(words) if values.is_empty() => Err(words),
        _ if values.is_empty() => Err(text!("lesson-no-object").to_owned()),
        _ => Ok(values),
    }
}

/// The place of the greatest value, which no place far away comes near.
fn single(values: Vec<(DVec2, f64)>, sign: f64, tolerance: f64) -> Result<Vec<DVec2>, String> {
    let greatest = values.iter().map(|(_, value)| sign * value);
    let greatest = greatest.fold(f64::NEG_INFINITY, f64::max);
    let least = values.iter().map(|(_, value)| sign * value);
    let least = least.fold(f64::INFINITY, f64::min);
    let best = values.iter().find(|(_, value)| sign * value >= greatest);
    let best = best.ok_or_else(|| text!("lesson-no-object").to_owned())?.0;
    let nearly = greatest - 0.02 * (greatest - least);
    let alike = values
        .iter()
        .any(|(p, value)| sign * value >= nearly && p.distance(best) > 2.0 * tolerance);
    if alike {
        return Err(text!("lesson-point-alike").to_owned());
    }
    Ok(vec![best])
}

fn brightest(place: LabPlace<'_>, sign: f64, tolerance: f64) -> Result<Vec<DVec2>, String> {
    let width = place.scene().image.size[0] as usize;
    let values = place
        .linear()?
        .iter()
        .enumerate()
        .filter(|(_, pixel)| pixel[3] > 0.0)
        .map(|(index, &[r, g, b, _])| {
            let at = [(index % width) as u32, (index / width) as u32];
            let value = luminance(Rgb::new(r.into(), g.into(), b.into()));
            (place.place_of(at), value)
        })
        .collect();
    single(values, sign, tolerance)
}

/// Where the slope along the line jumps most.
fn corner(place: LabPlace<'_>, mode: ShadingMode, tolerance: f64) -> Result<Vec<DVec2>, String> {
    let profile = place.profile(&[mode])?;
    let size = DVec2::from_array(place.scene().image.size.map(f64::from));
    let values: Vec<(DVec2, f64)> = profile
        .borders
        .iter()
        .zip(&profile.traces[0].corners)
        .filter(|(border, _)| border.faces.iter().all(Option::is_some))
        .filter_map(|(border, corner)| {
            let at = (DVec2::new(border.x, border.y) - size / 2.0) / size.min_element();
            corner.as_ref().map(|corner| (at, corner.jump.abs()))
        })
        .collect();
    if values.is_empty() {
        return Err(text!("lesson-no-corner").to_owned());
    }
    single(values, 1.0, tolerance)
}

/// The parameter of a key that has a slider, and which light it belongs to.
pub fn slider(key: &str) -> Option<(&'static Parameter, usize, Slider)> {
    let (parameter, index) = Parameter::of_key(key)?;
    Some((parameter, index.unwrap_or(0), parameter.slider()?))
}

/// The value of a key of a scene, as a number; of a coefficient the greatest channel.
///
/// # Errors
/// A key that has no slider, or no value in this scene.
pub fn value_of(scene: &crate::scene::Scene, key: &str) -> Result<f64, String> {
    let missing = || text!("lesson-no-value", name = key);
    let (parameter, index, _) = slider(key).ok_or_else(missing)?;
    let value = parameter.value(scene, index).ok_or_else(missing)?;
    match &value {
        toml::Value::Float(value) => Ok(*value),
        #[expect(
            clippy::cast_precision_loss,
            reason = "whole numbers of a slider are small"
        )]
        toml::Value::Integer(value) => Ok(*value as f64),
        toml::Value::Array(values) => {
            let values = values.iter().filter_map(toml::Value::as_float);
            values.reduce(f64::max).ok_or_else(missing)
        }
        _ => Err(missing()),
    }
}

/// The value at a share of a slider.
pub(super) fn along(slider: &Slider, share: f64) -> f64 {
    let value = if slider.logarithmic && slider.from > 0.0 {
        slider.from * (slider.to / slider.from).powf(share)
    } else {
        slider.from + (slider.to - slider.from) * share
    };
    if slider.decimals == 0 {
        value.round()
    } else {
        value
    }
}

fn setting(
    place: LabPlace<'_>,
    control: &str,
    reach: &Expression,
    goal: &Goal,
    tolerance: f64,
) -> Result<f64, String> {
    let (_, _, slider) = slider(control).ok_or_else(|| text!("lesson-no-value", name = control))?;
    let under = |value: f64| place.under(&[format!("{control}={value}")]);
    // Not every setting of the slider goes with the rest of the scene.
    let mut tried: Vec<f64> = (0..TRIED)
        .map(|index| along(&slider, index as f64 / (TRIED - 1) as f64))
        .filter(|value| under(*value).is_ok())
        .collect();
    tried.dedup();
    if tried.is_empty() {
        return Err(text!("lesson-settings-many", count = 0));
    }
    let at = |value: f64| -> Result<f64, String> {
        let there = under(value)?;
        let reached = there.number(reach)?;
        Ok(match goal {
            Goal::Equals(equals) => reached - there.number(equals)?,
            Goal::Extreme(Extreme::Greatest) => reached,
            Goal::Extreme(Extreme::Least) => -reached,
        })
    };
    let values: Result<Vec<f64>, String> = tried.iter().map(|value| at(*value)).collect();
    let values = values?;
    // As near as the slider can be set.
    let settable = |value: f64| {
        if slider.decimals == 0 {
            value.round()
        } else {
            value
        }
    };
    let found = match goal {
        Goal::Equals(_) => {
            let crosses = |pair: &&[(f64, f64)]| (pair[0].1 <= 0.0) != (pair[1].1 <= 0.0);
            let pairs: Vec<(f64, f64)> =
                tried.iter().copied().zip(values.iter().copied()).collect();
            let crossings: Vec<&[(f64, f64)]> = pairs.windows(2).filter(crosses).collect();
            let [crossing] = crossings[..] else {
                return Err(text!("lesson-settings-many", count = crossings.len()));
            };
            let ((mut low, rising), mut high) = (crossing[0], crossing[1].0);
            for _ in 0..40 {
                let middle = settable((low + high) / 2.0);
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
            if at(found)?.abs() > tolerance {
                return Err(text!("lesson-settings-unreachable").to_owned());
            }
            found
        }
        Goal::Extreme(_) => {
            let best = (0..tried.len()).max_by(|a, b| values[*a].total_cmp(&values[*b]));
            let best = best.unwrap_or(0);
            let (greatest, least) = (
                values[best],
                values.iter().copied().fold(f64::INFINITY, f64::min),
            );
            let nearly = greatest - 0.02 * (greatest - least);
            let alike = (0..tried.len()).any(|index| {
                values[index] >= nearly && (tried[index] - tried[best]).abs() > 2.0 * tolerance
            });
            if alike || greatest <= least {
                return Err(text!("lesson-settings-alike").to_owned());
            }
            let (mut low, mut high) = (
                tried[best.saturating_sub(1)],
                tried[(best + 1).min(tried.len() - 1)],
            );
            for _ in 0..30 {
                let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
                let (a, b) = (settable(a), settable(b));
                if a <= low || b >= high {
                    break;
                }
                if at(a)? < at(b)? {
                    low = a;
                } else {
                    high = b;
                }
            }
            let found = settable((low + high) / 2.0);
            if at(found)? >= greatest {
                found
            } else {
                tried[best]
            }
        }
    };
    Ok(found)
}

/// Settings that give controls these values.
pub fn matched_settings(controls: &[String], values: &[f64]) -> Vec<String> {
    let pairs = controls.iter().zip(values);
    pairs
        .map(|(control, value)| format!("{control}={value}"))
        .collect()
}

/// Values in the middle four fifths of each control's slider.
fn random_values(controls: &[String], seed: u64) -> Vec<f64> {
    let mut state = seed;
    controls
        .iter()
        .map(|control| {
            // SplitMix64 (Steele, Lea and Flood 2014).
            state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
            let mut z = state;
            z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
            z ^= z >> 31;
            let share = 0.1 + 0.8 * (z >> 11) as f64 / (1u64 << 53) as f64;
            let value = slider(control).map_or(share, |(_, _, slider)| along(&slider, share));
            // As many digits as can be set.
            (value * 1e3).round() / 1e3
        })
        .collect()
}

/// Root mean square of the difference of two pictures, as shown.
pub(super) fn picture_difference(a: &LabPlace<'_>, b: &LabPlace<'_>) -> Result<f64, String> {
    let (scene, pictures) = (a.scene(), [a.linear()?, b.linear()?]);
    let picture = |index: usize| LinearPicture {
        width: scene.image.size[0],
        pixels: &pictures[index],
        clamps: true,
    };
    Ok(error_figures(picture(0), picture(1)).rms)
}
