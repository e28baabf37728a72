//! What can be wrong with a model.

/// Why a model could not be read. The message says what is wrong and what was expected, [`ObjError::line`] where.
#[derive(Debug, thiserror::Error)]
pub enum ObjError {
    #[error("cannot be read: {0}")]
    Read(#[from] std::io::Error),
    #[error("the file is empty, expected an OBJ model with `v` and `f` lines")]
    Empty,
    #[error("this is not text, expected an OBJ model in ASCII or UTF-8")]
    Binary { line: u64 },
    #[error("the line is longer than {limit} bytes, expected an OBJ model")]
    TooLong { line: u64, limit: usize },
    #[error("`{word}` is not {expected}")]
    Malformed { line: u64, word: String, expected: &'static str },
    #[error("{found} numbers, expected {expected}")]
    TooFewNumbers { line: u64, found: usize, expected: &'static str },
    #[error("the coordinate {word} is not finite in single precision, expected a number between -3.4e38 and 3.4e38")]
    NotFinite { line: u64, word: String },
    #[error("a vertex of weight 0 is at infinity, expected a weight that is not zero")]
    ZeroWeight { line: u64 },
    #[error("a face of {found} vertices, expected at least 3")]
    TooFewCorners { line: u64, found: usize },
    #[error(
        "the face names {kind} {index}, expected 1 to {count} or -{count} to -1, as {count} of them come before this line"
    )]
    OutOfRange { line: u64, kind: &'static str, index: String, count: u64 },
    #[error("there is no face with three different corners, expected at least one `f` line")]
    NoFace,
    #[error("the model has more than {} corners, expected fewer", u32::MAX)]
    TooLarge,
    #[error("the model was refused: {0}")]
    Refused(tobj::LoadError),
}

impl ObjError {
    /// The line, from 1, where it is known; of a continued line the first.
    pub fn line(&self) -> Option<u64> {
        match self {
            Self::Binary { line }
            | Self::TooLong { line, .. }
            | Self::Malformed { line, .. }
            | Self::TooFewNumbers { line, .. }
            | Self::NotFinite { line, .. }
            | Self::ZeroWeight { line }
            | Self::TooFewCorners { line, .. }
            | Self::OutOfRange { line, .. } => Some(*line),
            Self::Read(_) | Self::Empty | Self::NoFace | Self::TooLarge | Self::Refused(_) => None,
        }
    }
}

/// A word of the file for a message: valid text, and no longer than a message may be.
pub(super) fn quoted(word: &[u8]) -> String {
    const LONGEST: usize = 40;
    let text = String::from_utf8_lossy(&word[..word.len().min(LONGEST)]);
    if word.len() > LONGEST { format!("{text}…") } else { text.into_owned() }
}
