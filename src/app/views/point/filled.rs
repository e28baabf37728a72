//! The equation filled in for the probed pixel, as lines that add up, some of which unfold.

use crate::analysis::probe::{
    FilledLine, FilledPart, Here, LineValue, Product, Share, channels, digits, digits_below,
    law_text, law_words, percent,
};
use crate::app::session::Session;
use crate::app::widgets::letter::set;
use crate::app::widgets::palette::tone_text as colour;
use crate::app::widgets::strip::strip;
use crate::app::widgets::symbol;
use crate::app::widgets::typeset::{Piece, Run, RunId, formula, run_ui, spoken};
use crate::text::text;
use eframe::egui::accesskit::Role;
use eframe::egui::collapsing_header::{CollapsingState, paint_default_icon};
use eframe::egui::text::{LayoutJob, TextFormat, TextWrapping};
use eframe::egui::{
    Align, Color32, CornerRadius, FontId, Galley, Id, Layout, Rect, RichText, Sense, Stroke,
    StrokeKind, Ui, WidgetInfo, pos2, vec2,
};
use std::sync::Arc;

/// Height of a line, and of the bar, in points.
const LINE: f32 = 24.0;
const BAR: f32 = 22.0;
/// Font sizes of names and numbers, of letters that stand for a name, and of formulas, in points.
const TEXT: f32 = 14.0;
const LETTERS: f32 = 16.0;
const FORMULA: f32 = 15.0;
/// Width of a channel's column, and of the space before it, in points.
const COLUMN: f32 = 51.0;
const SPACE: f32 = 7.0;
/// Indent of names behind the sign and the triangle, and behind the sign alone, in points.
const INDENT: f32 = 34.0;
const FLAT_INDENT: f32 = 14.0;
/// Space between two parts of the bar, in points. It separates terms of one kind, which have the same colour.
const GAP: f32 = 1.5;
/// Minimum scale of formulas in a narrow panel.
const LEAST_SCALE: f32 = 0.7;

/// Height of a line of numbers, and of the letters above them, in points.
const ROW: f32 = 20.0;
const HEAD: f32 = LETTERS * 1.6;
/// Width of the channel's letter in front of a line, in points.
const MARK: f32 = 16.0;
/// Minimum and maximum space between two columns, which holds a sign, in points.
const COLUMN_GAPS: [f32; 2] = [9.0, 16.0];

/// Values of letters at the pixel, by the letters' names.
pub type Values = [(&'static str, String)];

/// Shows the whole formula at the probe.
pub fn filled_ui(ui: &mut Ui, session: &mut Session, here: Here<'_>) {
    let chosen = newly_chosen(ui, session.light);
    ui.scope(|ui| {
        ui.spacing_mut().item_spacing = vec2(8.0, 2.0);
        bar_ui(ui, &here.shares());
        channels_ui(ui);
        for part in here.filled() {
            match &part {
                FilledPart::Line(line) if !line.parts.is_empty() => {
                    fold_ui(ui, session, here, line, chosen);
                }
                part => part_ui(ui, part, &[], Id::NULL),
            }
        }
    });
}

/// Returns whether another light is chosen than in the previous frame. Its terms then unfold, and the others fold.
fn newly_chosen(ui: &Ui, light: usize) -> bool {
    let id = ui.scope_id().with("chosen-light");
    ui.data_mut(|data| {
        let before = data.get_temp::<usize>(id);
        data.insert_temp(id, light);
        before != Some(light)
    })
}

fn part_ui(ui: &mut Ui, part: &FilledPart, values: &Values, id: Id) {
    match part {
        FilledPart::Note(text) => _ = ui.label(RichText::new(text).weak()),
        FilledPart::Evaluated(over) => {
            ui.label(RichText::new(text!("point-evaluated-mean", over = &over[..])).weak());
        }
        FilledPart::Formula(formula) => formula_ui(ui, formula, values, id),
        FilledPart::OfLaw(line) => {
            ui.horizontal_wrapped(|ui| {
                ui.label(RichText::new(law_text(line)).monospace());
                ui.label(RichText::new(format!("= {}", law_words(line))).strong());
            });
        }
        FilledPart::Heading { name, tone, share } => {
            ui.horizontal(|ui| {
                ui.label(RichText::new(*name).color(colour(ui.visuals(), *tone)));
                ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                    ui.label(RichText::new(share.as_deref().unwrap_or_default()).weak());
                });
            });
        }
        FilledPart::Product {
            name,
            product,
            letters,
            value,
        } => {
            let visuals = ui.visuals();
            let heads = product.columns.iter().map(|column| {
                let tip =
                    |letter: &str| format!("{}{}", here_words(values, letter), column.words());
                formula(visuals, &column.formula(), colour(visuals, *letters), tip)
            });
            let (heads, colour) = (heads.collect(), colour(visuals, *value));
            let table = TermTable {
                name,
                product,
                heads,
                colour,
            };
            table.ui(ui, run_at_probe(id));
        }
        FilledPart::Line(line) => flat_ui(ui, line),
        FilledPart::Rule => {
            let (rect, _) = strip(ui, 5.0, Sense::hover());
            let stroke = Stroke::new(1.0, ui.visuals().weak_text_color());
            let span = channel_edge(rect, 0) - COLUMN..=rect.max.x;
            ui.painter().hline(span, rect.center().y, stroke);
        }
    }
}

/// Returns a line with the value of a letter at the pixel, or an empty string if the value is not known.
fn here_words(values: &Values, letter: &str) -> String {
    let value = values.iter().find(|(name, _)| *name == letter);
    value.map_or_else(String::new, |(_, value)| {
        text!("point-here", values = &value[..]) + "\n"
    })
}

/// Returns the identity of a run whose symbols have values at the probe.
fn run_at_probe(id: Id) -> RunId<'static> {
    let name = text!("point-at-probe");
    RunId { id, name }
}

/// Shows a typeset formula that shrinks to fit the panel.
pub fn formula_ui(ui: &mut Ui, text: &str, values: &Values, id: Id) {
    let visuals = ui.visuals();
    let pieces = formula(visuals, text, visuals.text_color(), |letter| {
        here_words(values, letter)
    });
    ui.scope(|ui| {
        ui.spacing_mut().item_spacing.y = 0.0;
        let width = Run::new(ui, &pieces, FORMULA).width();
        let size = FORMULA * (ui.available_width() / width).clamp(LEAST_SCALE, 1.0);
        let run = run_ui(ui, &pieces, size, run_at_probe(id));
        run.widget_info(|| WidgetInfo::labeled(Role::Label, true, spoken(&pieces)));
    });
}

/// Shows the names of the channels over their columns.
fn channels_ui(ui: &mut Ui) {
    let weak = ui.visuals().weak_text_color();
    let (rect, _) = strip(ui, LINE - 4.0, Sense::hover());
    for (index, channel) in channels().into_iter().enumerate() {
        let galley = line_galley(ui, channel, FontId::proportional(TEXT), weak);
        paint_right(ui, galley, channel_edge(rect, index), rect, weak);
    }
}

/// Shows a line that does not unfold. Letters in place of its name highlight their control.
fn flat_ui(ui: &mut Ui, line: &FilledLine) {
    let name = name_galley(ui, line);
    let (rect, response) = strip(ui, name.size().y.max(LINE), Sense::hover());
    response.widget_info(|| {
        let words = format!("{} {}", line.name, line.value.words());
        WidgetInfo::labeled(Role::Label, true, words)
    });
    paint(ui, line, name, rect);
    if !line.letters.is_empty() {
        let visuals = ui.visuals();
        let letters = formula(visuals, line.letters, colour(visuals, line.tone), |_| {
            String::new()
        });
        let place = run_at_probe(ui.scope_id().with(("line", &line.name)));
        let left = pos2(rect.min.x + FLAT_INDENT, rect.center().y);
        Run::new(ui, &letters, LETTERS).paint(ui, left, place);
    }
}

/// Shows a line that unfolds to its parts by a click, Enter or the space bar.
///
/// The line of a light also unfolds when that light has been `chosen`, and those of other lights fold.
fn fold_ui(ui: &mut Ui, session: &mut Session, here: Here<'_>, line: &FilledLine, chosen: bool) {
    let light = line.light.map(|index| format!("light {index}"));
    let id = ui.make_persistent_id(light.unwrap_or_else(|| line.name.clone()));
    let own = line.light.is_none_or(|index| index == session.light);
    let mut fold = CollapsingState::load_with_default_open(ui.ctx(), id, own);
    let galley = name_galley(ui, line);
    let (rect, _) = strip(ui, galley.size().y.max(LINE), Sense::hover());
    let response = ui.interact(rect, id, Sense::click());
    let unfolds = if chosen && line.light.is_some() {
        own != fold.is_open()
    } else {
        response.clicked()
    };
    if unfolds {
        fold.toggle(ui);
    }
    let name = text!(
        "point-line-at-probe",
        name = &line.name[..],
        value = line.value.words()
    );
    response.widget_info(|| WidgetInfo::labeled(Role::DisclosureTriangle, ui.is_enabled(), &name));
    ui.ctx()
        .accesskit_node_builder(id, |node| node.set_expanded(fold.is_open()));
    if response.hovered() || response.has_focus() {
        let fill = ui.visuals().widgets.hovered.bg_fill.gamma_multiply(0.55);
        let stroke = if response.has_focus() {
            ui.visuals().widgets.active.bg_stroke
        } else {
            Stroke::NONE
        };
        let area = rect.expand2(vec2(2.0, 0.0));
        ui.painter()
            .rect(area, 5.0, fill, stroke, StrokeKind::Inside);
    }
    let icon = Rect::from_center_size(pos2(rect.min.x + 22.0, rect.center().y), vec2(10.0, 10.0));
    let openness = fold.openness(ui.ctx());
    paint_default_icon(ui, openness, &response.with_new_rect(icon));
    paint(ui, line, galley, rect);
    let light = line.light.and_then(|index| here.lights().nth(index));
    let values = light.map_or_else(Vec::new, |light| light.values());
    let clicked = symbol::is_clicked(ui.ctx());
    fold.show_body_unindented(ui, |ui| {
        for (number, part) in line.parts.iter().enumerate() {
            part_ui(ui, part, &values, id.with(("part", number)));
        }
        ui.add_space(6.0);
    });
    if let Some(index) = line.light
        && symbol::is_clicked(ui.ctx()) != clicked
    {
        // A symbol of this light was clicked: the controls become those of this light.
        session.light = index;
    }
}

/// Returns the left edge of a line's name.
fn indent(line: &FilledLine) -> f32 {
    if line.parts.is_empty() {
        FLAT_INDENT
    } else {
        INDENT
    }
}

/// Lays out the parts of a line's value, each with the distance of its right edge from that of the line.
fn value_galleys(ui: &Ui, line: &FilledLine) -> Vec<(Arc<Galley>, f32)> {
    let visuals = ui.visuals();
    match &line.value {
        LineValue::Channels(values) => {
            let values = values.iter().enumerate().map(|(index, value)| {
                let colour = colour(visuals, line.tone);
                let galley = line_galley(ui, value, FontId::monospace(TEXT), colour);
                (galley, channel_offset(index))
            });
            values.collect()
        }
        LineValue::Words(words) => {
            let (font, weak) = (FontId::proportional(TEXT), visuals.weak_text_color());
            vec![(line_galley(ui, words, font, weak), 0.0)]
        }
    }
}

/// Lays out a line's name in the width left of its value, in two rows where it is too long for one.
fn name_galley(ui: &Ui, line: &FilledLine) -> Arc<Galley> {
    let least = match line.value {
        LineValue::Channels(_) => COLUMN,
        LineValue::Words(_) => 0.0,
    };
    let values = value_galleys(ui, line).into_iter();
    let taken = values.map(|(galley, offset)| offset + galley.size().x.max(least));
    let room = ui.available_width() - taken.fold(0.0, f32::max) - SPACE - indent(line);
    let name = if line.letters.is_empty() {
        &*line.name
    } else {
        ""
    };
    text_galley(ui, name, colour(ui.visuals(), line.tone), room, 2)
}

/// Paints the sign, the name and the value of a line.
fn paint(ui: &Ui, line: &FilledLine, name: Arc<Galley>, rect: Rect) {
    let weak = ui.visuals().weak_text_color();
    let colour = colour(ui.visuals(), line.tone);
    let (middle, sign) = (rect.center().y, text_galley(ui, line.sign, weak, INDENT, 1));
    place_at(ui, sign, rect.min.x, middle, weak);
    for (galley, offset) in value_galleys(ui, line) {
        paint_right(ui, galley, rect.max.x - offset, rect, colour);
    }
    place_at(ui, name, rect.min.x + indent(line), middle, colour);
}

/// Returns the distance of the right edge of a channel's column from that of the line.
fn channel_offset(index: usize) -> f32 {
    (COLUMN + SPACE) * (2 - index) as f32
}

/// Returns the right edge of a channel's column.
fn channel_edge(rect: Rect, index: usize) -> f32 {
    rect.max.x - channel_offset(index)
}

/// Lays out text with subscripts and superscripts in one row.
fn line_galley(ui: &Ui, words: &str, font: FontId, colour: Color32) -> Arc<Galley> {
    ui.painter().layout_job(set(words, font, colour))
}

/// Lays out text in at most `rows` rows of the width `room`, truncated.
fn text_galley(ui: &Ui, words: &str, colour: Color32, room: f32, rows: usize) -> Arc<Galley> {
    let format = TextFormat {
        font_id: FontId::proportional(TEXT),
        color: colour,
        ..TextFormat::default()
    };
    let mut job = LayoutJob::single_section(words.to_owned(), format);
    job.wrap = TextWrapping {
        max_rows: rows,
        break_anywhere: rows == 1,
        ..TextWrapping::truncate_at_width(room.max(0.0))
    };
    ui.painter().layout_job(job)
}

fn paint_right(ui: &Ui, galley: Arc<Galley>, edge: f32, rect: Rect, colour: Color32) {
    let left = edge - galley.size().x;
    place_at(ui, galley, left, rect.center().y, colour);
}

/// Paints a galley with its left side at `x` and its middle at `y`.
fn place_at(ui: &Ui, galley: Arc<Galley>, x: f32, y: f32, colour: Color32) {
    let top = y - galley.size().y / 2.0;
    ui.painter().galley(pos2(x, top), galley, colour);
}

/// Shows the share of each term in the pixel's brightness as one bar. Each part is as long as its term is bright.
fn bar_ui(ui: &mut Ui, shares: &[Share]) {
    let (rect, _) = strip(ui, BAR, Sense::hover());
    let whole: f64 = shares.iter().map(|share| share.weight).sum();
    let seen: Vec<_> = shares.iter().filter(|share| share.weight > 0.0).collect();
    if seen.is_empty() {
        let stroke = Stroke::new(1.0, ui.visuals().weak_text_color());
        ui.painter()
            .rect_stroke(rect, 4.0, stroke, StrokeKind::Inside);
        return;
    }
    let mut x = rect.min.x;
    for (index, share) in seen.iter().enumerate() {
        let width = (share.weight / whole) as f32 * rect.width();
        let space = if index + 1 < seen.len() {
            GAP.min(width * 0.5)
        } else {
            0.0
        };
        let place = Rect::from_min_max(pos2(x, rect.min.y), pos2(x + width - space, rect.max.y));
        share_ui(ui, share, place, whole);
        x += width;
    }
}

fn share_ui(ui: &Ui, share: &Share, place: Rect, whole: f64) {
    let part = percent(share.weight, whole).unwrap_or_default();
    let text = format!("{}: {part}", share.name);
    let id = ui.scope_id().with(("share", &share.name));
    let response = ui.interact(place, id, Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, &text));
    let fill = colour(ui.visuals(), share.tone);
    ui.painter().rect_filled(place, CornerRadius::same(3), fill);
    let dark = ui.visuals().panel_fill;
    let names = [&share.name, &share.short];
    let galleys = names.map(|name| line_galley(ui, name, FontId::proportional(13.0), dark));
    if let Some(galley) = galleys
        .into_iter()
        .find(|galley| galley.size().x + 6.0 <= place.width())
    {
        let left = place.center().x - galley.size().x / 2.0;
        place_at(ui, galley, left, place.center().y, dark);
    }
    if response.hovered() {
        let stroke = Stroke::new(2.0, ui.visuals().strong_text_color());
        ui.painter()
            .rect_stroke(place, CornerRadius::same(3), stroke, StrokeKind::Inside);
    }
    response.on_hover_text(text!("point-share-tip", share = text));
}

/// A term with the letters of its columns.
struct TermTable<'a> {
    /// Name of the term, for screen readers.
    name: &'a str,
    product: &'a Product,
    heads: Vec<Vec<Piece>>,
    /// Colour of the term's value.
    colour: Color32,
}

/// A column as laid out.
struct Laid<'a> {
    head: Run<'a>,
    numbers: [Arc<Galley>; 3],
    digits: f32,
    width: f32,
    sign: &'static str,
    mean: bool,
}

impl TermTable<'_> {
    fn ui(&self, ui: &mut Ui, place: RunId<'_>) {
        let gaps = self.heads.len() as f32;
        let room = (ui.available_width() - MARK).max(0.0);
        let natural = self.lay_out(ui, 1.0);
        let scale = ((room - gaps * COLUMN_GAPS[0]) / total(&natural)).clamp(LEAST_SCALE, 1.0);
        let laid = if scale < 1.0 {
            self.lay_out(ui, scale)
        } else {
            natural
        };
        let gap = ((room - total(&laid)) / gaps).clamp(COLUMN_GAPS[0], COLUMN_GAPS[1]);
        let (rect, _) = strip(ui, HEAD + 3.0 * ROW, Sense::hover());
        self.paint(ui, &laid, rect, gap, place);
        self.describe(ui, rect, place);
    }

    /// Returns the sign between a column and the one before it.
    fn sign(&self, index: usize) -> &'static str {
        match self.product.columns.get(index) {
            Some(_) if index == 0 => "",
            Some(column) if column.added => "+",
            Some(_) => "·",
            None => "=",
        }
    }

    fn lay_out(&self, ui: &Ui, scale: f32) -> Vec<Laid<'_>> {
        let plain = ui.visuals().text_color();
        let laid = |index, head, size, numbers: [String; 3], colour, mean| {
            let numbers = numbers.map(|number| {
                let font = FontId::monospace(TEXT * scale);
                line_galley(ui, &number, font, colour)
            });
            let digits = numbers
                .iter()
                .map(|number| number.size().x)
                .fold(0.0, f32::max);
            let head = Run::new(ui, head, size);
            Laid {
                width: digits.max(head.width()),
                head,
                numbers,
                digits,
                sign: self.sign(index),
                mean,
            }
        };
        let columns = self.product.columns.iter().zip(&self.heads).enumerate();
        let mut all: Vec<_> = columns
            .map(|(index, (column, head))| {
                let size = LETTERS * scale.max(0.85);
                let numbers = digits_below(column.values);
                laid(index, head, size, numbers, plain, column.mean)
            })
            .collect();
        let value = self.product.value.to_array().map(digits);
        let last = self.heads.len();
        all.push(laid(last, &[], LETTERS, value, self.colour, false));
        all
    }

    fn paint(&self, ui: &Ui, laid: &[Laid<'_>], rect: Rect, gap: f32, place: RunId<'_>) {
        let (plain, weak) = (ui.visuals().text_color(), ui.visuals().weak_text_color());
        let line = |channel: usize| rect.min.y + HEAD + ROW * (channel as f32 + 0.5);
        for (channel, name) in channels().into_iter().enumerate() {
            let first = name.chars().next().map_or_else(String::new, String::from);
            // A Chinese character fills the available width.
            let size = if first.is_ascii() { TEXT } else { MARK - 4.0 };
            let first = line_galley(ui, &first, FontId::proportional(size), weak);
            place_at(ui, first, rect.min.x, line(channel), weak);
        }
        let mut x = rect.min.x + MARK;
        for (index, column) in laid.iter().enumerate() {
            if index + 1 == laid.len() {
                // Values are aligned below each other, whatever their number of factors.
                x = x.max(rect.max.x - column.width - gap);
            }
            if index > 0 {
                for channel in 0..3 {
                    let sign = line_galley(ui, column.sign, FontId::monospace(TEXT), weak);
                    let left = x + (gap - sign.size().x) / 2.0;
                    place_at(ui, sign, left, line(channel), weak);
                }
                x += gap;
            }
            let left = x + (column.width - column.head.width()) / 2.0;
            let middle = rect.min.y + HEAD / 2.0;
            let id = place.id.with(index);
            let start = pos2(left, middle);
            column.head.paint(ui, start, RunId { id, ..place });
            if column.mean {
                // The bar that the textbooks draw over a mean.
                let top = middle - LETTERS * 0.66;
                ui.painter()
                    .hline(left..=left + column.head.width(), top, (1.0, plain));
            }
            let right = x + (column.width + column.digits) / 2.0;
            for (channel, number) in column.numbers.iter().enumerate() {
                let left = right - number.size().x;
                place_at(ui, Arc::clone(number), left, line(channel), plain);
            }
            x += column.width;
        }
    }

    /// Describes the lines of numbers as sentences for screen readers.
    fn describe(&self, ui: &Ui, rect: Rect, place: RunId<'_>) {
        let columns: Vec<_> = self
            .product
            .columns
            .iter()
            .map(|column| digits_below(column.values))
            .collect();
        for (channel, name) in channels().into_iter().enumerate() {
            let mut text = format!("{} {name}: ", self.name);
            for (index, numbers) in columns.iter().enumerate() {
                let sign = if index == 0 {
                    String::new()
                } else {
                    format!(" {} ", self.sign(index))
                };
                text += &format!("{sign}{}", numbers[channel]);
            }
            text += &format!(" = {}", digits(self.product.value[channel]));
            let top = rect.min.y + HEAD + ROW * channel as f32;
            let line = Rect::from_min_size(pos2(rect.min.x, top), vec2(rect.width(), ROW));
            let response = ui.interact(line, place.id.with(("line", channel)), Sense::hover());
            response.widget_info(|| WidgetInfo::labeled(Role::Label, true, &text));
        }
    }
}

fn total(laid: &[Laid<'_>]) -> f32 {
    laid.iter().map(|column| column.width).sum()
}
