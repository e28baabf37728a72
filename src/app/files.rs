//! Files, on threads of their own: the window stays alive while a model is read or a picture is drawn.

use super::action::Action;
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
    ProfileQuestion, comparison_sheet, draw_normals, draw_overlay, draw_panes, draw_profile, panes_on_sheet, probe,
    profile,
};
use crate::document::{Loaded, load_with, save_picture};
use crate::render::{Frame, Renderer, check_memory};
use crate::scene::Scene;
use eframe::egui::Context;
use std::cell::Cell;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, TryRecvError, channel};
use std::thread;

/// What comes back from a thread.
enum Outcome {
    Loaded(Box<Result<Loaded, String>>),
    /// Unsaved work with what it was made from.
    Restored(Box<Result<(Document, Document), String>>),
    Exported(Result<PathBuf, String>),
    /// A path picked in the desktop's own dialog; none where it was left or there is no such dialog.
    Picked(Option<PathBuf>),
}

/// Work under way.
struct Work {
    what: String,
    done: Arc<AtomicU64>,
    total: Arc<AtomicU64>,
    cancelled: Arc<AtomicBool>,
    outcome: Receiver<Outcome>,
}

/// The files' side of the window.
#[derive(Default)]
pub struct Files {
    work: Option<Work>,
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

impl Files {
    /// What is under way, and how far it is from 0 to 1.
    pub fn progress(&self) -> Option<(&str, f32)> {
        let work = self.work.as_ref()?;
        let (done, total) = (work.done.load(Ordering::Relaxed), work.total.load(Ordering::Relaxed));
        let fraction = if total == 0 { 0.0 } else { done as f32 / total as f32 };
        Some((&work.what, fraction))
    }

    /// Cancels the work under way: what is drawn stops at its next sample and is not written, other outcomes are ignored.
    pub fn cancel(&mut self) {
        if let Some(work) = self.work.take() {
            work.cancelled.store(true, Ordering::Relaxed);
        }
    }

    /// Runs work on a thread. It reports how much is done, of how much, and is told whether to go on.
    fn start(
        &mut self,
        ctx: &Context,
        what: String,
        run: impl FnOnce(&dyn Fn(u64, u64) -> bool) -> Outcome + Send + 'static,
    ) {
        let (sender, outcome) = channel();
        let [done, total] = [(); 2].map(|()| Arc::new(AtomicU64::new(0)));
        let cancelled = Arc::new(AtomicBool::new(false));
        let shared = (Arc::clone(&done), Arc::clone(&total), Arc::clone(&cancelled));
        self.work = Some(Work { what, done, total, cancelled, outcome });
        let ctx = ctx.clone();
        thread::spawn(move || {
            let (done, total, cancelled) = shared;
            let tell = |now: u64, of: u64| {
                done.store(now, Ordering::Relaxed);
                total.store(of, Ordering::Relaxed);
                ctx.request_repaint();
                !cancelled.load(Ordering::Relaxed)
            };
            // The receiver may be gone; dropping the outcome is fine.
            let _ = sender.send(run(&tell));
            ctx.request_repaint();
        });
    }

    /// Opens a scene, a model or a picture.
    pub fn open(&mut self, ctx: &Context, path: PathBuf) {
        self.start(ctx, format!("Opening {}", path.display()), move |tell| {
            let loaded = load_with(&path, &[] as &[&str], &mut |read, total| _ = tell(read, total));
            Outcome::Loaded(Box::new(loaded.map_err(|error| error.to_string())))
        });
    }

    /// Opens unsaved work that was left in a file.
    pub fn restore(&mut self, ctx: &Context, path: PathBuf) {
        self.start(ctx, "Restoring unsaved work".to_owned(), move |_| {
            Outcome::Restored(Box::new(recovery::restore(&path)))
        });
    }

    /// Takes the path that may be replaced without another question, if any.
    pub fn take_agreed(&mut self) -> Option<PathBuf> {
        self.agreed.take()
    }

    /// Draws and writes a picture of `document`.
    pub fn export(&mut self, ctx: &Context, state: &AppState, form: &ExportForm) {
        let (document, form) = (state.document.clone(), form.clone());
        let over = form.overlay.then(|| Over::of(state));
        self.start(ctx, format!("Drawing {}", form.path), move |tell| {
            let mut scene = document.scene;
            scene.image.size = form.size;
            let total = u64::from(form.samples) * scene.shown_panes().len() as u64;
            let mut renderer = Renderer::default();
            renderer.set_model(document.model);
            let path = PathBuf::from(&form.path);
            let mut draw =
                || picture(&mut renderer, &scene, form.samples, over.as_ref(), &mut |n| tell(n.into(), total));
            let drawn = check_memory(&scene).map_err(|error| error.to_string()).map(|()| draw());
            let saved = drawn.and_then(|frame| match frame.filter(|_| tell(total, total)) {
                Some(frame) => save_picture(&path, &frame, &scene).map_err(|error| error.to_string()),
                None => Ok(()),
            });
            Outcome::Exported(saved.map(|()| path))
        });
    }

    /// Shows the desktop's own dialog.
    pub fn pick(&mut self, ctx: &Context, pick: Pick) {
        self.start(ctx, "Waiting for the desktop's file dialog".to_owned(), move |_| {
            let dialog = rfd::FileDialog::new();
            Outcome::Picked(match pick {
                Pick::Open => dialog.add_filter("Scenes, models, pictures", &["toml", "obj", "png"]).pick_file(),
                Pick::SaveScene => dialog.add_filter("Scene", &["toml"]).set_file_name("scene.toml").save_file(),
                Pick::SavePicture => dialog.add_filter("Picture", &["png"]).set_file_name("picture.png").save_file(),
                Pick::SaveProfile => {
                    dialog.add_filter("Profile", &["csv", "png", "svg"]).set_file_name("profile.csv").save_file()
                }
                Pick::SaveCode(language) => dialog.set_file_name(language.suggestion()).save_file(),
            })
        });
    }

    /// Takes what the thread has brought.
    pub fn poll(&mut self, ctx: &Context, state: &mut AppState) {
        let Some(work) = &self.work else { return };
        let outcome = match work.outcome.try_recv() {
            Err(TryRecvError::Empty) => return,
            Err(TryRecvError::Disconnected) => None,
            Ok(outcome) => Some(outcome),
        };
        self.work = None;
        ctx.request_repaint();
        match outcome {
            None => state.dialog = Some(Dialog::message("That did not work", "It ended without a result.".to_owned())),
            Some(Outcome::Loaded(loaded)) => match *loaded {
                Ok(loaded) => state.open(Document::from(loaded)),
                Err(text) => state.dialog = Some(Dialog::message("The file was not opened", text)),
            },
            Some(Outcome::Restored(restored)) => match *restored {
                Ok((document, original)) => {
                    state.open(original);
                    state.document = document;
                    state.ask(Action::AdoptRestored);
                }
                Err(text) => state.dialog = Some(Dialog::message("The unsaved work was not restored", text)),
            },
            Some(Outcome::Exported(Ok(path))) => state.notice = Some(format!("exported {}", path.display())),
            Some(Outcome::Exported(Err(text))) => {
                state.dialog = Some(Dialog::message("The picture was not exported", text));
            }
            Some(Outcome::Picked(path)) => {
                if let (Some(path), Some(dialog)) = (path, &mut state.dialog) {
                    dialog.take_path(path.display().to_string());
                    self.agreed = Some(path);
                }
            }
        }
    }
}
