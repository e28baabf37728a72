//! Answers handed in as a picture: they are read back unchanged, changes, damage and forgery are detected, and the engine grades
//! a class.

mod collect;
mod heavy;

use serde_json::{Value, json};
use shading_lab::lesson::{
    ANSWERS_KEYWORD, Answer, Answered, CURVE_POINTS, Grade, HandInError, Lesson, Record,
    hand_in_bytes, read_hand_in,
};
use shading_lab::picture::{SCENE_KEYWORD, read_scene_text, read_texts, write_png};
use shading_lab::render::Frame;
use shading_lab::scene::Scene;
use std::fs;
use std::io::Cursor;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const LESSON: &str = r#"+++
lesson = 1
name = "own-lesson"
title = "A lecturer's own"
+++

## One number

```step
scene = "matt"
probe = [0.0, 0.0]
```

```question
kind = "value"
ask = "cos 60°?"
answer = "cos(60)"
tolerance = 0.05
from = -1
to = 1
[[wrong]]
answer = "cos(45)"
says = "That is the cosine of <45°>."
```

## One option

```question
kind = "choice"
ask = "Which is greater?"
[[option]]
text = "One"
says = "Two is more than one."
right = false
[[option]]
text = "Two"
right = true
```

## One curve

```question
kind = "curve"
ask = "Draw cos²x."
x = [0, 90]
y = [0, 1]
x_name = "x"
y_name = "cos²x"
answer = "cos(x)^2"
tolerance = 0.1
```

## One place

```step
scene = "sphere"
set = ["camera.eye=[0,0,4]", "camera.target=[0,0,0]", "image.size=[128,128]"]
```

```question
kind = "point"
ask = "Where is $N·L$ greatest?"
find = "greatest"
of = "0 - abs(probe.position[0]) - abs(probe.position[1])"
```
"#;

fn lesson() -> Lesson {
    Lesson::read(LESSON, None).expect("a lesson")
}

fn picture() -> Frame {
    Frame {
        width: 8,
        height: 8,
        pixels: vec![[10, 20, 30, 255]; 64],
    }
}

fn answered(step: usize, answer: Answer) -> Answered {
    Answered {
        step,
        prediction: answer.clone(),
        answer,
        grade: Grade::default(),
        looked_up: 1,
        tries: 2,
        seconds: 3.5,
    }
}

fn record(value: f64, option: usize) -> Record {
    let mut record = Record::new("own-lesson", 7);
    record.put(answered(0, Answer::Value(value)));
    record.put(answered(1, Answer::Choice(option)));
    record
}

fn handed_in(record: &Record, name: &str) -> Vec<u8> {
    hand_in_bytes(&picture(), &Scene::default(), &lesson(), record, name).expect("a picture")
}

#[test]
fn answers_name_lesson_and_scene_come_back() {
    let mut given = record(0.5, 1);
    // Answers that fit no question are not written.
    let bytes = handed_in(&given, "王小明");
    given.put(answered(1, Answer::Value(1.0)));
    given.put(answered(7, Answer::Choice(0)));
    let fewer = read_hand_in(Cursor::new(handed_in(&given, ""))).expect("answers");
    assert_eq!(fewer.record.answers.len(), 1);
    assert_eq!(fewer.name, "");

    let read = read_hand_in(Cursor::new(&bytes)).expect("answers");
    assert_eq!((&*read.name, &*read.title), ("王小明", "A lecturer's own"));
    assert_eq!(read.record, record(0.5, 1));
    assert_eq!(read.source.as_deref(), Some(LESSON));
    let scene = read_scene_text(Cursor::new(&bytes)).expect("a scene");
    assert_eq!(Scene::parse(&scene, ""), Ok(Scene::default()));
}

#[test]
fn a_change_is_noticed() {
    let bytes = handed_in(&record(0.4, 0), "Ada");
    let wanted = [(ANSWERS_KEYWORD, 1 << 20), (SCENE_KEYWORD, 1 << 20)];
    let [answers, scene] = read_texts(Cursor::new(&bytes), wanted).expect("texts");
    let (answers, scene) = (answers.expect("answers"), scene.expect("a scene"));
    let written = |answers: &str, scene: &str| {
        let mut bytes = Vec::new();
        let texts = [(ANSWERS_KEYWORD, answers), (SCENE_KEYWORD, scene)];
        write_png(&mut bytes, &picture(), None, &texts).expect("a picture");
        bytes
    };
    let read = |bytes: Vec<u8>| read_hand_in(Cursor::new(bytes));
    assert!(read(written(&answers, &scene)).is_ok());
    for changed in [
        answers.replace("\"given\":0.4", "\"given\":0.5"),
        answers.replace("Ada", "Bob"),
        answers.replace("\"looked_up\":1", "\"looked_up\":0"),
        answers.replace("\"seed\":7", "\"seed\":8"),
        answers.replace("answer = \\\"cos(60)\\\"", "answer = \\\"0.4\\\""),
        format!("{answers} "),
        answers.replacen("\"digest\":\"", "\"digest\":\"0", 1),
        answers.replacen("\"digest\"", "\"digits\"", 1),
    ] {
        assert_ne!(changed, answers);
        let error = read(written(&changed, &scene));
        assert!(matches!(error, Err(HandInError::Changed)), "{error:?}");
    }
    let other = format!("{scene}# ");
    let error = read(written(&answers, &other));
    assert!(matches!(error, Err(HandInError::Changed)), "{error:?}");
    assert!(matches!(
        read(written("{}", &scene)),
        Err(HandInError::Version)
    ));
    assert!(matches!(
        read(written("[", &scene)),
        Err(HandInError::Form(_))
    ));
    let mut none = Vec::new();
    write_png(&mut none, &picture(), Some(&Scene::default()), &[]).expect("a picture");
    assert!(matches!(read(none), Err(HandInError::NoAnswers)));
}

/// Creates a folder of a test's own.
fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("hand-in-{name}"));
    let _ = fs::remove_dir_all(&path);
    fs::create_dir_all(&path).expect("a folder");
    path
}

fn run(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_shading-lab"));
    let command = command.current_dir(folder).env("LANG", "C");
    command.args(arguments).output().expect("a run")
}

const STUDENTS: usize = 200;

/// Returns which of the four questions a student answers correctly.
fn knows(student: usize) -> [bool; 4] {
    [0, 1, 2, 3].map(|question| student.is_multiple_of(question + 2))
}

fn work(student: usize) -> Record {
    let [value, choice, curve, place] = knows(student);
    let mut record = record(if value { 0.52 } else { 0.7 }, usize::from(choice));
    let right = |x: f64| (x * 90.0).to_radians().cos().powi(2);
    let curve = (0..CURVE_POINTS).map(|index| {
        let x = index as f64 / (CURVE_POINTS - 1) as f64;
        Some(if curve { right(x) + 0.02 } else { x })
    });
    record.put(answered(2, Answer::Curve(curve.collect())));
    if student != 7 {
        let at = if place { [0.01, -0.01] } else { [0.2, 0.1] };
        record.put(answered(3, Answer::Point(at)));
    }
    record
}

fn name(student: usize) -> String {
    match student {
        0 => "=HYPERLINK(\"http://x\")".to_owned(),
        1 => "<script>alert(1)</script>".to_owned(),
        2 => "\u{1b}[2JEve".to_owned(),
        3 => String::new(),
        4 => "王小明, \"Ming\"".to_owned(),
        _ => format!("Student {student}"),
    }
}

/// Returns twenty files that do not count.
fn spoiled(sound: &[u8]) -> Vec<Vec<u8>> {
    let mut spoiled: Vec<Vec<u8>> = (1..9)
        .map(|part| sound[..sound.len() * part / 20].to_vec())
        .collect();
    spoiled.push(Vec::new());
    spoiled.push(b"no picture".to_vec());
    // A header that claims gigabytes, with a matching checksum.
    let mut huge = sound.to_vec();
    huge[16..24].copy_from_slice(&[0, 0, 0xff, 0xff, 0, 0, 0xff, 0xff]);
    let sum = checksum(&huge[12..29]);
    huge[29..33].copy_from_slice(&sum.to_be_bytes());
    let texts = [(ANSWERS_KEYWORD, 1 << 20), (SCENE_KEYWORD, 1 << 20)];
    let [answers, scene] = read_texts(Cursor::new(sound), texts).expect("texts");
    let (answers, scene) = (answers.expect("answers"), scene.expect("a scene"));
    let cut = huge
        .windows(4)
        .position(|word| word == b"iTXt")
        .expect("a text");
    spoiled.push(huge[..cut - 4].to_vec());
    let forged = |answers: &str| {
        let mut bytes = Vec::new();
        let texts = [(ANSWERS_KEYWORD, answers), (SCENE_KEYWORD, &*scene)];
        write_png(&mut bytes, &picture(), None, &texts).expect("a picture");
        bytes
    };
    for (from, to) in [
        ("\"given\":0.7", "\"given\":0.5"),
        ("\"given\":0,", "\"given\":1,"),
        ("\"tries\":2", "\"tries\":1"),
        ("own-lesson", "lambert"),
        ("\"version\":1", "\"version\":2"),
        ("{", "["),
    ] {
        assert!(answers.contains(from), "{from}");
        spoiled.push(forged(&answers.replace(from, to)));
    }
    spoiled.push(forged(""));
    spoiled.push(forged(&" ".repeat(9 << 20)));
    let mut plain = Vec::new();
    write_png(&mut plain, &picture(), Some(&Scene::default()), &[]).expect("a picture");
    spoiled.push(plain);
    assert_eq!(spoiled.len(), 20);
    spoiled
}

/// Returns the FNV-1a hash of texts with their lengths, as in hand-ins.
fn digest(texts: &[&str]) -> String {
    let lengths = |text: &&str| [text.as_bytes(), &(text.len() as u64).to_le_bytes()].concat();
    let hash = texts
        .iter()
        .flat_map(lengths)
        .fold(0xcbf2_9ce4_8422_2325u64, |hash, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
        });
    format!("{hash:016x}")
}

/// Returns a hand-in whose lesson is replaced, with matching digests.
fn forged(sound: &[u8], from: &str, to: &str) -> Vec<u8> {
    resealed(sound, |all| {
        let source = all["source"].as_str().expect("a lesson").replace(from, to);
        all["lesson_digest"] = json!(digest(&[&source]));
        all["source"] = json!(source);
    })
}

/// Returns a hand-in that is changed, with a matching digest.
fn resealed(sound: &[u8], change: impl FnOnce(&mut Value)) -> Vec<u8> {
    let texts = [(ANSWERS_KEYWORD, 1 << 20), (SCENE_KEYWORD, 1 << 20)];
    let [answers, scene] = read_texts(Cursor::new(sound), texts).expect("texts");
    let scene = scene.expect("a scene");
    let mut all: Value = serde_json::from_str(&answers.expect("answers")).expect("JSON");
    change(&mut all);
    let object = all.as_object_mut().expect("an object");
    object.retain(|key, _| key != "version" && key != "digest");
    let rest = format!(",{}", &all.to_string()[1..]);
    let seal = digest(&[&rest, &scene]);
    let answers = format!("{{\"version\":1,\"digest\":\"{seal}\"{rest}");
    let mut bytes = Vec::new();
    let texts = [(ANSWERS_KEYWORD, &*answers), (SCENE_KEYWORD, &*scene)];
    write_png(&mut bytes, &picture(), None, &texts).expect("a picture");
    bytes
}

/// Returns the CRC-32 as PNG defines it.
fn checksum(bytes: &[u8]) -> u32 {
    let step = |sum: u32, byte: &u8| {
        (0..8).fold(sum ^ u32::from(*byte), |sum, _| {
            (sum >> 1) ^ (0xedb8_8320 * (sum & 1))
        })
    };
    !bytes.iter().fold(!0, step)
}

#[test]
fn a_class_is_graded_and_nothing_stops_at_a_bad_file() {
    let folder = folder("class");
    let mut files = Vec::new();
    for student in 0..STUDENTS {
        let file = format!("{student:03}.png");
        fs::write(
            folder.join(&file),
            handed_in(&work(student), &name(student)),
        )
        .expect("a file");
        files.push(file);
    }
    let spoiled = spoiled(&handed_in(&work(1), "Mallory"));
    for (index, bytes) in spoiled.iter().enumerate() {
        let file = format!("bad-{index:02}.png");
        fs::write(folder.join(&file), bytes).expect("a file");
        // Among the others, so that it could stop the run.
        files.insert(10 * index, file);
    }
    let mut arguments = vec![
        "collect",
        "--json",
        "--csv",
        "class.csv",
        "-o",
        "class.html",
    ];
    arguments.extend(files.iter().map(String::as_str));
    let output = run(&folder, &arguments);
    let errors = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{errors}");
    assert_eq!(errors.lines().count(), 20, "{errors}");
    for line in errors.lines() {
        assert!(line.contains("bad-"), "{line}");
    }

    let object: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let unreadable = object["unreadable"].as_array().expect("a list");
    assert_eq!(unreadable.len(), 20);
    assert!(
        unreadable
            .iter()
            .all(|file| !file["why"].as_str().expect("why").is_empty())
    );
    let rows = object["rows"].as_array().expect("a list");
    assert_eq!(rows.len(), STUDENTS);
    for (student, row) in rows.iter().enumerate() {
        assert_eq!(row["file"], format!("{student:03}.png"));
        assert_eq!(row["lesson"], "own-lesson");
        for (question, knows) in knows(student).into_iter().enumerate() {
            let answer = &row["answers"][question];
            let answered = student != 7 || question != 3;
            assert_eq!(answer["question"], question + 1);
            assert_eq!(
                answer["kind"],
                ["value", "choice", "curve", "point"][question]
            );
            assert_eq!(answer["right"], knows && answered, "{student} {question}");
            assert_eq!(answer["given"].is_null(), !answered);
            // Wrong answers to the first two questions are those of their wrong models, each the first one.
            let model = (question < 2 && !knows).then_some(0);
            assert_eq!(answer["model"], json!(model), "{student} {question}");
            assert_eq!(answer["prediction_model"], answer["model"]);
        }
    }
    let [value, choice] = [0, 1].map(|question| &object["questions"][question]["models"]);
    let ignorant = (0..STUDENTS).filter(|student| !knows(*student)[0]).count();
    let share = ignorant as f64 / STUDENTS as f64;
    let row = json!({ "model": 0, "says": "That is the cosine of <45°>.", "count": ignorant, "share": share });
    assert_eq!(value, &json!([row]));
    assert_eq!(
        choice.as_array().map(Vec::len),
        Some(1),
        "the right option is no model"
    );

    let table = fs::read_to_string(folder.join("class.csv")).expect("a table");
    let mut rows = csv::Reader::from_reader(table.as_bytes());
    let rows: Vec<_> = rows.records().map(|row| row.expect("a row")).collect();
    assert_eq!(rows.len(), STUDENTS);
    assert_eq!(&rows[0][1], "'=HYPERLINK(\"http://x\")");
    assert_eq!(&rows[4][1], "王小明, \"Ming\"");
    assert_eq!((&rows[0][3], &rows[0][4], &rows[0][6]), ("4", "4", "0.52"));
    assert!(!table.contains('\u{1b}'));

    let page = fs::read_to_string(folder.join("class.html")).expect("a page");
    assert!(page.contains("&lt;script&gt;alert(1)") && !page.contains("<script"));
    assert_eq!(page.matches(" opacity=\"0.55\"").count(), STUDENTS);
    assert_eq!(
        page.matches("That is the cosine of &lt;45°&gt;.").count(),
        1
    );
    assert!(page.contains(english!("class-models")));
    assert!(page.contains("data:image/png;base64,") && !page.contains("http://x\">"));
}

#[test]
fn the_table_says_who_is_right() {
    let folder = folder("table");
    for student in [0, 1, 4] {
        let bytes = handed_in(&work(student), &name(student));
        fs::write(folder.join(format!("{student}.png")), bytes).expect("a file");
    }
    fs::write(
        folder.join("own.md"),
        LESSON.replace("answer = \"cos(60)\"", "answer = \"0.7\""),
    )
    .expect("a file");
    fs::write(
        folder.join("other.md"),
        LESSON.replace("own-lesson", "other"),
    )
    .expect("a file");
    let files = ["0.png", "1.png", "4.png"];
    let output = run(&folder, &[&["collect"], &files[..]].concat());
    let table = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    assert!(
        table.contains("1× (33 %) That is the cosine of <45°>."),
        "{table}"
    );
    let title = english!("class-title", title = "A lecturer's own", students = 3);
    assert!(table.contains(&title), "{table}");
    assert!(
        table.contains("0.52 ✓") && table.contains("0.7 ✗") && table.contains("67 %"),
        "{table}"
    );

    // The lecturer's own text takes precedence over the picture's.
    let own = run(
        &folder,
        &[&["collect", "--lesson", "own.md"], &files[..]].concat(),
    );
    let table = String::from_utf8_lossy(&own.stdout).into_owned();
    assert!(
        table.contains("0.52 ✗") && table.contains("0.7 ✓"),
        "{table}"
    );
    let other = run(
        &folder,
        &[&["collect", "--lesson", "other.md"], &files[..]].concat(),
    );
    assert_eq!(other.status.code(), Some(2));
    assert_eq!(String::from_utf8_lossy(&other.stderr).lines().count(), 3);
}

#[test]
fn what_is_wrong_with_a_lesson_inside_is_told_with_the_picture() {
    let folder = folder("lesson-inside");
    let hand_in = |name: &str, source: String, student: &str| {
        let lesson = Lesson { source, ..lesson() };
        let bytes = hand_in_bytes(
            &picture(),
            &Scene::default(),
            &lesson,
            &record(0.5, 1),
            student,
        );
        fs::write(folder.join(name), bytes.expect("a picture")).expect("a file");
    };
    let twice = LESSON.replace("tolerance = 0.05", "tolerance = 0");
    hand_in(
        "two.png",
        twice.replace("find = \"greatest\"", "find = \"best\""),
        "Ada",
    );
    hand_in("none.png", LESSON.replace("cos(60)", "cos(x)"), "Ben");
    let settings = "set = [\"material.n=-1\", \"material.ka=x\"]\nprobe = [";
    hand_in("set.png", LESSON.replace("probe = [", settings), "Cleo");
    let output = run(&folder, &["collect", "two.png", "none.png", "set.png"]);
    let errors = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{errors}");
    let inside = |picture: &str| {
        let bad = english!("class-bad-lesson", error = "");
        let start = format!("{picture}: {bad}");
        errors.lines().filter(|line| line.contains(&start)).count()
    };
    assert!(
        inside("two.png") == 2 && inside("none.png") >= 1,
        "{errors}"
    );
    assert!(inside("set.png") >= 2, "{errors}");
    let told = inside("two.png") + inside("none.png") + inside("set.png");
    assert_eq!(told, errors.lines().count(), "{errors}");
    // A lesson of one's own is identified by its path.
    fs::write(folder.join("own.md"), LESSON.replace("cos(60)", "cos(x)")).expect("a file");
    let output = run(&folder, &["collect", "--lesson", "own.md", "none.png"]);
    let errors = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(errors.contains("own.md:"), "{errors}");
}

#[test]
fn a_spreadsheet_takes_no_name_for_a_formula() {
    let folder = folder("formulas");
    let names = [
        "Ada;=1+1",
        "＝1+1",
        "\u{200b}=1+1",
        "\u{feff}@SUM(A1)",
        "-0.5",
        "Eve",
    ];
    let files: Vec<String> = (0..names.len()).map(|i| format!("a;+{i}.png")).collect();
    for (file, name) in files.iter().zip(names) {
        fs::write(folder.join(file), handed_in(&record(0.5, 1), name)).expect("a file");
    }
    let mut arguments = vec!["collect", "--csv", "class.csv"];
    arguments.extend(files.iter().map(String::as_str));
    let output = run(&folder, &arguments);
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    let table = fs::read_to_string(folder.join("class.csv")).expect("a table");
    let rows: Vec<&str> = table.lines().skip(1).collect();
    for (row, expected) in rows.iter().zip([
        "\"a;'+0.png\",\"Ada;'=1+1\",own-lesson,2,4,0.500,0.5,1,,0.5,1,,2,1,3.5,B,1,,B,1,,2,1,3.5,,0,,,0,,,,,,0,,,0,,,,",
        "\"a;'+1.png\",'＝1+1,own-lesson,",
        "\"a;'+2.png\",'\u{200b}=1+1,own-lesson,",
        "\"a;'+3.png\",'\u{feff}@SUM(A1),own-lesson,",
        "\"a;'+4.png\",-0.5,own-lesson,",
        "\"a;'+5.png\",Eve,own-lesson,",
    ]) {
        assert!(row.starts_with(expected), "{row}");
    }
}
