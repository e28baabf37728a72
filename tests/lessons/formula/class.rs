//! The formulas of a class, sorted by their meaning.

use super::{SolvedQuestion, below, lesson};
use crate::common::program::Folder;
use shading_lab::lesson::{
    Answer, Answered, Grade, Handed, Lesson, Record, class_sheet, collect, hand_in_bytes, worksheet,
};
use shading_lab::render::Frame;
use shading_lab::scene::Scene;
use std::collections::BTreeMap;

const KEYS: &str = "names = [\"kd\", \"ip\", \"N·L\"]\nanswer = \"kd * ip * max(N·L, 0)\"\n\
    [[wrong]]\nformula = \"kd * ip * N·L\"\nsays = \"Negative.\"\n\
    [[wrong]]\nformula = \"kd * ip * abs(N·L)\"\nsays = \"Both sides.\"";

/// Functions, each with the wrong model that it is, and spellings of its cosine.
const FUNCTIONS: [(Option<usize>, [&str; 4]); 5] = [
    (
        None,
        [
            "max(N·L, 0)",
            "max(0, L·N)",
            "(N·L + abs(N·L))/2",
            "clamp(NL, 0, 1)",
        ],
    ),
    (Some(0), ["N·L", "L·N", "dot(N, L)", "(2*N·L - N·L)"]),
    (
        Some(1),
        ["abs(N·L)", "max(N·L, -N·L)", "sqrt(N·L^2)", "abs(-L·N)"],
    ),
    (
        None,
        [
            "max(N·L, 0)^2",
            "max(0, NL)²",
            "max(N·L, 0)*max(N·L, 0)",
            "clamp(N·L, 0, 1)^2",
        ],
    ),
    (
        None,
        [
            "(N·L > 0)",
            "(0 < N·L)",
            "not (N·L <= 0)",
            "(1 - (N·L <= 0))",
        ],
    ),
];

/// Returns spellings of functions with the number of the function.
fn answers(count: usize) -> Vec<(usize, String)> {
    let mut state = 42;
    let one = |_| {
        let function = below(&mut state, FUNCTIONS.len());
        let cosine = FUNCTIONS[function].1[below(&mut state, 4)];
        let text = match below(&mut state, 5) {
            0 => format!("kd*ip*{cosine}"),
            1 => format!("{cosine} * ip * kd"),
            2 => format!("c = {cosine}; ip*c*kd"),
            3 => format!("(kd*{cosine})*ip + 0"),
            _ => format!("Kd * (Ip * {cosine}) / 1"),
        };
        (function, text)
    };
    (0..count)
        .map(one)
        .filter(|(_, text)| !text.contains("* not"))
        .collect()
}

#[test]
fn two_hundred_answers_are_sorted_by_meaning() {
    let asked = SolvedQuestion::new(KEYS);
    let answers: Vec<(usize, String)> = answers(230)
        .into_iter()
        .filter(|(_, text)| asked.grade(text).is_some())
        .take(200)
        .collect();
    assert_eq!(answers.len(), 200);
    let graded = answers.iter();
    let graded = graded.map(|(_, text)| (&**text, asked.grade(text).expect("a formula")));
    let groups = asked.kind().sorted(graded, asked.right());
    let mut expected: BTreeMap<usize, Vec<&str>> = BTreeMap::new();
    for (function, text) in &answers {
        expected.entry(*function).or_default().push(text);
    }
    assert_eq!(groups.len(), expected.len());
    for group in &groups {
        let of = |text: &str| {
            answers
                .iter()
                .find(|(_, known)| known == text)
                .expect("known")
                .0
        };
        let function = of(&group.spellings[0].0);
        assert!(
            group.spellings.iter().all(|(text, _)| of(text) == function),
            "{group:?}"
        );
        assert_eq!(group.count(), expected[&function].len());
        assert_eq!(group.model, FUNCTIONS[function].0);
        assert_eq!(group.right, function == 0);
        let counts: Vec<usize> = group.spellings.iter().map(|(_, count)| *count).collect();
        assert!(counts.is_sorted_by(|a, b| a >= b));
    }
    let models: Vec<_> = groups
        .iter()
        .map(|group| (group.right, group.model.is_none()))
        .collect();
    assert!(
        models.is_sorted(),
        "wrong models first, the right one last: {models:?}"
    );
}

fn handed(lesson: &Lesson, index: usize, text: &str) -> Handed {
    let mut record = Record::new(&lesson.name, 1);
    let answer = Answer::Formula(text.to_owned());
    record.put(Answered {
        step: 0,
        prediction: answer.clone(),
        answer,
        grade: Grade::default(),
        looked_up: 0,
        tries: 1,
        seconds: 9.0,
    });
    let frame = Frame {
        width: 4,
        height: 4,
        pixels: vec![[0, 0, 0, 255]; 16],
    };
    let bytes = hand_in_bytes(
        &frame,
        &Scene::default(),
        lesson,
        &record,
        &format!("Student {index}"),
    );
    Handed {
        path: format!("{index}.png").into(),
        bytes: Some(bytes.expect("a picture")),
    }
}

#[test]
fn a_sheet_shows_each_function_once() {
    let lesson = Lesson::read(&lesson(KEYS), None).expect("a lesson");
    let texts = [
        "kd*ip*N·L",
        "ip*kd*L·N",
        "kd*ip*abs(N·L)",
        "kd*ip*max(N·L,0)",
        "max(0, N·L)*ip*kd",
        "kd",
        "kd <b> ip",
        "not a formula",
    ];
    let files: Vec<Handed> = texts
        .iter()
        .enumerate()
        .map(|(index, text)| handed(&lesson, index, text))
        .collect();
    let class = collect(&files, None, false, &mut || {});
    // What cannot be read was not kept, so these two hand-ins have no answer.
    assert_eq!(class.set_aside.len(), 2);
    let group = &class.groups[0];
    let formulas = group.formulas(0);
    let counts: Vec<_> = formulas
        .iter()
        .map(|same| (same.model, same.right, same.count()))
        .collect();
    assert_eq!(
        counts,
        [
            (Some(0), false, 2),
            (Some(1), false, 1),
            (None, false, 1),
            (None, true, 2)
        ]
    );
    assert_eq!(group.models(0), [(0, 2), (1, 1)]);
    let sheet = class_sheet(&class);
    assert_eq!(sheet.matches("<tr class=\"is-right\">").count(), 1);
    assert!(sheet.contains("<code>ip*kd*L·N</code>") && sheet.contains("Negative."));
}

#[test]
fn the_program_prints_formulas_by_meaning() {
    let folder = Folder::new("formulas");
    let lesson = Lesson::read(&lesson(KEYS), None).expect("a lesson");
    for (index, text) in ["kd*ip*N·L", "ip*kd*L·N", "kd*ip*max(N·L, 0)"]
        .iter()
        .enumerate()
    {
        let bytes = handed(&lesson, index, text).bytes.expect("a picture");
        std::fs::write(folder.0.join(format!("{index}.png")), bytes).expect("a file");
    }
    let run = |arguments: &[&str]| {
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_shading-lab"));
        let output = command
            .current_dir(&folder.0)
            .arg("collect")
            .args(arguments)
            .output();
        String::from_utf8(output.expect("it runs").stdout).expect("text")
    };
    let files = ["0.png", "1.png", "2.png"];
    let table = run(&files);
    assert!(table.contains("2× kd*ip*N·L ✗"), "{table}");
    assert!(table.contains("1× kd*ip*max(N·L, 0) ✓"), "{table}");
    let json: serde_json::Value =
        serde_json::from_str(&run(
            &[&["--json", "--csv", "class.csv"], &files[..]].concat()
        ))
        .expect("JSON");
    let formulas = &json["questions"][0]["formulas"];
    assert_eq!(formulas[0]["model"], 0);
    assert_eq!(formulas[0]["count"], 2);
    assert_eq!(formulas[1]["spellings"][0]["text"], "kd*ip*max(N·L, 0)");
    let csv = std::fs::read_to_string(folder.0.join("class.csv")).expect("a table");
    assert!(csv.contains(",kd*ip*N·L,0,0,"), "{csv}");
}

#[test]
fn a_worksheet_has_a_line_to_write_on_and_the_formula_in_the_answers() {
    let lesson = Lesson::read(&lesson(KEYS), None).expect("a lesson");
    let sheet = shading_lab::lesson::Worksheet {
        answers: true,
        seed: 1,
        samples: 0,
    };
    let page = worksheet(&lesson, sheet, &mut || {}).expect("a page");
    let (asked, answers) = page.split_once("class=\"answers\"").expect("answers");
    assert!(asked.contains("<div class=\"rule\">") && !asked.contains("max("));
    assert!(
        answers.contains("max") && answers.contains("<sub><i>d</i></sub>"),
        "{answers}"
    );
}
