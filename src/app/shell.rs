//! The shell around the picture: bars, menus, dialogs and messages, and the commands that they share with the
//! keys.

pub mod bars;
pub mod code;
pub mod commands;
pub mod dialog;
pub mod dialogs;
pub mod embed;
pub mod equation;
pub mod files;
pub mod film;
pub(super) mod find;
pub mod layout;
pub mod lessons;
pub mod links;
pub mod menu;
pub mod notice;
pub mod state;
#[cfg(feature = "class")]
pub mod teaching;
pub mod terms;
pub mod toast;
pub mod welcome;
