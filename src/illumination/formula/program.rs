//! Straight-line code, ready to run: operations in order, with registers, over many points at a time.

use super::builder::{Builder, Operation, Value};
use super::code::{Code, for_code};
use crate::illumination::Real;
use std::collections::HashMap;

/// The place of a value: a constant, or a register with a number for each point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Slot {
    Constant(u16),
    Register(u16),
}

/// An operation with the places of its operands and of its result.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    pub code: Code,
    pub operands: [Slot; 3],
    pub result: u16,
    /// True if the points where it is undefined are counted.
    pub counts: bool,
}

/// Code in sections, which run one after the other. What a section computes may be used by those after it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Program {
    pub sections: Vec<Vec<Step>>,
    /// The places of the values that each section gives.
    pub results: Vec<Vec<Slot>>,
    pub constants: Vec<f64>,
    /// The registers of the inputs that are needed, by the input's index among the builder's operations.
    pub inputs: Vec<(u32, u16)>,
    /// The number of registers.
    pub registers: usize,
    /// True if a step counts the points where it is undefined.
    pub counts: bool,
    /// The operations that the steps were made of, section by section.
    pub sources: Vec<Vec<u32>>,
}

/// Makes code of the operations that `results` need, in sections; `section` gives the section of an operation, none where its
/// result is an input.
pub fn schedule(
    builder: &Builder,
    results: &[Vec<Value>],
    section: &dyn Fn(&Operation) -> Option<usize>,
) -> Program {
    let section = |operation: &Operation| operation.code.and_then(|_| section(operation));
    let needed = needed(builder, results, &section);
    let mut program = Program::default();
    let sources: Vec<Vec<u32>> = (0..results.len())
        .map(|own| {
            let all = (0..builder.operations.len()).filter(|index| {
                needed[*index] && section(&builder.operations[*index]) == Some(own)
            });
            all.map(|index| index as u32).collect()
        })
        .collect();
    let mut allocation = Allocation::new(builder, &sources, results);
    for (index, operation) in builder.operations.iter().enumerate() {
        if needed[index] && section(operation).is_none() {
            let register = allocation.allocate(index as u32);
            program.inputs.push((index as u32, register));
        }
    }
    let mut constants = Constants::default();
    let mut time = 0;
    for (own, results) in sources.iter().zip(results) {
        let mut steps = vec![];
        for index in own {
            let operation = &builder.operations[*index as usize];
            let Some(code) = operation.code else { continue };
            let operands = operation
                .operands
                .map(|value| constants.slot(value, &allocation));
            // A result may take the place of an operand that nothing else needs.
            allocation.release(time);
            time += 1;
            steps.push(Step {
                code,
                operands,
                result: allocation.allocate(*index),
                counts: builder.may_be_undefined(operation),
            });
        }
        program.counts |= steps.iter().any(|step| step.counts);
        program.sections.push(steps);
        let slots = results
            .iter()
            .map(|value| constants.slot(*value, &allocation));
        program.results.push(slots.collect());
        allocation.release(time);
        time += 1;
    }
    program.registers = allocation.count;
    program.constants = constants.numbers;
    program.sources = sources;
    program
}

/// Returns which operations and inputs the results depend on.
pub(super) fn needed(
    builder: &Builder,
    results: &[Vec<Value>],
    section: &dyn Fn(&Operation) -> Option<usize>,
) -> Vec<bool> {
    let mut needed = vec![false; builder.operations.len()];
    let mark = |needed: &mut Vec<bool>, value: &Value| {
        if let Value::Varying(index) = value {
            needed[*index as usize] = true;
        }
    };
    for value in results.iter().flatten() {
        mark(&mut needed, value);
    }
    for index in (0..builder.operations.len()).rev() {
        let operation = &builder.operations[index];
        let used = operation.code.map_or(0, Code::operands);
        if needed[index] && section(operation).is_some() {
            for value in &operation.operands[..used] {
                mark(&mut needed, value);
            }
        }
    }
    needed
}

#[derive(Default)]
struct Constants {
    numbers: Vec<f64>,
}

impl Constants {
    fn slot(&mut self, value: Value, allocation: &Allocation) -> Slot {
        let number = match value {
            Value::Varying(index) => return Slot::Register(allocation.places[&index]),
            Value::Known(number, _) => number,
        };
        let same = |own: &f64| own.to_bits() == number.to_bits();
        let place = self.numbers.iter().position(same).unwrap_or_else(|| {
            self.numbers.push(number);
            self.numbers.len() - 1
        });
        Slot::Constant(place as u16)
    }
}

/// The registers of values, which are given to others once nothing needs them.
struct Allocation {
    places: HashMap<u32, u16>,
    /// The values that are last used at each time.
    ends: Vec<Vec<u32>>,
    free: Vec<u16>,
    count: usize,
}

impl Allocation {
    /// Finds when each value is last used. The last section may run several times: what it takes from those before it,
    /// and the inputs, are kept to its end.
    fn new(builder: &Builder, sources: &[Vec<u32>], results: &[Vec<Value>]) -> Self {
        let mut last: HashMap<u32, (usize, usize)> = HashMap::new();
        let mut made: HashMap<u32, usize> = HashMap::new();
        let mut time = 0;
        for (section, (own, results)) in sources.iter().zip(results).enumerate() {
            let mut uses = |value: &Value, time: usize| {
                if let Value::Varying(index) = value {
                    last.insert(*index, (time, section));
                }
            };
            for index in own {
                let operation = &builder.operations[*index as usize];
                let used = operation.code.map_or(0, Code::operands);
                for value in &operation.operands[..used] {
                    uses(value, time);
                }
                made.insert(*index, section);
                time += 1;
            }
            for value in results {
                uses(value, time);
            }
            time += 1;
        }
        let mut ends = vec![vec![]; time];
        for (index, (end, section)) in last {
            // Inputs are kept, and so is what a later section takes from an earlier one.
            if made.get(&index) == Some(&section) {
                ends[end].push(index);
            }
        }
        for own in &mut ends {
            own.sort_unstable();
        }
        Self {
            places: HashMap::new(),
            ends,
            free: vec![],
            count: 0,
        }
    }

    fn allocate(&mut self, value: u32) -> u16 {
        let register = self.free.pop().unwrap_or_else(|| {
            self.count += 1;
            (self.count - 1) as u16
        });
        self.places.insert(value, register);
        register
    }

    fn release(&mut self, time: usize) {
        for value in &self.ends[time] {
            self.free.extend(self.places.get(value));
        }
    }
}

/// The registers of a program, each with a number for each of `blocks` groups of points.
pub struct Registers<R> {
    blocks: usize,
    constants: usize,
    /// The constants, then the registers, then the places where an operation was undefined.
    numbers: Vec<R>,
}

impl<R: Real> Registers<R> {
    /// Returns the registers of a program for `blocks` numbers in each.
    #[inline(always)]
    pub fn new(program: &Program, like: R, blocks: usize) -> Self {
        let constants = program.constants.len();
        let mut numbers = Vec::with_capacity(constants + (program.registers + 1) * blocks);
        for constant in &program.constants {
            numbers.push(like.number(*constant));
        }
        let zero = like.number(0.0);
        numbers.resize(constants + (program.registers + 1) * blocks, zero);
        Self {
            blocks,
            constants,
            numbers,
        }
    }

    /// Returns where a slot begins, and the distance of its numbers, of which a register has `blocks`.
    #[inline(always)]
    fn place(&self, slot: Slot, blocks: usize) -> (usize, usize) {
        match slot {
            Slot::Constant(index) => (usize::from(index), 0),
            Slot::Register(index) => (self.constants + usize::from(index) * blocks, 1),
        }
    }

    /// Returns a slot's number for one group of points.
    #[inline(always)]
    pub fn get(&self, slot: Slot, block: usize) -> R {
        let (place, step) = self.place(slot, self.blocks);
        self.numbers[place + block * step]
    }

    /// Sets a register's number for one group of points.
    #[inline(always)]
    pub fn set(&mut self, register: u16, block: usize, value: R) {
        let (place, _) = self.place(Slot::Register(register), self.blocks);
        self.numbers[place + block] = value;
    }

    /// Returns the number, 1 or 0, that says whether an operation was undefined at a group of points.
    #[inline(always)]
    pub fn undefined(&self, block: usize) -> R {
        self.numbers[self.numbers.len() - self.blocks + block]
    }

    /// Forgets where operations were undefined.
    #[inline(always)]
    pub fn reset(&mut self) {
        let first = self.numbers.len() - self.blocks;
        for number in &mut self.numbers[first..] {
            *number = number.number(0.0);
        }
    }

    /// Runs a section's steps where a register has one number.
    // In one copy for all callers: it has the code of all operations.
    #[inline(never)]
    pub fn run(&mut self, steps: &[Step]) {
        let Some(like) = self.numbers.first().copied() else {
            return;
        };
        like.vectorize(
            #[inline(always)]
            || {
                for step in steps {
                    self.run_step(step, [1, 1]);
                }
            },
        );
    }

    /// Runs a section's steps for the first `count` groups of points, and notes where operations are undefined.
    pub fn run_noting(&mut self, steps: &[Step], count: usize) {
        let blocks = [self.blocks, count];
        let undefined = self.numbers.len() - self.blocks;
        for step in steps {
            if step.counts {
                let [a, b, _] = step.operands.map(|slot| self.place(slot, self.blocks));
                each(
                    &mut self.numbers,
                    ([a, b, (undefined, 1)], undefined),
                    count,
                    |a, b, before: R| step.code.undefined(a, b).max(before),
                );
            }
            self.run_step(step, blocks);
        }
    }

    /// Runs a step for the first of the `blocks` numbers that a register has.
    #[inline(always)]
    fn run_step(&mut self, step: &Step, [blocks, count]: [usize; 2]) {
        let operands = step.operands.map(|slot| self.place(slot, blocks));
        let (result, _) = self.place(Slot::Register(step.result), blocks);
        for_code!(step.code, CODE => each(&mut self.numbers, (operands, result), count,
            #[inline(always)] |a, b, c| CODE.apply(a, b, c)));
    }
}

/// Computes a register's numbers from those of three operands.
#[inline(always)]
fn each<R: Real>(
    numbers: &mut [R],
    ([a, b, c], result): ([(usize, usize); 3], usize),
    blocks: usize,
    of: impl Fn(R, R, R) -> R,
) {
    for block in 0..blocks {
        let at = |(place, step): (usize, usize)| numbers[place + block * step];
        numbers[result + block] = of(at(a), at(b), at(c));
    }
}
