//! The program as a script and as a person in a terminal see it, and its texts.

#[path = "../common/fixtures.rs"]
#[allow(dead_code, reason = "each program takes what it needs")]
#[macro_use]
mod common;

mod analyses;
mod catalogue;
mod languages;
mod scripts;
mod shell;
