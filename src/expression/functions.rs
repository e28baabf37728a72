//! Functions and operators by name, with their meaning for numbers.

/// A function or an operator with its name, which no other has.
#[derive(Clone, Copy, Debug)]
pub(super) struct Function(pub &'static str, pub Operation);

impl PartialEq for Function {
    fn eq(&self, other: &Self) -> bool {
        self.0 == other.0
    }
}

/// The meaning of a function.
#[derive(Clone, Copy, Debug)]
pub(super) enum Operation {
    One(fn(f64) -> f64),
    Two(fn(f64, f64) -> f64),
    Three(fn(f64, f64, f64) -> f64),
    Compare(fn(f64, f64) -> bool),
    And,
    Or,
    Not,
    /// Of the numbers of a list, at least one.
    List(fn(&[f64]) -> f64),
    /// Of the numbers of any arguments, at least one.
    All(fn(&[f64]) -> f64),
    Luminance,
    Dot,
    Cross,
    Normalize,
}

use Operation::*;

pub(super) const ADD: Function = Function("+", Two(|a, b| a + b));
pub(super) const SUBTRACT: Function = Function("-", Two(|a, b| a - b));
pub(super) const MULTIPLY: Function = Function("*", Two(|a, b| a * b));
/// The middle dot: the product of numbers; in formulas also of vectors.
pub(super) const MIDDLE_DOT: Function = Function("·", Two(|a, b| a * b));
pub(super) const DIVIDE: Function = Function("/", Two(|a, b| a / b));
pub(super) const POWER: Function = Function("^", Two(f64::powf));
pub(super) const NEGATE: Function = Function("negate", One(|x| -x));
pub(super) const SQRT: Function = Function("sqrt", One(f64::sqrt));
pub(super) const DOT: Function = Function("dot", Dot);
pub(super) const AND: Function = Function("and", And);
pub(super) const OR: Function = Function("or", Or);
pub(super) const NOT: Function = Function("not", Not);

/// Functions called by name.
pub(super) const NAMED: [Function; 26] = [
    SQRT,
    Function("abs", One(f64::abs)),
    Function(
        "min",
        All(|all| all.iter().copied().fold(f64::INFINITY, f64::min)),
    ),
    Function(
        "max",
        All(|all| all.iter().copied().fold(f64::NEG_INFINITY, f64::max)),
    ),
    Function("sum", All(|all| all.iter().sum())),
    Function(
        "mean",
        All(|all| all.iter().sum::<f64>() / all.len() as f64),
    ),
    Function("exp", One(f64::exp)),
    Function("log", One(f64::ln)),
    Function("pow", Two(f64::powf)),
    Function("round", One(f64::round)),
    Function("floor", One(f64::floor)),
    Function(
        "clamp",
        Three(|x, least, greatest| x.max(least).min(greatest)),
    ),
    Function("mix", Three(|a, b, t| t.mul_add(b - a, a))),
    Function("step", Two(|edge, x| if x < edge { 0.0 } else { 1.0 })),
    Function("smoothstep", Three(smoothstep)),
    Function("sin", One(|x| x.to_radians().sin())),
    Function("cos", One(|x| x.to_radians().cos())),
    Function("tan", One(|x| x.to_radians().tan())),
    Function("asin", One(|x| x.asin().to_degrees())),
    Function("acos", One(|x| x.acos().to_degrees())),
    Function("atan", One(|x| x.atan().to_degrees())),
    Function("luminance", Luminance),
    DOT,
    Function(
        "length",
        List(|all| all.iter().map(|x| x * x).sum::<f64>().sqrt()),
    ),
    Function("cross", Cross),
    Function("normalize", Normalize),
];

/// Returns Hermite's cubic between two edges: 0 below the first, 1 above the second.
fn smoothstep(low: f64, high: f64, x: f64) -> f64 {
    let t = ((x - low) / (high - low)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// Comparisons by their signs; 0 and −0 are equal.
pub(super) const COMPARISONS: [(&str, Function); 8] = [
    ("<=", Function("<=", Compare(|a, b| a <= b))),
    ("≤", Function("<=", Compare(|a, b| a <= b))),
    (">=", Function(">=", Compare(|a, b| a >= b))),
    ("≥", Function(">=", Compare(|a, b| a >= b))),
    ("==", Function("==", Compare(|a, b| a == b))),
    ("!=", Function("!=", Compare(|a, b| a != b))),
    ("<", Function("<", Compare(|a, b| a < b))),
    (">", Function(">", Compare(|a, b| a > b))),
];

/// Constants by name.
pub(super) const CONSTANTS: [(&str, f64); 3] = [
    ("pi", std::f64::consts::PI),
    ("inf", f64::INFINITY),
    ("infinity", f64::INFINITY),
];

impl Function {
    /// Returns the number of its arguments where it is called by name; none if any number is allowed.
    pub fn arguments(self) -> Option<usize> {
        match self.1 {
            All(_) => None,
            Dot | Cross | Two(_) | Compare(_) | And | Or => Some(2),
            Three(_) => Some(3),
            One(_) | Not | List(_) | Luminance | Normalize => Some(1),
        }
    }
}

/// Letters that are read as the name of the letter.
const LETTERS: [(char, &str); 18] = [
    ('α', "alpha"),
    ('β', "beta"),
    ('γ', "gamma"),
    ('δ', "delta"),
    ('Δ', "Delta"),
    ('ε', "epsilon"),
    ('η', "eta"),
    ('θ', "theta"),
    ('ϑ', "theta"),
    ('λ', "lambda"),
    ('μ', "mu"),
    ('ρ', "rho"),
    ('σ', "sigma"),
    ('τ', "tau"),
    ('φ', "phi"),
    ('ϕ', "phi"),
    ('ψ', "psi"),
    ('ω', "omega"),
];

/// Returns how a character of a name is read: a Greek letter as its name, a subscript digit as a digit; none for a
/// character that is in no name.
pub(crate) fn in_name(c: char) -> Option<String> {
    if c.is_ascii_alphanumeric() || c == '_' {
        return Some(c.to_string());
    }
    if let Some(digit) = ('₀'..='₉').position(|digit| digit == c) {
        return Some(digit.to_string());
    }
    let letter = LETTERS.iter().find(|(letter, _)| *letter == c)?;
    Some(letter.1.to_owned())
}
