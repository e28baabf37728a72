//! The lines of a law with their values at a point.

use super::listed::Listed;
use super::named::{Constancy, Incidence, Input};
use crate::expression::{Formula, FormulaError};
use crate::illumination::V3;
use crate::illumination::formula::builder::Value;
use crate::illumination::formula::lower::Lowered;
use crate::illumination::formula::program::{Program, Registers, schedule};
use crate::scene::{Rgb, Scene};
use glam::DVec3;
use serde::Serialize;

/// A line of a law, with its value for a light at a point.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LawLine {
    /// The name of the line; none for the law's value.
    pub name: Option<String>,
    /// The text of its value, in one line.
    pub formula: String,
    /// The value.
    #[serde(flatten)]
    pub value: LineNumbers,
}

/// A law at a point.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LawValues {
    /// The lines in their order, the law's value last.
    pub lines: Vec<LawLine>,
    /// True if an operation had no value there, and counted as 0.
    pub undefined: bool,
}

impl LawValues {
    /// Returns the law's value.
    pub fn value(&self) -> Rgb {
        match self.lines.last().map(|line| line.value) {
            Some(LineNumbers::Value(value)) => value,
            _ => Rgb::ZERO,
        }
    }
}

/// The numbers of a line.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum LineNumbers {
    /// A number for each channel.
    Value(Rgb),
    /// A vector; that of the red channel where it has od or another number that differs between channels.
    Vector(DVec3),
}

/// A law whose lines are all evaluated, one after the other.
#[derive(Debug)]
pub struct LawLines {
    formula: Formula,
    program: Program,
    inputs: Vec<(Input, u16)>,
    /// The values of the lines for each channel.
    values: [Vec<Lowered>; 3],
    /// The values that the program gives.
    results: Vec<Value>,
}

impl LawLines {
    /// Prepares the law that `scene` has as a text.
    pub fn of(scene: &Scene) -> Result<Self, FormulaError> {
        let Listed {
            formula,
            builder,
            named,
            lines: values,
        } = Listed::of(scene, Rgb::ONE, Constancy::NONE)?;
        let mut results = vec![];
        for line in values.iter().flatten() {
            match line {
                Lowered::Number(value) => results.push(*value),
                Lowered::Vector(value) => results.extend(value),
            }
        }
        let program = schedule(&builder, std::slice::from_ref(&results), &|_| Some(0));
        let of =
            |(index, register): &(u32, u16)| named.input_of(*index).map(|input| (input, *register));
        Ok(Self {
            inputs: program.inputs.iter().filter_map(of).collect(),
            formula,
            program,
            values,
            results,
        })
    }

    /// Evaluates the lines for a light at a point with vectors N and V and the surface's colour Od.
    pub fn at(
        &self,
        [normal, view]: [DVec3; 2],
        color: Rgb,
        incidence: &Incidence<f64>,
    ) -> LawValues {
        let mut registers = Registers::new(&self.program, 0.0);
        let (normal, view): (V3<f64>, V3<f64>) = (normal.into(), view.into());
        for (input, register) in &self.inputs {
            let of_point = input.of_point(normal, view, Some(color.to_array()));
            let value = of_point.or_else(|| input.of_light(incidence));
            registers.set(*register, 0, value.unwrap_or_default());
        }
        registers.run(&self.program.sections[0], 1);
        let of = |value: &Value| {
            let place = self.results.iter().position(|own| own == value);
            let register = place.and_then(|place| self.program.results[0].get(place));
            register.map_or(0.0, |register| registers.get(*register, 0))
        };
        let line = |(index, line): (usize, &crate::expression::Line)| {
            let text = self.formula.text_of(&line.value);
            let values = [0, 1, 2].map(|channel| self.values[channel][index]);
            LawLine {
                name: line.name.clone(),
                formula: text.split_whitespace().collect::<Vec<_>>().join(" "),
                value: match values[0] {
                    Lowered::Vector(parts) => LineNumbers::Vector(parts.each_ref().map(of).into()),
                    Lowered::Number(_) => {
                        let number = |value: Lowered| value.number().as_ref().map_or(0.0, of);
                        LineNumbers::Value(Rgb::from_array(values.map(number)))
                    }
                },
            }
        };
        LawValues {
            lines: self.formula.lines().iter().enumerate().map(line).collect(),
            undefined: registers.undefined[0] > 0.0,
        }
    }
}
