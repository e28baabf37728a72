//! The tab of error against run time: what to measure, the plot while points come in, and the table.

mod figure;

use super::background::{progress_ui, wake};
use super::engine::Engine;
use super::report::{ReportView, export_ui};
use super::state::AppState;
use crate::analysis::{About, Answer, Method, Part, Plot, Setting, Study, StudyQuestion, study_plot};
use crate::jobs::{Asked, Background};
use crate::scene::{Interpolation, Scene};
use eframe::egui::{Button, RichText, TextEdit, Ui};
use figure::{LaidOut, figure_ui};

/// Tessellations to choose from, in segments.
const SEGMENTS: [u32; 8] = [4, 8, 16, 32, 64, 128, 256, 512];
/// Frames timed for each setting, to choose from.
const REPEATS: [u32; 3] = [3, 9, 27];

/// The tab's state.
#[derive(Debug, Default)]
pub struct StudyView {
    choices: Choices,
    /// What became of the point that was chosen last.
    message: Option<String>,
    work: Background<Asked<StudyQuestion>>,
    view: ReportView,
    plot: Option<Plot>,
    drawing: Option<LaidOut>,
}

impl StudyView {
    fn study(&self) -> Option<&Study> {
        self.work.answer()
    }

    /// Takes what is new; the plot is drawn apart, since its points can be chosen.
    fn receive(&mut self, scene: &Scene) {
        if !self.work.take() {
            return;
        }
        let Some(study) = self.work.answer() else { return };
        let mut report = study.report(&About { name: "", scene });
        report.sections.iter_mut().for_each(|section| section.parts.retain(|part| !matches!(part, Part::Plot(_))));
        (self.plot, self.drawing) = (study_plot(study), None);
        self.view.set(report);
    }

    fn answer(&self) -> Option<(Box<dyn Answer>, Scene)> {
        Some((Box::new(self.study()?.clone()), self.work.answered()?.subject().scene))
    }
}

/// What is chosen to be measured.
#[derive(Clone, Debug)]
pub struct Choices {
    methods: [bool; Method::ALL.len()],
    segments: [bool; SEGMENTS.len()],
    affine: bool,
    repeats: u32,
    /// Exponents between commas; the scene's own where there is nothing.
    n: String,
}

impl Default for Choices {
    fn default() -> Self {
        let segments = SEGMENTS.map(|segments| (8..=128).contains(&segments));
        Self { methods: [true; Method::ALL.len()], segments, affine: false, repeats: REPEATS[1], n: String::new() }
    }
}

impl Choices {
    /// What is asked for, or what is wrong with it.
    fn request(&self, scene: &Scene) -> Result<StudyQuestion, String> {
        fn chosen<T: Copy>(all: &[T], which: &[bool]) -> Vec<T> {
            all.iter().zip(which).filter(|(_, on)| **on).map(|(value, _)| *value).collect()
        }
        let mut interpolations = vec![Interpolation::Perspective];
        if self.affine {
            interpolations.push(Interpolation::Affine);
        }
        let request = StudyQuestion {
            methods: chosen(&Method::ALL, &self.methods),
            segments: chosen(&SEGMENTS, &self.segments),
            interpolations,
            n: exponents(&self.n, scene)?,
            repeats: self.repeats,
        };
        if request.methods.is_empty() || request.segments.is_empty() {
            return Err("Choose at least one method and one tessellation.".to_owned());
        }
        Ok(request)
    }
}

/// The exponents that are typed.
fn exponents(text: &str, scene: &Scene) -> Result<Vec<f64>, String> {
    let words = text.split([',', ';', ' ']).filter(|word| !word.is_empty());
    let number = |word: &str| {
        let n = word.parse().map_err(|_| format!("n: “{word}” is no number."))?;
        let mut tried = scene.clone();
        tried.material.n = n;
        tried.validate().map(|()| n).map_err(|error| format!("n: {error}."))
    };
    words.map(number).collect()
}

/// The tab.
pub fn study_ui(ui: &mut Ui, view: &mut StudyView, state: &mut AppState, engine: &Engine) {
    let size = engine.size;
    if size.contains(&0) {
        return;
    }
    view.receive(&state.shown.scene);
    ui.label(
        "Every way of shading at every tessellation against the exact picture: how far off, and how long it takes.",
    );
    ui.add_space(4.0);
    let running = view.work.progress().is_some();
    ui.add_enabled_ui(!running, |ui| choices_ui(ui, &mut view.choices));
    ui.add_space(4.0);
    if !progress_ui(ui, &view.work, "Keeps what is known so far") {
        start_ui(ui, view, state, size);
    }
    let rows = view.work.answer().map_or(&[][..], |study| &study.rows);
    let mut asked = view.plot.as_ref().and_then(|plot| figure_ui(ui, plot, &mut view.drawing, rows));
    let refused = view.work.known().and_then(|known| known.as_ref().err());
    if let Some(message) = view.message.as_ref().or(refused) {
        ui.label(RichText::new(message).weak());
    }
    if view.study().is_some() {
        export_ui(ui, state, "study", || view.answer());
        let row = view.view.picked_ui(ui);
        asked = row.and_then(|row| Some(view.study()?.rows.get(row)?.setting)).or(asked);
    }
    if let Some(setting) = asked {
        load(view, state, &setting);
    }
}

/// Shows a setting in the picture, or says why it cannot.
fn load(view: &mut StudyView, state: &mut AppState, setting: &Setting) {
    let words = setting.title();
    view.message = Some(if setting.load(&mut state.shown.scene) {
        format!("The picture shows {words}. Undo leads back.")
    } else {
        format!("{words}: this historic method is measured apart and is no mode of the picture; it cannot be shown.")
    });
}

fn choices_ui(ui: &mut Ui, choices: &mut Choices) {
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = [4.0, 4.0].into();
        for (method, on) in Method::ALL.into_iter().zip(&mut choices.methods) {
            ui.toggle_value(on, method.title()).on_hover_text(says(method));
        }
    });
    ui.add_space(2.0);
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = [4.0, 4.0].into();
        ui.label("Segments");
        for (segments, on) in SEGMENTS.into_iter().zip(&mut choices.segments) {
            ui.toggle_value(on, segments.to_string()).on_hover_text("Polygons round the axis; rings go with them");
        }
    });
    ui.add_space(2.0);
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        ui.label("Frames timed");
        for repeats in REPEATS {
            ui.selectable_value(&mut choices.repeats, repeats, format!("{repeats} ×"));
        }
        ui.add_space(8.0);
        ui.checkbox(&mut choices.affine, "Affine too")
            .on_hover_text("Interpolation in the picture as well as in space");
    });
    ui.horizontal(|ui| {
        let label = ui.label("n");
        let edit =
            TextEdit::singleline(&mut choices.n).hint_text("the scene's own; or 5, 50, 500").desired_width(220.0);
        ui.add(edit).labelled_by(label.id);
    });
}

fn says(method: Method) -> &'static str {
    match method {
        Method::Flat => "One intensity a face, at its centre",
        Method::FlatVertexMean => "One intensity a face, the mean of those at its vertices",
        Method::Interpolated => "Intensities at vertices with the face's own normal",
        Method::Gouraud => "Intensities at vertices with their normals, interpolated",
        Method::Phong => "Normals interpolated and made unit vectors at each pixel",
        Method::PhongUnnormalised => "Normals interpolated and left as they are",
        Method::PhongScalar => {
            "Phong shading in the scalar code of the two historic methods, to compare their times with"
        }
        Method::Taylor => {
            "Bishop and Weimer 1986: the cosines' Taylor expansion over each triangle, by forward differences"
        }
        Method::Angular => "Kuijk and Blake 1989: normals turn by equal angles along edges and spans",
    }
}

fn start_ui(ui: &mut Ui, view: &mut StudyView, state: &AppState, size: [u32; 2]) {
    let question = view.choices.request(&state.shown.scene);
    let tip = "Measures the active picture at its present size. Times are best while nothing else is touched";
    let start = ui.add_enabled(question.is_ok(), Button::new("Start")).on_hover_text(tip);
    match question {
        Err(problem) => _ = ui.label(RichText::new(problem).color(ui.visuals().warn_fg_color)),
        Ok(question) if start.clicked() => {
            let asked = Asked::new(question, &state.shown.scene, state.shown.model.as_ref(), size);
            *view = StudyView { choices: view.choices.clone(), ..StudyView::default() };
            view.work.start(asked, wake(ui.ctx()));
        }
        Ok(_) => {}
    }
}
