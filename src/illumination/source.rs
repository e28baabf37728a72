//! Light sources, prepared: each yields a direction and an attenuation at a point. Area lights are sets of points.

use super::{Real, Scalar, V3};
use crate::scene::{self, AreaShape, Attenuation, Light, LightKind, Rgb};
use glam::DVec3;
use std::f64::consts::TAU;

/// The distance, in camera distances, beyond which a light's rays count as parallel: over an object as large as the camera
/// distance its direction turns by less than 10⁻¹², over the largest, of 10⁸ camera distances, by less than can be seen.
const PARALLEL_BEYOND: f64 = 1e12;

/// The largest intensity of a surface, from all lights together or from the ambient light. It is far beyond useful values
/// and leaves single precision enough range to interpolate intensities and to add up samples.
pub const BRIGHTEST: f64 = 1e34;

/// The smallest divisor for lengths, so that a light on the surface stays finite.
const SHORTEST: f64 = 1e-9;

/// One light, or one sample of an area light. Lengths are in camera distances, positions relative to the eye.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Source<T> {
    place: SourcePosition<T>,
    falloff: Falloff<T>,
    cone: Option<Cone<T>>,
    /// `Ip·kd·color` per channel; `Ip·kd` where a pattern gives the colour.
    pub diffuse: [T; 3],
    /// `Ip·ks·Os` per channel.
    pub specular: [T; 3],
}

/// A spot light's cone (after Warn 1983): `(−L·D)^e` about the axis D inside it, nothing outside.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Cone<T> {
    /// D, unit.
    axis: [T; 3],
    exponent: T,
    /// `1 − cos δ` at the edge: half the square of the chord, which keeps its digits for narrow cones.
    edge: T,
    /// 1 over the part of the edge's value over which the light fades.
    inverse_fade: T,
}

impl<T: Scalar> Cone<T> {
    fn of(light: &Light) -> Option<Self> {
        let gap = |degrees: f64| 2.0 * (degrees.to_radians() * 0.5).sin().powi(2);
        let edge = gap(light.cone);
        let fade = (edge - gap(light.cone * (1.0 - light.softness))).max(HARD_EDGE * edge);
        (light.kind == LightKind::Spot).then(|| Self {
            axis: scalars(direction(light.direction)),
            exponent: T::from_f64(light.exponent),
            edge: T::from_f64(edge),
            inverse_fade: T::from_f64(1.0 / fade),
        })
    }

    /// Returns `1 − cos` of the angle between the axis and −`l`.
    #[inline(always)]
    fn gap<R: Real<Scalar = T>>(&self, l: V3<R>) -> R {
        let chord = l + V3::constant(l.x, self.axis);
        chord.dot(chord) * T::from_f64(0.5)
    }

    /// Returns the part of the intensity that is sent in the direction −`l`.
    #[inline(always)]
    fn factor<R: Real<Scalar = T>>(&self, l: V3<R>) -> R {
        let (zero, one) = (l.x.number(0.0), l.x.number(1.0));
        let tiny = l.x.number(f64::from(f32::MIN_POSITIVE));
        let gap = self.gap(l);
        let power = ((one - gap).max(tiny).log2() * self.exponent).exp2();
        let inside = ((l.x.constant(self.edge) - gap) * self.inverse_fade)
            .max(zero)
            .min(one);
        // Hermite's cubic: level at both ends of the edge.
        let soft = inside * inside * (l.x.number(3.0) - inside - inside);
        power * soft
    }
}

/// The part of the cone over which a hard edge fades, far less than a pixel.
const HARD_EDGE: f64 = 1e-6;

#[derive(Clone, Copy, Debug, PartialEq)]
enum SourcePosition<T> {
    /// Parallel rays: L, unit.
    Towards([T; 3]),
    /// A point.
    At([T; 3]),
}

/// The attenuation factor f as a function of a distance in camera distances. It is limited by the source's intensity (see
/// `Share`): divisors are raised to `min_divisor`, or f is lowered to `max`.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Falloff<T> {
    /// A constant f.
    Constant(T),
    /// `1/(scale·r + k)`, r to the viewer.
    Viewer { scale: T, k: T, min_divisor: T },
    /// `1/(scale·r + k)`, r to the light.
    Light { scale: T, k: T, min_divisor: T },
    /// `min(1, 1/(c1 + c2·d + c3·d²))`.
    Quadratic { c1: T, c2: T, c3: T },
    /// `1/(scale·d)²`, given 1/scale².
    InverseSquare { factor: T, max: T },
}

/// The limit of what one source may add to an intensity, so that all of them together stay below [`BRIGHTEST`] wherever they are.
#[derive(Clone, Copy, Debug)]
pub(super) struct Share {
    /// The largest coefficient of the diffuse term, times f.
    pub diffuse: f64,
    /// The largest coefficient of the specular term, times f.
    pub specular: f64,
}

impl Share {
    /// Returns the share of one of `count` sources, for a surface whose colour multiplies by at most `color`, and whose
    /// specular factor by at most `specular`.
    pub fn new(count: usize, color: f64, specular: f64) -> Self {
        let each = 0.5 * BRIGHTEST / count.max(1) as f64;
        Self {
            diffuse: each / color.max(1.0),
            specular: each / specular.max(1.0),
        }
    }

    fn attenuation(self, diffuse: Rgb, specular: Rgb) -> f64 {
        // Even a dark source's f must stay within the range of numbers.
        let most = |share: f64, coefficients: Rgb| share / coefficients.max_element().max(1.0);
        most(self.diffuse, diffuse).min(most(self.specular, specular))
    }
}

impl<T: Scalar> Source<T> {
    /// Prepares `light` as one source, or one for each sample, seen from `eye`, with lengths measured in `unit`s;
    /// `kd_color` and `ks` are the material's. None adds more than its `share`.
    pub(super) fn all_of(
        light: &Light,
        eye: DVec3,
        unit: f64,
        [kd_color, ks]: [Rgb; 2],
        share: Share,
    ) -> Vec<Self> {
        let color = light.color / f64::from(light.sample_count().max(1));
        let diffuse = (color * kd_color).min(Rgb::splat(share.diffuse));
        let specular = (color * ks).min(Rgb::splat(share.specular));
        let max = share.attenuation(diffuse, specular);
        let at = |position: DVec3| {
            let offset = (position - eye) / unit;
            let distance = length(offset);
            let parallel = light.kind == LightKind::Directional || distance > PARALLEL_BEYOND;
            let far = (light.kind.has_position() && parallel).then_some(distance);
            Self {
                place: match light.kind {
                    LightKind::Directional => {
                        SourcePosition::Towards(scalars(-direction(light.direction)))
                    }
                    _ if parallel => SourcePosition::Towards(scalars(direction(offset))),
                    _ => SourcePosition::At(scalars(offset)),
                },
                falloff: Falloff::new(light, unit, far, max),
                cone: Cone::of(light),
                diffuse: scalars(diffuse),
                specular: scalars(specular),
            }
        };
        if light.kind == LightKind::Area {
            area_samples(light).into_iter().map(at).collect()
        } else {
            vec![at(light.position)]
        }
    }

    /// Returns the unit vector to the light, the attenuation f and the inverse distance of the light (0 for parallel rays)
    /// at `position`, whose distance from the eye is `1/inverse_depth`.
    #[inline(always)]
    pub fn reach<R: Real<Scalar = T>>(&self, position: V3<R>, inverse_depth: R) -> (V3<R>, R, R) {
        let like = position.x;
        let (shortest, one) = (like.number(SHORTEST), like.number(1.0));
        let (l, inverse_distance, nearness) = match self.place {
            SourcePosition::Towards(l) => (V3::constant(like, l), one, like.number(0.0)),
            SourcePosition::At(place) => {
                let to_light = V3::constant(like, place) - position;
                let inverse = to_light
                    .dot(to_light)
                    .max(shortest * shortest)
                    .inverse_sqrt_of_sound();
                (to_light.scale(inverse), inverse, inverse)
            }
        };
        let f = match self.falloff {
            Falloff::Constant(f) => like.constant(f),
            Falloff::Viewer {
                scale,
                k,
                min_divisor,
            } => {
                one / (one / inverse_depth * scale + like.constant(k))
                    .max(like.constant(min_divisor))
            }
            Falloff::Light {
                scale,
                k,
                min_divisor,
            } => {
                one / (one / inverse_distance * scale + like.constant(k))
                    .max(like.constant(min_divisor))
            }
            Falloff::InverseSquare { factor, max } => {
                (inverse_distance * inverse_distance * factor).min(like.constant(max))
            }
            Falloff::Quadratic { c1, c2, c3 } => {
                let d = one / inverse_distance;
                let sum = d.mul_add(
                    d.mul_add(like.constant(c3), like.constant(c2)),
                    like.constant(c1),
                );
                one.min(one / sum.max(shortest))
            }
        };
        (l, f, nearness)
    }

    /// Returns the part of the light's intensity that a spot light sends in the direction −`l`; 1 for other lights.
    #[inline(always)]
    pub fn spot<R: Real<Scalar = T>>(&self, l: V3<R>) -> R {
        match &self.cone {
            None => l.x.constant(T::from_f64(1.0)),
            Some(cone) => cone.factor(l),
        }
    }

    /// Returns whether −`l` lies outside a spot light's cone, which sends nothing there.
    pub fn is_outside_cone(&self, l: V3<T>) -> bool
    where
        T: Real<Scalar = T>,
    {
        self.cone
            .as_ref()
            .is_some_and(|cone| cone.gap(l) >= cone.edge)
    }

    /// Returns the direction to the source from `position`, and the source's distance in multiples of its length.
    pub(super) fn way(&self, position: V3<T>) -> (V3<T>, T)
    where
        T: Real<Scalar = T>,
    {
        match self.place {
            SourcePosition::Towards(l) => (V3::constant(position.x, l), T::from_f64(f64::MAX)),
            SourcePosition::At(place) => {
                (V3::constant(position.x, place) - position, T::from_f64(1.0))
            }
        }
    }

    /// Makes f be evaluated by its formula at each point even where it is 1 everywhere.
    pub(super) fn evaluate_attenuation(&mut self) {
        let one = T::from_f64(1.0);
        if self.falloff == Falloff::Constant(one) {
            self.falloff = Falloff::Quadratic {
                c1: one,
                c2: T::default(),
                c3: T::default(),
            };
        }
    }

    /// Returns whether f differs from point to point.
    pub fn attenuates(&self) -> bool {
        !matches!(self.falloff, Falloff::Constant(_))
    }

    /// Returns L, if it is the same everywhere.
    pub fn parallel(&self) -> Option<[T; 3]> {
        match self.place {
            SourcePosition::Towards(l) => Some(l),
            SourcePosition::At(_) => None,
        }
    }

    /// Returns whether L is the same everywhere.
    pub fn is_parallel(&self) -> bool {
        self.parallel().is_some()
    }
}

impl Source<f32> {
    /// Returns the most that a highlight of this source adds, in any channel.
    pub(super) fn greatest_specular(&self) -> f64 {
        let f = match self.falloff {
            Falloff::Constant(f) => f,
            Falloff::Viewer { k, min_divisor, .. } | Falloff::Light { k, min_divisor, .. } => {
                1.0 / k.max(min_divisor)
            }
            Falloff::Quadratic { .. } => 1.0,
            Falloff::InverseSquare { max, .. } => max,
        };
        let [r, g, b] = self.specular;
        f64::from(r.max(g).max(b)) * f64::from(f)
    }
}

impl<T: Scalar> Falloff<T> {
    /// Prepares f, limited to `max`. `far` is the distance of a point light that is treated as parallel. A directional
    /// light has no distance, so attenuation by the distance to it has no effect.
    fn new(light: &Light, unit: f64, far: Option<f64>, max: f64) -> Self {
        let t = T::from_f64;
        let (min_divisor, scale, k) = (t(SHORTEST.max(1.0 / max)), t(unit), t(light.k));
        match (light.attenuation, far) {
            (Attenuation::Viewer, _) => Self::Viewer {
                scale,
                k,
                min_divisor,
            },
            (Attenuation::None, _) => Self::Constant(t(1.0)),
            _ if !light.kind.has_position() => Self::Constant(t(1.0)),
            (law, Some(distance)) => {
                Self::Constant(t(attenuation_at(light, law, distance * unit).min(max)))
            }
            (Attenuation::Light, None) => Self::Light {
                scale,
                k,
                min_divisor,
            },
            (Attenuation::InverseSquare, None) => Self::InverseSquare {
                factor: t(1.0 / (unit * unit)),
                max: t(max),
            },
            (Attenuation::Quadratic, None) => Self::Quadratic {
                c1: t(light.c1),
                c2: t(light.c2 * unit),
                c3: t(light.c3 * unit * unit),
            },
        }
    }
}

/// Returns f at `d` world units from the light, or from the viewer where `attenuation` counts from there. At distance 0 it
/// is as large as the kernels make it, which do not divide by zero.
pub fn attenuation_at(light: &Light, attenuation: Attenuation, d: f64) -> f64 {
    match attenuation {
        Attenuation::None => 1.0,
        Attenuation::Viewer | Attenuation::Light => 1.0 / (d + light.k).max(SHORTEST),
        Attenuation::InverseSquare => 1.0 / (d * d).max(SHORTEST * SHORTEST),
        Attenuation::Quadratic => {
            (1.0 / (light.c1 + light.c2 * d + light.c3 * d * d).max(SHORTEST)).min(1.0)
        }
    }
}

/// Returns the length, without overflow or underflow of the squares.
fn length(v: DVec3) -> f64 {
    let largest = v.abs().max_element();
    if largest > 0.0 && largest.is_finite() {
        (v / largest).length() * largest
    } else {
        largest
    }
}

/// Returns the unit vector of any finite vector; zero stays zero.
pub(crate) fn direction(v: DVec3) -> DVec3 {
    scene::direction(v).unwrap_or_default()
}

fn scalars<T: Scalar>(v: DVec3) -> [T; 3] {
    v.to_array().map(T::from_f64)
}

/// The golden section, by which each row of a sphere's samples is turned against the last.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// Returns the points that replace an area light, world: the middles of `light.samples` strata of equal area.
///
/// The unit square is cut into about √N rows as high as their number of cells, so that all N cells have equal areas. It is
/// laid over the rectangle, or over the sphere by Archimedes' projection. The midpoint rule's error falls as 1/N where the
/// integrand is smooth. A sphere of one sample shines from its centre: a point of its surface would light one side alone.
pub fn area_samples(light: &Light) -> Vec<DVec3> {
    let samples = strata(light.samples).into_iter();
    match light.shape {
        AreaShape::Rectangle => {
            let [across, up] = rectangle_axes(light);
            samples
                .map(|([u, v], _)| light.position + across * (u - 0.5) + up * (v - 0.5))
                .collect()
        }
        AreaShape::Sphere if light.samples == 1 => vec![light.position],
        AreaShape::Sphere => {
            let at = |([u, v], row): ([f64; 2], usize)| {
                let height = 1.0 - 2.0 * v;
                let (sine, cosine) = (TAU * (u + GOLDEN * row as f64)).sin_cos();
                let level = (1.0 - height * height).max(0.0).sqrt();
                light.position + light.radius * DVec3::new(level * cosine, height, level * sine)
            };
            samples.map(at).collect()
        }
    }
}

/// Returns the two sides of a rectangular light in world units: its width is horizontal, unless it faces straight up or down.
pub fn rectangle_axes(light: &Light) -> [DVec3; 2] {
    let facing = light.direction.normalize_or(DVec3::NEG_Z);
    let level = DVec3::Y.cross(facing).try_normalize().unwrap_or(DVec3::X);
    let up = facing.cross(level);
    [level * light.extent[0], up * light.extent[1]]
}

/// Returns the corners of a polyhedron that holds an area light: a rectangle's own, in their order; those of the cube about
/// a sphere.
pub fn area_hull(light: &Light) -> Vec<DVec3> {
    match light.shape {
        AreaShape::Rectangle => {
            let [across, up] = rectangle_axes(light).map(|side| side * 0.5);
            [across + up, across - up, -across - up, up - across]
                .map(|corner| light.position + corner)
                .to_vec()
        }
        AreaShape::Sphere => {
            let corner = |k: u32| [0, 1, 2].map(|axis| if k >> axis & 1 == 0 { -1.0 } else { 1.0 });
            (0..8)
                .map(|k| light.position + light.radius * DVec3::from_array(corner(k)))
                .collect()
        }
    }
}

/// Returns the middles of `count` cells of equal area in the unit square, each with its row.
fn strata(count: u32) -> Vec<([f64; 2], usize)> {
    let rows = (f64::from(count).sqrt().round() as u32).clamp(1, count.max(1));
    let end = |row: u32| (u64::from(count) * u64::from(row) / u64::from(rows)) as u32;
    let mut middles = Vec::with_capacity(count as usize);
    for row in 0..rows {
        let (start, cells) = (end(row), end(row + 1) - end(row));
        let v = (f64::from(start) + 0.5 * f64::from(cells)) / f64::from(count);
        let u = |cell: u32| (f64::from(cell) + 0.5) / f64::from(cells);
        middles.extend((0..cells).map(|cell| ([u(cell), v], row as usize)));
    }
    middles
}
