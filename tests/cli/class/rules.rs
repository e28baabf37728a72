//! The way of a class: joined, asked, answered, shown, asked again, explained, gone on.

use super::client::Phone;
use super::{Class, start, wait_until};
use serde_json::{Value, json};
use shading_lab::class::Command;
use shading_lab::lesson::{ClassRecord, Phase};
use std::fs;
use std::io::{self, BufRead, BufReader, Write};
use std::net::{Shutdown, SocketAddr, TcpListener, TcpStream};
use std::time::Duration;

fn choice(option: usize) -> Value {
    json!({ "choice": option })
}

#[test]
fn a_class_goes_its_way() {
    let class = Class::new("way");
    let room = class.live.room();
    let mut phone = class.phone();
    let page = phone.get("");
    assert_eq!(page.status, 200);
    assert!(page.text().contains("Number 20.0"), "{}", page.text());
    phone.join(Some("Ada"));
    let mut events = phone.events().expect("events");
    let first = json!({ "step": 1, "phase": "ask", "round": 1, "steps": 12, "answered": null });
    let steps = room.lesson().steps.len();
    let pace = events.pace().expect("a pace");
    assert_eq!(pace, {
        let mut first = first;
        first["steps"] = json!(steps);
        first
    });

    let question = phone.get("steps/1");
    assert_eq!(question.status, 200);
    assert_eq!(
        phone.get("steps/1/1.png").headers["content-type"],
        "image/png"
    );
    assert_eq!(phone.get("steps/1/explanation").status, 403);
    assert_eq!(phone.get("steps/2").status, 403);

    // The wrong answer, changed to the right one.
    for option in [1, 0] {
        assert_eq!(
            phone.answer(1, 1, &choice(option)).json(),
            json!({ "saved": true })
        );
        assert_eq!(events.pace().expect("a pace")["answered"], choice(option));
    }
    let snapshot = room.snapshot();
    assert_eq!(
        (snapshot.joined, snapshot.connected, snapshot.answered),
        (1, 1, 1)
    );

    assert!(room.perform(Command::ShowAnswers));
    assert_eq!(events.pace().expect("a pace")["phase"], "spread");
    wait_until("the spread", || room.snapshot().spread.is_some());
    let spread = room.snapshot().spread.expect("a spread");
    assert_eq!((spread.rounds.len(), spread.rounds[0].right()), (1, 1));
    let refused = phone.answer(1, 1, &choice(1));
    assert_eq!(refused.status, 409);
    assert_eq!(refused.json()["pace"]["phase"], "spread");
    assert_eq!(refused.json()["error"], english!("live-not-open"));

    assert!(room.perform(Command::AskAgain));
    let again = events.pace().expect("a pace");
    assert_eq!(
        (&again["round"], &again["answered"]),
        (&json!(2), &Value::Null)
    );
    assert_eq!(phone.answer(1, 1, &choice(1)).status, 409);
    assert_eq!(phone.answer(1, 2, &choice(1)).status, 200);
    assert_eq!(events.pace().expect("a pace")["answered"], choice(1));
    assert!(room.perform(Command::Explain));
    assert_eq!(events.pace().expect("a pace")["phase"], "explain");
    assert!(phone.get("steps/1/explanation").text().contains('<'));
    wait_until("both rounds", || room.snapshot().spread.is_some());
    let spread = room.snapshot().spread.expect("a spread");
    let right: Vec<_> = spread.rounds.iter().map(|round| round.right()).collect();
    assert_eq!(right, [1, 0]);

    assert!(room.perform(Command::Next));
    assert_eq!(events.pace().expect("a pace")["step"], 2);
    // A step that is gone back to is as it was left.
    assert!(room.perform(Command::Back));
    let back = events.pace().expect("a pace");
    assert_eq!(
        (&back["step"], &back["phase"], &back["round"]),
        (&json!(1), &json!("explain"), &json!(2))
    );
    assert!(!room.perform(Command::Back) && !room.perform(Command::ShowAnswers));
    assert!(room.perform(Command::End));
    assert_eq!(events.pace().expect("a pace")["phase"], "closed");
    assert!(!room.perform(Command::Next));
}

#[test]
fn at_their_own_pace_students_turn_the_steps_and_see_no_explanation_ahead() {
    let class = Class::new("own-pace");
    let room = class.live.room();
    let mut phone = class.joined();
    let mut other = class.joined();
    // Slowly enough for one phone.
    let rest = || std::thread::sleep(Duration::from_millis(250));
    let turn = |phone: &mut Phone, step: usize| {
        rest();
        phone.post("turn", &json!({ "step": step })).status
    };
    assert_eq!(turn(&mut phone, 2), 403, "it is not allowed yet");
    assert_eq!(phone.get("steps/2").status, 403);

    let mut events = phone.events().expect("events");
    let mut following = other.events().expect("events");
    assert_eq!(events.pace().expect("a pace").get("lecturer"), None);
    following.pace().expect("a pace");
    assert!(room.perform(Command::OwnPace(true)));
    assert_eq!(events.pace().expect("a pace")["lecturer"], 1);
    following.pace().expect("a pace");

    let steps = room.lesson().steps.len();
    for nowhere in [0, steps + 1] {
        assert_eq!(turn(&mut phone, nowhere), 404, "{nowhere}");
    }
    assert_eq!(turn(&mut phone, 2), 200);
    let own = events.pace().expect("a pace");
    assert_eq!(
        (&own["step"], &own["lecturer"], &own["phase"]),
        (&json!(2), &json!(1), &json!("ask"))
    );
    assert_eq!(room.pace().step, 1, "nobody else is moved");
    assert_eq!(room.snapshot().elsewhere, 1);
    assert_eq!(phone.get("steps/2").status, 200);
    assert_eq!(phone.get("steps/2/explanation").status, 403);

    rest();
    // Each answers the step at which they are, and no other.
    let dark = choice(0);
    assert_eq!(phone.answer(1, 1, &choice(0)).status, 409);
    assert_eq!(phone.answer(2, 1, &dark).status, 200);
    assert_eq!(events.pace().expect("a pace")["answered"], dark);
    assert_eq!(other.answer(2, 1, &dark).status, 409);
    assert_eq!(room.snapshot().answered, 0, "the lecturer's question");

    // What the lecturer closes is closed for whoever turns to it; what was answered ahead is shown when its turn comes.
    assert!(room.perform(Command::Next) && room.perform(Command::ShowAnswers));
    wait_until("the spread", || room.snapshot().spread.is_some());
    let spread = room.snapshot().spread.expect("a spread");
    assert_eq!(spread.rounds[0].answers.len(), 1);
    assert_eq!(phone.answer(2, 1, &choice(1)).status, 409);
    assert_eq!(
        room.snapshot().elsewhere,
        0,
        "who is where the lecturer is follows the lecturer"
    );

    // Together again: everybody is at the lecturer's step.
    assert_eq!(turn(&mut phone, 1), 200);
    assert!(room.perform(Command::OwnPace(false)));
    assert_eq!(room.snapshot().elsewhere, 0);
    assert_eq!(turn(&mut phone, 1), 403);
    let back = phone.events().expect("events").pace().expect("a pace");
    assert_eq!((&back["step"], back.get("lecturer")), (&json!(2), None));
}

#[test]
fn a_step_that_was_left_open_is_open_again() {
    let class = Class::new("left");
    let room = class.live.room();
    let mut phone = class.joined();
    assert!(room.perform(Command::Next));
    assert_eq!(phone.answer(1, 1, &choice(0)).status, 409);
    assert!(room.perform(Command::Back));
    assert_eq!(phone.answer(1, 1, &choice(0)).status, 200);
    // Who comes late is at the step of the others at once, and may see what was before.
    assert!(room.perform(Command::Next));
    let mut late = class.joined();
    let pace = late.events().expect("events").pace().expect("a pace");
    assert_eq!(pace["step"], 2);
    assert_eq!(late.get("steps/1").status, 200);
}

#[test]
fn two_tabs_are_one_student() {
    let class = Class::new("tabs");
    let mut first = class.joined();
    let mut second = first.tab();
    second.join(None);
    assert_eq!(second.token, first.token);
    let mut events = second.events().expect("events");
    events.pace().expect("the first pace");
    assert_eq!(first.answer(1, 1, &choice(1)).status, 200);
    // The other tab is told.
    assert_eq!(events.pace().expect("a pace")["answered"], choice(1));
    assert_eq!(second.answer(1, 1, &choice(0)).status, 200);
    let snapshot = class.live.room().snapshot();
    assert_eq!((snapshot.joined, snapshot.answered), (1, 1));
    let record = fs::read(class.record()).expect("a record");
    assert_eq!(
        ClassRecord::read(&record).expect("a record").students.len(),
        1
    );
}

#[test]
fn a_phone_that_was_away_finds_its_place_again() {
    let class = Class::new("away");
    let room = class.live.room();
    let mut phone = class.joined();
    let mut events = phone.events().expect("events");
    events.pace().expect("a pace");
    wait_until("the phone is there", || room.snapshot().connected == 1);
    drop(events);
    wait_until("the phone is gone", || room.snapshot().connected == 0);
    assert_eq!(phone.answer(1, 1, &choice(0)).status, 200);
    for command in [
        Command::ShowAnswers,
        Command::Explain,
        Command::Next,
        Command::Next,
    ] {
        assert!(room.perform(command));
    }
    let pace = phone.events().expect("events").pace().expect("a pace");
    assert_eq!(pace["step"], 3);
    assert!(room.perform(Command::Back) && room.perform(Command::Back));
    let pace = phone.events().expect("events").pace().expect("a pace");
    assert_eq!(pace["answered"], choice(0));
}

#[test]
fn a_class_that_was_restarted_goes_on() {
    let class = Class::new("restarted");
    let mut phone = class.joined();
    let token = phone.token.clone();
    phone.join(Some("Ada"));
    assert_eq!(phone.answer(1, 1, &choice(0)).status, 200);
    assert!(class.live.room().perform(Command::Explain));
    assert!(class.live.room().perform(Command::Next));
    let code = class.live.room().head().code.clone();
    let Class { live, folder } = class;
    // While it is going on nobody else gets the record.
    let busy = start(&folder, None).expect_err("in use");
    assert!(busy.contains("--output"), "{busy}");
    drop(live);

    let class = Class::within(folder, None);
    let room = class.live.room();
    assert_eq!(room.head().code, code);
    assert!(
        class
            .live
            .notes()
            .iter()
            .any(|note| note.contains("1 student")),
        "{:?}",
        class.live.notes()
    );
    assert_eq!((room.pace().step, room.pace().phase), (2, Phase::Ask));
    let mut phone = Phone::new(super::address(&class.live), &code);
    phone.token.clone_from(&token);
    phone.join(None);
    assert_eq!(phone.token, token);
    assert_eq!(phone.get("steps/1/explanation").status, 200);
    assert_eq!(phone.answer(2, 1, &choice(1)).status, 200);
    let record = ClassRecord::read(&fs::read(class.record()).expect("a record")).expect("a record");
    assert_eq!(record.students.len(), 1);
    assert_eq!(
        (&*record.students[0].name, record.students[0].answers.len()),
        ("Ada", 2)
    );
}

#[test]
fn names_are_short_and_plain() {
    let class = Class::new("names");
    let mut phone = class.phone();
    phone.join(Some(&format!("\u{1b}[31m\u{202e}{}", "x".repeat(100))));
    let rows = class.live.room().students();
    let name = &rows[0].name;
    assert!(
        name.chars().count() <= 40 && name.contains("xxx"),
        "{name:?}"
    );
    assert!(!name.contains(['\u{1b}', '\u{202e}']), "{name:?}");
    phone.join(Some("王小明"));
    assert_eq!(class.live.room().students()[0].name, "王小明");
}

#[test]
fn every_link_of_the_page_is_relative() {
    let class = Class::new("relative");
    let mut phone = class.joined();
    for rest in named(&phone.get("").text()) {
        assert!(!rest.starts_with('/') && !rest.contains("://"), "{rest}");
        assert_eq!(phone.get(&rest).status, 200, "{rest}");
    }
    let folder = phone
        .send("GET", &phone.base.clone(), &[], b"")
        .expect("an answer");
    let code = &class.live.room().head().code;
    assert_eq!(
        (folder.status, &folder.headers["location"]),
        (307, &format!("{code}/"))
    );
}

/// Returns what a page names.
fn named(page: &str) -> Vec<String> {
    let attributes = page
        .match_indices("href=\"")
        .chain(page.match_indices("src=\""));
    let named = attributes.filter_map(|(at, _)| page[at..].split('"').nth(1));
    named
        .filter(|named| !named.starts_with("data:"))
        .map(str::to_owned)
        .collect()
}

/// Passes on a request of a connection with `/prefix` taken off its path, as a proxy does, and everything that comes back.
fn pass_on(client: TcpStream, server: SocketAddr) -> io::Result<()> {
    let mut client = BufReader::new(client);
    let mut server = TcpStream::connect(server)?;
    let mut line = String::new();
    while client.read_line(&mut line)? > 2 {
        let line = std::mem::take(&mut line).replacen(" /prefix/", " /", 1);
        server.write_all(line.as_bytes())?;
    }
    server.write_all(b"Connection: close\r\n\r\n")?;
    let mut back = (server.try_clone()?, client.get_ref().try_clone()?);
    let answers = std::thread::spawn(move || {
        let copied = io::copy(&mut back.0, &mut back.1);
        let _ = back.1.shutdown(Shutdown::Both);
        copied
    });
    io::copy(&mut client, &mut server)?;
    drop(answers.join());
    Ok(())
}

#[test]
fn behind_a_proxy_with_a_prefix_everything_works() {
    let class = Class::new("prefix");
    let (server, proxy) = (
        super::address(&class.live),
        TcpListener::bind(("127.0.0.1", 0)).expect("a port"),
    );
    let address = proxy.local_addr().expect("an address");
    std::thread::spawn(move || {
        for client in proxy.incoming().map_while(Result::ok) {
            std::thread::spawn(move || pass_on(client, server));
        }
    });
    let code = &class.live.room().head().code;
    let mut phone = Phone::new(address, &format!("prefix/{code}"));
    let page = phone.get("").text();
    let joined = phone.post("join", &json!({}));
    // Without a path in it a browser keeps the cookie for the folder that it asked, prefix and all.
    assert!(
        !joined.headers["set-cookie"]
            .to_lowercase()
            .contains("path="),
        "{joined:?}"
    );
    phone.keep_cookie(&joined);
    for rest in named(&page) {
        assert_eq!(phone.get(&rest).status, 200, "{rest}");
    }
    let mut events = phone.events().expect("events");
    assert_eq!(events.pace().expect("a pace")["phase"], "ask");
    assert_eq!(phone.answer(1, 1, &choice(1)).status, 200);
    assert_eq!(events.pace().expect("a pace")["answered"], choice(1));
    class.live.room().perform(Command::ShowAnswers);
    assert_eq!(events.pace().expect("a pace")["phase"], "spread");
}

#[test]
fn what_does_not_change_is_sent_once_and_compressed() {
    let class = Class::new("files");
    let mut phone = class.phone();
    let plain = phone.get("class.js");
    let gzip = [("Accept-Encoding", "gzip, deflate")];
    let small = phone
        .request("GET", "class.js", &gzip, b"")
        .expect("an answer");
    assert_eq!(small.headers["content-encoding"], "gzip");
    assert!(small.body.len() < plain.body.len());
    assert!(small.headers["cache-control"].contains("immutable"));
    let known = [gzip[0], ("If-None-Match", &*small.headers["etag"])];
    let again = phone
        .request("GET", "class.js", &known, b"")
        .expect("an answer");
    assert_eq!((again.status, again.body.len()), (304, 0));
    let policy = &phone.get("").headers["content-security-policy"];
    assert!(
        policy.contains("default-src 'none'") && !policy.contains("unsafe"),
        "{policy}"
    );
}
