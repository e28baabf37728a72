//! A table of a report in a panel: as many of its columns as there is room for.

use super::letter::lettered;
use crate::analysis::Table;
use crate::text::text;
use eframe::egui::{
    Align, Button, Grid, Label, Layout, RichText, ScrollArea, TextStyle, Ui, WidgetText,
};
use std::fmt::Debug;
use std::hash::Hash;

/// Narrowest column, points. Narrower ones let a table that just fits change its mind about its scroll bar in every frame.
const NARROWEST: f32 = 28.0;
/// Between columns: where there is room, and where there is little.
const GAPS: [f32; 2] = [14.0, 6.0];
const ROW_GAP: f32 = 3.0;
/// A first column of words is not made narrower than this.
const LEAST_WORDS: f32 = 84.0;

/// What of a table is shown in a width.
struct Fitted<'a> {
    heads: Vec<&'a str>,
    rows: Vec<Vec<String>>,
    /// Whether each column holds numbers.
    numbers: Vec<bool>,
    gap: f32,
    /// The width that the first column's words are broken at.
    words: Option<f32>,
}

/// A table; returns the row that is clicked, where rows are to choose from.
pub fn table_ui(
    ui: &mut Ui,
    id: impl Hash + Copy + Debug,
    table: &Table,
    pick: bool,
) -> Option<usize> {
    rows_ui(ui, id, table, (pick, None))
}

/// A table: columns that can be done without are left out where the panel is narrow, then the words of the first one are
/// broken; what is too wide still is scrolled. Where rows are to choose from, the first cell is a button, and one of them may
/// be chosen already.
pub fn rows_ui(
    ui: &mut Ui,
    id: impl Hash + Copy + Debug,
    table: &Table,
    (pick, chosen): (bool, Option<usize>),
) -> Option<usize> {
    let fitted = fit(ui, table);
    let mut picked = None;
    let content = |ui: &mut Ui| {
        head_ui(ui, &fitted);
        for (index, row) in fitted.rows.iter().enumerate() {
            for (column, (cell, number)) in row.iter().zip(&fitted.numbers).enumerate() {
                if *number {
                    let text = RichText::new(cell).monospace();
                    ui.with_layout(Layout::right_to_left(Align::Center), |ui| ui.label(text));
                } else if column == 0 {
                    let chosen = pick.then_some(chosen == Some(index));
                    if first_ui(ui, cell, fitted.words, chosen) {
                        picked = Some(index);
                    }
                } else {
                    let colour = ui.visuals().text_color();
                    ui.label(lettered(cell, colour));
                }
            }
            ui.end_row();
        }
    };
    ScrollArea::horizontal()
        .id_salt(("scroll", id))
        .show(ui, |ui| {
            ui.spacing_mut().interact_size.y = ui.text_style_height(&TextStyle::Body);
            Grid::new(("table", id))
                .num_columns(fitted.heads.len())
                .min_col_width(NARROWEST)
                .spacing([fitted.gap, ROW_GAP])
                .striped(fitted.rows.len() > 3)
                .show(ui, content)
        });
    picked
}

fn head_ui(ui: &mut Ui, fitted: &Fitted<'_>) {
    if fitted.heads.iter().all(|head| head.is_empty()) {
        return;
    }
    for (head, number) in fitted.heads.iter().zip(&fitted.numbers) {
        let head = Label::new(RichText::new(*head).weak()).extend();
        if *number {
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| ui.add(head));
        } else {
            ui.add(head);
        }
    }
    ui.end_row();
}

/// The first cell of a row, a button where rows are to choose from; returns whether it is clicked.
fn first_ui(ui: &mut Ui, cell: &str, width: Option<f32>, chosen: Option<bool>) -> bool {
    let colour = ui.visuals().text_color();
    let cell_ui = |ui: &mut Ui| {
        let text: WidgetText = match chosen {
            // A button's name is that of its text.
            Some(_) => cell.into(),
            None => lettered(cell, colour).into(),
        };
        let Some(chosen) = chosen else {
            ui.label(text);
            return false;
        };
        ui.spacing_mut().button_padding = [3.0, 0.0].into();
        let button = Button::selectable(chosen, text);
        let button = if width.is_some() {
            button.wrap()
        } else {
            button
        };
        ui.add(button)
            .on_hover_text(text!("report-show-tip"))
            .clicked()
    };
    let Some(width) = width else {
        return cell_ui(ui);
    };
    let broken = |ui: &mut Ui| {
        ui.set_max_width(width);
        cell_ui(ui)
    };
    ui.vertical(broken).inner
}

/// As much of a table as there is room for.
fn fit<'a>(ui: &Ui, table: &'a Table) -> Fitted<'a> {
    let room = ui.available_width();
    let extras = table.columns.iter().filter(|column| column.extra).count();
    for left_out in 0..=extras {
        let (heads, rows, numbers) = table.for_people(left_out);
        let widths: Vec<f32> = (0..heads.len())
            .map(|column| column_width(ui, column, &heads, &rows, numbers[column]))
            .collect();
        let gaps = widths.len().saturating_sub(1) as f32;
        let wanted: f32 = widths.iter().sum();
        let gap = GAPS.into_iter().find(|gap| wanted + gaps * gap <= room);
        let last = left_out == extras;
        if gap.is_none() && !last {
            continue;
        }
        let words = (gap.is_none() && !numbers.first().copied().unwrap_or(true)).then(|| {
            let others = wanted - widths[0] + gaps * GAPS[1];
            (room - others).max(LEAST_WORDS)
        });
        return Fitted {
            heads,
            rows,
            numbers,
            gap: gap.unwrap_or(GAPS[1]),
            words,
        };
    }
    unreachable!("the last round returns")
}

/// The width that a column's cells take without a break.
fn column_width(ui: &Ui, column: usize, heads: &[&str], rows: &[Vec<String>], number: bool) -> f32 {
    let style = if number {
        TextStyle::Monospace
    } else {
        TextStyle::Body
    };
    let width = |text: &str, style: &TextStyle| {
        let colour = ui.visuals().text_color();
        ui.painter()
            .layout_no_wrap(text.to_owned(), style.resolve(ui.style()), colour)
            .size()
            .x
    };
    // A button has some room about its text.
    let padding = if column == 0 { 8.0 } else { 0.0 };
    rows.iter()
        .filter_map(|row| row.get(column))
        .map(|cell| padding + width(cell, &style))
        .fold(width(heads[column], &TextStyle::Body), f32::max)
}
