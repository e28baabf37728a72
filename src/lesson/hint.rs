//! The error of a wrong answer that agrees with no wrong model.

use serde::{Deserialize, Serialize};

/// The error of a wrong answer.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub enum Hint {
    /// A number is too high or too low.
    Number {
        /// True if it is too high.
        high: bool,
    },
    /// The value of a control is too high or too low.
    Control {
        /// The number of the control among those of the question.
        control: usize,
        /// True if it is too high.
        high: bool,
    },
    /// A piece of a curve is wrong.
    Curve {
        /// Its fault.
        fault: CurveFault,
        /// The abscissa where it begins.
        from: f64,
        /// The abscissa where it ends.
        to: f64,
    },
    /// A place lies beside the right one.
    Place {
        /// The side.
        side: Side,
        /// The fraction of its maximum that the quantity has there, where that says something.
        share: Option<f64>,
    },
    /// A place does not lie on the object.
    Beside,
    /// A formula has another value than the right one.
    Formula {
        /// The number of the point of the domain where they differ most.
        point: usize,
        /// The components of the value there, of a number the first; `None` if there is no value.
        given: Option<[f64; 3]>,
        /// The components of the right value; `None` if that has none.
        expected: Option<[f64; 3]>,
    },
    /// An item is in the wrong place.
    Item {
        /// The number of the item.
        item: usize,
        /// The number of places by which it is too late; negative if it is too early.
        places: isize,
    },
}

/// The fault of a piece of a curve.
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
