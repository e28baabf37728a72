//! The domain of a formula: what its names may be, and the points at which two formulas are compared.
//!
//! The first points are the corners of the domain, the next ones lie on its edges and faces and where a name is 0 or 1, the
//! others are spread evenly in it. All are round numbers, so that a point that is shown is the one that was computed.

use super::quantity::Quantity;
use crate::bits::SplitMix64;

/// The number of points at which formulas are compared.
pub const POINTS: usize = 4096;
/// Most corners; a domain of up to eight names has all of them among its points.
const CORNERS: usize = 256;
/// The number of points before those inside: corners, edges and faces.
const EDGES: usize = 1024;
/// The ratio of the ends of a range above which points are spread evenly by their logarithm: of exponents from 1 to
/// 1000, most of what is seen happens below 30.
const WIDE: f64 = 50.0;

/// A name with the values that it may have.
#[derive(Clone, Debug, PartialEq)]
pub struct Name {
    /// The name as it is typed.
    pub name: String,
    /// Its values.
    pub values: Values,
}

/// The values of a name.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Values {
    /// Numbers from the first to the second.
    Between(f64, f64),
    /// Unit vectors in any direction.
    Directions,
}

/// The ranges of names that need none in a lesson: names, and the ends of their range.
const KNOWN: [(&[&str], [f64; 2]); 8] = [
    (
        &[
            "ka", "kd", "ks", "kt", "od", "os", "ia", "ip", "f", "c1", "c2", "c3",
        ],
        [0.0, 1.0],
    ),
    (&["alpha", "s", "t", "s0", "w", "w0"], [0.0, 1.0]),
    (&["n"], [1.0, 1005.0]),
    (&["m"], [0.05, 1.0]),
    (&["eta"], [1.0, 3.0]),
    (&["d", "r", "z"], [0.1, 10.0]),
    (&["theta"], [0.0, 90.0]),
    (&["phi"], [0.0, 180.0]),
];

/// Unit vectors whose components have two decimals at most, up to the order and the signs of the components.
const ROUND: [[f64; 3]; 5] = [
    [0.0, 0.0, 1.0],
    [0.0, 0.6, 0.8],
    [0.36, 0.48, 0.8],
    [0.48, 0.6, 0.64],
    [0.0, 0.28, 0.96],
];

impl Values {
    /// Returns the values of a name that everybody knows: coefficients and intensities from 0 to 1, cosines from −1 to 1.
    pub fn of(name: &str) -> Option<Self> {
        let known = KNOWN.iter().find(|(names, _)| names.contains(&name));
        if let Some((_, [from, to])) = known {
            return Some(Self::Between(*from, *to));
        }
        let mut letters = name.chars();
        let vector = letters.next().is_some_and(|first| "NLVRH".contains(first));
        match (vector, letters.as_str()) {
            (true, "") => Some(Self::Directions),
            (true, "x" | "y" | "z") => Some(Self::Between(-1.0, 1.0)),
            _ if name.contains('·') => Some(Self::Between(-1.0, 1.0)),
            (false, digits) if name.starts_with('I') && is_index(digits) => {
                Some(Self::Between(0.0, 1.0))
            }
            _ => None,
        }
    }

    /// Returns the value at a fraction of the range, rounded to hundredths of the width's power of ten, or to
    /// thousandths if `finer`; in a wide range to three digits.
    fn at(self, fraction: f64, directions: &[[f64; 3]], finer: bool) -> Quantity {
        match self {
            Self::Between(from, to) if from > 0.0 && to / from > WIDE => {
                let value = from * (to / from).powf(fraction);
                Quantity::Number(significant(value, 3).clamp(from, to))
            }
            Self::Between(from, to) => {
                let value = from + (to - from) * fraction;
                let digits = if finer { 3.0 } else { 2.0 } - (to - from).log10().floor();
                Quantity::Number(rounded(value, digits as i32).clamp(from, to))
            }
            Self::Directions => {
                let place = (fraction * directions.len() as f64) as usize;
                Quantity::Vector(directions[place.min(directions.len() - 1)])
            }
        }
    }

    /// Returns the end of the range, or a value at which formulas often change: 0, 1 and the middle.
    fn special(self, choice: usize, directions: &[[f64; 3]]) -> Quantity {
        let Self::Between(from, to) = self else {
            return Quantity::Vector(directions[choice % 6]);
        };
        let value = match choice % 8 {
            0 | 1 => from,
            2 | 3 => to,
            4 | 5 if from < 0.0 => 0.0,
            6 if to > 1.0 => 1.0,
            _ => return self.at(0.5, directions, false),
        };
        Quantity::Number(value.clamp(from, to))
    }
}

/// Returns whether what follows `I` names one of several intensities: nothing, digits, or a letter of a point.
fn is_index(rest: &str) -> bool {
    rest.len() <= 2 && rest.chars().all(|c| c.is_ascii_alphanumeric())
}

/// Rounds to so many digits after the point; negative ones before it.
fn rounded(value: f64, digits: i32) -> f64 {
    // Division by a power of ten is exact to the last bit of the decimal number, multiplication by its inverse is not.
    if digits >= 0 {
        let scale = 10f64.powi(digits);
        (value * scale).round() / scale
    } else {
        let scale = 10f64.powi(-digits);
        (value / scale).round() * scale
    }
}

fn significant(value: f64, digits: i32) -> f64 {
    rounded(value, digits - 1 - value.abs().log10().floor() as i32)
}

/// Returns the unit vectors with round components: first the six along the axes.
fn directions() -> Vec<[f64; 3]> {
    let mut all: Vec<[f64; 3]> = Vec::new();
    for [a, b, c] in ROUND {
        for [x, y, z] in [
            [a, b, c],
            [b, c, a],
            [c, a, b],
            [a, c, b],
            [c, b, a],
            [b, a, c],
        ] {
            for signs in 0..8 {
                let sign = |bit: u32, x: f64| if signs >> bit & 1 == 1 { 0.0 - x } else { x };
                let vector = [sign(0, x), sign(1, y), sign(2, z)];
                if !all.contains(&vector) {
                    all.push(vector);
                }
            }
        }
    }
    all
}

/// Returns the points of a domain, the same ones always.
pub fn points(names: &[Name]) -> Vec<Vec<Quantity>> {
    let directions = directions();
    let steps = steps(names.len());
    let corners = if names.len() < 8 {
        1 << names.len()
    } else {
        CORNERS
    };
    let mut random = SplitMix64(0);
    (0..POINTS)
        .map(|index| {
            let mut bits = random.next_u64();
            let of = |(place, name): (usize, &Name)| {
                let fraction = (0.5 + index as f64 * steps[place]).fract();
                if index < corners {
                    let end = if place < 8 {
                        index >> place & 1
                    } else {
                        usize::from(fraction >= 0.5)
                    };
                    return name.values.special(2 * end, &directions);
                }
                let choice = (bits & 15) as usize;
                bits >>= 4;
                if index < EDGES && choice < 8 {
                    name.values.special(choice, &directions)
                } else {
                    name.values.at(fraction, &directions, names.len() < 3)
                }
            };
            names.iter().enumerate().map(of).collect()
        })
        .collect()
}

/// Returns the steps of an evenly spread sequence in so many dimensions: powers of the inverse of the root of
/// `x^(count + 1) = x + 1`, after Roberts (2018).
fn steps(count: usize) -> Vec<f64> {
    let mut root = 2.0f64;
    for _ in 0..60 {
        root = (1.0 + root).powf(1.0 / (count as f64 + 1.0));
    }
    (1..=count)
        .map(|power| root.powi(-(power as i32)))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(of: &[&str]) -> Vec<Name> {
        let named = |name: &&str| Name {
            name: (*name).to_owned(),
            values: Values::of(name).expect("a known name"),
        };
        of.iter().map(named).collect()
    }

    #[test]
    fn corners_come_first_and_all_points_lie_in_the_domain() {
        let names = names(&["kd", "ip", "N·L"]);
        let points = points(&names);
        assert_eq!(points.len(), POINTS);
        let corner = |x: f64, y: f64, z: f64| [x, y, z].map(Quantity::Number).to_vec();
        for (index, point) in points.iter().take(8).enumerate() {
            let end = |bit: usize, low: f64| if index >> bit & 1 == 1 { 1.0 } else { low };
            assert_eq!(*point, corner(end(0, 0.0), end(1, 0.0), end(2, -1.0)));
        }
        let mut distinct: Vec<String> = points.iter().map(|point| format!("{point:?}")).collect();
        distinct.sort();
        distinct.dedup();
        assert!(distinct.len() > POINTS * 3 / 4, "{}", distinct.len());
        for point in &points {
            for (value, name) in point.iter().zip(&names) {
                let (Quantity::Number(value), Values::Between(from, to)) = (value, name.values)
                else {
                    panic!("numbers");
                };
                assert!((from..=to).contains(value));
                assert_eq!(*value, rounded(*value, 2), "not round");
            }
        }
    }

    #[test]
    fn every_part_of_a_domain_has_its_points() {
        let points = points(&names(&["n", "R·V"]));
        let of = |point: &Vec<Quantity>| match point[..] {
            [Quantity::Number(n), Quantity::Number(r_dot_v)] => (n, r_dot_v),
            _ => panic!("two numbers"),
        };
        for (low, high) in [(1.0, 3.0), (3.0, 10.0), (10.0, 100.0), (100.0, 1005.0)] {
            for side in [-1.0, 1.0] {
                let inside = points
                    .iter()
                    .map(of)
                    .filter(|(n, r_dot_v)| (low..=high).contains(n) && r_dot_v * side > 0.5);
                assert!(inside.count() > 60, "{low} to {high}, {side}");
            }
        }
    }

    #[test]
    fn round_directions_are_unit_vectors() {
        let all = directions();
        assert_eq!(all.len(), 150);
        for [x, y, z] in all {
            assert!((x * x + y * y + z * z - 1.0).abs() < 1e-15);
        }
    }
}
