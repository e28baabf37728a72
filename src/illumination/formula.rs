//! Formulas as straight-line code over any [`Real`].
//!
//! A typed [`Formula`] becomes a list of scalar operations. While the list is made, constants are folded, parts that occur
//! twice are shared, and each operation is noted with where its inputs change: what is known before a point
//! is looked at is evaluated at once. What nothing uses is dropped. The code then runs
//! over many points at a time, operation by operation.

mod builder;
mod code;
mod compare;
mod function;
mod lower;
mod program;
mod rate;

pub use compare::{Counterexample, Domain};
pub use function::{FormulaFunction, Outcome};
pub use rate::Rate;
