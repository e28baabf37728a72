//! The live class: a server on the lecturer's machine, and phones in the room that follow the lecturer's step and answer its question.
//!
//! [`Room`] is the class: its students, their answers and where it is; the lecturer's [`Command`]s are calls of its, so that no message
//! from outside can be one. Each answer is a line of a [record](crate::lesson::ClassRecord), which is on the disk before the phone is told
//! so. [`Server`] puts the class on the network; [`Live`] holds what belongs together.
//!
//! # Protocol
//! All paths lie below `/CODE/`, which is random. The page's links are relative, so that it works below a proxy's prefix. Steps, rounds
//! and pictures are counted from 1. What is refused is answered with `{"error": "a sentence in the language of the class"}`.
//!
//! | request | answer |
//! |---|---|
//! | `GET ./` | the page, with the present step in it |
//! | `GET ./class.js?HASH`, `./class.css?HASH` | what the page needs; `gzip` where that is accepted, kept for a year |
//! | `GET ./lab/…` | the program's own page, where its files were found (404 with a sentence else) |
//! | `POST ./join` `{"name": "…"?}` | 200 `{"steps": 12}` and a cookie `token`; with a valid cookie it is the same student, who may take a new name |
//! | `GET ./events` | server-sent events, see below |
//! | `GET ./steps/3` | a fragment of HTML: the step with its question, and nothing of the answer; 403 for a step that the class has not come to, unless students go at their own pace |
//! | `GET ./steps/3/explanation` | a fragment of HTML; 403 unless that step is explained |
//! | `GET ./steps/3/1.png?HASH` | a picture of the step, kept for a year |
//! | `POST ./turn` `{"step": 4}` | 200 `{"step": 4}`: at their own pace students go to any step (403 where the class follows the lecturer) |
//! | `POST ./answers` `{"step": 3, "round": 1, "answer": {"choice": 0}, "sent": 1795660000000?}` | 200 `{"saved": true}` once the answer is on the disk |
//!
//! An event is `event: pace` with `data: {"step": 3, "steps": 12, "phase": "ask", "round": 1, "answered": null}`. One comes at once on
//! connecting, and one whenever something in it has changed, by the lecturer or from another tab; `event: alive` with
//! `data: 1` every 15 seconds keeps the connection. `phase` is `ask`: the question can be answered, and the answer changed; `spread`: the class's answers are on the wall;
//! `explain`: the explanation can be fetched, or the step asks nothing; `closed`: the class is over. `answered` is the student's own
//! answer to this step and round, as it was posted. Where students go at their own pace, `lecturer` is the lecturer's step and `step` the student's own; nothing
//! is explained before the lecturer has it explained. A step that the lecturer leaves and comes back to is as it was left.
//!
//! An `answer` is JSON as [`Answer`](crate::lesson::Answer) is written: its kind and what was given, the same as `kind` and `given` in a
//! hand-in. `sent` is the time by the phone's clock, in milliseconds: of several answers in a round the one sent last counts, in whatever
//! order they arrive; without it the one that arrives last.
//!
//! | refused with | because |
//! |---|---|
//! | 400 | no JSON, or an answer that does not fit the question |
//! | 401 | without a token, or with one that this class does not know: join again, with the same name |
//! | 403 | what the lecturer has not shown yet |
//! | 404 | nothing is there |
//! | 409 | the step or its round is not open; `"pace"` has the present one, as in an event |
//! | 413 | more than 64 KB |
//! | 429 | more than 10 requests a second from one student, or a rush of new ones: try again after a second |
//! | 503 | a thousand students are there |
//! | 507 | the answer could not be written to the disk: try again |
//!
//! A phone that loses its connection connects again with growing pauses; nothing else is needed, since the first event tells all.

mod address;
mod content;
mod events;
mod files;
mod limits;
mod live;
pub mod page;
mod patient;
mod record;
mod refusal;
mod rehearsal;
mod room;
mod routes;
mod server;
mod tokens;

pub use content::{Graded, Round, Spread, StepContent};
pub use files::page_folder;
pub use live::{Live, LiveOptions};
pub use record::{Commit, open_record};
pub use refusal::{OwnPace, Refusal};
pub use rehearsal::rehearse;
pub use room::{AnswerRequest, Command, Room, Snapshot, StudentRow};
pub use server::{Server, ServerOptions};
pub use tokens::Token;
