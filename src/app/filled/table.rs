//! A term as a table: its letters in textbook order, and under them a line of numbers for each channel.

use super::figure::{Figure, column as figures};
use super::notation::{Notation, Vectors};
use crate::analysis::{Product, TermColumn as Column};
use crate::app::state::AppState;
use crate::app::typeset::{Piece, Place, Run};
use eframe::egui::accesskit::Role;
use eframe::egui::text::LayoutJob;
use eframe::egui::{Color32, FontId, Galley, Rect, Sense, Ui, WidgetInfo, pos2, vec2};
use glam::DVec3;
use std::sync::Arc;

/// Size of the letters, points.
const LETTERS: f32 = 16.0;
/// Size of the numbers, points.
const DIGITS: f32 = 14.0;
/// Height of a line of numbers, points.
const LINE: f32 = 20.0;
/// Width of the channel's letter in front of a line, points.
const MARK: f32 = 16.0;
/// Space between two columns for the sign there, points: as much as there is, between these.
const GAPS: [f32; 2] = [9.0, 16.0];
/// Formulas shrink no further than this to fit a narrow panel.
pub const LEAST_SCALE: f32 = 0.7;

pub const CHANNELS: [&str; 3] = ["red", "green", "blue"];

/// A term with the letters of its columns.
pub struct Table<'a> {
    /// What the term is called, for a screen reader.
    pub name: &'a str,
    pub columns: Vec<(Vec<Piece>, &'a Column)>,
    pub value: DVec3,
    /// The colour of its value.
    pub colour: Color32,
}

/// A column laid out.
struct Laid<'a> {
    head: Run<'a>,
    numbers: [Arc<Galley>; 3],
    digits: f32,
    width: f32,
    sign: &'static str,
    mean: bool,
}

impl<'a> Table<'a> {
    /// The table of a product, its letters and its value in one colour; `vectors` are those among its letters.
    pub fn new(name: &'a str, product: &'a Product, notation: &Notation, colour: Color32, vectors: &Vectors) -> Self {
        let columns = product.columns.iter().map(|column| (notation.head(column, colour, vectors), column)).collect();
        Self { name, columns, value: product.value, colour }
    }

    pub fn ui(&self, ui: &mut Ui, state: &mut AppState, place: Place<'_>) {
        let gaps = self.columns.len() as f32;
        let room = (ui.available_width() - MARK).max(0.0);
        let natural = self.lay_out(ui, 1.0);
        let width = total(&natural);
        let scale = ((room - gaps * GAPS[0]) / width).clamp(LEAST_SCALE, 1.0);
        let laid = if scale < 1.0 { self.lay_out(ui, scale) } else { natural };
        let gap = ((room - total(&laid)) / gaps).clamp(GAPS[0], GAPS[1]);
        let height = LETTERS * 1.6 + 3.0 * LINE;
        let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
        self.paint(ui, state, &laid, rect, gap, place);
        self.describe(ui, rect, place);
    }

    fn lay_out(&self, ui: &Ui, scale: f32) -> Vec<Laid<'_>> {
        let plain = ui.visuals().text_color();
        let mut laid: Vec<_> = self
            .columns
            .iter()
            .enumerate()
            .map(|(index, (head, column))| {
                let numbers = figures(column.values).map(|figure| galley(ui, &figure, DIGITS * scale, plain));
                let sign = match (index, column.added) {
                    (0, _) => "",
                    (_, true) => "+",
                    (_, false) => "·",
                };
                Laid::new(Run::new(ui, head, LETTERS * scale.max(0.85)), numbers, sign, column.mean)
            })
            .collect();
        let value = self.value.to_array().map(|value| galley(ui, &Figure::new(value), DIGITS * scale, self.colour));
        laid.push(Laid::new(Run::new(ui, &[], LETTERS), value, "=", false));
        laid
    }

    fn paint(&self, ui: &mut Ui, state: &mut AppState, laid: &[Laid<'_>], rect: Rect, gap: f32, place: Place<'_>) {
        let weak = ui.visuals().weak_text_color();
        let head = LETTERS * 1.6;
        let line = |channel: usize| rect.min.y + head + LINE * (channel as f32 + 0.5);
        for (channel, name) in CHANNELS.iter().enumerate() {
            let mark = ui.painter().layout_no_wrap(name[..1].to_owned(), FontId::proportional(DIGITS), weak);
            place_at(ui, mark, rect.min.x, line(channel), weak);
        }
        let mut x = rect.min.x + MARK;
        for (index, column) in laid.iter().enumerate() {
            if index + 1 == laid.len() {
                // Values stand below each other, whatever number of factors they have.
                x = x.max(rect.max.x - column.width - gap);
            }
            if index > 0 {
                for channel in 0..3 {
                    let sign = ui.painter().layout_no_wrap(column.sign.to_owned(), FontId::monospace(DIGITS), weak);
                    let left = x + (gap - sign.size().x) / 2.0;
                    place_at(ui, sign, left, line(channel), weak);
                }
                x += gap;
            }
            column.paint_head(ui, state, x, rect.min.y + head / 2.0, Place { id: place.id.with(index), ..place });
            let right = x + (column.width + column.digits) / 2.0;
            for (channel, number) in column.numbers.iter().enumerate() {
                place_at(ui, Arc::clone(number), right - number.size().x, line(channel), ui.visuals().text_color());
            }
            x += column.width;
        }
    }

    /// The lines of numbers as sentences.
    fn describe(&self, ui: &Ui, rect: Rect, place: Place<'_>) {
        let columns: Vec<_> = self.columns.iter().map(|(_, column)| (column.added, figures(column.values))).collect();
        for (channel, name) in CHANNELS.iter().enumerate() {
            let mut text = format!("{} {name}: ", self.name);
            for (index, (added, figures)) in columns.iter().enumerate() {
                let sign = if index == 0 {
                    ""
                } else if *added {
                    " + "
                } else {
                    " · "
                };
                text += &format!("{sign}{}", figures[channel].text());
            }
            text += &format!(" = {}", Figure::new(self.value[channel]).text());
            let top = rect.min.y + LETTERS * 1.6 + LINE * channel as f32;
            let line = Rect::from_min_size(pos2(rect.min.x, top), vec2(rect.width(), LINE));
            let response = ui.interact(line, place.id.with(("line", channel)), Sense::hover());
            response.widget_info(|| WidgetInfo::labeled(Role::Label, true, &text));
        }
    }
}

impl<'a> Laid<'a> {
    fn new(head: Run<'a>, numbers: [Arc<Galley>; 3], sign: &'static str, mean: bool) -> Self {
        let digits = numbers.iter().map(|number| number.size().x).fold(0.0, f32::max);
        let width = digits.max(head.width());
        Self { head, numbers, digits, width, sign, mean }
    }

    /// The letters over the numbers; a mean has the line above them that the textbooks draw.
    fn paint_head(&self, ui: &mut Ui, state: &mut AppState, x: f32, y: f32, place: Place<'_>) {
        let left = x + (self.width - self.head.width()) / 2.0;
        self.head.paint(ui, state, pos2(left, y), place);
        if self.mean {
            let top = y - LETTERS * 0.66;
            ui.painter().hline(left..=left + self.head.width(), top, (1.0, ui.visuals().text_color()));
        }
    }
}

fn total(laid: &[Laid<'_>]) -> f32 {
    laid.iter().map(|column| column.width).sum()
}

fn galley(ui: &Ui, figure: &Figure, size: f32, colour: Color32) -> Arc<Galley> {
    let job: LayoutJob = figure.layout(size, colour);
    ui.painter().layout_job(job)
}

/// Paints a galley with its left side at `x` and its middle at `y`.
fn place_at(ui: &Ui, galley: Arc<Galley>, x: f32, y: f32, colour: Color32) {
    let top = y - galley.size().y / 2.0;
    ui.painter().galley(pos2(x, top), galley, colour);
}
