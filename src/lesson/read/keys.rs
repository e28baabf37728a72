//! The keys of a question's block, and how each sort of them is read. A key means the same in every kind that has it.

use super::reader::Reader;
use crate::expression::Expression;
use crate::figure::Axis;
use crate::lesson::Prose;
use crate::lesson::control::slider;
use crate::scene::parameter::Parameter;
use crate::scene::{Choice, ShadingMode, nearest};
use crate::text::{excerpt, text};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use toml::Spanned;

type Text = Option<Spanned<String>>;

/// The keys of a question's block, of all kinds.
#[derive(Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Keys {
    pub kind: Spanned<String>,
    pub ask: Text,
    pub why: Text,
    pub term: Option<Term>,
    #[serde(default)]
    pub set: Vec<String>,
    #[serde(default)]
    pub option: Vec<OptionKeys>,
    #[serde(default)]
    pub item: Vec<ItemKeys>,
    pub by: Text,
    pub answer: Text,
    #[serde(default)]
    pub names: Vec<NameKeys>,
    pub tolerance: Option<f64>,
    pub from: Option<f64>,
    pub to: Option<f64>,
    #[serde(default)]
    pub unit: String,
    pub find: Text,
    pub of: Text,
    pub mode: Text,
    pub x: Option<[f64; 2]>,
    pub y: Option<[f64; 2]>,
    pub x_name: Text,
    pub y_name: Text,
    pub profile: Text,
    pub control: Text,
    pub reach: Text,
    pub equals: Text,
    /// True for settings, an expression for a choice.
    pub greatest: Option<Spanned<Most>>,
    pub most: Option<bool>,
    pub least: Option<Spanned<Most>>,
    #[serde(default)]
    pub controls: Vec<String>,
    #[serde(default)]
    pub wrong: Vec<WrongKeys>,
    /// A place, of a wrong model only: the right one is never in the file.
    #[serde(skip)]
    pub at: Option<Spanned<[f64; 2]>>,
    /// They are those of a wrong model.
    #[serde(skip)]
    pub is_wrong: bool,
}

/// The keys of a `[[wrong]]`.
#[derive(Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WrongKeys {
    pub says: Spanned<String>,
    #[serde(default)]
    pub set: Vec<String>,
    pub answer: Text,
    pub formula: Text,
    pub profile: Text,
    pub find: Text,
    pub of: Text,
    pub mode: Text,
    pub at: Option<Spanned<[f64; 2]>>,
    pub by: Text,
    pub equals: Text,
    pub most: Option<bool>,
    pub least: Option<bool>,
}

impl WrongKeys {
    /// Returns the names of the keys that it has, besides what it says.
    fn names(&self) -> impl Iterator<Item = &'static str> {
        [
            ("set", !self.set.is_empty()),
            ("answer", self.answer.is_some()),
            ("formula", self.formula.is_some()),
            ("profile", self.profile.is_some()),
            ("find", self.find.is_some()),
            ("of", self.of.is_some()),
            ("mode", self.mode.is_some()),
            ("at", self.at.is_some()),
            ("by", self.by.is_some()),
            ("equals", self.equals.is_some()),
            ("most", self.most.is_some()),
            ("least", self.least.is_some()),
        ]
        .into_iter()
        .filter_map(|(name, given)| given.then_some(name))
    }
}

impl Keys {
    /// Returns the keys of the same question with another answer: those of a wrong model go before its own.
    pub fn of_wrong(&self, wrong: &WrongKeys) -> Self {
        let mut keys = self.clone();
        (keys.is_wrong, keys.wrong) = (true, Vec::new());
        (keys.x_name, keys.y_name) = (None, None);
        let given: Vec<&str> = wrong.names().collect();
        // Of the keys that say the same thing in another way, one counts.
        for ways in [
            &["answer", "profile"][..],
            &["answer", "equals", "most", "least"],
        ] {
            if ways.iter().any(|way| given.contains(way)) {
                (keys.answer, keys.profile, keys.equals) = (None, None, None);
                (keys.greatest, keys.most, keys.least) = (None, None, None);
            }
        }
        let or = |new: &Text, old: &mut Text| {
            if new.is_some() {
                old.clone_from(new);
            }
        };
        or(&wrong.answer, &mut keys.answer);
        or(&wrong.formula, &mut keys.answer);
        or(&wrong.profile, &mut keys.profile);
        or(&wrong.find, &mut keys.find);
        or(&wrong.of, &mut keys.of);
        or(&wrong.mode, &mut keys.mode);
        or(&wrong.by, &mut keys.by);
        or(&wrong.equals, &mut keys.equals);
        keys.at.clone_from(&wrong.at);
        keys.most = wrong.most.or(keys.most);
        keys.least = wrong
            .least
            .map(|least| Spanned::new(wrong.says.span(), Most::Own(least)))
            .or(keys.least);
        keys.set.extend(wrong.set.iter().cloned());
        keys
    }
}

/// The value of `greatest` or `least`.
#[derive(Clone, Deserialize)]
#[serde(untagged)]
pub enum Most {
    Of(String),
    Own(bool),
}

/// A name that a formula may use: one that everybody knows, or one with its range.
#[derive(Clone, Deserialize)]
#[serde(untagged)]
pub enum NameKeys {
    Known(String),
    Between(BTreeMap<String, [f64; 2]>),
}

/// The keys of an `[[option]]`.
#[derive(Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct OptionKeys {
    pub text: Spanned<String>,
    pub holds: Text,
    pub right: Option<bool>,
    pub says: Text,
    #[serde(default)]
    pub set: Vec<String>,
}

/// The keys of an `[[item]]`.
#[derive(Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ItemKeys {
    pub text: Spanned<String>,
    #[serde(default)]
    pub set: Vec<String>,
}

/// The part of the equation that a question is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Term {
    /// The ambient term.
    Ambient,
    /// The diffuse term.
    Diffuse,
    /// The specular term.
    Specular,
    /// The factor f.
    Attenuation,
    /// The light that comes through the surface.
    Transmission,
    /// The sum over the lights.
    Lights,
}

/// The reader of the keys of one block. Each method notes what is wrong, and returns nothing then.
pub struct KeyReader<'r, 's> {
    pub lesson: &'r mut Reader<'s>,
    /// The offset of the block.
    pub at: usize,
    /// The offset of what is read: of the block, or of one of its wrong models.
    pub whole: usize,
}

impl KeyReader<'_, '_> {
    /// Notes a problem with the question, or one of its wrong models, as a whole.
    pub fn wrong(&mut self, words: impl Into<String>) {
        self.lesson.wrong(self.whole, words);
    }

    /// Notes a problem with the value of a key.
    pub fn wrong_value<T>(&mut self, key: &str, value: &Spanned<T>, words: &str) {
        let at = self.at + value.span().start;
        self.lesson
            .wrong(at, text!("lesson-key", key = key, words = words));
    }

    /// Notes that the value of a key is none of these words.
    pub fn wrong_word(&mut self, key: &str, value: &Spanned<String>, words: &[&str]) {
        let words = text!("expected-one-of", words = words.join(", "));
        self.wrong_value(key, value, &words);
    }

    /// Notes that a key is missing.
    pub fn missing(&mut self, key: &str) {
        self.wrong(text!("lesson-missing", key = key));
    }

    /// Reads a text, which may be missing.
    pub fn prose(&mut self, text: Option<&Spanned<String>>) -> Prose {
        let Some(text) = text else {
            return Prose::default();
        };
        let line = self.lesson.line(self.at + text.span().start);
        Prose::read(text.get_ref(), line).unwrap_or_else(|problem| {
            self.lesson.problems.push(problem);
            Prose::default()
        })
    }

    /// Reads an expression.
    pub fn expression(&mut self, key: &str, text: &Text) -> Option<Expression> {
        match text {
            Some(text) => self.expression_of(key, text, text.get_ref()),
            None => {
                self.missing(key);
                None
            }
        }
    }

    /// Reads the expression in the value of a key.
    pub fn expression_of<T>(
        &mut self,
        key: &str,
        value: &Spanned<T>,
        text: &str,
    ) -> Option<Expression> {
        let read = Expression::read(text);
        read.map_err(|words| self.wrong_value(key, value, &words))
            .ok()
    }

    /// Reads a number that is finite and above 0.
    pub fn positive(&mut self, key: &str, value: Option<f64>) -> Option<f64> {
        let sound = |value: &f64| *value > 0.0 && value.is_finite();
        self.sound(key, value, sound, text!("lesson-positive"))
    }

    /// Reads the ends of a range that an axis can have.
    pub fn range(&mut self, key: &str, value: Option<[f64; 2]>) -> Option<[f64; 2]> {
        let sound = |[from, to]: &[f64; 2]| Axis::can_span(*from, *to);
        self.sound(key, value, sound, text!("lesson-range"))
    }

    fn sound<T>(
        &mut self,
        key: &str,
        value: Option<T>,
        is_sound: impl Fn(&T) -> bool,
        words: &str,
    ) -> Option<T> {
        match &value {
            Some(value) if is_sound(value) => {}
            Some(_) => self.wrong(text!("lesson-key", key = key, words = words)),
            None => self.missing(key),
        }
        value.filter(is_sound)
    }

    /// Checks that a wrong model has keys, and only those by which one of this kind is given.
    pub fn wrong_has(&mut self, wrong: &WrongKeys, known: &[&str]) -> bool {
        let sound = |name: &str| name == "set" || known.contains(&name);
        let given: Vec<_> = wrong.names().collect();
        let fits = !given.is_empty() && given.into_iter().all(sound);
        if !fits {
            let mut words = known.to_vec();
            words.extend((!known.contains(&"set")).then_some("set"));
            self.wrong(text!("lesson-wrong-keys", words = words.join(", ")));
        }
        fits
    }

    /// Reads a shading mode.
    pub fn mode(&mut self, key: &str, word: &Spanned<String>) -> Option<ShadingMode> {
        let mode = ShadingMode::from_word(word.get_ref());
        if mode.is_none() {
            let words: Vec<_> = ShadingMode::OPTIONS.iter().map(|mode| mode.word).collect();
            self.wrong_word(key, word, &words);
        }
        mode
    }

    /// Returns whether a key of the scene has a slider; `at` is its offset.
    pub fn slides(&mut self, at: usize, key: &str) -> bool {
        let known = slider(key).is_some();
        if !known {
            let sliding = Parameter::all().filter(|parameter| parameter.slider().is_some());
            let near = nearest(key, sliding.map(|parameter| parameter.key));
            let words = text!(
                "lesson-no-slider",
                name = excerpt(key),
                near = near.unwrap_or("material.n")
            );
            self.lesson.wrong(at, words);
        }
        known
    }
}
