//! The text of lessons: CommonMark, with formulas set as the equation is.

use super::formula::pieces;
use crate::app::focus::one_stop;
use crate::app::state::AppState;
use crate::app::theme::TEXT;
use crate::app::typeset::{Place, Run, spoken};
use crate::text::text;
use eframe::egui::accesskit::Role;
use eframe::egui::{Sense, TextStyle, Ui, WidgetInfo, vec2};
use egui_commonmark::{CommonMarkCache, CommonMarkViewer};
use std::cell::{Cell, RefCell};
use std::mem::take;
use std::rc::Rc;

/// Size of formulas: a little larger than the text, as their small letters need it.
const FORMULA: f32 = TEXT + 1.0;
/// Letters and signs of a formula that stays on one line.
const WHOLE: usize = 18;
/// What brings its baseline to that of the text, points.
const RAISED: f32 = 1.0;

/// How far slanted letters at the end of a formula stand out to the right, points.
const SLANT: f32 = 1.5;

/// Shows a text; the letters of its formulas light up what they stand for.
pub fn prose_ui(ui: &mut Ui, state: &mut AppState, cache: &mut CommonMarkCache, words: &str) {
    let top = ui.cursor().min;
    shown_ui(ui, state, cache, words, true);
    let rect = ui.min_rect();
    one_stop(ui.ctx(), rect.with_min_y(top.y));
}

/// Shows a text on a button: its letters do nothing of themselves.
pub fn caption_ui(ui: &mut Ui, state: &mut AppState, cache: &mut CommonMarkCache, words: &str) {
    shown_ui(ui, state, cache, words, false);
}

fn shown_ui(
    ui: &mut Ui,
    state: &mut AppState,
    cache: &mut CommonMarkCache,
    words: &str,
    live: bool,
) {
    // The viewer takes functions that borrow nothing.
    let lent = Rc::new(RefCell::new(take(state)));
    let (inside, count) = (Rc::clone(&lent), Cell::new(0));
    let math = move |ui: &mut Ui, formula: &str, _: bool| {
        if let Ok(mut state) = inside.try_borrow_mut() {
            formula_ui(ui, &mut state, formula, &count, live);
        }
    };
    // Lines of a list are as far apart as those of a paragraph, not as rows of controls.
    let line = ui.text_style_height(&TextStyle::Body);
    let row = std::mem::replace(&mut ui.spacing_mut().interact_size.y, line);
    CommonMarkViewer::new()
        .render_math_fn(Some(&math))
        .show(ui, cache, words);
    ui.spacing_mut().interact_size.y = row;
    drop(math);
    if let Some(lent) = Rc::into_inner(lent) {
        *state = lent.into_inner();
    }
}

fn formula_ui(ui: &mut Ui, state: &mut AppState, formula: &str, count: &Cell<usize>, live: bool) {
    let spacing = std::mem::replace(&mut ui.spacing_mut().item_spacing.x, 0.0);
    let mut runs = pieces(ui.visuals(), formula);
    if formula.chars().count() <= WHOLE {
        runs = vec![runs.concat()];
    }
    let mut runs = runs.into_iter().peekable();
    while let Some(mut run) = runs.next() {
        if !live {
            run.iter_mut().for_each(|piece| piece.symbol = None);
        }
        count.set(count.get() + 1);
        let place = Place {
            id: ui.scope_id().with(("formula", count.get())),
            name: text!("course-in-text"),
        };
        let laid = Run::new(ui, &run, FORMULA);
        // As high as a line of text, so that lines stay evenly apart.
        let slanted = run.last().is_some_and(|last| last.low.is_empty());
        let ends = runs.peek().is_none() && slanted;
        let beyond = if ends { SLANT } else { 0.0 };
        let size = vec2(
            laid.width() + beyond,
            ui.text_style_height(&TextStyle::Body),
        );
        let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
        laid.paint(ui, state, rect.left_center() - vec2(0.0, RAISED), place);
        let words = spoken(&run);
        response.widget_info(|| WidgetInfo::labeled(Role::Label, true, words.trim()));
    }
    ui.spacing_mut().item_spacing.x = spacing;
}
