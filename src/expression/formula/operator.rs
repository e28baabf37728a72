//! The operations of formulas.

use crate::expression::functions::Function;

/// An operation of a formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[expect(missing_docs, reason = "their names say what they are")]
#[non_exhaustive]
pub enum Operator {
    Negate,
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    Min,
    Max,
    Sum,
    Mean,
    Abs,
    Sqrt,
    Exp,
    Log,
    Floor,
    Round,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Clamp,
    Mix,
    Step,
    Smoothstep,
    Dot,
    Cross,
    Length,
    Normalize,
    /// The component along x, y or z: 0, 1 or 2.
    Component(usize),
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Equal,
    NotEqual,
    And,
    Or,
    Not,
}

impl Operator {
    /// Returns whether its result jumps where an operand is a certain number.
    pub(crate) fn is_step(&self) -> bool {
        matches!(
            self,
            Self::Floor
                | Self::Round
                | Self::Step
                | Self::Less
                | Self::LessEqual
                | Self::Greater
                | Self::GreaterEqual
                | Self::Equal
                | Self::NotEqual
        )
    }

    /// Returns the operation of a function of the grammar; none for one that formulas do not have.
    pub(super) fn of(function: Function) -> Option<Self> {
        Some(match function.0 {
            "negate" => Self::Negate,
            "+" => Self::Add,
            "-" => Self::Subtract,
            // The types tell the product of numbers from that of vectors.
            "*" | "·" => Self::Multiply,
            "/" => Self::Divide,
            "^" | "pow" => Self::Power,
            "min" => Self::Min,
            "max" => Self::Max,
            "sum" => Self::Sum,
            "mean" => Self::Mean,
            "abs" => Self::Abs,
            "sqrt" => Self::Sqrt,
            "exp" => Self::Exp,
            "log" => Self::Log,
            "floor" => Self::Floor,
            "round" => Self::Round,
            "sin" => Self::Sin,
            "cos" => Self::Cos,
            "tan" => Self::Tan,
            "asin" => Self::Asin,
            "acos" => Self::Acos,
            "atan" => Self::Atan,
            "clamp" => Self::Clamp,
            "mix" => Self::Mix,
            "step" => Self::Step,
            "smoothstep" => Self::Smoothstep,
            "dot" => Self::Dot,
            "cross" => Self::Cross,
            "length" => Self::Length,
            "normalize" => Self::Normalize,
            "<" => Self::Less,
            "<=" => Self::LessEqual,
            ">" => Self::Greater,
            ">=" => Self::GreaterEqual,
            "==" => Self::Equal,
            "!=" => Self::NotEqual,
            "and" => Self::And,
            "or" => Self::Or,
            "not" => Self::Not,
            _ => return None,
        })
    }
}
