//! What `collect` says of a class: who counts, how numbers are spread, first and last answers, and a test before and after.

use super::{answered, folder, handed_in, record, resealed, run, work};
use serde_json::{Value, json};
use shading_lab::lesson::{Answer, CURVE_POINTS, Record};
use std::fs;
use std::path::Path;
use std::process::Output;

/// Runs `collect` on pictures, and returns the JSON with what went to stderr.
fn collected(folder: &Path, files: &[(&str, Vec<u8>)], more: &[&str]) -> (Value, String, Output) {
    let mut arguments = vec!["collect", "--json"];
    arguments.extend(more);
    for (file, bytes) in files {
        fs::write(folder.join(file), bytes).expect("a file");
        arguments.push(file);
    }
    let output = run(folder, &arguments);
    let object = serde_json::from_slice(&output.stdout).expect("JSON");
    let errors = String::from_utf8_lossy(&output.stderr).into_owned();
    (object, errors, output)
}

#[test]
fn a_student_counts_once_and_an_empty_sheet_nowhere() {
    let folder = folder("once");
    let nothing = Record::new("own-lesson", 7);
    let files = [
        ("ada-1.png", handed_in(&record(0.7, 0), "Ada Lovelace")),
        ("ben.png", handed_in(&record(0.7, 0), "Ben")),
        ("nobody-1.png", handed_in(&record(0.5, 1), "")),
        ("empty.png", handed_in(&nothing, "Eve")),
        ("nobody-2.png", handed_in(&record(0.5, 1), "")),
        ("ada-2.png", handed_in(&record(0.5, 1), " ada  LOVELACE")),
    ];
    let (object, errors, output) = collected(&folder, &files, &["-o", "class.html"]);
    assert!(output.status.success(), "{errors}");
    let names = |key: &str| -> Vec<&str> {
        let list = object[key].as_array().expect("a list").iter();
        list.map(|row| row["file"].as_str().expect("a name"))
            .collect()
    };
    let counted = ["ben.png", "nobody-1.png", "nobody-2.png", "ada-2.png"];
    assert_eq!(names("rows"), counted);
    assert_eq!(names("set_aside"), ["empty.png", "ada-1.png"]);
    assert_eq!(names("unreadable"), [""; 0]);
    assert_eq!(object["questions"][0]["share_right"], 0.75);
    let again = english!("class-again", file = "ada-2.png");
    let page = fs::read_to_string(folder.join("class.html")).expect("a page");
    for words in [again.as_str(), english!("class-empty")] {
        assert!(errors.contains(words) && page.contains(words), "{words}");
    }
    // The same file twice is one, too.
    let twice = run(&folder, &["collect", "--json", "ben.png", "ben.png"]);
    let twice: Value = serde_json::from_slice(&twice.stdout).expect("JSON");
    assert_eq!(twice["rows"].as_array().map(Vec::len), Some(1));
    // Nothing at all is no class.
    let (object, ..) = collected(&folder, &[("empty.png", handed_in(&nothing, "Eve"))], &[]);
    assert_eq!(object["rows"], json!([]));
}

#[test]
fn forged_numbers_are_bounded() {
    let folder = folder("forged-numbers");
    let sound = handed_in(&work(0), "Mallory");
    let with = |at: &str, value: Value| {
        resealed(&sound, |all| {
            *all.pointer_mut(at).expect("a place") = value;
        })
    };
    let unfit = [
        ("value.png", with("/answers/0/given", json!(1e308))),
        ("first.png", with("/answers/0/prediction", json!(-1.001))),
        ("curve.png", with("/answers/2/given/5", json!(1e308))),
        ("place.png", with("/answers/3/given", json!([1e308, 0.0]))),
    ];
    let (object, errors, output) = collected(&folder, &unfit, &[]);
    assert_eq!(output.status.code(), Some(2));
    assert_eq!(
        object["unreadable"].as_array().map(Vec::len),
        Some(4),
        "{errors}"
    );
    assert_eq!(
        errors.matches(english!("class-unfit")).count(),
        4,
        "{errors}"
    );
    let long = [("long.png", with("/answers/0/seconds", json!(1e308)))];
    let (object, ..) = collected(&folder, &long, &["--csv", "class.csv"]);
    assert_eq!(object["rows"][0]["answers"][0]["seconds"], 1e7);
    let table = fs::read_to_string(folder.join("class.csv")).expect("a table");
    assert!(table.contains(",10000000.0,"), "{table}");
}

#[test]
fn a_spread_says_only_what_is_spread() {
    let folder = folder("spread");
    let value = |value: f64| {
        let mut record = Record::new("own-lesson", 7);
        record.put(answered(0, Answer::Value(value)));
        record
    };
    let words = |values: &[f64]| {
        let mut arguments = vec!["collect".to_owned()];
        for (index, number) in values.iter().enumerate() {
            let file = format!("{index}.png");
            fs::write(folder.join(&file), handed_in(&value(*number), "")).expect("a file");
            arguments.push(file);
        }
        let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
        let table = run(&folder, &arguments).stdout;
        String::from_utf8_lossy(&table).into_owned()
    };
    for (values, expected) in [
        (
            &[0.6; 7][..],
            english!("class-predicted-same", value = "0.6"),
        ),
        (&[0.6][..], english!("class-predicted-same", value = "0.6")),
        (
            &[0.8, 0.5, 0.6][..],
            english!("class-predicted-few", values = "0.5, 0.6, 0.8"),
        ),
        (
            &[0.1, 0.2, 0.3, 0.4, 0.5][..],
            english!(
                "class-predicted",
                least = "0.1",
                lower = "0.2",
                median = "0.3",
                upper = "0.4",
                greatest = "0.5"
            ),
        ),
    ] {
        let table = words(values);
        assert!(table.contains(&expected), "{table}\n{expected}");
    }
}

#[test]
fn first_and_last_answers_are_told_apart() {
    let folder = folder("first-and-last");
    let mut record = work(0);
    let mut changed = answered(0, Answer::Value(0.5));
    changed.prediction = Answer::Value(0.9);
    record.put(changed);
    let files = [("ada.png", handed_in(&record, "Ada"))];
    let (object, ..) = collected(&folder, &files, &["--csv", "class.csv", "-o", "class.html"]);
    let answer = &object["rows"][0]["answers"][0];
    assert_eq!(
        (&answer["given"], &answer["prediction"]),
        (&json!(0.5), &json!(0.9))
    );
    assert_eq!(
        (&answer["right"], &answer["prediction_right"]),
        (&json!(true), &json!(false))
    );
    let table = fs::read_to_string(folder.join("class.csv")).expect("a table");
    let mut table = csv::Reader::from_reader(table.as_bytes());
    let heads = table.headers().expect("heads").clone();
    let row = table.records().next().expect("a row").expect("a row");
    let cell = |head: &str| {
        let place = heads.iter().position(|name| name == head).expect(head);
        row[place].to_owned()
    };
    let first = ["q1_first", "q1_first_right", "q1", "q1_right"].map(cell);
    assert_eq!(first, ["0.9", "0", "0.5", "1"]);
    assert_eq!(
        ["q1_tries", "q1_looked_up", "q1_seconds"].map(cell),
        ["2", "1", "3.5"]
    );
    // A curve is one cell.
    assert_eq!(cell("q3").split(' ').count(), CURVE_POINTS);
    let page = fs::read_to_string(folder.join("class.html")).expect("a page");
    assert!(page.contains("0.9 → 0.5 ✓"));
    let tries = english!("course-answers-tries", count = 2);
    let seconds = english!("course-answers-seconds", seconds = "4");
    assert!(page.contains(&tries) && page.contains(&seconds));
}

#[test]
fn a_test_before_is_compared_with_one_after_and_names_nobody() {
    let folder = folder("inventory");
    // Before, two of four know the value and one the option; after, all know the value and three the option.
    let knowledge = [
        (
            "pre",
            [(true, true), (true, false), (false, false), (false, false)],
        ),
        (
            "post",
            [(true, true), (true, true), (true, true), (true, false)],
        ),
    ];
    let mut arguments = vec!["collect".to_owned(), "--json".to_owned()];
    for (test, students) in knowledge {
        arguments.push(format!("--{test}"));
        for (index, (value, option)) in students.into_iter().enumerate() {
            let mut record = record(if value { 0.5 } else { 0.9 }, usize::from(option));
            // What counts is the first answer.
            record.answers[0].answer = Answer::Value(0.5);
            let file = format!("{test}-{index}.png");
            let name = format!("Secret {index}");
            fs::write(folder.join(&file), handed_in(&record, &name)).expect("a file");
            arguments.push(file);
        }
    }
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let output = run(&folder, &arguments);
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{errors}");
    let object: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let shares = |test: &str| -> Vec<Value> {
        let items = object[test]["items"].as_array().expect("items").iter();
        items.map(|item| item["difficulty"].clone()).collect()
    };
    assert_eq!(
        shares("pre"),
        [json!(0.5), json!(0.25), json!(0.0), json!(0.0)]
    );
    assert_eq!(
        shares("post"),
        [json!(1.0), json!(0.75), json!(0.0), json!(0.0)]
    );
    // 3 of 16 before, 7 of 16 after.
    let gain = object["gain"].as_f64().expect("a gain");
    assert!((gain - 4.0 / 13.0).abs() < 1e-12, "{gain}");
    let words = run(&folder, &[&["collect"], &arguments[2..]].concat());
    let words = String::from_utf8_lossy(&words.stdout).into_owned();
    let class = english!("inventory-class-gain", gain = "0.31");
    assert!(words.contains(&class), "{words}");
    for text in [&words, &object.to_string()] {
        assert!(!text.contains("Secret") && !text.contains(".png"), "{text}");
    }
    let alone = run(&folder, &["collect", "--pre", "pre-0.png"]);
    assert_eq!(alone.status.code(), Some(2));
}
