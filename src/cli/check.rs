//! `check`: validates a scene, a model, a picture or a lesson, with a line or JSON as the result.

use super::input::{SceneArguments, called, is_stdin, stdin};
use super::lesson::{question_count, read};
use super::output::{Failure, print, print_json, spinner};
use clap::Args;
use serde_json::{Value, json};
use shading_lab::document::{LoadError, Loaded};
use shading_lab::lesson::{Lesson, LessonProblem, OpenError, check};
use shading_lab::scene::{Choice, ProblemLocation};
use shading_lab::text::{Language, in_language, text};
use std::path::PathBuf;

#[derive(Args)]
pub struct Check {
    #[arg(value_name = "FILE")]
    file: PathBuf,
    #[arg(long, value_name = "KEY=VALUE", allow_hyphen_values = true)]
    set: Vec<String>,
    #[arg(long)]
    json: bool,
}

enum Sound {
    Scene(Box<Loaded>),
    /// The lesson, with remarks on its questions.
    Lesson(Box<Lesson>, Vec<LessonProblem>),
}

impl Check {
    pub fn run(self, earlier: &[String]) -> Result<(), Failure> {
        let name = called(&self.file).display().to_string();
        let found = self.open(earlier);
        if self.json {
            let object = in_language(Language::English, || match &found {
                Ok(sound) => sound.object(&name),
                // Again in this language, since a file's errors are already text.
                Err(_) => match self.open(earlier) {
                    Ok(sound) => sound.object(&name),
                    Err(error) => {
                        json!({ "file": name, "ok": false, "problems": problems(&error) })
                    }
                },
            });
            print_json(&format!("{object:#}\n"))?;
            return found.map(|_| ()).map_err(Failure::input);
        }
        let sound = found.map_err(Failure::input)?;
        print(&(sound.line(&name) + "\n"))
    }

    fn open(&self, earlier: &[String]) -> Result<Sound, OpenError> {
        if self.is_lesson()? {
            let lesson = read(&self.file)?;
            let working = spinner(text!("cli-working"));
            let checked = check(&lesson).map_err(|error| OpenError::Lesson {
                path: called(&self.file).to_owned(),
                error,
            });
            drop(working);
            return checked.map(|remarks| Sound::Lesson(Box::new(lesson), remarks));
        }
        let arguments = SceneArguments {
            source: Some(self.file.clone()),
            set: self.set.clone(),
            material: None,
        };
        Ok(Sound::Scene(Box::new(arguments.load(earlier)?)))
    }

    /// Returns whether the file is a lesson, judging by its name, or by the first line that every lesson has.
    fn is_lesson(&self) -> Result<bool, LoadError> {
        if is_stdin(&self.file) {
            return Ok(stdin()?.starts_with(b"+++"));
        }
        Ok(Lesson::is_file(&self.file))
    }
}

impl Sound {
    fn line(&self, name: &str) -> String {
        match self {
            Self::Lesson(lesson, remarks) => {
                let sound = text!(
                    "cli-check-lesson",
                    name = name,
                    steps = lesson.steps.len(),
                    questions = question_count(lesson)
                );
                let remark = |remark: &LessonProblem| {
                    let LessonProblem { line, words } = remark;
                    format!("\n{name}:{line}: {words}")
                };
                sound + &remarks.iter().map(remark).collect::<String>()
            }
            Self::Scene(loaded) => {
                let scene = &loaded.scene;
                let [width, height] = scene.image.size;
                let polygons =
                    polygons(loaded).map(|count| text!("cli-check-polygons", count = count));
                let materials = names(loaded).join(", ");
                let sound = text!(
                    "cli-check-sound",
                    name = name,
                    object = scene.object.kind.label(),
                    polygons = polygons.unwrap_or_default(),
                    lights = scene.lights.len(),
                    mode = scene.shading.mode.label(),
                    size = format!("{width}×{height}")
                );
                if materials.is_empty() {
                    return sound;
                }
                sound + "\n" + &text!("cli-check-materials", names = materials)
            }
        }
    }

    fn object(&self, name: &str) -> Value {
        let about = match self {
            Self::Lesson(lesson, remarks) => {
                let remark = |remark: &LessonProblem| json!({ "line": remark.line, "message": remark.words });
                let remarks: Vec<Value> = remarks.iter().map(remark).collect();
                json!({
                    "kind": "lesson", "name": lesson.name, "title": lesson.title,
                    "steps": lesson.steps.len(), "questions": question_count(lesson), "remarks": remarks,
                })
            }
            Self::Scene(loaded) => {
                let scene = &loaded.scene;
                json!({
                    "kind": "scene", "warnings": loaded.warnings(), "materials": names(loaded), "object": scene.object.kind, "polygons": polygons(loaded),
                    "lights": scene.lights.len(), "mode": scene.shading.mode, "size": scene.image.size,
                })
            }
        };
        let mut object = json!({ "file": name, "ok": true, "problems": [] });
        if let (Some(all), Value::Object(about)) = (object.as_object_mut(), about) {
            all.extend(about);
        }
        object
    }
}

fn polygons(loaded: &Loaded) -> Option<usize> {
    let model = loaded.model.as_ref()?;
    Some(model.starts.len().saturating_sub(1))
}

/// Returns the names of the model's materials.
fn names(loaded: &Loaded) -> Vec<&str> {
    let materials = loaded.model.iter().flat_map(|model| &model.materials);
    materials.map(|material| material.name.as_str()).collect()
}

/// Returns each problem with its file, line and key, as far as it has them.
fn problems(error: &OpenError) -> Vec<Value> {
    let problem = |file: Option<String>, line: Option<u64>, key: Option<&str>, message: String| json!({ "file": file, "line": line, "key": key, "message": message });
    match error {
        OpenError::Lesson { path, error } => {
            let file = path.display().to_string();
            let all = error.problems.iter();
            all.map(|found| {
                problem(
                    Some(file.clone()),
                    Some(found.line),
                    None,
                    found.words.clone(),
                )
            })
            .collect()
        }
        OpenError::File(LoadError::Scene(error)) => {
            let all = error.problems().iter();
            all.map(|found| {
                let (file, line) = match &found.place {
                    ProblemLocation::Line { file, line } => {
                        (Some(file.clone()), Some(*line as u64))
                    }
                    _ => (None, None),
                };
                let key = Some(&*found.key).filter(|key| !key.is_empty());
                problem(file, line, key, found.words())
            })
            .collect()
        }
        OpenError::File(LoadError::File {
            path,
            line,
            problem: words,
        }) => {
            vec![problem(
                Some(path.display().to_string()),
                *line,
                None,
                words.clone(),
            )]
        }
        error => vec![problem(None, None, None, error.to_string())],
    }
}
