//! Options and items: their letters, and how often each was chosen.

use crate::lesson::page::inline;

/// Returns the letter of an option or an item.
pub fn letter(index: usize) -> char {
    char::from(b'A' + u8::try_from(index % 26).unwrap_or(0))
}

/// Returns an option or an item with its letter.
pub fn lettered(index: usize, options: &[String]) -> String {
    let words = options.get(index).map_or("", |words| &**words);
    format!("{} {words}", letter(index))
}

/// Returns the HTML of an option or an item with its letter.
pub fn lettered_html(index: usize, words: &str) -> String {
    format!("{} {}", letter(index), inline(words))
}

/// The bars of a table, which say how often each answer was given.
pub struct Bars {
    total: usize,
    rows: String,
}

impl Bars {
    /// An empty table; `total` answers fill a bar.
    pub fn new(total: usize) -> Self {
        Self {
            total: total.max(1),
            rows: String::new(),
        }
    }

    /// Adds an answer; `label` is HTML.
    pub fn add(&mut self, label: &str, count: usize, is_right: bool) {
        let (class, sign) = if is_right {
            (" class=\"is-right\"", " ✓")
        } else {
            ("", "")
        };
        let share = 100.0 * count as f64 / self.total as f64;
        self.rows += &format!(
            "<tr{class}><td>{label}{sign}</td><td class=\"bar\"><div style=\"width:{share:.1}%\"></div></td><td>{count}</td></tr>\n"
        );
    }

    /// Returns the table as HTML.
    pub fn table(&self) -> String {
        format!("<table class=\"bars\">\n{}</table>\n", self.rows)
    }
}
