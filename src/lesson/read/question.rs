//! A step's question, of any kind.

use super::{Block, Reader};
use crate::expression::Expression;
use crate::lesson::question::{
    ChoiceOption, CurveOf, Extreme, Find, Goal, Item, Kind, MatchValues, Question, RightIf, Term,
};
use crate::lesson::solve::slider;
use crate::scene::parameter::Parameter;
use crate::scene::{Choice, ShadingMode, nearest};
use crate::text::{excerpt, text};
use serde::Deserialize;
use toml::Spanned;

const KINDS: [&str; 7] = [
    "choice", "value", "point", "curve", "settings", "order", "match",
];
const FINDS: [&str; 6] = [
    "brightest",
    "darkest",
    "greatest",
    "least",
    "zero",
    "corner",
];
/// How near a click counts, unless the lesson says so.
const NEAR: f64 = 0.05;

type Text = Option<Spanned<String>>;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawQuestion {
    kind: Spanned<String>,
    ask: Text,
    why: Text,
    term: Option<Term>,
    #[serde(default)]
    set: Vec<String>,
    #[serde(default)]
    option: Vec<RawOption>,
    #[serde(default)]
    item: Vec<RawItem>,
    by: Text,
    answer: Text,
    tolerance: Option<f64>,
    from: Option<f64>,
    to: Option<f64>,
    #[serde(default)]
    unit: String,
    find: Text,
    of: Text,
    mode: Text,
    x: Option<[f64; 2]>,
    y: Option<[f64; 2]>,
    x_name: Text,
    y_name: Text,
    profile: Text,
    control: Text,
    reach: Text,
    equals: Text,
    /// True for settings, an expression for a choice.
    greatest: Option<Spanned<Most>>,
    most: Option<bool>,
    least: Option<Spanned<Most>>,
    #[serde(default)]
    controls: Vec<String>,
}

#[derive(Deserialize)]
#[serde(untagged)]
enum Most {
    Of(String),
    Own(bool),
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawOption {
    text: Spanned<String>,
    holds: Text,
    right: Option<bool>,
    #[serde(default)]
    set: Vec<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawItem {
    text: Spanned<String>,
    #[serde(default)]
    set: Vec<String>,
}

impl Reader<'_> {
    pub(super) fn question(&mut self, block: &Block<'_>) -> Option<Question> {
        let mut raw: RawQuestion = self.toml(block)?;
        let kind = self.kind(block, &mut raw);
        let ask = self.prose(block, raw.ask.as_ref());
        if ask.is_empty() {
            self.missing(block.at, "ask");
        }
        Some(Question {
            kind: kind?,
            ask,
            why: self.prose(block, raw.why.as_ref()),
            term: raw.term,
            set: raw.set,
            line: self.line(block.at),
        })
    }

    fn mode(
        &mut self,
        block: &Block<'_>,
        key: &str,
        word: &Spanned<String>,
    ) -> Option<ShadingMode> {
        let mode = ShadingMode::from_word(word.get_ref());
        if mode.is_none() {
            let words: Vec<_> = ShadingMode::OPTIONS.iter().map(|mode| mode.word).collect();
            let words = text!("expected-one-of", words = words.join(", "));
            let at = block.at + word.span().start;
            self.wrong(at, text!("lesson-key", key = key, words = words));
        }
        mode
    }

    /// A key of the scene that has a slider.
    fn slides(&mut self, at: usize, key: &str) -> bool {
        let known = slider(key).is_some();
        if !known {
            let near = nearest(key, Parameter::all().map(|parameter| parameter.key));
            let words = text!(
                "lesson-no-slider",
                name = excerpt(key),
                near = near.unwrap_or("material.n")
            );
            self.wrong(at, words);
        }
        known
    }

    fn kind(&mut self, block: &Block<'_>, raw: &mut RawQuestion) -> Option<Kind> {
        let kind = raw.kind.get_ref().clone();
        match &*kind {
            "choice" => self.choice(block, raw),
            "value" => self.value(block, raw),
            "point" => self.point(block, raw),
            "curve" => self.curve(block, raw),
            "settings" => self.settings(block, raw),
            "order" => self.order(block, raw),
            "match" => self.matched(block, raw),
            _ => {
                let words = text!("expected-one-of", words = KINDS.join(", "));
                let at = block.at + raw.kind.span().start;
                self.wrong(at, text!("lesson-key", key = "kind", words = words));
                None
            }
        }
    }

    fn choice(&mut self, block: &Block<'_>, raw: &mut RawQuestion) -> Option<Kind> {
        if !(2..=8).contains(&raw.option.len()) {
            let words = text!("lesson-options", least = 2, most = 8);
            self.wrong(block.at, words);
            return None;
        }
        let by = self.extreme(block, raw);
        let mut options = Vec::new();
        for option in std::mem::take(&mut raw.option) {
            let at = block.at + option.text.span().start;
            let right = match (&option.holds, option.right) {
                (Some(_), Some(_)) => {
                    self.wrong(at, text!("lesson-option-both"));
                    None
                }
                (Some(holds), None) => self
                    .expression(block, "holds", Some(holds))
                    .map(RightIf::Holds),
                (None, said) => said.map(RightIf::Said),
            };
            options.push(ChoiceOption {
                text: self.prose(block, Some(&option.text)),
                right,
                set: option.set,
            });
        }
        let decided = options.iter().any(|option| option.right.is_some());
        if decided == by.is_some() {
            self.wrong(block.at, text!("lesson-option-neither"));
            return None;
        }
        Some(Kind::Choice { options, by })
    }

    /// What `greatest` or `least` says of a choice.
    fn extreme(&mut self, block: &Block<'_>, raw: &RawQuestion) -> Option<(Extreme, Expression)> {
        let pairs = [
            (Extreme::Greatest, "greatest", &raw.greatest),
            (Extreme::Least, "least", &raw.least),
        ];
        for (extreme, key, value) in pairs {
            if let Some(value) = value
                && let Most::Of(text) = value.get_ref()
            {
                let at = block.at + value.span().start;
                return self
                    .expression_at(at, key, text)
                    .map(|expression| (extreme, expression));
            }
        }
        None
    }

    fn value(&mut self, block: &Block<'_>, raw: &RawQuestion) -> Option<Kind> {
        let answer = self.expression(block, "answer", raw.answer.as_ref());
        let tolerance = self.positive(block, "tolerance", raw.tolerance);
        let range = raw.from.zip(raw.to).map(|(from, to)| [from, to]);
        let range = self.range(block, "from", range);
        let (tolerance, [from, to]) = (tolerance?, range?);
        Some(Kind::Value {
            answer: answer?,
            tolerance,
            from,
            to,
            unit: raw.unit.clone(),
        })
    }

    fn point(&mut self, block: &Block<'_>, raw: &RawQuestion) -> Option<Kind> {
        let Some(find) = &raw.find else {
            self.missing(block.at, "find");
            return None;
        };
        let tolerance = self.positive(block, "tolerance", raw.tolerance.or(Some(NEAR)))?;
        let mut of = || self.expression(block, "of", raw.of.as_ref());
        let found = match &**find.get_ref() {
            "brightest" => Find::Brightest,
            "darkest" => Find::Darkest,
            "greatest" => Find::Extreme(Extreme::Greatest, of()?),
            "least" => Find::Extreme(Extreme::Least, of()?),
            "zero" => Find::Zero(of()?),
            "corner" => match &raw.mode {
                Some(mode) => Find::Corner(self.mode(block, "mode", mode)?),
                None => Find::Corner(ShadingMode::Gouraud),
            },
            _ => {
                let words = text!("expected-one-of", words = FINDS.join(", "));
                let at = block.at + find.span().start;
                self.wrong(at, text!("lesson-key", key = "find", words = words));
                return None;
            }
        };
        Some(Kind::Point {
            find: found,
            tolerance,
        })
    }

    fn curve(&mut self, block: &Block<'_>, raw: &RawQuestion) -> Option<Kind> {
        let of = match (&raw.profile, &raw.answer) {
            (Some(mode), None) => CurveOf::Profile(self.mode(block, "profile", mode)?),
            (None, Some(answer)) => {
                CurveOf::Expression(self.expression(block, "answer", Some(answer))?)
            }
            _ => {
                self.wrong(block.at, text!("lesson-curve-of"));
                return None;
            }
        };
        let own = matches!(of, CurveOf::Profile(_)).then_some([0.0, 1.0]);
        let x = self.range(block, "x", raw.x.or(own));
        let y = self.range(block, "y", raw.y.or(own));
        let tolerance = self.positive(block, "tolerance", raw.tolerance.or(Some(0.1)));
        let (x, y) = (x?, y?);
        Some(Kind::Curve {
            x,
            y,
            x_name: self.prose(block, raw.x_name.as_ref()),
            y_name: self.prose(block, raw.y_name.as_ref()),
            of,
            tolerance: tolerance?,
        })
    }

    fn settings(&mut self, block: &Block<'_>, raw: &RawQuestion) -> Option<Kind> {
        let Some(control) = &raw.control else {
            self.missing(block.at, "control");
            return None;
        };
        let known = self.slides(block.at + control.span().start, control.get_ref());
        let reach = self.expression(block, "reach", raw.reach.as_ref());
        let tolerance = self.positive(block, "tolerance", raw.tolerance);
        let own = |most: &Option<Spanned<Most>>| {
            most.as_ref()
                .is_some_and(|most| matches!(most.get_ref(), Most::Own(true)))
        };
        let goals = [
            (raw.most == Some(true) || own(&raw.greatest)).then_some(Extreme::Greatest),
            own(&raw.least).then_some(Extreme::Least),
        ];
        let goal = match (&raw.equals, goals) {
            (Some(equals), [None, None]) => {
                Goal::Equals(self.expression(block, "equals", Some(equals))?)
            }
            (None, [Some(extreme), None] | [None, Some(extreme)]) => Goal::Extreme(extreme),
            _ => {
                self.wrong(block.at, text!("lesson-goal"));
                return None;
            }
        };
        known.then_some(())?;
        Some(Kind::Settings {
            control: control.get_ref().clone(),
            reach: reach?,
            goal,
            tolerance: tolerance?,
        })
    }

    fn order(&mut self, block: &Block<'_>, raw: &mut RawQuestion) -> Option<Kind> {
        let by = self.expression(block, "by", raw.by.as_ref());
        if !(3..=6).contains(&raw.item.len()) {
            let words = text!("lesson-items", least = 3, most = 6);
            self.wrong(block.at, words);
            return None;
        }
        let mut items = Vec::new();
        for item in std::mem::take(&mut raw.item) {
            items.push(Item {
                text: self.prose(block, Some(&item.text)),
                set: item.set,
            });
        }
        Some(Kind::Order { items, by: by? })
    }

    fn matched(&mut self, block: &Block<'_>, raw: &RawQuestion) -> Option<Kind> {
        if !(1..=8).contains(&raw.controls.len()) {
            self.missing(block.at, "controls");
            return None;
        }
        let mut known = true;
        for control in &raw.controls {
            known &= self.slides(block.at, control);
        }
        let tolerance = self.positive(block, "tolerance", raw.tolerance.or(Some(0.01)));
        known.then_some(())?;
        Some(Kind::Match {
            controls: raw.controls.clone(),
            values: if raw.set.is_empty() {
                MatchValues::Random
            } else {
                MatchValues::Given
            },
            tolerance: tolerance?,
        })
    }
}
