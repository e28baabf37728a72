//! The known word that a mistyped one probably meant.

/// Words longer than this are not compared: no known word is near them.
const LONGEST: usize = 64;

/// The known word with the fewest changed, added, dropped or exchanged letters, if those are at most a third of the
/// word's own (and one in the shortest), or the one that the word begins.
pub fn nearest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let word: Vec<char> = word.chars().take(LONGEST + 1).flat_map(char::to_lowercase).collect();
    if word.is_empty() || word.len() > LONGEST {
        return None;
    }
    let allowed = (word.len() / 3).max(1);
    let rank = |candidate: &'a str| {
        let letters: Vec<char> = candidate.chars().collect();
        let begins = word.len() >= 3 && letters.starts_with(&word);
        let distance = if begins { 1 } else { distance(&word, &letters) };
        (distance <= allowed && distance < letters.len()).then_some((distance, candidate))
    };
    known.into_iter().filter_map(rank).min_by_key(|&(distance, _)| distance).map(|(_, candidate)| candidate)
}

/// Optimal string alignment distance (Damerau 1964, Levenshtein 1966) by rows.
fn distance(a: &[char], b: &[char]) -> usize {
    let mut before: Vec<usize> = Vec::new();
    let mut above: Vec<usize> = (0..=b.len()).collect();
    for (i, &x) in a.iter().enumerate() {
        let mut row = vec![i + 1];
        for (j, &y) in b.iter().enumerate() {
            let mut least = (above[j] + usize::from(x != y)).min(above[j + 1] + 1).min(row[j] + 1);
            if i > 0 && j > 0 && x == b[j - 1] && a[i - 1] == y {
                least = least.min(before[j - 1] + 1);
            }
            row.push(least);
        }
        before = std::mem::replace(&mut above, row);
    }
    above[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chars(text: &str) -> Vec<char> {
        text.chars().collect()
    }

    #[test]
    fn each_kind_of_slip_counts_once() {
        for (a, b, expected) in
            [("phong", "phong", 0), ("phng", "phong", 1), ("phonng", "phong", 1), ("pohng", "phong", 1), ("", "abc", 3)]
        {
            assert_eq!(distance(&chars(a), &chars(b)), expected, "{a} {b}");
        }
    }

    #[test]
    fn the_nearest_word_is_found_and_a_distant_one_is_not() {
        let known = ["flat", "interpolated", "gouraud", "phong", "exact"];
        assert_eq!(nearest("gouraux", known), Some("gouraud"));
        assert_eq!(nearest("Pohng", known), Some("phong"));
        assert_eq!(nearest("inter", known), Some("interpolated"));
        assert_eq!(nearest("toon", known), None);
        assert_eq!(nearest("", known), None);
        assert_eq!(nearest("x", ["k"]), None);
        assert_eq!(nearest(&"p".repeat(1 << 20), known), None);
    }
}
