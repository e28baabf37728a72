//! Lessons, hand-ins and worksheets, and input from other people.

#[path = "../common/fixtures.rs"]
#[allow(dead_code, reason = "each program takes what it needs")]
#[macro_use]
mod common;

mod answers;
mod course;
mod format;
mod formula;
mod fuzz;
mod hand_in;
mod inventory;
mod models;
mod mutations;
#[cfg(feature = "class")]
mod phone;
mod worksheet;
