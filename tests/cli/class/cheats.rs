//! What curious students try.

use super::client::{Phone, connect};
use super::{Class, wait_until};
use crate::common::program::Folder;
use serde_json::{Value, json};
use shading_lab::class::Command;
use shading_lab::lesson::ClassRecord;
use std::fs;
use std::io::{Read, Write};
use std::time::{Duration, Instant};

fn choice(option: usize) -> Value {
    json!({ "choice": option })
}

#[test]
fn nobody_reads_the_answer_of_another() {
    let class = Class::new("read");
    let [mut ada, mut ben] = [class.joined(), class.joined()];
    assert_eq!(ada.answer(1, 1, &choice(0)).status, 200);
    assert_eq!(
        ben.events().expect("events").pace().expect("a pace")["answered"],
        Value::Null
    );
    // There is no way to ask for answers, in whatever phase.
    for command in [None, Some(Command::ShowAnswers), Some(Command::Explain)] {
        command.map(|command| class.live.room().perform(command));
        for path in [
            "answers",
            "answers/1",
            "students",
            "spread",
            "class.jsonl",
            "steps/1/answers",
            "steps/1/spread",
        ] {
            assert!(matches!(ben.get(path).status, 404 | 405), "{path}");
        }
    }
}

#[test]
fn nobody_answers_for_another() {
    let class = Class::new("another");
    let [mut ada, mut ben] = [class.joined(), class.joined()];
    assert_eq!(ada.answer(1, 1, &choice(0)).status, 200);
    // The number of another student, a name, or a token in the body is refused; so are guessed tokens.
    for extra in ["student", "token", "name"] {
        let mut body = json!({ "step": 1, "round": 1, "answer": choice(1) });
        body[extra] = json!(1);
        assert_eq!(ben.post("answers", &body).status, 400, "{extra}");
    }
    let guesses = [
        "",
        "0",
        "00000000000000000000000000000001",
        "../ada",
        "' or 1=1",
    ];
    for guess in guesses {
        let mut nobody = class.phone();
        nobody.token = Some(guess.to_owned());
        assert_eq!(nobody.answer(1, 1, &choice(1)).status, 401, "{guess}");
        assert!(nobody.events().is_err());
        assert_eq!(nobody.get("steps/1").status, 401);
        // Who joins with a made-up token gets one of the system's.
        nobody.join(None);
        assert_ne!(nobody.token.as_deref(), Some(guess));
    }
    assert_eq!(
        ada.events().expect("events").pace().expect("a pace")["answered"],
        choice(0)
    );
}

#[test]
fn nobody_answers_twice() {
    let class = Class::new("twice");
    let mut phone = class.joined();
    for _ in 0..3 {
        assert_eq!(phone.answer(1, 1, &choice(1)).status, 200);
    }
    assert_eq!(class.live.room().snapshot().answered, 1);
    class.live.room().perform(Command::ShowAnswers);
    assert_eq!(phone.answer(1, 1, &choice(0)).status, 409);
    let record = ClassRecord::read(&fs::read(class.record()).expect("a record")).expect("a record");
    let answers: Vec<usize> = record
        .students
        .iter()
        .map(|student| student.answers.len())
        .collect();
    assert_eq!(answers, [1]);
}

#[test]
fn nobody_moves_the_lecturers_step() {
    let class = Class::new("step");
    let mut phone = class.joined();
    let before = class.live.room().pace();
    for path in [
        "next",
        "pace",
        "step",
        "steps",
        "steps/2",
        "events",
        "join/next",
        "command",
        "",
    ] {
        for method in ["POST", "PUT", "PATCH", "DELETE"] {
            let body = json!({ "step": 2, "phase": "explain", "command": "next", "event": "pace" });
            let reply = phone.request(method, path, &[], body.to_string().as_bytes());
            assert_eq!(reply.expect("an answer").status, 404, "{method} {path}");
        }
    }
    assert_eq!(phone.answer(2, 1, &choice(0)).status, 409);
    assert_eq!(phone.answer(1, 2, &choice(0)).status, 409);
    assert_eq!(class.live.room().pace(), before);
}

#[test]
fn nothing_that_the_lecturer_has_not_shown_is_given_out() {
    let class = Class::new("ahead");
    let mut phone = class.joined();
    let steps = class.live.room().lesson().steps.len();
    for step in 2..=steps {
        assert_eq!(phone.get(&format!("steps/{step}")).status, 403);
        assert_eq!(phone.get(&format!("steps/{step}/1.png")).status, 403);
        std::thread::sleep(Duration::from_millis(110));
    }
    assert_eq!(phone.get("steps/1/explanation").status, 403);
    for step in [
        "0",
        "-1",
        "1e3",
        "99",
        "999999999999999999999",
        "1.0",
        "%31%30%30",
    ] {
        assert_eq!(phone.get(&format!("steps/{step}")).status, 404, "{step}");
        std::thread::sleep(Duration::from_millis(110));
    }
}

#[test]
fn no_file_but_the_pages_is_given_out() {
    let folder = Folder::new("class-traversal");
    fs::create_dir_all(folder.0.join("page/inner")).expect("a folder");
    folder.write("secret.txt", "secret");
    folder.write("page/index.html", "<p>lab</p>");
    folder.write("page/lab.wasm", "wasm");
    folder.write("page/inner/a.js", "1");
    #[cfg(unix)]
    std::os::unix::fs::symlink("../secret.txt", folder.0.join("page/link.txt")).expect("a link");
    let page = folder.0.join("page");
    let class = Class::within(folder, Some(page));
    let mut phone = class.joined();
    assert_eq!(phone.get("lab/").text(), "<p>lab</p>");
    assert_eq!(phone.get("lab/inner/a.js?7").text(), "1");
    let targets = [
        "lab/../class.jsonl",
        "lab/..%2fsecret.txt",
        "lab/%2e%2e/secret.txt",
        "lab/../secret.txt",
        "lab/inner/../../secret.txt",
        "lab//etc/passwd",
        "lab/%2fetc/passwd",
        "lab/link.txt",
        "lab/..\\secret.txt",
        "../secret.txt",
        "..%2f..%2fetc%2fpasswd",
        "class.jsonl",
        "lab/index.html%00.txt",
        "lab/inner",
        "lab/inner/",
        "/etc/passwd",
        "lab/page/index.html",
        "class.js/../../secret.txt",
    ];
    for target in targets {
        let reply = phone.get(target);
        assert!(matches!(reply.status, 400 | 404), "{target}: {reply:?}");
        assert!(
            !reply.text().contains("secret") && !reply.text().contains("root:"),
            "{target}"
        );
    }
    // Without the class's code there is nothing at all.
    for target in [
        "/",
        "/secret.txt",
        "/class.js",
        "/aaaaaa/",
        "/../",
        "*",
        "http://class/",
    ] {
        let reply = phone.send("GET", target, &[], b"").expect("an answer");
        assert!(
            matches!(reply.status, 400 | 404),
            "{target}: {}",
            reply.status
        );
    }
}

#[test]
fn what_is_too_large_is_refused() {
    let class = Class::new("large");
    let mut phone = class.joined();
    let long = json!({ "step": 1, "round": 1, "answer": { "curve": vec![1.0; 40_000] } });
    assert_eq!(phone.post("answers", &long).status, 413);
    // Also where the length is not told before.
    let mut stream = connect(phone.address).expect("a connection");
    let token = phone.token.as_deref().unwrap_or_default();
    let head = format!(
        "POST {}/answers HTTP/1.1\r\nHost: class\r\nCookie: token={token}\r\nTransfer-Encoding: chunked\r\n\r\n",
        phone.base
    );
    stream.get_mut().write_all(head.as_bytes()).expect("a head");
    let chunk = format!("4000\r\n{}\r\n", " ".repeat(0x4000));
    for _ in 0..8 {
        // The server may have answered and closed already.
        let _ = stream.get_mut().write_all(chunk.as_bytes());
    }
    let mut answer = String::new();
    let _ = stream.read_to_string(&mut answer);
    assert!(answer.starts_with("HTTP/1.1 413 "), "{answer}");
    let mut other = class.joined();
    let head = other.request("GET", &format!("steps/1?{}", "x".repeat(40_000)), &[], b"");
    assert!(
        head.is_err() || matches!(head, Ok(reply) if reply.status == 431 || reply.status == 414)
    );
    assert_eq!(class.live.room().snapshot().answered, 0);
}

#[test]
fn what_does_not_fit_is_refused_with_a_sentence() {
    let class = Class::new("unfit");
    let [mut phone, mut other] = [class.joined(), class.joined()];
    let bodies = [
        "",
        "{",
        "null",
        "[]",
        "{\"step\":1}",
        "{\"step\":-1,\"round\":1,\"answer\":{\"choice\":0}}",
        "{\"step\":1,\"round\":1,\"answer\":{\"choice\":2}}",
        "{\"step\":1,\"round\":1,\"answer\":{\"value\":0.5}}",
        "{\"step\":1,\"round\":1,\"answer\":{\"choice\":-1}}",
        "{\"step\":1,\"round\":1,\"answer\":{\"choice\":1e99}}",
        "{\"step\":1,\"round\":1,\"answer\":{\"curve\":[1e999]}}",
        "{\"step\":1,\"round\":1,\"answer\":{\"choice\":0},\"sent\":1e300}",
        "{\"step\":1,\"round\":1,\"answer\":{\"choice\":0},\"sent\":18446744073709551615}",
        "\u{0}\u{1}\u{2}",
    ];
    for (index, body) in bodies.iter().enumerate() {
        let phone = if index % 2 == 0 {
            &mut phone
        } else {
            &mut other
        };
        let reply = phone
            .request("POST", "answers", &[], body.as_bytes())
            .expect("an answer");
        assert_eq!(reply.status, 400, "{body}");
        assert!(
            reply.json()["error"]
                .as_str()
                .is_some_and(|words| words.ends_with('.')),
            "{body}"
        );
    }
    assert_eq!(class.live.room().snapshot().answered, 0);
}

#[test]
fn who_asks_too_fast_is_put_off_and_nobody_else_is() {
    let class = Class::new("fast");
    let [mut fast, mut calm] = [class.joined(), class.joined()];
    let begun = Instant::now();
    let mut put_off = 0;
    let mut let_in = 0;
    for index in 0..60 {
        match fast.answer(1, 1, &choice(index % 2)).status {
            429 => put_off += 1,
            200 => let_in += 1,
            status => panic!("{status}"),
        }
    }
    let most = 10.0 + 10.0 * begun.elapsed().as_secs_f64();
    assert!(
        f64::from(let_in) <= most && put_off > 0,
        "{let_in} were let in"
    );
    assert_eq!(calm.answer(1, 1, &choice(0)).status, 200);
}

#[test]
fn a_class_is_full_at_a_thousand_and_invented_students_make_room() {
    let class = Class::new("full");
    let room = class.live.room();
    let mut answered = class.joined();
    assert_eq!(answered.answer(1, 1, &choice(0)).status, 200);
    let watching = class.joined();
    let _events = watching.events().expect("events");
    wait_until("the phone is there", || room.snapshot().connected == 1);
    let begun = Instant::now();
    let mut joined = 2;
    while joined < 1200 {
        assert!(begun.elapsed() < Duration::from_secs(60));
        match room.join(None, None) {
            Ok(_) => joined += 1,
            Err(shading_lab::class::Refusal::TooFast) => {
                std::thread::sleep(Duration::from_millis(20));
            }
            Err(refusal) => panic!("{refusal:?}"),
        }
    }
    assert_eq!(room.snapshot().joined, 1000);
    // Who has answered or watches keeps the seat.
    assert_eq!(answered.answer(1, 1, &choice(1)).status, 200);
    let mut watching: Phone = watching;
    assert_eq!(watching.answer(1, 1, &choice(1)).status, 200);
}

#[test]
fn slow_phones_do_not_hold_up_the_others() {
    let class = Class::new("slow");
    let phone = class.joined();
    let token = phone.token.as_deref().unwrap_or_default();
    let beginnings = [
        "GET".to_owned(),
        format!("GET {}/ HTTP/1.1\r\nHost: class\r\n", phone.base),
        format!(
            "POST {}/answers HTTP/1.1\r\nHost: class\r\nCookie: token={token}\r\nContent-Length: 100\r\n\r\n{{",
            phone.base
        ),
    ];
    let mut slow: Vec<_> = beginnings
        .iter()
        .map(|beginning| {
            let mut stream = connect(phone.address).expect("a connection");
            stream
                .get_mut()
                .write_all(beginning.as_bytes())
                .expect("a beginning");
            stream
        })
        .collect();
    let mut other = class.joined();
    assert_eq!(other.answer(1, 1, &choice(0)).status, 200);
    // Each is ended after ten seconds, with an answer or without.
    let begun = Instant::now();
    for stream in &mut slow {
        let mut answer = String::new();
        let _ = stream.read_to_string(&mut answer);
        assert!(begun.elapsed() < Duration::from_secs(20), "{answer}");
        assert!(
            answer.is_empty() || answer.starts_with("HTTP/1.1 408 "),
            "{answer}"
        );
    }
    assert!(begun.elapsed() > Duration::from_secs(5));
}
