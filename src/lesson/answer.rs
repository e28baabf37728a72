//! What a student answers, and how right it is.

use super::question::{CurveOf, Extreme, Goal, Kind, Question};
use super::solve::{Solution, matched_settings, picture_difference};
use super::{LabPlace, solve};
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// An answer to a question.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Answer {
    /// The number of an option, from 0.
    Choice(usize),
    /// A number.
    Value(f64),
    /// From the middle of the picture to the right and down, in units of its shorter side.
    Point([f64; 2]),
    /// At [`super::CURVE_POINTS`] abscissae, evenly; nothing where none was drawn.
    Curve(Vec<Option<f64>>),
    /// The value of the control.
    Settings(f64),
    /// The items by their numbers from 0, the least first.
    Order(Vec<usize>),
    /// The values of the controls.
    Match(Vec<f64>),
}

/// How right an answer is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Grade {
    /// Whether it is right, within the question's tolerance.
    pub right: bool,
    /// From 0 to 1.
    pub score: f64,
    /// How far it is from the right answer, in the question's own unit, where that has one.
    pub off: Option<f64>,
}

impl Grade {
    fn of(right: bool) -> Self {
        Self {
            right,
            score: f64::from(u8::from(right)),
            off: None,
        }
    }

    /// Full marks within the tolerance, none at twice that.
    fn within(off: f64, tolerance: f64) -> Self {
        let slack = 1e-9 * tolerance;
        Self {
            right: off <= tolerance + slack,
            score: (2.0 - off / tolerance).clamp(0.0, 1.0),
            off: Some(off),
        }
    }
}

impl Answer {
    /// How right it is, for a question whose solution is known; none where it answers another kind of question.
    pub fn grade(
        &self,
        question: &Question,
        solution: &Solution,
        place: LabPlace<'_>,
    ) -> Option<Grade> {
        let place = place.under(&question.set).ok()?;
        match (self, &question.kind, solution) {
            (Self::Choice(given), Kind::Choice { .. }, Solution::Choice(right)) => {
                Some(Grade::of(given == right))
            }
            (Self::Value(given), Kind::Value { tolerance, .. }, Solution::Value(right)) => {
                let off = (given - right).abs();
                Some(Grade::within(off, *tolerance))
            }
            (Self::Point(given), Kind::Point { tolerance, .. }, Solution::Places(places)) => {
                let given = DVec2::from_array(*given);
                let off = places.iter().map(|place| place.distance(given));
                let off = off.fold(f64::INFINITY, f64::min);
                Some(Grade::within(off, *tolerance))
            }
            (Self::Curve(given), Kind::Curve { y, tolerance, .. }, Solution::Curve(right)) => {
                let off = curve_distance(given, right)? / (y[1] - y[0]);
                Some(Grade::within(off, *tolerance))
            }
            (
                Self::Settings(given),
                Kind::Settings {
                    control,
                    reach,
                    goal,
                    tolerance,
                },
                Solution::Setting(right),
            ) => {
                let off = match goal {
                    Goal::Extreme(Extreme::Greatest | Extreme::Least) => (given - right).abs(),
                    Goal::Equals(equals) => {
                        let there = place.under(&[format!("{control}={given}")]).ok()?;
                        (there.number(reach).ok()? - there.number(equals).ok()?).abs()
                    }
                };
                Some(Grade::within(off, *tolerance))
            }
            (Self::Order(given), Kind::Order { .. }, Solution::Order(right)) => {
                order_grade(given, right)
            }
            (
                Self::Match(given),
                Kind::Match {
                    controls,
                    tolerance,
                    ..
                },
                Solution::Match(right),
            ) => {
                if given.len() != controls.len() {
                    return None;
                }
                let under = |values: &[f64]| place.under(&matched_settings(controls, values)).ok();
                let off = picture_difference(&under(given)?, &under(right)?).ok()?;
                Some(Grade::within(off, *tolerance))
            }
            _ => None,
        }
    }

    /// Whether it is an answer to a question of this kind that can be graded: finite numbers, indices that there are.
    pub fn fits(&self, kind: &Kind) -> bool {
        match (self, kind) {
            (Self::Choice(given), Kind::Choice { options, .. }) => *given < options.len(),
            (Self::Value(given), Kind::Value { .. })
            | (Self::Settings(given), Kind::Settings { .. }) => given.is_finite(),
            (Self::Point(given), Kind::Point { .. }) => given.iter().all(|x| x.is_finite()),
            (Self::Curve(given), Kind::Curve { .. }) => {
                given.len() == solve::CURVE_POINTS
                    && given.iter().flatten().all(|value| value.is_finite())
            }
            (Self::Order(given), Kind::Order { items, .. }) => {
                let mut sorted = given.clone();
                sorted.sort_unstable();
                sorted.into_iter().eq(0..items.len())
            }
            (Self::Match(given), Kind::Match { controls, .. }) => {
                given.len() == controls.len() && given.iter().all(|x| x.is_finite())
            }
            _ => false,
        }
    }

    /// The right answer, as a student would give it.
    pub fn right(solution: &Solution) -> Self {
        match solution {
            Solution::Choice(right) => Self::Choice(*right),
            Solution::Value(right) => Self::Value(*right),
            Solution::Places(places) => {
                Self::Point(places.first().copied().unwrap_or_default().to_array())
            }
            Solution::Curve(right) => Self::Curve(right.iter().map(|[_, y]| Some(*y)).collect()),
            Solution::Setting(right) => Self::Settings(*right),
            Solution::Order(right) => Self::Order(right.clone()),
            Solution::Match(right) => Self::Match(right.clone()),
        }
    }
}

/// The mean distance; none where less than nine tenths were drawn.
fn curve_distance(given: &[Option<f64>], right: &[[f64; 2]]) -> Option<f64> {
    let distances: Vec<f64> = given
        .iter()
        .zip(right)
        .filter_map(|(given, [_, right])| given.map(|given| (given - right).abs()))
        .collect();
    let enough = given.len() == right.len() && 10 * distances.len() >= 9 * right.len();
    enough.then(|| distances.iter().sum::<f64>() / distances.len() as f64)
}

/// The score is the share of pairs in the right order.
fn order_grade(given: &[usize], right: &[usize]) -> Option<Grade> {
    let rank = |item: usize| right.iter().position(|right| *right == item);
    let ranks: Option<Vec<usize>> = given.iter().map(|item| rank(*item)).collect();
    let ranks = ranks.filter(|ranks| ranks.len() == right.len())?;
    let pairs = (0..ranks.len()).flat_map(|b| (0..b).map(move |a| (a, b)));
    let (mut count, mut good) = (0u32, 0u32);
    for (a, b) in pairs {
        count += 1;
        good += u32::from(ranks[a] < ranks[b]);
    }
    Some(Grade {
        right: good == count,
        score: f64::from(good) / f64::from(count.max(1)),
        off: None,
    })
}

impl CurveOf {
    /// Whether it is an intensity along the step's line.
    pub fn is_profile(&self) -> bool {
        matches!(self, Self::Profile(_))
    }
}
