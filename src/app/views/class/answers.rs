//! The answers to a question, the round before beside the present one.

use super::charts::{Colours, Range, clicks, curves, highest, numbers};
use super::layer::Layer;
use crate::app::course::prose_ui;
use crate::app::engine::image_of;
use crate::app::widgets::drawing::{drawing_ui, plot_style, rgb};
use crate::app::widgets::focus::named;
use crate::app::widgets::meter::meter_ui;
use crate::app::widgets::palette::{right_colour, vector_text};
use crate::app::widgets::tile;
use crate::class::{Round, Spread};
use crate::figure::palette::Vector;
use crate::figure::{Drawing, PlotStyle};
use crate::lesson::{
    Answer, ClassQuestion, Kind, Question, Solution, control_name, counted, for_fingers, letter,
    short_answer, slider,
};
use crate::text::text;
use eframe::egui::accesskit::Role;
use eframe::egui::{RichText, Sense, Shape, TextureHandle, TextureOptions, Ui, vec2};
use egui_commonmark::CommonMarkCache;
use glam::DVec2;

/// The height of a plot as a fraction of its width, and the most that one is high: as a fraction of the view's height, and in points.
const ASPECT: f32 = 0.62;
const SHARE: f32 = 0.55;
const HIGHEST: f32 = 420.0;
/// The height of a bar, in points.
const BAR: f32 = 18.0;
/// The most orders that have bars.
const ORDERS: usize = 6;
/// The most wrong models that are named.
const MODELS: usize = 3;

/// The answers to a question, and how they are shown.
pub struct Answers<'a> {
    pub question: &'a Question,
    pub asked: &'a ClassQuestion,
    pub spread: &'a Spread,
    /// True if the right answer may be seen.
    pub right: bool,
    /// The step, from 1.
    pub step: usize,
    pub markdown: &'a mut CommonMarkCache,
    /// The picture of a step that clicks are shown in.
    pub picture: &'a mut Option<(usize, TextureHandle)>,
    /// The textures of the drawings of the last two rounds.
    pub layers: &'a mut [Layer; 2],
}

impl<'a> Answers<'a> {
    /// Returns the last two rounds with their numbers.
    fn rounds(&self) -> Vec<(usize, &'a Round)> {
        let rounds = &self.spread.rounds;
        let numbered = rounds.iter().enumerate();
        let last = numbered.skip(rounds.len().saturating_sub(2));
        last.map(|(index, round)| (index + 1, round)).collect()
    }

    fn solution(&self) -> Option<&'a Solution> {
        self.asked.solution().filter(|_| self.right)
    }
}

/// Shows the answers of the last two rounds.
pub fn answers_ui(ui: &mut Ui, answers: &mut Answers<'_>) {
    match &answers.question.kind {
        Kind::Choice(_) => choices_ui(ui, answers),
        Kind::Order(_) => orders_ui(ui, answers),
        Kind::Match(_) => {}
        _ => rounds_ui(ui, answers),
    }
    if answers.right {
        models_ui(ui, answers);
    }
}

/// Shows a drawing for each round, side by side.
fn rounds_ui(ui: &mut Ui, answers: &mut Answers<'_>) {
    let rounds = answers.rounds();
    let several = rounds.len() > 1;
    ui.columns(rounds.len().max(1), |columns| {
        for (index, (ui, (number, round))) in columns.iter_mut().zip(rounds).enumerate() {
            round_ui(ui, answers, (index, round));
            caption_ui(ui, answers, (number, round), several);
        }
    });
}

/// Says which round it is, how many answered, and how many of them rightly once that may be seen.
fn caption_ui(ui: &mut Ui, answers: &Answers<'_>, (number, round): (usize, &Round), several: bool) {
    let count = round.answers.len();
    let words = if answers.right {
        text!("wall-right-of", right = round.right(), count = count)
    } else {
        text!("wall-count", count = count)
    };
    let words = if several {
        format!("{}: {words}", text!("wall-round", round = number))
    } else {
        words
    };
    ui.label(RichText::new(words).weak());
}

/// Returns the most that a plot is high, in points: what it is about stays in sight above it.
fn most_height(ui: &Ui) -> f32 {
    HIGHEST.min(SHARE * ui.clip_rect().height())
}

fn round_ui(ui: &mut Ui, answers: &mut Answers<'_>, (index, round): (usize, &Round)) {
    let style = plot_style(ui);
    let width = ui.available_width();
    let size = vec2(width, (ASPECT * width).min(most_height(ui)));
    let size = DVec2::new(size.x.into(), size.y.into());
    let colours = Colours {
        answer: rgb(vector_text(ui.visuals(), Vector::L)),
        right: rgb(right_colour(ui)),
    };
    let words = || text!("wall-count", count = round.answers.len());
    let mut drawing = match (&answers.question.kind, answers.solution()) {
        (Kind::Curve(curve), right) => {
            let names = [&curve.x_name, &curve.y_name].map(|name| name.plain());
            let right = match right {
                Some(Solution::Curve(right)) => Some(&right[..]),
                _ => None,
            };
            curves(
                curve,
                [&names[0], &names[1]],
                round,
                right,
                (size, &style, colours),
            )
        }
        (Kind::Point(_), _) => return picture_ui(ui, answers, (index, round), (&style, colours)),
        _ => {
            let Some((ends, name, tolerance)) = range(answers.question) else {
                return;
            };
            let right = match answers.solution() {
                Some(Solution::Value(right) | Solution::Settings(right)) => {
                    Some([*right, tolerance])
                }
                _ => None,
            };
            let range = Range {
                ends,
                name: &name,
                count: text!("wall-students-axis"),
                right,
            };
            let most = answers.rounds().into_iter();
            let most = most.map(|(_, round)| highest(ends, &values(round))).max();
            let style = (size, &style, colours);
            numbers(range, &values(round), most.unwrap_or(0), style)
        }
    };
    // The letters are the window's own, over the texture.
    let letters = Drawing {
        texts: std::mem::take(&mut drawing.texts),
        ..Drawing::new(drawing.size, style.paper.ground)
    };
    let below = ui.painter().add(Shape::Noop);
    if let Some((response, painter)) = drawing_ui(ui, &letters, Sense::hover(), words) {
        let shape = answers.layers[index].shape(&painter, drawing, response.rect);
        painter.set(below, shape);
    }
}

/// Returns the ends and the name of the axis of a question for a number, and how far from the right one is right too.
fn range(question: &Question) -> Option<([f64; 2], String, f64)> {
    match &question.kind {
        Kind::Value(value) => Some(([value.from, value.to], value.unit.clone(), value.tolerance)),
        Kind::Settings(settings) => {
            let (.., slider) = slider(&settings.control)?;
            let name = control_name(&settings.control);
            Some(([slider.from, slider.to], name, 0.0))
        }
        _ => None,
    }
}

fn values(round: &Round) -> Vec<f64> {
    let answers = round.answers.iter();
    let value = |answer: &Answer| match answer {
        Answer::Value(value) | Answer::Settings(value) => Some(*value),
        _ => None,
    };
    answers.filter_map(|graded| value(&graded.answer)).collect()
}

/// Shows the picture of the step with the clicks in it.
fn picture_ui(
    ui: &mut Ui,
    answers: &mut Answers<'_>,
    (index, round): (usize, &Round),
    (style, colours): (&PlotStyle, Colours),
) {
    let (Some(frame), Kind::Point(point)) = (&answers.asked.picture, &answers.question.kind) else {
        return;
    };
    let step = answers.step;
    if answers
        .picture
        .as_ref()
        .is_none_or(|(known, _)| *known != step)
    {
        let texture = ui
            .ctx()
            .load_texture("class", image_of(frame), TextureOptions::LINEAR);
        *answers.picture = Some((step, texture));
    }
    let Some((_, texture)) = answers.picture.as_ref() else {
        return;
    };
    let size = vec2(frame.width as f32, frame.height as f32);
    let most = vec2(ui.available_width(), most_height(ui));
    let shown = size * (most / size).min_elem();
    let response = tile::picture_ui(ui, Some(texture), shown);
    let rect = response.rect;
    let words = text!("wall-count", count = round.answers.len());
    named(response, Role::Image, &words);
    let right = match answers.solution() {
        Some(Solution::Point(places)) => Some(&places[..]),
        _ => None,
    };
    let size = DVec2::new(shown.x.into(), shown.y.into());
    let drawing = clicks(round, right, point.tolerance, (size, style.text, colours));
    let painter = ui.painter_at(rect);
    painter.add(answers.layers[index].shape(&painter, drawing, rect));
}

/// Shows a text of the lesson in the words of the phones, on which it is answered.
pub fn words_ui(ui: &mut Ui, markdown: &mut CommonMarkCache, words: &str) {
    prose_ui(ui, markdown, &for_fingers(words));
}

/// Shows each option with a bar for each round.
fn choices_ui(ui: &mut Ui, answers: &mut Answers<'_>) {
    let right = match answers.solution() {
        Some(Solution::Choice(right)) => Some(*right),
        _ => None,
    };
    for (option, words) in answers.asked.options.iter().enumerate() {
        let words = format!("{}\\. {words}", letter(option));
        ui.push_id(option, |ui| words_ui(ui, answers.markdown, &words));
        let is_this = |answer: &Answer| *answer == Answer::Choice(option);
        bars_ui(ui, &answers.rounds(), is_this, right == Some(option));
    }
}

/// Shows the most frequent orders with a bar for each round, and which letter stands for what.
fn orders_ui(ui: &mut Ui, answers: &mut Answers<'_>) {
    let rounds = answers.rounds();
    let given = rounds.iter().flat_map(|(_, round)| &round.answers);
    let orders = counted(given.map(|graded| &graded.answer)).into_iter();
    let right = answers.solution().map(Answer::right);
    for (order, _) in orders.take(ORDERS) {
        ui.label(RichText::new(short_answer(order)).strong());
        let is_this = |answer: &Answer| answer == order;
        bars_ui(ui, &rounds, is_this, right.as_ref() == Some(order));
    }
    for (item, words) in answers.asked.options.iter().enumerate() {
        let words = format!("{}\\. {words}", letter(item));
        ui.push_id(item, |ui| words_ui(ui, answers.markdown, &words));
    }
}

/// Shows a bar for each round: how many of its answers are this one.
fn bars_ui(
    ui: &mut Ui,
    rounds: &[(usize, &Round)],
    is_this: impl Fn(&Answer) -> bool,
    is_right: bool,
) {
    let visuals = ui.visuals();
    let right = right_colour(ui);
    let plain = vector_text(visuals, Vector::L);
    for (index, (number, round)) in rounds.iter().enumerate() {
        let given = round.answers.iter();
        let count = given.filter(|graded| is_this(&graded.answer)).count();
        let share = count as f32 / round.answers.len().max(1) as f32;
        let words = format!("{count} ({:.0} %)", 100.0 * share);
        let words = if is_right {
            format!("{words} · {}", text!("course-mark-right"))
        } else {
            words
        };
        let words = match rounds.len() {
            1 => words,
            _ => format!("{number}: {words}"),
        };
        ui.horizontal(|ui| {
            let width = 0.7 * ui.available_width();
            let colour = if is_right { right } else { plain };
            // The round before is paler.
            let last = index + 1 == rounds.len();
            let colour = colour.gamma_multiply(if last { 1.0 } else { 0.5 });
            let response = meter_ui(ui, vec2(width, BAR), share, colour);
            named(response, Role::Image, &words);
            ui.label(words);
        });
    }
    ui.add_space(4.0);
}

/// Shows which wrong models the answers of the last round agree with.
fn models_ui(ui: &mut Ui, answers: &mut Answers<'_>) {
    let Some(round) = answers.spread.rounds.last() else {
        return;
    };
    for (model, count) in round.models().into_iter().take(MODELS) {
        let Some(says) = answers.asked.says.get(model) else {
            continue;
        };
        let words = format!("**{count} ×** {says}");
        ui.push_id(("model", model), |ui| {
            words_ui(ui, answers.markdown, &words);
        });
    }
}
