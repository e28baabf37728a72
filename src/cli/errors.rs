//! Errors of the arguments themselves, in the chosen language.

use super::input::one_of;
use clap::Error;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use shading_lab::text::{excerpt, listed, text};
use std::error::Error as _;
use std::num::{ParseFloatError, ParseIntError};

/// Returns a sentence for an error of the arguments; none for help and the like, and for errors that no argument of
/// this program can cause, which keep clap's text.
pub fn worded(error: &Error) -> Option<String> {
    let all = |kind| match error.get(kind) {
        Some(ContextValue::String(text)) => vec![excerpt(text)],
        Some(ContextValue::Strings(texts)) => texts.iter().map(|text| excerpt(text)).collect(),
        _ => Vec::new(),
    };
    let arguments = listed(all(ContextKind::InvalidArg));
    let value = all(ContextKind::InvalidValue).concat();
    Some(match error.kind() {
        ErrorKind::InvalidValue | ErrorKind::ValueValidation if value.is_empty() => {
            text!("cli-missing-value", argument = arguments)
        }
        ErrorKind::ValueValidation => {
            let cause = error.source()?;
            let reason = if cause.is::<ParseIntError>() {
                text!("cli-expected-count").to_owned()
            } else if cause.is::<ParseFloatError>() {
                text!("cli-expected-number").to_owned()
            } else {
                cause.to_string()
            };
            text!(
                "cli-wrong-value",
                argument = arguments,
                value = value,
                reason = reason
            )
        }
        ErrorKind::InvalidValue => {
            let choices = one_of(&all(ContextKind::ValidValue));
            let reason = text!("cli-expected", choices = choices);
            text!(
                "cli-wrong-value",
                argument = arguments,
                value = value,
                reason = reason
            )
        }
        ErrorKind::UnknownArgument => {
            let meant = all(ContextKind::SuggestedArg).concat();
            let meant = (!meant.is_empty()).then(|| text!("document-did-you-mean", name = meant));
            text!(
                "cli-unknown-argument",
                argument = arguments,
                meant = meant.unwrap_or_default()
            )
        }
        ErrorKind::MissingRequiredArgument => text!("cli-missing-arguments", arguments = arguments),
        ErrorKind::ArgumentConflict => {
            let other = listed(all(ContextKind::PriorArg));
            text!("cli-conflict", argument = arguments, other = other)
        }
        _ => return None,
    })
}
