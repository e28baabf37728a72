//! A law of reflection that is typed as a formula, in place of the diffuse and the specular term.

mod backs;
mod cost;
mod lines;
mod listed;
mod named;
mod parts;

pub use backs::lights_backs;
pub use cost::law_operations;
pub use lines::{LawLine, LawLines, LawValues, LineNumbers};
pub use listed::Listed;
pub use named::{Constancy, Incidence, Input};
pub use parts::{LawPart, Unneeded};

use super::builder::{Operation, Value};
use super::program::{GROUPS_TOGETHER, Program, Registers, schedule};
use super::rate::Rate;
use crate::expression::FormulaError;
use crate::illumination::{Real, ShadingPoint, V3};
use crate::scene::{Rgb, Scene};

/// The sections of the code at a point: what is the same for all lights there, and what differs from light to light.
const POINT: usize = 0;
const LIGHT: usize = 1;

/// A law of reflection typed as a formula: the factor of one light's part, for each channel.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Law {
    /// The code at a point.
    program: Program,
    places: InputPlaces,
    /// The code for a light whose L is constant, evaluated once.
    once: Program,
    once_inputs: Vec<(Input, u16)>,
    parts: Vec<LawPart>,
    names_distance: bool,
}

/// The registers of the inputs that the code at a point needs.
#[derive(Clone, Debug, Default, PartialEq)]
struct InputPlaces {
    normal: Option<[u16; 3]>,
    view: Option<[u16; 3]>,
    color: Option<[u16; 3]>,
    light: Option<[u16; 3]>,
    distance: Option<u16>,
    grazing: Option<u16>,
    /// Those of what is computed once for each light, in its order.
    known: Vec<u16>,
}

impl InputPlaces {
    /// Finds the registers of `inputs`; a component that nothing needs goes to the register `spare`.
    fn of(inputs: &[(Input, u16)], spare: u16) -> Self {
        let place = |input: Input| {
            let own = inputs.iter().find(|(own, _)| *own == input);
            own.map(|(_, register)| *register)
        };
        let vector = |component: fn(usize) -> Input| {
            let places = [0, 1, 2].map(|axis| place(component(axis)));
            let is_needed = places.iter().any(Option::is_some);
            is_needed.then(|| places.map(|place| place.unwrap_or(spare)))
        };
        Self {
            normal: vector(Input::Normal),
            view: vector(Input::View),
            color: vector(Input::Color),
            light: vector(Input::Light),
            distance: place(Input::Distance),
            grazing: place(Input::Grazing),
            known: (0..)
                .map_while(|index| place(Input::Known(index)))
                .collect(),
        }
    }
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
        let mut program = schedule(builder, &[vec![], listed.factors().to_vec()], &section);
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
        let inputs: Vec<(Input, u16)> = program.inputs.iter().filter_map(of).collect();
        let mut named = listed.named.made.iter();
        let names_distance = named.any(|(input, _)| *input == Input::Distance);
        let spare = program.registers as u16;
        program.registers += 1;
        Ok(Self {
            places: InputPlaces::of(&inputs, spare),
            names_distance,
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

    /// Returns whether there may be points where an operation is undefined.
    #[inline(always)]
    pub fn may_be_undefined(&self) -> bool {
        self.program.counts || self.once.counts
    }

    /// Returns whether the law depends on the distance to the light.
    #[inline(always)]
    pub fn names_distance(&self) -> bool {
        self.names_distance
    }

    /// Returns what is known of a light before a point is looked at, where L is constant; the last number is 1 if an operation was
    /// undefined.
    pub fn known(&self, incidence: &Incidence<f64>) -> Vec<f64> {
        let mut registers = Registers::new(&self.once, 0.0);
        for (input, register) in &self.once_inputs {
            let value = input.of_light(incidence);
            registers.set(*register, 0, value.unwrap_or_default());
        }
        registers.run(&self.once.sections[0], 1);
        let results = self.once.results[0].iter();
        let numbers = results.map(|result| registers.get(*result, 0));
        numbers.chain([registers.undefined[0]]).collect()
    }

    /// Begins at the first [`GROUPS_TOGETHER`] groups of points: computes what is the same for all lights. `registers` are those of this
    /// law's points before, or none.
    #[inline(always)]
    pub fn at<'a, R: Real>(
        &'a self,
        points: &[LawPoint<R>],
        registers: &'a mut Option<Registers<R>>,
        like: R,
    ) -> LawAt<'a, R> {
        let registers = registers.get_or_insert_with(|| Registers::new(&self.program, like));
        for (group, point) in points.iter().enumerate() {
            if let Some(normal) = self.places.normal {
                registers.set_vector(normal, group, &point.site.normal);
            }
            if let Some(view) = self.places.view {
                registers.set_vector(view, group, &point.site.view);
            }
            if let Some(places) = self.places.color {
                let [x, y, z] = point.color.unwrap_or([like.number(1.0); 3]);
                registers.set_vector(places, group, &V3 { x, y, z });
            }
        }
        registers.undefined = [like.number(0.0); GROUPS_TOGETHER];
        registers.run(&self.program.sections[POINT], points.len());
        LawAt {
            law: self,
            undefined: registers.undefined,
            registers,
        }
    }
}

/// A group of points at which a law is evaluated.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LawPoint<R> {
    pub site: ShadingPoint<R>,
    /// The part of Od that varies.
    pub color: Option<[R; 3]>,
    /// The intensity, per channel.
    pub sum: [R; 3],
    /// 1 where the law is undefined for a source that reaches the point, otherwise 0.
    pub undefined: R,
}

/// The groups of points at which a law is evaluated next, and what is kept from those before.
pub(crate) struct LawScratch<R> {
    pub points: Vec<LawPoint<R>>,
    pub registers: Option<Registers<R>>,
}

impl<R> Default for LawScratch<R> {
    fn default() -> Self {
        Self {
            points: vec![],
            registers: None,
        }
    }
}

/// A law at several groups of points.
pub struct LawAt<'a, R> {
    law: &'a Law,
    registers: &'a mut Registers<R>,
    /// 1 where an operation that is the same for all lights was undefined, otherwise 0.
    undefined: [R; GROUPS_TOGETHER],
}

impl<R: Real> LawAt<'_, R> {
    /// Sets a light as a group of points has it; `known` is what [`Law::known`] gives for the light.
    #[inline(always)]
    pub fn put(&mut self, group: usize, incidence: &Incidence<R>, known: &[R::Scalar]) {
        let places = &self.law.places;
        if let Some(light) = places.light {
            self.registers.set_vector(light, group, &incidence.l);
        }
        for (register, value) in [
            (places.distance, incidence.distance),
            (places.grazing, incidence.grazing),
        ] {
            if let Some(register) = register {
                self.registers.set(register, group, value);
            }
        }
        let undefined = self.undefined[group];
        for (register, known) in places.known.iter().zip(known) {
            self.registers
                .set(*register, group, undefined.constant(*known));
        }
        let of_light = known.last().map(|known| undefined.constant(*known));
        self.registers.undefined[group] = of_light.map_or(undefined, |known| undefined.max(known));
    }

    /// Evaluates the law for the light at the first `count` groups of points.
    #[inline(always)]
    pub fn run(&mut self, count: usize) {
        self.registers.run(&self.law.program.sections[LIGHT], count);
    }

    /// Returns the factors of the light's part at a group of points, for each channel.
    #[inline(always)]
    pub fn factors(&self, group: usize) -> [R; 3] {
        let results = &self.law.program.results[LIGHT];
        let mut factors = [self.undefined[group]; 3];
        for (factor, register) in factors.iter_mut().zip(results) {
            *factor = self.registers.get(*register, group);
        }
        factors
    }

    /// Returns 1 where an operation was undefined for the light at a group of points, otherwise 0.
    #[inline(always)]
    pub fn undefined(&self, group: usize) -> R {
        self.registers.undefined[group]
    }
}
