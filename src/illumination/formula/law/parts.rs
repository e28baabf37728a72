//! The parts of a law's text, and how often the operations are done that were made for them.

use crate::expression::{Formula, with_parentheses};
use crate::illumination::formula::builder::Builder;
use crate::illumination::formula::program::Program;
use crate::illumination::formula::rate::Rate;

/// A part of a law's text, and the scalar operations that were made for it first.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LawPart {
    /// The part, in one line.
    pub text: String,
    /// The operations done once for a picture, for each light, at each point, and at each point for each light.
    pub counts: [u32; 4],
    /// The reason why nothing is done for it, if nothing is.
    pub unneeded: Option<Unneeded>,
}

/// The reason why a part of a law needs no operation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unneeded {
    /// It changes nothing with the scene's numbers: a factor of 1, a product with 0, a summand of 0.
    WithoutEffect,
    /// Nothing that is left needs its result.
    Unused,
}

/// Returns the parts that operations were made for, in the order of the text.
pub fn parts(builder: &Builder, formula: &Formula, programs: [&Program; 2]) -> Vec<LawPart> {
    let place = |rate: Rate| match rate {
        Rate::Never | Rate::Frame => 0,
        Rate::Light => 1,
        Rate::Point => 2,
        Rate::PointLight => 3,
    };
    let mut counts = vec![[0; 4]; builder.origins.len()];
    for done in &builder.done {
        counts[done.origin as usize][0] += 1;
    }
    for index in programs
        .iter()
        .flat_map(|program| program.sources.iter().flatten())
    {
        let operation = &builder.operations[*index as usize];
        counts[operation.origin as usize][place(operation.rate)] += 1;
    }
    let made = |origin: usize| {
        let mut operations = builder.operations.iter();
        operations.any(|own| own.code.is_some() && own.origin as usize == origin)
    };
    let mut all: Vec<(usize, LawPart)> = vec![];
    for (origin, (span, counts)) in builder.origins.iter().zip(counts).enumerate() {
        let unneeded = match counts {
            [0, 0, 0, 0] if builder.cut.contains(&(origin as u32)) => Some(Unneeded::WithoutEffect),
            [0, 0, 0, 0] if made(origin) => Some(Unneeded::Unused),
            [0, 0, 0, 0] => continue,
            _ => None,
        };
        let text = with_parentheses(formula.text(), span.clone());
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        let part = LawPart {
            text,
            counts,
            unneeded,
        };
        all.push((span.end, part));
    }
    all.sort_by_key(|(end, _)| *end);
    all.into_iter().map(|(_, part)| part).collect()
}
