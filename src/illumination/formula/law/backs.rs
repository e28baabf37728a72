//! The test for laws that may light surfaces turned away from the light.

use super::named::product_of;
use crate::expression::Formula;
use crate::illumination::formula::builder::{Builder, Sign, Value};
use crate::illumination::formula::lower::{Inputs, Lowered, lower};
use crate::illumination::formula::rate::Rate;
use crate::scene::{Backfacing, LAW_NUMBERS, Reflection};

/// The names of a law whose values are not known, but for the sign of N·L. The numbers that are no products are never negative.
struct Unknown {
    cosine: Sign,
    made: Vec<(usize, Lowered)>,
}

impl Inputs for Unknown {
    fn name(&mut self, builder: &mut Builder, index: usize) -> Lowered {
        if let Some((_, value)) = self.made.iter().find(|(own, _)| *own == index) {
            return *value;
        }
        let mut input = |sign| builder.input_of_sign(Rate::PointLight, sign);
        let value = match LAW_NUMBERS.get(index) {
            Some(name) if name.contains('·') => {
                let is_own = *name == "N·L";
                let cosine = input(if is_own { self.cosine } else { Sign::Any });
                builder.cosines.push(cosine);
                Lowered::Number(cosine)
            }
            Some(_) => Lowered::Number(input(Sign::NotNegative)),
            None => Lowered::Vector([(); 3].map(|()| input(Sign::Any))),
        };
        self.made.push((index, value));
        value
    }

    fn dot(&mut self, builder: &mut Builder, a: usize, b: usize) -> Option<Value> {
        self.name(builder, product_of(a, b)?).number()
    }
}

/// Lists the operations of a law where N·L has that sign; returns its value, too.
fn listed(formula: &Formula, cosine: Sign) -> (Builder, Option<Value>) {
    let mut builder = Builder::default();
    let made = vec![];
    let lines = lower(&mut builder, formula, &mut Unknown { cosine, made });
    let value = lines.last().and_then(Lowered::number);
    (builder, value)
}

/// Returns whether a light may add something to a surface that is turned away from it: a law of one's own may, unless its text
/// shows that it is defined everywhere and 0 wherever N·L is not above 0.
pub fn lights_backs(reflection: &Reflection) -> bool {
    if !reflection.is_own_law() {
        return reflection.backfacing == Backfacing::Flip;
    }
    let Ok(formula) = reflection.law() else {
        return false;
    };
    let (builder, _) = listed(&formula, Sign::Any);
    let mut all = builder.operations.iter();
    let (_, behind) = listed(&formula, Sign::NotPositive);
    behind != Some(Value::ZERO) || all.any(|operation| builder.may_be_undefined(operation))
}
