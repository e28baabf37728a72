//! A typed formula as a function of the names of a question, in double precision.

use super::domain::{Name, Values};
use super::quantity::Quantity;
use crate::expression::{Formula, FormulaError, Names, Operator, Position, Term, Type, Typed};
use crate::text::text;
use glam::DVec3;

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
        self.formula
            .names_any(&|index| self.places.get(index) == Some(&place))
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
        let mut place = Bindings {
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
struct Bindings<'p> {
    values: &'p [Quantity],
    places: &'p [usize],
    lines: Vec<Quantity>,
}

impl Bindings<'_> {
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
