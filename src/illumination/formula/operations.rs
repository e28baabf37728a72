//! The operations of a scene's own law one by one, for questions about each of them.

use super::builder::{Builder, Operation, Value};
use super::law::{Constancy, Incidence, Input, Listed};
use super::program::needed;
use crate::expression::FormulaError;
use crate::illumination::{Real, V3};
use crate::scene::{Rgb, Scene};
use std::ops::Range;

/// The operations of a law in the order of evaluation.
#[derive(Debug)]
pub(crate) struct LawOperations {
    builder: Builder,
    inputs: Vec<(Input, Value)>,
    /// The factor of a light's part, for each channel.
    pub results: [Value; 3],
    needed: Vec<bool>,
}

/// The values that a law depends on at a point, for one light.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LawSite<R> {
    pub normal: V3<R>,
    pub view: V3<R>,
    /// The factor of Od of each channel, if there is one.
    pub color: Option<[R; 3]>,
    pub incidence: Incidence<R>,
}

impl LawSite<f64> {
    /// Rounds to another number type.
    pub fn rounded_to<R: Real>(&self, like: R) -> LawSite<R> {
        let number = |value: f64| like.number(value);
        let vector = |v: V3<f64>| V3::new(number(v.x), number(v.y), number(v.z));
        LawSite {
            normal: vector(self.normal),
            view: vector(self.view),
            color: self.color.map(|color| color.map(number)),
            incidence: Incidence {
                l: vector(self.incidence.l),
                distance: number(self.incidence.distance),
                grazing: number(self.incidence.grazing),
            },
        }
    }
}

impl LawOperations {
    /// Lists the operations of the law that `scene` has as a text. Od is `color` times that of the point.
    pub fn of(scene: &Scene, color: Rgb) -> Result<Self, FormulaError> {
        let listed = Listed::of(scene, color, Constancy::NONE)?;
        let results = listed.factors();
        Ok(Self {
            needed: needed(&listed.builder, &[results.to_vec()], &|_| Some(0)),
            builder: listed.builder,
            inputs: listed.named.made,
            results,
        })
    }

    /// Lists the operations of the law of `scene`, if that is its model and the text is right; Od is the material's.
    pub fn of_model(scene: &Scene) -> Option<Self> {
        if !scene.reflection.is_own_law() {
            return None;
        }
        Self::of(scene, scene.material.color).ok()
    }

    /// Returns the operations that the results need, with their indices; inputs are among them.
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = (usize, &Operation)> {
        let all = self.builder.operations.iter().enumerate();
        all.filter(|(index, _)| self.needed[*index])
    }

    /// Returns the part of the text that an operation was made for first.
    pub fn span(&self, operation: &Operation) -> Range<usize> {
        let origins = &self.builder.origins;
        origins
            .get(operation.origin as usize)
            .cloned()
            .unwrap_or(0..0)
    }

    /// Returns whether there are operands for which an operation is undefined.
    pub fn may_be_undefined(&self, operation: &Operation) -> bool {
        self.builder.may_be_undefined(operation)
    }

    /// Evaluates the law in the number type of `site`: puts the result of each operation into `values`, by its index.
    pub fn evaluate<R: Real>(&self, site: &LawSite<R>, values: &mut Vec<R>) {
        let like = site.incidence.distance;
        values.clear();
        values.resize(self.builder.operations.len(), like.number(0.0));
        for (input, value) in &self.inputs {
            if let Value::Varying(index) = value {
                let of_point = input.of_point(site.normal, site.view, site.color);
                let value = of_point.or_else(|| input.of_light(&site.incidence));
                values[*index as usize] = value.unwrap_or(like.number(0.0));
            }
        }
        for (index, operation) in self.iter() {
            if let Some(code) = operation.code {
                let [a, b, c] = operation.operands.map(|value| value.of(values, like));
                values[index] = code.apply(a, b, c);
            }
        }
    }

    /// Returns the factors of a light's part at a point, for each channel.
    pub fn factors_at<R: Real>(&self, site: &LawSite<R>) -> [R; 3] {
        let mut values = vec![];
        self.evaluate(site, &mut values);
        self.factors(&values, site.incidence.distance)
    }

    /// Returns the factors of a light's part, for each channel, of values that [`Self::evaluate`] has found.
    pub fn factors<R: Real>(&self, values: &[R], like: R) -> [R; 3] {
        self.results.map(|result| result.of(values, like))
    }
}

impl Value {
    /// Returns the number, given those of all operations.
    pub fn of<R: Real>(self, values: &[R], like: R) -> R {
        match self {
            Self::Known(number, _) => like.number(number),
            Self::Varying(index) => values[index as usize],
        }
    }
}
