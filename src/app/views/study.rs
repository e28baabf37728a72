//! The view of error against run time: the choice of what to measure, the plot while points arrive, and the table.

use super::report::{Offer, Pending, Picked, export_ui};
use crate::analysis::study::{Method, Setting, Study, StudyQuestion, study_point};
use crate::app::engine::Engine;
use crate::app::session::Session;
use crate::app::session::action::Requests;
use crate::app::session::window::WindowState;
use crate::app::widgets::theme::text_field;
use crate::scene::{Choice, Interpolation, ReflectionModel, Scene};
use crate::text::text;
use eframe::egui::{CollapsingHeader, Response, RichText, Ui};

/// Tessellations to choose from, in segments.
const SEGMENTS: [u32; 8] = [4, 8, 16, 32, 64, 128, 256, 512];
/// Numbers of timed frames for each setting, to choose from.
const REPEATS: [u32; 3] = [3, 9, 27];

/// State of the view.
#[derive(Default)]
pub struct StudyView {
    choices: Choices,
    /// Message about the point that was chosen last.
    message: Option<String>,
    asking: Pending<StudyQuestion>,
}

impl StudyView {
    fn study(&self) -> Option<&Study> {
        self.asking.work.answer()
    }

    /// Returns the setting that was clicked, in the table or in the plot.
    fn setting(&self, picked: Picked) -> Option<Setting> {
        let rows = &self.study()?.rows;
        let row = match picked {
            Picked::Row(row) => rows.get(row)?,
            Picked::Point(point) => rows
                .iter()
                .filter(|row| study_point(row).is_some())
                .nth(point)?,
        };
        Some(row.setting)
    }
}

/// Choice of what to measure.
#[derive(Clone, Debug)]
struct Choices {
    question: StudyQuestion,
    /// Exponents separated by commas; the scene's own if empty.
    n: String,
}

impl Default for Choices {
    fn default() -> Self {
        Self {
            question: StudyQuestion {
                segments: vec![8, 16, 32, 64, 128],
                interpolations: vec![Interpolation::Perspective],
                ..StudyQuestion::default()
            },
            n: String::new(),
        }
    }
}

impl Choices {
    /// Returns the question to ask, or what is wrong with the choices.
    fn request(&self, scene: &Scene) -> Result<StudyQuestion, String> {
        let mut question = StudyQuestion {
            n: exponents(&self.n, scene)?,
            reference: self.question.reference.filter(|_| has_own_law(scene)),
            ..self.question.clone()
        };
        if question.methods.is_empty() || question.segments.is_empty() {
            return Err(text!("engine-study-nothing-chosen").to_owned());
        }
        question.methods.sort_by_key(|method| method.place());
        question
            .interpolations
            .sort_by_key(|interpolation| interpolation.place());
        Ok(question)
    }
}

/// Shows a switch that puts `value` into a list or takes it out.
fn switch_ui<T: PartialEq>(
    chosen: &mut Vec<T>,
    value: T,
    switch: impl FnOnce(&mut bool) -> Response,
) {
    let mut on = chosen.contains(&value);
    if switch(&mut on).changed() {
        chosen.retain(|other| *other != value);
        if on {
            chosen.push(value);
        }
    }
}

fn has_own_law(scene: &Scene) -> bool {
    scene.reflection.model == ReflectionModel::Formula
}

/// Parses the typed exponents.
fn exponents(text: &str, scene: &Scene) -> Result<Vec<f64>, String> {
    let words = text.split([',', ';', ' ']).filter(|word| !word.is_empty());
    let number = |word: &str| {
        let n = word
            .parse()
            .map_err(|_| text!("engine-study-no-number", word = word))?;
        let mut tried = scene.clone();
        tried.material.n = n;
        tried
            .validate()
            .map(|()| n)
            .map_err(|error| text!("engine-study-bad-n", problem = error.to_string()))
    };
    words.map(number).collect()
}

/// Shows the view of error against run time.
pub fn study_ui(
    ui: &mut Ui,
    view: &mut StudyView,
    session: &mut Session,
    window: &mut WindowState,
    requests: &mut Requests,
    engine: &Engine,
) {
    let size = engine.size;
    if size.contains(&0) {
        return;
    }
    view.asking.receive();
    ui.label(text!("engine-study-intro"));
    ui.add_space(4.0);
    let running = view.asking.work.progress().is_some();
    CollapsingHeader::new(text!("engine-study-choices"))
        .default_open(true)
        .show(ui, |ui| {
            ui.add_enabled_ui(!running, |ui| {
                choices_ui(ui, &mut view.choices);
                if has_own_law(&session.shown.scene) {
                    reference_ui(ui, &mut view.choices.question, &session.shown.scene);
                }
            });
        });
    ui.add_space(4.0);
    start_ui(ui, view, session, engine);
    if let Some(message) = &view.message {
        ui.label(RichText::new(message).weak());
    }
    if view.study().is_none() {
        return;
    }
    export_ui(ui, session, window, requests, "study", || {
        view.asking.latest()
    });
    ui.add_space(6.0);
    let picked = view.asking.view.picked_ui(ui, None);
    let setting = picked.and_then(|picked| view.setting(picked));
    if let (Some(setting), Some(study)) = (setting, view.study()) {
        view.message = Some(load(session, study, &setting));
    }
}

/// Shows a setting in the picture. Returns a sentence that says so, or why it cannot be shown.
fn load(session: &mut Session, study: &Study, setting: &Setting) -> String {
    let words = study.title(setting);
    if setting.load(&mut session.shown.scene) {
        text!("engine-study-shown", setting = words)
    } else {
        text!("engine-study-not-shown", setting = words)
    }
}

fn choices_ui(ui: &mut Ui, Choices { question, n }: &mut Choices) {
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = [4.0, 4.0].into();
        for method in Method::VALUES {
            switch_ui(&mut question.methods, *method, |on| {
                ui.toggle_value(on, method.label())
                    .on_hover_text(method.help())
            });
        }
    });
    ui.add_space(2.0);
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = [4.0, 4.0].into();
        ui.label(text!("engine-study-segments"));
        for segments in SEGMENTS {
            switch_ui(&mut question.segments, segments, |on| {
                ui.toggle_value(on, segments.to_string())
                    .on_hover_text(text!("engine-study-segments.tip"))
            });
        }
    });
    ui.add_space(2.0);
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        ui.label(text!("engine-study-frames"));
        for repeats in REPEATS {
            ui.selectable_value(&mut question.repeats, repeats, format!("{repeats} ×"))
                .on_hover_text(text!("engine-study-frames.tip"));
        }
        ui.add_space(8.0);
        switch_ui(&mut question.interpolations, Interpolation::Affine, |on| {
            ui.checkbox(on, text!("engine-study-affine"))
                .on_hover_text(text!("engine-study-affine.tip"))
        });
    });
    ui.horizontal(|ui| {
        let label = ui.label("n");
        let edit = text_field(n)
            .hint_text(text!("engine-study-n-hint"))
            .desired_width(220.0_f32.min(ui.available_width()));
        ui.add(edit).labelled_by(label.id);
    });
}

/// Shows the choice of the law beside the scene's own.
fn reference_ui(ui: &mut Ui, question: &mut StudyQuestion, scene: &Scene) {
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = [4.0, 4.0].into();
        ui.label(text!("engine-study-reference"));
        let mut chosen = question.reference(scene);
        for law in ReflectionModel::VALUES {
            ui.selectable_value(&mut chosen, *law, law.label())
                .on_hover_text(text!("engine-study-reference.tip"));
        }
        question.reference = Some(chosen);
    });
}

/// Shows the progress of the study, and the button that starts it.
fn start_ui(ui: &mut Ui, view: &mut StudyView, session: &Session, engine: &Engine) {
    let request = view.choices.request(&session.shown.scene);
    let asked = view.asking.work.answered().map(|asked| &asked.question);
    let stale = asked.is_some_and(|question| {
        view.asking
            .is_stale(&session.shown, |a, b| question.same(a, b))
    });
    let about = request.as_ref().map(|question| {
        let frames = frames(question, &session.shown.scene);
        let time = duration(engine.nanoseconds() as f64 * 1e-9 * frames as f64);
        text!("engine-study-about", frames = frames, time = time)
    });
    let about = about.unwrap_or_default();
    let offer = Offer {
        about: &about,
        start: text!("engine-measure"),
        problem: request.as_ref().err().map(String::as_str),
        stale,
    };
    if view.asking.state_ui(ui, &offer)
        && let Ok(question) = request
    {
        view.message = None;
        view.asking
            .start(ui.ctx(), &session.shown, engine.size, question);
    }
}

/// Returns about how many frames a study draws. The first of each setting is not timed.
fn frames(question: &StudyQuestion, scene: &Scene) -> usize {
    let drawn = |method: &Method| match method {
        Method::Flat | Method::FlatVertexMean => 1,
        _ => question.interpolations.len(),
    };
    let settings: usize = question.methods.iter().map(drawn).sum();
    let laws = 1 + usize::from(question.reference(scene) != scene.reflection.model);
    let exponents = question.n.len().max(1);
    laws * settings * question.segments.len() * exponents * (question.repeats as usize + 1)
}

/// Formats an approximate time in words.
pub fn duration(seconds: f64) -> String {
    if seconds < 1.5 {
        text!("engine-time-short").to_owned()
    } else if seconds < 90.0 {
        text!("engine-time-seconds", count = seconds.round())
    } else {
        text!("engine-time-minutes", count = (seconds / 60.0).round())
    }
}
