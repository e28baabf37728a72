//! The operations of a law at a pixel, counted from its code.

use super::listed::Listed;
use super::named::{Constancy, Input};
use crate::expression::FormulaError;
use crate::illumination::formula::builder::Value;
use crate::illumination::formula::code::Code;
use crate::illumination::formula::program::schedule;
use crate::scene::Scene;

/// Vectors are inputs, so that no operation on one is left out because of the numbers that it has in a scene.
const INPUTS: Constancy = Constancy {
    color: true,
    ..Constancy::NONE
};

/// Counts the operations at a pixel of the scene's own law: additions, multiplications, divisions and roots, and powers with
/// other functions that are no arithmetic. They are those of one light and of the channel that needs most.
///
/// As in the papers' counts, light and viewer are at infinity, so that what depends on L and V alone is computed once; signs,
/// comparisons, and the larger of two numbers are free.
///
/// # Errors
/// If the law cannot be read.
pub fn law_operations(scene: &Scene) -> Result<[u32; 4], FormulaError> {
    let listed = Listed::of(scene, scene.material.color, INPUTS)?;
    let (builder, named) = (&listed.builder, &listed.named);
    let of_channel = |factor| {
        let program = schedule(builder, &[vec![factor]], &|_| Some(0));
        // The values that differ from pixel to pixel.
        let normal = |index: &u32| matches!(named.input_of(*index), Some(Input::Normal(_)));
        let inputs = program.inputs.iter().map(|(index, _)| *index);
        let mut varying: Vec<Value> = inputs.filter(normal).map(Value::Varying).collect();
        let mut counts = [0; 4];
        for index in program.sources.concat() {
            let operation = &builder.operations[index as usize];
            let Some(code) = operation.code else { continue };
            let operands = &operation.operands[..code.operands()];
            if operands.iter().any(|operand| varying.contains(operand)) {
                varying.push(Value::Varying(index));
                let own = counts_of(code);
                counts = std::array::from_fn(|kind| counts[kind] + own[kind]);
            }
        }
        counts
    };
    let channels = listed.factors().map(of_channel);
    let most = channels
        .into_iter()
        .max_by_key(|own| own.iter().sum::<u32>());
    Ok(most.unwrap_or_default())
}

/// Returns additions, multiplications, divisions and roots, and powers of an operation.
fn counts_of(code: Code) -> [u32; 4] {
    match code {
        Code::Add | Code::Subtract => [1, 0, 0, 0],
        Code::Multiply => [0, 1, 0, 0],
        Code::MultiplyAdd | Code::MultiplySubtract | Code::SubtractProduct => [1, 1, 0, 0],
        Code::Divide | Code::Sqrt => [0, 0, 1, 0],
        Code::InverseSqrt => [0, 0, 2, 0],
        Code::Negate
        | Code::Min
        | Code::Max
        | Code::Abs
        | Code::Floor
        | Code::Greater
        | Code::Beyond => [0; 4],
        Code::Exp2
        | Code::Log2
        | Code::PowerOfPositive
        | Code::Power
        | Code::Sin
        | Code::Cos
        | Code::Asin
        | Code::Acos
        | Code::Atan => [0, 0, 0, 1],
    }
}
