//! The text of lessons: CommonMark, with formulas set as in the equation.

use crate::app::system;
use crate::app::widgets::focus::one_stop;
use crate::app::widgets::formula::formula_ui;
use crate::lesson::{blocks, for_fingers, without_closed_links};
use eframe::egui::accesskit::{self, Role};
use eframe::egui::{Response, TextStyle, Ui, UiBuilder};
use egui_commonmark::{CommonMarkCache, CommonMarkViewer};
use std::cell::Cell;

/// A mark at the end of a formula that a space follows; a space itself would not close a formula.
const SPACED: char = '\u{200b}';
/// Characters that may not begin a line.
const CLOSING: &[char] = &[
    ',', '.', ';', ':', '!', '?', '，', '。', '；', '：', '！', '？', '、',
];
const BRACKETS: &[char] = &[')', '）', '」'];

/// Shows a text. Pointing at a letter of its formulas highlights the letter's meaning.
pub fn prose_ui(ui: &mut Ui, cache: &mut CommonMarkCache, words: &str) -> Response {
    let builder = UiBuilder::new().id_salt(("prose", words));
    let prose = ui.scope_builder(builder, |ui| shown_ui(ui, cache, words, true));
    let prose = prose.response;
    one_stop(ui, prose.rect);
    if !system::PAGE {
        return prose;
    }
    // A browser's screen readers get the whole text, with its lists, tables and formulas, in place of its parts.
    ui.ctx().accesskit_node_builder(prose.id, |node| {
        let [min, max] =
            [prose.rect.min, prose.rect.max].map(|corner| [corner.x, corner.y].map(f64::from));
        node.set_role(Role::Article);
        node.set_bounds(accesskit::Rect::new(min[0], min[1], max[0], max[1]));
        node.set_inner_html(blocks(words).to_string());
    });
    prose
}

/// Shows a text on a button; its letters do not react themselves.
pub fn caption_ui(ui: &mut Ui, cache: &mut CommonMarkCache, words: &str) {
    shown_ui(ui, cache, words, false);
}

fn shown_ui(ui: &mut Ui, cache: &mut CommonMarkCache, words: &str, live: bool) {
    let count = Cell::new(0);
    let math = move |ui: &mut Ui, formula: &str, _: bool| spaced_ui(ui, formula, &count, live);
    // The lines of a list are spaced like those of a paragraph, not like rows of controls.
    let line = ui.text_style_height(&TextStyle::Body);
    let row = std::mem::replace(&mut ui.spacing_mut().interact_size.y, line);
    let words = joined(&without_closed_links(words));
    let words = if system::fingers(ui.ctx()) {
        for_fingers(&words)
    } else {
        words
    };
    CommonMarkViewer::new()
        .render_math_fn(Some(&math))
        .show(ui, cache, &words);
    ui.spacing_mut().interact_size.y = row;
}

/// Moves closing punctuation, and the space after it, into the formula or the emphasis that it follows. Each
/// of these is laid out separately, and the next line could otherwise begin with the punctuation.
fn joined(words: &str) -> String {
    let mut all = String::with_capacity(words.len());
    let mut rest = words;
    // Text outside marks and text between marks alternate.
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
        // A closing bracket stays on the same side of the mark as its opening one.
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

/// Finds the next mark of a formula, of emphasis or of code, and its position.
fn next_mark(words: &str) -> Option<(&'static str, usize)> {
    let marks = ["`", "$", "**", "*"].into_iter();
    let found = marks.filter_map(|mark| Some((mark, words.find(mark)?)));
    // Of two marks at one position, the longer one.
    found.min_by_key(|(mark, at)| (*at, usize::MAX - mark.len()))
}

/// Shows a formula with the space that follows it.
fn spaced_ui(ui: &mut Ui, formula: &str, count: &Cell<usize>, live: bool) {
    let (formula, space) = match formula.strip_suffix(SPACED) {
        Some(formula) => (
            formula,
            ui.fonts_mut(|fonts| fonts.glyph_width(&TextStyle::Body.resolve(ui.style()), ' ')),
        ),
        None => (formula, 0.0),
    };
    formula_ui(ui, formula, space, count, live);
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
