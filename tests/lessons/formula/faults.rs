//! Faulty questions: `check` names what is wrong, and the line.

use super::lesson;
use shading_lab::lesson::{Lesson, check};

/// Returns what is wrong with a question, with the lines.
fn wrong(keys: &str) -> String {
    let source = lesson(keys);
    let error = match Lesson::read(&source, None) {
        Ok(lesson) => check(&lesson).expect_err("faulty"),
        Err(error) => error,
    };
    error.to_string()
}

const NAMES: &str = "names = [\"kd\", \"N·L\"]\n";

#[test]
fn faulty_questions_are_found() {
    let with = |keys: &str| format!("{NAMES}{keys}");
    let model = |formula: &str| format!("\n[[wrong]]\nformula = \"{formula}\"\nsays = \"No.\"");
    let sound = with("answer = \"kd * max(N·L, 0)\"") + &model("kd * N·L");
    let lesson = Lesson::read(&lesson(&sound), None).expect("a lesson");
    let remarks = check(&lesson).expect("sound");
    assert_eq!(remarks.len(), 1);
    for (keys, expected) in [
        (
            with("answer = \"kd*0 + N·L*0 + 3\""),
            english!("lesson-formula-constant").to_owned(),
        ),
        (
            with("answer = \"kd*sqrt(-1 - abs(N·L))\""),
            english!("lesson-formula-undefined").to_owned(),
        ),
        (
            with("answer = \"kd * N·L\"") + &model("N·L*kd"),
            english!("lesson-wrong-near", apart = "0.00", least = "0.5"),
        ),
        (
            with("answer = \"kd * max(N·L, 0)\"") + &model("kd * N·L") + &model("N·L/(1/kd)"),
            english!("lesson-wrong-same", other = 1),
        ),
        (
            with("answer = \"kd\""),
            english!("lesson-formula-unused", name = "N·L"),
        ),
        (with(""), english!("lesson-missing", key = "answer")),
        (
            with("term = \"transmission\""),
            english!("lesson-formula-no-term").to_owned(),
        ),
        (
            with("answer = \"kd * max(N·K, 0)\""),
            "`answer`: ".to_owned(),
        ),
        (
            with("answer = \"kd * max(N·L, 0)\"") + &model("kd * (N·L"),
            "`formula`: ".to_owned(),
        ),
        (
            "names = [\"gain\"]\nanswer = \"gain\"".to_owned(),
            english!("lesson-formula-name", name = "gain"),
        ),
        (
            "names = [\"kd\", \"kd\"]\nanswer = \"kd\"".to_owned(),
            english!("lesson-formula-name", name = "kd"),
        ),
        (
            "names = [{ pi = [0, 1] }]\nanswer = \"1\"".to_owned(),
            english!("lesson-formula-name", name = "pi"),
        ),
        (
            "names = []\nanswer = \"1\"".to_owned(),
            english!("lesson-formula-many-names", most = 12),
        ),
        (
            "names = [{ a = [0, 1], b = [0, 1] }]\nanswer = \"a + b\"".to_owned(),
            english!("lesson-formula-names").to_owned(),
        ),
        (
            "names = [{ a = [1, 0] }]\nanswer = \"a\"".to_owned(),
            english!("lesson-range").to_owned(),
        ),
    ] {
        let words = wrong(&keys);
        assert!(words.contains(&expected), "{keys}\n{words}\n{expected}");
    }
    // Where the engine computes something else, its term is not this formula.
    let gold = lesson_with(
        "material.reflectance=gold",
        "names = [\"ks\", \"R·V\", \"n\", \"N·L\"]\nterm = \"specular\"",
    );
    let error = check(&Lesson::read(&gold, None).expect("a lesson")).expect_err("faulty");
    assert!(
        error
            .to_string()
            .contains("the engine computes something else"),
        "{error}"
    );
}

fn lesson_with(setting: &str, keys: &str) -> String {
    lesson(keys).replace("\"image.size", &format!("\"{setting}\", \"image.size"))
}

#[test]
fn the_line_of_a_faulty_model_is_named() {
    let keys = format!(
        "{NAMES}answer = \"kd * max(N·L, 0)\"\n[[wrong]]\nformula = \"kd * N·L\"\nsays = \"No.\"\n[[wrong]]\nformula = \"kd *\"\nsays = \"No.\""
    );
    let source = lesson(&keys);
    let line = 1 + source[..source.find("\"kd *\"").expect("there")]
        .matches('\n')
        .count();
    assert!(
        wrong(&keys).starts_with(&format!("{line}: ")),
        "{}",
        wrong(&keys)
    );
}
