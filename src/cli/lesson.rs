//! `lesson`: the lessons that there are, one in words, or its worksheet.

use super::output::{Failure, print, progress_bar};
use clap::Args;
use clap::builder::{PathBufValueParser, TypedValueParser};
use serde_json::{Value, json};
use shading_lab::document::{check_target, write_whole};
use shading_lab::lesson::{
    LESSONS, Lesson, LessonError, OpenError, Worksheet, find, in_words, topic_name, worksheet,
};
use shading_lab::scene::nearest;
use shading_lab::text::text;
use std::path::{Path, PathBuf};

/// Samples a pixel of a worksheet's pictures.
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

/// The name of a page: its ending says HTML, or it is a device or a pipe.
pub fn page_name() -> impl TypedValueParser<Value = PathBuf> {
    PathBufValueParser::new().try_map(|path| {
        let ending = path
            .extension()
            .map(|ending| ending.to_string_lossy().to_lowercase());
        let page = ending.is_some_and(|ending| ending == "html" || ending == "htm");
        if page || super::input::is_device(&path) {
            Ok(path)
        } else {
            Err(text!("cli-expected-html"))
        }
    })
}

impl LessonCommand {
    pub fn run(self) -> Result<(), Failure> {
        let Some(name) = &self.lesson else {
            return print(&list(self.json));
        };
        if let Some(target) = &self.output {
            check_target(target)?;
        }
        let lesson = open(name)?;
        let wrong = |error: LessonError| {
            Failure::input(OpenError::Lesson {
                path: name.clone(),
                error,
            })
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
            bar.finish_and_clear();
            return Ok(write_whole(target, |out| out.write_all(page.as_bytes()))?);
        }
        if self.json {
            return print(&format!("{:#}\n", steps(&lesson)));
        }
        print(&in_words(&lesson, self.seed, answers).map_err(wrong)?)
    }
}

/// A built-in lesson or a file.
pub fn open(name: &Path) -> Result<Lesson, Failure> {
    if let Some(lesson) = name.to_str().and_then(find) {
        return Ok(lesson.lesson());
    }
    if name.extension().is_some_and(|ending| ending == "md") {
        return Lesson::open(name).map_err(Failure::input);
    }
    let name: String = name.to_string_lossy().escape_debug().collect();
    let meant = nearest(&name, LESSONS.iter().map(|lesson| lesson.name));
    let meant = meant.map(|meant| text!("document-did-you-mean", name = meant));
    Err(Failure::input(text!(
        "cli-no-lesson",
        name = name,
        meant = meant.unwrap_or_default()
    )))
}

fn list(as_json: bool) -> String {
    let lessons: Vec<Lesson> = LESSONS.iter().map(|lesson| lesson.lesson()).collect();
    if as_json {
        let lessons: Vec<Value> = lessons.iter().map(summary).collect();
        return format!("{:#}\n", json!({ "lessons": lessons }));
    }
    let width = lessons
        .iter()
        .map(|lesson| lesson.name.len())
        .max()
        .unwrap_or(0);
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

fn summary(lesson: &Lesson) -> Value {
    let questions = lesson.steps.iter().filter(|step| step.question.is_some());
    json!({
        "name": lesson.name, "title": lesson.title, "topic": lesson.topic, "minutes": lesson.minutes, "about": lesson.about,
        "steps": lesson.steps.len(), "questions": questions.count(),
    })
}

fn steps(lesson: &Lesson) -> Value {
    let steps: Vec<Value> = lesson
        .steps
        .iter()
        .map(|step| {
            json!({
                "title": step.title, "scene": step.stage.scene, "set": step.stage.set, "view": step.stage.view,
                "question": step.question.as_ref().map(|question| question.kind.name()),
            })
        })
        .collect();
    let mut object = summary(lesson);
    object["steps"] = json!(steps);
    object
}
