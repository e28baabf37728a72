//! The page of a class on a phone: what surrounds the steps, a step with its question, and its explanation, as HTML.
//!
//! All is made by pure functions of the lesson, in the language of the moment, by the builder of worksheets. What shows an answer
//! (the right one, why it is right, what is said of wrong models, the text behind a question) stands in the explanation alone, which
//! the class hands out when the lecturer says so.

mod form;
mod lab;
mod picture;
mod plot;
mod shell;

pub use shell::{SCRIPT, STYLE, shell};

use crate::lesson::{
    Budget, ClassQuestion, Element, FilledStep, Html, Kind, Lab, Lesson, LessonError, Printed,
    Question, Solution, Step, answer, blocks, element, for_fingers, inline,
};
use crate::text::text;
use form::form;
use lab::LabLink;
use picture::Pictures;
use plot::CurvePlot;

/// The most bytes of a phone's first view: the page, its style and script, the step and its pictures.
pub const FIRST_VIEW: usize = 80_000;

/// A step as phones show it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct StepPage {
    /// The title, the text, the picture and the question, and nothing of the answer.
    pub html: String,
    /// The right answer and why it is right; empty of a step that asks nothing.
    pub explanation: String,
    /// The pictures in the question, as PNG, by their numbers.
    pub pictures: Vec<Vec<u8>>,
}

/// Returns the page of a step, counted from 0; `seed` decides what is drawn at random.
///
/// # Errors
/// The problem of the lesson, with its line; or that it has no such step.
pub fn step_page(lesson: &Lesson, index: usize, seed: u64) -> Result<StepPage, LessonError> {
    let count = lesson.steps.len();
    let step = lesson.steps.get(index).ok_or_else(|| {
        LessonError::one(1, text!("link-no-step", step = index + 1, count = count))
    })?;
    let staged = step.stage.load(lesson.folder.as_deref())?;
    let full = Lab::within(&staged, &Budget::of_file());
    let place = full.place(&staged);
    let mut filled = FilledStep::new((index, step), &full, place, Some(seed))?;
    filled.text = for_fingers(&filled.text);
    if let Some(asked) = &mut filled.asked {
        (asked.ask, asked.why) = (for_fingers(&asked.ask), for_fingers(&asked.why));
    }
    let pictures = Pictures::fitting(step, &staged, &filled)?;
    let link = LabLink::of(&staged);
    let mut page = element("article")
        .attribute("data-step", index + 1)
        .broken()
        .line(heading(index, step))
        .line(element("div").class("text").with(blocks(&filled.text)));
    let question = step.question.as_ref();
    if !question.is_some_and(|question| question.kind.asks().uses_picture()) {
        page = page.line(pictures.figure(index, 0, &step.title));
    }
    let mut explanation = Html::new();
    match (question, &filled.asked, &filled.right) {
        (Some(question), Some(asked), Some(right)) => {
            page = page.line(form(question, asked, &pictures, index, &link));
            let printed = Printed {
                ask: &asked.ask,
                options: &asked.options,
                set: &question.set,
                place: pictures.place(),
                picture: pictures.frame(),
                seed,
                without_pictures: false,
            };
            let right = right_answer(question, asked, right, &printed);
            let right = right.map_err(|words| step.question_problem(words))?;
            let after = step.after.filled(&place)?;
            explanation = explanation
                .line(element("h3").with(text!("phone-right")))
                .line(right)
                .line(blocks(&for_fingers(&after)))
                .line(link.html());
        }
        _ => page = page.line(link.html()),
    }
    Ok(StepPage {
        html: Html::from(page).to_string(),
        explanation: explanation.to_string(),
        pictures: pictures.into_bytes(),
    })
}

/// Returns the title of a step with its number.
fn heading(index: usize, step: &Step) -> Element {
    let title = Html::from(format!("{}. ", index + 1)).with(inline(&step.title));
    // The script moves the focus there when the step changes.
    element("h2").attribute("tabindex", -1).with(title)
}

/// Returns the right answer, and why it is right.
fn right_answer(
    question: &Question,
    asked: &ClassQuestion,
    right: &Solution,
    printed: &Printed<'_>,
) -> Result<Html, String> {
    let (Kind::Curve(curve), Solution::Curve(right)) = (&question.kind, right) else {
        return answer(asked, question, Some(right), printed);
    };
    // The axes of a worksheet are too wide for a phone.
    let plot = CurvePlot::new(curve);
    let entry = |class: &str, words: &str| element("span").class(class).with(words);
    let legend = element("p")
        .class("legend")
        .with(entry("own", text!("course-curve-yours")))
        .with(" ")
        .with(entry("right", text!("course-curve-right")));
    let why = element("div").with(blocks(&asked.why));
    Ok(Html::new()
        .line(plot.html(Some(right)))
        .line(legend)
        .line(why))
}
