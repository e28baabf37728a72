//! Files, in the background: the window stays alive while a model is read or a picture is drawn.

use super::action::Action;
use super::background::wake;
use super::dialog::{Dialog, ExportForm, Pick};
use super::document::Document;
use super::engine::overlay_options;
use super::handles;
use super::look::OverlayLook;
use super::points::{ProbePoint, ProfileLine};
use super::profile::look::ProfileLook;
use super::recovery;
use super::state::AppState;
use crate::analysis::{
    ProfileQuestion, Watch, comparison_sheet, draw_normals, draw_overlay, draw_panes, draw_profile, panes_on_sheet,
    probe, profile,
};
use crate::document::{Loaded, load_with, save_picture};
use crate::jobs::{Job, Work};
use crate::render::{Frame, Renderer, check_memory};
use crate::scene::Scene;
use eframe::egui::Context;
use std::cell::Cell;
use std::path::PathBuf;

/// Work on a file.
enum FileWork {
    Open(PathBuf),
    /// Opens unsaved work that was left in a file.
    Restore(PathBuf),
    Export(Box<Export>),
    /// Shows the desktop's own dialog.
    Pick(Pick),
}

/// A picture to be drawn and written.
struct Export {
    document: Document,
    form: ExportForm,
    over: Option<Over>,
}

/// What comes of it.
#[derive(Clone)]
enum Outcome {
    Loaded(Box<Loaded>),
    /// Unsaved work with what it was made from.
    Restored(Box<(Document, Document)>),
    Exported(PathBuf),
    /// A path picked in the desktop's own dialog; none where it was left or there is no such dialog.
    Picked(Option<PathBuf>),
}

/// The files' side of the window.
#[derive(Default)]
pub struct Files {
    job: Option<Job<FileWork>>,
    /// The path that the desktop's own dialog gave, which has asked whether to replace the file.
    agreed: Option<PathBuf>,
}

/// What is drawn over a picture.
pub struct Over {
    pub look: OverlayLook,
    pub light: usize,
    pub place: ProbePoint,
    /// The profile's line, while its tab is open.
    pub line: Option<ProfileLine>,
    pub profile: ProfileLook,
    /// The point of the mesh whose faces are lit up.
    pub vertex: Option<u32>,
}

impl Over {
    fn draw(&self, frame: &mut Frame, renderer: &mut Renderer, scene: &Scene) {
        let (width, height) = (frame.width, frame.height);
        let [x, y] = self.place.pixel([width, height]);
        let probe = probe(renderer, scene, x, y);
        let options = overlay_options(&self.look, self.light, scene);
        let taken = self.line.and_then(|line| {
            let modes = vec![scene.shading.mode];
            let request = ProfileQuestion { modes, ..self.profile.request(line.pixels([width, height])) };
            profile(renderer, scene, &request).ok()
        });
        if let Some(mut map) = tiny_skia::PixmapMut::from_bytes(frame.pixels.as_flattened_mut(), width, height) {
            draw_normals(&mut map, scene, renderer, &options, self.vertex);
            if let Some(taken) = &taken {
                taken.traces.iter().for_each(|trace| draw_profile(&mut map, taken, trace, &options));
            }
            draw_overlay(&mut map, scene, &probe, &options);
        }
    }

    /// What is drawn over the picture in the window.
    pub fn of(state: &AppState) -> Self {
        let AppState { look, light, probe, line, pointed, .. } = state;
        Self {
            look: look.overlay.clone(),
            light: *light,
            place: *probe,
            line: handles::line::shown(state).then_some(*line),
            profile: look.profile.clone(),
            vertex: pointed.kept,
        }
    }
}

/// The picture of a scene, or the sheet of what it compares; none where `progress` has stopped it.
pub fn picture(
    renderer: &mut Renderer,
    scene: &Scene,
    samples: u32,
    over: Option<&Over>,
    progress: &mut dyn FnMut(u32) -> bool,
) -> Option<Frame> {
    let go_on = Cell::new(true);
    let mut progress = |done| {
        go_on.set(progress(done));
        go_on.get()
    };
    let draw_over = |frame: &mut Frame, renderer: &mut Renderer, scene: &Scene| {
        if let Some(over) = over.filter(|_| go_on.get()) {
            over.draw(frame, renderer, scene);
        }
        if go_on.get() { Ok(()) } else { Err(()) }
    };
    let panes = draw_panes(renderer, scene, &panes_on_sheet(scene), samples, &mut progress, draw_over);
    panes.ok().map(|panes| comparison_sheet(scene, &panes, true))
}

impl Work for FileWork {
    type Answer = Outcome;

    fn run(&self, watch: &dyn Watch<Outcome>) -> Result<Outcome, String> {
        match self {
            Self::Open(path) => {
                let mut progress = |read: u64, total: u64| _ = watch.at(read as f32 / total.max(1) as f32);
                let loaded = load_with(path, &[] as &[&str], &mut progress);
                loaded.map(|loaded| Outcome::Loaded(Box::new(loaded))).map_err(|error| error.to_string())
            }
            Self::Restore(path) => recovery::restore(path).map(|both| Outcome::Restored(Box::new(both))),
            Self::Export(export) => export.run(watch),
            Self::Pick(pick) => Ok(Outcome::Picked(pick.show())),
        }
    }
}

impl FileWork {
    /// What is under way.
    fn title(&self) -> String {
        match self {
            Self::Open(path) => format!("Opening {}", path.display()),
            Self::Restore(_) => "Restoring unsaved work".to_owned(),
            Self::Export(export) => format!("Drawing {}", export.form.path),
            Self::Pick(_) => "Waiting for the desktop's file dialog".to_owned(),
        }
    }

    /// What did not work.
    fn failure(&self) -> &'static str {
        match self {
            Self::Open(_) => "The file was not opened",
            Self::Restore(_) => "The unsaved work was not restored",
            Self::Export(_) => "The picture was not exported",
            Self::Pick(_) => "That did not work",
        }
    }
}

impl Export {
    fn run(&self, watch: &dyn Watch<Outcome>) -> Result<Outcome, String> {
        let Self { document, form, over } = self;
        let mut scene = document.scene.clone();
        scene.image.size = form.size;
        check_memory(&scene).map_err(|error| error.to_string())?;
        let total = f64::from(form.samples) * scene.shown_panes().len() as f64;
        let mut renderer = Renderer::default();
        renderer.set_model(document.model.clone());
        let path = PathBuf::from(&form.path);
        let mut progress = |done: u32| watch.at((f64::from(done) / total) as f32);
        let frame = picture(&mut renderer, &scene, form.samples, over.as_ref(), &mut progress);
        if let Some(frame) = frame.filter(|_| watch.at(1.0)) {
            save_picture(&path, &frame, &scene).map_err(|error| error.to_string())?;
        }
        Ok(Outcome::Exported(path))
    }
}

impl Pick {
    fn show(self) -> Option<PathBuf> {
        let dialog = rfd::FileDialog::new();
        match self {
            Self::Open => dialog.add_filter("Scenes, models, pictures", &["toml", "obj", "png"]).pick_file(),
            Self::SaveScene => dialog.add_filter("Scene", &["toml"]).set_file_name("scene.toml").save_file(),
            Self::SavePicture => dialog.add_filter("Picture", &["png"]).set_file_name("picture.png").save_file(),
            Self::SaveAnswer(format) => dialog.add_filter("Analysis", &[format.ending()]).save_file(),
            Self::SaveCode(language) => dialog.set_file_name(language.suggestion()).save_file(),
        }
    }
}

impl Files {
    /// What is under way, and how far it is from 0 to 1.
    pub fn progress(&self) -> Option<(String, f32)> {
        self.job.as_ref().map(|job| (job.work.title(), job.share()))
    }

    /// Cancels the work under way: what is drawn stops at its next sample and is not written, other outcomes are ignored.
    pub fn cancel(&mut self) {
        self.job = None;
    }

    /// Opens a scene, a model or a picture.
    pub fn open(&mut self, ctx: &Context, path: PathBuf) {
        self.start(ctx, FileWork::Open(path));
    }

    /// Opens unsaved work that was left in a file.
    pub fn restore(&mut self, ctx: &Context, path: PathBuf) {
        self.start(ctx, FileWork::Restore(path));
    }

    /// Draws and writes a picture of the document.
    pub fn export(&mut self, ctx: &Context, state: &AppState, form: &ExportForm) {
        let over = form.overlay.then(|| Over::of(state));
        let export = Export { document: state.document.clone(), form: form.clone(), over };
        self.start(ctx, FileWork::Export(Box::new(export)));
    }

    /// Shows the desktop's own dialog.
    pub fn pick(&mut self, ctx: &Context, pick: Pick) {
        self.start(ctx, FileWork::Pick(pick));
    }

    fn start(&mut self, ctx: &Context, work: FileWork) {
        self.job = Some(Job::start(work, wake(ctx)));
    }

    /// Takes the path that may be replaced without another question, if any.
    pub fn take_agreed(&mut self) -> Option<PathBuf> {
        self.agreed.take()
    }

    /// Takes what the thread has brought.
    pub fn poll(&mut self, ctx: &Context, state: &mut AppState) {
        let Some((work, outcome)) = Job::take(&mut self.job) else { return };
        ctx.request_repaint();
        match outcome {
            Err(text) => state.dialog = Some(Dialog::message(work.failure(), text)),
            Ok(Outcome::Loaded(loaded)) => state.open(Document::from(*loaded)),
            Ok(Outcome::Restored(both)) => {
                let (document, original) = *both;
                state.open(original);
                state.document = document;
                state.ask(Action::AdoptRestored);
            }
            Ok(Outcome::Exported(path)) => state.notice = Some(format!("exported {}", path.display())),
            Ok(Outcome::Picked(path)) => {
                if let (Some(path), Some(dialog)) = (path, &mut state.dialog) {
                    dialog.take_path(path.display().to_string());
                    self.agreed = Some(path);
                }
            }
        }
    }
}
