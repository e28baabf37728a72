//! Random formulas over the names of a law of reflection, with every operator and function, whose types agree.

use super::dice::Dice;
use shading_lab::scene::{LAW_NUMBERS, LAW_VECTORS};

/// The type of a part.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Number,
    Vector,
    Truth,
}

/// Names of lines: everyday ones, Greek letters and subscripts, words of shading languages, and names that the law has.
const LINES: [&str; 20] = [
    "spot",
    "h",
    "r",
    "x1",
    "half_way",
    "α",
    "k₀",
    "σ2",
    "sample",
    "float",
    "vec3",
    "main",
    "law",
    "gl_Position",
    "a__b",
    "N",
    "V",
    "n",
    "kd",
    "theta",
];

/// The deepest nesting of parts, well below what the grammar allows.
const DEPTH: usize = 16;

/// Returns a formula of a few dozen operations at most, with up to three named lines.
pub fn any_formula(dice: &mut Dice) -> String {
    let numbers = LAW_NUMBERS.map(|name| (name, Kind::Number));
    let vectors = LAW_VECTORS.map(|name| (name, Kind::Vector));
    let mut author = Author {
        dice,
        names: numbers.into_iter().chain(vectors).collect(),
    };
    let mut text = String::new();
    for _ in 0..author.below(4) {
        let name = author.dice.of(&LINES);
        let kind = (author.dice).of(&[Kind::Number, Kind::Number, Kind::Vector, Kind::Truth]);
        let size = author.below(9);
        let end = author.dice.of(&["\n", "\n", "; "]);
        text += &format!("{name} = {}{end}", author.part(kind, size, DEPTH));
        author.names.retain(|(own, _)| *own != name);
        author.names.push((name, kind));
    }
    let kind = if author.dice.unit() < 0.95 {
        Kind::Number
    } else {
        Kind::Truth
    };
    let size = author.below(25);
    text + &author.part(kind, size, DEPTH)
}

struct Author<'a> {
    dice: &'a mut Dice,
    /// The names so far, each once.
    names: Vec<(&'static str, Kind)>,
}

impl Author<'_> {
    /// Returns a whole number from 0 to `count` − 1.
    fn below(&mut self, count: usize) -> usize {
        ((self.dice.unit() * count as f64) as usize).min(count - 1)
    }

    /// Returns a part of about `size` operations.
    fn part(&mut self, kind: Kind, size: usize, depth: usize) -> String {
        match kind {
            _ if size == 0 || depth == 0 => self.leaf(kind),
            Kind::Number => self.number(size - 1, depth - 1),
            Kind::Vector => self.vector(size - 1, depth - 1),
            Kind::Truth => self.truth(size - 1, depth - 1),
        }
    }

    /// Returns parts of these types, of about `size` operations together.
    fn parts<const N: usize>(
        &mut self,
        kinds: [Kind; N],
        mut size: usize,
        depth: usize,
    ) -> [String; N] {
        kinds.map(|kind| {
            let own = if N == 1 { size } else { self.below(size + 1) };
            size -= own;
            self.part(kind, own, depth)
        })
    }

    fn name(&mut self, kind: Kind) -> Option<&'static str> {
        let own = self.names.iter().filter(|(_, own)| *own == kind);
        let own: Vec<_> = own.map(|(name, _)| *name).collect();
        // The lines, which come last, as often as all names of the law.
        let from = if self.dice.unit() < 0.5 {
            0
        } else {
            own.len().saturating_sub(3)
        };
        (!own.is_empty()).then(|| self.dice.of(&own[from..]))
    }

    fn leaf(&mut self, kind: Kind) -> String {
        if kind == Kind::Number && self.dice.unit() < 0.3 {
            let usual = ["0", "1", "2", "3", "0.5", "10", "90", "1e-3", "pi", "π"];
            return match self.below(60) {
                0 => "inf".to_owned(),
                1..25 => format!("{:.3}", self.dice.between(0.0, 4.0)),
                _ => self.dice.of(&usual).to_owned(),
            };
        }
        match self.name(kind) {
            Some(name) => name.to_owned(),
            None if kind == Kind::Vector => "cross(N, normalize(L))".to_owned(),
            None => "(N·L > 0)".to_owned(),
        }
    }

    fn number(&mut self, size: usize, depth: usize) -> String {
        use Kind::{Number, Truth, Vector};
        match self.below(30) {
            0..10 => {
                let [a, b] = self.parts([Number; 2], size, depth);
                let sign = self.dice.of(&["+", "+", "-", "−", "*", "*", "×", "/", "÷"]);
                format!("({a} {sign} {b})")
            }
            10..13 => {
                let exponent = match self.below(4) {
                    0 => self.part(Number, size / 2, depth),
                    1 => self.leaf(Number),
                    _ => self.dice.of(&["2", "3", "5", "0.5", "-1"]).to_owned(),
                };
                let base = self.part(Number, size / 2, depth);
                match self.below(4) {
                    0 => format!("pow({base}, {exponent})"),
                    1 => format!("({base})²"),
                    2 => format!("({base})³"),
                    _ => format!("(({base})^{exponent})"),
                }
            }
            13..19 => {
                let [a] = self.parts([Number], size, depth);
                let function = self.dice.of(&[
                    "-", "√", "sqrt", "abs", "exp", "log", "round", "floor", "sin", "cos", "tan",
                    "asin", "acos", "atan",
                ]);
                if function == "-" {
                    return format!("(-{a})");
                }
                format!("{function}({a})")
            }
            19..23 => {
                let function = self.dice.of(&["min", "max", "max", "sum", "mean"]);
                match self.below(4) {
                    0 => format!("{function}({})", self.part(Number, size, depth)),
                    1 => {
                        let all = self.parts([Number; 3], size, depth);
                        format!("{function}({})", all.join(", "))
                    }
                    _ => {
                        let all = self.parts([Number; 2], size, depth);
                        format!("{function}({})", all.join(", "))
                    }
                }
            }
            23 => {
                let all = self.parts([Number; 2], size, depth);
                format!("step({})", all.join(", "))
            }
            24..26 => {
                let function = self.dice.of(&["clamp", "mix", "smoothstep"]);
                let all = self.parts([Number; 3], size, depth);
                format!("{function}({})", all.join(", "))
            }
            26 => format!("({})", self.part(Truth, size, depth)),
            27 => {
                let axis = self.dice.of(&["x", "y", "z"]);
                match self.name(Vector) {
                    Some(name) => format!("{name}.{axis}"),
                    None => self.leaf(Number),
                }
            }
            28 => format!("length({})", self.part(Vector, size, depth)),
            _ => {
                let [a, b] = self.parts([Vector; 2], size, depth);
                match self.below(2) {
                    0 => format!("dot({a}, {b})"),
                    _ => format!("(({a})·({b}))"),
                }
            }
        }
    }

    fn vector(&mut self, size: usize, depth: usize) -> String {
        use Kind::{Number, Vector};
        match self.below(8) {
            0..3 => {
                let [a, b] = self.parts([Vector; 2], size, depth);
                let sign = self.dice.of(&["+", "-"]);
                format!("({a} {sign} {b})")
            }
            3..5 => {
                let [factor, v] = self.parts([Number, Vector], size, depth);
                match self.below(4) {
                    0 => format!("({v} / {factor})"),
                    1 => format!("({v} * {factor})"),
                    2 => format!("(({factor})·({v}))"),
                    _ => format!("({factor} * {v})"),
                }
            }
            5 => format!("normalize({})", self.part(Vector, size, depth)),
            6 => {
                let [a, b] = self.parts([Vector; 2], size, depth);
                format!("cross({a}, {b})")
            }
            _ => match self.below(2) {
                0 => format!("(-{})", self.part(Vector, size, depth)),
                _ => {
                    let [a, b, t] = self.parts([Vector, Vector, Number], size, depth);
                    format!("mix({a}, {b}, {t})")
                }
            },
        }
    }

    fn truth(&mut self, size: usize, depth: usize) -> String {
        use Kind::{Number, Truth};
        match self.below(5) {
            0..3 => {
                let [a, b] = self.parts([Number; 2], size, depth);
                let sign = (self.dice).of(&["<", ">", "<", ">", "<=", ">=", "≤", "≥", "==", "!="]);
                format!("({a} {sign} {b})")
            }
            3 => format!("not ({})", self.part(Truth, size, depth)),
            _ => {
                let [a, b] = self.parts([Truth; 2], size, depth);
                let word = self.dice.of(&["and", "or"]);
                format!("({a} {word} {b})")
            }
        }
    }
}
