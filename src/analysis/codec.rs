//! Questions and answers as bytes, for a worker of a web page; infinities and what is no number travel too.

use serde::Serialize;
use serde::de::DeserializeOwned;

/// How a value becomes bytes, and bytes that value again.
#[derive(Debug)]
pub struct Codec<T> {
    /// The value as bytes.
    pub to_bytes: fn(&T) -> Vec<u8>,
    /// Nothing where the bytes are no such value.
    pub from_bytes: fn(&[u8]) -> Option<T>,
}

impl<T: Serialize + DeserializeOwned> Codec<T> {
    /// The value as it is serialised for programs of its own kind.
    pub const fn plain() -> Self {
        Self {
            to_bytes: to_bytes::<T>,
            from_bytes: from_bytes::<T>,
        }
    }
}

impl<T> Clone for Codec<T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Copy for Codec<T> {}

/// A value as bytes; none at all where it cannot be told.
pub(crate) fn to_bytes<T: Serialize>(value: &T) -> Vec<u8> {
    postcard::to_stdvec(value).unwrap_or_default()
}

/// The value that [`to_bytes`] made these bytes of; none where they are no such value.
pub(crate) fn from_bytes<T: DeserializeOwned>(bytes: &[u8]) -> Option<T> {
    postcard::from_bytes(bytes).ok()
}
