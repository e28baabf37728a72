//! The search for the known word that a mistyped one probably meant.

use crate::text::text;

/// The longest word that is compared: no known word is near longer ones.
const LONGEST: usize = 64;

/// Returns the known word with the fewest changed, added, dropped or exchanged letters, if those are at most a third of the
/// word's own (and one in the shortest), or else the known word that begins with this one.
pub fn nearest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let length = word.chars().take(LONGEST + 1).count();
    if !(1..=LONGEST).contains(&length) {
        return None;
    }
    let word = word.to_lowercase();
    let rank = |candidate: &'a str| {
        let begins = length >= 3 && candidate.to_lowercase().starts_with(&word);
        let distance = if begins {
            1
        } else {
            strsim::osa_distance(&word, &candidate.to_lowercase())
        };
        (distance <= (length / 3).max(1) && distance < candidate.chars().count())
            .then_some((distance, candidate))
    };
    known
        .into_iter()
        .filter_map(rank)
        .min_by_key(|&(distance, _)| distance)
        .map(|(_, candidate)| candidate)
}

/// Returns words to append to an unknown word that suggest the known one that was probably meant; empty if there is none.
pub fn did_you_mean<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    nearest(word, known)
        .map(|meant| text!("document-did-you-mean", name = meant))
        .unwrap_or_default()
}
