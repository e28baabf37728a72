//! A choice: one of several options.

use super::extreme::{Extreme, too_near};
use super::kind::{AnyKind, Predictions, Printed, QuestionKind};
use super::lettered::{Bars, letter, lettered, lettered_html};
use crate::expression::Expression;
use crate::lesson::html::{Html, element};
use crate::lesson::read::keys::{KeyReader, Keys, Most};
use crate::lesson::{Grade, Hint, LabPlace, Prose};
use crate::text::text;

/// A choice among several options.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    /// The options, two to eight.
    pub options: Vec<ChoiceOption>,
    /// The right option is that whose scene has the largest or the smallest value of this.
    pub by: Option<(Extreme, Expression)>,
}

/// An option of a choice.
#[derive(Clone, Debug, PartialEq)]
pub struct ChoiceOption {
    /// Its text.
    pub text: Prose,
    /// A sentence that names the misconception of those who choose it; may be empty.
    pub says: Prose,
    /// The reason why it is right, where the lesson says so or an expression decides.
    pub right: Option<RightIf>,
    /// Settings of its scene.
    pub set: Vec<String>,
}

/// The reason why an option is right.
#[derive(Clone, Debug, PartialEq)]
pub enum RightIf {
    /// The lesson's own statement: true if it is right.
    Said(bool),
    /// An expression that is true if it is right.
    Holds(Expression),
}

impl AnyKind for Choice {
    fn options(&self) -> Vec<&Prose> {
        self.options.iter().map(|option| &option.text).collect()
    }

    fn chart_tells(&self) -> bool {
        true
    }
}

impl QuestionKind for Choice {
    /// The number of an option, from 0.
    type Answer = usize;
    type Solution = usize;

    /// A wrong option says itself what is wrong with it.
    const MODEL_KEYS: &[&str] = &[];

    fn read(keys: &Keys, reader: &mut KeyReader<'_, '_>) -> Option<Self> {
        if !(2..=8).contains(&keys.option.len()) {
            reader.wrong(text!("lesson-options", least = 2, most = 8));
            return None;
        }
        let by = read_extreme(keys, reader);
        let mut options = Vec::new();
        for option in &keys.option {
            let right = match (&option.holds, option.right) {
                (Some(_), Some(_)) => {
                    let at = reader.at + option.text.span().start;
                    reader.lesson.wrong(at, text!("lesson-option-both"));
                    None
                }
                (Some(_), None) => reader
                    .expression("holds", &option.holds)
                    .map(RightIf::Holds),
                (None, said) => said.map(RightIf::Said),
            };
            options.push(ChoiceOption {
                text: reader.prose(Some(&option.text)),
                says: reader.prose(option.says.as_ref()),
                right,
                set: option.set.clone(),
            });
        }
        let decided = options.iter().any(|option| option.right.is_some());
        if decided == by.is_some() {
            reader.wrong(text!("lesson-option-neither"));
            return None;
        }
        Some(Self { options, by })
    }

    fn solve(&self, place: LabPlace<'_>, _: u64) -> Result<usize, String> {
        if let Some((extreme, by)) = &self.by {
            let value = |option: &ChoiceOption| place.under(&option.set)?.number(by);
            let values: Result<Vec<f64>, String> = self.options.iter().map(value).collect();
            return best(&values?, *extreme);
        }
        let mut right = Vec::new();
        for (index, option) in self.options.iter().enumerate() {
            let there = place.under(&option.set)?;
            let holds = match &option.right {
                Some(RightIf::Said(said)) => *said,
                Some(RightIf::Holds(holds)) => holds.holds(&there)?,
                None => false,
            };
            right.extend(holds.then_some(index));
        }
        match right[..] {
            [right] => Ok(right),
            _ => Err(text!("lesson-right-options", count = right.len())),
        }
    }

    /// Checks that the right option does not say what is wrong with it.
    fn check(&self, right: &usize, _: LabPlace<'_>) -> Result<(), String> {
        let right = self.options.get(*right);
        if right.is_some_and(|option| !option.says.is_empty()) {
            return Err(text!("lesson-right-says").to_owned());
        }
        Ok(())
    }

    fn right(right: &usize) -> usize {
        *right
    }

    fn fits(&self, given: &usize) -> bool {
        *given < self.options.len()
    }

    fn tolerance(&self) -> f64 {
        0.5
    }

    /// Returns 0 of the same option, 1 of another one.
    fn distance(&self, given: &usize, model: &usize, _: LabPlace<'_>) -> Option<f64> {
        Some(f64::from(u8::from(given != model)))
    }

    fn fault(&self, _: &usize, _: &usize, _: LabPlace<'_>) -> Option<Hint> {
        None
    }

    fn grade(&self, given: &usize, right: &usize, _: &[&usize], _: LabPlace<'_>) -> Option<Grade> {
        let is_right = given == right;
        let option = self.options.get(*given);
        let says = option.is_some_and(|option| !option.says.is_empty());
        Some(Grade {
            right: is_right,
            score: f64::from(u8::from(is_right)),
            model: (says && !is_right).then_some(*given),
            ..Grade::default()
        })
    }

    fn short(given: &usize) -> String {
        letter(*given).to_string()
    }

    fn words(&self, given: &usize, options: &[String]) -> String {
        options.get(*given).cloned().unwrap_or_default()
    }

    fn solution_words(&self, right: &usize, options: &[String]) -> String {
        lettered(*right, options)
    }

    fn blank(&self, printed: &Printed<'_>, _: Option<&usize>) -> Result<Html, String> {
        let list = element("ul").class("options").broken();
        let options = printed.options.iter().enumerate();
        let list = options.fold(list, |list, (index, words)| {
            let row = element("li").with(element("span").class("box"));
            list.line(row.with(lettered_html(index, words)))
        });
        Ok(Html::new().line(list))
    }

    fn chart(&self, class: &Predictions<'_, usize, usize>) -> Html {
        let options = class.options.iter().enumerate();
        let options = options.filter(|_| !class.given.is_empty());
        let bars = options.fold(Bars::new(class.given.len()), |bars, (option, words)| {
            let chosen = class.given.iter().filter(|(given, _)| **given == option);
            let label = lettered_html(option, words);
            bars.with(label, chosen.count(), class.right == Some(&option))
        });
        bars.table()
    }
}

/// Reads `greatest` or `least`.
fn read_extreme(keys: &Keys, reader: &mut KeyReader<'_, '_>) -> Option<(Extreme, Expression)> {
    let pairs = [
        (Extreme::Greatest, "greatest", &keys.greatest),
        (Extreme::Least, "least", &keys.least),
    ];
    for (extreme, key, value) in pairs {
        if let Some(value) = value
            && let Most::Of(text) = value.get_ref()
        {
            let expression = reader.expression_of(key, value, text);
            return expression.map(|expression| (extreme, expression));
        }
    }
    None
}

/// Finds the largest or smallest value, which no other comes near.
fn best(values: &[f64], extreme: Extreme) -> Result<usize, String> {
    let key = |index: &usize| -extreme.sign() * values[*index];
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|a, b| key(a).total_cmp(&key(b)));
    match order[..] {
        [first, second, ..] if !too_near(values[first], values[second]) => Ok(first),
        [only] => Ok(only),
        _ => Err(text!("lesson-too-near").to_owned()),
    }
}
