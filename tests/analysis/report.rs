//! Tables and their texts, for people and for files.

use shading_lab::analysis::report::{Column, Table, as_it_is, grouped};

#[test]
fn digits_are_grouped_from_the_right() {
    assert_eq!(
        (grouped(0), grouped(999)),
        ("0".to_owned(), "999".to_owned())
    );
    assert_eq!(grouped(1_234_567), "1\u{2009}234\u{2009}567");
}

#[test]
fn columns_are_even_in_chinese_and_the_extra_ones_go_first() {
    let column = |head: &'static str| Column::shown(head, as_it_is);
    let mut table = Table::new([
        column("名稱"),
        column("RMS").extra(),
        column("最大").extra(),
    ]);
    table.rows.push(vec!["精確".into(), 1.0.into(), 2.0.into()]);
    table
        .rows
        .push(vec!["Phong".into(), 10.0.into(), 20.0.into()]);
    assert_eq!(
        table.text(),
        "  名稱   RMS  最大\n  精確     1     2\n  Phong   10    20\n"
    );
    let heads = |left_out| table.for_people(left_out).0;
    assert_eq!(heads(1), ["名稱", "RMS"]);
    assert_eq!(heads(2), ["名稱"]);
}

/// Characters that begin a formula; spreadsheets also accept the wide ones of East Asian keyboards.
const FORMULA: [char; 8] = ['=', '+', '-', '@', '＝', '＋', '－', '＠'];

/// Returns a text as a field of CSV.
fn field(text: &str) -> String {
    let mut table = Table::new([Column::key("text")]);
    table.rows.push(vec![text.into()]);
    let csv = table.to_csv();
    let field = csv
        .strip_prefix("text\n")
        .and_then(|rest| rest.strip_suffix('\n'));
    field.expect("a head and a row").to_owned()
}

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
