//! Encoding of a link's characters: percent encoding for its readable part, base64url for compressed text.

/// The digits of base64url (RFC 4648, section 5), none of which browsers or messengers change.
const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

/// Percent-encodes all but plain characters. RFC 3986 allows a few more in a query; messengers end a link at some of
/// them, or interpret them as markup.
pub fn encoded(text: &str) -> String {
    let mut encoded = String::with_capacity(text.len());
    for byte in text.bytes() {
        if byte.is_ascii_alphanumeric() || b"-._,=;".contains(&byte) {
            encoded.push(char::from(byte));
        } else {
            push_encoded(&mut encoded, byte);
        }
    }
    encoded
}

/// Encodes a last character that is neither letter nor digit, which messengers take for the end of a sentence.
pub fn ended(mut text: String) -> String {
    let last = text.as_bytes().last().copied();
    if let Some(last) = last.filter(u8::is_ascii_punctuation) {
        text.pop();
        push_encoded(&mut text, last);
    }
    text
}

fn push_encoded(text: &mut String, byte: u8) {
    let digit = |value: u8| char::from(b"0123456789ABCDEF"[usize::from(value & 15)]);
    text.extend(['%', digit(byte >> 4), digit(byte)]);
}

/// Decodes a text; a plus sign is a blank, as in browsers. On failure, returns the offset of the error.
pub fn decoded(text: &str) -> Result<String, usize> {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let [first, others @ ..] = rest {
        rest = others;
        bytes.push(match first {
            b'+' => b' ',
            b'%' => {
                let at = text.len() - rest.len() - 1;
                let (pair, others) = rest.split_at_checked(2).ok_or(at)?;
                rest = others;
                let pair = std::str::from_utf8(pair).map_err(|_| at)?;
                let digits = pair.bytes().all(|byte| byte.is_ascii_hexdigit());
                u8::from_str_radix(pair, 16)
                    .ok()
                    .filter(|_| digits)
                    .ok_or(at)?
            }
            other => *other,
        });
    }
    String::from_utf8(bytes).map_err(|_| 0)
}

/// Encodes bytes as base64url without padding.
pub fn base64(bytes: &[u8]) -> String {
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for chunk in bytes.chunks(3) {
        let group = (0..3).fold(0u32, |group, at| {
            group << 8 | u32::from(chunk.get(at).copied().unwrap_or(0))
        });
        let digits = (0..=chunk.len()).map(|at| DIGITS[(group >> (18 - 6 * at) & 63) as usize]);
        text.extend(digits.map(char::from));
    }
    text
}

/// Decodes a text in base64url, with or without padding.
pub fn from_base64(text: &str) -> Option<Vec<u8>> {
    let text = text.trim_end_matches('=').as_bytes();
    let mut bytes = Vec::with_capacity(text.len() / 4 * 3 + 3);
    for chunk in text.chunks(4) {
        if chunk.len() == 1 {
            return None;
        }
        let mut group = 0u32;
        for at in 0..4 {
            let value = match chunk.get(at) {
                Some(digit) => DIGITS.iter().position(|known| known == digit)?,
                None => 0,
            };
            group = group << 6 | value as u32;
        }
        let [_, all @ ..] = group.to_be_bytes();
        bytes.extend(&all[..chunk.len() - 1]);
    }
    Some(bytes)
}

/// Returns the text after `start`, which is compared ignoring case.
pub fn after<'t>(text: &'t str, start: &str) -> Option<&'t str> {
    let (head, rest) = text.split_at_checked(start.len())?;
    head.eq_ignore_ascii_case(start).then_some(rest)
}
