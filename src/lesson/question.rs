//! The questions of a lesson, as they are read.

use super::Prose;
use crate::expression::Expression;
use crate::scene::ShadingMode;
use serde::{Deserialize, Serialize};

/// A question, asked before its answer can be seen.
#[derive(Clone, Debug, PartialEq)]
pub struct Question {
    pub kind: Kind,
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
        options: Vec<ChoiceOption>,
        by: Option<(Extreme, Expression)>,
    },
    /// A number from a field that takes `from` to `to`.
    Value {
        answer: Expression,
        tolerance: f64,
        from: f64,
        to: f64,
        unit: String,
    },
    /// A place in the picture; the tolerance in units of its shorter side.
    Point { find: Find, tolerance: f64 },
    /// A curve drawn over `x`; the tolerance is the mean distance as a share of `y`.
    Curve {
        x: [f64; 2],
        y: [f64; 2],
        x_name: Prose,
        y_name: Prose,
        of: CurveOf,
        tolerance: f64,
    },
    /// A setting of one control that makes something so.
    Settings {
        /// A key.
        control: String,
        reach: Expression,
        goal: Goal,
        /// Of what is reached, or for an extreme of the control's own value.
        tolerance: f64,
    },
    /// Things from the least to the greatest.
    Order { items: Vec<Item>, by: Expression },
    /// Settings that make a picture like another one.
    Match {
        /// Keys.
        controls: Vec<String>,
        values: MatchValues,
        /// Root mean square of the difference.
        tolerance: f64,
    },
}

/// The part of the equation that a question is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Term {
    Ambient,
    Diffuse,
    Specular,
    Attenuation,
    Transmission,
    Lights,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extreme {
    Greatest,
    Least,
}

/// An option of a choice.
#[derive(Clone, Debug, PartialEq)]
pub struct ChoiceOption {
    pub text: Prose,
    /// Whether it is right, where the lesson says so or an expression decides.
    pub right: Option<RightIf>,
    /// Settings of its scene.
    pub set: Vec<String>,
}

/// What makes an option right.
#[derive(Clone, Debug, PartialEq)]
pub enum RightIf {
    Said(bool),
    Holds(Expression),
}

/// Where the right place of a point lies.
#[derive(Clone, Debug, PartialEq)]
pub enum Find {
    Brightest,
    Darkest,
    Extreme(Extreme, Expression),
    /// Anywhere that its sign changes.
    Zero(Expression),
    /// Where the slope along the step's line jumps most in this mode.
    Corner(ShadingMode),
}

#[derive(Clone, Debug, PartialEq)]
pub enum CurveOf {
    /// Of `x`.
    Expression(Expression),
    /// The intensity along the step's line in this mode.
    Profile(ShadingMode),
}

#[derive(Clone, Debug, PartialEq)]
pub enum Goal {
    Equals(Expression),
    Extreme(Extreme),
}

/// One of the things to be sorted.
#[derive(Clone, Debug, PartialEq)]
pub struct Item {
    pub text: Prose,
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

    /// Whether its answer is a drawing.
    pub fn is_drawn(&self) -> bool {
        matches!(self, Self::Curve { .. })
    }
}
