//! A value: a number that is typed.

use super::kind::{AnyKind, Predictions, Printed, QuestionKind};
use super::number::{blank_line, digits, number_chart, short_number, with_unit};
use crate::expression::Expression;
use crate::figure::short;
use crate::lesson::html::{Html, element};
use crate::lesson::read::keys::{KeyReader, Keys};
use crate::lesson::{Hint, LabPlace};
use crate::text::{fixed, text};

/// A number from a field that takes `from` to `to`.
#[derive(Clone, Debug, PartialEq)]
pub struct Value {
    /// The right value.
    pub answer: Expression,
    /// The largest distance from it that counts as right.
    pub tolerance: f64,
    /// The smallest number that can be entered.
    pub from: f64,
    /// The largest number that can be entered.
    pub to: f64,
    /// The unit after the field; may be empty.
    pub unit: String,
}

impl AnyKind for Value {
    fn hint(&self) -> Option<String> {
        Some(text!(
            "class-range",
            from = self.from.to_string(),
            to = self.to.to_string(),
            unit = &*self.unit
        ))
    }

    fn unit(&self) -> &str {
        &self.unit
    }

    fn predicts_number(&self) -> bool {
        true
    }
}

impl QuestionKind for Value {
    /// The number.
    type Answer = f64;
    type Solution = f64;

    const MODEL_KEYS: &[&str] = &["answer"];

    fn read(keys: &Keys, reader: &mut KeyReader<'_, '_>) -> Option<Self> {
        let answer = reader.expression("answer", &keys.answer);
        let tolerance = reader.positive("tolerance", keys.tolerance);
        let range = keys.from.zip(keys.to).map(|(from, to)| [from, to]);
        let range = reader.range("from", range);
        let (tolerance, [from, to]) = (tolerance?, range?);
        Some(Self {
            answer: answer?,
            tolerance,
            from,
            to,
            unit: keys.unit.clone(),
        })
    }

    fn solve(&self, place: LabPlace<'_>, _: u64) -> Result<f64, String> {
        let value = place.number(&self.answer)?;
        if value - self.tolerance < self.from || value + self.tolerance > self.to {
            let value = fixed(value, 4);
            return Err(text!("lesson-value-outside", value = value));
        }
        Ok(value)
    }

    fn solve_wrong(&self, place: LabPlace<'_>, _: u64) -> Result<f64, String> {
        let value = place.number(&self.answer)?;
        if value < self.from || value > self.to {
            let value = fixed(value, 4);
            return Err(text!("lesson-wrong-value-outside", value = value));
        }
        Ok(value)
    }

    fn right(right: &f64) -> f64 {
        *right
    }

    fn fits(&self, given: &f64) -> bool {
        (self.from..=self.to).contains(given)
    }

    fn tolerance(&self) -> f64 {
        self.tolerance
    }

    fn distance(&self, given: &f64, model: &f64, _: LabPlace<'_>) -> Option<f64> {
        Some((given - model).abs())
    }

    fn fault(&self, given: &f64, right: &f64, _: LabPlace<'_>) -> Option<Hint> {
        Some(Hint::Number {
            high: given > right,
        })
    }

    fn number(given: &f64) -> Option<f64> {
        Some(*given)
    }

    fn short(given: &f64) -> String {
        short_number(*given)
    }

    fn short_solution(&self, right: &f64) -> String {
        with_unit(&short_number(*right), &self.unit)
    }

    fn words(&self, given: &f64, _: &[String]) -> String {
        with_unit(&short(*given), &self.unit)
    }

    fn solution_words(&self, right: &f64, _: &[String]) -> String {
        with_unit(&fixed(*right, digits(self.tolerance)), &self.unit)
    }

    fn blank(&self, _: &Printed<'_>, _: Option<&f64>) -> Result<Html, String> {
        let words = element("p").with(text!("class-answer")).with(" ");
        let line = words.with(blank_line()).with(" ").with(&*self.unit);
        Ok(Html::new().line(line))
    }

    fn chart(&self, class: &Predictions<'_, f64, f64>) -> Html {
        number_chart(class, Some([self.from, self.to]), self.tolerance)
    }
}
