//! Files, on threads of their own: the window stays alive while a model is read or a picture is drawn.

use super::code::Language;
use super::dialog::{Dialog, ExportForm};
use super::document::Document;
use super::engine::overlay_options;
use super::state::AppState;
use crate::analysis::probe;
use crate::document::{Loaded, load_with, save_picture};
use crate::figure::draw_overlay;
use crate::render::Renderer;
use eframe::egui::Context;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, TryRecvError, channel};
use std::thread;

/// What comes back from a thread.
enum Outcome {
    Loaded(Box<Result<Loaded, String>>),
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

    /// Draws and writes a picture of `document`.
    pub fn export(&mut self, ctx: &Context, state: &AppState, form: &ExportForm) {
        let (document, form) = (state.document.clone(), form.clone());
        let (look, light, place) = (state.look.overlay.clone(), state.light, state.probe);
        self.start(ctx, format!("Drawing {}", form.path), move |tell| {
            let mut scene = document.scene;
            scene.image.size = form.size;
            let total = u64::from(form.samples);
            let mut renderer = Renderer::default();
            renderer.set_model(document.model);
            let mut frame = renderer.render_supersampled(&scene, form.samples, &mut |n| tell(n.into(), total));
            if form.overlay {
                let [x, y] = place.pixel(form.size);
                let probe = probe(&mut renderer, &scene, x, y);
                let options = overlay_options(&look, light, &scene);
                let (width, height) = (frame.width, frame.height);
                let map = tiny_skia::PixmapMut::from_bytes(frame.pixels.as_flattened_mut(), width, height);
                if let Some(mut map) = map {
                    draw_overlay(&mut map, &scene, &probe, &options);
                }
            }
            let path = PathBuf::from(&form.path);
            let saved = save_picture(&path, &frame, &scene);
            Outcome::Exported(saved.map(|()| path).map_err(|error| error.to_string()))
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
            Some(Outcome::Exported(Ok(path))) => state.notice = Some(format!("exported {}", path.display())),
            Some(Outcome::Exported(Err(text))) => {
                state.dialog = Some(Dialog::message("The picture was not exported", text));
            }
            Some(Outcome::Picked(path)) => {
                if let (Some(path), Some(dialog)) = (path, &mut state.dialog) {
                    dialog.take_path(path.display().to_string());
                }
            }
        }
    }
}
