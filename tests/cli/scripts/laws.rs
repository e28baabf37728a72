//! A scene whose law cannot be read: what is wrong with it, and where.

use crate::common::program::Folder;
use crate::common::value;

/// Returns a scene file whose law is `formula`, from its fourth line on.
fn scene(formula: &str) -> String {
    format!("[reflection]\nmodel = \"formula\"\nformula = \"\"\"\n{formula}\"\"\"\n")
}

/// Returns the message about a law.
fn message(place: &str, line: usize, column: usize, problem: &str) -> String {
    let at = english!(
        "formula-at",
        line = line,
        column = column,
        problem = problem
    );
    format!("{place} `reflection.formula` {at}")
}

fn meant(name: &str) -> String {
    english!("document-did-you-mean", name = name)
}

#[test]
fn a_law_that_cannot_be_read_is_refused_with_its_place_and_the_nearest_name() {
    let folder = Folder::new("laws");
    let unknown = english!("formula-unknown", name = "sopt", meant = meant("spot"));
    let vector = english!(
        "formula-vector-for-number",
        part = "max(N, 0)",
        meant = meant("N·L")
    );
    let open = english!(
        "formula-ends",
        expected = english!("formula-expected-sign", sign = ")")
    );
    let many = vec!["kd"; 258].join("+");
    for (formula, line, column, problem) in [
        (
            "spot = max(R·V, 0)\nkd * N·L + ks * sopt^n\n",
            2,
            17,
            &*unknown,
        ),
        ("kd *\n\tmax(N, 0)\n", 2, 6, &vector),
        ("kd * (ks + 1", 1, 13, &open),
        ("", 1, 1, english!("formula-empty")),
        ("# only a comment\n", 2, 1, english!("formula-empty")),
        ("spot = R·V\n", 2, 1, english!("formula-no-value")),
        ("N", 1, 1, english!("formula-result-vector")),
        (&many, 1, 1, &english!("formula-operations", most = 256)),
    ] {
        folder.write("s.toml", scene(formula));
        let expected = message("s.toml:3:", line, column, problem);
        for arguments in [
            &["check", "s.toml"][..],
            &["render", "s.toml", "-o", "a.png"],
            &["link", "s.toml"],
        ] {
            folder.fails(arguments, 2, &[&expected]);
        }
    }
    // The law of another model is read too, so that choosing it later draws a picture.
    folder.write("s.toml", "reflection.formula = \"max(N, 0)\"\n");
    folder.fails(
        &["check", "s.toml"],
        2,
        &[&message("s.toml:1:", 1, 5, &vector)],
    );
    for (formula, line, column, problem) in [
        ("kd * max(N, 0)", 1, 10, &*vector),
        ("a = 1; kd * max(N, 0)", 1, 17, &vector),
        ("a = 1\nkd * max(N, 0)", 2, 10, &vector),
    ] {
        let setting = format!("reflection.formula={formula}");
        let place = format!("--set {}:", setting.escape_debug());
        folder.fails(
            &["check", "sphere", "--set", &setting],
            2,
            &[&message(&place, line, column, problem)],
        );
    }
    assert_eq!(folder.names(), ["s.toml"]);
}

#[test]
fn a_law_of_too_many_characters_or_of_control_characters_is_refused() {
    let folder = Folder::new("long-laws");
    let most = english!("range-lines", longest = 2000);
    let long = format!("{}kd", " ".repeat(1999));
    for (formula, found) in [
        (long.as_str(), format!("{:?}", " ".repeat(20))),
        ("kd\\u0007", "\"kd\\u{7}\"".to_owned()),
        ("kd\\u001b[31m", "\"kd\\u{1b}[31m\"".to_owned()),
    ] {
        folder.write("s.toml", scene(formula));
        let expected = value("s.toml:3: `reflection.formula`", &found, &most);
        folder.fails(&["check", "s.toml"], 2, &[&expected]);
    }
    let longest = format!("{}kd", " ".repeat(1998));
    folder.write("s.toml", scene(&longest));
    folder.prints(&["check", "s.toml"]);
}

#[test]
fn a_law_is_set_in_one_line_or_in_several() {
    let folder = Folder::new("laws-set");
    let picture = |settings: &[&str]| {
        let mut arguments = vec!["render", "sphere", "--size", "24x24", "-o", "a.png"];
        for setting in ["reflection.model=formula"].iter().chain(settings) {
            arguments.extend(["--set", setting]);
        }
        folder.prints(&arguments);
        crate::common::program::pixels_of(&folder.0.join("a.png"))
    };
    let phong = picture(&[]);
    for formula in [
        "s = max(R·V, 0); kd*od*max(N·L, 0) + ks*os*s^n*(N·L > 0)",
        "s = max(R·V, 0)\nkd*od*max(N·L, 0) + ks*os*s^n*(N·L > 0)",
        "s = max(R·V, 0)\r\nkd*od*max(NL, 0) + ks*os*s^n*(L·N > 0)",
        "\"s = max(R·V, 0)\\nkd*od*max(N·L, 0) + ks*os*s^n*(N·L > 0)\"",
    ] {
        let setting = format!("reflection.formula={formula}");
        assert!(picture(&[&setting]) == phong, "{formula}");
    }
    for formula in ["0", "0.5", "-1e3"] {
        let setting = format!("reflection.formula={formula}");
        assert!(picture(&[&setting]) != phong, "{formula}");
    }
}
