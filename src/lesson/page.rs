//! Parts of a self-contained HTML page: text, formulas and pictures. Everything from a lesson or a hand-in is
//! escaped, and the page loads nothing.

use super::html::{Html, element};
use super::links::may_open;
use crate::document::picture_bytes;
use crate::figure::{Base, Formula, Item, is_italic};
use crate::link::base64;
use crate::render::Frame;
use crate::text::language;
use pulldown_cmark::{CowStr, Event, Options, Parser, Tag, TagEnd, html};

/// The page's security policy: it may use its own styles and pictures, and nothing else.
const POLICY: &str = "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'\"/>";

/// Returns a page; `style` is CSS.
pub fn page(title: &str, style: &str, body: Html) -> String {
    let viewport = element("meta")
        .attribute("name", "viewport")
        .attribute("content", "width=device-width, initial-scale=1");
    let style = format!("\n{COMMON}{style}");
    let head = element("head")
        .broken()
        .line(element("meta").attribute("charset", "utf-8"))
        .line(viewport)
        .line(Html::made(POLICY.to_owned()))
        .line(element("title").with(title))
        .line(element("style").with(Html::made(style)));
    let page = element("html")
        .attribute("lang", language().tag())
        .broken()
        .line(head)
        .line(element("body").broken().with(body));
    format!("<!DOCTYPE html>\n{}\n", Html::from(page))
}

const COMMON: &str = "\
@page { size: auto; margin: 16mm 17mm; }
* { box-sizing: border-box; }
body { font: 11pt/1.45 'Noto Sans', 'Helvetica Neue', Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', sans-serif;
  color: #1a1a1a; background: #fff; max-width: 190mm; margin: 0 auto; padding: 6mm; }
body:lang(zh) { font-family: 'Noto Sans', 'Helvetica Neue', Helvetica, Arial, 'Noto Sans CJK TC', 'Noto Sans TC', 'PingFang TC', 'Microsoft JhengHei', sans-serif; }
h1 { font-size: 19pt; line-height: 1.2; margin: 0 0 1mm; }
h2 { font-size: 13pt; line-height: 1.3; margin: 0 0 2mm; break-after: avoid; }
h3 { font-size: 11pt; margin: 3mm 0 1mm; break-after: avoid; }
p, ul, ol { margin: 0 0 2.2mm; }
ul, ol { padding-left: 6mm; }
table { border-collapse: collapse; margin: 0 0 3mm; }
th, td { border: 0.3mm solid #b5b5b5; padding: 0.8mm 2mm; text-align: left; vertical-align: top; }
th { background: #f0f0f0; }
code { font-family: 'DejaVu Sans Mono', Menlo, Consolas, monospace; font-size: 0.9em; }
sub, sup { font-size: 0.72em; line-height: 0; }
.formula { white-space: nowrap; font-family: 'Noto Serif', 'Times New Roman', Georgia, 'Noto Serif CJK TC', serif; font-size: 1.06em; }
:lang(zh) em { font-style: normal; font-weight: bold; }
figure { margin: 0; break-inside: avoid; }
figcaption { font-size: 9pt; color: #555; }
svg { display: block; max-width: 100%; height: auto; overflow: visible; }
svg text { font-family: inherit; fill: #1a1a1a; }
.quiet { color: #555; }
@media print { body { max-width: none; padding: 0; } }
";

/// Converts CommonMark with formulas to HTML.
pub fn blocks(text: &str) -> Html {
    made_of(events(text))
}

fn made_of(events: Vec<Event<'_>>) -> Html {
    let mut out = String::new();
    html::push_html(&mut out, events.into_iter());
    Html::made(out)
}

/// Converts CommonMark of one paragraph to HTML without the paragraph's tags; anything more is treated as
/// plain text.
pub fn inline(text: &str) -> Html {
    let mut events = events(text);
    let paragraph = |event: &Event<'_>| matches!(event, Event::Start(Tag::Paragraph));
    let only = |event: &Event<'_>| {
        let block = matches!(event, Event::Start(tag) if !matches!(tag, Tag::Paragraph | Tag::Emphasis | Tag::Strong | Tag::Link { .. }));
        !block && !matches!(event, Event::Rule)
    };
    if !events.iter().all(only) || events.iter().filter(|event| paragraph(event)).count() > 1 {
        return with_formulas(text);
    }
    events.retain(|event| !paragraph(event) && !matches!(event, Event::End(TagEnd::Paragraph)));
    made_of(events)
}

/// Returns the parts of a text without raw HTML, pictures, and links that may not be opened.
fn events(text: &str) -> Vec<Event<'_>> {
    let mut kept_links = Vec::new();
    let plain = |c: char| !c.is_control() || "\n\t".contains(c);
    Parser::new_ext(text, Options::ENABLE_TABLES | Options::ENABLE_MATH)
        .filter_map(|event| match event {
            Event::Html(html) | Event::InlineHtml(html) => Some(Event::Text(html)),
            Event::Start(Tag::HtmlBlock) => Some(Event::Start(Tag::Paragraph)),
            Event::End(TagEnd::HtmlBlock) => Some(Event::End(TagEnd::Paragraph)),
            Event::InlineMath(inside) | Event::DisplayMath(inside) => {
                Some(Event::InlineHtml(formula(&inside).to_string().into()))
            }
            Event::Code(inside) => Some(
                match inside
                    .strip_prefix('$')
                    .and_then(|inside| inside.strip_suffix('$'))
                {
                    Some(inside) => Event::InlineHtml(formula(inside).to_string().into()),
                    None => Event::Code(inside),
                },
            ),
            Event::Start(Tag::Image { .. }) | Event::End(TagEnd::Image) => None,
            Event::Start(Tag::Link { ref dest_url, .. }) => {
                let kept = may_open(dest_url);
                kept_links.push(kept);
                kept.then_some(event)
            }
            Event::End(TagEnd::Link) => kept_links.pop().unwrap_or(false).then_some(event),
            event => Some(event),
        })
        .map(|event| match event {
            Event::Text(text) if !text.chars().all(plain) => {
                let text: String = text
                    .chars()
                    .map(|c| if plain(c) { c } else { '\u{fffd}' })
                    .collect();
                Event::Text(CowStr::from(text))
            }
            event => event,
        })
        .collect()
}

/// Converts plain text to HTML; only the text between dollar signs is set as formulas.
fn with_formulas(text: &str) -> Html {
    let pieces = text.split('$').enumerate();
    let set = |(index, piece): (usize, &str)| match index % 2 {
        1 => formula(piece),
        _ => piece.replace('`', "").into(),
    };
    pieces.map(set).collect()
}

/// Converts a formula to HTML: `K_d` with a subscript, `(R·V)^n` with a superscript; single letters are
/// italic.
fn formula(text: &str) -> Html {
    let inside = set(&Formula::read_or_verbatim(text));
    element("span").class("formula").with(inside).into()
}

fn set(formula: &Formula) -> Html {
    let items = formula.items.iter();
    let set = |Item { base, low, high }: &Item| {
        let base = match base {
            Base::Name(name) if is_italic(name) => element("i").with(&**name).into(),
            Base::Name(text) | Base::Signs(text) => Html::from(&**text),
            Base::Group(inside) => set(inside),
        };
        let scripts = [("sub", low), ("sup", high)].into_iter();
        let scripts = scripts.filter(|(_, script)| !script.is_empty());
        scripts.fold(base, |html, (name, script)| {
            html.with(element(name).with(set(script)))
        })
    };
    items.map(set).collect()
}

/// Returns a picture inside the page; `words` describes it.
pub fn picture(frame: &Frame, words: &str) -> Html {
    element("img")
        .attribute("src", data(frame))
        .attribute("width", frame.width)
        .attribute("height", frame.height)
        .attribute("alt", words)
        .into()
}

/// Returns a white pixel as a placeholder for a picture.
pub fn blank_picture() -> Frame {
    Frame {
        width: 1,
        height: 1,
        pixels: vec![[0xff; 4]],
    }
}

/// Returns a picture as a data URL.
pub fn data(frame: &Frame) -> String {
    let bytes = picture_bytes(frame, None).unwrap_or_default();
    let mut text = base64(&bytes).replace('-', "+").replace('_', "/");
    while !text.len().is_multiple_of(4) {
        text.push('=');
    }
    format!("data:image/png;base64,{text}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lesson::LESSONS;
    use crate::text::Language;

    #[test]
    fn formulas_have_letters_above_and_below_the_line() {
        for (text, expected) in [
            (
                "K_d·cos^2 θ",
                "<i>K</i><sub><i>d</i></sub>·cos<sup>2</sup> <i>θ</i>",
            ),
            ("e^{-1/2}<", "<i>e</i><sup>−1/2</sup>&lt;"),
            ("x^12", "<i>x</i><sup>1</sup>2"),
            ("ΔI_P", "Δ<i>I</i><sub><i>P</i></sub>"),
            ("<x_", "&lt;x_"),
        ] {
            assert_eq!(
                formula(text).to_string(),
                format!("<span class=\"formula\">{expected}</span>")
            );
        }
    }

    #[test]
    fn every_formula_of_the_lessons_is_read_and_painted_whole() {
        let mut count = 0;
        for lesson in &LESSONS {
            for source in Language::ALL.map(|language| lesson.source(language)) {
                for text in source.split('$').skip(1).step_by(2) {
                    let read =
                        Formula::read(text).unwrap_or_else(|| panic!("{}: {text}", lesson.name));
                    let painted = formula(text)
                        .to_string()
                        .replace("<sup>", "^")
                        .replace("&lt;", "<")
                        .replace("&#39;", "'");
                    let mut plain = String::new();
                    for piece in painted.split('<') {
                        plain.push_str(piece.split_once('>').map_or(piece, |(_, words)| words));
                    }
                    assert_eq!(plain, read.to_string(), "{text}");
                    count += 1;
                }
            }
        }
        assert!(count > 300, "{count} formulas");
    }

    #[test]
    fn markup_of_others_is_text() {
        for text in [
            "<script>alert(1)</script>",
            "a <img src=x onerror=alert(1)> b",
            "<!-- x -->",
            "<div onclick='x'>\n\n*a*",
        ] {
            for html in [blocks(text), inline(text)].map(|html| html.to_string()) {
                assert!(
                    !html.contains("<script")
                        && !html.contains("<img")
                        && !html.contains("<!--")
                        && !html.contains("<div"),
                    "{html}"
                );
            }
        }
        assert_eq!(
            inline("[a](javascript:alert(1)) [b](https://x.org/)").to_string(),
            "a <a href=\"https://x.org/\">b</a>"
        );
        assert_eq!(inline("![alt](https://x.org/x.png)").to_string(), "alt");
        assert_eq!(
            inline("`$N$` is *unit*: $|N| = 1$, `code`").to_string(),
            "<span class=\"formula\"><i>N</i></span> is <em>unit</em>: <span class=\"formula\">|<i>N</i>| = 1</span>, <code>code</code>"
        );
    }
}
