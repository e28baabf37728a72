//! A lesson with every kind of question, small enough to be solved often.

/// A lesson with the kinds in the order of `docs/lessons.md`, some of them twice.
pub const EVERY_KIND: &str = include_str!("../data/every-kind.md");
