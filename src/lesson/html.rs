//! HTML and SVG put together of elements. Text and the values of attributes are escaped wherever they are put in, so that nothing of a
//! lesson or a hand-in becomes markup.

use std::fmt::{self, Display, Formatter, Write as _};

/// Elements that have no content.
const VOID: [&str; 6] = ["img", "meta", "circle", "image", "path", "rect"];

/// A piece of a page.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Html(String);

impl Html {
    /// An empty piece.
    pub fn new() -> Self {
        Self::default()
    }

    /// What is HTML or SVG already: that of the Markdown parser, of a drawing, of a style sheet.
    pub fn made(markup: String) -> Self {
        Self(markup)
    }

    /// The piece with another one behind it.
    pub fn with(mut self, piece: impl Into<Self>) -> Self {
        self.0.push_str(&piece.into().0);
        self
    }

    /// The piece with another one behind it, which ends its line.
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

/// An element with its attributes and what is inside.
#[derive(Clone, Debug)]
pub struct Element {
    name: &'static str,
    attributes: String,
    inside: Html,
}

/// Returns an empty element.
pub fn element(name: &'static str) -> Element {
    Element {
        name,
        attributes: String::new(),
        inside: Html::new(),
    }
}

impl Element {
    /// The element with an attribute more.
    pub fn attribute(mut self, name: &'static str, value: impl Display) -> Self {
        let value = escaped(&value.to_string());
        let _ = write!(self.attributes, " {name}=\"{value}\"");
        self
    }

    /// The element in a class of the style sheet.
    pub fn class(self, class: &str) -> Self {
        self.attribute("class", class)
    }

    /// The element with a length more, to a tenth of a pixel.
    pub fn length(self, name: &'static str, value: f64) -> Self {
        self.attribute(name, format!("{value:.1}"))
    }

    /// The element whose content begins in a line of its own.
    pub fn broken(self) -> Self {
        self.with("\n")
    }

    /// The element with a piece more inside.
    pub fn with(mut self, piece: impl Into<Html>) -> Self {
        self.inside = self.inside.with(piece);
        self
    }

    /// The element with a piece more inside, which ends its line.
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

/// Text as HTML has it, without the control characters that XML lacks.
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
