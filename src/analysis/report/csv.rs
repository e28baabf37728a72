//! Fields of CSV (RFC 4180) for arbitrary text: other programs can read it back, and no spreadsheet interprets it as
//! a formula.

use crate::text::turns;

/// Characters that begin a formula; spreadsheets also accept the wide ones of East Asian keyboards.
const FORMULA: [char; 8] = ['=', '+', '-', '@', '＝', '＋', '－', '＠'];

/// Separators of cells for some spreadsheets other than the comma, against which a field's quotation marks protect:
/// in countries that write 0,5 the semicolon. Such a spreadsheet does not recognise a quotation mark in the middle of
/// what it considers a cell.
const SEPARATORS: [char; 4] = [';', '\t', '\r', '\n'];

/// Returns a text as a field.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_cell_is_a_formula_however_the_line_is_split() {
        for text in [
            "=1+1",
            "Ada;=1+1",
            "Ada\t+1+1",
            "Ada\n@SUM(A1)",
            "＝1+1",
            "；;－1+x",
            "\u{200b}=1+1",
            "\u{feff}\u{a0}=1+1",
            "\u{202e}=1+1",
            "\t=1+1",
            "\tx",
            "\r\n=cmd|'/c calc'!A0",
            "\u{1b}=x",
            "-E1",
        ] {
            let field = field(text);
            for separator in [',', ';', '\t', '\n'] {
                for cell in field.split(separator) {
                    let seen = cell.trim_matches(|c: char| {
                        c == '"'
                            || c.is_whitespace()
                            || c.is_control()
                            || "\u{200b}\u{feff}\u{202e}".contains(c)
                    });
                    assert!(!seen.starts_with(FORMULA), "{text:?} became {field:?}");
                }
            }
            // Other programs read the text back, with its apostrophes.
            let mut reader = csv::ReaderBuilder::new()
                .has_headers(false)
                .from_reader(field.as_bytes());
            let row = reader.records().next().expect("a row").expect("a field");
            assert_eq!(
                (row.len(), row[0].replace('\'', "")),
                (1, text.replace('\'', ""))
            );
        }
    }

    #[test]
    fn numbers_and_plain_words_stay_as_they_are() {
        for text in [
            "-0.5",
            "+3",
            "-1e-7",
            "-0.5 - 0.25",
            "Ada",
            "王小明",
            "A=B",
            "light 1: diffuse",
            "",
        ] {
            assert_eq!(field(text), text);
        }
        assert_eq!(field("Ada, \"Lovelace\""), "\"Ada, \"\"Lovelace\"\"\"");
        assert_eq!(field("Ada;Byron"), "\"Ada;Byron\"");
    }
}
