//! The lines that add up: what a line is called, and its red, green and blue. Some unfold to what stands behind them.

use super::figure::Figure;
use super::table::CHANNELS;
use crate::app::state::AppState;
use crate::app::typeset::{Piece, Place, Run};
use eframe::egui::accesskit::Role;
use eframe::egui::collapsing_header::{CollapsingState, paint_default_icon};
use eframe::egui::text::{LayoutJob, TextFormat, TextWrapping};
use eframe::egui::{Color32, FontId, Galley, Rect, Sense, Stroke, StrokeKind, Ui, WidgetInfo, pos2, vec2};
use glam::DVec3;
use std::sync::Arc;

/// Height of a line, points.
const LINE: f32 = 24.0;
/// Size of names and numbers, points.
const TEXT: f32 = 14.0;
/// Width of a channel's column, and of the space before it, points.
const COLUMN: f32 = 51.0;
const SPACE: f32 = 7.0;
/// Where names begin: behind the sign and the triangle, points.
const INDENT: f32 = 34.0;
/// Where they begin behind the sign alone, points.
const FLAT_INDENT: f32 = 14.0;
/// Size of letters that stand for a name, points.
const LETTERS: f32 = 16.0;
/// What symbols are called behind their names.
pub const AT_PROBE: &str = "at the probe";

/// What a line says at its right.
#[derive(Clone, Debug)]
pub enum Says {
    Channels([String; 3]),
    Words(String),
}

impl Says {
    /// Intensities.
    pub fn sum(value: DVec3) -> Self {
        Self::Channels(value.to_array().map(|part| Figure::new(part).text()))
    }

    fn spoken(&self) -> String {
        match self {
            Self::Channels([red, green, blue]) => format!("{red} red, {green} green, {blue} blue"),
            Self::Words(words) => words.clone(),
        }
    }
}

/// A line of the sum.
#[derive(Clone, Debug)]
pub struct Line<'a> {
    /// + or =.
    pub sign: &'static str,
    pub name: &'a str,
    pub says: Says,
    pub colour: Color32,
    /// Whether nothing unfolds, so that the name needs no room for a triangle.
    pub flat: bool,
    /// Whether letters stand in place of the name, which is spoken only.
    pub lettered: bool,
}

impl<'a> Line<'a> {
    /// A line that unfolds.
    pub fn new(name: &'a str, says: Says, colour: Color32) -> Self {
        Self { sign: "", name, says, colour, flat: false, lettered: false }
    }
}

/// The names of the channels over their columns.
pub fn channels_ui(ui: &mut Ui) {
    let weak = ui.visuals().weak_text_color();
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), LINE - 4.0), Sense::hover());
    for (index, channel) in CHANNELS.iter().enumerate() {
        let galley = ui.painter().layout_no_wrap((*channel).to_owned(), FontId::proportional(TEXT), weak);
        right(ui, galley, column(rect, index), rect, weak);
    }
}

/// A line that does not unfold.
pub fn line_ui(ui: &mut Ui, line: &Line<'_>) -> Rect {
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), LINE), Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, format!("{} {}", line.name, line.says.spoken())));
    paint(ui, line, rect);
    rect
}

/// A line that is called by `letters`, which light up their control.
pub fn letters_ui(ui: &mut Ui, state: &mut AppState, line: &Line<'_>, letters: &[Piece]) {
    let rect = line_ui(ui, line);
    let place = Place { id: ui.scope_id().with(("line", line.name)), name: AT_PROBE };
    let left = pos2(rect.min.x + FLAT_INDENT, rect.center().y);
    Run::new(ui, letters, LETTERS).paint(ui, state, left, place);
}

/// A line across, as under a written sum.
pub fn rule_ui(ui: &mut Ui) {
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), 5.0), Sense::hover());
    let stroke = Stroke::new(1.0, ui.visuals().weak_text_color());
    ui.painter().hline(column(rect, 0) - COLUMN..=rect.max.x, rect.center().y, stroke);
}

/// Whether a line that unfolds is open.
#[derive(Clone, Copy, Debug)]
pub struct Opening {
    pub at_first: bool,
    /// Opens or closes it in this frame.
    pub now: Option<bool>,
}

impl Opening {
    /// Open until it is folded.
    pub const OPEN: Self = Self { at_first: true, now: None };
}

/// A line that unfolds to `body`, by a click, Enter or the space bar.
pub fn fold_ui(ui: &mut Ui, salt: &str, line: &Line<'_>, opening: Opening, body: impl FnOnce(&mut Ui)) {
    let id = ui.make_persistent_id(salt);
    let mut state = CollapsingState::load_with_default_open(ui.ctx(), id, opening.at_first);
    let (_, rect) = ui.allocate_space(vec2(ui.available_width(), LINE));
    let response = ui.interact(rect, id, Sense::click());
    let toggled = opening.now.map_or(response.clicked(), |open| open != state.is_open());
    if toggled {
        state.toggle(ui);
    }
    let name = format!("{} at the probe: {}", line.name, line.says.spoken());
    response.widget_info(|| WidgetInfo::labeled(Role::DisclosureTriangle, ui.is_enabled(), &name));
    ui.ctx().accesskit_node_builder(id, |node| node.set_expanded(state.is_open()));
    if response.hovered() || response.has_focus() {
        let fill = ui.visuals().widgets.hovered.bg_fill.gamma_multiply(0.55);
        let stroke = if response.has_focus() { ui.visuals().widgets.active.bg_stroke } else { Stroke::NONE };
        ui.painter().rect(rect.expand2(vec2(2.0, 0.0)), 5.0, fill, stroke, StrokeKind::Inside);
    }
    let icon = Rect::from_center_size(pos2(rect.min.x + 22.0, rect.center().y), vec2(10.0, 10.0));
    let openness = state.openness(ui.ctx());
    paint_default_icon(ui, openness, &response.with_new_rect(icon));
    paint(ui, line, rect);
    state.show_body_unindented(ui, |ui| {
        body(ui);
        ui.add_space(6.0);
    });
}

fn paint(ui: &Ui, line: &Line<'_>, rect: Rect) {
    text(ui, line.sign, rect.min.x, rect, ui.visuals().weak_text_color(), INDENT);
    let left = rect.min.x + if line.flat { FLAT_INDENT } else { INDENT };
    match &line.says {
        Says::Channels(values) => {
            let galleys: Vec<_> = values
                .iter()
                .map(|value| ui.painter().layout_no_wrap(value.clone(), FontId::monospace(TEXT), line.colour))
                .collect();
            let mut free = rect.max.x;
            for (index, galley) in galleys.into_iter().enumerate() {
                let edge = column(rect, index);
                free = free.min(edge - galley.size().x.max(COLUMN));
                right(ui, galley, edge, rect, line.colour);
            }
            if !line.lettered {
                text(ui, line.name, left, rect, line.colour, free - SPACE - left);
            }
        }
        Says::Words(words) => {
            let weak = ui.visuals().weak_text_color();
            let galley = ui.painter().layout_no_wrap(words.clone(), FontId::proportional(TEXT), weak);
            let free = rect.max.x - galley.size().x - SPACE - left;
            right(ui, galley, rect.max.x, rect, weak);
            text(ui, line.name, left, rect, line.colour, free);
        }
    }
}

/// The right edge of a channel's column.
fn column(rect: Rect, index: usize) -> f32 {
    rect.max.x - (COLUMN + SPACE) * (2 - index) as f32
}

/// Paints words, cut short where they have no room.
fn text(ui: &Ui, words: &str, x: f32, rect: Rect, colour: Color32, room: f32) {
    let format = TextFormat { font_id: FontId::proportional(TEXT), color: colour, ..TextFormat::default() };
    let mut job = LayoutJob::single_section(words.to_owned(), format);
    job.wrap = TextWrapping::truncate_at_width(room.max(0.0));
    let galley = ui.painter().layout_job(job);
    let top = rect.center().y - galley.size().y / 2.0;
    ui.painter().galley(pos2(x, top), galley, colour);
}

fn right(ui: &Ui, galley: Arc<Galley>, edge: f32, rect: Rect, colour: Color32) {
    let place = pos2(edge - galley.size().x, rect.center().y - galley.size().y / 2.0);
    ui.painter().galley(place, galley, colour);
}
