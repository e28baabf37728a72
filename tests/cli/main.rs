//! The command line and its texts, for scripts and for people in a terminal.

#[path = "../common/fixtures.rs"]
#[allow(dead_code, reason = "each program takes what it needs")]
#[macro_use]
mod common;

mod analyses;
mod catalogue;
#[cfg(feature = "class")]
mod class;
mod languages;
mod scripts;
mod shell;
