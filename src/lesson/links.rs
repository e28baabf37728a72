//! The links of a text that anybody may have written: to pages and letters, and to nothing else.

use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};
use std::ops::Range;

/// CommonMark as the window reads it.
const OPTIONS: Options = Options::ENABLE_TABLES
    .union(Options::ENABLE_MATH)
    .union(Options::ENABLE_TASKLISTS)
    .union(Options::ENABLE_STRIKETHROUGH)
    .union(Options::ENABLE_FOOTNOTES)
    .union(Options::ENABLE_DEFINITION_LIST);

/// Returns whether a link may lead to an address: a page of the web, or a letter. Anything else could run a script in a page, or have
/// the desktop open a file or log on to another machine.
pub fn may_open(address: &str) -> bool {
    let starts = |start: &str| {
        let head = address.get(..start.len());
        head.is_some_and(|head| head.eq_ignore_ascii_case(start))
    };
    let allowed = ["https://", "http://", "mailto:"].into_iter().any(starts);
    allowed && !address.contains(|c: char| c.is_control() || c.is_whitespace())
}

/// Returns CommonMark in which the links that may not be opened are text.
pub fn without_closed_links(text: &str) -> String {
    let is_closed = |event: &Event<'_>| matches!(event, Event::Start(Tag::Link { dest_url, .. }) if !may_open(dest_url));
    if !Parser::new_ext(text, OPTIONS).any(|event| is_closed(&event)) {
        return text.to_owned();
    }
    let mut edits: Vec<(Range<usize>, &str)> = Vec::new();
    let mut in_code = false;
    // What is inside the link at hand, if that may not be opened.
    let mut words: Option<Range<usize>> = None;
    for (event, range) in Parser::new_ext(text, OPTIONS).into_offset_iter() {
        if is_closed(&event) {
            words = Some(range.end..range.start);
            continue;
        }
        match event {
            Event::End(TagEnd::Link) => {
                if let Some(words) = words.take() {
                    let words = if words.is_empty() {
                        range.end..range.end
                    } else {
                        words
                    };
                    edits.extend([(range.start..words.start, ""), (words.end..range.end, "")]);
                }
                continue;
            }
            Event::Start(Tag::CodeBlock(_)) => in_code = true,
            Event::End(TagEnd::CodeBlock) => in_code = false,
            // Where a link has become text, brackets around it must not become a link.
            Event::Text(_) if !in_code => {
                edits.extend(brackets(text, range.clone()).map(|at| (at..at, "\\")));
            }
            _ => {}
        }
        if let Some(words) = &mut words {
            *words = words.start.min(range.start)..words.end.max(range.end);
        }
    }
    edited(text, edits)
}

/// Returns where brackets stand that nothing escapes yet.
fn brackets(text: &str, range: Range<usize>) -> impl Iterator<Item = usize> {
    let escaped = text[..range.start].ends_with('\\');
    let found = text[range.clone()].match_indices(['[', ']', '<', '>']);
    found
        .map(|(at, _)| at)
        .filter(move |at| !(*at == 0 && escaped))
        .map(move |at| range.start + at)
}

/// Returns a text with other text in the place of some of its ranges.
fn edited(text: &str, mut edits: Vec<(Range<usize>, &str)>) -> String {
    edits.sort_by_key(|(range, _)| range.start);
    let mut out = String::with_capacity(text.len());
    let mut taken = 0;
    for (range, other) in edits {
        out += text.get(taken..range.start).unwrap_or_default();
        out += other;
        taken = taken.max(range.end);
    }
    out + text.get(taken..).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pages_and_letters_may_be_opened_and_nothing_else() {
        for address in [
            "https://example.org/?a=1&b=2#c",
            "HTTP://localhost:8000",
            "mailto:a@example.org",
        ] {
            assert!(may_open(address), "{address}");
        }
        for address in [
            "javascript:alert(1)",
            "JavaScript:alert(1)",
            "java\nscript:alert(1)",
            "data:text/html,x",
            "vbscript:x",
            "file:///etc/passwd",
            "smb://host/share",
            "ssh://host",
            "blob:https://example.org/1",
            "https:javascript",
            "https://example.org/\u{1b}[31m",
            " https://example.org",
            "//example.org",
            "/etc/passwd",
            "#heading",
            "",
            "é",
        ] {
            assert!(!may_open(address), "{address}");
        }
    }

    #[test]
    fn closed_links_are_text_and_others_stay() {
        for (text, expected) in [
            ("[a](javascript:x) b", "a b"),
            ("[*a* `b`](file:///x 'title')", "*a* `b`"),
            ("[a][r] and [r]\n\n[r]: ssh://x", "a and r\n\n[r]: ssh://x"),
            ("<javascript:x>", "javascript:x"),
            ("[](javascript:x)b", "b"),
            (
                "[a](https://x.org) <https://y.org> [b](c)",
                "[a](https://x.org) <https://y.org> b",
            ),
            ("[a](x) `[b](y)` $[c]$", "a `[b](y)` $[c]$"),
            ("no link at [all] <b>", "no link at [all] <b>"),
        ] {
            assert_eq!(without_closed_links(text), expected);
        }
    }

    #[test]
    fn what_is_left_of_a_closed_link_makes_no_other() {
        for text in [
            "[[a](javascript:x)](javascript:y)",
            "[[[a](x)](javascript:y)](javascript:z)",
            "<<javascript:x>>",
            "\\[[a](x)](javascript:y) \\\\[[a](x)](javascript:y)",
            "[![a](x)](javascript:y)",
            "> [a\n> b](javascript:x)\n\n| [a](x) |\n|--|\n| [[b](y)](javascript:z) |",
            "&#91;[a](x)](javascript:y)",
        ] {
            let plain = without_closed_links(text);
            let closed = Parser::new_ext(&plain, OPTIONS)
                .any(|event| matches!(event, Event::Start(Tag::Link { dest_url, .. }) if !may_open(&dest_url)));
            assert!(!closed, "{text} became {plain}");
        }
    }
}
