//! The catalogue of stiff and extreme cases: the engine holds in each, and the naive way does not.

use shading_lab::analysis::{HALF_A_CODE_VALUE, Verdict, stability, stability_cases};
use shading_lab::render::Renderer;
use std::collections::HashSet;

/// Cases in which the naive way holds as well: their condition is mild, and they stand there for comparison.
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
        assert!(result.pixels > 8000, "{}: most pixels are compared", result.case.name);
        let expected = if MILD.contains(&result.case.name) { Verdict::BothHold } else { Verdict::RobustHolds };
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
        let scene = case.scene();
        assert!(
            scene.is_none_or(|scene| scene.validate().is_ok()),
            "{}: {:?}",
            case.name,
            case.scene().map(|s| s.validate())
        );
    }
}
