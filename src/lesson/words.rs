//! A lesson in words, for a terminal.

use super::class::ClassQuestion;
use super::links::without_closed_links;
use super::{Budget, Lab, Lesson, LessonError, Question, Staged, letter};
use crate::text::text;
use std::fmt::Write as _;

/// Returns the lesson with its numbers, its questions and, with `answers`, what is right and why.
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
        let _ = writeln!(out, "\n    {}", arguments(&staged, &step.stage.scene));
        let Some(question) = &step.question else {
            continue;
        };
        number += 1;
        let asked = ClassQuestion::filled(index, question, place).map_err(wrong)?;
        let heading = text!("class-question", number = number);
        let _ = writeln!(out, "\n{heading} {}", without_marks(&asked.ask));
        out.push_str(&expected(&asked, question));
        if answers {
            let solution = question.solve(place, seed);
            let solution = solution
                .map_err(|words| wrong((question.line, text!("lesson-question", words = words))))?;
            let words = question.kind.solution_words(&solution, &asked.options);
            let words = without_marks(&words);
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

/// Returns a step's scene as the arguments of any command that takes a scene.
fn arguments(staged: &Staged, name: &str) -> String {
    let path = staged.path.as_ref().map(|path| path.display().to_string());
    let mut words = shell_word(path.as_deref().unwrap_or(name));
    for setting in &staged.settings {
        let _ = write!(words, " --set {}", shell_word(setting));
    }
    words
}

/// Returns a word as a shell reads it: in single quotation marks where it would be taken apart without.
fn shell_word(word: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_.,:/=+".contains(c);
    if !word.is_empty() && word.chars().all(plain) {
        return word.to_owned();
    }
    format!("'{}'", word.replace('\'', r"'\''"))
}

/// Returns the options, or a line that says what is expected.
fn expected(asked: &ClassQuestion, question: &Question) -> String {
    let options = asked.options.iter().enumerate();
    let mut out: String = options
        .map(|(index, words)| format!("   {} {}\n", letter(index), without_marks(words)))
        .collect();
    if let Some(hint) = question.kind.asks().hint() {
        let _ = writeln!(out, "   {hint}");
    }
    out
}

/// Returns CommonMark without the marks of formulas, and without links that may not be opened.
pub fn without_marks(text: &str) -> String {
    let text = without_closed_links(text);
    text.replace("`$", "").replace("$`", "").replace('$', "")
}
