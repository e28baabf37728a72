//! The concept inventory: two forms with the same concepts and other answers, and a class that takes both.

use crate::common::dice::Dice;
use serde_json::Value;
use shading_lab::lesson::{
    Answer, AnswerKey, Answered, ChoiceOption, Grade, Kind, Lab, LabPlace, Lesson, Question,
    Record, RightIf, Step, TestStatistics, find, hand_in_bytes, normalised_gain,
};
use shading_lab::render::Frame;
use shading_lab::scene::Scene;
use shading_lab::text::{Language, fixed};
use std::fs;
use std::path::Path;
use std::process::Command;

const FORMS: [&str; 2] = ["inventory-a", "inventory-b"];
const ITEMS: usize = 24;

fn form(name: &str, language: Language) -> Lesson {
    find(name).expect("a form").lesson_in(language)
}

fn question(step: &Step) -> &Question {
    step.question.as_ref().expect("a question")
}

/// Solves an item.
fn with_key<T>(step: &Step, look: impl FnOnce(&AnswerKey, LabPlace<'_>) -> T) -> T {
    let staged = step.stage.load(None).expect("a scene");
    let lab = Lab::new(&staged);
    let place = lab.place(&staged);
    let key = question(step).solve_all(place, 1).expect("an answer");
    look(&key, place)
}

#[test]
fn both_forms_ask_for_the_same_concepts_and_teach_nothing_on_the_way() {
    for language in Language::ALL {
        assert!(!form("diffuse", language).test);
        let [a, b] = FORMS.map(|name| form(name, language));
        assert_eq!([a.steps.len(), b.steps.len()], [ITEMS; 2]);
        for (one, other) in a.steps.iter().zip(&b.steps) {
            assert_eq!(one.title, other.title);
            let [kind, like] = [one, other].map(|step| question(step).kind.name());
            assert_eq!(kind, like, "{}", one.title);
        }
        for lesson in [&a, &b] {
            assert!(lesson.test && lesson.minutes == 25 && lesson.topic == "test");
            for step in &lesson.steps {
                let (asked, name) = (question(step), format!("{}: {}", lesson.name, step.title));
                assert!(asked.why.is_empty() && step.after.is_empty(), "{name}");
                assert!(
                    step.stage.hide && step.stage.controls.is_empty() && step.stage.view.is_none(),
                    "{name}"
                );
                assert!(
                    step.stage.panes.as_ref().is_none_or(Vec::is_empty),
                    "{name}"
                );
                // The engine decides which option is right.
                if let Kind::Choice(choice) = &asked.kind {
                    let said =
                        |option: &ChoiceOption| matches!(option.right, Some(RightIf::Said(_)));
                    assert!(!choice.options.iter().any(said), "{name}");
                    assert!(choice.options.len() >= 3, "{name}");
                }
            }
        }
    }
}

#[test]
fn the_table_says_which_lesson_teaches_which_item() {
    let table = include_str!("../../docs/course.md");
    let (_, table) = table
        .split_once("## The concept inventory")
        .expect("a table");
    let form = form(FORMS[0], Language::English);
    let rows = table
        .lines()
        .filter(|line| line.starts_with("| ") && !line.starts_with("| item"));
    let rows: Vec<Vec<&str>> = rows
        .map(|row| row.trim_matches('|').split('|').map(str::trim).collect())
        .collect();
    assert_eq!(rows.len(), ITEMS);
    for (index, (row, step)) in rows.iter().zip(&form.steps).enumerate() {
        assert_eq!((row[0], row[1]), (&*(index + 1).to_string(), &*step.title));
        let name = row[3]
            .trim_start_matches('[')
            .split(']')
            .next()
            .expect("a name");
        let count = find(name)
            .expect(name)
            .lesson_in(Language::English)
            .steps
            .len();
        let steps = row[4]
            .split([',', '–'])
            .map(|step| step.trim().parse::<usize>());
        assert!(
            steps.flatten().all(|step| (1..=count).contains(&step)),
            "{row:?}"
        );
    }
}

#[test]
fn who_remembers_the_answers_of_form_a_has_none_of_form_b_right() {
    let [a, b] = FORMS.map(|name| form(name, Language::English));
    for (one, other) in a.steps.iter().zip(&b.steps) {
        let remembered = with_key(one, |key, _| Answer::right(&key.right));
        with_key(other, |key, place| {
            let grade = question(other).grade(&remembered, key, place);
            assert!(
                grade.is_none_or(|grade| !grade.right),
                "{}: {remembered:?}",
                one.title
            );
        });
    }
}

#[test]
fn no_option_stands_out_by_its_place() {
    for name in FORMS {
        let mut places = [0; 4];
        for step in &form(name, Language::English).steps {
            if matches!(question(step).kind, Kind::Choice(_)) {
                with_key(step, |key, _| match Answer::right(&key.right) {
                    Answer::Choice(right) => places[right] += 1,
                    other => panic!("{other:?}"),
                });
            }
        }
        assert!(
            places.iter().all(|count| (1..=6).contains(count)),
            "{name}: {places:?}"
        );
    }
}

/// Returns the right answers to a form, and for each item the answer of one of its wrong models.
fn answers(lesson: &Lesson) -> Vec<[Answer; 2]> {
    let of_step = |step: &Step| {
        with_key(step, |key, _| {
            let right = Answer::right(&key.right);
            let wrong = match (&right, key.wrong.first()) {
                (Answer::Choice(right), _) => Answer::Choice(usize::from(*right == 0)),
                (_, Some(wrong)) => Answer::right(wrong),
                (other, None) => panic!("{other:?} has no wrong model"),
            };
            [wrong, right]
        })
    };
    lesson.steps.iter().map(of_step).collect()
}

/// Students know a concept the more likely, the stronger they are; after the course they know more.
fn knowledge(after: bool) -> Vec<Vec<bool>> {
    let mut dice = Dice(17 + u64::from(after));
    let student = |strength: usize| {
        let share = if after { 0.5 } else { 0.1 } + 0.04 * strength as f64;
        (0..ITEMS).map(|_| dice.unit() < share).collect()
    };
    (0..12).map(student).collect()
}

#[test]
fn a_class_that_takes_form_a_and_then_form_b_is_compared_item_by_item() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("inventory-class");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder");
    let picture = Frame {
        width: 8,
        height: 8,
        pixels: vec![[10, 20, 30, 255]; 64],
    };
    let mut arguments = vec!["collect".to_owned()];
    for (after, name) in [false, true].into_iter().zip(FORMS) {
        // The languages may differ.
        let lessons = Language::ALL.map(|language| form(name, language));
        let answers = answers(&lessons[0]);
        arguments.push(if after { "--post" } else { "--pre" }.to_owned());
        for (student, knows) in knowledge(after).iter().enumerate() {
            let mut record = Record::new(name, 1);
            for (step, (known, answers)) in knows.iter().zip(&answers).enumerate() {
                let answer = &answers[usize::from(*known)];
                record.put(Answered {
                    step,
                    prediction: answer.clone(),
                    answer: answer.clone(),
                    grade: Grade::default(),
                    looked_up: 0,
                    tries: 1,
                    seconds: 40.0,
                });
            }
            let lesson = &lessons[student % 2];
            let bytes = hand_in_bytes(&picture, &Scene::default(), lesson, &record, "");
            let file = format!("{name}-{student}.png");
            fs::write(folder.join(&file), bytes.expect("a picture")).expect("a file");
            arguments.push(file);
        }
    }
    let run = |more: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_shading-lab"));
        let command = command.current_dir(&folder).env("LANG", "C");
        let output = command.args(&arguments).args(more).output().expect("a run");
        let errors = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{errors}");
        String::from_utf8(output.stdout).expect("text")
    };
    let object: Value = serde_json::from_str(&run(&["--json"])).expect("JSON");
    let [pre, post] = [false, true].map(|after| TestStatistics::of(&knowledge(after)));
    for (test, expected) in [("pre", &pre), ("post", &post)] {
        let found = &object[test];
        assert_eq!(found["students"], expected.students);
        assert_eq!(found["kr20"].as_f64(), expected.kr20);
        let items = found["items"].as_array().expect("items");
        assert_eq!(items.len(), ITEMS);
        for (item, expected) in items.iter().zip(&expected.items) {
            assert_eq!(item["difficulty"].as_f64(), Some(expected.difficulty));
            assert_eq!(item["discrimination"].as_f64(), expected.discrimination);
        }
        assert_eq!(items[0]["title"], "Ambient light");
    }
    let gain = normalised_gain(pre.mean, post.mean).expect("a gain");
    assert_eq!(object["gain"].as_f64(), Some(gain));
    assert!(gain > 0.2 && pre.kr20 > Some(0.5), "{gain}, {:?}", pre.kr20);
    let words = run(&[]);
    let class = english!("inventory-class-gain", gain = fixed(gain, 2));
    assert!(
        words.contains(&class) && words.contains("The exponent n"),
        "{words}"
    );
}
