//! The feedback to a wrong answer: the wrong model that it agrees with, or where it is off.

use super::kinds::{digits, short_number, with_unit};
use super::{CurveFault, Grade, Hint, Kind, Question, Side, control_name, without_marks};
use crate::text::{fixed, text};

impl Question {
    /// Says which wrong model an answer agrees with, or where it is off; `None` for a right answer. `says` and `names` are the
    /// question's with their numbers filled in.
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
        match *self {
            Self::Number { high: true } => text!("lesson-hint-high").to_owned(),
            Self::Number { high: false } => text!("lesson-hint-low").to_owned(),
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
                let where_to = side_words(side);
                match share {
                    Some(share) => {
                        let share = short_number(share);
                        text!("lesson-hint-share", side = where_to, share = share)
                    }
                    None => where_to.to_owned(),
                }
            }
            Self::Beside => text!("lesson-hint-beside").to_owned(),
            Self::Formula {
                point,
                given,
                expected,
            } => match kind {
                Kind::Formula(formula) => formula.difference_words(point, given, expected),
                _ => String::new(),
            },
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

/// Returns in which direction a place lies beside the right one.
fn side_words(side: Side) -> &'static str {
    text!(match side {
        Side::Left => "lesson-hint-left",
        Side::Right => "lesson-hint-right",
        Side::Up => "lesson-hint-up",
        Side::Down => "lesson-hint-down",
        Side::Out => "lesson-hint-out",
        Side::In => "lesson-hint-in",
    })
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
    // No finer than a hand draws.
    let digits = digits((curve.x[1] - curve.x[0]) / 20.0);
    let number = |x: f64| with_unit(&fixed(x, digits), &curve.unit);
    let span = match (from <= curve.x[0], to >= curve.x[1]) {
        (true, true) => text!("lesson-hint-everywhere").to_owned(),
        (true, false) => text!("lesson-hint-up-to", to = number(to)),
        (false, true) => text!("lesson-hint-beyond", from = number(from)),
        (false, false) => text!("lesson-hint-between", from = number(from), to = number(to)),
    };
    text!("lesson-hint-curve", fault = fault, span = span)
}
