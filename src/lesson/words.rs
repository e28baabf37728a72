//! A lesson in words, for a terminal.

use super::class::{Asked, letter};
use super::worksheet::answer_words;
use super::{Budget, Kind, Lab, Lesson, LessonError, Question};
use crate::text::text;
use std::fmt::Write as _;

/// The lesson with its numbers, its questions and, with `answers`, what is right and why.
///
/// # Errors
/// What is wrong with the lesson, with its line.
pub fn in_words(lesson: &Lesson, seed: u64, answers: bool) -> Result<String, LessonError> {
    let mut out = format!("{}\n", lesson.title);
    if !lesson.about.is_empty() {
        let _ = writeln!(out, "{}", without_marks(&lesson.about));
    }
    let mut right = String::new();
    let mut number = 0;
    let budget = Budget::of_file();
    for (index, step) in lesson.steps.iter().enumerate() {
        let staged = step.stage.load(lesson.folder.as_deref())?;
        let lab = Lab::within(&staged, &budget);
        let place = lab.place(&staged);
        let wrong = |(line, words): (u64, String)| LessonError::one(line, words);
        let text = step.text.filled(&place).map_err(wrong)?;
        let _ = write!(
            out,
            "\n{}. {}\n\n{}\n",
            index + 1,
            step.title,
            without_marks(text.trim())
        );
        let mut settings = vec![step.stage.scene.clone()];
        settings.extend(
            step.stage
                .set
                .iter()
                .map(|setting| ["--set", setting].join(" ")),
        );
        let _ = writeln!(out, "\n    {}", settings.join(" "));
        let Some(question) = &step.question else {
            continue;
        };
        number += 1;
        let asked = Asked::filled(index, question, place).map_err(wrong)?;
        let heading = text!("class-question", number = number);
        let _ = writeln!(out, "\n{heading} {}", without_marks(&asked.ask));
        out.push_str(&room(&asked, question));
        if answers {
            let solution = question.solve(place, seed);
            let solution = solution
                .map_err(|words| wrong((question.line, text!("lesson-question", words = words))))?;
            let words = without_marks(&answer_words(&asked, question, &solution));
            let _ = writeln!(
                right,
                "{heading} {words}\n{}\n",
                without_marks(asked.why.trim())
            );
        }
    }
    if !right.is_empty() {
        let heading = text!("class-answers", title = &*lesson.title);
        let _ = write!(out, "\n{heading}\n\n{}\n", right.trim_end());
    }
    Ok(out)
}

/// What there is to choose from, or what is expected.
fn room(asked: &Asked, question: &Question) -> String {
    let options = asked.options.iter().enumerate();
    let mut out: String = options
        .map(|(index, words)| format!("   {} {}\n", letter(index), without_marks(words)))
        .collect();
    if let Kind::Value { from, to, unit, .. } = &question.kind {
        let _ = writeln!(
            out,
            "   {}",
            text!(
                "class-range",
                from = from.to_string(),
                to = to.to_string(),
                unit = &**unit
            )
        );
    }
    out
}

/// CommonMark without the marks of formulas.
pub fn without_marks(text: &str) -> String {
    text.replace("`$", "").replace("$`", "").replace('$', "")
}
