//! Formulas in the notation of textbooks: `K_a·I_a`, `(R·V)^n`, `cos θ`. Letters that the window knows are set as
//! in the equation.

use super::theme::TEXT;
use super::typeset::{Piece, Run, RunId, letter, spoken};
use crate::figure::{Base, Formula, Item};
use crate::text::text;
use eframe::egui::accesskit::Role;
use eframe::egui::{Sense, TextStyle, Ui, Visuals, WidgetInfo, vec2};
use std::cell::Cell;

/// The size of formulas: a little larger than the text, for the sake of their small letters.
const FORMULA: f32 = TEXT + 1.0;
/// The maximum number of characters of a formula that stays on one line.
const WHOLE: usize = 18;
/// The upward shift that brings a formula's baseline to that of the text, in points.
const RAISED: f32 = 1.0;
/// The overhang of slanted letters at the end of a formula, in points.
const SLANT: f32 = 1.5;

/// Names to which the window's own formulas give a meaning that they do not have in textbooks or in what a student types.
const AMBIGUOUS: [&str; 5] = ["S", "T", "law", "lit", "spot"];
/// Signs before which a long formula may break.
const BREAKS: [&str; 7] = ["=", "+", "−", "≈", "<", ">", "/"];

/// Shows a formula as a part of a line of text, with `space` points after it. Its letters react to the pointer if they are
/// `live`; `count` numbers the runs of one text.
pub fn formula_ui(ui: &mut Ui, formula: &str, space: f32, count: &Cell<usize>, live: bool) {
    let spacing = std::mem::replace(&mut ui.spacing_mut().item_spacing.x, 0.0);
    let mut runs = pieces(ui.visuals(), formula);
    if formula.chars().count() <= WHOLE {
        runs = vec![runs.concat()];
    }
    let runs = runs.into_iter().flat_map(|run| parts(ui, run));
    let runs: Vec<Vec<Piece>> = runs.collect();
    let mut runs = runs.into_iter().peekable();
    while let Some(mut run) = runs.next() {
        if !live {
            run.iter_mut().for_each(|piece| piece.symbol = None);
        }
        count.set(count.get() + 1);
        let place = RunId {
            id: ui.scope_id().with(("formula", count.get())),
            name: text!("course-in-text"),
        };
        let laid = Run::new(ui, &run, FORMULA);
        // As high as a line of text, so that lines stay evenly spaced.
        let slanted = run.last().is_some_and(|last| last.low.is_empty());
        let last = runs.peek().is_none();
        let beyond = if last && slanted { SLANT } else { 0.0 };
        let beyond = if last { beyond + space } else { beyond };
        let width = (laid.width() + beyond).min(ui.max_rect().width());
        let size = vec2(width, ui.text_style_height(&TextStyle::Body));
        let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
        laid.paint(ui, rect.left_center() - vec2(0.0, RAISED), place);
        let words = spoken(&run);
        response.widget_info(|| WidgetInfo::labeled(Role::Label, true, words.trim()));
    }
    ui.spacing_mut().item_spacing.x = spacing;
}

/// Splits a run that is wider than a line between its pieces.
fn parts(ui: &Ui, run: Vec<Piece>) -> Vec<Vec<Piece>> {
    let room = ui.max_rect().width() - SLANT;
    let (mut parts, mut left) = (vec![Vec::new()], room);
    for piece in run {
        let width = Run::new(ui, std::slice::from_ref(&piece), FORMULA).width();
        if width > left {
            parts.push(Vec::new());
            left = room;
        }
        left -= width;
        if let Some(part) = parts.last_mut() {
            part.push(piece);
        }
    }
    parts.retain(|part| !part.is_empty());
    parts
}

/// Splits a formula into pieces, in runs that each stay on one line.
pub fn pieces(visuals: &Visuals, formula: &str) -> Vec<Vec<Piece>> {
    let mut runs: Vec<Vec<Piece>> = vec![Vec::new()];
    let formula = Formula::read_or_verbatim(formula.trim());
    set(visuals, &mut runs, &formula);
    runs.retain(|run| !run.is_empty());
    runs
}

fn set(visuals: &Visuals, runs: &mut Vec<Vec<Piece>>, formula: &Formula) {
    for Item { base, low, high } in &formula.items {
        let (mut low, high) = (low.to_string(), high.to_string());
        match base {
            Base::Name(name) => {
                let piece = named(visuals, name, std::mem::take(&mut low));
                if let Some(run) = runs.last_mut() {
                    run.push(piece);
                }
            }
            Base::Signs(signs) => push_signs(visuals, runs, signs),
            Base::Group(inside) => set(visuals, runs, inside),
        }
        let Some(piece) = runs.last_mut().and_then(|run| run.last_mut()) else {
            continue;
        };
        if !low.is_empty() {
            piece.low = low.into();
        }
        if !high.is_empty() {
            piece.high = high.into();
        }
    }
}

/// Adds signs; each sign before which a line may break starts a new run.
fn push_signs(visuals: &Visuals, runs: &mut Vec<Vec<Piece>>, signs: &str) {
    let first = signs.trim_start_matches([')', '|', ' ']).chars().next();
    let spaced = signs.contains(' ');
    let breaks = spaced && first.is_some_and(|first| BREAKS.contains(&&*first.to_string()));
    let at = signs.find(' ').filter(|_| breaks).unwrap_or(0);
    let (before, after) = signs.split_at(at);
    let plain = |text: &str| Piece::plain(text.to_owned(), visuals.text_color());
    if let Some(run) = runs.last_mut().filter(|_| !before.is_empty()) {
        run.push(plain(before));
    }
    if breaks {
        runs.push(Vec::new());
    }
    if let Some(run) = runs.last_mut() {
        run.push(plain(after));
    }
}

/// Sets a letter or a word with its subscript.
fn named(visuals: &Visuals, name: &str, low: String) -> Piece {
    let whole = format!("{name}{low}");
    let known = (!AMBIGUOUS.contains(&&*whole)).then(|| letter(visuals, &whole));
    if let Some(piece) = known.flatten() {
        return piece;
    }
    let mut piece = match letter(visuals, name) {
        // For example N₁: one of several of the same kind.
        Some(piece) if !AMBIGUOUS.contains(&name) && !low.is_empty() => Piece {
            tip: None,
            ..Piece::plain(piece.text, piece.colour)
        },
        _ => Piece::plain(name.to_owned(), visuals.text_color()),
    };
    piece.low = low.into();
    piece
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::widgets::symbol::Symbol;
    use crate::app::widgets::typeset::spoken;
    use crate::lesson::LESSONS;
    use crate::text::Language;

    fn read(formula: &str) -> Vec<Piece> {
        pieces(&Visuals::dark(), formula).concat()
    }

    #[test]
    fn names_that_a_student_gives_are_shown_whole() {
        for name in ["spot", "lit", "law", "T", "s"] {
            let pieces = read(&format!("{name} = N·L"));
            let first = pieces.first().expect("a piece");
            assert_eq!((&*first.text, first.symbol), (name, None));
        }
    }

    #[test]
    fn letters_of_the_equation_are_symbols() {
        let symbols = |formula: &str| -> Vec<Symbol> {
            read(formula)
                .iter()
                .filter_map(|piece| piece.symbol)
                .collect()
        };
        assert_eq!(
            symbols("I = K_a·I_a + f·I_p·(K_d·(N·L) + K_s·(R·V)^n)"),
            [
                Symbol::Intensity,
                Symbol::Ka,
                Symbol::Ia,
                Symbol::Attenuation,
                Symbol::Ip,
                Symbol::Kd,
                Symbol::Normal,
                Symbol::Light,
                Symbol::Ks,
                Symbol::Reflected,
                Symbol::Viewer,
            ]
        );
        assert_eq!(symbols("I_{trans}"), [Symbol::Transmitted]);
        assert_eq!(symbols("n"), [Symbol::Exponent]);
        assert_eq!(symbols("cos θ = S·T/x_Q"), []);
    }

    #[test]
    fn every_formula_of_the_lessons_is_painted_whole() {
        let others = [
            r"\theta \le 90",
            "0.5^{1/n}",
            "{2 - 1}^2",
            "^2",
            "_^{",
            "x^12",
            "I'",
        ];
        let lessons = LESSONS
            .iter()
            .flat_map(|lesson| Language::ALL.map(|language| lesson.source(language)));
        let formulas = lessons.flat_map(|source| source.split('$').skip(1).step_by(2));
        for formula in formulas.chain(others) {
            let expected = Formula::read_or_verbatim(formula).to_string();
            assert_eq!(spoken(&read(formula)), expected, "{formula}");
        }
    }
}
