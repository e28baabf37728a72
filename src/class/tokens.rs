//! Secrets: a student's token, and the class's part of the address. Both come from the system's random source.

use std::fmt;

/// The letters of a code: none that looks like another one.
const LETTERS: &[u8; 31] = b"23456789abcdefghjkmnpqrstuvwxyz";
/// The length of a code.
const CODE: usize = 6;

/// The secret by which a student's phone is known.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct Token(u128);

impl Token {
    /// Creates a random token.
    ///
    /// # Errors
    /// The system has no random numbers.
    pub fn new() -> Result<Self, String> {
        let mut bytes = [0; 16];
        getrandom::fill(&mut bytes).map_err(|error| error.to_string())?;
        Ok(Self(u128::from_le_bytes(bytes)))
    }

    /// Reads a token: 32 hexadecimal digits.
    pub fn read(text: &str) -> Option<Self> {
        let digit = |byte: u8| matches!(byte, b'0'..=b'9' | b'a'..=b'f');
        let sound = text.len() == 32 && text.bytes().all(digit);
        sound.then(|| u128::from_str_radix(text, 16).ok().map(Self))?
    }
}

impl fmt::Display for Token {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:032x}", self.0)
    }
}

/// Hides the secret from messages.
impl fmt::Debug for Token {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Token")
    }
}

/// Returns a new code for a class's address.
///
/// # Errors
/// The system has no random numbers.
pub fn code() -> Result<String, String> {
    let mut bytes = [0; 4 * CODE];
    getrandom::fill(&mut bytes).map_err(|error| error.to_string())?;
    let (numbers, _) = bytes.as_chunks();
    let letters = numbers.iter().map(|number| {
        let index = u32::from_le_bytes(*number) as usize % LETTERS.len();
        char::from(LETTERS[index])
    });
    Ok(letters.collect())
}

/// Returns whether a text can be the code of a class.
pub fn is_code(text: &str) -> bool {
    text.len() == CODE && text.bytes().all(|byte| LETTERS.contains(&byte))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tokens_are_read_as_they_are_written_and_nothing_else_is() {
        let token = Token::new().expect("a token");
        assert_eq!(Token::read(&token.to_string()), Some(token));
        assert_ne!(Token::new(), Ok(token));
        for text in ["", "0", "+0000000000000000000000000000000", &"A".repeat(32)] {
            assert_eq!(Token::read(text), None, "{text}");
        }
        assert_eq!(Token::read(&"é".repeat(16)), None);
    }

    #[test]
    fn codes_can_be_read_aloud() {
        let codes: Vec<String> = (0..50).map(|_| code().expect("a code")).collect();
        assert!(codes.iter().all(|code| is_code(code)));
        assert!(!is_code("../abc") && !is_code("abc") && !is_code("oil101"));
        assert!(codes.windows(2).all(|pair| pair[0] != pair[1]));
    }
}
