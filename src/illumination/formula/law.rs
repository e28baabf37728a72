//! A law of reflection that is typed as a formula, in place of the diffuse and the specular term.

mod cost;
mod lines;
mod listed;
mod named;
mod parts;

pub use cost::law_operations;
pub use lines::{LawLine, LawLines, LawValues, LineNumbers};
pub use listed::Listed;
pub use named::{Constancy, Incidence, Input};
pub use parts::{LawPart, Unneeded};

use super::builder::{Operation, Value};
use super::program::{Program, Registers, schedule};
use super::rate::Rate;
use crate::expression::FormulaError;
use crate::illumination::{Real, V3};
use crate::scene::{Rgb, Scene};

/// The sections of the code at a point: what is the same for all lights there, and what differs from light to light.
const POINT: usize = 0;
const LIGHT: usize = 1;

/// A law of reflection typed as a formula: the factor of one light's part, for each channel.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Law {
    /// The code at a point.
    program: Program,
    /// What each input of the code is, with its register.
    inputs: Vec<(Input, u16)>,
    /// The code for a light whose L is constant, evaluated once.
    once: Program,
    once_inputs: Vec<(Input, u16)>,
    parts: Vec<LawPart>,
}

impl Law {
    /// Prepares the law that `scene` has as a text. Od is `color`, times that of the point where it is not constant.
    pub fn of(scene: &Scene, color: Rgb, constancy: Constancy) -> Result<Self, FormulaError> {
        let listed = Listed::of(scene, color, constancy)?;
        let builder = &listed.builder;
        let section = |operation: &Operation| match operation.rate {
            Rate::PointLight => Some(LIGHT),
            Rate::Point => Some(POINT),
            Rate::Never | Rate::Frame | Rate::Light => None,
        };
        let program = schedule(builder, &[vec![], listed.factors().to_vec()], &section);
        let known: Vec<u32> = program
            .inputs
            .iter()
            .map(|(index, _)| *index)
            .filter(|index| builder.operations[*index as usize].code.is_some())
            .collect();
        let values: Vec<Value> = known.iter().map(|index| Value::Varying(*index)).collect();
        let once = schedule(builder, &[values], &|_| Some(0));
        let of = |(index, register): &(u32, u16)| {
            let place = known.iter().position(|own| own == index);
            let input = place.map(|place| Input::Known(place as u16));
            let input = input.or_else(|| listed.named.input_of(*index));
            input.map(|input| (input, *register))
        };
        Ok(Self {
            inputs: program.inputs.iter().filter_map(of).collect(),
            once_inputs: once.inputs.iter().filter_map(of).collect(),
            parts: parts::parts(builder, &listed.formula, [&program, &once]),
            program,
            once,
        })
    }

    /// Returns the parts of the text, with the numbers of their operations.
    pub fn parts(&self) -> &[LawPart] {
        &self.parts
    }

    /// Returns what is known of a light before a point is looked at, where L is constant.
    pub fn known(&self, incidence: &Incidence<f64>) -> Vec<f64> {
        let mut registers = Registers::new(&self.once, 0.0, 1);
        for (input, register) in &self.once_inputs {
            let value = input.of_light(incidence, &[]);
            registers.set(*register, 0, value.unwrap_or_default());
        }
        registers.run(&self.once.sections[0]);
        let results = self.once.results[0].iter();
        results.map(|slot| registers.get(*slot, 0)).collect()
    }

    /// Begins at a point: computes what is the same for all lights.
    #[inline(always)]
    pub fn at<R: Real>(&self, normal: V3<R>, view: V3<R>, color: Option<[R; 3]>) -> LawAt<'_, R> {
        let mut registers = Registers::new(&self.program, normal.x, 1);
        for (input, register) in &self.inputs {
            if let Some(value) = input.of_point(normal, view, color) {
                registers.set(*register, 0, value);
            }
        }
        registers.run(&self.program.sections[POINT]);
        LawAt {
            law: self,
            registers,
        }
    }
}

/// A law at a point.
pub struct LawAt<'a, R> {
    law: &'a Law,
    registers: Registers<R>,
}

impl<R: Real> LawAt<'_, R> {
    /// Returns the factors of a light's part, for each channel; `known` is what [`Law::known`] gives for the light.
    #[inline(always)]
    pub fn factors(&mut self, incidence: &Incidence<R>, known: &[R::Scalar]) -> [R; 3] {
        let program = &self.law.program;
        for (input, register) in &self.law.inputs {
            if let Some(value) = input.of_light(incidence, known) {
                self.registers.set(*register, 0, value);
            }
        }
        self.registers.run(&program.sections[LIGHT]);
        let slots = &program.results[LIGHT];
        std::array::from_fn(|channel| self.registers.get(slots[channel], 0))
    }
}
