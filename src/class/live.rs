//! A class that is going on: its room, its server, and the address for the phones.

use super::address::{class_address, own_address};
use super::record::open_record;
use super::rehearsal::rehearse;
use super::room::{Command, Room};
use super::server::{Server, ServerOptions};
use crate::lesson::Lesson;
use crate::text::text;
use std::net::{IpAddr, SocketAddr};
use std::path::PathBuf;
use std::sync::Arc;

/// The settings of a class.
#[derive(Clone, Debug)]
pub struct LiveOptions {
    /// The file of its record.
    pub record: PathBuf,
    /// The address at which it is served.
    pub server: ServerOptions,
    /// The part of the shown address before the code, behind a proxy.
    pub url: Option<String>,
    /// True if students go at their own pace.
    pub own_pace: bool,
    /// The number of simulated students.
    pub rehearse: usize,
    /// The seed of what is drawn at random.
    pub seed: u64,
}

/// A class that is going on. When it is dropped it is over: the phones are told, and the port and the record are given back.
#[derive(Debug)]
pub struct Live {
    room: Arc<Room>,
    server: Option<Server>,
    at: SocketAddr,
    has_lab: bool,
    address: String,
    notes: Vec<String>,
}

impl Live {
    /// Starts a class about a lesson, or goes on with it where its record exists.
    ///
    /// # Errors
    /// The record or the port cannot be opened, in a sentence that says what to do.
    pub fn start(lesson: Lesson, options: &LiveOptions) -> Result<Self, String> {
        let mut notes = Vec::new();
        let (recorder, record) = open_record(&options.record, &lesson, options.seed)?;
        if !record.students.is_empty() || !record.paces.is_empty() {
            let file = options.record.display().to_string();
            let students = record.students.len();
            notes.push(text!("live-goes-on", file = file, students = students));
        }
        let room = Room::open(lesson, recorder, record);
        if options.own_pace {
            room.perform(Command::OwnPace(true));
        }
        let server = Server::start(&room, &options.server)?;
        let at = server.address();
        let ip = match at.ip() {
            ip if !ip.is_unspecified() => Some(ip),
            _ => own_address(),
        };
        if ip.is_none() && options.url.is_none() {
            notes.push(text!("live-no-network").to_owned());
        }
        if !server.has_lab() {
            notes.push(text!("live-lab-missing").to_owned());
        }
        let ip = ip.unwrap_or(IpAddr::from([127, 0, 0, 1]));
        let url = options.url.as_deref();
        let address = class_address(url, (ip, at.port()), &room.head().code);
        if options.rehearse > 0 {
            rehearse(&room, options.rehearse, options.seed);
        }
        Ok(Self {
            room,
            has_lab: server.has_lab(),
            server: Some(server),
            at,
            address,
            notes,
        })
    }

    /// Returns the class.
    pub fn room(&self) -> &Arc<Room> {
        &self.room
    }

    /// Returns the address that its server listens at.
    pub fn listens_at(&self) -> SocketAddr {
        self.at
    }

    /// Returns whether phones can open the program's own page.
    pub fn has_lab(&self) -> bool {
        self.has_lab
    }

    /// Returns the address that takes phones to its page.
    pub fn address(&self) -> &str {
        &self.address
    }

    /// Returns what the lecturer should know, in sentences.
    pub fn notes(&self) -> &[String] {
        &self.notes
    }
}

impl Drop for Live {
    fn drop(&mut self) {
        self.room.perform(Command::End);
        drop(self.server.take());
        self.room.close();
    }
}
