//! Files, in the background: the window stays alive while a model is read or a picture is drawn.

use super::action::Action;
use super::background::{Task, wake};
use super::dialog::{Dialog, ExportForm, FileTask};
use super::document::Document;
use super::engine::overlay_options;
use super::look::{Look, ViewName};
use super::recovery;
use super::state::AppState;
use super::system;
use crate::analysis::{
    NormalField, ProfileQuestion, Watch, comparison_sheet, draw_normals, draw_overlay, draw_panes,
    draw_profile, panes_on_sheet, probe, profile,
};
use crate::document::{load_with, save_picture};
use crate::jobs::Job;
use crate::render::{Frame, Renderer, check_memory};
use crate::scene::Scene;
use crate::text::text;
use eframe::egui::Context;
use std::cell::Cell;
use std::convert::Infallible;
use std::path::PathBuf;
use std::sync::Arc;

/// What becomes of the window when work on a file is done.
type Outcome = Arc<dyn Fn(&mut AppState) + Send + Sync>;
/// Draws over a picture of a scene.
type Over<'a> = &'a dyn Fn(&mut Frame, &mut Renderer, &Scene);

/// The files' side of the window.
#[derive(Default)]
pub struct Files {
    job: Option<Job<Task<Outcome>>>,
    /// What is under way.
    title: String,
    /// What it is if it does not work.
    failure: &'static str,
}

/// Draws over a picture of a scene what is drawn over it in the window.
pub fn over(state: &AppState) -> impl Fn(&mut Frame, &mut Renderer, &Scene) + Send + Sync + use<> {
    let Look {
        overlay,
        profile: profile_look,
        ..
    } = state.look.clone();
    let (light, point, vertex) = (state.light, state.probe, state.pointed.kept);
    let line = state.shows(ViewName::Profile).then_some(state.line);
    move |frame, renderer, scene| {
        let (width, height) = (frame.width, frame.height);
        let [x, y] = point.pixel([width, height]);
        let probe = probe(renderer, scene, x, y);
        let options = overlay_options(&overlay, light, scene);
        let taken = line.and_then(|line| {
            let own = scene.shading.mode;
            let request = ProfileQuestion {
                modes: vec![own],
                ..profile_look.request(line.pixels([width, height]), own)
            };
            profile(renderer, scene, &request).ok()
        });
        if let Some(mut map) =
            tiny_skia::PixmapMut::from_bytes(frame.pixels.as_flattened_mut(), width, height)
        {
            let lit = |field: &NormalField| {
                Ok(vertex.and_then(|point| field.vertex(field.vertex_at(point)?)))
            };
            let Ok(()) = draw_normals::<Infallible>(&mut map, scene, renderer, &options, lit);
            if let Some(taken) = &taken {
                taken
                    .traces
                    .iter()
                    .for_each(|trace| draw_profile(&mut map, taken, trace, &options));
            }
            draw_overlay(&mut map, scene, &probe, &options);
        }
    }
}

/// The picture of a scene, or the sheet of what it compares; none where `progress` has stopped it.
pub fn picture(
    renderer: &mut Renderer,
    scene: &Scene,
    samples: u32,
    over: Option<Over<'_>>,
    progress: &mut dyn FnMut(u32) -> bool,
) -> Option<Frame> {
    let go_on = Cell::new(true);
    let mut progress = |done| {
        go_on.set(progress(done));
        go_on.get()
    };
    let draw_over = |frame: &mut Frame, renderer: &mut Renderer, scene: &Scene| {
        if let Some(over) = over.filter(|_| go_on.get()) {
            over(frame, renderer, scene);
        }
        if go_on.get() { Ok(()) } else { Err(()) }
    };
    let panes = draw_panes(
        renderer,
        scene,
        &panes_on_sheet(scene),
        samples,
        &mut progress,
        draw_over,
    );
    panes
        .ok()
        .map(|panes| comparison_sheet(scene, &panes, true))
}

impl Files {
    /// What is under way, and how far it is from 0 to 1.
    pub fn progress(&self) -> Option<(&str, f32)> {
        self.job.as_ref().map(|job| (&*self.title, job.share()))
    }

    /// Cancels the work under way: what is drawn stops at its next sample and is not written, other outcomes are ignored.
    pub fn cancel(&mut self) {
        self.job = None;
    }

    /// Begins work in place of what is under way; what `run` returns is done to the window.
    fn start<F: Fn(&mut AppState) + Send + Sync + 'static>(
        &mut self,
        ctx: &Context,
        title: String,
        failure: &'static str,
        run: impl Fn(&dyn Watch<Outcome>) -> Result<F, String> + Send + Sync + 'static,
    ) {
        (self.title, self.failure) = (title, failure);
        let work = Task::new(move |watch| run(watch).map(|then| Arc::new(then) as Outcome));
        self.job = Some(Job::start(work, wake(ctx)));
    }

    /// Opens a scene, a model or a picture.
    pub fn open(&mut self, ctx: &Context, path: PathBuf) {
        self.start(
            ctx,
            text!("opening", path = path.display().to_string()),
            text!("not-opened"),
            move |watch| {
                let mut progress =
                    |read: u64, total: u64| _ = watch.at(read as f32 / total.max(1) as f32);
                let loaded = load_with(&path, &[] as &[&str], &mut progress)
                    .map_err(|error| error.to_string())?;
                let document = Document::from(loaded);
                Ok(move |state: &mut AppState| state.open(document.clone()))
            },
        );
    }

    /// Opens unsaved work that was left in a file.
    pub fn restore(&mut self, ctx: &Context, path: PathBuf) {
        let failure = text!("not-restored");
        self.start(ctx, text!("restoring").to_owned(), failure, move |_| {
            let (document, original, around) = recovery::restore(&path)?;
            Ok(move |state: &mut AppState| {
                state.open(original.clone());
                state.document = document.clone();
                state.derive();
                around.apply(state);
                state.ask(Action::AdoptRestored);
            })
        });
    }

    /// Draws and writes a picture of the document.
    pub fn export(&mut self, ctx: &Context, state: &AppState, form: ExportForm, path: PathBuf) {
        let over = form.overlay.then(|| over(state));
        let Document {
            mut scene, model, ..
        } = state.document.clone();
        scene.image.size = form.size;
        let total = f64::from(form.samples) * scene.shown_panes().len() as f64;
        self.start(
            ctx,
            text!("drawing-file", path = path.display().to_string()),
            text!("not-exported"),
            move |watch| {
                check_memory(&scene).map_err(|error| error.to_string())?;
                let mut renderer = Renderer::default();
                renderer.set_model(model.clone());
                let mut progress = |done: u32| watch.at((f64::from(done) / total) as f32);
                let over = over.as_ref().map(|over| over as Over<'_>);
                let frame = picture(&mut renderer, &scene, form.samples, over, &mut progress);
                if let Some(frame) = frame.filter(|_| watch.at(1.0)) {
                    save_picture(&path, &frame, &scene).map_err(|error| error.to_string())?;
                }
                let notice = text!("exported", path = path.display().to_string());
                Ok(move |state: &mut AppState| state.notice = Some(notice.clone()))
            },
        );
    }

    /// Shows the desktop's own dialog for the file that `dialog` asks for. It asks itself whether to replace a file.
    pub fn pick(&mut self, ctx: &Context, dialog: &mut Dialog) {
        let opens = matches!(
            dialog,
            Dialog::File {
                task: FileTask::Open,
                ..
            }
        );
        let Some((_, kind)) = dialog.file() else {
            return;
        };
        self.start(
            ctx,
            text!("waiting-dialog").to_owned(),
            text!("did-not-work"),
            move |_| {
                let picked = system::pick(opens, &kind);
                Ok(move |state: &mut AppState| {
                    if let (Some(path), Some((typed, _))) =
                        (&picked, state.dialog.as_mut().and_then(Dialog::file))
                    {
                        *typed = path.display().to_string();
                        state.agreed.clone_from(&picked);
                    }
                })
            },
        );
    }

    /// Takes what the thread has brought.
    pub fn poll(&mut self, ctx: &Context, state: &mut AppState) {
        let Some((_, outcome)) = Job::take(&mut self.job) else {
            return;
        };
        ctx.request_repaint();
        match outcome {
            Ok(then) => then(state),
            Err(text) => state.dialog = Some(Dialog::message(self.failure, text)),
        }
    }
}
