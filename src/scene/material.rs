//! The reflecting material: the coefficients of the illumination equation.

use super::Rgb;
use serde::{Deserialize, Serialize};

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Material {
    /// Ambient coefficient; in a file one number or three.
    #[serde(with = "coefficient")]
    pub ka: Rgb,
    /// Diffuse coefficient.
    #[serde(with = "coefficient")]
    pub kd: Rgb,
    /// Specular coefficient.
    #[serde(with = "coefficient")]
    pub ks: Rgb,
    /// The specular exponent, from 0 to infinity (a mirror).
    pub n: f64,
    /// The root mean square slope of the microfacets (Beckmann), or their width α (GGX); Cook–Torrance only.
    pub roughness: f64,
    /// Od, the surface's own colour, which multiplies `ka` and `kd`.
    pub color: Rgb,
    /// Os, the colour of the highlight, which multiplies `ks`; white leaves it the light's own.
    pub specular_color: Rgb,
    /// W(θ), how the specular coefficient depends on the angle of incidence.
    pub reflectance: Reflectance,
    /// Index of refraction per channel, `reflectance = "custom"` only.
    pub ior: Rgb,
    /// Extinction coefficient, the imaginary part of the index, per channel, `reflectance = "custom"` only.
    pub extinction: Rgb,
}

/// W(θ): the part of the light that is reflected at the angle of incidence θ.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Reflectance {
    /// 1, whatever the angle: Phong's own model.
    Constant,
    /// Fresnel's formulas for crown glass.
    Glass,
    /// For silver.
    Silver,
    /// For gold.
    Gold,
    /// For a material's own complex index of refraction.
    Custom,
}

impl Default for Material {
    fn default() -> Self {
        Self {
            ka: Rgb::splat(0.1),
            kd: Rgb::splat(0.7),
            ks: Rgb::splat(0.4),
            n: 32.0,
            roughness: 0.25,
            color: Rgb::new(0.9, 0.3, 0.2),
            specular_color: Rgb::ONE,
            reflectance: Reflectance::Constant,
            ior: Rgb::splat(1.5),
            extinction: Rgb::ZERO,
        }
    }
}

/// A coefficient is written as one number where the channels agree and read from one number or three.
mod coefficient {
    use super::Rgb;
    use serde::de::{self, SeqAccess, Visitor};
    use serde::ser::SerializeSeq;
    use serde::{Deserializer, Serializer};
    use std::fmt;

    pub fn serialize<S: Serializer>(value: &Rgb, serializer: S) -> Result<S::Ok, S::Error> {
        if value.x == value.y && value.y == value.z {
            return serializer.serialize_f64(value.x);
        }
        let mut sequence = serializer.serialize_seq(Some(3))?;
        for channel in value.to_array() {
            sequence.serialize_element(&channel)?;
        }
        sequence.end()
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Rgb, D::Error> {
        deserializer.deserialize_any(NumberOrThree)
    }

    struct NumberOrThree;

    impl<'de> Visitor<'de> for NumberOrThree {
        type Value = Rgb;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            f.write_str("a number or [red, green, blue]")
        }

        fn visit_f64<E: de::Error>(self, value: f64) -> Result<Rgb, E> {
            Ok(Rgb::splat(value))
        }

        #[expect(clippy::cast_precision_loss, reason = "a whole number in a file stands for a real one")]
        fn visit_i64<E: de::Error>(self, value: i64) -> Result<Rgb, E> {
            Ok(Rgb::splat(value as f64))
        }

        fn visit_seq<A: SeqAccess<'de>>(self, mut sequence: A) -> Result<Rgb, A::Error> {
            let mut channels = [0.0; 3];
            for (i, channel) in channels.iter_mut().enumerate() {
                *channel = sequence.next_element()?.ok_or_else(|| de::Error::invalid_length(i, &self))?;
            }
            if sequence.next_element::<f64>()?.is_some() {
                return Err(de::Error::invalid_length(4, &self));
            }
            Ok(Rgb::from_array(channels))
        }
    }
}
