//! A table of a report in a panel, with as many columns as fit.

use super::letter::lettered;
use crate::analysis::report::Table;
use crate::text::text;
use eframe::egui::{
    Align, Button, Grid, Label, Layout, RichText, ScrollArea, TextStyle, Ui, WidgetText,
};
use std::fmt::Debug;
use std::hash::Hash;

/// Minimum width of a column, points. With narrower ones, the scroll bar of a table that just fits would toggle in
/// every frame.
const NARROWEST: f32 = 28.0;
/// Gap between columns, points: the ordinary one, and the one for tight space.
const GAPS: [f32; 2] = [14.0, 6.0];
const ROW_GAP: f32 = 3.0;
/// Minimum width of a first column of words, points.
const LEAST_WORDS: f32 = 84.0;

/// The part of a table that fits a width.
struct Fitted<'a> {
    heads: Vec<&'a str>,
    rows: Vec<Vec<String>>,
    /// For each column, true if it holds numbers.
    numbers: Vec<bool>,
    gap: f32,
    /// The width at which the words of the first column wrap.
    words: Option<f32>,
}

/// Shows a table; returns the row that is clicked, if rows can be chosen.
pub fn table_ui(
    ui: &mut Ui,
    id: impl Hash + Copy + Debug,
    table: &Table,
    pick: bool,
) -> Option<usize> {
    rows_ui(ui, id, table, (pick, None))
}

/// Shows a table; returns the row that is clicked. In a narrow panel, optional columns are omitted first, then the
/// words of the first column wrap; a table that is still too wide scrolls. If rows can be chosen, the first cell is a
/// button, and one row may already be chosen.
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

/// Shows the first cell of a row, a button if rows can be chosen; returns whether it is clicked.
fn first_ui(ui: &mut Ui, cell: &str, width: Option<f32>, chosen: Option<bool>) -> bool {
    let colour = ui.visuals().text_color();
    let cell_ui = |ui: &mut Ui| {
        let text: WidgetText = match chosen {
            // A button's accessible name is its text.
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

/// Fits a table to the available width.
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

/// Returns the width of a column's cells without wrapping.
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
    // A button has some padding around its text.
    let padding = if column == 0 { 8.0 } else { 0.0 };
    rows.iter()
        .filter_map(|row| row.get(column))
        .map(|cell| padding + width(cell, &style))
        .fold(width(heads[column], &TextStyle::Body), f32::max)
}
