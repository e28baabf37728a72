//! A formula over named numbers as a function, evaluated at many points.

use super::builder::{Builder, Value};
use super::lower::{Inputs, Lowered, lower};
use super::program::{GROUPS_TOGETHER, Program, Registers, schedule};
use super::rate::Rate;
use crate::expression::{Formula, FormulaError, Names};

/// A formula over named numbers.
///
/// ```
/// use shading_lab::expression::Names;
/// use shading_lab::illumination::FormulaFunction;
///
/// let names = Names::new(&["kd", "ip", "N·L"], &[]);
/// let law = FormulaFunction::read("kd * ip * max(N·L, 0)", &names)?;
/// assert_eq!(law.at(&[0.5, 2.0, 0.25]).value, 0.25);
/// assert_eq!(law.at(&[0.5, 2.0, -0.25]).value, 0.0);
/// # Ok::<(), shading_lab::expression::FormulaError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct FormulaFunction {
    formula: Formula,
    program: Program,
    names: usize,
}

/// The value of a formula at a point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Outcome {
    /// The value; 0 where it is not a number.
    pub value: f64,
    /// True if a division by zero, or another operation without a value, counted as 0.
    pub undefined: bool,
}

/// The names as inputs; vectors, which have no numbers here, are zero.
struct Named {
    values: Vec<Option<Value>>,
}

impl Inputs for Named {
    fn name(&mut self, builder: &mut Builder, index: usize) -> Lowered {
        let value = self.values[index].get_or_insert_with(|| builder.input(Rate::Point));
        Lowered::Number(*value)
    }
}

impl FormulaFunction {
    /// Reads a formula over names that are all numbers.
    pub fn read(text: &str, names: &Names) -> Result<Self, FormulaError> {
        Formula::read(text, names).map(|formula| Self::new(formula, names))
    }

    fn new(formula: Formula, names: &Names) -> Self {
        let mut builder = Builder::default();
        let mut inputs = Named {
            values: vec![None; names.len()],
        };
        let lines = lower(&mut builder, &formula, &mut inputs);
        let value = lines
            .last()
            .and_then(Lowered::number)
            .unwrap_or(Value::ZERO);
        let mut program = schedule(&builder, &[vec![value]], &|_| Some(0));
        for (index, _) in &mut program.inputs {
            let own = |value: &Option<Value>| *value == Some(Value::Varying(*index));
            *index = inputs.values.iter().position(own).unwrap_or(0) as u32;
        }
        Self {
            formula,
            program,
            names: names.len(),
        }
    }

    /// Returns the formula.
    pub fn formula(&self) -> &Formula {
        &self.formula
    }

    /// Returns the number of scalar operations at a point.
    pub fn operations(&self) -> usize {
        self.program.sections.iter().map(Vec::len).sum()
    }

    /// Returns the value at a point, given the values of the names in their order; missing ones count as 0.
    pub fn at(&self, values: &[f64]) -> Outcome {
        self.at_all(&[values]).first().copied().unwrap_or_default()
    }

    /// Returns the values at many points, each with the values of the names in their order.
    pub fn at_all<P: AsRef<[f64]>>(&self, points: &[P]) -> Vec<Outcome> {
        let mut registers = Registers::new(&self.program, 0.0);
        let mut all = Vec::with_capacity(points.len());
        for points in points.chunks(GROUPS_TOGETHER) {
            registers.undefined = [0.0; GROUPS_TOGETHER];
            for (index, register) in &self.program.inputs {
                for (group, point) in points.iter().enumerate() {
                    let value = point.as_ref().get(*index as usize).copied();
                    registers.set(*register, group, value.unwrap_or(0.0));
                }
            }
            registers.run(&self.program.sections[0], points.len());
            let result = self.program.results[0][0];
            all.extend((0..points.len()).map(|group| {
                let value = registers.get(result, group);
                Outcome {
                    value: if value.is_nan() { 0.0 } else { value },
                    undefined: value.is_nan() || registers.undefined[group] > 0.0,
                }
            }));
        }
        all
    }

    /// Returns the number of names.
    pub fn name_count(&self) -> usize {
        self.names
    }
}
