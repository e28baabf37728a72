//! A formula that is typed, and graded by its meaning.

mod domain;
mod engine;
mod function;
mod meaning;
mod quantity;

use domain::POINTS;
pub use domain::{Name, Values};
pub use engine::term_text;
pub use function::Function;
use meaning::Field;
pub use quantity::Quantity;

use super::kind::{AnyKind, Predictions, Printed, QuestionKind};
use super::lettered::Bars;
use crate::expression::{Formula as Parsed, FormulaError};
use crate::figure::typed;
use crate::lesson::html::{Html, element};
use crate::lesson::page::inline;
use crate::lesson::read::keys::{KeyReader, Keys, NameKeys, Term};
use crate::lesson::{Grade, Hint, LabPlace};
use crate::text::{excerpt, listed, text};

/// A formula over given names.
#[derive(Clone, Debug, PartialEq)]
pub struct Formula {
    /// The names that may be used, with the values that they may have.
    pub names: Vec<Name>,
    /// The quantity that is asked for.
    pub of: FormulaOf,
}

/// The formula that is asked for.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum FormulaOf {
    /// A formula of the lesson.
    Text(String),
    /// A term of the engine's own equation, as it stands in the scene.
    Term(Term),
}

/// Answers that are the same function.
#[derive(Clone, Debug, PartialEq)]
pub struct SameFormula {
    /// The wrong model that they agree with.
    pub model: Option<usize>,
    /// True if they are right.
    pub right: bool,
    /// The spellings with how often each was typed, the most frequent first.
    pub spellings: Vec<(String, usize)>,
}

impl SameFormula {
    /// Returns how many answers there are.
    pub fn count(&self) -> usize {
        self.spellings.iter().map(|(_, count)| count).sum()
    }
}

/// The operations at a point that the engine's own term counts as.
const TERM: usize = 100;
/// Signs that on-screen keyboards hide behind other layouts, or lack.
pub const FORMULA_SIGNS: [&str; 8] = ["·", "^", "(", ")", "*", "/", "+", "-"];
/// The significant digits of results: as few as tell two of them apart, and those that show a point as it is.
const DIGITS: usize = 3;
const EXACT: usize = 9;
/// The most spellings of one function that a sheet shows.
const SPELLINGS: usize = 4;

impl Formula {
    /// The most names of a question.
    pub const MOST_NAMES: usize = 12;
    /// The longest answer, in characters.
    pub const MOST_CHARACTERS: usize = Parsed::MOST_CHARACTERS;

    /// Reads an answer; the error says where it is wrong and what was expected there.
    pub fn function(&self, text: &str) -> Result<Function, FormulaError> {
        let function = Function::read(text, &self.names)?;
        match &self.of {
            FormulaOf::Text(right) if right == text => Ok(function),
            _ => function.if_expected(self.wants_vector()),
        }
    }

    /// Returns the values of the names at a point of the domain, by its number.
    pub fn point(&self, number: usize) -> Option<Vec<Quantity>> {
        domain::points(&self.names).into_iter().nth(number)
    }

    /// Returns a formula for prose, set as in textbooks.
    pub fn set(text: &str) -> String {
        format!("${}$", typed(text))
    }

    /// Sorts answers by their meaning: those of a wrong model first, then other wrong ones, then the right ones; of each sort the
    /// most frequent first. What cannot be read is left out.
    pub fn sorted<'a>(
        &self,
        given: impl Iterator<Item = (&'a str, Grade)>,
        right: &str,
    ) -> Vec<SameFormula> {
        let Ok(right) = self.function(right) else {
            return Vec::new();
        };
        let field = Field::new(&self.names, &right);
        let mut groups: Vec<(Function, SameFormula)> = Vec::new();
        for (text, grade) in given {
            let mut spellings = groups
                .iter_mut()
                .flat_map(|(_, group)| &mut group.spellings);
            if let Some((_, count)) = spellings.find(|(known, _)| known == text) {
                *count += 1;
                continue;
            }
            let Ok(function) = self.function(text) else {
                continue;
            };
            let spelling = (text.to_owned(), 1);
            match groups
                .iter_mut()
                .find(|(known, _)| field.same(known, &function))
            {
                Some((_, group)) => group.spellings.push(spelling),
                None => groups.push((
                    function,
                    SameFormula {
                        model: grade.model,
                        right: grade.right,
                        spellings: vec![spelling],
                    },
                )),
            }
        }
        let mut groups: Vec<SameFormula> = groups.into_iter().map(|(_, group)| group).collect();
        for group in &mut groups {
            group
                .spellings
                .sort_by_key(|(_, count)| std::cmp::Reverse(*count));
        }
        let rank = |group: &SameFormula| (group.right, group.model.is_none());
        groups.sort_by_key(|group| (rank(group), std::cmp::Reverse(group.count())));
        groups
    }

    /// Says where a formula differs from the right one, with the values of the names there.
    pub(in crate::lesson) fn difference_words(
        &self,
        point: usize,
        given: Option<[f64; 3]>,
        expected: Option<[f64; 3]>,
    ) -> String {
        let Some(point) = self.point(point) else {
            return String::new();
        };
        let values = self.names.iter().zip(&point);
        let values = values.map(|(name, value)| {
            let (name, value) = (Self::set(&name.name), value.words(EXACT));
            format!("{name} = {value}")
        });
        let vector = self.wants_vector();
        let words = |value: Option<[f64; 3]>, digits: usize| match value {
            Some(value) if vector => Quantity::Vector(value).words(digits),
            Some([value, ..]) => Quantity::Number(value).words(digits),
            None => text!("lesson-formula-no-value").to_owned(),
        };
        let both = |digits: usize| [given, expected].map(|value| words(value, digits));
        let apart = (DIGITS..EXACT)
            .map(both)
            .find(|[given, expected]| given != expected);
        let [given, expected] = apart.unwrap_or_else(|| both(EXACT));
        text!(
            "lesson-hint-formula",
            values = listed(values),
            given = given,
            expected = expected
        )
    }

    /// Returns whether a vector is asked for.
    pub fn wants_vector(&self) -> bool {
        match &self.of {
            FormulaOf::Text(right) => {
                Function::read(right, &self.names).is_ok_and(|right| right.is_vector())
            }
            FormulaOf::Term(_) => false,
        }
    }

    /// Reads the names of a question.
    fn read_names(keys: &Keys, reader: &mut KeyReader<'_, '_>) -> Option<Vec<Name>> {
        let mut names: Vec<Name> = Vec::new();
        for key in &keys.names {
            let (name, range) = match key {
                NameKeys::Known(name) => (name, None),
                NameKeys::Between(ranges) if ranges.len() == 1 => {
                    let (name, range) = ranges.iter().next()?;
                    (name, Some(*range))
                }
                NameKeys::Between(_) => {
                    reader.wrong(text!("lesson-formula-names"));
                    return None;
                }
            };
            let values = match range {
                Some(range) => reader
                    .range("names", Some(range))
                    .map(|[from, to]| Values::Between(from, to)),
                None => Values::of(name),
            };
            let known = names.iter().any(|known| known.name == *name);
            let (true, false, Some(values)) = (Function::can_be_name(name), known, values) else {
                reader.wrong(text!("lesson-formula-name", name = &**name));
                return None;
            };
            names.push(Name {
                name: name.clone(),
                values,
            });
        }
        if names.is_empty() || names.len() > Self::MOST_NAMES {
            reader.wrong(text!("lesson-formula-many-names", most = Self::MOST_NAMES));
            return None;
        }
        Some(names)
    }

    /// Checks that each name appears in the answer or in a wrong model.
    fn check_use(&self, keys: &Keys, reader: &mut KeyReader<'_, '_>) {
        let FormulaOf::Text(right) = &self.of else {
            return;
        };
        let wrong = keys.wrong.iter().filter_map(|wrong| wrong.formula.as_ref());
        let texts = wrong.map(|text| &**text.get_ref()).chain([&**right]);
        let functions: Vec<Function> = texts
            .filter_map(|text| Function::read(text, &self.names).ok())
            .collect();
        for (index, name) in self.names.iter().enumerate() {
            if !functions.iter().any(|function| function.uses(index)) {
                reader.wrong(text!("lesson-formula-unused", name = &*name.name));
            }
        }
    }
}

impl AnyKind for Formula {
    fn hint(&self) -> Option<String> {
        let names = self.names.iter().map(|name| &*name.name);
        Some(text!("class-formula", names = listed(names)))
    }
}

impl QuestionKind for Formula {
    /// The formula as it was typed.
    type Answer = String;
    type Solution = String;

    const MODEL_KEYS: &[&str] = &["formula"];

    fn read(keys: &Keys, reader: &mut KeyReader<'_, '_>) -> Option<Self> {
        let names = Self::read_names(keys, reader)?;
        let of = match (&keys.answer, keys.term) {
            (Some(text), _) => {
                let key = if keys.is_wrong { "formula" } else { "answer" };
                if let Err(error) = Function::read(text.get_ref(), &names) {
                    reader.wrong_value(key, text, &error.to_string());
                    return None;
                }
                FormulaOf::Text(text.get_ref().clone())
            }
            (None, Some(term)) => FormulaOf::Term(term),
            (None, None) => {
                reader.missing("answer");
                return None;
            }
        };
        let read = Self { names, of };
        if !keys.is_wrong {
            read.check_use(keys, reader);
        }
        Some(read)
    }

    fn solve(&self, place: LabPlace<'_>, _: u64) -> Result<String, String> {
        let right = self.solve_wrong(place, 0)?;
        let function = self.function(&right).map_err(|error| error.to_string())?;
        place.spend_operations(POINTS * function.size())?;
        let field = Field::new(&self.names, &function);
        if !field.is_defined() {
            return Err(text!("lesson-formula-undefined").to_owned());
        }
        if field.constant {
            return Err(text!("lesson-formula-constant").to_owned());
        }
        Ok(right)
    }

    fn solve_wrong(&self, place: LabPlace<'_>, _: u64) -> Result<String, String> {
        match &self.of {
            FormulaOf::Text(text) => Ok(text.clone()),
            FormulaOf::Term(term) => {
                place.spend_operations(POINTS * TERM)?;
                term_text(*term, &self.names, &place.scene())
            }
        }
    }

    fn right(right: &String) -> String {
        right.clone()
    }

    fn fits(&self, given: &String) -> bool {
        self.function(given).is_ok()
    }

    fn tolerance(&self) -> f64 {
        1.0
    }

    /// Returns the largest difference in the domain of the model, in tolerances.
    fn distance(&self, given: &String, model: &String, _: LabPlace<'_>) -> Option<f64> {
        let [given, model] = [given, model].map(|text| self.function(text).ok());
        let (given, model) = given.zip(model)?;
        let field = Field::new(&self.names, &model);
        Some(
            field
                .difference(&given, &model)
                .map_or(0.0, |difference| difference.off),
        )
    }

    fn fault(&self, given: &String, right: &String, _: LabPlace<'_>) -> Option<Hint> {
        let [given, right] = [given, right].map(|text| self.function(text).ok());
        let (given, right) = given.zip(right)?;
        let difference = Field::new(&self.names, &right).difference(&given, &right)?;
        Some(Hint::Formula {
            point: difference.point,
            given: difference.given.map(Quantity::components),
            expected: difference.expected.map(Quantity::components),
        })
    }

    /// Grades a formula: right is what is the same function, and a wrong model is named only where it is the same.
    fn grade(
        &self,
        given: &String,
        right: &String,
        wrong: &[&String],
        place: LabPlace<'_>,
    ) -> Option<Grade> {
        let function = self.function(given).ok()?;
        let own = self.function(right).ok()?;
        // At most it is compared with all of them, and once more with the right one.
        let compared = (2 + wrong.len()) * function.size() + 3 * own.size();
        place.spend_operations(POINTS * compared).ok()?;
        let field = Field::new(&self.names, &own);
        let mut grade = Grade {
            right: field.same(&function, &own),
            ..Grade::default()
        };
        if grade.right {
            grade.score = 1.0;
            return Some(grade);
        }
        let is_that = |model: &&String| {
            let model = self.function(model);
            model.is_ok_and(|model| field.same(&function, &model))
        };
        grade.model = wrong.iter().position(is_that);
        if grade.model.is_none() {
            grade.hint = self.fault(given, right, place);
        }
        Some(grade)
    }

    fn short(given: &String) -> String {
        let words: Vec<&str> = given.split_whitespace().collect();
        excerpt(&words.join(" "))
    }

    fn words(&self, given: &String, _: &[String]) -> String {
        Self::set(given)
    }

    fn solution_words(&self, right: &String, _: &[String]) -> String {
        Self::set(right)
    }

    /// Prints the names that may be used, and a line to write on.
    fn blank(&self, _: &Printed<'_>, _: Option<&String>) -> Result<Html, String> {
        let names = self.names.iter().map(|name| Self::set(&name.name));
        let names = text!("class-formula", names = listed(names));
        let names = element("p").class("quiet").with(inline(&names));
        Ok(Html::new().line(names).line(element("div").class("rule")))
    }

    /// Prints the formulas of the class: one row for each function, with its spellings.
    fn chart(&self, class: &Predictions<'_, String, String>) -> Html {
        let Some(right) = class.right else {
            return Html::new();
        };
        let given = class.given.iter();
        let given = given.map(|(text, grade)| (text.as_str(), *grade));
        let groups = self.sorted(given, right).into_iter();
        let bars = groups.fold(Bars::new(class.given.len()), |bars, group| {
            let (count, right) = (group.count(), group.right);
            bars.with(spellings(&group), count, right)
        });
        bars.table()
    }
}

/// Returns the HTML of the spellings of a function: the most frequent one set as in textbooks, the others as typed.
fn spellings(group: &SameFormula) -> Html {
    let mut label = Html::new();
    for (index, (text, _)) in group.spellings.iter().take(SPELLINGS).enumerate() {
        label = if index == 0 {
            label.with(inline(&Formula::set(text)))
        } else {
            label
                .with(element("br"))
                .with(element("code").with(Formula::short(text)))
        };
    }
    match group.spellings.len().saturating_sub(SPELLINGS) {
        0 => label,
        more => label
            .with(element("br"))
            .with(text!("class-formula-more", count = more)),
    }
}
