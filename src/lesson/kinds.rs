//! The kinds of questions: one line of a table each, and one file with all that is known of it.

mod choice;
mod curve;
mod extreme;
mod formula;
pub(super) mod kind;
mod lettered;
mod matching;
mod number;
mod order;
mod point;
mod settings;
mod shape;
mod value;

pub use choice::{Choice, ChoiceOption, RightIf};
#[cfg(any(feature = "app", feature = "class"))]
pub use curve::abscissa;
#[cfg(feature = "app")]
pub use curve::ordinate;
pub use curve::{CURVE_POINTS, Curve, CurveOf};
pub use extreme::Extreme;
pub use formula::{FORMULA_SIGNS, Formula, FormulaOf, Name, Quantity, SameFormula, Values};
pub(super) use lettered::Bars;
pub use lettered::letter;
#[cfg(feature = "class")]
pub(crate) use lettered::lettered_html;
pub use matching::{Match, MatchValues, picture_distance};
pub use number::{digits, short_number, with_unit};
pub use order::{Item, Order};
pub use point::{Find, Point};
pub use settings::{Goal, Settings};
pub use value::Value;

use super::html::Html;
use super::read::keys::{KeyReader, Keys};
use super::{Grade, LabPlace};
use kind::{AnyKind, Predictions, Printed, QuestionKind};
use serde::{Deserialize, Serialize};

/// The answers that a question's grades are taken from.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct AnswerKey {
    /// The right answer.
    pub right: Solution,
    /// The answers of the wrong models, in their order.
    pub wrong: Vec<Solution>,
}

/// Makes the enums of questions, answers and right answers of a table of kinds, and hands what is asked of them to the kind's
/// own type. A row has the type's name, its word in lessons and hand-ins, and the name of its right answer in JSON.
macro_rules! kinds {
    ($($name:ident, $word:literal, $solution:literal;)+) => {
        /// A kind of question, with all that it asks for.
        #[derive(Clone, Debug, PartialEq)]
        pub enum Kind {
            $(
                #[doc = concat!("A question of the kind `", $word, "`.")]
                $name($name),
            )+
        }

        /// An answer to a question.
        #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
        #[non_exhaustive]
        pub enum Answer {
            $(
                #[doc = concat!("An answer to a [`", stringify!($name), "`].")]
                #[serde(rename = $word)]
                $name(<$name as QuestionKind>::Answer),
            )+
        }

        /// The right answer to a question.
        #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
        #[non_exhaustive]
        pub enum Solution {
            $(
                #[doc = concat!("The right answer to a [`", stringify!($name), "`].")]
                #[serde(rename = $solution)]
                $name(<$name as QuestionKind>::Solution),
            )+
        }

        impl Kind {
            /// Reads the keys of a question.
            pub(super) fn read(keys: &Keys, reader: &mut KeyReader<'_, '_>) -> Option<Self> {
                match &**keys.kind.get_ref() {
                    $($word => $name::read(keys, reader).map(Self::$name),)+
                    _ => {
                        reader.wrong_word("kind", &keys.kind, &[$($word),+]);
                        None
                    }
                }
            }

            /// Returns the word for it in a lesson.
            pub fn name(&self) -> &'static str {
                match self {
                    $(Self::$name(_) => $word,)+
                }
            }

            /// Returns what is known of it without the type of its answer.
            pub fn asks(&self) -> &dyn AnyKind {
                match self {
                    $(Self::$name(kind) => kind,)+
                }
            }

            /// Returns the keys by which a wrong model is given.
            pub(super) fn model_keys(&self) -> &'static [&'static str] {
                match self {
                    $(Self::$name(_) => <$name as QuestionKind>::MODEL_KEYS,)+
                }
            }

            /// Finds the answer of a wrong model in a scene.
            pub(super) fn solve_wrong(
                &self,
                place: LabPlace<'_>,
                seed: u64,
            ) -> Result<Solution, String> {
                match self {
                    $(Self::$name(kind) => kind.solve_wrong(place, seed).map(Solution::$name),)+
                }
            }

            /// Finds the right answer in a scene.
            pub(super) fn solve(&self, place: LabPlace<'_>, seed: u64) -> Result<Solution, String> {
                match self {
                    $(Self::$name(kind) => kind.solve(place, seed).map(Solution::$name),)+
                }
            }

            /// Checks what is the matter with a question whose right answer is graded as right.
            pub(super) fn check(&self, right: &Solution, place: LabPlace<'_>) -> Result<(), String> {
                match (self, right) {
                    $((Self::$name(kind), Solution::$name(right)) => kind.check(right, place),)+
                    _ => Ok(()),
                }
            }

            /// Grades an answer; none of another kind of question.
            pub(super) fn grade(
                &self,
                given: &Answer,
                key: &AnswerKey,
                place: LabPlace<'_>,
            ) -> Option<Grade> {
                match (self, given, &key.right) {
                    $((Self::$name(kind), Answer::$name(given), Solution::$name(right)) => {
                        let wrong = key.wrong.iter().map(|wrong| match wrong {
                            Solution::$name(wrong) => Some(wrong),
                            _ => None,
                        });
                        let wrong: Vec<_> = wrong.collect::<Option<_>>()?;
                        kind.grade(given, right, &wrong, place)
                    })+
                    _ => None,
                }
            }

            /// Returns how many tolerances the answer of a wrong model is away from the right one.
            pub(super) fn separation(
                &self,
                wrong: &Solution,
                right: &Solution,
                place: LabPlace<'_>,
            ) -> Option<f64> {
                match (self, wrong, right) {
                    $((Self::$name(kind), Solution::$name(wrong), Solution::$name(right)) => {
                        let off = kind.off(&$name::right(wrong), right, place)?;
                        Some(off / kind.tolerance())
                    })+
                    _ => None,
                }
            }

            /// Returns an answer in the words of its question.
            pub fn words(&self, given: &Answer, options: &[String]) -> String {
                match (self, given) {
                    $((Self::$name(kind), Answer::$name(given)) => kind.words(given, options),)+
                    _ => short_answer(given),
                }
            }

            /// Returns the right answer in a few characters.
            pub fn short_solution(&self, right: &Solution) -> String {
                match (self, right) {
                    $((Self::$name(kind), Solution::$name(right)) => kind.short_solution(right),)+
                    _ => String::new(),
                }
            }

            /// Returns the right answer in words for print; none of a drawing.
            pub(super) fn solution_words(&self, right: &Solution, options: &[String]) -> String {
                match (self, right) {
                    $((Self::$name(kind), Solution::$name(right)) => {
                        kind.solution_words(right, options)
                    })+
                    _ => String::new(),
                }
            }

            /// Returns the HTML in which the student answers on a worksheet.
            pub(super) fn blank(
                &self,
                printed: &Printed<'_>,
                right: Option<&Solution>,
            ) -> Result<Html, String> {
                match self {
                    $(Self::$name(kind) => match right {
                        Some(Solution::$name(right)) => kind.blank(printed, Some(right)),
                        _ => kind.blank(printed, None),
                    },)+
                }
            }

            /// Returns the HTML of the right answer as a drawing, where that says more than words.
            pub(super) fn drawing(
                &self,
                right: &Solution,
                printed: &Printed<'_>,
            ) -> Result<Option<Html>, String> {
                match (self, right) {
                    $((Self::$name(kind), Solution::$name(right)) => kind.drawing(right, printed),)+
                    _ => Ok(None),
                }
            }

            /// Returns the HTML of the first answers of a class.
            pub(super) fn chart(&self, class: &Predictions<'_, Answer, Solution>) -> Html {
                match self {
                    $(Self::$name(kind) => kind.chart(&class.of_kind(
                        |given| match given {
                            Answer::$name(given) => Some(given),
                            _ => None,
                        },
                        |right| match right {
                            Solution::$name(right) => Some(right),
                            _ => None,
                        },
                    )),)+
                }
            }
        }

        impl Answer {
            /// Returns the right answer as a student would give it.
            pub fn right(right: &Solution) -> Self {
                match right {
                    $(Solution::$name(right) => Self::$name($name::right(right)),)+
                }
            }

            /// Returns whether it is an answer to a question of this kind that can be graded: its numbers are finite, its
            /// indices exist.
            pub fn fits(&self, kind: &Kind) -> bool {
                match (kind, self) {
                    $((Kind::$name(kind), Self::$name(given)) => kind.fits(given),)+
                    _ => false,
                }
            }

            /// Returns the number that it is.
            pub(super) fn number(&self) -> Option<f64> {
                match self {
                    $(Self::$name(given) => $name::number(given),)+
                }
            }
        }

        /// Returns an answer in a few characters.
        pub fn short_answer(answer: &Answer) -> String {
            match answer {
                $(Answer::$name(given) => $name::short(given),)+
            }
        }
    };
}

kinds! {
    Choice, "choice", "Choice";
    Value, "value", "Value";
    Point, "point", "Places";
    Curve, "curve", "Curve";
    Settings, "settings", "Setting";
    Order, "order", "Order";
    Match, "match", "Match";
    Formula, "formula", "Formula";
}
