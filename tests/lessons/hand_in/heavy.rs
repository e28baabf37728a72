//! Hand-ins whose lessons exceed the limit of work, memory or files: each gets a row of its own, and the others are graded.

use super::{answered, folder, handed_in, picture, record, run};
use serde_json::Value;
use shading_lab::lesson::{Answer, Lesson, Record, check, hand_in_bytes};
use shading_lab::scene::Scene;
use std::fs;
use std::path::Path;

/// Returns the messages about too much work and about too large a mesh.
fn too_much() -> [String; 2] {
    let triangles = english!("lesson-many-triangles", most = 4_194_304, triangles = "|");
    [
        english!("lesson-step-too-heavy", most = 20_000),
        triangles.split('|').next().unwrap_or_default().to_owned(),
    ]
}

/// Returns a lesson of one question in one step.
fn lesson_of(step: &str, question: &str) -> String {
    format!(
        "+++\nlesson = 1\nname = \"a\"\ntitle = \"A\"\n+++\n## A\n```step\n{step}\n```\n```question\nask = \"?\"\n{question}\n```\n"
    )
}

fn value(answer: &str) -> String {
    format!("kind = \"value\"\nanswer = '{answer}'\ntolerance = 1\nfrom = -9\nto = 9")
}

/// Returns an expression that sums `of` in many scenes.
fn in_many_scenes(of: &str) -> String {
    let scenes = (1..60).map(|n| format!("with(\"material.n={n}\", {of})"));
    scenes.collect::<Vec<_>>().join("+")
}

/// Returns lessons that would each take half a minute or more, with an answer to the question. `HEAVY_LESSONS=1` adds those that
/// take some seconds until they are stopped.
fn heavy() -> Vec<(&'static str, String, Answer)> {
    let many = (1..4000).map(|n| format!("{{{{ with(\"material.n={n}\", probe.sum[0]) }}}} "));
    let lamp = "{kind = \"area\", samples = 1024, position = [0, 3, 0], direction = [0, -1, 0]}";
    let lamps = format!(
        "scene = \"shadows\"\nset = [\"shading.shadows=true\", 'light=[{lamp}, {lamp}, {lamp}]', 'image.size=[1920, 480]']"
    );
    let mesh = "scene = \"teapot\"\nset = [\"object.segments=4096\", \"object.rings=4096\"]";
    let mut all = vec![
        (
            "mesh",
            lesson_of(mesh, &value("picture.mean")),
            Answer::Value(0.5),
        ),
        (
            "lamps",
            lesson_of(&lamps, &value("picture.mean")),
            Answer::Value(0.5),
        ),
    ];
    let slow = vec![
        (
            "grid",
            lesson_of(
                "scene = \"teapot\"",
                &format!(
                    "kind = \"point\"\nfind = \"greatest\"\nof = '{}'",
                    in_many_scenes("probe.sum[0]")
                ),
            ),
            Answer::Point([0.0, 0.0]),
        ),
        (
            "many",
            lesson_of(
                "scene = \"teapot\"\nprobe = [0, 0]",
                &value("0.5").replacen(
                    "kind",
                    &format!("why = '''{}'''\nkind", many.collect::<String>()),
                    1,
                ),
            ),
            Answer::Value(0.5),
        ),
    ];
    if std::env::var_os("HEAVY_LESSONS").is_some() {
        all.extend(slow);
    }
    all
}

fn hand_in_of(source: &str, answer: &Answer) -> Vec<u8> {
    let lesson = Lesson::read(source, None).expect("a lesson");
    let mut record = Record::new("a", 7);
    record.put(answered(0, answer.clone()));
    hand_in_bytes(&picture(), &Scene::default(), &lesson, &record, "Mallory").expect("a picture")
}

/// Collects the files of a folder; returns the printed JSON object, and the errors.
fn collected(folder: &Path, files: &[&str]) -> (Value, String) {
    let output = run(
        folder,
        &[&["collect", "--json", "-o", "class.html"], files].concat(),
    );
    let errors = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{errors}");
    assert!(folder.join("class.html").is_file());
    let object = serde_json::from_slice(&output.stdout);
    (object.expect("JSON"), errors)
}

#[test]
fn a_heavy_hand_in_is_one_row_and_the_others_are_graded() {
    let folder = folder("heavy");
    let heavy = heavy();
    let mut files = vec!["ada.png".to_owned()];
    fs::write(folder.join("ada.png"), handed_in(&record(0.5, 1), "Ada")).expect("a file");
    for (name, source, answer) in &heavy {
        let file = format!("{name}.png");
        fs::write(folder.join(&file), hand_in_of(source, answer)).expect("a file");
        // Before the other, so that it could stop the run.
        files.insert(0, file);
    }
    let files: Vec<&str> = files.iter().map(String::as_str).collect();
    let (object, errors) = collected(&folder, &files);
    let rows = object["rows"].as_array().expect("a list");
    assert_eq!(rows.len(), 1, "{object}");
    assert_eq!(rows[0]["name"], "Ada");
    assert_eq!(rows[0]["answers"][0]["right"], true);
    let unreadable = object["unreadable"].as_array().expect("a list");
    assert_eq!(unreadable.len(), heavy.len(), "{errors}");
    let question = english!("class-too-heavy", question = 1, why = "|");
    let (start, _) = question.split_once('|').expect("a reason");
    for row in unreadable {
        let why = row["why"].as_str().expect("why");
        let why = why.strip_prefix(start).expect("question 1");
        assert!(too_much().iter().any(|words| why.contains(words)), "{why}");
    }
    assert_eq!(errors.lines().count(), heavy.len(), "{errors}");
}

#[test]
fn what_is_too_heavy_in_ones_own_lesson_is_said_at_its_question() {
    let (_, source, _) = heavy().remove(1);
    let source = source
        + &lesson_of("scene = \"sphere\"", &value("2 < 1"))
            .split_once("## A")
            .map(|(_, rest)| format!("## B{}", rest.replace("tolerance = 1", "tolerance = 100")))
            .expect("a step");
    let lesson = Lesson::read(&source, None).expect("a lesson");
    let error = check(&lesson).expect_err("it is too heavy");
    let words: Vec<&str> = error
        .problems
        .iter()
        .map(|problem| &*problem.words)
        .collect();
    // The second question is graded nevertheless.
    assert_eq!(words.len(), 2, "{words:?}");
    assert!(words[0].contains(&too_much()[0]), "{words:?}");
    assert!(words[1].contains("`from`"), "{words:?}");
}

#[test]
fn a_hand_in_opens_no_file_whatever_it_calls_it() {
    let folder = folder("files");
    fs::write(folder.join("x.toml"), Scene::default().to_toml()).expect("a file");
    let path = folder.join("x.toml");
    let path = path.to_str().expect("UTF-8");
    let names = [
        path.to_owned(),
        format!("{path}/."),
        format!("{path}/"),
        format!("{path}/./."),
        "x.toml".to_owned(),
        "x.toml/.".to_owned(),
        "./x.toml".to_owned(),
        "//localhost/x.toml".to_owned(),
        r"\\\\host\\share\\x.toml".to_owned(),
        r"\\\\?\\C:\\x.toml".to_owned(),
        "C:/x.toml".to_owned(),
        "NUL".to_owned(),
    ];
    let mut files = Vec::new();
    for (index, name) in names.iter().enumerate() {
        let source = lesson_of(&format!("scene = \"{name}\""), &value("picture.mean"));
        let file = format!("{index}.png");
        fs::write(folder.join(&file), hand_in_of(&source, &Answer::Value(0.5))).expect("a file");
        files.push(file);
        let lesson = Lesson::read(&source, None).expect("a lesson");
        let staged = lesson.steps[0].stage.load(None);
        assert!(staged.is_err(), "{name} is opened");
    }
    let model = lesson_of(
        "scene = \"sphere\"\nset = [\"object.kind=obj\", \"object.path=a.obj\"]",
        &value("picture.mean"),
    );
    let model = Lesson::read(&model, None).expect("a lesson");
    assert!(model.steps[0].stage.load(None).is_err());
    let files: Vec<&str> = files.iter().map(String::as_str).collect();
    let (object, errors) = collected(&folder, &files);
    assert_eq!(errors.lines().count(), names.len(), "{errors}");
    for row in object["rows"].as_array().expect("a list") {
        assert!(row["answers"][0]["right"].is_null(), "{row}");
    }
}

#[test]
fn a_curve_over_nothing_stops_nobodys_page() {
    let folder = folder("thin");
    let question = "kind = \"curve\"\nx = [0, 5e-324]\ny = [0, 1]\nanswer = \"1\"";
    let thin = lesson_of("scene = \"sphere\"", question);
    let error = Lesson::read(&thin, None).expect_err("no range");
    assert!(
        error.to_string().contains(english!("lesson-range")),
        "{error}"
    );
    // A hand-in can contain what the program would not write.
    let sound = thin.replace("5e-324", "1e+3");
    let curve = Answer::Curve(vec![Some(0.5); 65]);
    let bytes = hand_in_of(&sound, &curve);
    let forged = super::forged(&bytes, "1e+3", "5e-324");
    fs::write(folder.join("thin.png"), forged).expect("a file");
    fs::write(folder.join("ada.png"), handed_in(&record(0.5, 1), "Ada")).expect("a file");
    let (object, _) = collected(&folder, &["thin.png", "ada.png"]);
    assert_eq!(object["rows"].as_array().map(Vec::len), Some(1));
    let why = object["unreadable"][0]["why"].as_str().expect("why");
    assert!(why.contains(english!("lesson-range")), "{why}");
}
