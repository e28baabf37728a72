//! Many phones at once, in the gate fifty. By hand:
//!
//! ```text
//! CLASS_PHONES=500 cargo test --release --test cli class::load -- --nocapture
//! ```
//! prints how long joining took, how long acknowledging, and the server's memory. Everything stays on this machine, and ends after a minute.
//!
//! A class that runs already, in a window for example, is joined with `CLASS_ADDRESS`, as the program prints it on this machine
//! (`shading-lab class tests/data/every-kind.md --bind 127.0.0.1`, at its first step). Its phones then stay for twenty seconds,
//! in which the lecturer shows the answers.

use super::client::Phone;
use super::command::Running;
use crate::common::dice::Dice;
use crate::common::program::Folder;
use serde_json::json;
use std::fs;
use std::net::SocketAddr;
use std::sync::Barrier;
use std::time::{Duration, Instant};

/// The phones in the gate.
const PHONES: usize = 50;
/// The time within which all answer.
const WITHIN: Duration = Duration::from_secs(5);
/// The time that phones stay in a class that runs already.
const STAY: Duration = Duration::from_secs(20);
/// The stack of a phone's thread, in bytes.
const STACK: usize = 256 << 10;

struct Timed {
    joined: Duration,
    acknowledged: Duration,
}

/// Returns where a class that runs already is, and its code.
fn running() -> Option<(SocketAddr, String)> {
    let address = std::env::var("CLASS_ADDRESS").ok()?;
    let rest = address.strip_prefix("http://").expect("an address");
    let (host, code) = rest.split_once('/').expect("an address with a code");
    let host: SocketAddr = host.parse().expect("an address with a port");
    assert!(host.ip().is_loopback(), "only a class on this machine");
    Some((host, code.trim_end_matches('/').to_owned()))
}

/// Returns the largest memory that a process has had, in bytes; none where the system does not say.
fn peak_memory(process: u32) -> Option<u64> {
    let status = fs::read_to_string(format!("/proc/{process}/status")).ok()?;
    let line = status
        .lines()
        .find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kilobytes: u64 = line.trim().strip_suffix(" kB")?.parse().ok()?;
    Some(kilobytes << 10)
}

#[test]
fn a_whole_class_joins_and_answers() {
    let phones = std::env::var("CLASS_PHONES")
        .ok()
        .and_then(|count| count.parse().ok());
    let phones = phones.unwrap_or(PHONES);
    let folder = Folder::new("class-load");
    let elsewhere = running();
    let class = elsewhere.is_none().then(|| Running::start(&folder, &[]));
    let (address, code) = match (elsewhere, &class) {
        (Some(elsewhere), _) => elsewhere,
        (None, own) => {
            let own = own.as_ref().expect("a class");
            (own.address, own.code.clone())
        }
    };
    let begun = Instant::now();
    let together = Barrier::new(phones);
    let stays = class.is_none();
    let phone = |index: usize| {
        let mut phone = Phone::new(address, &code);
        let begun_here = Instant::now();
        // As a browser does: the page, what it names, joining, the events, the picture.
        let page = phone.get("").text();
        assert!(page.contains("class.js"));
        assert_eq!(phone.get("class.css").status, 200);
        assert_eq!(phone.get("class.js").status, 200);
        loop {
            let reply = phone.post("join", &json!({}));
            if reply.status == 200 {
                phone.keep_cookie(&reply);
                break;
            }
            assert_eq!(reply.status, 429, "{}", reply.text());
            std::thread::sleep(Duration::from_millis(500));
        }
        let mut events = phone.events().expect("events");
        assert_eq!(events.pace().expect("a pace")["phase"], "ask");
        let picture = phone.get("steps/1/1.png");
        assert_eq!(picture.body.get(1..4), Some(&b"PNG"[..]));
        let joined = begun_here.elapsed();
        together.wait();
        let pause = Dice(index as u64).between(0.0, WITHIN.as_secs_f64());
        std::thread::sleep(Duration::from_secs_f64(pause));
        let sent = Instant::now();
        let reply = phone.answer(1, 1, &json!({ "choice": index % 2 }));
        let acknowledged = sent.elapsed();
        assert_eq!(reply.json(), json!({ "saved": true }));
        // The stream tells it too.
        assert_eq!(
            events.pace().expect("a pace")["answered"],
            json!({ "choice": index % 2 })
        );
        if stays {
            std::thread::sleep(STAY);
        }
        Timed {
            joined,
            acknowledged,
        }
    };
    let timed: Vec<Timed> = std::thread::scope(|scope| {
        let start = |index: usize| {
            let builder = std::thread::Builder::new().stack_size(STACK);
            let phone = &phone;
            builder
                .spawn_scoped(scope, move || phone(index))
                .expect("a thread")
        };
        let running: Vec<_> = (0..phones).map(start).collect();
        running
            .into_iter()
            .map(|thread| thread.join().expect("a phone"))
            .collect()
    });
    assert!(begun.elapsed() < Duration::from_secs(60));
    let mut waits: Vec<Duration> = timed.iter().map(|timed| timed.acknowledged).collect();
    waits.sort();
    let joined = timed
        .iter()
        .map(|timed| timed.joined)
        .max()
        .unwrap_or_default();
    let (median, late) = (waits[phones / 2], waits[(phones * 99).div_ceil(100) - 1]);
    println!(
        "{phones} phones: joined with the picture within {joined:.1?}; acknowledged in {median:.1?} at the median, {late:.1?} at the \
         99th percentile, {:.1?} at most",
        waits[phones - 1],
    );
    let Some(class) = class else { return };
    class.hears("answered", |event| event["answered"] == phones);
    let marks = folder.json(&["collect", "class.jsonl", "--json"]);
    assert_eq!(marks["rows"].as_array().map(Vec::len), Some(phones));
    let memory = peak_memory(class.child.id());
    println!(
        "the server's memory: {} MB at most",
        memory.map_or(0, |bytes| bytes >> 20)
    );
    assert!(memory.is_none_or(|bytes| bytes < 200 << 20), "{memory:?}");
}
