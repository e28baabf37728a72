//! Where a wrong answer is off, for answers that agree with no wrong model.

use super::kinds::short_number;
use super::{Grade, Kind, Question, control_name, without_marks};
use crate::text::text;
use serde::{Deserialize, Serialize};

/// Where a wrong answer is off.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub enum Hint {
    /// A number is too high or too low.
    Number {
        /// Too high.
        high: bool,
    },
    /// The value of a control is too high or too low.
    Control {
        /// The number of the control among those of the question.
        control: usize,
        /// Too high.
        high: bool,
    },
    /// A piece of a curve is wrong.
    Curve {
        /// What is the matter with it.
        fault: CurveFault,
        /// The abscissa where it begins.
        from: f64,
        /// The abscissa where it ends.
        to: f64,
    },
    /// A place lies beside the right one.
    Place {
        /// To which side.
        side: Side,
        /// The fraction of its maximum that the quantity has there, where that says something.
        share: Option<f64>,
    },
    /// A place does not lie on the object.
    Beside,
    /// An item is in the wrong place.
    Item {
        /// The number of the item.
        item: usize,
        /// How many places it is too late; negative if it is too early.
        places: isize,
    },
}

/// What is the matter with a piece of a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum CurveFault {
    /// Its values are too high.
    High,
    /// Its values are too low.
    Low,
    /// It should be zero.
    NotZero,
    /// It should be level.
    NotLevel,
    /// Its slope is too large.
    Steep,
    /// Its slope is too small.
    Shallow,
    /// Its slope should be the same all along, or jump at other places.
    Bent,
}

/// A direction in the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Side {
    /// To the left.
    Left,
    /// To the right.
    Right,
    /// Upwards.
    Up,
    /// Downwards.
    Down,
    /// Away from the picture's middle.
    Out,
    /// Towards the picture's middle.
    In,
}

impl Question {
    /// Says which wrong model an answer agrees with, or where it is off; nothing of a right answer. `says` and `names` are the
    /// question's with their numbers.
    pub fn feedback(&self, grade: &Grade, says: &[String], names: &[String]) -> Option<String> {
        let named = grade.model.and_then(|model| says.get(model));
        match (named, grade.hint) {
            (Some(says), _) => Some(says.clone()),
            (None, Some(hint)) => Some(hint.words(&self.kind, names)),
            _ => None,
        }
    }
}

impl Hint {
    /// Returns it as a sentence.
    fn words(&self, kind: &Kind, names: &[String]) -> String {
        let too = |high: bool| {
            if high {
                "lesson-hint-high"
            } else {
                "lesson-hint-low"
            }
        };
        match *self {
            Self::Number { high } => text!(too(high)).to_owned(),
            Self::Control { control, high } => {
                let controls = kind.asks().controls();
                let name = controls.get(control).map(|key| control_name(key));
                let key = if high {
                    "lesson-hint-control-high"
                } else {
                    "lesson-hint-control-low"
                };
                text!(key, name = name.unwrap_or_default())
            }
            Self::Curve { fault, from, to } => curve_words(kind, fault, [from, to]),
            Self::Place { side, share } => {
                let where_to = text!(side.key());
                match share {
                    Some(share) => {
                        let share = short_number(share);
                        text!("lesson-hint-share", side = where_to, share = share)
                    }
                    None => where_to.to_owned(),
                }
            }
            Self::Beside => text!("lesson-hint-beside").to_owned(),
            Self::Item { item, places } => {
                let name = names.get(item).map(|name| without_marks(name));
                let key = if places < 0 {
                    "lesson-hint-early"
                } else {
                    "lesson-hint-late"
                };
                let places = places.unsigned_abs();
                text!(key, item = name.unwrap_or_default(), places = places)
            }
        }
    }
}

impl Side {
    /// Returns the key of its sentence.
    fn key(self) -> &'static str {
        match self {
            Self::Left => "lesson-hint-left",
            Self::Right => "lesson-hint-right",
            Self::Up => "lesson-hint-up",
            Self::Down => "lesson-hint-down",
            Self::Out => "lesson-hint-out",
            Self::In => "lesson-hint-in",
        }
    }
}

/// Returns what is the matter with a curve, and where.
fn curve_words(kind: &Kind, fault: CurveFault, [from, to]: [f64; 2]) -> String {
    let Kind::Curve(curve) = kind else {
        return String::new();
    };
    let fault = text!(match fault {
        CurveFault::High => "lesson-hint-high-there",
        CurveFault::Low => "lesson-hint-low-there",
        CurveFault::NotZero => "lesson-hint-not-zero",
        CurveFault::NotLevel => "lesson-hint-not-level",
        CurveFault::Steep => "lesson-hint-steep",
        CurveFault::Shallow => "lesson-hint-shallow",
        CurveFault::Bent => "lesson-hint-bent",
    });
    let number = |x: f64| short_number(x) + &curve.unit;
    let span = match (from <= curve.x[0], to >= curve.x[1]) {
        (true, true) => text!("lesson-hint-everywhere").to_owned(),
        (true, false) => text!("lesson-hint-up-to", to = number(to)),
        (false, true) => text!("lesson-hint-beyond", from = number(from)),
        (false, false) => text!("lesson-hint-between", from = number(from), to = number(to)),
    };
    text!("lesson-hint-curve", fault = fault, span = span)
}
