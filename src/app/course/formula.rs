//! Formulas in the text of lessons: `K_a·I_a`, `(R·V)^n`, `cos θ`. Letters that the window knows are those of the equation.

use crate::app::widgets::typeset::{Piece, letter};
use eframe::egui::Visuals;
use std::iter::Peekable;
use std::str::Chars;

/// Letters of the window's formulas that mean something else in those of textbooks.
const AMBIGUOUS: [&str; 2] = ["S", "T"];
/// Signs before which a long formula may go on in the next line.
const BREAKS: [&str; 7] = ["=", "+", "−", "≈", "<", ">", "/"];
/// What other programs call letters.
const COMMANDS: [(&str, &str); 14] = [
    ("cdot", "·"),
    ("times", "×"),
    ("theta", "θ"),
    ("phi", "φ"),
    ("alpha", "α"),
    ("beta", "β"),
    ("eta", "η"),
    ("lambda", "λ"),
    ("pi", "π"),
    ("sum", "Σ"),
    ("le", "≤"),
    ("ge", "≥"),
    ("approx", "≈"),
    ("circ", "°"),
];

/// The pieces of a formula, in runs that stay on one line each.
pub fn pieces(visuals: &Visuals, formula: &str) -> Vec<Vec<Piece>> {
    let mut runs: Vec<Vec<Piece>> = vec![Vec::new()];
    let mut signs = String::new();
    let mut rest = formula.trim().chars().peekable();
    while let Some(next) = rest.next() {
        let name = match next {
            '\\' => command(&mut rest),
            'a'..='z' | 'A'..='Z' => {
                let mut word = next.to_string();
                while let Some(more) = rest.next_if(char::is_ascii_alphabetic) {
                    word.push(more);
                }
                word
            }
            '\u{391}'..='\u{3c9}' => next.to_string(),
            '_' | '^' => {
                flush(visuals, &mut runs, &mut signs);
                script(&mut runs, next, group(&mut rest));
                continue;
            }
            _ => {
                signs.push(if next == '-' { '−' } else { next });
                continue;
            }
        };
        if !name.chars().any(char::is_alphabetic) {
            signs.push_str(&name);
            continue;
        }
        flush(visuals, &mut runs, &mut signs);
        let low = rest.next_if_eq(&'_').map(|_| group(&mut rest));
        let piece = named(visuals, &name, low.unwrap_or_default());
        if let Some(run) = runs.last_mut() {
            run.push(piece);
        }
    }
    flush(visuals, &mut runs, &mut signs);
    runs.retain(|run| !run.is_empty());
    runs
}

/// Adds signs; where a line may end before them they begin a run.
fn flush(visuals: &Visuals, runs: &mut Vec<Vec<Piece>>, signs: &mut String) {
    let signs = std::mem::take(signs);
    if signs.is_empty() {
        return;
    }
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

/// A letter or a word, with lowered ones behind it.
fn named(visuals: &Visuals, name: &str, low: String) -> Piece {
    let whole = format!("{name}{low}");
    let known = (!AMBIGUOUS.contains(&&*whole)).then(|| letter(visuals, &whole));
    if let Some(piece) = known.flatten() {
        return piece;
    }
    let mut piece = match letter(visuals, name) {
        // As in N₁: one of several of the same kind.
        Some(piece) if !AMBIGUOUS.contains(&name) && !low.is_empty() => Piece {
            tip: None,
            ..Piece::plain(piece.text, piece.colour)
        },
        _ => Piece::plain(name.to_owned(), visuals.text_color()),
    };
    piece.low = low.into();
    piece
}

/// Puts lowered or raised letters behind what was last read.
fn script(runs: &mut [Vec<Piece>], sign: char, letters: String) {
    let Some(piece) = runs.last_mut().and_then(|run| run.last_mut()) else {
        return;
    };
    if sign == '_' {
        piece.low = letters.into();
    } else {
        piece.high = letters.into();
    }
}

/// What stands in braces, or the next character.
fn group(rest: &mut Peekable<Chars<'_>>) -> String {
    if rest.next_if_eq(&'{').is_none() {
        return rest.next().map(String::from).unwrap_or_default();
    }
    let mut inside = String::new();
    for next in rest.by_ref().take_while(|next| *next != '}') {
        inside.push(next);
    }
    inside
}

/// What follows a backslash.
fn command(rest: &mut Peekable<Chars<'_>>) -> String {
    let mut name = String::new();
    while let Some(more) = rest.next_if(char::is_ascii_alphabetic) {
        name.push(more);
    }
    let known = COMMANDS.iter().find(|(command, _)| *command == name);
    known.map_or(name, |(_, sign)| (*sign).to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::widgets::symbol::Symbol;
    use crate::app::widgets::typeset::spoken;

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
    fn any_text_is_set() {
        for (formula, expected) in [
            ("cos^4 α", "cos^4 α"),
            (r"\theta \le 90", "θ ≤ 90"),
            ("0.5^{1/n}", "0.5^1/n"),
            ("2 - 1", "2 − 1"),
            ("_^{", "{"),
            ("I'", "I'"),
        ] {
            assert_eq!(spoken(&read(formula)).trim(), expected, "{formula}");
        }
    }
}
