//! `lesson`: the list of lessons, one lesson as text, or its worksheet.

use super::input::{called, is_stdin, output_ending_in, stdin};
use super::output::{Failure, print, print_json, progress_bar, spinner, widest, write_text};
use clap::Args;
use clap::builder::TypedValueParser;
use serde_json::{Value, json};
use shading_lab::document::check_target;
use shading_lab::lesson::{
    LESSONS, Lesson, LessonError, OpenError, Worksheet, find, in_words, topic_name, worksheet,
};
use shading_lab::scene::did_you_mean;
use shading_lab::text::{excerpt, text};
use std::path::{Path, PathBuf};

/// Samples per pixel of a worksheet's pictures.
const SAMPLES: u32 = 4;

#[derive(Args)]
pub struct LessonCommand {
    #[arg(value_name = "NAME|FILE.md")]
    lesson: Option<PathBuf>,
    #[arg(short, long, value_name = "FILE.html", value_parser = page_name(), requires = "lesson")]
    output: Option<PathBuf>,
    #[arg(long, requires = "lesson")]
    without_answers: bool,
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    #[arg(long, conflicts_with = "output")]
    json: bool,
}

pub fn page_name() -> impl TypedValueParser<Value = PathBuf> {
    output_ending_in(&["html", "htm"], "cli-expected-html")
}

impl LessonCommand {
    pub fn run(self) -> Result<(), Failure> {
        let Some(name) = &self.lesson else {
            return match self.json {
                true => print_json(&summaries()),
                false => print(&list()),
            };
        };
        if let Some(target) = &self.output {
            check_target(target)?;
        }
        let lesson = open(name)?;
        let wrong = |error: LessonError| {
            let path = called(name).to_owned();
            Failure::input(OpenError::Lesson { path, error })
        };
        let answers = !self.without_answers;
        if let Some(target) = &self.output {
            let sheet = Worksheet {
                answers,
                seed: self.seed,
                samples: SAMPLES,
            };
            let bar = progress_bar(lesson.steps.len() as u64, text!("cli-drawing"));
            let page = worksheet(&lesson, sheet, &mut || bar.inc(1)).map_err(wrong)?;
            return write_text(target, &page);
        }
        if self.json {
            return print_json(&format!("{:#}\n", steps(&lesson)));
        }
        let working = spinner(text!("cli-working"));
        let words = in_words(&lesson, self.seed, answers).map_err(wrong)?;
        drop(working);
        print(&words)
    }
}

/// Opens a built-in lesson, a file, or the standard input.
pub fn open(name: &Path) -> Result<Lesson, Failure> {
    if let Some(lesson) = name.to_str().and_then(find) {
        return Ok(lesson.lesson());
    }
    if is_stdin(name) || Lesson::is_file(name) {
        return open_file(name);
    }
    let name = excerpt(&name.to_string_lossy());
    let meant = did_you_mean(&name, LESSONS.iter().map(|lesson| lesson.name));
    Err(Failure::input(text!(
        "cli-no-lesson",
        name = name,
        meant = meant
    )))
}

/// Opens a lesson's file, or the standard input.
pub fn open_file(path: &Path) -> Result<Lesson, Failure> {
    read(path).map_err(Failure::input)
}

pub fn read(path: &Path) -> Result<Lesson, OpenError> {
    if !is_stdin(path) {
        return Lesson::open(path);
    }
    let text = stdin()?;
    Lesson::read(&String::from_utf8_lossy(&text), None).map_err(|error| OpenError::Lesson {
        path: called(path).to_owned(),
        error,
    })
}

fn summaries() -> String {
    let lessons = LESSONS.iter().map(|lesson| summary(&lesson.lesson()));
    format!("{:#}\n", json!({ "lessons": lessons.collect::<Vec<_>>() }))
}

fn list() -> String {
    let lessons: Vec<Lesson> = LESSONS.iter().map(|lesson| lesson.lesson()).collect();
    let width = widest(lessons.iter().map(|lesson| &lesson.name));
    let line = |lesson: &Lesson| {
        let (name, title) = (&lesson.name, &lesson.title);
        let about = text!(
            "class-about",
            topic = topic_name(&lesson.topic),
            minutes = lesson.minutes
        );
        format!("{name:width$}  {title} ({about})\n")
    };
    lessons.iter().map(line).collect()
}

pub fn question_count(lesson: &Lesson) -> usize {
    let questions = lesson.steps.iter().filter(|step| step.question.is_some());
    questions.count()
}

fn summary(lesson: &Lesson) -> Value {
    json!({
        "name": lesson.name, "title": lesson.title, "topic": lesson.topic, "minutes": lesson.minutes, "about": lesson.about,
        "steps": lesson.steps.len(), "questions": question_count(lesson),
    })
}

fn steps(lesson: &Lesson) -> Value {
    let steps: Vec<Value> = lesson
        .steps
        .iter()
        .map(|step| {
            json!({
                "title": step.title, "scene": step.stage.scene, "lights": step.stage.lights, "panes": step.stage.panes,
                "set": step.stage.set, "view": step.stage.view,
                "question": step.question.as_ref().map(|question| question.kind.name()),
            })
        })
        .collect();
    let mut object = summary(lesson);
    object["steps"] = json!(steps);
    object
}
