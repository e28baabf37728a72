//! A lesson's file, read with the line of everything that is wrong.

use super::question::{
    ChoiceOption, CurveOf, Extreme, Find, Goal, Item, Kind, MatchValues, Question, RightIf, Term,
};
use super::stage::{OVERLAYS, Stage, view};
use super::{Lesson, LessonError, LessonProblem, Prose, Step};
use crate::expression::Expression;
use crate::scene::parameter::Parameter;
use crate::scene::{Choice, ShadingMode};
use crate::text::text;
use glam::DVec2;
use pulldown_cmark::{CodeBlockKind, Event, HeadingLevel, Options, Parser, Tag, TagEnd};
use serde::Deserialize;
use serde::de::DeserializeOwned;
use std::path::Path;
use toml::Spanned;

/// The version of the format.
const VERSION: u32 = 1;
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

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Head {
    lesson: Spanned<u32>,
    name: Spanned<String>,
    title: String,
    #[serde(default)]
    topic: String,
    #[serde(default)]
    minutes: u32,
    #[serde(default)]
    about: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawStage {
    scene: Option<String>,
    #[serde(default)]
    set: Vec<String>,
    lights: Option<usize>,
    panes: Option<Vec<String>>,
    view: Option<Spanned<String>>,
    probe: Option<[f64; 2]>,
    line: Option<[f64; 4]>,
    overlays: Option<Spanned<Vec<String>>>,
    controls: Option<Vec<String>>,
    #[serde(default)]
    hide: bool,
}

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

impl Lesson {
    /// Reads a lesson; `folder` is where the files lie that it names.
    ///
    /// # Errors
    /// Everything that is wrong with its form, each with its line. What the engine finds wrong, [`super::check`] says.
    pub fn read(source: &str, folder: Option<&Path>) -> Result<Self, LessonError> {
        if source.len() > Self::MAX_TEXT {
            let words = text!("lesson-too-long", most = Self::MAX_TEXT >> 20);
            return Err(LessonError::one(1, words));
        }
        let mut reader = Reader {
            source,
            problems: Vec::new(),
        };
        let lesson = reader.lesson(folder);
        match lesson {
            Some(lesson) if reader.problems.is_empty() => Ok(lesson),
            _ => Err(LessonError {
                problems: reader.problems,
            }),
        }
    }
}

/// A block of TOML and the offset where it begins.
struct Block<'s> {
    text: &'s str,
    at: usize,
}

struct Reader<'s> {
    source: &'s str,
    problems: Vec<LessonProblem>,
}

/// What stands between a heading and the next one.
struct RawStep<'s> {
    title: String,
    at: usize,
    /// The pieces of text about the blocks.
    pieces: Vec<(usize, usize)>,
    stage: Option<Block<'s>>,
    question: Option<Block<'s>>,
}

impl<'s> Reader<'s> {
    fn line(&self, offset: usize) -> u64 {
        let before = self.source.as_bytes().get(..offset).unwrap_or_default();
        1 + before.iter().filter(|byte| **byte == b'\n').count() as u64
    }

    fn wrong(&mut self, offset: usize, words: impl Into<String>) {
        let line = self.line(offset);
        self.wrong_at(line, words);
    }

    fn wrong_at(&mut self, line: u64, words: impl Into<String>) {
        let words = words.into();
        self.problems.push(LessonProblem { line, words });
    }

    fn toml<T: DeserializeOwned>(&mut self, block: &Block<'_>) -> Option<T> {
        // Of the end of a line with a carriage return, TOML takes both or none.
        match toml::from_str(block.text.trim_end_matches('\r')) {
            Ok(read) => Some(read),
            Err(error) => {
                let at = error.span().map_or(0, |span| span.start);
                self.wrong(
                    block.at + at,
                    text!("problem-toml", message = error.message()),
                );
                None
            }
        }
    }

    fn lesson(&mut self, folder: Option<&Path>) -> Option<Lesson> {
        let (block, body) = self.head()?;
        let head: Head = self.toml(&block)?;
        if *head.lesson.get_ref() != VERSION {
            let at = block.at + head.lesson.span().start;
            self.wrong(at, text!("lesson-version", version = VERSION));
        }
        let name = head.name.get_ref();
        let sound = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
        if name.is_empty() || name.len() > 64 || !name.chars().all(sound) {
            self.wrong(block.at + head.name.span().start, text!("lesson-name"));
        }
        let steps = self.split(body);
        if steps.is_empty() {
            self.wrong(body, text!("lesson-no-steps"));
        }
        if steps.len() > Lesson::MAX_STEPS {
            let words = text!("lesson-many-steps", most = Lesson::MAX_STEPS);
            self.wrong(body, words);
            return None;
        }
        let mut before = Stage::default();
        let mut read = Vec::new();
        for step in steps {
            let step = self.step(step, &before);
            before.clone_from(&step.stage);
            read.push(step);
        }
        Some(Lesson {
            name: head.name.into_inner(),
            title: head.title,
            topic: head.topic,
            minutes: if head.minutes == 0 { 10 } else { head.minutes },
            about: head.about,
            steps: read,
            folder: folder.map(Path::to_owned),
            source: self.source.to_owned(),
        })
    }

    /// The TOML between two lines `+++`, and where what follows begins.
    fn head(&mut self) -> Option<(Block<'s>, usize)> {
        let source = self.source;
        let start = source.len() - source.trim_start_matches('\u{feff}').trim_start().len();
        let Some(rest) = source[start..].strip_prefix("+++") else {
            self.wrong(start, text!("lesson-no-head"));
            return None;
        };
        let at = source.len() - rest.len();
        let Some(end) = rest.find("\n+++") else {
            self.wrong(start, text!("lesson-no-head"));
            return None;
        };
        Some((
            Block {
                text: &rest[..end],
                at,
            },
            at + end + "\n+++".len(),
        ))
    }

    /// The steps, by the headings of the second level.
    fn split(&mut self, body: usize) -> Vec<RawStep<'s>> {
        let source = self.source;
        let mut steps: Vec<RawStep<'s>> = Vec::new();
        let mut heading: Option<usize> = None;
        let mut title = String::new();
        let parser = Parser::new_ext(&source[body..], Options::ENABLE_TABLES).into_offset_iter();
        let mut depth = 0usize;
        let mut fence: Option<(String, usize, Option<usize>, usize)> = None;
        for (event, span) in parser {
            let (start, end) = (body + span.start, body + span.end);
            match event {
                Event::Start(Tag::Heading {
                    level: HeadingLevel::H2,
                    ..
                }) if depth == 0 => {
                    if let Some(step) = steps.last_mut()
                        && let Some(piece) = step.pieces.last_mut()
                    {
                        piece.1 = start;
                    }
                    heading = Some(start);
                    title.clear();
                }
                Event::End(TagEnd::Heading(HeadingLevel::H2)) => {
                    if let Some(at) = heading.take() {
                        steps.push(RawStep {
                            title: std::mem::take(&mut title),
                            at,
                            pieces: vec![(end, source.len())],
                            stage: None,
                            question: None,
                        });
                    }
                }
                Event::Text(text) | Event::Code(text) if heading.is_some() => title.push_str(&text),
                Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(info))) if depth == 0 => {
                    fence = Some((info.trim().to_owned(), start, None, start));
                    depth += 1;
                }
                Event::Text(text) if fence.is_some() => {
                    if let Some((_, _, first, last)) = &mut fence {
                        first.get_or_insert(start);
                        *last = start + text.len();
                    }
                }
                Event::End(TagEnd::CodeBlock) if fence.is_some() => {
                    depth -= 1;
                    if let Some((info, at, first, last)) = fence.take() {
                        self.block(
                            &mut steps,
                            &info,
                            (at, end),
                            first.map(|first| (first, last)),
                        );
                    }
                }
                Event::Start(_) => depth += 1,
                Event::End(_) => depth = depth.saturating_sub(1),
                _ => {}
            }
        }
        steps
    }

    /// Takes a fenced block of the last step.
    fn block(
        &mut self,
        steps: &mut [RawStep<'s>],
        info: &str,
        (start, end): (usize, usize),
        inside: Option<(usize, usize)>,
    ) {
        if info != "step" && info != "question" {
            return;
        }
        let (from, to) = inside.unwrap_or((end, end));
        let to = to.min(self.source.len());
        let block = Block {
            text: self.source.get(from..to).unwrap_or_default(),
            at: from,
        };
        let Some(step) = steps.last_mut() else {
            self.wrong(start, text!("lesson-block-outside"));
            return;
        };
        if let Some(piece) = step.pieces.last_mut() {
            piece.1 = start;
        }
        step.pieces.push((end, self.source.len()));
        let place = match info {
            "step" => &mut step.stage,
            _ => &mut step.question,
        };
        if place.replace(block).is_some() {
            self.wrong(start, text!("lesson-block-twice", name = info));
        }
    }

    fn step(&mut self, raw: RawStep<'s>, before: &Stage) -> Step {
        let mut prose = Prose::default();
        let pieces: Vec<&str> = raw
            .pieces
            .iter()
            .map(|&(from, to)| self.source.get(from..to).unwrap_or_default())
            .collect();
        // Lines are counted as they stand in the file: blocks are left out, not their lines.
        let mut text = String::new();
        let mut at = raw.pieces.first().map_or(raw.at, |piece| piece.0);
        let first = self.line(at);
        for (piece, &(from, to)) in pieces.iter().zip(&raw.pieces) {
            let skipped = self.line(from).saturating_sub(self.line(at));
            text.extend(std::iter::repeat_n('\n', skipped as usize));
            text.push_str(piece);
            at = to;
        }
        match Prose::read(&text, first) {
            Ok(read) => prose = read,
            Err((line, words)) => self.wrong_at(line, words),
        }
        let line = self.line(raw.at);
        let mut stage = Stage {
            hide: false,
            line_number: line,
            ..before.clone()
        };
        if let Some(block) = &raw.stage {
            self.stage(block, &mut stage);
        }
        if stage.scene.is_empty() {
            self.wrong(raw.at, text!("lesson-no-scene"));
        }
        let question = raw.question.as_ref().and_then(|block| self.question(block));
        Step {
            title: raw.title,
            text: prose,
            stage,
            question,
            line,
        }
    }

    fn stage(&mut self, block: &Block<'_>, stage: &mut Stage) {
        let Some(raw) = self.toml::<RawStage>(block) else {
            return;
        };
        stage.line_number = self.line(block.at);
        if let Some(scene) = raw.scene {
            *stage = Stage {
                scene,
                line_number: stage.line_number,
                ..Stage::default()
            };
        }
        stage.set.extend(raw.set);
        stage.lights = raw.lights.or(stage.lights);
        stage.panes = raw.panes.or(stage.panes.take());
        stage.hide = raw.hide;
        stage.probe = raw.probe.map(DVec2::from_array).or(stage.probe);
        let line = |[a, b, c, d]: [f64; 4]| [DVec2::new(a, b), DVec2::new(c, d)];
        stage.line = raw.line.map(line).or(stage.line);
        stage.controls = raw.controls.unwrap_or(std::mem::take(&mut stage.controls));
        if let Some(name) = raw.view {
            stage.view = view(name.get_ref());
            if stage.view.is_none() {
                let words = text!("expected-one-of", words = crate::link::VIEWS.join(", "));
                let words = text!("lesson-key", key = "view", words = words);
                self.wrong(block.at + name.span().start, words);
            }
        }
        if let Some(overlays) = raw.overlays {
            let at = block.at + overlays.span().start;
            stage.overlays.clear();
            for name in overlays.into_inner() {
                match OVERLAYS.into_iter().find(|overlay| *overlay == name) {
                    Some(overlay) => stage.overlays.push(overlay),
                    None => {
                        let words = text!("expected-one-of", words = OVERLAYS.join(", "));
                        self.wrong(at, text!("lesson-key", key = "overlays", words = words));
                    }
                }
            }
        }
        if let Err(words) = stage.check() {
            self.wrong(block.at, words);
        }
    }

    fn question(&mut self, block: &Block<'_>) -> Option<Question> {
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

    fn missing(&mut self, at: usize, key: &str) {
        self.wrong(at, text!("lesson-missing", key = key));
    }

    fn prose(&mut self, block: &Block<'_>, text: Option<&Spanned<String>>) -> Prose {
        let Some(text) = text else {
            return Prose::default();
        };
        let line = self.line(block.at + text.span().start);
        match Prose::read(text.get_ref(), line) {
            Ok(prose) => prose,
            Err((line, words)) => {
                self.wrong_at(line, words);
                Prose::default()
            }
        }
    }

    fn expression(
        &mut self,
        block: &Block<'_>,
        key: &str,
        text: Option<&Spanned<String>>,
    ) -> Option<Expression> {
        let Some(text) = text else {
            self.missing(block.at, key);
            return None;
        };
        self.expression_at(block.at + text.span().start, key, text.get_ref())
    }

    fn expression_at(&mut self, at: usize, key: &str, text: &str) -> Option<Expression> {
        match Expression::read(text) {
            Ok(expression) => Some(expression),
            Err(words) => {
                self.wrong(at, text!("lesson-key", key = key, words = words));
                None
            }
        }
    }

    /// A number that is finite and above 0.
    fn positive(&mut self, block: &Block<'_>, key: &str, value: Option<f64>) -> Option<f64> {
        match value {
            Some(value) if value > 0.0 && value.is_finite() => Some(value),
            Some(_) => {
                let words = text!("lesson-positive");
                self.wrong(block.at, text!("lesson-key", key = key, words = words));
                None
            }
            None => {
                self.missing(block.at, key);
                None
            }
        }
    }

    fn range(&mut self, block: &Block<'_>, key: &str, value: Option<[f64; 2]>) -> Option<[f64; 2]> {
        match value {
            Some([from, to]) if from < to && (to - from).is_finite() => Some([from, to]),
            Some(_) => {
                let words = text!("lesson-range");
                self.wrong(block.at, text!("lesson-key", key = key, words = words));
                None
            }
            None => {
                self.missing(block.at, key);
                None
            }
        }
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
        let known = super::solve::slider(key).is_some();
        if !known {
            let near = crate::scene::nearest(key, Parameter::all().map(|parameter| parameter.key));
            let words = text!(
                "lesson-no-slider",
                name = key,
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
