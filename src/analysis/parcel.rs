//! Questions and answers as bytes, for a worker of a web page; infinities and what is no number travel too.

use serde::Serialize;
use serde::de::DeserializeOwned;

/// How a value becomes bytes, and bytes that value again.
#[derive(Debug)]
pub struct Parcel<T> {
    /// The value as bytes.
    pub pack: fn(&T) -> Vec<u8>,
    /// Nothing where the bytes are no such value.
    pub unpack: fn(&[u8]) -> Option<T>,
}

impl<T: Serialize + DeserializeOwned> Parcel<T> {
    /// The value as it is serialised for programs of its own kind.
    pub const fn plain() -> Self {
        Self {
            pack: pack::<T>,
            unpack: unpack::<T>,
        }
    }
}

impl<T> Clone for Parcel<T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Copy for Parcel<T> {}

/// A value as bytes; none at all where it cannot be told.
pub fn pack<T: Serialize>(value: &T) -> Vec<u8> {
    postcard::to_stdvec(value).unwrap_or_default()
}

/// The value that [`pack`] made these bytes of; none where they are no such value.
pub fn unpack<T: DeserializeOwned>(bytes: &[u8]) -> Option<T> {
    postcard::from_bytes(bytes).ok()
}
