//! The light page of a phone: the page itself, and each step's part of it.

use crate::document::picture_bytes;
use crate::lesson::{Budget, Lab, Lesson, LessonError};
use crate::text::{escaped, language};

/// The page's script.
pub const SCRIPT: &str = include_str!("../../assets/class/class.js");
/// The page's style.
pub const STYLE: &str = include_str!("../../assets/class/class.css");

/// A step's part of the page, as fragments of HTML.
#[derive(Clone, Debug, Default)]
pub struct StepPage {
    /// The step with its question, and nothing of the answer.
    pub html: String,
    /// What is shown once the step is explained.
    pub explanation: String,
    /// The pictures as PNG, under `steps/STEP/1.png` and so on.
    pub pictures: Vec<Vec<u8>>,
}

/// Makes the page of a step, counted from 0; `seed` decides what is drawn at random.
///
/// # Errors
/// What is wrong with the step, with its line.
pub fn step_page(lesson: &Lesson, index: usize, _seed: u64) -> Result<StepPage, LessonError> {
    let step = &lesson.steps[index];
    let staged = step.stage.load(lesson.folder.as_deref())?;
    let lab = Lab::within(&staged, &Budget::of_file());
    let place = lab.place(&staged);
    let wrong = |(line, words): (u64, String)| LessonError {
        problems: vec![crate::lesson::LessonProblem { line, words }],
    };
    let plain = |text: String| escaped(&text).replace('&', "&amp;").replace('<', "&lt;");
    let text = plain(step.text.filled(&place).map_err(wrong)?);
    let after = plain(step.after.filled(&place).map_err(wrong)?);
    let mut asked = String::new();
    if let Some(question) = &step.question {
        asked = plain(question.ask.filled(&place).map_err(wrong)?);
    }
    let picture = picture_bytes(&place.picture(), None).unwrap_or_default();
    let (title, number) = (plain(step.title.clone()), index + 1);
    Ok(StepPage {
        html: format!(
            "<h1>{title}</h1>\n<img src=\"steps/{number}/1.png\" alt=\"\">\n<p>{text}</p>\n<p>{asked}</p>\n"
        ),
        explanation: format!("<p>{after}</p>\n"),
        pictures: vec![picture],
    })
}

/// Returns the page of a class for phones, with a step in it. `lab`: whether the program's own page can be opened.
pub fn shell(lesson: &Lesson, step: &StepPage, _lab: bool) -> String {
    let title = lesson.title.replace('&', "&amp;").replace('<', "&lt;");
    let (language, step) = (language().tag(), &step.html);
    format!(
        "<!DOCTYPE html>\n<html lang=\"{language}\"><head><meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{title}</title>\n\
         <link rel=\"stylesheet\" href=\"class.css\"><script src=\"class.js\" defer></script></head>\n\
         <body><p id=\"pace\"></p><main>{step}</main></body></html>\n"
    )
}
