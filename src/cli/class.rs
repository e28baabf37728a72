//! `class`: a live class about a lesson, with a window or without one.

use super::input::whole;
use super::lesson::open;
use super::output::{Failure, note, print_json};
use clap::Args;
use serde_json::{Value, json};
use shading_lab::class::{
    Command, Live, LiveOptions, ServerOptions, Snapshot, Spread, page_folder,
};
use shading_lab::lesson::{Pace, answer_parts};
use shading_lab::text::{excerpt, text};
use std::io::{BufRead, stdin};
use std::net::{IpAddr, Ipv4Addr};
use std::path::PathBuf;
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::Duration;

/// The time between two looks at the class.
const TICK: Duration = Duration::from_millis(100);
/// The most simulated students.
const MOST: u32 = 500;
/// The records of classes, and of rehearsals, where none is named.
const RECORD: &str = "class.jsonl";
const REHEARSAL: &str = "rehearsal.jsonl";

#[derive(Args)]
pub struct ClassCommand {
    #[arg(value_name = "LESSON")]
    lesson: PathBuf,
    #[arg(long)]
    headless: bool,
    #[arg(long, value_name = "PORT", value_parser = whole::<u16>(0..=65535))]
    port: Option<u16>,
    #[arg(long, value_name = "ADDRESS", value_parser = parse_address, default_value_t = IpAddr::V4(Ipv4Addr::UNSPECIFIED))]
    bind: IpAddr,
    #[arg(long, value_name = "BASE", value_parser = shading_lab::link::page)]
    url: Option<String>,
    #[arg(short, long, value_name = "FILE.jsonl")]
    output: Option<PathBuf>,
    #[arg(long, value_name = "FOLDER")]
    page: Option<PathBuf>,
    #[arg(long)]
    own_pace: bool,
    #[arg(long, value_name = "N", value_parser = whole::<usize>(1..=MOST))]
    rehearse: Option<usize>,
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
}

fn parse_address(text: &str) -> Result<IpAddr, String> {
    let expected = |_| text!("cli-expected-address").to_owned();
    text.parse().map_err(expected)
}

impl ClassCommand {
    pub fn run(self) -> Result<(), Failure> {
        let lesson = open(&self.lesson)?;
        if lesson.steps.iter().all(|step| step.question.is_none()) {
            return Err(Failure::input(text!("live-asks-nothing")));
        }
        let record = match self.rehearse {
            Some(_) => REHEARSAL,
            None => RECORD,
        };
        let options = LiveOptions {
            record: self.output.unwrap_or_else(|| record.into()),
            server: ServerOptions {
                bind: self.bind,
                port: self.port,
                page: self.page.or_else(page_folder),
            },
            url: self.url,
            own_pace: self.own_pace,
            rehearse: self.rehearse.unwrap_or(0),
            seed: self.seed,
        };
        let live = Live::start(lesson.clone(), &options).map_err(Failure::input)?;
        for words in live.notes() {
            note(words);
        }
        if self.headless {
            return headless(&live, &options);
        }
        window(lesson, live, self.seed)
    }
}

/// Opens the window of a class; when it is closed the class is over.
#[cfg(feature = "app")]
fn window(lesson: shading_lab::lesson::Lesson, live: Live, seed: u64) -> Result<(), Failure> {
    use shading_lab::{app, document, scene::presets};
    super::output::print(&format!("{}\n", live.address()))?;
    let loaded = document::load_scene(std::path::Path::new(presets::DEFAULT))?;
    let start = app::Start {
        loaded,
        lesson: Some(lesson),
        seed: Some(seed),
        language: Some(text::language()),
        page: None,
        fresh: false,
        class: Some(live),
    };
    app::run(start).map_err(Failure::work)
}

#[cfg(not(feature = "app"))]
fn window(_: shading_lab::lesson::Lesson, _: Live, _: u64) -> Result<(), Failure> {
    Err(Failure::work(text!("cli-no-window")))
}

/// Prints what happens, a JSON object a line, and does what is typed, until the class is over.
fn headless(live: &Live, options: &LiveOptions) -> Result<(), Failure> {
    let room = live.room();
    tell(&json!({
        "event": "open",
        "address": live.address(),
        "port": live.listens_at().port(),
        "lesson": room.lesson().name,
        "steps": room.lesson().steps.len(),
        "record": options.record,
        "lab": live.has_lab(),
    }))?;
    let typed = typed();
    let mut last: Option<Snapshot> = None;
    loop {
        let now = room.snapshot();
        if last.as_ref().is_none_or(|last| last.version != now.version) {
            events(last.as_ref(), &now).iter().try_for_each(tell)?;
            last = Some(now);
        }
        match typed.recv_timeout(TICK) {
            Ok(Ok(Command::End)) => return Ok(()),
            Ok(Ok(command)) => {
                if !room.perform(command) {
                    note(text!("live-not-now"));
                }
            }
            Ok(Err(word)) => note(&text!("live-no-command", word = word)),
            Err(RecvTimeoutError::Timeout) => {}
            // Nobody types any more: the class goes on until the process ends.
            Err(RecvTimeoutError::Disconnected) => std::thread::sleep(TICK),
        }
    }
}

/// Reads what is typed: a word a line.
fn typed() -> Receiver<Result<Command, String>> {
    let (sender, typed) = channel();
    std::thread::spawn(move || {
        for line in stdin().lock().lines().map_while(Result::ok) {
            let command = match line.trim() {
                "" => continue,
                "show" => Ok(Command::ShowAnswers),
                "again" => Ok(Command::AskAgain),
                "explain" => Ok(Command::Explain),
                "next" => Ok(Command::Next),
                "back" => Ok(Command::Back),
                "end" => Ok(Command::End),
                word => Err(excerpt(word)),
            };
            if sender.send(command).is_err() {
                return;
            }
        }
    });
    typed
}

fn tell(event: &Value) -> Result<(), Failure> {
    print_json(&format!("{event}\n"))
}

/// Returns what has happened between two looks.
fn events(last: Option<&Snapshot>, now: &Snapshot) -> Vec<Value> {
    let mut events = Vec::new();
    let people = |snapshot: &Snapshot| (snapshot.joined, snapshot.connected);
    if last.map_or((0, 0), people) != people(now) {
        events.push(json!({ "event": "joined", "joined": now.joined, "connected": now.connected }));
    }
    let Pace { step, phase, round } = now.pace;
    let gone_on = last.is_none_or(|last| last.pace != now.pace);
    if gone_on {
        events.push(json!({ "event": "step", "step": step, "phase": phase, "round": round }));
    }
    if gone_on || last.is_none_or(|last| last.answered != now.answered) {
        events.push(json!({
            "event": "answered", "step": step, "round": round, "answered": now.answered, "joined": now.joined,
        }));
    }
    let shown = last.is_some_and(|last| last.spread.is_some()) && !gone_on;
    if let Some(spread) = now.spread.as_ref().filter(|_| !shown) {
        events.push(shown_answers(spread));
    }
    if let Some(problem) = &now.problem
        && last.is_none_or(|last| last.problem.as_ref() != Some(problem))
    {
        events.push(json!({ "event": "problem", "step": step, "why": problem }));
    }
    events
}

/// Returns the answers of the class, round by round.
fn shown_answers(spread: &Spread) -> Value {
    let rounds = spread.rounds.iter().map(|round| {
        let answers = round.answers.iter().map(|graded| {
            let (kind, given) = answer_parts(&graded.answer);
            json!({
                "student": graded.student, "kind": kind, "given": given,
                "right": graded.grade.right, "model": graded.grade.model,
            })
        });
        let models = round.models().into_iter();
        let models = models.map(|(model, count)| json!({ "model": model, "count": count }));
        json!({
            "answered": round.answers.len(),
            "right": round.right(),
            "models": models.collect::<Vec<_>>(),
            "answers": answers.collect::<Vec<_>>(),
        })
    });
    json!({ "event": "shown", "step": spread.step, "rounds": rounds.collect::<Vec<_>>() })
}
