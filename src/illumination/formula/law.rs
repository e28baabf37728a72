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
    places: InputPlaces,
    /// The registers of what is the same for all lights.
    shared: Vec<u16>,
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
            shared: program.taken(LIGHT),
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
        let mut registers = Registers::new(&self.once, 0.0, 1);
        for (input, register) in &self.once_inputs {
            let value = input.of_light(incidence, &[]);
            registers.set(*register, 0, value.unwrap_or_default());
        }
        registers.run(&self.once.sections[0], 1);
        let results = self.once.results[0].iter();
        let numbers = results.map(|result| registers.get(*result, 0));
        numbers.chain([registers.undefined(0)]).collect()
    }

    /// Begins at a point: computes what is the same for all lights. `scratch` is that of this law's points before, or none; then it
    /// gets places for `lights`, at most [`TOGETHER`].
    #[inline(always)]
    pub fn at<'a, R: Real>(
        &'a self,
        normal: V3<R>,
        view: V3<R>,
        color: Option<&[R; 3]>,
        (scratch, lights): (&'a mut LawScratch<R>, usize),
    ) -> LawAt<'a, R> {
        let zero = normal.x.number(0.0);
        let places = lights.clamp(1, TOGETHER);
        let registers = scratch.get_or_insert_with(|| Registers::new(&self.program, zero, places));
        if let Some(normals) = self.places.normal {
            registers.set_vector(normals, [normal.x, normal.y, normal.z]);
        }
        if let Some(views) = self.places.view {
            registers.set_vector(views, [view.x, view.y, view.z]);
        }
        if let Some(colors) = self.places.color {
            let one = zero.number(1.0);
            registers.set_vector(colors, color.map_or([one; 3], |color| *color));
        }
        registers.set_undefined(0, zero);
        registers.run(&self.program.sections[POINT], 1);
        if places > 1 {
            for register in &self.shared {
                registers.spread(*register);
            }
        }
        LawAt {
            law: self,
            undefined: registers.undefined(0),
            registers,
        }
    }
}

/// The most lights that a law is evaluated for at once: an operation is chosen once for all of them.
pub const TOGETHER: usize = 7;

/// The registers of a law's code, kept from point to point.
pub(crate) type LawScratch<R> = Option<Registers<R>>;

/// A law at a point, with places for several lights.
pub struct LawAt<'a, R> {
    law: &'a Law,
    registers: &'a mut Registers<R>,
    /// 1 where an operation that is the same for all lights was undefined, otherwise 0.
    undefined: R,
}

impl<R: Real> LawAt<'_, R> {
    /// Returns the number of places for lights.
    #[inline(always)]
    pub fn places(&self) -> usize {
        self.registers.blocks()
    }

    /// Puts a light into a place; `known` is what [`Law::known`] gives for the light.
    #[inline(always)]
    pub fn put(&mut self, place: usize, incidence: &Incidence<R>, known: &[R::Scalar]) {
        let places = &self.law.places;
        if let Some([x, y, z]) = places.light {
            self.registers.set(x, place, incidence.l.x);
            self.registers.set(y, place, incidence.l.y);
            self.registers.set(z, place, incidence.l.z);
        }
        if let Some(register) = places.distance {
            self.registers.set(register, place, incidence.distance);
        }
        for (register, known) in places.known.iter().zip(known) {
            let known = self.undefined.constant(*known);
            self.registers.set(*register, place, known);
        }
        if self.law.may_be_undefined() {
            let of_light = known.last().map(|known| self.undefined.constant(*known));
            let undefined = of_light.map_or(self.undefined, |known| self.undefined.max(known));
            self.registers.set_undefined(place, undefined);
        }
    }

    /// Evaluates the law for the lights in the first `count` places.
    #[inline(always)]
    pub fn run(&mut self, count: usize) {
        self.registers.run(&self.law.program.sections[LIGHT], count);
    }

    /// Returns the factors of the part of the light in a place, for each channel.
    #[inline(always)]
    pub fn factors(&self, place: usize) -> [R; 3] {
        let results = &self.law.program.results[LIGHT];
        let mut factors = [self.undefined; 3];
        for (factor, register) in factors.iter_mut().zip(results) {
            *factor = self.registers.get(*register, place);
        }
        factors
    }

    /// Returns 1 where an operation was undefined for the light in a place, otherwise 0.
    #[inline(always)]
    pub fn undefined(&self, place: usize) -> R {
        self.registers.undefined(place)
    }
}
