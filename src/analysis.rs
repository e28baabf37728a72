//! Analyses of a picture in numbers: questions, and answers with their reports.
//!
//! Each analysis is a module with a [`Question`] and an [`Answer`]; [`ANALYSES`] lists them. The terminal, CSV, JSON,
//! pictures and the window show any answer by its [`Report`].

pub mod bench;
pub mod codec;
pub mod comparison;
pub mod conditions;
pub mod curves;
pub mod defects;
pub mod lobe;
pub mod normals;
mod operators;
pub mod overlay;
pub mod perception;
pub mod plan;
pub(crate) mod plan_words;
pub mod probe;
pub mod profile;
mod question;
pub mod report;
pub mod sampling;
pub mod scan;
pub mod stability;
pub mod study;

pub use question::{ANALYSES, Analysis, Format, Question, Subject, Watch, unwatched};
#[doc(inline)]
pub use report::{Answer, Report, ReportContext};
