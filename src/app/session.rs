//! What is open, how it is looked at, and what can be asked of it.

pub mod action;
pub mod appearance;
pub mod document;
pub mod place;
pub mod recovery;
