//! The view of the probed point: the pixel, the equation filled in, the vectors, the construction of R and H, and the curves.

mod filled;

use super::curves::{CurvesView, beside_words, curves_ui};
use super::report::export_ui;
use crate::analysis::probe::{
    ConstructionStep, Here, HitMaterial, LightHere, Probe, ProbeHit, Probed, VectorsShown,
    WorkedStep, digits, draw_vectors,
};
use crate::app::engine::Engine;
use crate::app::session::Session;
use crate::app::session::action::Requests;
use crate::app::session::window::WindowState;
use crate::app::views::point::filled::{filled_ui, formula_ui};
use crate::app::widgets::drawing::{drawing_ui, plot_style};
use crate::app::widgets::heading::heading_ui;
use crate::app::widgets::letter::set;
use crate::app::widgets::palette::vector_text;
use crate::app::widgets::theme::TEXT;
use crate::figure::palette::Vector;
use crate::figure::{Drawing, PlotStyle};
use crate::scene::Scene;
use crate::text::{Language, language, text};
use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align, Button, CollapsingHeader, FontId, Grid, Label, Layout, RichText, Sense, Ui, WidgetInfo,
    WidgetText, vec2,
};

/// Height of a table's rows, in points.
const ROW: f32 = 21.0;
/// Width from which the vectors are beside the equation, in points.
const WIDE: f32 = 720.0;
/// Maximum width of the drawing of the vectors, in points.
const DRAWING: f32 = 480.0;
/// Width of the vectors' table where available, and the gap between its columns, in points; and the names' share of the width.
const TABLE: f32 = 300.0;
const GAP: f32 = 4.0;
const NAME: f32 = 0.22;
/// Font sizes of numbers in the steps, in points: the usual one, and the minimum in a narrow panel.
const NUMBERS: [f32; 2] = [14.0, 12.0];

/// The drawing of the vectors as last laid out.
#[derive(Debug, Default)]
struct VectorsView {
    shown: VectorsShown,
    laid_out: Option<(LaidOutFor, Option<Drawing>)>,
}

/// The probe, the light, what is shown, the width, the style and the language.
type LaidOutFor = (u64, usize, VectorsShown, f32, PlotStyle, Language);

/// Shows everything about the probed point.
pub fn point_ui(
    ui: &mut Ui,
    session: &mut Session,
    window: &mut WindowState,
    requests: &mut Requests,
    engine: &Engine,
) {
    let (Some(probe), Some(scene)) = (engine.probed(), engine.drawn()) else {
        return;
    };
    match &probe.hit {
        None => background_ui(ui, probe, scene),
        Some(hit) => {
            let scene = &hit.scene_of(scene);
            let here = Here { scene, hit };
            hit_ui(ui, session, window, requests, engine, here, probe);
        }
    }
    ui.add_space(4.0);
    CollapsingHeader::new(RichText::new(text!("point-curves")).strong())
        .id_salt("curves-of-point")
        .show_unindented(ui, |ui| {
            let mut own: CurvesView = window.own.take();
            curves_ui(ui, &mut own, session, window, requests, engine);
            window.own.put(own);
        });
}

fn background_ui(ui: &mut Ui, probe: &Probe, scene: &Scene) {
    let [x, y] = probe.pixel;
    ui.label(RichText::new(text!("point-pixel", x = x, y = y)).strong());
    ui.add_space(4.0);
    ui.label(beside_words(probe, scene));
}

fn hit_ui(
    ui: &mut Ui,
    session: &mut Session,
    window: &mut WindowState,
    requests: &mut Requests,
    engine: &Engine,
    here: Here<'_>,
    probe: &Probe,
) {
    if ui.available_width() < WIDE {
        sum_ui(ui, session, window, requests, engine, here, probe);
        ui.separator();
        vectors_ui(ui, session, window, engine, here);
        return;
    }
    ui.columns_const(|[sum, vectors]| {
        sum_ui(sum, session, window, requests, engine, here, probe);
        vectors_ui(vectors, session, window, engine, here);
    });
}

/// Shows the pixel and the equation.
fn sum_ui(
    ui: &mut Ui,
    session: &mut Session,
    window: &mut WindowState,
    requests: &mut Requests,
    engine: &Engine,
    here: Here<'_>,
    probe: &Probe,
) {
    pixel_ui(ui, session, probe, here.hit);
    ui.add_space(8.0);
    filled_ui(ui, session, here);
    ui.add_space(4.0);
    let light = session.light;
    export_ui(ui, session, window, requests, "probe", || {
        let answer = Probed::of(probe.clone(), light);
        Some((Box::new(answer), engine.drawn()?.clone()))
    });
    ui.add_space(4.0);
}

/// Shows the pixel, its stored colour, and the position of its centre on the object.
fn pixel_ui(ui: &mut Ui, session: &Session, probe: &Probe, hit: &ProbeHit) {
    let [x, y] = probe.pixel;
    let mut pixel = text!("point-pixel", x = x, y = y);
    let scene = &session.document().scene;
    if scene.shown_panes().len() > 1 {
        let pane = scene.pane_name(session.panes.active);
        pixel = text!("point-pixel-of-pane", pixel = pixel, pane = pane);
    }
    let [r, g, b] = hit.stored;
    heading_ui(ui, Some(hit.stored), |ui| {
        ui.horizontal_wrapped(|ui| {
            ui.label(RichText::new(pixel).strong());
            ui.label(RichText::new(format!("{r:>3} {g:>3} {b:>3}")).monospace())
                .on_hover_text(text!("point-stored-tip"));
        });
        let depth = format!("{:.3}", hit.depth);
        let place = match hit.face {
            Some(face) => text!("point-place-face", face = face.to_string(), depth = depth),
            None => text!("point-place-surface", depth = depth),
        };
        ui.label(RichText::new(place).weak());
        if let Some(HitMaterial { name, .. }) = &hit.material {
            let material = text!("point-material", name = name.as_str());
            ui.label(RichText::new(material).weak());
        }
    });
}

/// Shows the vectors and the angles between them for the chosen light: drawn, constructed and in numbers.
fn vectors_ui(
    ui: &mut Ui,
    session: &Session,
    window: &mut WindowState,
    engine: &Engine,
    here: Here<'_>,
) {
    let count = here.hit.lights.len();
    let light = session.light.min(count.saturating_sub(1));
    let title = if count > 1 {
        text!("point-vectors-of", light = light + 1)
    } else {
        text!("point-vectors").to_owned()
    };
    ui.label(RichText::new(title).strong());
    if let Some(chosen) = here.lights().nth(light) {
        let mut own: VectorsView = window.own.take();
        let steps = chosen.construction();
        if matches!(own.shown, VectorsShown::Step(step) if steps.iter().all(|worked| worked.step != step))
        {
            own.shown = VectorsShown::Angles;
        }
        own.drawing_ui(ui, engine.revision, here, chosen);
        own.stepper_ui(ui, &steps);
        steps_ui(ui, own.shown, &steps, chosen);
        window.own.put(own);
    } else {
        ui.label(text!("point-no-light"));
    }
    ui.add_space(6.0);
    numbers_ui(ui, here, light);
}

impl VectorsView {
    fn drawing_ui(&mut self, ui: &mut Ui, revision: u64, here: Here<'_>, light: LightHere<'_>) {
        let (style, width) = (plot_style(ui), ui.available_width().min(DRAWING));
        let key = (revision, light.index, self.shown, width, style, language());
        if self.laid_out.as_ref().is_none_or(|(laid, _)| *laid != key) {
            let drawing = draw_vectors(here, light.index, self.shown, width.into(), &style);
            self.laid_out = Some((key, drawing));
        }
        let Some((_, Some(drawing))) = &self.laid_out else {
            ui.label(text!("point-no-direction"));
            return;
        };
        let words = || {
            let angles = light.angles();
            let list: Vec<_> = angles
                .iter()
                .map(|(name, value)| format!("{name} {value}"))
                .collect();
            text!("point-drawing", list = list.join("; "))
        };
        ui.vertical_centered(|ui| _ = drawing_ui(ui, drawing, Sense::hover(), words));
    }

    /// Shows the buttons for one step back, one step forward, and all steps at once.
    fn stepper_ui(&mut self, ui: &mut Ui, steps: &[WorkedStep]) {
        let stops: Vec<_> = [VectorsShown::Angles]
            .into_iter()
            .chain(steps.iter().map(|worked| VectorsShown::Step(worked.step)))
            .chain([VectorsShown::Construction])
            .collect();
        let at = stops
            .iter()
            .position(|stop| *stop == self.shown)
            .unwrap_or(0);
        ui.horizontal_wrapped(|ui| {
            let before = at.checked_sub(1);
            let after = Some(at + 1).filter(|after| *after < stops.len());
            for (sign, name, to) in [
                ("◀", text!("point-previous-step"), before),
                ("▶", text!("point-next-step"), after),
            ] {
                let response = ui.add_enabled(to.is_some(), Button::new(sign));
                response.widget_info(|| WidgetInfo::labeled(Role::Button, to.is_some(), name));
                if response.on_hover_text(name).clicked() {
                    self.shown = to.map_or(self.shown, |to| stops[to]);
                }
            }
            let all = self.shown == VectorsShown::Construction;
            if ui
                .add(Button::selectable(all, text!("point-all-steps")))
                .clicked()
            {
                self.shown = if all {
                    VectorsShown::Angles
                } else {
                    VectorsShown::Construction
                };
            }
        });
        let title = match self.shown {
            VectorsShown::Angles => text!("point-construction-hint").to_owned(),
            VectorsShown::Step(step) => text!(
                "point-step",
                number = at,
                count = steps.len(),
                title = step.title()
            ),
            VectorsShown::Construction => return,
        };
        ui.label(RichText::new(title).weak());
    }
}

/// Shows the visible steps with their numbers.
fn steps_ui(ui: &mut Ui, shown: VectorsShown, steps: &[WorkedStep], light: LightHere<'_>) {
    let values = light.values();
    for worked in steps {
        let alone = shown == VectorsShown::Step(worked.step);
        if !alone && shown != VectorsShown::Construction {
            continue;
        }
        let id = ui.scope_id().with(("step", worked.step as usize));
        ui.scope(|ui| {
            ui.spacing_mut().item_spacing.y = 2.0;
            formula_ui(ui, worked.formula, &values, id);
            for line in &worked.numbers {
                line_ui(ui, &format!("= {line}"));
            }
        });
        match worked.step {
            ConstructionStep::Mirror => _ = ui.label(light.mirror_check()),
            ConstructionStep::Cosine if steps.len() < ConstructionStep::ALL.len() - 1 => {
                ui.label(text!("point-behind"));
            }
            _ => {}
        }
        ui.add_space(4.0);
    }
}

/// Shows a line of numbers, split into two if the panel is too narrow for two vectors.
fn line_ui(ui: &mut Ui, text: &str) {
    let colour = ui.visuals().text_color();
    let job = |text: &str, size| set(text, FontId::monospace(size), colour);
    let [most, least] = NUMBERS;
    let width = ui.painter().layout_job(job(text, most)).size().x;
    let size = most * ui.available_width() / width;
    let second = [") + (", ") − ("].iter().find_map(|sign| text.find(sign));
    match second.filter(|_| size < least) {
        Some(end) => {
            let (first, second) = text.split_at(end + 1);
            ui.label(job(first, most));
            ui.label(job(&format!(" {second}"), most));
        }
        None => _ = ui.label(job(text, size.clamp(least, most))),
    }
}

/// Shows a cell of a table. Text is aligned left; numbers are aligned right, in columns of equal width.
fn cell(ui: &mut Ui, text: impl Into<WidgetText>, width: f32, align: Align) {
    ui.allocate_ui_with_layout(vec2(width, ROW), Layout::top_down(align), |ui| {
        ui.set_min_width(width);
        ui.add(Label::new(text).extend().selectable(true));
    });
}

/// Shows the coordinates of the vectors, and the angles between them, for one light.
fn numbers_ui(ui: &mut Ui, here: Here<'_>, light: usize) {
    let visuals = ui.visuals().clone();
    // Three numbers beside a name fit into a narrow panel.
    let room = ui.available_width().min(TABLE);
    let name_width = NAME * room;
    let number_width = (room - name_width) / 3.0 - GAP;
    let light = here.lights().nth(light);
    Grid::new("vectors")
        .num_columns(4)
        .spacing([GAP, 2.0])
        .min_row_height(ROW)
        .show(ui, |ui| {
            cell(ui, "", name_width, Align::Min);
            for head in ["x", "y", "z"] {
                cell(ui, RichText::new(head).weak(), number_width, Align::Max);
            }
            ui.end_row();
            for (vector, _, v) in here
                .vectors()
                .into_iter()
                .chain(light.iter().flat_map(|light| light.vectors()))
            {
                let colour =
                    vector.map_or(visuals.text_color(), |vector| vector_text(&visuals, vector));
                let name = vector.map_or(text!("point-position-short"), Vector::letter);
                let name = RichText::new(name).color(colour);
                cell(ui, name, name_width, Align::Min);
                for value in v.to_array() {
                    // Rounded, so that the residue of a 0 shows no digits.
                    let number = digits((value * 1e4).round() / 1e4);
                    let number = set(&number, FontId::monospace(TEXT), colour);
                    cell(ui, number, number_width, Align::Max);
                }
                ui.end_row();
            }
        });
    ui.add_space(6.0);
    Grid::new("angles")
        .num_columns(2)
        .spacing([GAP, 2.0])
        .min_row_height(ROW)
        .show(ui, |ui| {
            for (name, value) in light.iter().flat_map(|light| light.angles()) {
                cell(ui, RichText::new(name), name_width, Align::Min);
                let value = set(&value, FontId::monospace(TEXT), visuals.text_color());
                cell(ui, value, number_width, Align::Max);
                ui.end_row();
            }
        });
}
