//! A typed formula as a function of the names of a question, in double precision.

use super::domain::{Name, Values};
use crate::expression::{Formula, FormulaError, Names, Operator, Position, Term, Type, Typed};
use crate::figure::raised;
use crate::text::{fixed, text, with_minus};
use glam::DVec3;

/// A value of a name or of a formula.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Quantity {
    /// A number.
    Number(f64),
    /// A vector.
    Vector([f64; 3]),
}

/// A formula over the names of a question.
///
/// It is evaluated as on paper, with the arithmetic of IEEE 754: 1/0 is infinite, 0/0 and the square root of a negative number
/// are none. A formula without a finite value at a point has no value there.
#[derive(Clone, Debug, PartialEq)]
pub struct Function {
    formula: Formula,
    /// For each name of the formula its place among those of the question.
    places: Vec<usize>,
}

impl Function {
    /// Reads a formula whose value is a number or a vector.
    pub fn read(text: &str, names: &[Name]) -> Result<Self, FormulaError> {
        let of = |wanted: bool| {
            let names = names.iter().enumerate();
            let is_vector = |name: &Name| name.values == Values::Directions;
            let names = names.filter(move |(_, name)| is_vector(name) == wanted);
            names.map(|(place, name)| (place, &*name.name))
        };
        let [numbers, vectors] =
            [false, true].map(|wanted| of(wanted).map(|(_, name)| name).collect::<Vec<_>>());
        let known = Names::new(&numbers, &vectors);
        Ok(Self {
            formula: Formula::read_value(text, &known)?,
            places: of(false).chain(of(true)).map(|(place, _)| place).collect(),
        })
    }

    /// Returns whether a formula can have a name.
    pub fn can_be_name(name: &str) -> bool {
        Names::is_name(name)
    }

    /// Returns it if its value is what is asked for: a vector, or a number.
    pub fn if_expected(self, vector: bool) -> Result<Self, FormulaError> {
        if self.is_vector() == vector {
            return Ok(self);
        }
        let message = if vector {
            text!("lesson-formula-vector-expected")
        } else {
            text!("lesson-formula-number-expected")
        };
        let text = self.formula.text();
        let last = text.lines().last().unwrap_or_default();
        Err(FormulaError {
            position: Position {
                line: text.lines().count().max(1),
                column: 1 + last.chars().count(),
            },
            message: message.to_owned(),
        })
    }

    /// Returns whether its value is a vector.
    pub fn is_vector(&self) -> bool {
        let last = self.formula.lines().last();
        last.is_some_and(|line| line.value.kind == Type::Vector)
    }

    /// Returns whether the name at a place of the question appears in it.
    pub fn uses(&self, place: usize) -> bool {
        fn any(part: &Typed, holds: &dyn Fn(usize) -> bool) -> bool {
            match &part.term {
                Term::Name(index) => holds(*index),
                Term::Call(_, parts) => parts.iter().any(|part| any(part, holds)),
                _ => false,
            }
        }
        let holds = |index: usize| self.places.get(index) == Some(&place);
        let mut lines = self.formula.lines().iter();
        lines.any(|line| any(&line.value, &holds))
    }

    /// Returns the number of its names, numbers and operations.
    pub fn size(&self) -> usize {
        fn size(part: &Typed) -> usize {
            match &part.term {
                Term::Call(_, parts) => 1 + parts.iter().map(size).sum::<usize>(),
                _ => 1,
            }
        }
        let lines = self.formula.lines().iter();
        lines.map(|line| size(&line.value)).sum()
    }

    /// Evaluates it with the values of the question's names; none where it has no finite value.
    pub fn at(&self, values: &[Quantity]) -> Option<Quantity> {
        let mut place = Place {
            values,
            places: &self.places,
            lines: Vec::new(),
        };
        for line in self.formula.lines() {
            let value = place.value(&line.value);
            place.lines.push(value);
        }
        let value = place.lines.pop()?;
        value.is_finite().then_some(value)
    }
}

/// The values of names and lines.
struct Place<'p> {
    values: &'p [Quantity],
    places: &'p [usize],
    lines: Vec<Quantity>,
}

impl Place<'_> {
    fn value(&self, part: &Typed) -> Quantity {
        match &part.term {
            Term::Number(number) => Quantity::Number(*number),
            Term::Name(index) => self.values[self.places[*index]],
            Term::Line(line) => self.lines[*line],
            Term::Call(operator, parts) => self.call(*operator, parts),
        }
    }

    fn number(&self, part: &Typed) -> f64 {
        self.value(part).components()[0]
    }

    fn vector(&self, part: &Typed) -> DVec3 {
        DVec3::from_array(self.value(part).components())
    }

    fn call(&self, operator: Operator, parts: &[Typed]) -> Quantity {
        use Operator as Op;
        let number = |index: usize| self.number(&parts[index]);
        let vector = |index: usize| self.vector(&parts[index]);
        let is_vector = |index: usize| parts[index].kind == Type::Vector;
        let all = || parts.iter().map(|part| self.number(part));
        let truth = |holds: bool| f64::from(u8::from(holds));
        let result = match operator {
            Op::Add if is_vector(0) => return Quantity::from(vector(0) + vector(1)),
            Op::Subtract if is_vector(0) => return Quantity::from(vector(0) - vector(1)),
            Op::Negate if is_vector(0) => return Quantity::from(-vector(0)),
            Op::Multiply if is_vector(0) => return Quantity::from(vector(0) * number(1)),
            Op::Multiply if is_vector(1) => return Quantity::from(number(0) * vector(1)),
            Op::Divide if is_vector(0) => return Quantity::from(vector(0) / number(1)),
            Op::Mix if is_vector(0) => {
                return Quantity::from(vector(0) + (vector(1) - vector(0)) * number(2));
            }
            Op::Cross => return Quantity::from(vector(0).cross(vector(1))),
            Op::Normalize => return Quantity::from(vector(0) / vector(0).length()),
            Op::Dot => vector(0).dot(vector(1)),
            Op::Length => vector(0).length(),
            Op::Component(axis) => self.value(&parts[0]).components()[axis],
            Op::Negate => -number(0),
            Op::Add => number(0) + number(1),
            Op::Subtract => number(0) - number(1),
            Op::Multiply => number(0) * number(1),
            Op::Divide => number(0) / number(1),
            Op::Power => number(0).powf(number(1)),
            Op::Min => all().fold(f64::INFINITY, least),
            Op::Max => -all().map(|x| -x).fold(f64::INFINITY, least),
            Op::Sum => all().sum(),
            Op::Mean => all().sum::<f64>() / parts.len() as f64,
            Op::Abs => number(0).abs(),
            Op::Sqrt => number(0).sqrt(),
            Op::Exp => number(0).exp(),
            Op::Log => number(0).ln(),
            Op::Floor => number(0).floor(),
            Op::Round => number(0).round(),
            Op::Sin => number(0).to_radians().sin(),
            Op::Cos => number(0).to_radians().cos(),
            Op::Tan => number(0).to_radians().tan(),
            Op::Asin => number(0).asin().to_degrees(),
            Op::Acos => number(0).acos().to_degrees(),
            Op::Atan => number(0).atan().to_degrees(),
            Op::Clamp => least(-least(-number(0), -number(1)), number(2)),
            Op::Mix => number(0) + (number(1) - number(0)) * number(2),
            Op::Step => truth(number(1) >= number(0)),
            Op::Smoothstep => {
                let t = ((number(2) - number(0)) / (number(1) - number(0))).clamp(0.0, 1.0);
                t * t * (3.0 - 2.0 * t)
            }
            Op::Less => truth(number(0) < number(1)),
            Op::LessEqual => truth(number(0) <= number(1)),
            Op::Greater => truth(number(0) > number(1)),
            Op::GreaterEqual => truth(number(0) >= number(1)),
            Op::Equal => truth(number(0) == number(1)),
            Op::NotEqual => truth(number(0) != number(1)),
            Op::And => truth(number(0) != 0.0 && number(1) != 0.0),
            Op::Or => truth(number(0) != 0.0 || number(1) != 0.0),
            Op::Not => truth(number(0) == 0.0),
        };
        Quantity::Number(result)
    }
}

/// Returns the smaller of two numbers; none of them where one is none, unlike `f64::min`.
fn least(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() {
        f64::NAN
    } else {
        a.min(b)
    }
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

    fn is_finite(self) -> bool {
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
