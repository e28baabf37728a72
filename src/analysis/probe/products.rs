//! The terms of the equation as products of numbers: their factors, with their values at this pixel. Where a term is a
//! sum, over the vertices of a polygon or the points of an area light, the factors that differ between summands are
//! combined: their mean is displayed, which makes the product exact again.

use super::digits::triple;
use super::{LightTerms, ProbeHit};
use crate::illumination::Equation;
use crate::scene::{
    Attenuation, Backfacing, CuedBy, Light, LightKind, PatternKind, Reflectance, ReflectionModel,
    Rgb, Scene, ShadingMode,
};
use crate::text;

/// Factors with their product, per channel.
#[derive(Clone, Debug, PartialEq)]
pub struct TermColumn {
    /// Formulas with the letters in braces; see [`plain_formula`](super::plain_formula).
    pub factors: Vec<&'static str>,
    /// Their product, linear.
    pub values: Rgb,
    /// True if it is a mean over several evaluations.
    pub mean: bool,
    /// True if it is added to the preceding columns instead of multiplied.
    pub added: bool,
}

impl TermColumn {
    fn new(factor: &'static str, values: Rgb) -> Self {
        Self {
            factors: vec![factor],
            values,
            mean: false,
            added: false,
        }
    }

    /// Returns the factors in letters, side by side.
    pub fn formula(&self) -> String {
        self.factors.concat()
    }

    /// Describes the values in a sentence.
    pub fn words(&self) -> String {
        let values = triple(self.values);
        match (self.factors.len() == 1, self.mean) {
            (true, false) => text!("point-here", values = values),
            (true, true) => text!("point-here-mean", values = values),
            (false, false) => text!("point-here-product", values = values),
            (false, true) => text!("point-here-product-mean", values = values),
        }
    }
}

/// A term as columns whose product is its value.
#[derive(Clone, Debug, PartialEq)]
pub struct Product {
    /// The columns from left to right.
    pub columns: Vec<TermColumn>,
    /// The product of the columns, linear.
    pub value: Rgb,
}

/// The scene and its probe's hit.
#[derive(Clone, Copy, Debug)]
pub struct Here<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// The hit that the probe's pixel shows.
    pub hit: &'a ProbeHit,
}

/// One light of [`Here`].
#[derive(Clone, Copy, Debug)]
pub struct LightHere<'a> {
    /// The point that the light shines on.
    pub here: Here<'a>,
    /// Index in the scene's list.
    pub index: usize,
    /// The light.
    pub source: &'a Light,
    /// The light's terms there.
    pub terms: &'a LightTerms,
}

impl<'a> Here<'a> {
    /// Returns whether the equation is evaluated at the pixel itself.
    pub fn at_pixel(self) -> bool {
        matches!(
            self.scene.shading.mode,
            ShadingMode::Phong | ShadingMode::Exact
        )
    }

    /// Returns whether intensities fade at the points where the equation is evaluated instead of at the pixel.
    pub fn fades_at_points(self) -> bool {
        self.scene.depth_cueing.by == CuedBy::Vertex && !self.at_pixel()
    }

    /// Returns the lights in their order.
    pub fn lights(self) -> impl Iterator<Item = LightHere<'a>> {
        let pairs = self.scene.lights.iter().zip(&self.hit.lights).enumerate();
        pairs.map(move |(index, (source, terms))| LightHere {
            here: self,
            index,
            source,
            terms,
        })
    }

    /// Returns Od, if it is one colour for all evaluations.
    fn od(self) -> Option<Rgb> {
        let plain = self.scene.pattern.kind == PatternKind::None;
        let one = (plain && self.hit.tint.is_none()) || self.at_pixel();
        one.then(|| {
            if plain {
                self.scene.material.color
            } else {
                Equation::<f64>::new(self.scene).pattern_color(self.hit.position)
            }
        })
    }

    /// Returns the ambient term, `Ka·Od·Ia`.
    pub fn ambient(self) -> Product {
        let (ka, ia) = (self.scene.material.ka, self.scene.ambient.color);
        let od = TermColumn {
            mean: self.od().is_none(),
            ..TermColumn::new("{Od}", self.hit.color)
        };
        let value = if self.hit.bounced {
            ka * od.values * ia
        } else {
            self.hit.ambient
        };
        Product {
            columns: vec![TermColumn::new("{Ka}", ka), od, TermColumn::new("{Ia}", ia)],
            value,
        }
    }

    /// Returns `(1 − Kt)·Irefl + Kt·Itrans`, where light comes through the surface.
    pub fn mixture(self) -> Option<Product> {
        let (through, kt) = (self.hit.transmission?, self.scene.transparency.kt);
        let columns = vec![
            TermColumn::new("(1 − {Kt})", Rgb::splat(1.0 - kt)),
            TermColumn::new("{Irefl}", self.hit.reflected),
            TermColumn {
                added: true,
                ..TermColumn::new("{Kt}", Rgb::splat(kt))
            },
            TermColumn::new("{Itrans}", through.seen),
        ];
        Some(Product {
            columns,
            value: self.hit.intensity,
        })
    }

    /// Returns `s0·I + (1 − s0)·Idc`, where the depth is cued.
    pub fn fading(self) -> Option<Product> {
        let (cue, intensity, mean) = (self.hit.cue?, self.hit.intensity, self.fades_at_points());
        let kept = if mean {
            quotient(cue.kept, intensity)
        } else {
            Rgb::splat(cue.scale)
        };
        let columns = vec![
            TermColumn {
                mean,
                ..TermColumn::new("{s0}", kept)
            },
            TermColumn::new("{I}", intensity),
            TermColumn {
                mean,
                added: true,
                ..TermColumn::new("(1 − {s0})", Rgb::splat(1.0 - cue.scale))
            },
            TermColumn::new("{Idc}", self.scene.depth_cueing.color),
        ];
        Some(Product {
            columns,
            value: self.hit.sum,
        })
    }
}

impl LightHere<'_> {
    /// Returns whether the light's terms are products at the pixel instead of sums.
    pub fn is_one_product(self) -> bool {
        self.here.at_pixel() && self.source.kind != LightKind::Area
    }

    /// Returns whether f can differ from 1.
    pub fn attenuates(self) -> bool {
        match self.source.attenuation {
            Attenuation::None => false,
            Attenuation::Viewer => true,
            Attenuation::Light | Attenuation::InverseSquare | Attenuation::Quadratic => {
                self.source.kind.has_position()
            }
        }
    }

    /// Returns N·L according to the policy for surfaces turned away.
    pub fn facing(self) -> f64 {
        match self.here.scene.reflection.backfacing {
            Backfacing::Clamp => self.terms.n_dot_l.max(0.0),
            Backfacing::Flip => self.terms.n_dot_l.abs(),
        }
    }

    /// Returns whether N has been flipped towards the light.
    pub fn turned(self) -> bool {
        self.terms.n_dot_l < 0.0 && self.here.scene.reflection.backfacing == Backfacing::Flip
    }

    /// Returns S in letters.
    pub fn lobe_letters(self) -> &'static str {
        match self.here.scene.reflection.model {
            ReflectionModel::Phong => "({R}·{V})^n",
            ReflectionModel::Blinn => "({N}·{H})^n",
            ReflectionModel::CookTorrance | ReflectionModel::Formula => "{S}",
        }
    }

    /// Returns the factors besides the coefficients, which are common to all channels, and their product.
    fn strength(self) -> (Vec<&'static str>, f64) {
        let factors = [
            (self.attenuates(), "{f}", self.terms.attenuation),
            (
                self.source.kind == LightKind::Spot,
                "{spot}",
                self.terms.spot,
            ),
            (self.here.scene.shading.shadows, "{lit}", self.terms.reached),
        ];
        let present = || factors.iter().filter(|(present, ..)| *present);
        (
            present().map(|(_, letters, _)| *letters).collect(),
            present().map(|(.., value)| value).product(),
        )
    }

    /// Returns the light's part by the scene's own law, `f·Ip·law`; none where it has no law of its own.
    pub fn by_law(self) -> Option<Product> {
        let law = self.terms.law.as_ref()?;
        let (ip, value) = (self.source.color, self.terms.diffuse);
        let (mut factors, strength) = self.strength();
        let mut columns = vec![TermColumn::new("{Ip}", ip)];
        let mean = !self.is_one_product();
        if mean {
            factors.push("{law}");
            columns.push(TermColumn {
                factors,
                values: quotient(value, ip),
                mean,
                added: false,
            });
        } else {
            if !factors.is_empty() {
                columns.push(TermColumn {
                    factors,
                    values: Rgb::splat(strength),
                    mean,
                    added: false,
                });
            }
            columns.push(TermColumn::new("{law}", law.value()));
        }
        Some(Product { columns, value })
    }

    /// Returns the diffuse term, `f·Ip·Kd·Od·(N·L)`.
    pub fn diffuse(self) -> Product {
        let (ip, kd, value) = (
            self.source.color,
            self.here.scene.material.kd,
            self.terms.diffuse,
        );
        let (mut factors, strength) = self.strength();
        factors.push("({N}·{L})");
        let mut columns = vec![TermColumn::new("{Ip}", ip), TermColumn::new("{Kd}", kd)];
        let mut known = ip * kd;
        let od = self.here.od();
        if let Some(od) = od {
            columns.push(TermColumn::new("{Od}", od));
            known *= od;
        } else {
            factors.insert(0, "{Od}");
        }
        let values = match (self.is_one_product(), od) {
            (true, _) => Rgb::splat(strength * self.facing()),
            (false, Some(_)) => Rgb::splat(common(value, known)),
            (false, None) => quotient(value, known),
        };
        columns.push(TermColumn {
            factors,
            values,
            mean: !self.is_one_product(),
            added: false,
        });
        Product { columns, value }
    }

    /// Returns the specular term, `f·Ip·Ks·Os·W·S`.
    pub fn specular(self) -> Product {
        let (material, value) = (&self.here.scene.material, self.terms.specular);
        let (mut factors, strength) = self.strength();
        factors.push(self.lobe_letters());
        let coefficient = material.ks * material.specular_color;
        let mut ks = TermColumn::new("{Ks}", coefficient);
        if material.specular_color != Rgb::ONE {
            ks.factors.push("{Os}");
        }
        let mut columns = vec![TermColumn::new("{Ip}", self.source.color), ks];
        let mut known = self.source.color * coefficient;
        let by_angle = material.reflectance != Reflectance::Constant;
        let values = if self.is_one_product() {
            if by_angle {
                columns.push(TermColumn::new("{W}", self.terms.reflectance));
                known *= self.terms.reflectance;
            }
            // Not the product with f, which says nothing where no light arrives.
            Rgb::splat(common(value, known * strength) * strength)
        } else if by_angle {
            factors.insert(0, "{W}");
            quotient(value, known)
        } else {
            Rgb::splat(common(value, known))
        };
        columns.push(TermColumn {
            factors,
            values,
            mean: !self.is_one_product(),
            added: false,
        });
        Product { columns, value }
    }

    /// Returns S, where the terms are products at the pixel.
    pub fn lobe(self) -> f64 {
        let material = &self.here.scene.material;
        let known =
            self.source.color * material.ks * material.specular_color * self.terms.reflectance;
        common(self.terms.specular, known * self.strength().1)
    }

    /// Returns `R·V` or `N·H`, the cosine in S.
    pub fn lobe_cosine(self) -> f64 {
        let hit = self.here.hit;
        match self.here.scene.reflection.model {
            ReflectionModel::Phong => self.terms.r.dot(hit.view),
            _ if self.turned() => -hit.normal.dot(self.terms.h),
            _ => hit.normal.dot(self.terms.h),
        }
    }
}

/// Returns the quotient of `product` and `factors` for each channel; 0 where the factors are 0.
fn quotient(product: Rgb, factors: Rgb) -> Rgb {
    Rgb::from_array([0, 1, 2].map(|c| {
        if factors[c] > 0.0 {
            product[c] / factors[c]
        } else {
            0.0
        }
    }))
}

/// Returns the quotient that all channels share, from the channel with the largest factor; 0 where all are 0.
fn common(product: Rgb, factors: Rgb) -> f64 {
    let best = (0..3)
        .max_by(|&a, &b| factors[a].total_cmp(&factors[b]))
        .unwrap_or(0);
    if factors[best] > 0.0 {
        product[best] / factors[best]
    } else {
        0.0
    }
}
