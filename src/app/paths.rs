//! Names of files as they are typed.

use std::path::Path;

/// Gives a path that ends neither in `usual` nor in one of `others` the usual ending.
pub fn complete_path(path: &mut String, usual: &str, others: &[&str]) {
    let trimmed = path.trim();
    let known = Path::new(trimmed)
        .extension()
        .is_some_and(|ending| [usual].iter().chain(others).any(|known| ending.eq_ignore_ascii_case(known)));
    let folder = trimmed.ends_with(std::path::is_separator);
    *path = if known || folder { trimmed.to_owned() } else { format!("{trimmed}.{usual}") };
}
