//! A lesson as plain text, for a terminal.

use super::class::ClassQuestion;
use super::links::without_closed_links;
use super::{Budget, Lab, Lesson, LessonError, Question, Staged, letter};
use crate::text::text;
use std::fmt::Write as _;

/// Returns the lesson with its numbers, its questions and, with `answers`, the right answers and their
/// explanations.
///
/// # Errors
/// Returns the problem of the lesson, with its line.
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
        let text = step.text.filled(&place)?;
        let text = without_marks(text.trim());
        let _ = write!(out, "\n{}. {}\n\n{text}\n", index + 1, step.title);
        let _ = writeln!(out, "\n    {}", arguments(&staged, &step.stage.scene));
        let Some(question) = &step.question else {
            continue;
        };
        number += 1;
        let asked = ClassQuestion::filled(index, question, place)?;
        let heading = text!("class-question", number = number);
        let _ = writeln!(out, "\n{heading} {}", without_marks(&asked.ask));
        out.push_str(&expected(&asked, question));
        if answers {
            let solution = question.solve(place, seed);
            let solution = solution.map_err(|words| step.question_problem(words))?;
            let words = question.kind.solution_words(&solution, &asked.options);
            let after = step.after.filled(&place)?;
            let said = [&asked.why, &after].map(|text| text.trim());
            let said: Vec<&str> = said.into_iter().filter(|text| !text.is_empty()).collect();
            let (words, said) = (without_marks(&words), without_marks(&said.join("\n\n")));
            let _ = writeln!(right, "{heading} {words}\n{said}\n");
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

/// Quotes a word for a shell, if necessary, in single quotation marks.
fn shell_word(word: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_.,:/=+".contains(c);
    if !word.is_empty() && word.chars().all(plain) {
        return word.to_owned();
    }
    format!("'{}'", word.replace('\'', r"'\''"))
}

/// Returns the options, and a hint to the expected answer, if there is one.
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

/// Removes the marks of formulas, and the links that may not be opened, from CommonMark.
pub fn without_marks(text: &str) -> String {
    let text = without_closed_links(text);
    text.replace("`$", "").replace("$`", "").replace('$', "")
}

/// Replaces the mouse's words by those of a finger.
pub fn for_fingers(words: &str) -> String {
    let [mouse, finger] = [text!("course-mouse-words"), text!("course-finger-words")];
    let pairs = mouse.split(' ').zip(finger.split(' '));
    pairs.fold(words.to_owned(), |words, (mouse, finger)| {
        words.replace(mouse, finger)
    })
}

#[cfg(test)]
mod tests {
    use super::for_fingers;

    #[test]
    fn fingers_tap_where_a_mouse_clicks() {
        let words = "Click the ball. You clicked the middle; click elsewhere.";
        let tapped = "Tap the ball. You tapped the middle; tap elsewhere.";
        assert_eq!(for_fingers(words), tapped);
    }
}
