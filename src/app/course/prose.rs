//! The text of lessons: CommonMark, with formulas set as the equation is.

use super::formula::pieces;
use crate::app::widgets::focus::one_stop;
use crate::app::widgets::theme::TEXT;
use crate::app::widgets::typeset::{Place, Run, spoken};
use crate::lesson::without_closed_links;
use crate::text::text;
use eframe::egui::accesskit::Role;
use eframe::egui::{Sense, TextStyle, Ui, WidgetInfo, vec2};
use egui_commonmark::{CommonMarkCache, CommonMarkViewer};
use std::cell::Cell;

/// Size of formulas: a little larger than the text, as their small letters need it.
const FORMULA: f32 = TEXT + 1.0;
/// Letters and signs of a formula that stays on one line.
const WHOLE: usize = 18;
/// What brings its baseline to that of the text, points.
const RAISED: f32 = 1.0;

/// How far slanted letters at the end of a formula stand out to the right, points.
const SLANT: f32 = 1.5;

/// Stands at the end of a formula that a space follows: spaces would end no formula.
const SPACED: char = '\u{200b}';
/// What may not begin a line.
const CLOSING: &[char] = &[
    ',', '.', ';', ':', '!', '?', '，', '。', '；', '：', '！', '？', '、',
];
const BRACKETS: &[char] = &[')', '）', '」'];

/// Shows a text; the letters of its formulas light up what they stand for.
pub fn prose_ui(ui: &mut Ui, cache: &mut CommonMarkCache, words: &str) {
    let top = ui.cursor().min;
    shown_ui(ui, cache, words, true);
    let rect = ui.min_rect();
    one_stop(ui, rect.with_min_y(top.y));
}

/// Shows a text on a button: its letters do nothing of themselves.
pub fn caption_ui(ui: &mut Ui, cache: &mut CommonMarkCache, words: &str) {
    shown_ui(ui, cache, words, false);
}

fn shown_ui(ui: &mut Ui, cache: &mut CommonMarkCache, words: &str, live: bool) {
    let count = Cell::new(0);
    let math = move |ui: &mut Ui, formula: &str, _: bool| formula_ui(ui, formula, &count, live);
    // Lines of a list are as far apart as those of a paragraph, not as rows of controls.
    let line = ui.text_style_height(&TextStyle::Body);
    let row = std::mem::replace(&mut ui.spacing_mut().interact_size.y, line);
    CommonMarkViewer::new().render_math_fn(Some(&math)).show(
        ui,
        cache,
        &joined(&without_closed_links(words)),
    );
    ui.spacing_mut().interact_size.y = row;
}

/// The same text with what closes a sentence, and the space behind, inside the formula or the emphasis that it follows: each is
/// laid out for itself, and the next line would begin with it.
fn joined(words: &str) -> String {
    let mut all = String::with_capacity(words.len());
    let mut rest = words;
    // Text between marks and what marks enclose take turns.
    while let Some((mark, at)) = next_mark(rest) {
        let (before, inside) = rest.split_at(at);
        all.push_str(before);
        let inside = &inside[mark.len()..];
        let Some(length) = inside.find(mark).filter(|length| *length > 0) else {
            all.push_str(mark);
            rest = inside;
            continue;
        };
        let after = &inside[length + mark.len()..];
        // A bracket stands as its other half does.
        let behind = match mark {
            "`" => after,
            "$" => after.trim_start_matches([CLOSING, BRACKETS].concat().as_slice()),
            _ => after.trim_start_matches(CLOSING),
        };
        let moved = &after[..after.len() - behind.len()];
        all.extend([mark, &inside[..length], moved]);
        rest = &after[moved.len()..];
        if let Some(behind) = rest.strip_prefix(' ').filter(|_| mark == "$") {
            all.push(SPACED);
            rest = behind;
        }
        all.push_str(mark);
    }
    all.push_str(rest);
    all
}

/// The next mark of a formula, of emphasis or of code, and where it is.
fn next_mark(words: &str) -> Option<(&'static str, usize)> {
    let marks = ["`", "$", "**", "*"].into_iter();
    let found = marks.filter_map(|mark| Some((mark, words.find(mark)?)));
    // Of two at one place the longer one.
    found.min_by_key(|(mark, at)| (*at, usize::MAX - mark.len()))
}

fn formula_ui(ui: &mut Ui, formula: &str, count: &Cell<usize>, live: bool) {
    let spacing = std::mem::replace(&mut ui.spacing_mut().item_spacing.x, 0.0);
    let (formula, space) = match formula.strip_suffix(SPACED) {
        Some(formula) => (
            formula,
            ui.fonts_mut(|fonts| fonts.glyph_width(&TextStyle::Body.resolve(ui.style()), ' ')),
        ),
        None => (formula, 0.0),
    };
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
        let last = runs.peek().is_none();
        let beyond = if last && slanted { SLANT } else { 0.0 };
        let beyond = if last { beyond + space } else { beyond };
        let size = vec2(
            laid.width() + beyond,
            ui.text_style_height(&TextStyle::Body),
        );
        let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
        laid.paint(ui, rect.left_center() - vec2(0.0, RAISED), place);
        let words = spoken(&run);
        response.widget_info(|| WidgetInfo::labeled(Role::Label, true, words.trim()));
    }
    ui.spacing_mut().item_spacing.x = spacing;
}

#[cfg(test)]
mod tests {
    use super::joined;

    #[test]
    fn no_line_begins_with_what_closes_the_one_before() {
        for (words, expected) in [
            ("$K_s$, n", "$K_s,\u{200b}$n"),
            ("where $N$ points", "where $N\u{200b}$points"),
            ("($R·V$).", "($R·V).$"),
            (
                "of the **light**, and *here*.",
                "of the **light,** and *here.*",
            ),
            ("(*affine*); then", "(*affine*); then"),
            ("`a$b`, $c$", "`a$b`, $c$"),
            ("* one\n* two", "* one\n* two"),
            ("5 $ and 2 * 3", "5 $ and 2 * 3"),
        ] {
            assert_eq!(joined(words), expected);
        }
    }
}
