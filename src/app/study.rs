//! The tab of error against run time: what to measure, the plot while points come in, and the table.

use super::background::{progress_ui, wake};
use super::drawing::drawing_ui;
use super::drawing::{boxed, height, plot_style};
use super::engine::Engine;
use super::report::{ReportView, export_ui};
use super::state::AppState;
use crate::analysis::{
    About, Answer, Method, Part, Plot, Setting, Study, StudyQuestion, StudyRow, study_plot,
    study_point,
};
use crate::figure::{Drawing, PlotStyle, Text, lay_out};
use crate::jobs::{Asked, Background};
use crate::scene::{Choice, Interpolation, Scene};
use eframe::egui::{Button, CursorIcon, Pos2, Rect, Response, RichText, Sense, TextEdit, Ui, pos2};
use glam::DVec2;

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
        let Some(study) = self.work.answer() else {
            return;
        };
        let mut report = study.report(&About { name: "", scene });
        report
            .sections
            .iter_mut()
            .for_each(|section| section.parts.retain(|part| !matches!(part, Part::Plot(_))));
        (self.plot, self.drawing) = (study_plot(study), None);
        self.view.set(report);
    }

    fn answer(&self) -> Option<(Box<dyn Answer>, Scene)> {
        Some((
            Box::new(self.study()?.clone()),
            self.work.answered()?.subject().scene,
        ))
    }
}

/// What is chosen to be measured.
#[derive(Clone, Debug)]
struct Choices {
    question: StudyQuestion,
    /// Exponents between commas; the scene's own where there is nothing.
    n: String,
}

impl Default for Choices {
    fn default() -> Self {
        let (segments, interpolations) =
            (vec![8, 16, 32, 64, 128], vec![Interpolation::Perspective]);
        Self {
            question: StudyQuestion {
                segments,
                interpolations,
                ..StudyQuestion::default()
            },
            n: String::new(),
        }
    }
}

impl Choices {
    /// What is asked for, or what is wrong with it.
    fn request(&self, scene: &Scene) -> Result<StudyQuestion, String> {
        let mut question = StudyQuestion {
            n: exponents(&self.n, scene)?,
            ..self.question.clone()
        };
        if question.methods.is_empty() || question.segments.is_empty() {
            return Err("Choose at least one method and one tessellation.".to_owned());
        }
        question.methods.sort_by_key(|method| method.place());
        question
            .interpolations
            .sort_by_key(|interpolation| interpolation.place());
        Ok(question)
    }
}

/// A switch that puts `value` into a list and takes it out.
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

/// The exponents that are typed.
fn exponents(text: &str, scene: &Scene) -> Result<Vec<f64>, String> {
    let words = text.split([',', ';', ' ']).filter(|word| !word.is_empty());
    let number = |word: &str| {
        let n = word
            .parse()
            .map_err(|_| format!("n: “{word}” is no number."))?;
        let mut tried = scene.clone();
        tried.material.n = n;
        tried
            .validate()
            .map(|()| n)
            .map_err(|error| format!("n: {error}."))
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
    let mut asked = view
        .plot
        .as_ref()
        .and_then(|plot| figure_ui(ui, plot, &mut view.drawing, rows));
    let refused = view.work.known().and_then(|known| known.as_ref().err());
    if let Some(message) = view.message.as_ref().or(refused) {
        ui.label(RichText::new(message).weak());
    }
    if view.study().is_some() {
        export_ui(ui, state, "study", || view.answer());
        let row = view.view.picked_ui(ui);
        asked = row
            .and_then(|row| Some(view.study()?.rows.get(row)?.setting))
            .or(asked);
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
        format!(
            "{words}: this historic method is measured apart and is no mode of the picture; it cannot be shown."
        )
    });
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
        ui.label("Segments");
        for segments in SEGMENTS {
            let tip = "Polygons round the axis; rings go with them";
            switch_ui(&mut question.segments, segments, |on| {
                ui.toggle_value(on, segments.to_string()).on_hover_text(tip)
            });
        }
    });
    ui.add_space(2.0);
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        ui.label("Frames timed");
        for repeats in REPEATS {
            ui.selectable_value(&mut question.repeats, repeats, format!("{repeats} ×"));
        }
        ui.add_space(8.0);
        let tip = "Interpolation in the picture as well as in space";
        switch_ui(&mut question.interpolations, Interpolation::Affine, |on| {
            ui.checkbox(on, "Affine too").on_hover_text(tip)
        });
    });
    ui.horizontal(|ui| {
        let label = ui.label("n");
        let edit = TextEdit::singleline(n)
            .hint_text("the scene's own; or 5, 50, 500")
            .desired_width(220.0);
        ui.add(edit).labelled_by(label.id);
    });
}

fn start_ui(ui: &mut Ui, view: &mut StudyView, state: &AppState, size: [u32; 2]) {
    let question = view.choices.request(&state.shown.scene);
    let tip = "Measures the active picture at its present size. Times are best while nothing else is touched";
    let start = ui
        .add_enabled(question.is_ok(), Button::new("Start"))
        .on_hover_text(tip);
    match question {
        Err(problem) => _ = ui.label(RichText::new(problem).color(ui.visuals().warn_fg_color)),
        Ok(question) if start.clicked() => {
            let asked = Asked::new(
                question,
                &state.shown.scene,
                state.shown.model.as_ref(),
                size,
            );
            *view = StudyView {
                choices: view.choices.clone(),
                ..StudyView::default()
            };
            view.work.start(asked, wake(ui.ctx()));
        }
        Ok(_) => {}
    }
}

/// A point is meant within this many points of the pointer.
const NEAR: f32 = 16.0;

/// A plot laid out for a style and a width.
type LaidOut = (Drawing, PlotStyle, f32);

/// The plot; returns the setting whose point is clicked.
fn figure_ui(
    ui: &mut Ui,
    plot: &Plot,
    laid_out: &mut Option<LaidOut>,
    rows: &[StudyRow],
) -> Option<Setting> {
    let style = plot_style(ui);
    let width = ui.available_width();
    let kept = laid_out
        .take()
        .filter(|(_, laid, wide)| *laid == style && *wide == width);
    let (drawing, ..) = &*laid_out.insert(kept.unwrap_or_else(|| {
        let room = DVec2::new(
            width.into(),
            height(plot, width.into(), style.text) + 0.3 * f64::from(width),
        );
        (lay_out(plot, room, &style), style, width)
    }));
    ui.add_space(6.0);
    let words_for_readers = || format!("{}; {}", plot.title, plot.note);
    let (response, painter) = drawing_ui(ui, drawing, Sense::click(), words_for_readers)?;
    let rect = response.rect;
    let pointer = response.hover_pos()?;
    let row = nearest(rows, drawing, rect, pointer)?;
    ui.ctx().set_cursor_icon(CursorIcon::PointingHand);
    let lines: Vec<Text> = words(row)
        .into_iter()
        .map(|line| Text::new(line, DVec2::ZERO, style.text, style.paper.text))
        .collect();
    boxed(ui, &painter, &lines, (rect, pointer));
    response.clicked().then_some(row.setting)
}

/// The row whose point is nearest to the pointer.
fn nearest<'a>(
    rows: &'a [StudyRow],
    drawing: &Drawing,
    rect: Rect,
    pointer: Pos2,
) -> Option<&'a StudyRow> {
    let away = |row: &StudyRow| {
        let (at, _) = drawing.place(study_point(row)?)?;
        Some(pos2(rect.min.x + at.x as f32, rect.min.y + at.y as f32).distance(pointer))
    };
    let near = rows
        .iter()
        .filter_map(|row| Some((row, away(row)?)))
        .filter(|(_, away)| *away <= NEAR);
    near.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(row, _)| row)
}

/// A row in a few lines.
fn words(row: &StudyRow) -> [String; 4] {
    let setting = &row.setting;
    let go = if row.scalar {
        "a historic method: cannot be shown"
    } else {
        "click to show it"
    };
    [
        format!("{}, n = {}", setting.title(), setting.n),
        format!(
            "RMS {:.3}, greatest {:.2} code values",
            255.0 * row.error_rms,
            255.0 * row.error_max
        ),
        format!(
            "{:.3} ms ± {:.3}, {} evaluations",
            row.time_ms, row.spread_ms, row.evaluations
        ),
        go.to_owned(),
    ]
}
