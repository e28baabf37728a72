//! Text from others that this program repeats: short in messages, and with terminal control characters escaped.

/// The maximum length of a quotation in a message, in characters.
pub const LONGEST_QUOTE: usize = 200;

/// Returns a text as quoted in a message: its first 200 characters, and `…` where it is longer.
pub fn excerpt(text: &str) -> String {
    let mut chars = text.chars();
    let mut short: String = chars.by_ref().take(LONGEST_QUOTE).collect();
    if chars.next().is_some() {
        short.push('…');
    }
    short
}

/// Returns another library's message with each name that it quotes between backquotes cut as by [`excerpt`].
pub fn with_short_names(message: &str) -> String {
    let pieces: Vec<_> = message.split('`').map(excerpt).collect();
    pieces.join("`")
}

/// Returns a text with the characters that a terminal would act on escaped: an escape as `\u{1b}`. Line ends and tabs
/// stay.
///
/// # Examples
/// ```
/// use shading_lab::text::escaped;
///
/// assert_eq!(escaped("a\tb\n\u{1b}[31mc"), "a\tb\n\\u{1b}[31mc");
/// ```
pub fn escaped(text: &str) -> String {
    written_out(text, |c| c.escape_unicode().to_string())
}

/// Returns JSON in which the characters that [`escaped`] escapes are JSON escapes, so that its value is unchanged.
pub fn escaped_json(json: &str) -> String {
    written_out(json, |c| format!("\\u{:04x}", u32::from(c)))
}

fn written_out(text: &str, escape: impl Fn(char) -> String) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        if "\n\t".contains(c) || !(c.is_control() || turns(c)) {
            out.push(c);
        } else {
            out += &escape(c);
        }
    }
    out
}

/// Returns whether a character separates lines or changes the direction of writing: text with it can look like
/// different text.
pub fn turns(c: char) -> bool {
    matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}
