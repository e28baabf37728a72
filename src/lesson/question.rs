//! The questions of a lesson, as they are read.

use super::Prose;
use crate::expression::Expression;
use crate::scene::ShadingMode;
use serde::{Deserialize, Serialize};

/// A question, asked before its answer can be seen.
#[derive(Clone, Debug, PartialEq)]
pub struct Question {
    /// What kind of answer it wants.
    pub kind: Kind,
    /// What is asked, with numbers that the engine fills in.
    pub ask: Prose,
    /// Why the answer is right; may be empty.
    pub why: Prose,
    /// The part of the equation that it is about.
    pub term: Option<Term>,
    /// Settings for the right answer alone.
    pub set: Vec<String>,
    /// Where it stands in the file, from 1.
    pub line: u64,
}

/// What kind of answer is asked for.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    /// One of several; `by` where the scenes of the options decide.
    Choice {
        /// What can be chosen.
        options: Vec<ChoiceOption>,
        /// The option is right whose scene has the greatest or the least value of this.
        by: Option<(Extreme, Expression)>,
    },
    /// A number from a field that takes `from` to `to`.
    Value {
        /// Its value is right.
        answer: Expression,
        /// Greatest distance from it that counts as right.
        tolerance: f64,
        /// Least number that can be entered.
        from: f64,
        /// Greatest number that can be entered.
        to: f64,
        /// What stands behind the field; may be empty.
        unit: String,
    },
    /// A place in the picture; the tolerance in units of its shorter side.
    Point {
        /// What is looked for.
        find: Find,
        /// Greatest distance from it that counts as right.
        tolerance: f64,
    },
    /// A curve drawn over `x`; the tolerance is the mean distance as a share of `y`.
    Curve {
        /// Where the abscissae begin and end.
        x: [f64; 2],
        /// Where the ordinates begin and end.
        y: [f64; 2],
        /// What the horizontal axis measures.
        x_name: Prose,
        /// What the vertical axis measures.
        y_name: Prose,
        /// The right curve.
        of: CurveOf,
        /// The greatest mean distance that counts as right.
        tolerance: f64,
    },
    /// A setting of one control that makes something so.
    Settings {
        /// A key.
        control: String,
        /// What is to become so.
        reach: Expression,
        /// What it is to become.
        goal: Goal,
        /// Of what is reached, or for an extreme of the control's own value.
        tolerance: f64,
    },
    /// Things from the least to the greatest.
    Order {
        /// What is to be sorted.
        items: Vec<Item>,
        /// What they are sorted by, evaluated in the scene of each.
        by: Expression,
    },
    /// Settings that make a picture like another one.
    Match {
        /// Keys.
        controls: Vec<String>,
        /// Where the values come from.
        values: MatchValues,
        /// Root mean square of the difference.
        tolerance: f64,
    },
}

/// The part of the equation that a question is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Term {
    /// The ambient term.
    Ambient,
    /// The diffuse term.
    Diffuse,
    /// The specular term.
    Specular,
    /// The factor f.
    Attenuation,
    /// What comes through the surface.
    Transmission,
    /// The sum over the lights.
    Lights,
}

/// Which end of a range is looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extreme {
    /// The greatest value.
    Greatest,
    /// The least value.
    Least,
}

/// An option of a choice.
#[derive(Clone, Debug, PartialEq)]
pub struct ChoiceOption {
    /// What it says.
    pub text: Prose,
    /// Whether it is right, where the lesson says so or an expression decides.
    pub right: Option<RightIf>,
    /// Settings of its scene.
    pub set: Vec<String>,
}

/// What makes an option right.
#[derive(Clone, Debug, PartialEq)]
pub enum RightIf {
    /// The lesson says whether.
    Said(bool),
    /// It is right where this is true.
    Holds(Expression),
}

/// Where the right place of a point lies.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Find {
    /// The pixel of the greatest luminance.
    Brightest,
    /// The pixel of the object of the least luminance.
    Darkest,
    /// Where this is greatest or least in the picture.
    Extreme(Extreme, Expression),
    /// Anywhere that its sign changes.
    Zero(Expression),
    /// Where the slope along the step's line jumps most in this mode.
    Corner(ShadingMode),
}

/// Which curve is to be drawn.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum CurveOf {
    /// Of `x`.
    Expression(Expression),
    /// The intensity along the step's line in this mode.
    Profile(ShadingMode),
}

/// What a setting is to reach.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Goal {
    /// This value.
    Equals(Expression),
    /// The greatest or the least value.
    Extreme(Extreme),
}

/// One of the things to be sorted.
#[derive(Clone, Debug, PartialEq)]
pub struct Item {
    /// What it says.
    pub text: Prose,
    /// Settings of its scene.
    pub set: Vec<String>,
}

/// Where the values of a picture to be matched come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MatchValues {
    /// From the question's settings.
    Given,
    /// From a seed.
    Random,
}

impl Kind {
    /// As a lesson has it.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Choice { .. } => "choice",
            Self::Value { .. } => "value",
            Self::Point { .. } => "point",
            Self::Curve { .. } => "curve",
            Self::Settings { .. } => "settings",
            Self::Order { .. } => "order",
            Self::Match { .. } => "match",
        }
    }

    /// Whether its answer is one number.
    pub fn predicts_number(&self) -> bool {
        matches!(self, Self::Value { .. } | Self::Settings { .. })
    }

    /// Whether each student has another right answer, by the seed.
    pub(super) fn is_drawn_at_random(&self) -> bool {
        matches!(
            self,
            Self::Match {
                values: MatchValues::Random,
                ..
            }
        )
    }

    /// Whether its answer is a drawing.
    pub fn is_drawn(&self) -> bool {
        matches!(self, Self::Curve { .. })
    }
}
