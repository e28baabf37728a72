//! The names of a law and what they stand for.

use crate::illumination::formula::builder::{Builder, Value};
use crate::illumination::formula::code::Code;
use crate::illumination::formula::lower::{Inputs, Lowered, dot, normalize};
use crate::illumination::formula::rate::Rate;
use crate::illumination::{Real, V3};
use crate::scene::{LAW_NUMBERS, LAW_VECTORS, Rgb, Scene};

/// The values that the equation has of a light at a point.
#[derive(Clone, Copy, Debug)]
pub struct Incidence<R> {
    /// L, unit.
    pub l: V3<R>,
    /// The distance to the light, world units.
    pub distance: R,
    /// The |N·L| up to which rounding decides on which side of the surface the light is.
    pub grazing: R,
}

/// The values that are the same at all points of a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constancy {
    /// True if Od is the same everywhere.
    pub color: bool,
    /// V, where it is constant.
    pub view: Option<[f64; 3]>,
    /// True if the rays of each light are parallel, so that L is constant.
    pub lights: bool,
}

impl Constancy {
    /// Everything may differ from point to point.
    pub const NONE: Self = Self {
        color: false,
        view: None,
        lights: false,
    };
}

/// An input of the code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Input {
    Normal(usize),
    View(usize),
    Light(usize),
    Distance,
    /// The |N·L| that counts as 0.
    Grazing,
    /// The factor of Od of a channel at a point.
    Color(usize),
    /// The values that are computed once for each light.
    Known(u16),
}

impl Input {
    /// Returns the value that an input of a point has.
    #[inline(always)]
    pub fn of_point<R: Real>(self, normal: V3<R>, view: V3<R>, color: Option<[R; 3]>) -> Option<R> {
        match self {
            Self::Normal(axis) => Some(normal.axis(axis)),
            Self::View(axis) => Some(view.axis(axis)),
            Self::Color(channel) => {
                Some(color.map_or(normal.x.number(1.0), |color| color[channel]))
            }
            Self::Light(_) | Self::Distance | Self::Grazing | Self::Known(_) => None,
        }
    }

    /// Returns the value that an input of a light has.
    #[inline(always)]
    pub fn of_light<R: Real>(self, incidence: &Incidence<R>) -> Option<R> {
        match self {
            Self::Light(axis) => Some(incidence.l.axis(axis)),
            Self::Distance => Some(incidence.distance),
            Self::Grazing => Some(incidence.grazing),
            Self::Normal(_) | Self::View(_) | Self::Color(_) | Self::Known(_) => None,
        }
    }
}

/// The inputs so far, and the numbers of one channel.
pub struct Named<'a> {
    scene: &'a Scene,
    /// Od, or what it is times that of the point where it is not constant.
    color: Rgb,
    constancy: Constancy,
    /// True if the law has steps: N·L is exactly 0 where rounding alone decides its sign, so that it decides on no step.
    has_steps: bool,
    /// The channel whose numbers the names have.
    pub channel: usize,
    pub made: Vec<(Input, Value)>,
}

impl<'a> Named<'a> {
    pub fn new(scene: &'a Scene, color: Rgb, constancy: Constancy, has_steps: bool) -> Self {
        Self {
            scene,
            color,
            constancy,
            has_steps,
            channel: 0,
            made: vec![],
        }
    }

    /// Returns what the input of this index among the builder's operations is.
    pub fn input_of(&self, index: u32) -> Option<Input> {
        let own = |(_, value): &&(Input, Value)| *value == Value::Varying(index);
        self.made.iter().find(own).map(|(input, _)| *input)
    }

    fn input(&mut self, builder: &mut Builder, input: Input) -> Value {
        if let (Input::View(axis), Some(view)) = (input, self.constancy.view) {
            return Value::Known(view[axis], Rate::Frame);
        }
        if let Some((_, value)) = self.made.iter().find(|(own, _)| *own == input) {
            return *value;
        }
        let rate = match input {
            Input::Normal(_) | Input::View(_) | Input::Color(_) => Rate::Point,
            _ if self.constancy.lights => Rate::Light,
            Input::Light(_) | Input::Distance | Input::Grazing | Input::Known(_) => {
                Rate::PointLight
            }
        };
        let value = builder.input(rate);
        self.made.push((input, value));
        value
    }

    fn vector(&mut self, builder: &mut Builder, name: &str) -> [Value; 3] {
        let of = |make: fn(usize) -> Input| [0, 1, 2].map(make);
        let inputs = match name {
            "N" => of(Input::Normal),
            "V" => of(Input::View),
            "L" => of(Input::Light),
            "R" => {
                let (n, l) = (self.vector(builder, "N"), self.vector(builder, "L"));
                let cosine = self.product(builder, "N·L");
                let twice = builder.add(cosine, cosine);
                return [0, 1, 2].map(|axis| {
                    let along = builder.multiply(twice, n[axis]);
                    builder.subtract(along, l[axis])
                });
            }
            _ => {
                let (l, v) = (self.vector(builder, "L"), self.vector(builder, "V"));
                let sum = [0, 1, 2].map(|axis| builder.add(l[axis], v[axis]));
                return normalize(builder, sum);
            }
        };
        inputs.map(|input| self.input(builder, input))
    }

    /// Returns a dot product of two letters.
    fn product(&mut self, builder: &mut Builder, name: &str) -> Value {
        // R·V without R: 2(N·L)(N·V) − L·V.
        if name == "R·V" {
            let [nl, nv, lv] = ["N·L", "N·V", "L·V"].map(|name| self.product(builder, name));
            let twice = builder.add(nl, nl);
            let along = builder.multiply(twice, nv);
            let cosine = builder.subtract(along, lv);
            builder.cosines.push(cosine);
            return cosine;
        }
        let (a, b) = name.split_once('·').unwrap_or(("N", "L"));
        let (a, b) = (self.vector(builder, a), self.vector(builder, b));
        let mut cosine = dot(builder, a, b);
        if self.has_steps && name == "N·L" {
            let grazing = self.input(builder, Input::Grazing);
            cosine = builder.beyond(cosine, grazing);
        }
        builder.cosines.push(cosine);
        cosine
    }

    /// Returns a number of the scene, which is the same in the whole picture.
    fn number(&self, name: &str) -> f64 {
        let material = &self.scene.material;
        let own = |channels: Rgb| channels.to_array()[self.channel];
        match name {
            "ka" => own(material.ka),
            "kd" => own(material.kd),
            "ks" => own(material.ks),
            "od" => own(self.color),
            "os" => own(material.specular_color),
            "m" => material.roughness,
            "eta" => own(material.ior),
            _ => material.n,
        }
    }
}

impl Inputs for Named<'_> {
    fn name(&mut self, builder: &mut Builder, index: usize) -> Lowered {
        if let Some(name) = index.checked_sub(LAW_NUMBERS.len()) {
            return Lowered::Vector(self.vector(builder, LAW_VECTORS[name]));
        }
        Lowered::Number(match LAW_NUMBERS[index] {
            "d" => self.input(builder, Input::Distance),
            "theta" => {
                let cosine = self.product(builder, "N·L");
                builder.function(Code::Acos, cosine)
            }
            "phi" => {
                let cosine = self.product(builder, "R·V");
                builder.function(Code::Acos, cosine)
            }
            "od" if !self.constancy.color => {
                let here = self.input(builder, Input::Color(self.channel));
                let color = Value::Known(self.number("od"), Rate::Frame);
                builder.multiply(color, here)
            }
            name if name.contains('·') => self.product(builder, name),
            name => Value::Known(self.number(name), Rate::Frame),
        })
    }

    fn dot(&mut self, builder: &mut Builder, a: usize, b: usize) -> Option<Value> {
        self.name(builder, product_of(a, b)?).number()
    }
}

/// Returns the index of the name that the dot product of two vectors has, if there is one.
pub fn product_of(a: usize, b: usize) -> Option<usize> {
    let vector = |index: usize| LAW_VECTORS.get(index.checked_sub(LAW_NUMBERS.len())?);
    let (a, b) = (*vector(a)?, *vector(b)?);
    let is_own = |pair| pair == (a, b) || pair == (b, a);
    let mut pairs = LAW_NUMBERS.iter().map(|name| name.split_once('·'));
    pairs.position(|pair| pair.is_some_and(is_own))
}
