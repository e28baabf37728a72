//! Fields of CSV (RFC 4180) for arbitrary text: other programs can read it back, and no spreadsheet interprets it as
//! a formula.

use crate::text::turns;

/// Characters that begin a formula; spreadsheets also accept the wide ones of East Asian keyboards.
const FORMULA: [char; 8] = ['=', '+', '-', '@', '＝', '＋', '－', '＠'];

/// Separators of cells for some spreadsheets other than the comma, against which a field's quotation marks protect:
/// in countries that write 0,5 the semicolon. Such a spreadsheet does not recognise a quotation mark in the middle of
/// what it considers a cell.
const SEPARATORS: [char; 4] = [';', '\t', '\r', '\n'];

pub fn field(text: &str) -> String {
    let plain: String = text
        .split_inclusive(SEPARATORS)
        .map(without_formula)
        .collect();
    let special = |c: char| SEPARATORS.contains(&c) || ",\"".contains(c);
    if plain.contains(special) {
        format!("\"{}\"", plain.replace('"', "\"\""))
    } else {
        plain
    }
}

/// Returns a possible cell, with an apostrophe before anything that a spreadsheet would interpret as a formula.
fn without_formula(cell: &str) -> String {
    let unseen = |c: char| {
        c.is_whitespace()
            || c.is_control()
            || turns(c)
            || matches!(c, '\u{ad}' | '\u{180e}' | '\u{200b}'..='\u{200d}' | '\u{2060}'..='\u{2064}' | '\u{feff}')
    };
    let formula = cell.trim_start_matches(unseen).starts_with(FORMULA) && !is_numbers(cell);
    // Some spreadsheets take a leading tab or carriage return for the start of a formula.
    if formula || cell.starts_with(['\t', '\r']) {
        format!("'{cell}")
    } else {
        cell.to_owned()
    }
}

/// Returns whether a cell is one or more numbers, each of which may be missing: `-`.
fn is_numbers(cell: &str) -> bool {
    cell.split_whitespace()
        .all(|word| word == "-" || word.parse::<f64>().is_ok())
}
