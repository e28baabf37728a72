//! HTML and SVG built from elements. Text and the values of attributes are escaped on insertion, so that
//! nothing in a lesson or a hand-in becomes markup.

use std::fmt::{self, Display, Formatter, Write as _};

/// The elements without content.
const VOID: [&str; 8] = [
    "img", "input", "link", "meta", "circle", "image", "path", "rect",
];

/// A fragment of a page.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Html(String);

impl Html {
    /// Creates an empty fragment.
    pub fn new() -> Self {
        Self::default()
    }

    /// Wraps existing HTML or SVG: output of the Markdown parser, a drawing, a style sheet.
    pub fn made(markup: String) -> Self {
        Self(markup)
    }

    /// Appends another fragment.
    pub fn with(mut self, piece: impl Into<Self>) -> Self {
        self.0.push_str(&piece.into().0);
        self
    }

    /// Appends another fragment and ends the line.
    pub fn line(mut self, piece: impl Into<Self>) -> Self {
        self = self.with(piece);
        self.0.push('\n');
        self
    }
}

impl Display for Html {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

/// Text, escaped.
impl From<&str> for Html {
    fn from(text: &str) -> Self {
        Self(escaped(text))
    }
}

impl From<String> for Html {
    fn from(text: String) -> Self {
        Self::from(&*text)
    }
}

impl<T: Into<Self>> FromIterator<T> for Html {
    fn from_iter<I: IntoIterator<Item = T>>(pieces: I) -> Self {
        pieces.into_iter().fold(Self::new(), Self::with)
    }
}

/// An element with its attributes and its content.
#[derive(Clone, Debug)]
pub struct Element {
    name: &'static str,
    attributes: String,
    inside: Html,
}

/// Creates an empty element.
pub fn element(name: &'static str) -> Element {
    Element {
        name,
        attributes: String::new(),
        inside: Html::new(),
    }
}

impl Element {
    /// Adds an attribute.
    pub fn attribute(mut self, name: &'static str, value: impl Display) -> Self {
        let value = escaped(&value.to_string());
        let _ = write!(self.attributes, " {name}=\"{value}\"");
        self
    }

    /// Sets the class of the style sheet.
    pub fn class(self, class: &str) -> Self {
        self.attribute("class", class)
    }

    /// Adds an attribute with a length, rounded to a tenth of a pixel.
    pub fn length(self, name: &'static str, value: f64) -> Self {
        self.attribute(name, format!("{value:.1}"))
    }

    /// Breaks the line before the content.
    pub fn broken(self) -> Self {
        self.with("\n")
    }

    /// Appends a fragment to the content.
    pub fn with(mut self, piece: impl Into<Html>) -> Self {
        self.inside = self.inside.with(piece);
        self
    }

    /// Appends a fragment to the content and ends the line.
    pub fn line(mut self, piece: impl Into<Html>) -> Self {
        self.inside = self.inside.line(piece);
        self
    }
}

impl From<Element> for Html {
    fn from(element: Element) -> Self {
        let Element {
            name,
            attributes,
            inside: Html(inside),
        } = element;
        Self(if VOID.contains(&name) {
            format!("<{name}{attributes}/>")
        } else {
            format!("<{name}{attributes}>{inside}</{name}>")
        })
    }
}

/// Escapes text for HTML, and removes the control characters that XML lacks.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            c if c.is_control() && !"\n\t".contains(c) => out.push('\u{fffd}'),
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_and_attributes_are_escaped_and_elements_are_closed() {
        let image = element("img").attribute("alt", "\"<1>\"");
        let part = element("p")
            .class("quiet")
            .with("a < b & 'c'\u{1}")
            .with(image);
        let page = element("div").broken().line(part).line(element("span"));
        assert_eq!(
            Html::from(page).to_string(),
            "<div>\n<p class=\"quiet\">a &lt; b &amp; &#39;c&#39;\u{fffd}\
             <img alt=\"&quot;&lt;1&gt;&quot;\"/></p>\n<span></span>\n</div>"
        );
        let list: Html = ["a", "<b>"].into_iter().collect();
        assert_eq!(
            list,
            Html::new().with("a").with(Html::made("&lt;b&gt;".into()))
        );
    }
}
