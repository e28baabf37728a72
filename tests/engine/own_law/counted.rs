//! A number that counts the operations done on it.

use shading_lab::illumination::Real;
use std::cell::Cell;
use std::ops::{Add, Div, Mul, Neg, Sub};

thread_local! {
    static COUNT: Cell<i64> = const { Cell::new(0) };
}

/// Returns the number of operations on [`Counted`] numbers.
pub fn counted<T>(work: impl FnOnce() -> T) -> i64 {
    COUNT.set(0);
    work();
    COUNT.get()
}

/// A number that counts. An operation that is undefined for some operands is made of several steps, of which all together
/// count one: a power is `2^(b·log2 a)` with a raised above 0 and three comparisons, a quotient and an angle compare first. Signs
/// are free.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Counted(pub f64);

/// The steps of a power, a quotient and an angle that count one each by themselves, less the one that counts.
const OF_POWER: i64 = 6 - 1;
const OF_QUOTIENT: i64 = 2 - 1;
const OF_ANGLE: i64 = 4 - 1;

fn done(value: f64, count: i64) -> Counted {
    COUNT.set(COUNT.get() + count);
    Counted(value)
}

macro_rules! operators {
    ($($of:ident::$name:ident $count:expr),*) => {
        $(impl $of for Counted {
            type Output = Self;
            fn $name(self, other: Self) -> Self {
                done(self.0.$name(other.0), $count)
            }
        })*
    };
}

operators!(Add::add 1, Sub::sub 1, Mul::mul 1, Div::div -OF_QUOTIENT);

impl Mul<f64> for Counted {
    type Output = Self;
    fn mul(self, other: f64) -> Self {
        done(self.0 * other, 1)
    }
}

impl Neg for Counted {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

macro_rules! functions {
    ($($name:ident($($other:ident)?) $count:expr),*) => {
        $(fn $name(self $(, $other: Self)?) -> Self {
            done(Real::$name(self.0 $(, $other.0)?), $count)
        })*
    };
}

impl Real for Counted {
    type Scalar = f64;
    type Mask = bool;

    fn constant(self, value: f64) -> Self {
        Self(value)
    }

    functions!(max(other) 1, min(other) 1, abs() 1, floor() 1, inverse_sqrt() 1, sqrt() 0, log2() 0, exp2() -OF_POWER,
        sin_of_degrees() 1, cos_of_degrees() 1, atan_in_degrees() 1, asin_in_degrees() -OF_ANGLE, acos_in_degrees() -OF_ANGLE);

    fn mul_add(self, a: Self, b: Self) -> Self {
        done(self.0 * a.0 + b.0, 1)
    }

    fn log2_one_minus(t: Self) -> Self {
        done(f64::log2_one_minus(t.0), 1)
    }

    fn greater_than(self, other: Self) -> bool {
        done(0.0, 1);
        self.0 > other.0
    }

    fn select(mask: bool, if_true: Self, if_false: Self) -> Self {
        if mask { if_true } else { if_false }
    }

    /// Returns true, as where another lane needs what this one does not.
    fn any(_: bool) -> bool {
        true
    }

    fn mask_of_bits(self, bits: u64) -> bool {
        bits & 1 == 1
    }
}
