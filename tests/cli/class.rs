//! The live class: what phones send and are told, what is written, and who may do what.

mod cheats;
mod client;
mod command;
mod fuzz;
mod kill;
mod load;
mod record;
mod rules;

use crate::common::lessons::EVERY_KIND;
use crate::common::program::Folder;
use client::Phone;
use shading_lab::class::{Live, LiveOptions, ServerOptions};
use shading_lab::lesson::Lesson;
use std::net::{IpAddr, Ipv4Addr, SocketAddr};
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// The longest time that anything here may take.
const PATIENCE: Duration = Duration::from_secs(20);

/// A class in a folder of its own.
struct Class {
    live: Live,
    folder: Folder,
}

impl Class {
    fn new(name: &str) -> Self {
        Self::within(Folder::new(&format!("class-{name}")), None)
    }

    fn within(folder: Folder, page: Option<PathBuf>) -> Self {
        let live = start(&folder, page).expect("a class");
        Self { live, folder }
    }

    fn phone(&self) -> Phone {
        Phone::new(address(&self.live), &self.live.room().head().code)
    }

    /// Returns a phone whose student has joined.
    fn joined(&self) -> Phone {
        let mut phone = self.phone();
        phone.join(None);
        phone
    }

    fn record(&self) -> PathBuf {
        self.folder.0.join("class.jsonl")
    }
}

fn lesson() -> Lesson {
    Lesson::read(EVERY_KIND, None).expect("a lesson")
}

fn start(folder: &Folder, page: Option<PathBuf>) -> Result<Live, String> {
    let options = LiveOptions {
        record: folder.0.join("class.jsonl"),
        server: ServerOptions {
            bind: IpAddr::V4(Ipv4Addr::LOCALHOST),
            port: Some(0),
            page,
        },
        url: None,
        own_pace: false,
        rehearse: 0,
        seed: 1,
    };
    Live::start(lesson(), &options)
}

fn address(live: &Live) -> SocketAddr {
    live.listens_at()
}

/// Waits until something holds.
#[track_caller]
fn wait_until(what: &str, mut holds: impl FnMut() -> bool) {
    let begun = Instant::now();
    while !holds() {
        assert!(begun.elapsed() < PATIENCE, "waited in vain: {what}");
        std::thread::sleep(Duration::from_millis(5));
    }
}
