//! The dialogs: questions and messages in front of everything else.

use super::film::FilmForm;
use crate::analysis::Format;
use crate::app::widgets::dialog::FileKind;
use crate::figure::QrCode;
use crate::text::text;
use std::path::Path;

/// A dialog of the window.
#[derive(Clone, Debug, PartialEq)]
pub enum Dialog {
    Message {
        title: String,
        text: String,
    },
    /// A question for a file, with the task to be done with it.
    File {
        task: FileTask,
        path: String,
    },
    Code(CodeForm),
    /// The question whether to replace existing files, asked before `then` is accepted.
    Replace {
        names: String,
        then: Box<Self>,
    },
    /// The question whether to save before the window closes.
    Unsaved,
    /// The question whether to restore unsaved work from an earlier run.
    Restore {
        name: String,
    },
    /// The question for the address of the page that links begin with.
    Page(PageForm),
    /// The link to the current view as a QR code, over the whole window.
    LinkCode(LinkCode),
    Scenes,
    Find,
    Manual,
    Keys,
    About,
}

/// The form for the address of the page that links begin with.
#[derive(Clone, Debug, PartialEq)]
pub struct PageForm {
    pub address: String,
    /// The error in the address.
    pub wrong: Option<String>,
    /// True if the QR code is shown afterwards.
    pub then_code: bool,
}

/// A link as a QR code.
#[derive(Clone, Debug, PartialEq)]
pub struct LinkCode {
    pub link: String,
    pub code: QrCode,
    /// The name of a model that the link leaves out.
    pub left_out: Option<String>,
}

/// A task to be done with a file.
#[derive(Clone, Debug, PartialEq)]
pub enum FileTask {
    Open,
    SaveScene,
    Export(ExportForm),
    SaveAnswer(Format),
    /// The answers to a lesson, with the student's name.
    HandIn(String),
    /// The answers of a live class; an existing file is continued.
    #[cfg(feature = "class")]
    Class,
}

/// The settings for exporting a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct ExportForm {
    pub size: [u32; 2],
    /// The width over the height, if a change of one changes the other.
    pub shape: Option<f64>,
    pub samples: u32,
    /// True if the displayed vectors are exported too.
    pub overlay: bool,
    /// The animation of a value, if one is exported.
    pub film: Option<FilmForm>,
    /// The error in the settings.
    pub wrong: Option<String>,
}

/// The form that shows the scene as code, and saves it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CodeForm {
    pub language: Language,
    /// The index of the displayed part of a text in several parts.
    pub part: usize,
    /// The path to save to, while the form asks for it.
    pub path: Option<String>,
    /// The result of the last operation.
    pub message: Option<String>,
}

/// The language in which a scene is shown as code.
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
            #[cfg(feature = "class")]
            Self::Class => (
                text!("wall-file"),
                text!("wall-file.verb"),
                text!("wall-file.kind"),
                &["jsonl"],
                "class.jsonl",
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
    /// Creates a message, for example an error.
    pub fn message(title: &str, text: String) -> Self {
        Self::Message {
            title: title.to_owned(),
            text,
        }
    }

    /// Returns the path that the dialog asks for, and the kind of the file.
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

    /// Closes a question within the dialog; returns whether there was one.
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

    /// Returns whether the dialog asks for a file to open.
    pub fn opens(&self) -> bool {
        matches!(
            self,
            Self::File {
                task: FileTask::Open,
                ..
            }
        )
    }

    /// Appends the usual extension to the name of a file to be written, if the name has none that the program
    /// knows.
    pub fn complete(&mut self) {
        if self.opens() {
            return;
        }
        let Some((path, kind)) = self.file() else {
            return;
        };
        let extension = |path: &str| {
            Path::new(path)
                .extension()
                .map(|ending| ending.to_string_lossy().into_owned())
        };
        let trimmed = path.trim().to_owned();
        let known = extension(&trimmed).is_some_and(|ending| {
            let mut endings = kind.endings.iter();
            kind.endings.is_empty() || endings.any(|known| ending.eq_ignore_ascii_case(known))
        });
        let complete = known || trimmed.ends_with(std::path::is_separator);
        *path = if complete {
            trimmed
        } else {
            format!("{trimmed}.{}", extension(kind.example).unwrap_or_default())
        };
    }
}
