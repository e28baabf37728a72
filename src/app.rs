//! The window: controls in the order of the equation, the picture, and views that show its values as numbers.
//!
//! [`AppState`] holds everything that the window remembers: a session, its appearance, and the course. Each
//! panel is a function of the parts that it needs. Menus, keys and buttons request actions, which run in one
//! place at the end of the frame. The window redraws only what has changed.

mod controls;
mod course;
mod engine;
mod picture;
mod session;
mod shell;
#[cfg_attr(target_arch = "wasm32", path = "app/start/page.rs")]
mod start;
mod stored;
#[cfg_attr(target_arch = "wasm32", path = "app/page.rs")]
mod system;
mod views;
mod widgets;

pub use course::{Course, SavedProgress};
pub use session::appearance::profile::ProfileAppearance;
pub use session::appearance::{Appearance, Overlays, ViewName};
pub use session::document::{CoursePart, Document, Origin};
pub use session::place::{ProbePoint, ProfileLine};
pub use shell::state::AppState;
#[cfg(not(target_arch = "wasm32"))]
pub use start::Start;
pub use start::run;
pub use views::profile::Profiles;
pub use views::scan::ScanView;

#[cfg(feature = "class")]
use crate::class::Live;
use crate::document::{Loaded, picture_bytes};
use crate::lesson::Lesson;
use crate::link::is_link;
use crate::render::{Frame, FrameReport, Renderer};
use crate::scene::{Choice as _, presets};
use crate::text::{Language, language, set_language, text};
use controls::scenes::scene_after;
use eframe::egui::panel::PanelState;
use eframe::egui::util::IdTypeMap;
use eframe::egui::{ColorImage, Context, ThemePreference, Ui, ViewportCommand};
use engine::Engine;
use picture::Room;
use session::action::Action;
#[cfg(feature = "class")]
use session::action::ClassAction;
use session::notice::Notice;
use session::recovery::Recovery;
use session::window::{Figure, ViewStates};
use shell::dialog::{CodeForm, Dialog, ExportForm, FileTask};
use shell::files::Files;
use shell::layout::Layout;
use shell::state::Leaving;
use shell::{commands, dialogs, embed, files, links, toast};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use stored::Stored;
use widgets::symbol::{self, Sought};
use widgets::theme::ThemeChoice;
use widgets::{fingers, focus, theme};

/// The application window.
pub struct App {
    state: AppState,
    engine: Engine,
    files: Files,
    layout: Layout,
    room: Room,
    title: String,
    /// The pixels per point of the cached glyphs.
    letters: Option<f32>,
    /// True if a dialog, or the progress of work on a file, is in front of everything else and receives the
    /// keys.
    in_front: bool,
    recovery: Option<Recovery>,
    /// True if nothing is read from earlier runs and nothing is stored.
    fresh: bool,
    /// A folder that the desktop is to show at the end of the frame.
    folder: Option<PathBuf>,
    /// The language given at startup, and the menu's choice that it overrides. A different choice in the menu
    /// ends the override.
    started_in: Option<(Language, Option<Language>)>,
}

impl App {
    /// Creates a window that shows `loaded`, with the appearance of the last run.
    pub fn new(cc: &eframe::CreationContext<'_>, loaded: Loaded) -> Self {
        // A language that another window chooses does not reach this one.
        set_language(language());
        theme::install(&cc.egui_ctx);
        cc.egui_ctx
            .add_plugin(fingers::Fingers::new(system::coarse()));
        let Stored { appearance, course } = cc.storage.map(Stored::read).unwrap_or_default();
        let mut state = AppState::default();
        state.window.appearance = appearance.sound();
        state.course = Course::with(course);
        // egui stores an unchecked scale of its own. Set through the options, this one holds from the first
        // frame on.
        cc.egui_ctx
            .options_mut(|options| options.zoom_factor = state.window.appearance.scale);
        let shown = loaded.shown.clone();
        state.open(Document::from(loaded));
        state.show(&shown);
        state.session.begin();
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
            fresh: false,
            folder: None,
            started_in: None,
        }
    }

    /// Saves unsaved work to a file in `folder` from now on, and offers to restore the work that another run
    /// left there.
    #[must_use]
    pub fn with_recovery(mut self, folder: &Path) -> Self {
        self.recovery = Recovery::new(folder);
        let shown = &self.state.session.document().scene;
        match &mut self.recovery {
            // A page that is loaded again goes on where it was.
            Some(recovery) if system::reloaded() || recovery.is_left(shown) => {
                self.state.requests.ask(Action::Restore);
            }
            Some(recovery) => {
                if let Some((_, name)) = recovery.left() {
                    self.state.dialog = Some(Dialog::Restore { name });
                }
            }
            None => {}
        }
        self
    }

    /// Returns the last drawn picture.
    pub fn frame(&self) -> &Frame {
        self.engine.frame()
    }

    /// Returns the samples per pixel of the displayed picture; [`Self::frame`] has one.
    pub fn samples(&self) -> u32 {
        self.engine.samples()
    }

    /// Returns the report of the last drawn picture.
    pub fn report(&self) -> &FrameReport {
        self.engine.report()
    }

    /// Returns the state of the window.
    pub fn state(&self) -> &AppState {
        &self.state
    }

    /// Welcomes first-time users, if the default scene is open. In a built-in scene, puts the probe beside the highlight.
    #[must_use]
    pub fn with_welcome(mut self) -> Self {
        let default = Origin::BuiltIn(presets::DEFAULT.to_owned());
        self.state.window.welcome = !self.state.window.appearance.welcomed
            && self.state.session.document().origin == default;
        // A link may have placed the probe.
        self.state.window.seek_highlight = self.state.window.probe == ProbePoint::default()
            && self.state.session.document().is_built_in();
        self
    }

    /// Opens `lesson`, if there is one; `seed` decides what is drawn at random in it.
    #[must_use]
    pub fn with_lesson(mut self, lesson: Option<Lesson>, seed: Option<u64>) -> Self {
        self.state.course.seed = seed.unwrap_or(self.state.course.seed);
        if let Some(lesson) = lesson {
            let built_in = lesson.folder.is_none();
            self.state.open_lesson(Arc::new(lesson), built_in);
        }
        self
    }

    /// Shows a live class that has been started.
    #[cfg(feature = "class")]
    pub fn teach(&mut self, ctx: &Context, class: Live) {
        self.state.teach(ctx, class);
    }

    /// Makes links begin with `page` from now on, if it is given.
    #[must_use]
    pub fn with_page(mut self, page: Option<String>) -> Self {
        self.state.window.appearance.page = page.unwrap_or(self.state.window.appearance.page);
        self
    }

    /// Forgets everything that earlier runs stored, and stores nothing for the next one.
    #[must_use]
    pub fn fresh(mut self, ctx: &Context) -> Self {
        ctx.data_mut(IdTypeMap::clear);
        self.state.window.appearance = Appearance::default();
        self.state.course = Course::default();
        self.fresh = true;
        self
    }

    /// Sets the language, if it is given, until another is chosen in the menu. The language is not stored.
    #[must_use]
    pub fn in_language(mut self, language: Option<Language>) -> Self {
        self.started_in =
            language.map(|language| (language, self.state.window.appearance.language));
        self
    }

    /// Makes the window a figure embedded in another page, with the given controls. Except for theme and
    /// language its appearance is the default, and it is not stored.
    #[must_use]
    pub fn embedded(mut self, controls: &[String]) -> Self {
        let Appearance {
            theme, language, ..
        } = self.state.window.appearance;
        self.state.window.appearance = Appearance {
            theme,
            language,
            welcomed: true,
            ..Appearance::default()
        };
        self.state.window.welcome = false;
        self.state.window.embedded = Some(Figure {
            controls: controls.to_vec(),
            problem: None,
        });
        self
    }

    /// Shows everything but dialogs and messages.
    fn panels(&mut self, ui: &mut Ui) {
        let Self {
            state,
            engine,
            layout,
            ..
        } = self;
        let known = layout.picture.is_some();
        let room = if state.window.embedded.is_some() {
            let (session, course) = (&mut state.session, &mut state.course);
            let (window, requests) = (&mut state.window, &mut state.requests);
            embed::embedded_ui(ui, session, window, course, requests, engine)
        } else {
            layout.ui(ui, state, engine)
        };
        if let Some(room) = room {
            (self.room, state.window.room) = (room, room.whole);
        }
        if !known && layout.picture.is_some() {
            // The height of the bars above the picture is known only now. Repeating the layout at once is faster
            // than a frame that jumps.
            ui.ctx().request_discard("layout");
        }
    }

    /// Performs the actions requested in this frame, and whatever follows them.
    fn settle(&mut self, ctx: &Context) {
        let asked = self.state.requests.take();
        if !asked.is_empty() {
            ctx.request_repaint();
        }
        self.state.follow_lock();
        for action in asked {
            let rest = self.state.perform(action, self.room.pane);
            self.state.session.commit();
            if let Some(rest) = rest {
                self.perform(ctx, rest);
            }
            self.state.follow_lock();
        }
        let (held, time) = ctx.input(|input| (input.pointer.any_down(), input.time));
        let held = held || self.state.course.gliding.is_some();
        self.state.session.observe(held, time);
        if symbol::turn(ctx) {
            ctx.request_repaint();
        }
        self.show_appearance(ctx);
        if let Some(recovery) = &mut self.recovery {
            let AppState {
                session,
                window,
                leaving,
                ..
            } = &mut self.state;
            recovery.keep(ctx, session, window, *leaving == Leaving::Now);
        }
    }

    /// Returns whether the window may close now; if not, asks about the unsaved work.
    fn may_close(&mut self) -> bool {
        let may = self.state.leaving == Leaving::Now || !self.state.session.modified();
        if !may {
            self.state.dialog = Some(Dialog::Unsaved);
        } else if let Some(recovery) = &mut self.recovery {
            recovery.forget();
        }
        may
    }

    /// Returns whether leaving the page now would lose work: work that is not kept, or whose model is a file of its own.
    fn would_lose(&self) -> bool {
        let session = &self.state.session;
        let kept = self.recovery.is_some() && session.document().model.is_none();
        session.modified() && !kept && self.state.window.embedded.is_none()
    }

    /// Closes the window and discards unsaved work.
    fn close(&mut self, ctx: &Context) {
        self.state.leaving = Leaving::Now;
        ctx.send_viewport_cmd(ViewportCommand::Close);
    }

    fn show_appearance(&mut self, ctx: &Context) {
        ctx.set_theme(match self.state.window.appearance.theme {
            ThemeChoice::System => ThemePreference::System,
            ThemeChoice::Dark => ThemePreference::Dark,
            ThemeChoice::Light => ThemePreference::Light,
        });
        // In points of the screen, rounded, so that the layout does not depend on the last digit.
        let size = (ctx.content_rect().size() * ctx.zoom_factor()).round();
        ctx.set_zoom_factor(self.state.window.appearance.zoom(size.y));
        theme::forget_letters(ctx, &mut self.letters);
        let fingers = system::fingers(ctx);
        theme::touch(ctx, fingers || size.x < theme::NARROW);
        let chosen = self.state.window.appearance.language;
        self.started_in = self.started_in.filter(|(_, before)| *before == chosen);
        let wanted = self
            .started_in
            .map(|(language, _)| language)
            .or(chosen)
            .unwrap_or_else(Language::of_system);
        if wanted != language() {
            set_language(wanted);
            // The cached results of the views contain text.
            self.state.window.own = ViewStates::default();
            self.state.translate_lesson();
            ctx.request_repaint();
        }
        let session = &self.state.session;
        let mark = if session.modified() { "*" } else { "" };
        let name = session.document().origin.name();
        let title = format!("{name}{mark} — shading-lab");
        if title != self.title {
            system::set_title(ctx, &title);
            self.title = title;
        }
    }

    /// Performs an action that needs the window, files or the clipboard.
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
                    self.state.window.seek_highlight = true;
                }
            }
            Action::Save => match self.state.session.document().scene_file() {
                Some(path) => self.save(ctx, path),
                None => self.perform(ctx, Action::SaveAs),
            },
            Action::SaveAs => {
                let path = self.state.session.document().suggested("toml");
                self.ask_file(ctx, FileTask::SaveScene, path);
            }
            Action::SaveTo(path) => self.save(ctx, path),
            Action::ShowFolder(folder) => self.folder = Some(folder),
            Action::Export => {
                // More would take long on the single thread of a page on a phone.
                let phone = system::PAGE && system::fingers(ctx);
                let form = ExportForm {
                    size: [1920, 1080],
                    shape: None,
                    samples: if phone { 4 } else { 16 },
                    overlay: true,
                    film: None,
                    wrong: None,
                };
                let path = self.state.session.document().suggested("png");
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
                let name = scene_after(&self.state.session.document().origin, step).to_owned();
                self.perform(ctx, Action::OpenBuiltIn(name));
            }
            Action::ResetAll => {
                for action in [Action::ResetScene, Action::ResetLayout] {
                    self.state.requests.ask(action);
                }
            }
            Action::ResetLayout => {
                let window = &mut self.state.window;
                window.appearance = window.appearance.reset();
                (window.probe, window.line) = Default::default();
                window.seek_highlight = self.state.session.document().is_built_in();
                (window.enlarged, window.picture_alone) = (false, false);
                window.own = ViewStates::default();
                ctx.data_mut(|data| data.remove_by_type::<PanelState>());
            }
            Action::Find => self.state.dialog = Some(Dialog::Find),
            Action::Seek(key) => self.seek(ctx, Sought::Parameter(key)),
            Action::SeekSymbol(symbol) => self.seek(ctx, Sought::Symbol(symbol)),
            Action::Manual => self.state.dialog = Some(Dialog::Manual),
            Action::Keys => self.state.dialog = Some(Dialog::Keys),
            Action::About => self.state.dialog = Some(Dialog::About),
            Action::PictureAlone => {
                self.state.window.picture_alone = !self.state.window.picture_alone;
                system::set_fullscreen(ctx, self.state.window.picture_alone);
            }
            Action::ResetRow => focus::ask_reset(ctx),
            Action::TakeProbe => focus::take(ctx, focus::picture_id()),
            Action::Menus => focus::take_first(ctx),
            Action::HandIn => match self.state.course.to_hand_in() {
                Some((lesson, _)) => {
                    let name = self.state.course.kept.name.clone();
                    let file = PathBuf::from(format!("{}.png", lesson.name));
                    // A web page has no folder, and downloads the file.
                    let path = std::path::absolute(&file).unwrap_or(file);
                    let path = path.display().to_string();
                    self.ask_file(ctx, FileTask::HandIn(name), path);
                }
                None => {
                    let words = text!("course-hand-in-nothing").to_owned();
                    self.state.dialog = Some(Dialog::message(text!("course-hand-in"), words));
                }
            },
            #[cfg(feature = "class")]
            Action::Class(ClassAction::Teach) => {
                if let Some(file) = self.state.class_file() {
                    self.ask_file(ctx, FileTask::Class, file.display().to_string());
                }
            }
            #[cfg(feature = "class")]
            Action::Class(action) => self.state.lead_class(ctx, action),
            Action::LoadStage => self.files.load_stage(ctx, &self.state.course),
            Action::Quit if self.may_close() => self.close(ctx),
            Action::CloseUnsaved => self.close(ctx),
            Action::Restore => {
                if let Some((path, _)) = self.recovery.as_ref().and_then(Recovery::left) {
                    self.files.restore(ctx, path.to_owned());
                }
            }
            Action::AdoptRestored => self.recovery.iter_mut().for_each(Recovery::adopt),
            Action::DeleteLeft => self.recovery.iter_mut().for_each(Recovery::delete),
            // The other actions concern the state alone and are already done.
            _ => {}
        }
    }

    /// Shows a control, in place of what covers it.
    fn seek(&mut self, ctx: &Context, sought: Sought) {
        let window = &mut self.state.window;
        (window.enlarged, window.picture_alone) = (false, false);
        symbol::seek(ctx, sought);
    }

    /// Asks for a file; a web page asks only how to export a picture, since it downloads what it writes.
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
        match crate::document::save_scene(&path, &self.state.session.document().scene) {
            Ok(()) => {
                let origin = Origin::File(path.clone());
                if self.state.session.document().origin != origin {
                    self.state.window.appearance.remember(&path);
                }
                self.state.session.save_as(origin);
                let text = text!("saved", path = path.display().to_string());
                self.state.session.notice = Some(Notice::written(text, &path));
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
        let Document { scene, model, .. } = self.state.session.document();
        let mut scene = scene.clone();
        scene.image.size = self.room.whole;
        let mut renderer = Renderer::default().with_model(model.clone());
        let over = files::Over::new(&self.state.session, &self.state.window);
        let Some(frame) = files::picture(&mut renderer, &scene, 1, Some(&over), &mut |_| true)
        else {
            return;
        };
        let size = [frame.width as usize, frame.height as usize];
        let pixels = frame.pixels.as_flattened();
        ctx.copy_image(ColorImage::from_rgba_unmultiplied(size, pixels));
        self.state.session.notice = Some(text!("copied-picture").into());
    }
}

impl eframe::App for App {
    fn logic(&mut self, ctx: &Context, _: &mut eframe::Frame) {
        if ctx.input(|input| input.viewport().close_requested()) && !self.may_close() {
            // A hidden window has to be shown to ask.
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
        fingers::begin_frame(&ctx, system::page_scrolls());
        if let Some((link, place)) = system::went() {
            self.state.go_back(&link, &place);
        }
        for path in system::dropped(&ctx) {
            self.state.requests.ask(Action::OpenFile(path));
        }
        self.state.glide(&ctx);
        focus::listen(&ctx, self.in_front);
        if !self.in_front && self.state.window.embedded.is_none() {
            let AppState {
                window,
                course,
                requests,
                ..
            } = &mut self.state;
            commands::listen(&ctx, window, course, requests);
        }
        self.panels(ui);
        self.files.poll(&ctx, &mut self.state);
        toast::toast_ui(&ctx, &mut self.state, self.layout.picture);
        dialogs::dialog_ui(&ctx, &mut self.state, &mut self.files);
        self.settle(&ctx);
        // A dialog or progress that has come to the front takes the focus from what is behind it.
        let in_front = self.state.dialog.is_some() || self.files.progress().is_some();
        if in_front && !self.in_front {
            ctx.memory_mut(|memory| memory.stop_text_input());
        }
        self.in_front = in_front;
        focus::show(&ctx);
        links::open_addresses(&ctx);
        if let Some(folder) = self.folder.take() {
            system::show_folder(&ctx, &folder);
        }
        system::copy(&ctx);
        let (state, engine) = (&self.state, &self.engine);
        system::end_frame(
            &ctx,
            self.would_lose(),
            || state.link().ok().map(|written| written.link),
            state.place(),
            || engine.is_up_to_date(&state.session),
            || picture_bytes(engine.frame(), Some(&state.session.document().scene)).ok(),
        );
    }

    fn persist_egui_memory(&self) -> bool {
        !self.fresh
    }

    fn save(&mut self, storage: &mut dyn eframe::Storage) {
        if let Some(recovery) = &mut self.recovery
            && system::PAGE
        {
            recovery.write_now(&self.state.session, &self.state.window);
        }
        if self.fresh || self.state.window.embedded.is_some() {
            return;
        }
        let stored = Stored {
            appearance: self.state.window.appearance.clone(),
            course: self.state.course.kept.clone(),
        };
        stored.write(storage);
    }
}
