//! What is written of a class, and read again.

use super::{Class, lesson};
use crate::common::program::Folder;
use proptest::prelude::*;
use serde_json::json;
use shading_lab::class::{AnswerRequest, Command, Room, open_record};
use shading_lab::lesson::{Answer, ClassRecord, MAX_ROUNDS};
use std::collections::BTreeMap;
use std::fs::{self, OpenOptions};
use std::io::Write;

/// A message of a student: an answer to the open question, by the phone's clock.
#[derive(Clone, Debug)]
struct Message {
    student: usize,
    option: usize,
    sent: u64,
}

fn messages() -> impl Strategy<Value = Vec<Message>> {
    let one = (0usize..4, 0usize..2).prop_map(|(student, option)| (student, option));
    proptest::collection::vec(one, 1..12).prop_map(|all| {
        let message = |(index, (student, option)): (usize, (usize, usize))| Message {
            student,
            option,
            sent: 1000 + index as u64,
        };
        all.into_iter().enumerate().map(message).collect()
    })
}

/// Returns the indices of `messages` in the order in which they arrive: each once at least, some twice.
fn arrivals() -> impl Strategy<Value = (Vec<Message>, Vec<usize>)> {
    messages().prop_flat_map(|messages| {
        let count = messages.len();
        let again = proptest::collection::vec(0..count, 0..6);
        let order = again.prop_map(move |again| (0..count).chain(again).collect::<Vec<_>>());
        (Just(messages), order.prop_shuffle())
    })
}

/// Plays messages to a class in an order, and returns who has which answer in the record.
fn played(name: &str, messages: &[Message], order: &[usize]) -> BTreeMap<String, Answer> {
    let folder = Folder::new(name);
    let path = folder.0.join("class.jsonl");
    let (recorder, record) = open_record(&path, &lesson(), 1).expect("a record");
    let room = Room::open(lesson(), recorder, record);
    let names = ["Ada", "Ben", "Cleo", "Dan"];
    let tokens = names.map(|name| room.join(None, Some(name)).expect("a seat"));
    let request = |message: &Message| AnswerRequest {
        step: 1,
        round: 1,
        answer: Answer::Choice(message.option),
        sent: message.sent,
    };
    let mut commits = Vec::new();
    for index in order {
        let message = &messages[*index];
        let commit = room.answer(tokens[message.student], request(message));
        commits.push(commit.expect("it is open"));
    }
    for commit in commits {
        commit
            .blocking_recv()
            .expect("a writer")
            .expect("it is saved");
    }
    // What arrives too late is refused and changes nothing.
    assert!(room.perform(Command::ShowAnswers));
    for message in messages {
        assert!(
            room.answer(tokens[message.student], request(message))
                .is_err()
        );
    }
    let record = ClassRecord::read(&fs::read(&path).expect("a file")).expect("a record");
    let students = record.students.into_iter();
    students
        .map(|student| (student.name, student.answers[&(1, 1)].answer.clone()))
        .collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 40, ..crate::common::properties::config(file!()) })]

    #[test]
    fn lost_doubled_and_late_messages_leave_the_same_record((messages, order) in arrivals()) {
        let in_order: Vec<usize> = (0..messages.len()).collect();
        let expected = played("class-in-order", &messages, &in_order);
        let names = ["Ada", "Ben", "Cleo", "Dan"];
        let mut last = BTreeMap::new();
        for message in &messages {
            last.insert(names[message.student].to_owned(), Answer::Choice(message.option));
        }
        prop_assert_eq!(&expected, &last);
        prop_assert_eq!(played("class-any-order", &messages, &order), expected);
    }

    #[test]
    fn a_record_cut_anywhere_is_read_up_to_its_last_whole_line(cut in 0.0..1.0f64) {
        let whole = [
            r#"{"line":"student","student":1,"token":"00000000000000000000000000000001","name":"王"}"#,
            r#"{"line":"answer","student":1,"step":1,"round":1,"answer":{"choice":0},"sent":5,"seconds":2.5}"#,
            r#"{"line":"pace","step":2,"phase":"ask","round":1}"#,
            r#"{"line":"answer","student":2,"step":3,"round":1,"answer":{"value":0.5}}"#,
        ];
        let folder = Folder::new("class-cut");
        let path = folder.0.join("class.jsonl");
        drop(open_record(&path, &lesson(), 1).expect("a record"));
        let head = fs::read(&path).expect("a file").len();
        let mut file = OpenOptions::new().append(true).open(&path).expect("a file");
        for line in whole {
            writeln!(file, "{line}").expect("a line");
        }
        let bytes = fs::read(&path).expect("a file");
        let length = head + ((bytes.len() - head) as f64 * cut) as usize;
        fs::write(&path, &bytes[..length]).expect("a file");
        let (recorder, record) = open_record(&path, &lesson(), 1).expect("what is whole is read");
        let lines = bytes[head..length].iter().filter(|byte| **byte == b'\n').count();
        let answers: usize = record.students.iter().map(|student| student.answers.len()).sum();
        prop_assert_eq!(answers, [0, 0, 1, 1, 2][lines]);
        prop_assert_eq!(record.paces.len(), usize::from(lines >= 3));
        drop(recorder);
        // What was not whole is gone from the file too.
        let left = fs::read(&path).expect("a file");
        prop_assert!(left.ends_with(b"\n") && bytes.starts_with(&left));
    }
}

#[test]
fn a_line_that_is_wrong_is_named() {
    let class = Class::new("wrong-line");
    let good = fs::read(class.record()).expect("a record");
    let path = class.record();
    drop(class.live);
    let lines = [
        r#"{"line":"answer","student":1}"#,
        r#"{"line":"answer","student":0,"step":1,"round":1,"answer":{"choice":0}}"#,
        r#"{"line":"answer","student":4000000000,"step":1,"round":1,"answer":{"choice":0}}"#,
        r#"{"line":"answer","student":1,"step":0,"round":1,"answer":{"choice":0}}"#,
        r#"{"line":"answer","student":1,"step":1,"round":1000,"answer":{"choice":0}}"#,
        r#"{"line":"grade","student":1}"#,
        "\u{0}",
    ];
    const { assert!(MAX_ROUNDS < 1000) };
    for line in lines {
        let bytes = [&good[..], line.as_bytes(), b"\n"].concat();
        fs::write(&path, &bytes).expect("a file");
        let refused = open_record(&path, &lesson(), 1).expect_err(line);
        assert!(
            refused.contains("line 2: ") && refused.contains("--output"),
            "{refused}"
        );
        assert_eq!(
            fs::read(&path).expect("a file"),
            bytes,
            "the file is left alone"
        );
    }
    // Another file's content is left alone too.
    for other in [
        "no record\n",
        "{\"line\":\"pace\"}\n",
        "\n",
        "text without an end",
    ] {
        fs::write(&path, other).expect("a file");
        assert!(open_record(&path, &lesson(), 1).is_err(), "{other}");
        assert_eq!(fs::read_to_string(&path).expect("a file"), other);
    }
    // A beginning that was cut is begun again.
    fs::write(&path, &good[..good.len() / 2]).expect("a file");
    assert!(open_record(&path, &lesson(), 1).is_ok());
}

#[test]
fn only_the_owner_may_read_a_record() {
    let class = Class::new("owner");
    let mut phone = class.joined();
    let answer = json!({ "choice": 0 });
    assert_eq!(phone.answer(1, 1, &answer).status, 200);
    let record = fs::read_to_string(class.record()).expect("a record");
    // The secret by which a student is known stands in it.
    assert!(record.contains(phone.token.as_deref().expect("a token")));
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        let mode = fs::metadata(class.record())
            .expect("a file")
            .permissions()
            .mode();
        assert_eq!(mode & 0o777, 0o600);
    }
}
