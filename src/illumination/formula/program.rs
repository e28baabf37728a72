//! Straight-line code, ready to run: operations in order, with registers, over several groups of points at a time.

use super::builder::{Builder, Operation, Value};
use super::code::{Code, for_code};
use crate::illumination::{Real, V3};
use std::cell::Cell;
use std::collections::HashMap;

/// An operation with the registers of its operands and of its result.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    pub code: Code,
    pub operands: [u16; 3],
    pub result: u16,
    /// True if the points where it is undefined are counted.
    pub counts: bool,
}

/// Code in sections, which run one after the other. What a section computes may be used by those after it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Program {
    pub sections: Vec<Vec<Step>>,
    /// The registers of the values that each section gives.
    pub results: Vec<Vec<u16>>,
    /// The values of the first registers, which never change.
    pub constants: Vec<f64>,
    /// The registers of the inputs that are needed, by the input's index among the builder's operations.
    pub inputs: Vec<(u32, u16)>,
    /// The number of registers, those of the constants among them.
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
    let constants = constants(builder, &sources, results);
    let mut allocation = Allocation::new(builder, &sources, results, constants.len());
    let register = |value: Value, allocation: &Allocation| match value {
        Value::Varying(index) => allocation.places[&index],
        Value::Known(number, _) => place_of(&constants, number).unwrap_or(0) as u16,
    };
    for (index, operation) in builder.operations.iter().enumerate() {
        if needed[index] && section(operation).is_none() {
            let register = allocation.allocate(index as u32);
            program.inputs.push((index as u32, register));
        }
    }
    let mut time = 0;
    for (own, results) in sources.iter().zip(results) {
        let mut steps = vec![];
        for index in own {
            let operation = &builder.operations[*index as usize];
            let Some(code) = operation.code else { continue };
            let operands = operation.operands.map(|value| register(value, &allocation));
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
        let given = results.iter().map(|value| register(*value, &allocation));
        program.results.push(given.collect());
        allocation.release(time);
        time += 1;
    }
    program.registers = allocation.count;
    program.constants = constants;
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

/// Returns each number that the operations or the results name, once.
fn constants(builder: &Builder, sources: &[Vec<u32>], results: &[Vec<Value>]) -> Vec<f64> {
    let operations = sources
        .iter()
        .flatten()
        .map(|index| &builder.operations[*index as usize]);
    let operands = operations.flat_map(|operation| &operation.operands);
    let mut constants = vec![];
    for value in operands.chain(results.iter().flatten()) {
        if let Value::Known(number, _) = value
            && place_of(&constants, *number).is_none()
        {
            constants.push(*number);
        }
    }
    constants
}

fn place_of(constants: &[f64], number: f64) -> Option<usize> {
    let same = |own: &f64| own.to_bits() == number.to_bits();
    constants.iter().position(same)
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
    /// Finds when each value is last used; the registers begin after the constants. The last section may run several times: what it takes from those before it,
    /// and the inputs, are kept to its end.
    fn new(
        builder: &Builder,
        sources: &[Vec<u32>],
        results: &[Vec<Value>],
        constants: usize,
    ) -> Self {
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
            count: constants,
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

/// The most groups of points that code runs over at once: an operation is chosen once for all of them.
pub const GROUPS_TOGETHER: usize = 4;

/// The registers of a program, each with a number for each of several groups of points.
pub struct Registers<R> {
    numbers: Vec<[R; GROUPS_TOGETHER]>,
    /// 1 where an operation was undefined, otherwise 0.
    pub undefined: [R; GROUPS_TOGETHER],
}

impl<R: Real> Registers<R> {
    /// Returns the registers of a program, with its constants.
    #[inline(always)]
    pub fn new(program: &Program, like: R) -> Self {
        let zero = [like.number(0.0); GROUPS_TOGETHER];
        let mut numbers = Vec::with_capacity(program.registers);
        for constant in &program.constants {
            numbers.push([like.number(*constant); GROUPS_TOGETHER]);
        }
        numbers.resize(program.registers, zero);
        Self {
            numbers,
            undefined: zero,
        }
    }

    /// Returns a register's number for one group of points.
    #[inline(always)]
    pub fn get(&self, register: u16, group: usize) -> R {
        self.numbers[usize::from(register)][group]
    }

    /// Sets a register's number for one group of points.
    #[inline(always)]
    pub fn set(&mut self, register: u16, group: usize, value: R) {
        self.numbers[usize::from(register)][group] = value;
    }

    /// Sets the registers of a vector's components for one group of points.
    #[inline(always)]
    pub fn set_vector(&mut self, [x, y, z]: [u16; 3], group: usize, vector: &V3<R>) {
        self.set(x, group, vector.x);
        self.set(y, group, vector.y);
        self.set(z, group, vector.z);
    }

    /// Runs a section's steps for the first `count` groups of points, and notes where operations are undefined.
    // In one copy for all callers: it has the code of all operations.
    #[inline(never)]
    pub fn run(&mut self, steps: &[Step], count: usize) {
        let Self { numbers, undefined } = self;
        // A result may take the place of an operand.
        let numbers = Cell::from_mut(&mut numbers[..]).as_slice_of_cells();
        undefined[0].vectorize(
            #[inline(always)]
            move || {
                for step in steps {
                    let place = |register: u16| numbers[usize::from(register)].as_array_of_cells();
                    let [a, b, c] = step.operands;
                    if step.counts {
                        let operands = place(a).iter().zip(place(b)).take(count);
                        for ((a, b), undefined) in operands.zip(&mut *undefined) {
                            let here = step.code.undefined(a.get(), b.get());
                            *undefined = here.max(*undefined);
                        }
                    }
                    let result = place(step.result);
                    for_code!(step.code, CODE => {
                        let a = place(a);
                        // Operands that an operation does not have are not looked up.
                        let b = if CODE.operands() > 1 { place(b) } else { a };
                        let c = if CODE.operands() > 2 { place(c) } else { a };
                        for group in 0..count.min(GROUPS_TOGETHER) {
                            let [a, b, c] = [a[group].get(), b[group].get(), c[group].get()];
                            result[group].set(CODE.apply(a, b, c));
                        }
                    });
                }
            },
        );
    }
}
