//! Answers handed in as a picture: they come back as they were given, and what was changed, damaged or forged is noticed.

use shading_lab::lesson::{
    ANSWERS_KEYWORD, Answer, Answered, Grade, HandInError, Lesson, Record, hand_in_bytes,
    read_hand_in,
};
use shading_lab::picture::{SCENE_KEYWORD, read_scene_text, read_texts, write_png};
use shading_lab::render::Frame;
use shading_lab::scene::Scene;
use std::io::Cursor;

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
```

## One option

```question
kind = "choice"
ask = "Which is greater?"
[[option]]
text = "One"
right = false
[[option]]
text = "Two"
right = true
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
    // What fits no question does not go out.
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
