//! Lessons, hand-ins and worksheets, and what other people send.

#[path = "../common/fixtures.rs"]
#[allow(dead_code, reason = "each program takes what it needs")]
#[macro_use]
mod common;

mod answers;
mod course;
mod format;
mod fuzz;
mod hand_in;
mod worksheet;
