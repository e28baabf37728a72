//! Files, on threads of their own: the window stays alive while a model is read or a picture is drawn.

use super::action::Action;
use super::code::Language;
use super::dialog::{Dialog, ExportForm};
use super::document::Document;
use super::engine::overlay_options;
use super::handles;
use super::handles::line::ProfileLine;
use super::profile::ProfileLook;
use super::recovery;
use super::state::{AppState, OverlayLook, ProbePoint};
use crate::analysis::{
    ProfileRequest, comparison_sheet, draw_normals, draw_overlay, draw_panes, draw_profile, panes_on_sheet, probe,
    profile,
};
use crate::document::{Loaded, load_with, save_picture};
use crate::render::{Frame, Renderer, check_memory};
use crate::scene::Scene;
use eframe::egui::Context;
use std::convert::Infallible;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
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
    outcome: Receiver<Outcome>,
}

/// The files' side of the window.
#[derive(Default)]
pub struct Files {
    work: Option<Work>,
    /// The path that the desktop's own dialog gave, which has asked whether to replace the file.
    agreed: Option<PathBuf>,
}

/// Which dialog of the desktop's is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pick {
    Open,
    SaveScene,
    SavePicture,
    SaveCode(Language),
    SaveProfile,
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
            let request = ProfileRequest { modes, ..self.profile.request(line.pixels([width, height])) };
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

/// The picture of a scene, or the sheet of what it compares.
pub fn picture(
    renderer: &mut Renderer,
    scene: &Scene,
    samples: u32,
    over: Option<&Over>,
    progress: &mut dyn FnMut(u32),
) -> Frame {
    let draw_over = |frame: &mut Frame, renderer: &mut Renderer, scene: &Scene| {
        if let Some(over) = over {
            over.draw(frame, renderer, scene);
        }
        Ok::<(), Infallible>(())
    };
    let panes = draw_panes(renderer, scene, &panes_on_sheet(scene), samples, progress, draw_over);
    panes.map_or_else(|never| match never {}, |panes| comparison_sheet(scene, &panes, true))
}

impl Files {
    /// What is under way, and how far it is from 0 to 1.
    pub fn progress(&self) -> Option<(&str, f32)> {
        let work = self.work.as_ref()?;
        let (done, total) = (work.done.load(Ordering::Relaxed), work.total.load(Ordering::Relaxed));
        let fraction = if total == 0 { 0.0 } else { done as f32 / total as f32 };
        Some((&work.what, fraction))
    }

    /// Forgets the work under way: its outcome will not be looked at.
    pub fn cancel(&mut self) {
        self.work = None;
    }

    fn start(&mut self, ctx: &Context, what: String, run: impl FnOnce(&dyn Fn(u64, u64)) -> Outcome + Send + 'static) {
        let (sender, outcome) = channel();
        let (done, total) = (Arc::new(AtomicU64::new(0)), Arc::new(AtomicU64::new(0)));
        let counters = (Arc::clone(&done), Arc::clone(&total));
        self.work = Some(Work { what, done, total, outcome });
        let ctx = ctx.clone();
        thread::spawn(move || {
            let tell = |now: u64, of: u64| {
                counters.0.store(now, Ordering::Relaxed);
                counters.1.store(of, Ordering::Relaxed);
                ctx.request_repaint();
            };
            // A window that has given up listening is no error.
            let _ = sender.send(run(&tell));
            ctx.request_repaint();
        });
    }

    /// Opens a scene, a model or a picture.
    pub fn open(&mut self, ctx: &Context, path: PathBuf) {
        self.start(ctx, format!("Opening {}", path.display()), move |tell| {
            let loaded = load_with(&path, &[] as &[&str], &mut |read, total| tell(read, total));
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
            let saved = drawn.and_then(|frame| save_picture(&path, &frame, &scene).map_err(|error| error.to_string()));
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
