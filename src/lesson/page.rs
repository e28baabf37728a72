//! Parts of a page in HTML that stands alone: text, formulas, pictures and axes. Nothing of a lesson or a hand-in gets into it
//! unescaped, and the page loads nothing.

use super::links::may_open;
use crate::document::picture_bytes;
use crate::figure::{Axis, Base, Formula, Item, is_italic, ticks};
use crate::link::base64;
use crate::render::Frame;
use crate::text::language;
use pulldown_cmark::{CowStr, Event, Options, Parser, Tag, TagEnd, html};
use std::fmt::Write as _;

/// A page; `title` is text, `style` and `body` are CSS and HTML.
pub fn page(title: &str, style: &str, body: &str) -> String {
    let (language, title) = (language().tag(), escaped(title));
    format!(
        "<!DOCTYPE html>\n<html lang=\"{language}\">\n<head>\n<meta charset=\"utf-8\"/>\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'\"/>\n\
         <title>{title}</title>\n<style>\n{COMMON}{style}</style>\n</head>\n<body>\n{body}</body>\n</html>\n"
    )
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
figure { margin: 0; break-inside: avoid; }
figcaption { font-size: 9pt; color: #555; }
svg { display: block; max-width: 100%; height: auto; }
svg text { font-family: inherit; fill: #1a1a1a; }
.quiet { color: #555; }
@media print { body { max-width: none; padding: 0; } }
";

/// Text as HTML.
pub fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            // XML has no other control characters.
            c if c.is_control() && !"\n\t".contains(c) => out.push('\u{fffd}'),
            c => out.push(c),
        }
    }
    out
}

/// CommonMark with formulas as HTML.
pub fn blocks(text: &str) -> String {
    let mut out = String::new();
    html::push_html(&mut out, events(text).into_iter());
    out
}

/// CommonMark of one paragraph, without the paragraph; what is more than that is plain text.
pub fn inline(text: &str) -> String {
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
    let mut out = String::new();
    html::push_html(&mut out, events.into_iter());
    out
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
                Some(Event::InlineHtml(formula(&inside).into()))
            }
            Event::Code(inside) => Some(
                match inside
                    .strip_prefix('$')
                    .and_then(|inside| inside.strip_suffix('$'))
                {
                    Some(inside) => Event::InlineHtml(formula(inside).into()),
                    None => Event::Code(inside),
                },
            ),
            Event::Start(Tag::Image { .. }) | Event::End(TagEnd::Image) => None,
            Event::Start(Tag::Link { ref dest_url, .. }) => {
                kept_links.push(may_open(dest_url));
                kept_links.last().copied().unwrap_or(false).then_some(event)
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

/// Plain text in which only what stands between dollar signs is set.
fn with_formulas(text: &str) -> String {
    let mut out = String::new();
    for (index, piece) in text.split('$').enumerate() {
        if index % 2 == 1 {
            out.push_str(&formula(piece));
        } else {
            out.push_str(&escaped(&piece.replace('`', "")));
        }
    }
    out
}

/// Returns a formula as HTML: `K_d` with its letter below the line, `(R·V)^n` with its exponent above it; single letters lean.
fn formula(text: &str) -> String {
    let mut out = "<span class=\"formula\">".to_owned();
    set(&Formula::read_or_verbatim(text), &mut out);
    out.push_str("</span>");
    out
}

fn set(formula: &Formula, out: &mut String) {
    for Item { base, low, high } in &formula.items {
        match base {
            Base::Name(name) if is_italic(name) => _ = write!(out, "<i>{name}</i>"),
            Base::Name(text) | Base::Signs(text) => out.push_str(&escaped(text)),
            Base::Group(inside) => set(inside, out),
        }
        for (tag, script) in [("sub", low), ("sup", high)] {
            if !script.is_empty() {
                let _ = write!(out, "<{tag}>");
                set(script, out);
                let _ = write!(out, "</{tag}>");
            }
        }
    }
}

/// A picture inside the page; `words` says what it shows.
pub fn picture(frame: &Frame, words: &str) -> String {
    let [width, height] = [frame.width, frame.height];
    let (address, words) = (data(frame), escaped(words));
    format!("<img src=\"{address}\" width=\"{width}\" height=\"{height}\" alt=\"{words}\"/>")
}

/// The address of a picture that contains it.
pub fn data(frame: &Frame) -> String {
    let bytes = picture_bytes(frame, None).unwrap_or_default();
    let mut text = base64(&bytes).replace('-', "+").replace('_', "/");
    while !text.len().is_multiple_of(4) {
        text.push('=');
    }
    format!("data:image/png;base64,{text}")
}

/// Axes to draw curves over.
pub struct Axes {
    pub x: [f64; 2],
    pub y: [f64; 2],
    /// As HTML has them.
    pub x_name: String,
    pub y_name: String,
}

/// Size of the axes' field, and what stands to the left and below.
const FIELD: [f64; 2] = [520.0, 280.0];
const LEFT: f64 = 62.0;
const BELOW: f64 = 44.0;

impl Axes {
    /// With curves over them: their points and the attributes of their lines. The curves may leave the field; what is outside
    /// is not seen.
    pub fn svg(&self, curves: &[(Vec<[f64; 2]>, &str)]) -> String {
        let [width, height] = FIELD;
        let axis = |[low, high]: [f64; 2]| Axis {
            name: String::new(),
            low,
            high,
            degrees: false,
            decades: false,
        };
        let mut svg = format!(
            "<svg viewBox=\"{} -12 {} {}\" width=\"{}\" role=\"img\" fill=\"none\">\n",
            -LEFT,
            width + LEFT + 16.0,
            height + BELOW + 16.0,
            width + LEFT + 16.0,
        );
        for (value, words) in ticks(&axis(self.x), 10.0) {
            let [x, _] = self.place([value, self.y[0]]);
            let _ = writeln!(
                svg,
                "<path d=\"M{x:.1} 0V{height}\" stroke=\"#d8d8d8\"/><text x=\"{x:.1}\" y=\"{}\" font-size=\"13\" text-anchor=\"middle\">{}</text>",
                height + 16.0,
                escaped(&words)
            );
        }
        for (value, words) in ticks(&axis(self.y), 6.0) {
            let [_, y] = self.place([self.x[0], value]);
            let _ = writeln!(
                svg,
                "<path d=\"M0 {y:.1}H{width}\" stroke=\"#d8d8d8\"/><text x=\"-6\" y=\"{:.1}\" font-size=\"13\" text-anchor=\"end\">{}</text>",
                y + 4.5,
                escaped(&words)
            );
        }
        let _ = write!(
            svg,
            "<rect width=\"{width}\" height=\"{height}\" stroke=\"#555\"/>\n\
             <text x=\"{}\" y=\"{}\" font-size=\"13\" text-anchor=\"middle\">{}</text>\n\
             <text transform=\"translate(-46 {}) rotate(-90)\" font-size=\"13\" text-anchor=\"middle\">{}</text>\n",
            width / 2.0,
            height + 36.0,
            self.x_name,
            height / 2.0,
            self.y_name
        );
        for (points, attributes) in curves {
            let mut path = String::new();
            let mut pen = 'M';
            for point in points {
                if point[1].is_nan() {
                    pen = 'M';
                    continue;
                }
                let [x, y] = self.place(*point);
                let _ = write!(path, "{pen}{x:.1} {:.1}", y.clamp(-8.0, height + 8.0));
                pen = 'L';
            }
            if !path.is_empty() {
                let _ = writeln!(svg, "<path d=\"{path}\" {attributes}/>");
            }
        }
        svg + "</svg>\n"
    }

    fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let share = |value: f64, [low, high]: [f64; 2]| (value - low) / (high - low);
        let [width, height] = FIELD;
        [width * share(x, self.x), height * (1.0 - share(y, self.y))]
    }
}

/// A name beside an axis: SVG has no sub and sup, and shows formulas as plain text.
pub fn axis_name(text: &str) -> String {
    escaped(&text.replace(['$', '`'], ""))
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
                formula(text),
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
            for html in [blocks(text), inline(text)] {
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
            inline("[a](javascript:alert(1)) [b](https://x.org/)"),
            "a <a href=\"https://x.org/\">b</a>"
        );
        assert_eq!(inline("![alt](https://x.org/x.png)"), "alt");
        assert_eq!(
            inline("`$N$` is *unit*: $|N| = 1$, `code`"),
            "<span class=\"formula\"><i>N</i></span> is <em>unit</em>: <span class=\"formula\">|<i>N</i>| = 1</span>, <code>code</code>"
        );
    }
}
