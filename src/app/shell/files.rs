//! Work on files, in the background: the window stays responsive while a model is read or a picture is drawn.

use super::dialog::{Dialog, ExportForm};
use super::film::FilmForm;
use crate::analysis::codec::Codec;
use crate::analysis::comparison::{Captions, comparison_sheet, draw_panes, panes_on_sheet};
use crate::analysis::defects::{defects, draw_defects};
use crate::analysis::normals::{NormalField, draw_normals};
use crate::analysis::overlay::{OverlayOptions, free_corners};
use crate::analysis::probe::{draw_overlay, probe};
use crate::analysis::profile::{ProfileQuestion, draw_profile, profile};
use crate::analysis::{Watch, unwatched};
use crate::animation::write_film;
use crate::app::course::Course;
use crate::app::engine::overlay_options;
use crate::app::session::Session;
use crate::app::session::action::Action;
use crate::app::session::appearance::profile::ProfileAppearance;
use crate::app::session::appearance::{Overlays, ViewName};
use crate::app::session::document::Document;
use crate::app::session::notice::Notice;
use crate::app::session::place::{ProbePoint, ProfileLine};
use crate::app::session::recovery;
use crate::app::session::window::WindowState;
use crate::app::shell::state::AppState;
use crate::app::system;
use crate::app::views;
use crate::app::widgets::background::{Task, wake};
use crate::app::widgets::dialog::Picked;
use crate::document::{SaveError, load_with, save_film, save_picture, write_whole};
use crate::geometry::Mesh;
use crate::jobs::{Job, Work, model_from_bytes, model_to_bytes};
use crate::lesson::{Lesson, hand_in};
use crate::render::{Frame, Renderer, check_memory_for};
use crate::scene::Scene;
use crate::text::text;
use eframe::egui::Context;
use serde::{Deserialize, Serialize};
use std::cell::Cell;
use std::convert::Infallible;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The size of the picture that is handed in with answers, in pixels.
const HANDED_IN: [u32; 2] = [960, 720];

/// A change to the window after work on a file is done.
type Outcome = Arc<dyn Fn(&mut AppState) + Send + Sync>;

/// The window's work on files.
#[derive(Default)]
pub struct Files {
    job: Option<Job<Task<Outcome>>>,
    drawing: Option<Job<Exported>>,
    filming: Option<Job<Filmed>>,
    /// The title of the work under way.
    title: String,
    /// The title of the message if the work fails.
    failure: &'static str,
}

/// The overlays of a picture, as the window shows them.
#[derive(Serialize, Deserialize)]
pub struct Over {
    overlay: Overlays,
    profile: ProfileAppearance,
    light: usize,
    point: ProbePoint,
    vertex: Option<u32>,
    line: Option<ProfileLine>,
    /// The built-in scene of the defect that is marked.
    defect: Option<String>,
}

impl Over {
    pub fn new(session: &Session, window: &WindowState) -> Self {
        Self {
            overlay: window.appearance.overlay.clone(),
            profile: window.appearance.profile.clone(),
            light: session.light,
            point: window.probe,
            vertex: window.pointed.kept,
            line: window.shows(ViewName::Profile).then_some(window.line),
            defect: views::defects::marked(session, window).map(str::to_owned),
        }
    }

    fn draw(&self, frame: &mut Frame, renderer: &mut Renderer, scene: &Scene) {
        let (width, height) = (frame.width, frame.height);
        let [x, y] = self.point.pixel([width, height]);
        let probe = probe(renderer, scene, x, y);
        let options = OverlayOptions {
            free_corners: free_corners(frame),
            ..overlay_options(&self.overlay, self.light, scene)
        };
        let taken = self.line.and_then(|line| {
            let own = scene.shading.mode;
            let request = ProfileQuestion {
                modes: vec![own],
                ..self.profile.request(line.pixels([width, height]), own)
            };
            profile(renderer, scene, &request).ok()
        });
        if let Some(mut map) =
            tiny_skia::PixmapMut::from_bytes(frame.pixels.as_flattened_mut(), width, height)
        {
            if self.overlay.normals() {
                let lit = |field: &NormalField| {
                    let next = || {
                        let place = self.point.centre(scene.image.size);
                        field.vertex_next_to(renderer, scene, place)
                    };
                    let kept = self.vertex.and_then(|point| field.vertex_at(point));
                    let number = kept.or_else(|| self.overlay.vertex.then(next).flatten());
                    Ok(number.and_then(|number| field.vertex(number)))
                };
                let Ok(()) = draw_normals::<Infallible>(&mut map, scene, renderer, &options, lit);
            }
            if self.defect.is_some() {
                let found = defects(renderer, scene, probe.pixel, &unwatched);
                draw_defects(&mut map, &found, self.defect.as_deref(), &options);
            }
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

/// A picture to be exported.
#[derive(Serialize, Deserialize)]
pub struct Exported {
    scene: Scene,
    #[serde(
        serialize_with = "model_to_bytes",
        deserialize_with = "model_from_bytes"
    )]
    model: Option<Arc<Mesh>>,
    samples: u32,
    over: Option<Over>,
    path: PathBuf,
}

impl Work for Exported {
    type Answer = Frame;

    const CODECS: Option<(Codec<Self>, Codec<Frame>)> = Some((Codec::plain(), Codec::plain()));

    fn run(&self, watch: &dyn Watch<Frame>) -> Result<Frame, String> {
        let model = self.model.as_deref();
        check_memory_for(&self.scene, model, 1).map_err(|error| error.to_string())?;
        let mut renderer = Renderer::default().with_model(self.model.clone());
        let total = f64::from(self.samples) * self.scene.shown_panes().len() as f64;
        let mut progress = |done: u32| watch.progress((f64::from(done) / total) as f32);
        let frame = picture(
            &mut renderer,
            &self.scene,
            self.samples,
            self.over.as_ref(),
            &mut progress,
        );
        // Nobody reads the reason.
        frame.ok_or_else(String::new)
    }
}

/// An animation to be exported.
#[derive(Serialize, Deserialize)]
pub struct Filmed {
    /// The first frame's settings: its scene, its samples, its path and so on.
    first: Exported,
    form: FilmForm,
}

impl Work for Filmed {
    /// The file on a web page, where only the page itself can save it; `None` elsewhere, where it is already
    /// written.
    type Answer = Option<Vec<u8>>;

    const CODECS: Option<(Codec<Self>, Codec<Self::Answer>)> =
        Some((Codec::plain(), Codec::plain()));

    fn run(&self, watch: &dyn Watch<Self::Answer>) -> Result<Self::Answer, String> {
        let Exported {
            scene,
            model,
            samples,
            over,
            path,
        } = &self.first;
        let (sweep, format) = self.form.sweep(scene, path)?;
        sweep
            .scenes()
            .try_for_each(|scene| check_memory_for(&scene, model.as_deref(), 1))
            .map_err(|error| error.to_string())?;
        let mut renderer = Renderer::default().with_model(model.clone());
        let count = f64::from(sweep.count());
        let mut done = 0.0;
        let mut draw = |scene: &Scene| {
            let share = (done / count) as f32;
            done += 1.0;
            let mut progress = |_| watch.progress(share);
            if !progress(0) {
                return None;
            }
            picture(&mut renderer, scene, *samples, over.as_ref(), &mut progress)
        };
        let seconds = self.form.seconds;
        if !system::PAGE {
            let saved = save_film(path, format, &sweep, seconds, &mut draw);
            return saved.map(|()| None).map_err(|error| error.to_string());
        }
        let mut bytes = Vec::new();
        let written = write_film(&mut bytes, format, &sweep, seconds, &mut draw);
        written
            .map(|()| Some(bytes))
            .map_err(|error| error.to_string())
    }
}

/// Draws the picture of a scene, or the sheet of a comparison; returns `None` if `progress` has stopped it.
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
        .map(|panes| comparison_sheet(scene, &panes, Captions::Figures))
}

impl Files {
    /// Returns the title of the work under way, and its progress from 0 to 1.
    pub fn progress(&self) -> Option<(&str, f32)> {
        let drawing = self.drawing.as_ref().map(Job::share);
        let drawing = drawing.or(self.filming.as_ref().map(Job::share));
        let share = self.job.as_ref().map(Job::share).or(drawing);
        share.map(|share| (&*self.title, share))
    }

    /// Cancels the work under way. Drawing stops at its next sample and nothing is written; other results are
    /// ignored.
    pub fn cancel(&mut self) {
        (self.job, self.drawing, self.filming) = (None, None, None);
    }

    /// Starts work in place of any under way, and applies the result of `run` to the window.
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

    /// Opens a scene, a model, a picture or a lesson.
    pub fn open(&mut self, ctx: &Context, path: PathBuf) {
        if Lesson::is_file(&path) {
            return self.open_lesson(ctx, path);
        }
        self.start(
            ctx,
            text!("opening", path = path.display().to_string()),
            text!("not-opened"),
            move |watch| {
                let mut progress =
                    |read: u64, total: u64| _ = watch.progress(read as f32 / total.max(1) as f32);
                let loaded = load_with(&path, &[] as &[&str], &mut progress)
                    .map_err(|error| error.to_string())?;
                let document = Document::from(loaded);
                Ok(move |state: &mut AppState| _ = state.open(document.clone()))
            },
        );
    }

    /// Opens a lesson.
    fn open_lesson(&mut self, ctx: &Context, path: PathBuf) {
        let title = text!("opening", path = path.display().to_string());
        self.start(ctx, title, text!("not-opened"), move |_| {
            let lesson = Lesson::open(&path).map_err(|error| error.to_string())?;
            let (lesson, path) = (Arc::new(lesson), path.clone());
            Ok(move |state: &mut AppState| {
                state.window.appearance.remember(&path);
                state.open_lesson(Arc::clone(&lesson), false);
            })
        });
    }

    /// Draws the last picture, and writes it with the answers to a lesson inside.
    pub fn hand_in(
        &mut self,
        ctx: &Context,
        document: &Document,
        course: &mut Course,
        name: String,
        path: PathBuf,
    ) {
        let Some((lesson, record)) = course.to_hand_in() else {
            return;
        };
        course.kept.name.clone_from(&name);
        let Document { scene, model, .. } = document.clone();
        let title = text!("drawing-file", path = path.display().to_string());
        self.start(ctx, title, text!("course-not-handed-in"), move |watch| {
            let mut sized = scene.clone();
            sized.image.size = HANDED_IN;
            let mut renderer = Renderer::default().with_model(model.clone());
            let mut progress = |_| watch.progress(0.5);
            // Nobody reads the reason.
            let frame =
                picture(&mut renderer, &sized, 4, None, &mut progress).ok_or_else(String::new)?;
            hand_in(&path, &frame, &scene, &lesson, &record, &name)
                .map_err(|error| error.to_string())?;
            let text = text!("course-handed-in", path = path.display().to_string());
            let notice = Notice::written(text, &path);
            Ok(move |state: &mut AppState| state.session.notice = Some(notice.clone()))
        });
    }

    /// Loads the scene of the current step.
    pub fn load_stage(&mut self, ctx: &Context, course: &Course) {
        let Some(open) = &course.open else {
            return;
        };
        let (opening, step, lesson) = (open.opening, open.step, Arc::clone(&open.lesson));
        let title = text!("opening", path = open.current().stage.scene.as_str());
        self.start(ctx, title, text!("not-opened"), move |_| {
            let stage = &lesson.steps[step].stage;
            let staged = stage.load(lesson.folder.as_deref());
            let staged = staged.map(Arc::new).map_err(|error| error.to_string());
            Ok(move |state: &mut AppState| state.stage(opening, step, staged.clone()))
        });
    }

    /// Opens unsaved work that an earlier run left in a file.
    pub fn restore(&mut self, ctx: &Context, path: PathBuf) {
        let failure = text!("not-restored");
        self.start(ctx, text!("restoring").to_owned(), failure, move |_| {
            let (document, original, around) = recovery::restore(&path)?;
            Ok(move |state: &mut AppState| {
                if state.open(original.clone()) {
                    state.session.restore(document.clone());
                    around.apply(&mut state.session, &mut state.window);
                    state.requests.ask(Action::AdoptRestored);
                }
            })
        });
    }

    /// Draws a picture or an animation of the document, and then writes it.
    ///
    /// # Errors
    /// Returns the error in the requested animation.
    pub fn export(
        &mut self,
        ctx: &Context,
        session: &Session,
        window: &WindowState,
        form: &ExportForm,
        path: PathBuf,
    ) -> Result<(), String> {
        let Document {
            mut scene, model, ..
        } = session.document().clone();
        scene.image.size = form.size;
        if let Some(film) = &form.film {
            film.sweep(&scene, &path)?;
        }
        self.title = text!("drawing-file", path = path.display().to_string());
        let first = Exported {
            scene,
            model,
            samples: form.samples,
            over: form.overlay.then(|| Over::new(session, window)),
            path,
        };
        match form.film.clone() {
            Some(form) => {
                self.filming = Some(Job::start(Filmed { first, form }, wake(ctx)));
            }
            None => self.drawing = Some(Job::start(first, wake(ctx))),
        }
        Ok(())
    }

    /// Writes what has been drawn, in the background since it may take a while.
    fn write(
        &mut self,
        ctx: &Context,
        path: PathBuf,
        save: impl Fn(&Path) -> Result<(), SaveError> + Send + Sync + 'static,
    ) {
        let title = std::mem::take(&mut self.title);
        self.start(ctx, title, text!("not-exported"), move |_| {
            save(&path).map_err(|error| error.to_string())?;
            let text = text!("exported", path = path.display().to_string());
            let notice = Notice::written(text, &path);
            Ok(move |state: &mut AppState| state.session.notice = Some(notice.clone()))
        });
    }

    /// Shows the desktop's own dialog for the file that `dialog` asks for. That dialog asks by itself whether
    /// to replace a file.
    pub fn pick(&mut self, ctx: &Context, dialog: &mut Dialog) {
        let opens = dialog.opens();
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
                    state.no_dialog = matches!(picked, Picked::NoDialog);
                    if let (Picked::File(path), Some((typed, _))) =
                        (&picked, state.dialog.as_mut().and_then(Dialog::file))
                    {
                        *typed = path.display().to_string();
                        state.agreed = Some(path.clone());
                    }
                })
            },
        );
    }

    /// Handles the results of finished work.
    pub fn poll(&mut self, ctx: &Context, state: &mut AppState) {
        match Job::take(&mut self.drawing) {
            Some((work, Ok(frame))) => {
                let path = work.path.clone();
                let save = move |path: &Path| save_picture(path, &frame, &work.scene);
                self.write(ctx, path, save);
            }
            Some((_, Err(text))) => {
                state.dialog = Some(Dialog::message(text!("not-exported"), text));
            }
            None => {}
        }
        match Job::take(&mut self.filming) {
            Some((work, Ok(file))) => {
                // Elsewhere than on a web page, the file is written already.
                let save = move |path: &Path| match &file {
                    Some(bytes) => write_whole(path, |out| out.write_all(bytes)),
                    None => Ok(()),
                };
                self.write(ctx, work.first.path.clone(), save);
            }
            Some((_, Err(text))) => {
                state.dialog = Some(Dialog::message(text!("not-exported"), text));
            }
            None => {}
        }
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
