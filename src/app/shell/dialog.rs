//! What is asked or told in front of everything else.

use super::film::FilmForm;
use crate::analysis::Format;
use crate::app::widgets::dialog::FileKind;
use crate::figure::QrCode;
use crate::text::text;
use std::path::Path;

/// A dialog.
#[derive(Clone, Debug, PartialEq)]
pub enum Dialog {
    Message {
        title: String,
        text: String,
    },
    /// Asks for a file, and what is to be done with it.
    File {
        task: FileTask,
        path: String,
    },
    Code(CodeForm),
    /// Whether to replace files that exist, before what another dialog asks for is done.
    Replace {
        names: String,
        then: Box<Self>,
    },
    /// Whether to save before the window closes.
    Unsaved,
    /// Whether to restore unsaved work that was left behind.
    Restore {
        name: String,
    },
    /// Asks for the address of the page that links begin with.
    Page(PageForm),
    /// The link of what is seen, over the whole window.
    LinkCode(LinkCode),
    Scenes,
    Keys,
    About,
}

/// The address of the page that links begin with, as it is typed.
#[derive(Clone, Debug, PartialEq)]
pub struct PageForm {
    pub address: String,
    /// What is wrong with it.
    pub wrong: Option<String>,
    /// Whether the QR code is shown then.
    pub then_code: bool,
}

/// A link as a QR code.
#[derive(Clone, Debug, PartialEq)]
pub struct LinkCode {
    pub link: String,
    pub code: QrCode,
    /// The name of a model that the link says nothing of.
    pub left_out: Option<String>,
}

/// What is to be done with a file.
#[derive(Clone, Debug, PartialEq)]
pub enum FileTask {
    Open,
    SaveScene,
    Export(ExportForm),
    SaveAnswer(Format),
    /// The answers to a lesson, by whom.
    HandIn(String),
}

/// How a picture is to be exported.
#[derive(Clone, Debug, PartialEq)]
pub struct ExportForm {
    pub size: [u32; 2],
    /// Width over height, while a change of one changes the other.
    pub shape: Option<f64>,
    pub samples: u32,
    /// With the vectors as they are shown.
    pub overlay: bool,
    /// A value that changes from frame to frame.
    pub film: Option<FilmForm>,
    /// What is wrong with that.
    pub wrong: Option<String>,
}

/// Which text of the scene as code is looked at, and what is done with it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CodeForm {
    pub language: Language,
    /// Of a text in several parts, the one that is shown.
    pub part: usize,
    /// Where it is to be saved, while that is asked.
    pub path: Option<String>,
    /// What was last done, or why it was not.
    pub message: Option<String>,
}

/// In which language a scene is shown as code.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Language {
    #[default]
    Calls,
    Shaders,
    Program,
}

impl FileTask {
    pub fn file_kind(&self) -> FileKind {
        let (title, verb, files, endings, example): (_, _, _, &[_], _) = match self {
            Self::Open => (
                text!("file-open"),
                text!("open"),
                text!("file-open-kinds"),
                &["toml", "obj", "png", "md"],
                text!("file-open-example"),
            ),
            Self::SaveScene => (
                text!("file-save"),
                text!("save"),
                text!("file-scene"),
                &["toml"],
                "scene.toml",
            ),
            Self::Export(form) => (
                text!("file-export"),
                text!("export"),
                text!("file-picture"),
                if form.film.is_some() {
                    &["png", "apng", "gif"]
                } else {
                    &["png"]
                },
                "picture.png",
            ),
            Self::HandIn(_) => (
                text!("course-hand-in"),
                text!("course-hand-in.verb"),
                text!("file-picture"),
                &["png"],
                "answers.png",
            ),
            Self::SaveAnswer(format) => {
                let example = match format {
                    Format::Json => "analysis.json",
                    Format::Csv => "analysis.csv",
                    Format::Png => "analysis.png",
                    Format::Svg => "analysis.svg",
                };
                (
                    text!("file-analysis"),
                    text!("save"),
                    text!("file-analysis-kind"),
                    &["csv", "png", "svg", "json"],
                    example,
                )
            }
        };
        FileKind {
            title,
            verb,
            files,
            endings,
            example,
        }
    }
}

impl Language {
    pub fn file_kind(self) -> FileKind {
        let example = if self == Self::Shaders {
            "scene.vert"
        } else {
            "scene.c"
        };
        FileKind {
            title: text!("file-code"),
            verb: text!("save"),
            files: text!("file-code-kind"),
            endings: &[],
            example,
        }
    }
}

impl Dialog {
    /// A message, for example an error.
    pub fn message(title: &str, text: String) -> Self {
        Self::Message {
            title: title.to_owned(),
            text,
        }
    }

    /// The path that it asks for, and the kind of the file.
    pub fn file(&mut self) -> Option<(&mut String, FileKind)> {
        match self {
            Self::File { task, path } => Some((path, task.file_kind())),
            Self::Code(CodeForm {
                path: Some(path),
                language,
                ..
            }) => Some((path, language.file_kind())),
            _ => None,
        }
    }

    /// Leaves a question within the dialog; tells whether there was one.
    pub fn step_back(&mut self) -> bool {
        match self {
            Self::Code(form) => form.path.take().is_some(),
            Self::Replace { then, .. } => {
                *self = std::mem::replace(&mut **then, Self::About);
                true
            }
            _ => false,
        }
    }

    /// Gives the file that is to be written the usual ending, where its name has none that the program knows.
    pub fn complete(&mut self) {
        if matches!(
            self,
            Self::File {
                task: FileTask::Open,
                ..
            }
        ) {
            return;
        }
        let Some((
            path,
            FileKind {
                endings, example, ..
            },
        )) = self.file()
        else {
            return;
        };
        let extension = |path: &str| {
            Path::new(path)
                .extension()
                .map(|ending| ending.to_string_lossy().into_owned())
        };
        let trimmed = path.trim().to_owned();
        let known = extension(&trimmed).is_some_and(|ending| {
            endings.is_empty()
                || endings
                    .iter()
                    .any(|known| ending.eq_ignore_ascii_case(known))
        });
        let complete = known || trimmed.ends_with(std::path::is_separator);
        *path = if complete {
            trimmed
        } else {
            format!("{trimmed}.{}", extension(example).unwrap_or_default())
        };
    }
}
