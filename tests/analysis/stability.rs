//! The catalogue of stiff and extreme cases: the engine is accurate in each, and the naive computation is not.

use shading_lab::analysis::stability::{HALF_A_CODE_VALUE, Verdict, stability, stability_cases};
use shading_lab::render::Renderer;
use shading_lab::text::{Language, in_language};
use std::collections::HashSet;
use std::process::Command;

/// Cases in which the naive computation is accurate as well: they are well conditioned, and listed for comparison.
const MILD: [&str; 1] = ["exponent-1e4"];

#[test]
fn the_engine_is_within_half_a_code_value_in_every_case() {
    let mut renderer = Renderer::default();
    let mut failed = Vec::new();
    for case in stability_cases() {
        let result = stability(&mut renderer, case);
        println!(
            "{:22} naive {:8.3} ({} off, {} not finite) robust {:8.4} of {} {:?}",
            result.case.name,
            result.naive_error,
            result.naive_off,
            result.naive_not_finite,
            result.robust_error,
            result.pixels,
            result.verdict
        );
        assert!(
            result.pixels > 8000,
            "{}: most pixels are compared",
            result.case.name
        );
        let expected = if MILD.contains(&result.case.name) {
            Verdict::BothHold
        } else {
            Verdict::RobustHolds
        };
        let holds = result.robust_error <= HALF_A_CODE_VALUE && result.robust_not_finite == 0;
        if !holds || result.verdict != expected {
            failed.push(result.case.name);
        }
    }
    assert!(failed.is_empty(), "{failed:?}");
}

#[test]
fn every_case_has_a_name_of_its_own_and_is_a_sound_scene() {
    let names: Vec<&str> = stability_cases().map(|case| case.name).collect();
    assert!(names.len() >= 25);
    assert_eq!(names.iter().collect::<HashSet<_>>().len(), names.len());
    for case in stability_cases() {
        for language in Language::ALL {
            in_language(language, || {
                for text in [case.title(), case.naive(), case.engine()] {
                    assert!(!text.starts_with("engine-"), "{text} has no text");
                }
            });
        }
        let scene = case.scene();
        assert!(
            scene.is_none_or(|scene| scene.validate().is_ok()),
            "{}: {:?}",
            case.name,
            case.scene().map(|s| s.validate())
        );
    }
}

/// Runs the program; returns its exit code, and what it writes to stdout and to stderr.
pub fn program(words: &[&str]) -> (Option<i32>, String, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_shading-lab"))
        .env_remove("LANGUAGE")
        .env("LC_ALL", "C")
        .args(words)
        .output()
        .expect("the program runs");
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (
        output.status.code(),
        text(&output.stdout),
        text(&output.stderr),
    )
}

#[test]
fn the_command_line_tells_and_draws_the_cases() {
    let (status, out, _) = program(&[
        "stability",
        "--case",
        "exponent-1e6,critical-angle",
        "--json",
    ]);
    assert_eq!(status, Some(0));
    let told: serde_json::Value = serde_json::from_str(&out).expect("one JSON object");
    let cases = told["cases"].as_array().expect("a list");
    assert_eq!(
        cases
            .iter()
            .map(|case| case["name"].as_str())
            .collect::<Vec<_>>(),
        [Some("exponent-1e6"), Some("critical-angle")]
    );
    for case in cases {
        assert!(
            case["naive_error"].as_f64().expect("a number") > HALF_A_CODE_VALUE,
            "{case}"
        );
        assert!(
            case["robust_error"].as_f64().expect("a number") <= HALF_A_CODE_VALUE,
            "{case}"
        );
        assert_eq!(case["verdict"], "robust-holds");
    }
    let folder = std::env::temp_dir().join(format!("shading-lab-stability-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    let (sheet, table) = (folder.join("w.png"), folder.join("w.csv"));
    let files = [
        "-o",
        sheet.to_str().expect("Unicode"),
        "--csv",
        table.to_str().expect("Unicode"),
    ];
    let (status, out, err) = program(&[&["stability", "--case", "w-0"], &files[..]].concat());
    assert_eq!((status, out.as_str(), err.as_str()), (Some(0), "", ""));
    // The sheet of one case opens as its scene.
    let opened = shading_lab::document::load_scene(&sheet)
        .expect("a picture with a scene")
        .scene;
    assert_eq!(
        Some(opened),
        stability_cases()
            .find(|case| case.name == "w-0")
            .expect("a case")
            .scene()
    );
    assert_eq!(
        std::fs::read_to_string(&table)
            .expect("a table")
            .lines()
            .count(),
        2
    );
    let _ = std::fs::remove_dir_all(&folder);
    let (status, _, err) = program(&["stability", "--case", "w-1"]);
    assert!(
        status == Some(2) && err.contains("w-1") && err.contains("critical-angle"),
        "{err}"
    );
}
