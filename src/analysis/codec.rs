//! Serialization of questions and answers for a worker of a web page; infinities and NaN are preserved.

use serde::Serialize;
use serde::de::DeserializeOwned;

/// Conversion of a value to bytes and back.
#[derive(Debug)]
pub struct Codec<T> {
    /// Serializes the value.
    pub to_bytes: fn(&T) -> Vec<u8>,
    /// Deserializes the value; none where the bytes are not valid.
    pub from_bytes: fn(&[u8]) -> Option<T>,
}

impl<T: Serialize + DeserializeOwned> Codec<T> {
    /// Returns the codec that uses the value's own serialization for programs of its kind.
    pub const fn plain() -> Self {
        Self {
            to_bytes: to_bytes::<T>,
            from_bytes: from_bytes::<T>,
        }
    }
}

/// Serializes a value; empty if that is impossible.
pub(crate) fn to_bytes<T: Serialize>(value: &T) -> Vec<u8> {
    postcard::to_stdvec(value).unwrap_or_default()
}

/// Deserializes bytes that [`to_bytes`] made; none where they are not valid.
pub(crate) fn from_bytes<T: DeserializeOwned>(bytes: &[u8]) -> Option<T> {
    postcard::from_bytes(bytes).ok()
}
