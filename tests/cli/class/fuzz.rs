//! Requests of any form: each is answered or its connection closed, and the class goes on.
//!
//! `FUZZ_COUNT=1000000 cargo test --release --test cli class::fuzz -- --nocapture` tries that many.

use super::Class;
use super::client::connect;
use crate::common::dice::Dice;
use crate::common::fuzz::Format;
use serde_json::json;
use shading_lab::class::Command;
use std::io::{BufRead, BufReader, Write};
use std::net::{Shutdown, SocketAddr, TcpStream};
use std::time::{Duration, Instant};

/// Requests in the gate.
const COUNT: u64 = 2000;
/// The students whose requests are changed.
const STUDENTS: usize = 190;

/// Sends bytes, reads whatever comes back until the connection is closed, and returns the status codes.
fn exchange(address: SocketAddr, bytes: &[u8]) -> Vec<u16> {
    let mut stream: BufReader<TcpStream> = connect(address).expect("the server is there");
    // The server may refuse before all is sent.
    let _ = stream.get_mut().write_all(bytes);
    let _ = stream.get_ref().shutdown(Shutdown::Write);
    let mut codes = Vec::new();
    let mut line = Vec::new();
    while stream
        .read_until(b'\n', &mut line)
        .is_ok_and(|count| count > 0)
    {
        // Who asks in HTTP/1.0 is answered in it.
        let version = [&b"HTTP/1.1 "[..], b"HTTP/1.0 "];
        if let Some(rest) = version
            .iter()
            .find_map(|version| line.strip_prefix(*version))
        {
            codes.extend(
                std::str::from_utf8(&rest[..3])
                    .ok()
                    .and_then(|code| code.parse::<u16>().ok()),
            );
            // A stream of events does not end by itself.
            if codes.last() == Some(&200) && line_of_events(&mut stream) {
                return codes;
            }
        }
        line.clear();
    }
    codes
}

/// Reads on to the end of a head; true if events follow.
fn line_of_events(stream: &mut impl BufRead) -> bool {
    let mut line = String::new();
    while stream.read_line(&mut line).is_ok_and(|count| count > 2) {
        if line.starts_with("content-type: text/event-stream") {
            return true;
        }
        line.clear();
    }
    false
}

/// What is put into requests.
const WORDS: &[&str] = &[
    "\r\n\r\n",
    "Transfer-Encoding: chunked\r\n",
    "Content-Length: 99999999999999999999\r\n",
    "Content-Length: -1\r\n",
    "Expect: 100-continue\r\n",
    "Upgrade: h2c\r\nConnection: Upgrade\r\n",
    "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n",
    "/../",
    "%2e%2e%2f",
    "%00",
    "HTTP/1.0",
    "HTTP/9.9",
    "CONNECT a:1",
    "OPTIONS *",
    "HEAD",
    "[[[[[[[[[[[[[[[[",
    "{\"choice\":",
    "Range: bytes=0-0\r\n",
    "token=",
    "Cookie: token=00000000000000000000000000000000\r\n",
    "If-None-Match: *\r\n",
    "Accept-Encoding: gzip;q=nan\r\n",
];

/// Returns requests of a student that are answered.
fn sound(base: &str, token: &str) -> Vec<Vec<u8>> {
    let head = format!("Host: class\r\nCookie: token={token}\r\nConnection: close\r\n");
    let answer = json!({ "step": 1, "round": 1, "answer": { "choice": 0 }, "sent": 7 }).to_string();
    let (length, name) = (answer.len(), json!({ "name": "Ada" }).to_string());
    let post = |path: &str, body: &str| {
        let length = body.len();
        format!("POST {base}/{path} HTTP/1.1\r\n{head}Content-Length: {length}\r\n\r\n{body}")
    };
    let get = |path: &str| format!("GET {base}/{path} HTTP/1.1\r\n{head}\r\n");
    let chunked = format!(
        "POST {base}/answers HTTP/1.1\r\n{head}Transfer-Encoding: chunked\r\n\r\n{length:x}\r\n{answer}\r\n0\r\n\r\n"
    );
    let turn = json!({ "step": 1 }).to_string();
    let posts = [
        post("answers", &answer),
        post("join", &name),
        post("turn", &turn),
        chunked,
    ];
    let paths = [
        "",
        "class.js",
        "events",
        "steps/1",
        "steps/1/1.png",
        "steps/1/explanation",
        "lab/index.html",
    ];
    let all = posts.into_iter().chain(paths.map(get));
    all.map(String::into_bytes).collect()
}

#[test]
fn requests() {
    let set = |name: &str| std::env::var(name).ok()?.parse::<u64>().ok();
    let (count, seed) = (
        set("FUZZ_COUNT").unwrap_or(COUNT),
        set("FUZZ_SEED").unwrap_or(1),
    );
    let class = Class::new("fuzz");
    let room = class.live.room();
    assert!(room.perform(Command::OwnPace(true)));
    let phone = class.phone();
    // One student alone would be put off most of the time.
    let formats: Vec<Format> = (0..STUDENTS)
        .filter_map(|_| room.join(None, None).ok())
        .map(|token| Format {
            name: "requests",
            sound: sound(&phone.base, &token.to_string()),
            words: WORDS,
            read: |_| true,
            png: false,
        })
        .collect();
    let mut seen = [0u64; 6];
    for tried in 0..count {
        let format = &formats[tried as usize % formats.len()];
        let bytes = format.changed(&mut Dice(seed.wrapping_mul(1 << 32).wrapping_add(tried)));
        let begun = Instant::now();
        for code in exchange(phone.address, &bytes) {
            seen[usize::from(code / 100).min(5)] += 1;
            assert_ne!(
                code / 100,
                5,
                "FUZZ_SEED={seed}, request {tried}: {:?}",
                String::from_utf8_lossy(&bytes)
            );
        }
        assert!(
            begun.elapsed() < Duration::from_secs(15),
            "request {tried} of FUZZ_SEED={seed}"
        );
    }
    println!("requests: {count} tried, answered by hundreds {seen:?}");
    // Much gets through to what reads it.
    assert!(30 * seen[2] > seen[4] && seen[4] > 0, "{seen:?}");
    // The class is where it was, and goes on.
    let pace = room.pace();
    assert_eq!((pace.step, pace.round), (1, 1));
    // A rush of new students is put off for a second.
    std::thread::sleep(Duration::from_secs(1));
    let mut phone = class.joined();
    assert_eq!(phone.answer(1, 1, &json!({ "choice": 0 })).status, 200);
    assert!(room.perform(Command::ShowAnswers));
}
