//! Answers handed in: one picture that contains the scene, the lesson and every answer.
//!
//! The answers are a text chunk of the PNG: JSON that begins with a digest of the rest and of the scene's
//! text, so that changes by hand or by another program are detected. The digest is no signature: anybody with
//! the source of this program can write any answers with a matching digest. Grades are not included; the
//! collector of the answers computes them.

use super::{Answer, Answered, Grade, Lesson, Record, find};
use crate::bits::fnv_1a;
use crate::document::{SaveError, write_picture};
use crate::picture::{PictureError, SCENE_KEYWORD, read_texts, write_png};
use crate::render::Frame;
use crate::scene::Scene;
use crate::text::{Language, language, text, turns};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use std::io::{BufRead, Seek};
use std::path::Path;

/// The keyword of the text chunk with the answers.
pub const ANSWERS_KEYWORD: &str = "shading-lab:answers";

/// The version of the chunk's format.
const VERSION: u64 = 1;
/// The maximum length of the text, in bytes: a lesson of [`Lesson::MAX_TEXT`] with every line's end escaped,
/// and its answers.
const MAX_TEXT: usize = 4 << 20;
/// The longest time that an answer can have taken, in seconds: a forged file may say anything.
pub(super) const LONGEST: f64 = 1e7;
/// The maximum length of a student's stored name, in characters.
pub const MAX_NAME: usize = 100;

/// The answers that a student handed in. They are unchecked, and may fit no question.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct HandIn {
    /// The student's name without control characters; empty if none was given.
    pub name: String,
    /// The title of the lesson as the student saw it.
    pub title: String,
    /// The language in which the student saw the lesson.
    pub language: Language,
    /// The digest of the lesson's text.
    pub digest: String,
    /// The lesson's text; `None` for a lesson that comes with the program.
    pub source: Option<String>,
    /// The answers.
    pub record: Record,
}

impl HandIn {
    /// Returns the answers to a lesson as a student hands them in, in the current language.
    pub fn new(lesson: &Lesson, record: &Record, name: &str) -> Self {
        let mut record = record.clone();
        record.fit(lesson);
        Self {
            name: clean_name(name),
            title: lesson.title.clone(),
            language: language(),
            digest: digest([&lesson.source]),
            source: (!is_built_in(lesson)).then(|| lesson.source.clone()),
            record,
        }
    }

    /// Returns whether `lesson` has exactly the text that was answered.
    pub fn is_of(&self, lesson: &Lesson) -> bool {
        digest([&lesson.source]) == self.digest
    }
}

/// Returns whether a lesson comes with the program, word for word.
pub(super) fn is_built_in(lesson: &Lesson) -> bool {
    find(&lesson.name).is_some_and(|built_in| {
        let mut languages = Language::ALL.into_iter();
        languages.any(|language| built_in.source(language) == lesson.source)
    })
}

/// The reason why a picture does not count as answers handed in.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum HandInError {
    /// No picture, or one that cannot be read.
    #[error(transparent)]
    Picture(#[from] PictureError),
    /// A picture without answers.
    #[error("{}", text!("class-no-answers"))]
    NoAnswers,
    /// Answers in another version of the format.
    #[error("{}", text!("class-version", version = VERSION))]
    Version,
    /// The answers or the scene were changed after they were handed in.
    #[error("{}", text!("class-changed"))]
    Changed,
    /// A text that does not have the form of answers.
    #[error("{}", text!("class-not-answers", error = .0.to_string()))]
    Form(serde_json::Error),
}

#[derive(Serialize, Deserialize)]
struct Content {
    lesson: String,
    title: String,
    lesson_digest: String,
    language: String,
    name: Option<String>,
    seed: u64,
    answers: Vec<Entry>,
    source: Option<String>,
}

#[derive(Serialize, Deserialize)]
struct Entry {
    step: usize,
    kind: String,
    prediction: Value,
    given: Value,
    looked_up: u32,
    tries: u32,
    seconds: f64,
}

/// Writes a PNG of the last picture with the answers to a lesson. Opening the PNG restores the scene.
///
/// # Errors
/// See [`SaveError`].
pub fn hand_in(
    path: &Path,
    frame: &Frame,
    scene: &Scene,
    lesson: &Lesson,
    record: &Record,
    name: &str,
) -> Result<(), SaveError> {
    let answers = answers_text(lesson, record, name, &scene.to_toml());
    write_picture(path, frame, Some(scene), &[(ANSWERS_KEYWORD, &answers)])
}

/// Returns the bytes of a PNG with the answers to a lesson.
///
/// # Errors
/// Returns an error if the frame has no pixels.
pub fn hand_in_bytes(
    frame: &Frame,
    scene: &Scene,
    lesson: &Lesson,
    record: &Record,
    name: &str,
) -> Result<Vec<u8>, PictureError> {
    let answers = answers_text(lesson, record, name, &scene.to_toml());
    let mut bytes = Vec::new();
    let texts = [(ANSWERS_KEYWORD, &*answers)];
    write_png(&mut bytes, frame, Some(scene), &texts).map(|()| bytes)
}

fn answers_text(lesson: &Lesson, record: &Record, name: &str, scene: &str) -> String {
    let hand_in = HandIn::new(lesson, record, name);
    let content = Content {
        lesson: hand_in.record.lesson,
        title: hand_in.title,
        lesson_digest: hand_in.digest,
        language: hand_in.language.tag().to_owned(),
        name: Some(hand_in.name).filter(|name| !name.is_empty()),
        seed: hand_in.record.seed,
        answers: hand_in.record.answers.iter().map(entry).collect(),
        source: hand_in.source,
    };
    let content = json!(content).to_string();
    // The opening brace belongs to the whole object.
    let rest = format!(",{}", content.get(1..).unwrap_or_default());
    head(&digest([&rest, scene])) + &rest
}

/// Returns the text in front of the part that the digest covers.
fn head(digest: &str) -> String {
    format!(r#"{{"version":{VERSION},"digest":"{digest}""#)
}

/// Reads the answers in a PNG.
///
/// # Errors
/// Returns the reason why the PNG does not count as answers.
pub fn read_hand_in(png: impl BufRead + Seek) -> Result<HandIn, HandInError> {
    let wanted = [
        (ANSWERS_KEYWORD, MAX_TEXT),
        (SCENE_KEYWORD, Scene::MAX_TEXT),
    ];
    let [answers, scene] = read_texts(png, wanted)?;
    let answers = answers.ok_or(HandInError::NoAnswers)?;
    let all: Value = serde_json::from_str(&answers).map_err(HandInError::Form)?;
    if all.get("version").and_then(Value::as_u64) != Some(VERSION) {
        return Err(HandInError::Version);
    }
    let said = all
        .get("digest")
        .and_then(Value::as_str)
        .unwrap_or_default();
    let scene = scene.unwrap_or_default();
    let sealed = |rest: &str| digest([rest, &scene]) == said;
    if !answers.strip_prefix(&head(said)).is_some_and(sealed) {
        return Err(HandInError::Changed);
    }
    let content: Content = serde_json::from_value(all).map_err(HandInError::Form)?;
    let entries = content.answers.into_iter().take(Lesson::MAX_STEPS);
    let answers: Result<Vec<Answered>, _> = entries.map(answered).collect();
    let source = content
        .source
        .filter(|source| source.len() <= Lesson::MAX_TEXT);
    if source
        .as_ref()
        .is_some_and(|source| digest([source]) != content.lesson_digest)
    {
        return Err(HandInError::Changed);
    }
    Ok(HandIn {
        name: clean_name(&content.name.unwrap_or_default()),
        title: clean(&content.title, 2 * MAX_NAME),
        language: Language::from_tag(&content.language).unwrap_or(Language::English),
        digest: content.lesson_digest,
        source,
        record: Record {
            lesson: clean(&content.lesson, MAX_NAME),
            seed: content.seed,
            answers: answers.map_err(HandInError::Form)?,
        },
    })
}

fn entry(answered: &Answered) -> Entry {
    let (kind, given) = answer_parts(&answered.answer);
    let (_, prediction) = answer_parts(&answered.prediction);
    Entry {
        step: answered.step,
        kind,
        prediction,
        given,
        looked_up: answered.looked_up,
        tries: answered.tries,
        seconds: answered.seconds,
    }
}

fn answered(entry: Entry) -> Result<Answered, serde_json::Error> {
    let answer = |value| serde_json::from_value(json!({ &*entry.kind: value }));
    Ok(Answered {
        step: entry.step,
        prediction: answer(entry.prediction)?,
        answer: answer(entry.given)?,
        grade: Grade::default(),
        looked_up: entry.looked_up,
        tries: entry.tries,
        seconds: entry.seconds.clamp(0.0, LONGEST),
    })
}

/// Returns the kind of an answer as in lessons, and its value as in JSON.
pub fn answer_parts(answer: &Answer) -> (String, Value) {
    let one = match json!(answer) {
        Value::Object(one) => one.into_iter().next(),
        _ => None,
    };
    one.unwrap_or_default()
}

/// Returns a name without anything that would overwrite other text.
pub(super) fn clean_name(name: &str) -> String {
    clean(name, MAX_NAME)
}

/// Returns untrusted text as one short line, without control characters and marks that change the writing
/// direction.
pub fn clean(text: &str, most: usize) -> String {
    let plain = text.chars().filter(|c| !turns(*c));
    let plain = plain.map(|c| if c.is_control() { ' ' } else { c });
    plain.take(most).collect::<String>().trim().to_owned()
}

/// Returns the FNV-1a hash of texts, each followed by its length.
pub(crate) fn digest<'t>(
    texts: impl IntoIterator<Item = &'t (impl AsRef<str> + ?Sized + 't)>,
) -> String {
    fnv_1a(texts.into_iter().flat_map(|text| {
        let text = text.as_ref();
        text.bytes().chain((text.len() as u64).to_le_bytes())
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digests_are_those_of_fnv() {
        // An empty text followed by its length 0: FNV-1a of eight zero bytes.
        assert_eq!(digest([""]), "a8c7f832281a39c5");
        assert_ne!(digest(["ab", "c"]), digest(["a", "bc"]));
    }

    #[test]
    fn names_are_one_plain_line() {
        assert_eq!(
            clean_name(" Ada\r\n\u{1b}[31mL\u{202e}ovelace "),
            "Ada   [31mLovelace"
        );
        assert_eq!(clean_name(&"x".repeat(1000)).len(), MAX_NAME);
        assert_eq!(clean_name("王小明"), "王小明");
    }
}
