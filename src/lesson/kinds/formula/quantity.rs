//! Values of names and of formulas: numbers and vectors.

use crate::figure::raised;
use crate::text::{fixed, with_minus};
use glam::DVec3;

/// A value of a name or of a formula.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Quantity {
    /// A number.
    Number(f64),
    /// A vector.
    Vector([f64; 3]),
}

impl From<DVec3> for Quantity {
    fn from(vector: DVec3) -> Self {
        Self::Vector(vector.to_array())
    }
}

impl Quantity {
    /// Returns the components of a vector, or a number and two zeros.
    pub fn components(self) -> [f64; 3] {
        match self {
            Self::Number(number) => [number, 0.0, 0.0],
            Self::Vector(vector) => vector,
        }
    }

    /// Returns whether all its components are finite.
    pub fn is_finite(self) -> bool {
        self.components().into_iter().all(f64::is_finite)
    }

    /// Returns its largest component, without its sign.
    pub fn greatest(self) -> f64 {
        self.components()
            .into_iter()
            .fold(0.0, |most, x| most.max(x.abs()))
    }

    /// Returns the largest difference of the components of two values.
    pub fn apart(self, other: Self) -> f64 {
        let [a, b] = [self, other].map(|value| DVec3::from_array(value.components()));
        (a - b).abs().max_element()
    }

    /// Returns the value a part of the way to another one of its kind; of unit vectors a unit vector.
    pub fn towards(self, other: Self, part: f64) -> Self {
        match (self, other) {
            (Self::Vector(from), Self::Vector(to)) => {
                let [from, to] = [from, to].map(DVec3::from_array);
                Self::from(from.lerp(to, part).normalize())
            }
            _ => Self::Number(
                self.components()[0] + (other.components()[0] - self.components()[0]) * part,
            ),
        }
    }

    /// Returns it in so many significant digits.
    pub fn words(self, digits: usize) -> String {
        match self {
            Self::Number(number) => number_words(number, digits),
            Self::Vector(vector) => {
                let components = vector.map(|component| number_words(component, digits));
                format!("({})", components.join(", "))
            }
        }
    }
}

fn number_words(number: f64, digits: usize) -> String {
    let size = number.abs();
    let trimmed = |text: &str| match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text.to_owned(),
    };
    if size < 1e-12 {
        return "0".to_owned();
    }
    if (1e-3..1e6).contains(&size) {
        let decimals = digits as i32 - 1 - size.log10().floor() as i32;
        return trimmed(&fixed(number, decimals.max(0) as usize));
    }
    let text = format!("{number:.*e}", digits.saturating_sub(1));
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let exponent = raised(exponent.parse().unwrap_or(0));
    format!("{}·10{exponent}", with_minus(&trimmed(mantissa)))
}
