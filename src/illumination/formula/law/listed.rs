//! The operations of a law, listed from its text.

use super::named::{Constancy, Named};
use crate::expression::{Formula, FormulaError, Operator};
use crate::illumination::formula::builder::{Builder, Value};
use crate::illumination::formula::lower::{Lowered, lower};
use crate::scene::{Rgb, Scene};

/// The operations of a law, in order.
pub struct Listed<'a> {
    pub formula: Formula,
    pub builder: Builder,
    /// The names, with the inputs that they need.
    pub named: Named<'a>,
    /// The values of the lines, for each channel.
    pub lines: [Vec<Lowered>; 3],
}

impl<'a> Listed<'a> {
    /// Lists the operations of the law that `scene` has as a text. Od is `color`, times that of the point where it is not constant.
    pub fn of(scene: &'a Scene, color: Rgb, constancy: Constancy) -> Result<Self, FormulaError> {
        let formula = scene.reflection.law()?;
        let mut builder = Builder::default();
        let mut named = Named::new(
            scene,
            color,
            constancy,
            formula.calls_any(&Operator::is_step),
        );
        let lines = [0, 1, 2].map(|channel| {
            named.channel = channel;
            lower(&mut builder, &formula, &mut named)
        });
        Ok(Self {
            formula,
            builder,
            named,
            lines,
        })
    }

    /// Returns the law's value for each channel.
    pub fn factors(&self) -> [Value; 3] {
        let value = |lines: &Vec<Lowered>| lines.last().and_then(Lowered::number);
        self.lines
            .each_ref()
            .map(|lines| value(lines).unwrap_or(Value::ZERO))
    }
}
