//! The values of a law's operations in three number types.

use crate::analysis::stability::precise::Precise;
use crate::illumination::{Equation, LawOperations, SourcePart};

/// The values of all operations in the three number types.
#[derive(Default)]
pub struct Values {
    pub single: Vec<f32>,
    pub double: Vec<f64>,
    pub exact: Vec<Precise>,
}

impl Values {
    /// Evaluates the law in all three number types, and returns its factors in `f32`, in `f64`, and in 106 bits as `f64`. In `f32`
    /// N·L counts as 0 where it does in the picture, whose equation is `single`.
    pub fn evaluate(
        &mut self,
        operations: &LawOperations,
        part: &SourcePart,
        single: &Equation<f32>,
    ) -> [[f64; 3]; 3] {
        let like = (0.0_f32, 0.0_f64, Precise::default());
        let mut rounded = part.site.rounded_to(like.0);
        rounded.incidence.grazing = single.grazing_at(part.nearness as f32);
        operations.evaluate(&rounded, &mut self.single);
        operations.evaluate(&part.site, &mut self.double);
        operations.evaluate(&part.site.rounded_to(like.2), &mut self.exact);
        [
            operations.factors(&self.single, like.0).map(f64::from),
            operations.factors(&self.double, like.1),
            operations.factors(&self.exact, like.2).map(f64::from),
        ]
    }
}
