//! Options and items: their letters, and how often each was chosen.

use crate::lesson::html::{Element, Html, element};
use crate::lesson::page::inline;

/// Returns the letter of an option or an item.
pub fn letter(index: usize) -> char {
    char::from(b'A' + u8::try_from(index % 26).unwrap_or(0))
}

/// Returns an option or an item with its letter.
pub fn lettered(index: usize, options: &[String]) -> String {
    let words = options.get(index).map_or("", |words| &**words);
    format!("{}. {words}", letter(index))
}

/// Returns the HTML of an option or an item with its letter.
pub fn lettered_html(index: usize, words: &str) -> Html {
    Html::from(format!("{}. ", letter(index))).with(inline(words))
}

/// The bars of a table, which say how often each answer was given.
pub struct Bars {
    total: usize,
    table: Element,
}

impl Bars {
    /// Creates an empty table; `total` answers fill a bar.
    pub fn new(total: usize) -> Self {
        Self {
            total: total.max(1),
            table: element("table").class("bars").broken(),
        }
    }

    /// Adds a row for an answer.
    pub fn with(self, label: impl Into<Html>, count: usize, is_right: bool) -> Self {
        let (row, sign) = if is_right {
            (element("tr").class("is-right"), " ✓")
        } else {
            (element("tr"), "")
        };
        let share = 100.0 * count as f64 / self.total as f64;
        let bar = element("div").attribute("style", format!("width:{share:.1}%"));
        let row = row
            .with(element("td").with(label).with(sign))
            .with(element("td").class("bar").with(bar))
            .with(element("td").with(count.to_string()));
        Self {
            table: self.table.line(row),
            ..self
        }
    }

    /// Returns the table as HTML.
    pub fn table(self) -> Html {
        Html::new().line(self.table)
    }
}
