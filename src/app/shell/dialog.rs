//! What is asked or told in front of everything else, and the widgets that all dialogs share.

use super::film::FilmForm;
use crate::analysis::Format;
use crate::app::widgets::focus::named;
use crate::app::widgets::theme::text_field;
use crate::figure::QrCode;
use crate::text::text;
use eframe::egui::accesskit::Role;
use eframe::egui::{Button, Key, Label, RichText, ScrollArea, Ui};
use std::path::{Path, PathBuf};

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

/// The kind of file that a dialog asks for.
pub struct FileKind {
    pub title: &'static str,
    /// What the button says.
    pub verb: &'static str,
    /// What the desktop's own dialog calls such files.
    pub files: &'static str,
    /// What their names may end in; anything where empty.
    pub endings: &'static [&'static str],
    /// A name with the usual ending.
    pub example: &'static str,
}

/// What became of the desktop's own dialog for a file.
pub enum Picked {
    #[cfg_attr(
        target_arch = "wasm32",
        allow(dead_code, reason = "a page has no paths")
    )]
    File(PathBuf),
    /// It was cancelled.
    Nothing,
    /// The desktop has none.
    NoDialog,
}

/// What the user has decided.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Choice {
    Stay,
    Leave,
    Accept,
    /// The desktop's own dialog for the file.
    Browse,
    /// To the question before.
    Back,
    /// Leave, and let go of what the question is about.
    Discard,
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

/// Two names in one sentence.
pub fn both(first: String, second: String) -> String {
    text!("and", first = first, second = second)
}

/// A question or a message with a button for each answer; Enter gives the only one.
pub fn question_ui(ui: &mut Ui, title: &str, text: &str, answers: &[(&str, Choice)]) -> Choice {
    ui.heading(title);
    ui.add_space(8.0);
    ScrollArea::vertical()
        .max_height(320.0)
        .show(ui, |ui| ui.label(text));
    ui.add_space(12.0);
    let enter = answers.len() == 1 && ui.input(|input| input.key_pressed(Key::Enter));
    let given = |ui: &mut Ui, answer: &str| ui.button(answer).clicked() || enter;
    let chosen = ui.horizontal(|ui| {
        answers
            .iter()
            .filter(|(answer, _)| given(ui, answer))
            .last()
    });
    chosen.inner.map_or(Choice::Stay, |(_, choice)| *choice)
}

/// A field for a path, with the desktop's dialog a button away; where there turned out to be none, it says so. Accepts when Enter is
/// pressed in it.
pub fn path_ui(ui: &mut Ui, path: &mut String, hint: &str, no_dialog: bool) -> Choice {
    let mut choice = Choice::Stay;
    ui.horizontal(|ui| {
        let field = text_field(path)
            .hint_text(hint)
            .desired_width((ui.available_width() - 92.0).max(0.0));
        let field = named(ui.add(field), Role::TextInput, text!("file"));
        if field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter)) {
            choice = Choice::Accept;
        } else if !field.has_focus() && ui.memory(|memory| memory.focused().is_none()) {
            field.request_focus();
        }
        if ui
            .button(text!("browse"))
            .on_hover_text(text!("browse-tip"))
            .clicked()
        {
            choice = Choice::Browse;
        }
    });
    if no_dialog {
        let words = RichText::new(text!("browse-none")).color(ui.visuals().error_fg_color);
        ui.add(Label::new(words).wrap());
    }
    choice
}

/// The buttons below a path; what `entered` chose holds where the path is `ready`.
pub fn buttons_ui(
    ui: &mut Ui,
    verb: &str,
    back: (&str, Choice),
    ready: bool,
    entered: Choice,
) -> Choice {
    let mut choice = if entered == Choice::Accept && !ready {
        Choice::Stay
    } else {
        entered
    };
    ui.horizontal(|ui| {
        if ui.add_enabled(ready, Button::new(verb)).clicked() {
            choice = Choice::Accept;
        }
        if ui.button(back.0).clicked() {
            choice = back.1;
        }
    });
    choice
}
