//! Access to a parameter's value in a scene.

use super::Scene;
use super::choice::{Choice, ChoiceOption};
use super::format::Datum;
use super::problem::UnlocatedProblem;
use std::fmt::Debug;
use toml::de::DeValue;
use toml::{Spanned, Value};

/// The field of a scene that holds a value. The `usize` is an index into a list, from 0: of the light, the pane or the model's material.
#[derive(Debug)]
pub struct Access<T: 'static> {
    /// The function that returns the value of the element with this index; `None` where the list is shorter.
    pub get: fn(&Scene, usize) -> Option<&T>,
    /// The function that returns the value for changing it; `None` where the list is shorter.
    pub get_mut: fn(&mut Scene, usize) -> Option<&mut T>,
}

/// A field of a scene, whatever its type.
pub trait Field: Debug + Sync {
    /// Returns its value in the form of a scene file; `None` where the scene has no such light.
    fn value(&self, scene: &Scene, index: usize) -> Option<Value>;
    /// Sets it to a value of a scene file without checking its limits.
    fn read(
        &self,
        scene: &mut Scene,
        index: usize,
        value: &Spanned<DeValue<'_>>,
    ) -> Result<(), UnlocatedProblem>;
    /// Copies its value from another scene.
    fn copy(&self, from: &Scene, to: &mut Scene, index: usize);
    /// Returns whether two scenes agree in it, for numbers bit by bit.
    fn agrees(&self, a: &Scene, b: &Scene, index: usize) -> bool;
}

impl<T: Datum> Field for Access<T> {
    fn value(&self, scene: &Scene, index: usize) -> Option<Value> {
        (self.get)(scene, index)?.value()
    }

    fn read(
        &self,
        scene: &mut Scene,
        index: usize,
        value: &Spanned<DeValue<'_>>,
    ) -> Result<(), UnlocatedProblem> {
        let value = T::read(value)?;
        if let Some(place) = (self.get_mut)(scene, index) {
            *place = value;
        }
        Ok(())
    }

    fn copy(&self, from: &Scene, to: &mut Scene, index: usize) {
        if let (Some(value), Some(place)) = ((self.get)(from, index), (self.get_mut)(to, index)) {
            place.clone_from(value);
        }
    }

    fn agrees(&self, a: &Scene, b: &Scene, index: usize) -> bool {
        match ((self.get)(a, index), (self.get)(b, index)) {
            (Some(a), Some(b)) => a.same(b),
            (a, b) => a.is_none() && b.is_none(),
        }
    }
}

/// A field that holds one of several values, identified by their positions among the options.
pub trait ChoiceField: Field {
    /// Returns the values that it can have.
    fn options(&self) -> &'static [ChoiceOption];
    /// Returns the position of its value among the options; `None` where the scene has no such light or pane.
    fn chosen(&self, scene: &Scene, index: usize) -> Option<usize>;
    /// Sets it to the option at this position; does nothing where there is none.
    fn choose(&self, scene: &mut Scene, index: usize, option: usize);
}

impl<T: Choice + Datum> ChoiceField for Access<T> {
    fn options(&self) -> &'static [ChoiceOption] {
        T::OPTIONS
    }

    fn chosen(&self, scene: &Scene, index: usize) -> Option<usize> {
        (self.get)(scene, index).map(|value| value.place())
    }

    fn choose(&self, scene: &mut Scene, index: usize, option: usize) {
        if let (Some(place), Some(value)) = ((self.get_mut)(scene, index), T::VALUES.get(option)) {
            *place = *value;
        }
    }
}

/// A list of a scene whose elements are tables of keys.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum List {
    /// `Scene::lights`.
    Lights,
    /// `Scene::compare.panes`.
    Panes,
    /// `Scene::object.materials`.
    Materials,
}

impl List {
    /// Every list.
    pub const ALL: [Self; 3] = [Self::Lights, Self::Panes, Self::Materials];

    /// Returns the beginning of its elements' keys.
    pub const fn key(self) -> &'static str {
        match self {
            Self::Lights => "light",
            Self::Panes => "compare.pane",
            Self::Materials => "object.material",
        }
    }

    /// Returns the list that a key of the table of parameters belongs to.
    pub fn of(key: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|list| {
            key.strip_prefix(list.key())
                .is_some_and(|rest| rest.starts_with(".N"))
        })
    }

    /// Returns the number of its entries in a scene.
    pub fn len(self, scene: &Scene) -> usize {
        match self {
            Self::Lights => scene.lights.len(),
            Self::Panes => scene.compare.panes.len(),
            Self::Materials => scene.object.materials.len(),
        }
    }

    /// Replaces it by `count` elements that have only defaults.
    pub fn renew(self, scene: &mut Scene, count: usize) {
        match self {
            Self::Lights => scene.lights = vec![Default::default(); count],
            Self::Panes => scene.compare.panes = vec![Default::default(); count],
            Self::Materials => scene.object.materials = vec![Default::default(); count],
        }
    }
}
