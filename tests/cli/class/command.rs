//! `shading-lab class` without a window, as a script runs it.

use super::client::Phone;
use super::wait_until;
use crate::common::lessons::EVERY_KIND;
use crate::common::program::Folder;
use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Write};
use std::net::{SocketAddr, TcpListener};
use std::process::{Child, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;

/// A class as a process of its own; killed when dropped.
pub struct Running {
    pub child: Child,
    pub events: Receiver<Value>,
    pub address: SocketAddr,
    pub code: String,
}

impl Running {
    /// Starts a class in a folder with these arguments, and waits until it is open.
    pub fn start(folder: &Folder, arguments: &[&str]) -> Self {
        let fixed = [
            "class",
            "every-kind.md",
            "--headless",
            "--bind",
            "127.0.0.1",
            "--port",
            "0",
        ];
        folder.write("every-kind.md", EVERY_KIND);
        let mut command = folder.command(&[&fixed[..], arguments].concat());
        command
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null());
        let mut child = command.spawn().expect("the program");
        let lines = BufReader::new(child.stdout.take().expect("its output")).lines();
        let (sender, events) = channel();
        std::thread::spawn(move || {
            for line in lines.map_while(Result::ok) {
                let event =
                    serde_json::from_str(&line).unwrap_or_else(|error| panic!("{line}: {error}"));
                if sender.send(event).is_err() {
                    return;
                }
            }
        });
        let open: Value = events
            .recv_timeout(Duration::from_secs(30))
            .expect("it opens");
        assert_eq!(open["event"], "open");
        let port = open["port"].as_u64().expect("a port") as u16;
        let address = open["address"].as_str().expect("an address");
        let code = address
            .trim_end_matches('/')
            .rsplit('/')
            .next()
            .unwrap_or_default();
        Self {
            address: SocketAddr::from(([127, 0, 0, 1], port)),
            code: code.to_owned(),
            child,
            events,
        }
    }

    pub fn phone(&self) -> Phone {
        Phone::new(self.address, &self.code)
    }

    pub fn types(&mut self, word: &str) {
        let stdin = self.child.stdin.as_mut().expect("its input");
        writeln!(stdin, "{word}").expect("it reads");
    }

    /// Waits for an event.
    #[track_caller]
    pub fn hears(&self, what: &str, is: impl Fn(&Value) -> bool) -> Value {
        loop {
            let event = self.events.recv_timeout(Duration::from_secs(30));
            let event = event.unwrap_or_else(|_| panic!("waited in vain: {what}"));
            if event["event"] == what && is(&event) {
                return event;
            }
        }
    }

    /// Ends the process at once, as `kill -9` does.
    pub fn kill(&mut self) {
        self.child.kill().expect("it can be killed");
        self.child.wait().expect("it is gone");
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

#[test]
fn a_class_without_a_window_says_what_happens() {
    let folder = Folder::new("class-headless");
    let mut class = Running::start(&folder, &[]);
    class.hears("step", |event| {
        event["step"] == 1 && event["phase"] == "ask"
    });
    let [mut ada, mut ben] = [class.phone(), class.phone()];
    ada.join(Some("Ada"));
    ben.join(None);
    class.hears("joined", |event| event["joined"] == 2);
    assert_eq!(ada.answer(1, 1, &json!({ "choice": 0 })).status, 200);
    assert_eq!(ben.answer(1, 1, &json!({ "choice": 1 })).status, 200);
    class.hears("answered", |event| event["answered"] == 2);
    class.types("show");
    let shown = class.hears("shown", |_| true);
    assert_eq!(
        (
            &shown["rounds"][0]["right"],
            &shown["rounds"][0]["answered"]
        ),
        (&json!(1), &json!(2))
    );
    // Nothing is said of the wrong option, so it is no model.
    assert_eq!(shown["rounds"][0]["models"], json!([]));
    assert_eq!(shown["rounds"][0]["answers"][1]["right"], json!(false));
    class.types("again");
    class.hears("step", |event| event["round"] == 2);
    assert_eq!(ben.answer(1, 2, &json!({ "choice": 0 })).status, 200);
    class.types("explain");
    let shown = class.hears("shown", |_| true);
    assert_eq!(
        (&shown["rounds"][0]["right"], &shown["rounds"][1]["right"]),
        (&json!(1), &json!(1))
    );
    for step in 2..=3 {
        class.types("next");
        class.hears("step", |event| event["step"] == step);
    }
    assert_eq!(ada.answer(3, 1, &json!({ "value": 0.5 })).status, 200);
    class.types("end");
    wait_until("it ends", || {
        class.child.try_wait().is_ok_and(|status| status.is_some())
    });

    // The file is graded as hand-ins are: the first round is the prediction.
    let marks = folder.json(&["collect", "class.jsonl", "--json"]);
    let rows = marks["rows"].as_array().expect("rows");
    let names: Vec<&Value> = rows.iter().map(|row| &row["name"]).collect();
    assert_eq!(names, [&json!("Ada"), &json!("")]);
    let [ada, ben] = [&rows[0]["answers"], &rows[1]["answers"]];
    assert_eq!(
        (&ada[0]["right"], &ada[2]["right"], &ada[1]["given"]),
        (&json!(true), &json!(true), &Value::Null)
    );
    assert_eq!(
        (
            &ben[0]["right"],
            &ben[0]["prediction_right"],
            &ben[0]["tries"]
        ),
        (&json!(true), &json!(false), &json!(2))
    );
    let words = folder.prints(&["collect", "class.jsonl"]);
    assert!(
        words.contains("Ada") && words.contains("class.jsonl:2"),
        "{words}"
    );
    folder.prints(&[
        "collect",
        "class.jsonl",
        "-o",
        "class.html",
        "--csv",
        "class.csv",
    ]);
}

#[test]
fn students_of_one_name_are_not_one_student() {
    let folder = Folder::new("class-names-alike");
    let class = Running::start(&folder, &[]);
    for option in 0..2 {
        let mut phone = class.phone();
        phone.join(Some("Kim"));
        assert_eq!(phone.answer(1, 1, &json!({ "choice": option })).status, 200);
    }
    let marks = folder.json(&["collect", "class.jsonl", "--json"]);
    assert_eq!(marks["rows"].as_array().map(Vec::len), Some(2), "{marks}");
}

#[test]
fn two_classes_are_held_at_once() {
    let folder = Folder::new("class-two");
    let [first, second] =
        ["a.jsonl", "b.jsonl"].map(|file| Running::start(&folder, &["--output", file]));
    assert_ne!(first.code, second.code);
    let [mut ada, mut ben] = [first.phone(), second.phone()];
    ada.join(None);
    ben.join(None);
    assert_eq!(ada.answer(1, 1, &json!({ "choice": 0 })).status, 200);
    // The secret of one class is none of the other.
    let mut stranger = second.phone();
    stranger.token.clone_from(&ada.token);
    assert_eq!(stranger.answer(1, 1, &json!({ "choice": 0 })).status, 401);
}

#[test]
fn what_is_in_the_way_is_named_with_what_to_do() {
    let folder = Folder::new("class-in-the-way");
    let class = Running::start(&folder, &[]);
    let begin = [
        "class",
        "every-kind.md",
        "--headless",
        "--bind",
        "127.0.0.1",
        "--port",
        "0",
    ];
    folder.fails(
        &begin,
        2,
        &[&english!("live-record-in-use", file = "class.jsonl")],
    );
    let taken = TcpListener::bind(("127.0.0.1", 0)).expect("a port");
    let port = taken.local_addr().expect("an address").port().to_string();
    let on_port = [
        "class",
        "every-kind.md",
        "--headless",
        "--output",
        "b.jsonl",
        "--bind",
        "127.0.0.1",
        "--port",
        &port,
    ];
    folder.fails(&on_port, 2, &[&english!("live-port-taken", port = &*port)]);
    drop(class);
    let other = [
        "class",
        "mach-bands",
        "--headless",
        "--bind",
        "127.0.0.1",
        "--port",
        "0",
    ];
    let title = "Every kind";
    let why = english!("live-record-other", title = title);
    folder.fails(
        &other,
        2,
        &[&english!(
            "live-record-unsound",
            file = "class.jsonl",
            error = why
        )],
    );
    folder.fails(
        &["class", "mach-band", "--headless"],
        2,
        &[&english!(
            "cli-no-lesson",
            name = "mach-band",
            meant = shading_lab::scene::did_you_mean("mach-band", ["mach-bands"].into_iter())
        )],
    );
    folder.refuses(
        &["class", "mach-bands", "--bind", "here"],
        english!("cli-expected-address"),
    );
    folder.fails(
        &["class", "every-kind.md", "--headless", "--output", "."],
        2,
        &[&english!("live-record-no-file", file = ".")],
    );
}

#[test]
fn a_rehearsed_class_makes_the_mistakes_of_the_lesson() {
    let folder = Folder::new("class-rehearsed");
    let mut class = Running::start(&folder, &["--rehearse", "40"]);
    class.hears("joined", |event| event["joined"] == 40);
    class.types("next");
    class.hears("answered", |event| {
        event["step"] == 2 && event["answered"].as_u64() >= Some(25)
    });
    class.types("show");
    let shown = class.hears("shown", |event| event["step"] == 2);
    let round = &shown["rounds"][0];
    let number = |value: &Value| value.as_u64().unwrap_or(0);
    let (answered, right) = (number(&round["answered"]), number(&round["right"]));
    assert!(
        right * 10 > answered && right * 10 < 9 * answered,
        "{right} of {answered}"
    );
    class.types("again");
    class.hears("answered", |event| {
        event["round"] == 2 && event["answered"].as_u64() >= Some(25)
    });
    class.types("show");
    let shown = class.hears("shown", |_| true);
    let round = &shown["rounds"][1];
    // A talk with the neighbour convinces many.
    assert!(
        number(&round["right"]) * answered > right * number(&round["answered"]),
        "{shown}"
    );
    let marks = folder.json(&["collect", "rehearsal.jsonl", "--json"]);
    assert!(marks["rows"].as_array().is_some_and(|rows| rows.len() > 25));
}
