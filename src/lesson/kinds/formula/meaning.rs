//! The meaning of formulas: whether two of them are the same function of their names, and where they differ most.

use super::domain::{Name, points};
use super::function::Function;
use super::quantity::Quantity;

/// The largest difference of two values that count as equal, as a fraction of the larger one or, near 0, of the largest value
/// of the right answer, counted as 1 at most. Spellings of one function differ by less than 10⁻⁹ through rounding, and by 10⁻⁷
/// where a constant is typed with seven digits; the smallest difference that a picture can show, a code value, is 4·10⁻³.
const TOLERANCE: f64 = 1e-6;
/// The difference between a value and none, in tolerances: as much as between 1 and 0.
const UNDEFINED: f64 = 1.0 / TOLERANCE;
/// The part of the points at which a right answer must have a value.
const DEFINED: f64 = 0.5;
/// The part of the way to another point of the domain at which a gap is looked at from nearby.
const NEARBY: f64 = 1e-6;

/// The place where two formulas differ most.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference {
    /// The number of the point.
    pub point: usize,
    /// The value of the first formula, if it has one there.
    pub given: Option<Quantity>,
    /// The value of the second one.
    pub expected: Option<Quantity>,
    /// Their greatest distance, in tolerances.
    pub off: f64,
}

/// The points at which formulas are compared: those of the domain at which the right answer has a value.
///
/// Two formulas are the same if at each of these points both have the same value or both have none. Where only one has a value,
/// as `x/x` has none at 0, they are still the same there if they are so nearby: a gap that its neighbours fill is no
/// difference.
pub struct Field {
    points: Vec<Vec<Quantity>>,
    /// The numbers of the points that count.
    defined: Vec<usize>,
    /// The largest value of the right answer, 1 at most.
    scale: f64,
    /// True if the right answer has the same value everywhere.
    pub constant: bool,
}

impl Field {
    /// Evaluates the right answer over the domain.
    pub fn new(names: &[Name], right: &Function) -> Self {
        let points = points(names);
        let (mut defined, mut scale, mut constant) = (Vec::new(), 0.0f64, true);
        let mut first = None;
        for (index, point) in points.iter().enumerate() {
            if let Some(value) = right.at(point) {
                defined.push(index);
                scale = scale.max(value.greatest());
                constant &= value.apart(*first.get_or_insert(value)) <= TOLERANCE * scale;
            }
        }
        Self {
            points,
            defined,
            scale: scale.min(1.0),
            constant,
        }
    }

    /// Returns whether the right answer has a value in most of the domain.
    pub fn is_defined(&self) -> bool {
        self.defined.len() as f64 >= DEFINED * self.points.len() as f64
    }

    /// Returns whether two formulas are the same function.
    pub fn same(&self, a: &Function, b: &Function) -> bool {
        let mut defined = self.defined.iter();
        defined.all(|index| self.off(&self.points[*index], a, b).1 <= 1.0)
    }

    /// Finds the place where two formulas differ most; none if they are the same function.
    pub fn difference(&self, given: &Function, expected: &Function) -> Option<Difference> {
        let (mut most, mut found, mut off) = (-1.0, None, 0.0f64);
        for index in &self.defined {
            let point = &self.points[*index];
            let (apart, tolerances) = self.off(point, given, expected);
            off = off.max(tolerances);
            if tolerances > 1.0 && apart > most {
                most = apart;
                found = Some(*index);
            }
        }
        let point = found?;
        let [given, expected] = [given, expected].map(|formula| formula.at(&self.points[point]));
        Some(Difference {
            point,
            given,
            expected,
            off,
        })
    }

    /// Returns how far apart two formulas are at a point, 0 where one has no value, and in tolerances.
    fn off(&self, point: &[Quantity], a: &Function, b: &Function) -> (f64, f64) {
        match (a.at(point), b.at(point)) {
            (None, None) => (0.0, 0.0),
            (Some(a), Some(b)) => (a.apart(b), self.tolerances(a, b)),
            _ => match self
                .nearby(point)
                .map(|nearby| (a.at(&nearby), b.at(&nearby)))
            {
                Some((Some(a), Some(b))) if self.tolerances(a, b) <= 1.0 => (0.0, 0.0),
                _ => (0.0, UNDEFINED),
            },
        }
    }

    fn tolerances(&self, a: Quantity, b: Quantity) -> f64 {
        let allowed = TOLERANCE * a.greatest().max(b.greatest()).max(self.scale);
        if allowed > 0.0 {
            a.apart(b) / allowed
        } else {
            0.0
        }
    }

    /// Returns a point next to another one, on the way to the last.
    fn nearby(&self, point: &[Quantity]) -> Option<Vec<Quantity>> {
        let towards = self.points.last()?.iter();
        let moved = point.iter().zip(towards);
        Some(moved.map(|(from, to)| from.towards(*to, NEARBY)).collect())
    }
}
