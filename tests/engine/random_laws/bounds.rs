//! The values that a formula may have in any precision from single on, by interval arithmetic over its parts: an evaluator of
//! its own, which shares nothing with the program's.

use shading_lab::expression::{Formula, Operator, Term, Typed};

/// The relative error of an operation in single precision, of its operands' rounding too.
const ROUNDING: f64 = 1e-6;
/// The magnitude from which single precision may overflow, and that below which it may lose digits.
const RANGE: [f64; 2] = [1e-18, 1e18];
/// The power below which single precision has 0.
const FAINTEST: f64 = 1e-30;
/// The error of an operation in double precision.
const ROUNDING_IN_DOUBLE: f64 = 1e-14;
/// The sine from which there is no angle any more.
const NO_ANGLE: f64 = 1.0 + 1e-6;

/// The values that a number may have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    pub low: f64,
    pub high: f64,
    /// True for a number that is known before a point is looked at, and computed in double precision.
    known: bool,
}

/// The bounds of a number, or those of a vector's components.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    Number(Bounds),
    Vector([Bounds; 3]),
}

/// Returns the bounds of the formula's value; `None` where rounding may change it without limit, as next to a division by zero.
pub fn bounds(formula: &Formula, name: &dyn Fn(usize) -> Value) -> Option<Bounds> {
    let mut lines: Vec<Value> = vec![];
    for line in formula.lines() {
        let value = value(&line.value, &lines, name)?;
        lines.push(value);
    }
    match lines.last()? {
        Value::Number(number) => Some(*number),
        Value::Vector(_) => None,
    }
}

impl Bounds {
    pub fn known(number: f64) -> Self {
        Self::only_value(number, true)
    }

    fn only_value(number: f64, known: bool) -> Self {
        Self {
            low: number,
            high: number,
            known,
        }
    }

    /// Returns the bounds of an input that is known up to `error`.
    pub fn input(number: f64, error: f64) -> Self {
        Self {
            low: number - error,
            high: number + error,
            known: false,
        }
    }

    fn size(self) -> f64 {
        self.low.abs().max(self.high.abs())
    }

    /// Returns the number if there is but one.
    fn only(self) -> Option<f64> {
        (self.low == self.high).then_some(self.low)
    }

    /// Returns whether it is one whole number, which every precision represents.
    fn is_whole(self) -> bool {
        self.only().is_some_and(|number| number.fract() == 0.0)
    }

    fn contains_zero(self) -> bool {
        self.low <= 0.0 && self.high >= 0.0
    }

    fn is_zero(self) -> bool {
        self.only() == Some(0.0)
    }

    /// Returns the image of a function that never falls, computed with an error of `slack`.
    fn rising(self, of: impl Fn(f64) -> f64, slack: f64) -> Option<Self> {
        rounded([of(self.low), of(self.high)], slack, self.known)
    }

    fn negated(self) -> Self {
        Self {
            low: -self.high,
            high: -self.low,
            ..self
        }
    }

    fn plus(self, other: Self) -> Option<Self> {
        let ends = [self.low + other.low, self.high + other.high];
        let slack = ROUNDING * (self.size() + other.size());
        rounded(ends, slack, self.known && other.known)
    }

    fn minus(self, other: Self) -> Option<Self> {
        self.plus(other.negated())
    }

    fn times(self, other: Self) -> Option<Self> {
        if self.is_zero() || other.is_zero() {
            let known = [self, other]
                .iter()
                .any(|factor| factor.known && factor.is_zero());
            return Some(Self::only_value(0.0, known || self.known && other.known));
        }
        let products = [
            self.low * other.low,
            self.low * other.high,
            self.high * other.low,
            self.high * other.high,
        ];
        rounded(ends(products), 0.0, self.known && other.known)
    }

    fn over(self, other: Self) -> Option<Self> {
        if other.is_zero() || self.is_zero() {
            return Some(Self::only_value(
                0.0,
                self.known && (other.known || self.is_zero()),
            ));
        }
        if other.contains_zero() {
            return None;
        }
        if self.known && other.known {
            return rounded([self.low / other.low; 2], 0.0, true);
        }
        let inverse = rounded([1.0 / other.high, 1.0 / other.low], 0.0, other.known)?;
        self.times(inverse)
    }

    fn min(self, other: Self) -> Self {
        Self {
            low: self.low.min(other.low),
            high: self.high.min(other.high),
            known: self.known && other.known,
        }
    }

    fn max(self, other: Self) -> Self {
        self.negated().min(other.negated()).negated()
    }

    fn abs(self) -> Self {
        let least = if self.contains_zero() {
            0.0
        } else {
            self.low.abs().min(self.high.abs())
        };
        Self {
            low: least,
            high: self.size(),
            ..self
        }
    }

    fn sqrt(self) -> Option<Self> {
        let tiny = if self.known { 0.0 } else { RANGE[0] };
        self.rising(|x| x.max(0.0).sqrt(), tiny)
    }

    /// Returns 1 where `self` is above `other`, else 0; both where rounding decides.
    fn above(self, other: Self) -> Self {
        let both_known = self.known && other.known;
        let slack = match both_known {
            _ if self.is_whole() && other.is_whole() => 0.0,
            true => ROUNDING_IN_DOUBLE * (self.size() + other.size()),
            false => ROUNDING * (self.size() + other.size()),
        };
        let always = self.low > other.high + slack;
        let never = self.high <= other.low - slack;
        Self {
            low: f64::from(u8::from(always)),
            high: f64::from(u8::from(!never)),
            known: both_known && (always || never),
        }
    }

    fn not(self) -> Self {
        Self {
            low: 1.0 - self.high,
            high: 1.0 - self.low,
            ..self
        }
    }

    fn differs(self, other: Self) -> Self {
        self.above(other).max(other.above(self))
    }

    fn log(self) -> Option<Self> {
        if self.high <= 0.0 {
            return Some(Self::only_value(0.0, self.known));
        }
        if self.low <= 0.0 || self.low < RANGE[0] && !self.known {
            return None;
        }
        self.rising(f64::ln, ROUNDING)
    }

    fn exp(self) -> Option<Self> {
        let slack = if self.known {
            0.0
        } else {
            ROUNDING * self.size()
        };
        let ends = [(self.low - slack).exp(), (self.high + slack).exp()];
        if self.known {
            return rounded(ends, 0.0, true);
        }
        power_of(ends)
    }

    /// Returns the sine of an angle that is `turned` by some degrees.
    fn sin(self, turned: f64) -> Option<Self> {
        let (middle, half) = (0.5 * (self.low + self.high), 0.5 * (self.high - self.low));
        // Of larger angles too little is left below a degree, in double and in single precision.
        if self.size() > if self.known { 1e7 } else { 1e5 } {
            return None;
        }
        let sine = sine(middle + turned);
        let error = half.to_radians();
        let ends = [(sine - error).max(-1.0), (sine + error).min(1.0)];
        rounded(ends, ROUNDING, self.known)
    }

    /// Returns the angle, degrees, of a sine or a cosine, by a function that rises.
    fn angle(self, of: impl Fn(f64) -> f64) -> Option<Self> {
        if self.low > NO_ANGLE || self.high < -NO_ANGLE {
            return Some(Self::only_value(0.0, self.known));
        }
        let slack = if self.known { 0.0 } else { 0.5 * ROUNDING };
        if self.size() > NO_ANGLE - slack {
            return None;
        }
        self.rising(|x| of(x.clamp(-1.0, 1.0)).to_degrees(), ROUNDING)
    }

    pub fn acos(self) -> Option<Self> {
        // It falls where the cosine rises.
        self.negated().angle(|x| (-x).acos())
    }

    fn power(self, exponent: Self) -> Option<Self> {
        if self.known && exponent.known {
            return rounded([power(self.low, exponent.low)?; 2], 0.0, true);
        }
        // The largest number of a precision stands for infinity, whose powers it does not have.
        if self.size().max(exponent.size()) > RANGE[1] {
            return None;
        }
        if exponent.is_zero() {
            return Some(Self::only_value(1.0, exponent.known));
        }
        let whole = exponent.only().filter(|_| exponent.is_whole());
        if self.low > 0.0 {
            return powers([self.low, self.high], exponent);
        }
        let maybe_whole = whole.is_none() && exponent.low.ceil() <= exponent.high;
        if self.high < 0.0 {
            return match whole {
                None if maybe_whole => None,
                None => Some(Self::only_value(0.0, false)),
                Some(whole) => {
                    let size = powers([-self.high, -self.low], exponent)?;
                    Some(if whole % 2.0 == 0.0 {
                        size
                    } else {
                        size.negated()
                    })
                }
            };
        }
        if exponent.low <= 0.0 || maybe_whole {
            return None;
        }
        let size = |x: f64| {
            if x > 0.0 {
                powers([x; 2], exponent).map(|size| size.high)
            } else {
                Some(0.0)
            }
        };
        let (below, above) = (size(-self.low)?, size(self.high)?);
        let ends = match whole {
            Some(whole) if whole % 2.0 == 0.0 => [0.0, below.max(above)],
            Some(_) => [-below, above],
            None => [0.0, above],
        };
        rounded(ends, RANGE[0], false)
    }
}

/// Returns the sine of an angle in degrees, exactly at quarter turns.
fn sine(angle: f64) -> f64 {
    match angle.rem_euclid(360.0) {
        0.0 | 180.0 => 0.0,
        90.0 => 1.0,
        270.0 => -1.0,
        rest => rest.to_radians().sin(),
    }
}

/// Returns `a^b` of two numbers; `None` where it is too large.
fn power(a: f64, b: f64) -> Option<f64> {
    let power = if a == 0.0 {
        f64::from(u8::from(b == 0.0))
    } else if a < 0.0 && b.fract() != 0.0 {
        0.0
    } else {
        a.powf(b)
    };
    power.is_finite().then_some(power)
}

/// Returns the bounds of powers of positive numbers.
fn powers(base: [f64; 2], exponent: Bounds) -> Option<Bounds> {
    let [a, b] = base.map(f64::log2);
    let e = [exponent.low, exponent.high];
    let [low, high] = ends([a * e[0], a * e[1], b * e[0], b * e[1]]);
    let slack = |x: f64| ROUNDING * (x.abs() + exponent.size());
    power_of([(low - slack(low)).exp2(), (high + slack(high)).exp2()])
}

/// Returns the bounds of a power that is not known.
fn power_of([low, high]: [f64; 2]) -> Option<Bounds> {
    let low = if low < FAINTEST { 0.0 } else { low };
    rounded([low, high], 0.0, false)
}

fn ends(numbers: [f64; 4]) -> [f64; 2] {
    [
        numbers.into_iter().fold(f64::INFINITY, f64::min),
        numbers.into_iter().fold(f64::NEG_INFINITY, f64::max),
    ]
}

/// Returns bounds with an operation's rounding, unless it is done on known numbers; `None` where single precision may overflow.
fn rounded([low, high]: [f64; 2], slack: f64, known: bool) -> Option<Bounds> {
    let most = low.abs().max(high.abs());
    if known {
        return (most < RANGE[1]).then_some(Bounds { low, high, known });
    }
    let wider = |x: f64| ROUNDING * x.abs() + slack + 1e-36;
    (most < RANGE[1]).then(|| Bounds {
        low: low - wider(low),
        high: high + wider(high),
        known,
    })
}

fn value(part: &Typed, lines: &[Value], name: &dyn Fn(usize) -> Value) -> Option<Value> {
    match &part.term {
        Term::Number(number) => Some(Value::Number(Bounds::known(*number))),
        Term::Line(line) => Some(lines[*line]),
        Term::Name(index) => Some(name(*index)),
        Term::Call(operator, parts) => {
            let values: Option<Vec<Value>> =
                parts.iter().map(|part| value(part, lines, name)).collect();
            call(*operator, &values?)
        }
    }
}

fn call(operator: Operator, values: &[Value]) -> Option<Value> {
    let vectors: Vec<[Bounds; 3]> = values
        .iter()
        .filter_map(|value| match value {
            Value::Vector(vector) => Some(*vector),
            Value::Number(_) => None,
        })
        .collect();
    let numbers: Vec<Bounds> = values
        .iter()
        .filter_map(|value| match value {
            Value::Number(number) => Some(*number),
            Value::Vector(_) => None,
        })
        .collect();
    let by_axis =
        |of: &dyn Fn(usize) -> Option<Bounds>| Some(Value::Vector([of(0)?, of(1)?, of(2)?]));
    match (operator, &*vectors, &*numbers) {
        (Operator::Add, [a, b], _) => by_axis(&|k| a[k].plus(b[k])),
        (Operator::Subtract, [a, b], _) => by_axis(&|k| a[k].minus(b[k])),
        (Operator::Negate, [a], _) => by_axis(&|k| Some(a[k].negated())),
        (Operator::Multiply, [a], [factor]) => by_axis(&|k| a[k].times(*factor)),
        (Operator::Divide, [a], [divisor]) => by_axis(&|k| a[k].over(*divisor)),
        (Operator::Mix, [a, b], [t]) => by_axis(&|k| mix(a[k], b[k], *t)),
        (Operator::Dot, [a, b], _) => dot(*a, *b).map(Value::Number),
        (Operator::Length, [a], _) => dot(*a, *a)?.sqrt().map(Value::Number),
        (Operator::Normalize, [a], _) => {
            let square = dot(*a, *a)?;
            let zero = a.iter().all(|part| part.is_zero());
            if !zero && square.low < RANGE[0] {
                return None;
            }
            let length = square.sqrt()?;
            by_axis(&|k| a[k].over(length))
        }
        (Operator::Component(axis), [a], _) => Some(Value::Number(a[axis])),
        (Operator::Cross, [a, b], _) => by_axis(&|k| {
            let (next, last) = ((k + 1) % 3, (k + 2) % 3);
            a[next].times(b[last])?.minus(a[last].times(b[next])?)
        }),
        _ => number(operator, &numbers).map(Value::Number),
    }
}

fn dot(a: [Bounds; 3], b: [Bounds; 3]) -> Option<Bounds> {
    let [x, y, z] = [0, 1, 2].map(|k| a[k].times(b[k]));
    x?.plus(y?)?.plus(z?)
}

fn mix(a: Bounds, b: Bounds, t: Bounds) -> Option<Bounds> {
    a.plus(b.minus(a)?.times(t)?)
}

fn sum(numbers: &[Bounds]) -> Option<Bounds> {
    let mut sum = Bounds::known(0.0);
    for number in numbers {
        sum = sum.plus(*number)?;
    }
    Some(sum)
}

fn number(operator: Operator, numbers: &[Bounds]) -> Option<Bounds> {
    let at = |index: usize| numbers.get(index).copied().unwrap_or(Bounds::known(0.0));
    let [a, b, c] = [at(0), at(1), at(2)];
    let [zero, one] = [0.0, 1.0].map(Bounds::known);
    match operator {
        Operator::Negate => Some(a.negated()),
        Operator::Add => a.plus(b),
        Operator::Subtract => a.minus(b),
        Operator::Multiply | Operator::And => a.times(b),
        Operator::Divide => a.over(b),
        Operator::Power => a.power(b),
        Operator::Min => numbers.iter().copied().reduce(Bounds::min),
        Operator::Max => numbers.iter().copied().reduce(Bounds::max),
        Operator::Or => Some(a.max(b)),
        Operator::Not => Some(a.not()),
        Operator::Sum => sum(numbers),
        Operator::Mean => sum(numbers)?.over(Bounds::known(numbers.len() as f64)),
        Operator::Abs => Some(a.abs()),
        Operator::Sqrt => a.sqrt(),
        Operator::Exp => a.exp(),
        Operator::Log => a.log(),
        Operator::Floor => Some(floor(a)),
        Operator::Round => Some(floor(a.plus(Bounds::known(0.5))?)),
        Operator::Sin => a.sin(0.0),
        Operator::Cos => a.sin(90.0),
        Operator::Tan => a.sin(0.0)?.over(a.sin(90.0)?),
        Operator::Asin => a.angle(f64::asin),
        Operator::Acos => a.acos(),
        Operator::Atan => a.rising(|x| x.atan().to_degrees(), 0.0),
        Operator::Clamp => Some(a.max(b).min(c)),
        Operator::Mix => mix(a, b, c),
        Operator::Step => Some(a.above(b).not()),
        Operator::Smoothstep => {
            let t = c.minus(a)?.over(b.minus(a)?)?.max(zero).min(one);
            t.rising(|t| t * t * (3.0 - 2.0 * t), ROUNDING)
        }
        Operator::Less => Some(b.above(a)),
        Operator::Greater => Some(a.above(b)),
        Operator::LessEqual => Some(a.above(b).not()),
        Operator::GreaterEqual => Some(b.above(a).not()),
        Operator::Equal => Some(a.differs(b).not()),
        Operator::NotEqual => Some(a.differs(b)),
        _ => panic!("{operator:?} has no bounds"),
    }
}

fn floor(a: Bounds) -> Bounds {
    Bounds {
        low: a.low.floor(),
        high: a.high.floor(),
        ..a
    }
}
