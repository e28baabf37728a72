//! Formulas in the text of lessons: `K_a·I_a`, `(R·V)^n`, `cos θ`. Letters that the window knows are set as
//! in the equation.

use crate::app::widgets::typeset::{Piece, letter};
use crate::figure::{Base, Formula, Item};
use eframe::egui::Visuals;

/// Letters whose meaning in the window's formulas differs from that in textbooks.
const AMBIGUOUS: [&str; 2] = ["S", "T"];
/// Signs before which a long formula may break.
const BREAKS: [&str; 7] = ["=", "+", "−", "≈", "<", ">", "/"];
/// Splits a formula into pieces, in runs that each stay on one line.
pub fn pieces(visuals: &Visuals, formula: &str) -> Vec<Vec<Piece>> {
    let mut runs: Vec<Vec<Piece>> = vec![Vec::new()];
    set(
        visuals,
        &mut runs,
        &Formula::read_or_verbatim(formula.trim()),
    );
    runs.retain(|run| !run.is_empty());
    runs
}

fn set(visuals: &Visuals, runs: &mut Vec<Vec<Piece>>, formula: &Formula) {
    for Item { base, low, high } in &formula.items {
        let (mut low, high) = (low.to_string(), high.to_string());
        match base {
            Base::Name(name) => {
                let piece = named(visuals, name, std::mem::take(&mut low));
                runs.last_mut()
                    .into_iter()
                    .for_each(|run| run.push(piece.clone()));
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
