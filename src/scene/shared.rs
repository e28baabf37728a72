//! A list that many copies of a scene share.

use serde::{Serialize, Serializer};
use std::ops::Deref;
use std::sync::Arc;

/// A list that is not copied when its scene is: a clone is the same list, and only different lists are compared by their
/// elements. So a scene with many vertices is compared with the last one drawn in no time.
#[derive(Clone, Debug, Default)]
pub struct Shared<T>(Arc<[T]>);

impl<T> Shared<T> {
    /// Returns whether both are one list.
    pub fn is(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl<T: Clone> Shared<T> {
    /// Returns the elements for changing them; other holders of the list keep it as it was.
    pub fn make_mut(&mut self) -> &mut [T] {
        Arc::make_mut(&mut self.0)
    }
}

impl<T> Deref for Shared<T> {
    type Target = [T];

    fn deref(&self) -> &[T] {
        &self.0
    }
}

impl<T: PartialEq> PartialEq for Shared<T> {
    fn eq(&self, other: &Self) -> bool {
        self.is(other) || self.0 == other.0
    }
}

impl<T: Serialize> Serialize for Shared<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.0.serialize(serializer)
    }
}

impl<T> From<Vec<T>> for Shared<T> {
    fn from(list: Vec<T>) -> Self {
        Self(list.into())
    }
}

impl<T> FromIterator<T> for Shared<T> {
    fn from_iter<I: IntoIterator<Item = T>>(list: I) -> Self {
        Self(list.into_iter().collect())
    }
}
