//! The window: controls in the order of the equation, the picture, and its meaning in numbers.
//!
//! [`AppState`] is all that the window remembers; each panel is a function of it. Menus, keys and buttons ask for
//! actions, which are done in one place at the end of the frame. Nothing is drawn again unless something has changed.

mod action;
mod appearance;
mod background;
mod bars;
mod code;
mod commands;
mod compare;
mod controls;
mod course;
mod curves;
mod defects;
mod dialog;
mod dialogs;
mod document;
mod drawing;
mod embed;
mod engine;
mod equation;
mod files;
mod filled;
mod film;
mod focus;
mod handles;
mod heading;
mod layout;
mod letter;
mod lines;
mod links;
mod material;
mod menu;
mod named;
mod notice;
mod orbit;
mod palette;
mod panes;
mod picture;
mod place;
mod plan;
mod point;
mod profile;
mod recovery;
mod report;
mod row;
mod sampling;
mod scan;
mod scenes;
mod sign;
mod stability;
#[cfg_attr(target_arch = "wasm32", path = "app/page/start.rs")]
mod start;
mod state;
mod study;
mod symbol;
#[cfg_attr(target_arch = "wasm32", path = "app/page.rs")]
mod system;
mod table;
mod terms;
mod theme;
mod toast;
mod typeset;
mod views;
mod welcome;

pub use appearance::{Appearance, Overlays, ViewName};
pub use course::{Course, SavedProgress};
pub use document::{CoursePart, Document, Origin};
pub use place::{ProbePoint, ProfileLine};
pub use profile::Profiles;
pub use profile::appearance::ProfileAppearance;
pub use scan::ScanView;
#[cfg(not(target_arch = "wasm32"))]
pub use start::Start;
pub use start::run;
pub use state::AppState;

use crate::document::{Loaded, picture_bytes};
use crate::lesson::Lesson;
use crate::link::is_link;
use crate::render::{Frame, FrameReport, Renderer};
use crate::scene::{Choice as _, presets};
use crate::text::{Language, language, set_language, text};
use action::Action;
use dialog::{CodeForm, Dialog, ExportForm, FileTask};
use document::History;
use eframe::egui::{ColorImage, Context, ThemePreference, Ui, ViewportCommand};
use engine::Engine;
use files::Files;
use layout::Layout;
use picture::Room;
use recovery::Recovery;
use serde::{Deserialize, Serialize};
use state::{Leaving, ViewStates};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use theme::ThemeChoice;

/// Where the window's look is kept between two sessions.
const STORAGE_KEY: &str = "look";

/// What is kept there.
#[derive(Default, Serialize, Deserialize)]
#[serde(default)]
struct Stored {
    #[serde(rename = "look")]
    appearance: Appearance,
    course: SavedProgress,
}

/// The window.
pub struct App {
    state: AppState,
    engine: Engine,
    files: Files,
    layout: Layout,
    room: Room,
    title: String,
    /// Pixels to a point of the letters in memory.
    letters: Option<f32>,
    /// Whether a dialog, or the progress of work on a file, stands in front of everything else: the keys are for that.
    in_front: bool,
    recovery: Option<Recovery>,
    /// The language that this run was started in, and the choice in the menu that it goes before; another choice ends it.
    started_in: Option<(Language, Option<Language>)>,
}

impl App {
    /// A window that shows `loaded`, looking as it did last time.
    pub fn new(cc: &eframe::CreationContext<'_>, loaded: Loaded) -> Self {
        theme::install(&cc.egui_ctx);
        let stored: Option<Stored> = cc
            .storage
            .and_then(|storage| eframe::get_value(storage, STORAGE_KEY));
        // Anybody may have written what was stored.
        let Stored { appearance, course } = stored.unwrap_or_default();
        let mut state = AppState {
            appearance: appearance.sound(),
            course: Course::with(course),
            ..AppState::default()
        };
        // The toolkit stores a scale of its own, which nobody has checked. Set in this way it holds from the first frame on.
        cc.egui_ctx
            .options_mut(|options| options.zoom_factor = state.appearance.scale);
        let shown = loaded.shown.clone();
        state.open(Document::from(loaded));
        state.show(&shown);
        state.history = History::new(state.document.clone());
        Self {
            state,
            engine: Engine::new(),
            files: Files::default(),
            layout: Layout::default(),
            room: Room {
                whole: [1, 1],
                pane: [1, 1],
            },
            title: String::new(),
            letters: None,
            in_front: false,
            recovery: None,
            started_in: None,
        }
    }

    /// The same window, which keeps its unsaved work in a file in `folder` and offers what another left there.
    #[must_use]
    pub fn with_recovery(mut self, folder: &Path) -> Self {
        self.recovery = Recovery::new(folder);
        if let Some((_, name)) = self.recovery.as_ref().and_then(Recovery::left) {
            self.state.dialog = Some(Dialog::Restore { name });
        }
        self
    }

    /// The picture as last drawn.
    pub fn frame(&self) -> &Frame {
        self.engine.frame()
    }

    /// Samples a pixel of the picture in sight; [`Self::frame`] has one.
    pub fn samples(&self) -> u32 {
        self.engine.samples()
    }

    /// What drawing it did.
    pub fn report(&self) -> &FrameReport {
        self.engine.report()
    }

    /// What the window remembers.
    pub fn state(&self) -> &AppState {
        &self.state
    }

    /// The same window, which welcomes whoever has not been here before.
    #[must_use]
    pub fn with_welcome(mut self) -> Self {
        let default = Origin::BuiltIn(presets::DEFAULT.to_owned());
        self.state.welcome =
            !self.state.appearance.welcomed && self.state.document.origin == default;
        // A link may have said where.
        self.state.seek_highlight = self.state.welcome && self.state.probe == ProbePoint::default();
        self
    }

    /// The same window in a lesson, where there is one; `seed` decides what is drawn at random in it.
    #[must_use]
    pub fn with_lesson(mut self, lesson: Option<Lesson>, seed: Option<u64>) -> Self {
        self.state.course.seed = seed.unwrap_or(self.state.course.seed);
        if let Some(lesson) = lesson {
            let built_in = lesson.folder.is_none();
            self.state.open_lesson(Arc::new(lesson), built_in);
        }
        self
    }

    /// The same window, whose links begin with `page` from now on, where one is named.
    #[must_use]
    pub fn with_page(mut self, page: Option<String>) -> Self {
        self.state.appearance.page = page.unwrap_or(self.state.appearance.page);
        self
    }

    /// The same window in `language`, where there is one, until another is chosen in its menu; it is not remembered.
    #[must_use]
    pub fn in_language(mut self, language: Option<Language>) -> Self {
        self.started_in = language.map(|language| (language, self.state.appearance.language));
        self
    }

    fn panels(&mut self, ui: &mut Ui) {
        let Self {
            state,
            engine,
            layout,
            ..
        } = self;
        if state.embedded.is_some() {
            self.room = embed::embedded_ui(ui, state, engine);
            state.room = self.room.whole;
            state.commit();
            return;
        }
        let known = layout.picture.is_some();
        if let Some(room) = layout.ui(ui, state, engine) {
            (self.room, state.room) = (room, room.whole);
            if !known {
                // How high the strips above the picture are is known only now. To lay out again at once is faster than a
                // frame that jumps.
                ui.ctx().request_discard("layout");
            }
            if let Some(picture) = layout.picture {
                welcome::welcome_ui(ui.ctx(), state, picture);
            }
        }
        self.state.commit();
    }

    fn settle(&mut self, ctx: &Context) {
        let asked = std::mem::take(&mut self.state.asked);
        if !asked.is_empty() {
            ctx.request_repaint();
        }
        for action in asked {
            let rest = self.state.perform(action, self.room.pane);
            self.state.commit();
            if let Some(rest) = rest {
                self.perform(ctx, rest);
            }
        }
        let (held, time) = ctx.input(|input| (input.pointer.any_down(), input.time));
        let held = held || self.state.gliding.is_some();
        self.state.history.observe(&self.state.document, held, time);
        if self.state.lit.turn() {
            ctx.request_repaint();
        }
        self.show_look(ctx);
        if let Some(recovery) = &mut self.recovery {
            recovery.keep(ctx, &mut self.state);
        }
    }

    /// Whether the window may close now; asks otherwise.
    fn may_close(&mut self) -> bool {
        let may = self.state.leaving == Leaving::Now || !self.state.modified();
        if !may {
            self.state.dialog = Some(Dialog::Unsaved);
        } else if let Some(recovery) = &mut self.recovery {
            recovery.forget();
        }
        may
    }

    /// Closes the window, whatever is unsaved.
    fn close(&mut self, ctx: &Context) {
        self.state.leaving = Leaving::Now;
        ctx.send_viewport_cmd(ViewportCommand::Close);
    }

    fn show_look(&mut self, ctx: &Context) {
        ctx.set_theme(match self.state.appearance.theme {
            ThemeChoice::System => ThemePreference::System,
            ThemeChoice::Dark => ThemePreference::Dark,
            ThemeChoice::Light => ThemePreference::Light,
        });
        // In points of the screen, rounded: what is shown must not depend on the last digit.
        let size = (ctx.content_rect().size() * ctx.zoom_factor()).round();
        ctx.set_zoom_factor(self.state.appearance.zoom(size.y));
        theme::forget_letters(ctx, &mut self.letters);
        let fingers = system::fingers(ctx);
        theme::touch(ctx, fingers || size.x < theme::NARROW);
        let chosen = self.state.appearance.language;
        self.started_in = self.started_in.filter(|(_, before)| *before == chosen);
        let wanted = self
            .started_in
            .map(|(language, _)| language)
            .or(chosen)
            .unwrap_or_else(Language::of_system);
        if wanted != language() {
            set_language(wanted);
            // What views have worked out holds text.
            self.state.own = ViewStates::default();
            self.state.translate_lesson();
            ctx.request_repaint();
        }
        let mark = if self.state.modified() { "*" } else { "" };
        let title = format!("{}{mark} — shading-lab", self.state.document.origin.name());
        if title != self.title {
            system::set_title(ctx, &title);
            self.title = title;
        }
    }

    /// Does what needs the window, files or the clipboard.
    fn perform(&mut self, ctx: &Context, action: Action) {
        match action {
            Action::Open => self.ask_file(ctx, FileTask::Open, String::new()),
            Action::OpenFile(path) => match path.to_str() {
                Some(text) if is_link(text) => self.state.open_link(text),
                _ => self.files.open(ctx, path),
            },
            Action::OpenLink(text) => self.state.open_link(&text),
            Action::CopyLink => self.state.copy_link(ctx),
            Action::OpenPage => self.state.open_page(ctx),
            Action::ShowCode => self.state.show_code(),
            Action::Page => self.state.ask_page(false),
            Action::OpenBuiltIn(name) => {
                if let Some(document) = Document::built_in(&name) {
                    self.state.open(document);
                    self.state.seek_highlight = true;
                }
            }
            Action::Save => match self.state.document.scene_file() {
                Some(path) => self.save(ctx, path),
                None => self.perform(ctx, Action::SaveAs),
            },
            Action::SaveAs => {
                let path = self.state.document.suggested("toml");
                self.ask_file(ctx, FileTask::SaveScene, path);
            }
            Action::SaveTo(path) => self.save(ctx, path),
            Action::Export => {
                // The one thread of a page on a phone takes long for more.
                let phone = system::PAGE && system::fingers(ctx);
                let form = ExportForm {
                    size: [1920, 1080],
                    shape: None,
                    samples: if phone { 4 } else { 16 },
                    overlay: true,
                    film: None,
                    wrong: None,
                };
                let path = self.state.document.suggested("png");
                self.ask_file(ctx, FileTask::Export(form), path);
            }
            Action::CopyPicture => self.copy_picture(ctx),
            Action::SaveAnswer(name, format) => {
                let path = format!("{name}.{}", format.word());
                self.ask_file(ctx, FileTask::SaveAnswer(format), path);
            }
            Action::Code => self.state.dialog = Some(Dialog::Code(CodeForm::default())),
            Action::Scenes => self.state.dialog = Some(Dialog::Scenes),
            Action::NextScene(step) => {
                let name = self.state.scene_after(step).to_owned();
                self.perform(ctx, Action::OpenBuiltIn(name));
            }
            Action::Keys => self.state.dialog = Some(Dialog::Keys),
            Action::About => self.state.dialog = Some(Dialog::About),
            Action::PictureAlone => {
                self.state.picture_alone = !self.state.picture_alone;
                system::set_fullscreen(ctx, self.state.picture_alone);
            }
            Action::ResetRow => focus::ask_reset(ctx),
            Action::TakeProbe => focus::take(ctx, focus::picture_id()),
            Action::Menus => focus::take_first(ctx),
            Action::HandIn => match self.state.course.to_hand_in() {
                Some((lesson, _)) => {
                    let name = self.state.course.kept.name.clone();
                    let path = std::path::absolute(format!("{}.png", lesson.name));
                    let path =
                        path.map_or_else(|_| String::new(), |path| path.display().to_string());
                    self.ask_file(ctx, FileTask::HandIn(name), path);
                }
                None => {
                    let words = text!("course-hand-in-nothing").to_owned();
                    self.state.dialog = Some(Dialog::message(text!("course-hand-in"), words));
                }
            },
            Action::LoadStage => self.files.load_stage(ctx, &self.state),
            Action::Quit if self.may_close() => self.close(ctx),
            Action::CloseUnsaved => self.close(ctx),
            Action::Restore => {
                if let Some((path, _)) = self.recovery.as_ref().and_then(Recovery::left) {
                    self.files.restore(ctx, path.to_owned());
                }
            }
            Action::AdoptRestored => self.recovery.iter_mut().for_each(Recovery::adopt),
            Action::DeleteLeft => self.recovery.iter_mut().for_each(Recovery::delete),
            // What is left concerns the state alone and has been done.
            _ => {}
        }
    }

    /// Asks for a file; a page asks only how a picture is to be exported, since it downloads what it writes.
    fn ask_file(&mut self, ctx: &Context, task: FileTask, path: String) {
        let asks = !system::PAGE || matches!(task, FileTask::Export(_) | FileTask::HandIn(_));
        let dialog = Dialog::File { task, path };
        if asks {
            self.state.dialog = Some(dialog);
        } else {
            dialogs::perform(ctx, &mut self.state, &mut self.files, dialog);
        }
    }

    fn save(&mut self, ctx: &Context, path: PathBuf) {
        let leaving = std::mem::take(&mut self.state.leaving);
        match crate::document::save_scene(&path, &self.state.document.scene) {
            Ok(()) => {
                let origin = Origin::File(path.clone());
                if self.state.document.origin != origin {
                    self.state.opened = self.state.document.scene.clone();
                    self.state.appearance.remember(&path);
                    self.state.activate(self.state.panes.active);
                }
                self.state.document.origin = origin;
                self.state.notice = Some(text!("saved", path = path.display().to_string()));
                self.state.saved = self.state.document.clone();
                self.state.begin();
                if leaving == Leaving::OnceSaved {
                    self.close(ctx);
                }
            }
            Err(error) => {
                self.state.dialog = Some(Dialog::message(text!("not-saved"), error.to_string()));
            }
        }
    }

    fn copy_picture(&mut self, ctx: &Context) {
        let Document { scene, model, .. } = &self.state.document;
        let mut scene = scene.clone();
        scene.image.size = self.room.whole;
        let mut renderer = Renderer::default();
        renderer.set_model(model.clone());
        let over = files::Over::new(&self.state);
        let Some(frame) = files::picture(&mut renderer, &scene, 1, Some(&over), &mut |_| true)
        else {
            return;
        };
        let size = [frame.width as usize, frame.height as usize];
        ctx.copy_image(ColorImage::from_rgba_unmultiplied(
            size,
            frame.pixels.as_flattened(),
        ));
        self.state.notice = Some(text!("copied-picture").to_owned());
    }
}

impl eframe::App for App {
    fn logic(&mut self, ctx: &Context, _: &mut eframe::Frame) {
        if ctx.input(|input| input.viewport().close_requested()) && !self.may_close() {
            // A window that is hidden has to come up to ask.
            for command in [
                ViewportCommand::CancelClose,
                ViewportCommand::Minimized(false),
                ViewportCommand::Focus,
            ] {
                ctx.send_viewport_cmd(command);
            }
        }
    }

    fn ui(&mut self, ui: &mut Ui, _: &mut eframe::Frame) {
        let ctx = ui.ctx().clone();
        system::begin_frame(&ctx);
        for path in system::dropped(&ctx) {
            self.state.ask(Action::OpenFile(path));
        }
        self.state.glide(&ctx);
        focus::listen(&ctx, self.in_front);
        if !self.in_front && self.state.embedded.is_none() {
            commands::listen(&ctx, &mut self.state);
        }
        self.panels(ui);
        self.files.poll(&ctx, &mut self.state);
        toast::toast_ui(&ctx, &mut self.state);
        dialogs::dialog_ui(&ctx, &mut self.state, &mut self.files);
        self.settle(&ctx);
        // What has come to stand in front takes the focus from what is behind it.
        let in_front = self.state.dialog.is_some() || self.files.progress().is_some();
        if in_front && !self.in_front {
            ctx.memory_mut(|memory| memory.stop_text_input());
        }
        self.in_front = in_front;
        focus::show(&ctx);
        links::open_addresses(&ctx);
        let (state, engine) = (&self.state, &self.engine);
        system::end_frame(
            &ctx,
            self.recovery.is_some() && state.modified(),
            || state.link().ok().map(|written| written.link),
            || picture_bytes(engine.frame(), Some(&state.document.scene)).ok(),
        );
    }

    fn save(&mut self, storage: &mut dyn eframe::Storage) {
        if self.state.embedded.is_some() {
            return;
        }
        eframe::set_value(
            storage,
            STORAGE_KEY,
            &Stored {
                appearance: self.state.appearance.clone(),
                course: self.state.course.kept.clone(),
            },
        );
    }
}
