//! The known word that a mistyped one probably meant.

/// Words longer than this are not compared: no known word is near them.
const LONGEST: usize = 64;

/// The known word with the fewest changed, added, dropped or exchanged letters, if those are at most a third of the
/// word's own (and one in the shortest), or the one that the word begins.
pub fn nearest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let length = word.chars().take(LONGEST + 1).count();
    if !(1..=LONGEST).contains(&length) {
        return None;
    }
    let word = word.to_lowercase();
    let rank = |candidate: &'a str| {
        let begins = length >= 3 && candidate.starts_with(&word);
        let distance = if begins {
            1
        } else {
            strsim::osa_distance(&word, candidate)
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
