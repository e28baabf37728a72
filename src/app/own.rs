//! What each tab and dialog remembers, kept by its type, so that the window's state need not know them.

use std::any::{Any, TypeId};
use std::collections::HashMap;
use std::fmt;

/// One value of each type.
#[derive(Default)]
pub struct Own(HashMap<TypeId, Box<dyn Any>>);

impl Own {
    /// The value, if there is one yet.
    pub fn get<T: 'static>(&self) -> Option<&T> {
        self.0.get(&TypeId::of::<T>())?.downcast_ref()
    }

    /// Takes the value out, to be put back; its default if there is none yet.
    pub fn take<T: Default + 'static>(&mut self) -> T {
        let value = self.0.remove(&TypeId::of::<T>()).and_then(|value| value.downcast().ok());
        value.map(|value| *value).unwrap_or_default()
    }

    /// Puts a value in its place.
    pub fn put<T: 'static>(&mut self, value: T) {
        self.0.insert(TypeId::of::<T>(), Box::new(value));
    }

    /// Changes the value.
    pub fn change<T: Default + 'static>(&mut self, change: impl FnOnce(&mut T)) {
        let mut value = self.take();
        change(&mut value);
        self.put(value);
    }
}

impl fmt::Debug for Own {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} values", self.0.len())
    }
}
