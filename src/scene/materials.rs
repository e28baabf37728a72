//! The named materials of the OpenGL tradition, as published.
//!
//! The numbers are those of `teapots.c` by Mark J. Kilgard (1994, GLUT 3.7, `progs/redbook`), the program of the *OpenGL
//! Programming Guide*'s plate of 24 teapots: ambient, diffuse and specular reflectance per channel, and a shininess
//! which times 128 is the exponent. OpenGL measures it from N to H, as Blinn's model does; under Phong's the same n makes
//! a highlight twice as wide.

use super::{Material, MaterialSource, Rgb};
use crate::text::text;

/// A material with a name.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NamedMaterial {
    /// The name on the command line: lower-case words with hyphens.
    pub name: &'static str,
    /// Ambient coefficient per channel.
    pub ka: Rgb,
    /// Diffuse coefficient per channel.
    pub kd: Rgb,
    /// Specular coefficient per channel.
    pub ks: Rgb,
    /// The exponent of `(N·H)^n`.
    pub n: f64,
}

/// Every named material: stones, metals, plastics, rubbers, six of each.
#[rustfmt::skip]
pub const NAMED: &[NamedMaterial] = &[
    named("emerald", [0.0215, 0.1745, 0.0215], [0.07568, 0.61424, 0.07568], [0.633, 0.727811, 0.633], 0.6),
    named("jade", [0.135, 0.2225, 0.1575], [0.54, 0.89, 0.63], [0.316228, 0.316228, 0.316228], 0.1),
    named("obsidian", [0.05375, 0.05, 0.06625], [0.18275, 0.17, 0.22525], [0.332741, 0.328634, 0.346435], 0.3),
    named("pearl", [0.25, 0.20725, 0.20725], [1.0, 0.829, 0.829], [0.296648, 0.296648, 0.296648], 0.088),
    named("ruby", [0.1745, 0.01175, 0.01175], [0.61424, 0.04136, 0.04136], [0.727811, 0.626959, 0.626959], 0.6),
    named("turquoise", [0.1, 0.18725, 0.1745], [0.396, 0.74151, 0.69102], [0.297254, 0.30829, 0.306678], 0.1),
    named("brass", [0.329412, 0.223529, 0.027451], [0.780392, 0.568627, 0.113725], [0.992157, 0.941176, 0.807843], 0.21794872),
    named("bronze", [0.2125, 0.1275, 0.054], [0.714, 0.4284, 0.18144], [0.393548, 0.271906, 0.166721], 0.2),
    named("chrome", [0.25, 0.25, 0.25], [0.4, 0.4, 0.4], [0.774597, 0.774597, 0.774597], 0.6),
    named("copper", [0.19125, 0.0735, 0.0225], [0.7038, 0.27048, 0.0828], [0.256777, 0.137622, 0.086014], 0.1),
    named("gold", [0.24725, 0.1995, 0.0745], [0.75164, 0.60648, 0.22648], [0.628281, 0.555802, 0.366065], 0.4),
    named("silver", [0.19225, 0.19225, 0.19225], [0.50754, 0.50754, 0.50754], [0.508273, 0.508273, 0.508273], 0.4),
    named("black-plastic", [0.0, 0.0, 0.0], [0.01, 0.01, 0.01], [0.5, 0.5, 0.5], 0.25),
    named("cyan-plastic", [0.0, 0.1, 0.06], [0.0, 0.50980392, 0.50980392], [0.50196078, 0.50196078, 0.50196078], 0.25),
    named("green-plastic", [0.0, 0.0, 0.0], [0.1, 0.35, 0.1], [0.45, 0.55, 0.45], 0.25),
    named("red-plastic", [0.0, 0.0, 0.0], [0.5, 0.0, 0.0], [0.7, 0.6, 0.6], 0.25),
    named("white-plastic", [0.0, 0.0, 0.0], [0.55, 0.55, 0.55], [0.7, 0.7, 0.7], 0.25),
    named("yellow-plastic", [0.0, 0.0, 0.0], [0.5, 0.5, 0.0], [0.6, 0.6, 0.5], 0.25),
    named("black-rubber", [0.02, 0.02, 0.02], [0.01, 0.01, 0.01], [0.4, 0.4, 0.4], 0.078125),
    named("cyan-rubber", [0.0, 0.05, 0.05], [0.4, 0.5, 0.5], [0.04, 0.7, 0.7], 0.078125),
    named("green-rubber", [0.0, 0.05, 0.0], [0.4, 0.5, 0.4], [0.04, 0.7, 0.04], 0.078125),
    named("red-rubber", [0.05, 0.0, 0.0], [0.5, 0.4, 0.4], [0.7, 0.04, 0.04], 0.078125),
    named("white-rubber", [0.05, 0.05, 0.05], [0.5, 0.5, 0.5], [0.7, 0.7, 0.7], 0.078125),
    named("yellow-rubber", [0.05, 0.05, 0.0], [0.5, 0.5, 0.4], [0.7, 0.7, 0.04], 0.078125),
];

/// The number of consecutive materials of a kind in [`NAMED`].
pub const OF_A_KIND: usize = 6;

const fn named(
    name: &'static str,
    ka: [f64; 3],
    kd: [f64; 3],
    ks: [f64; 3],
    shininess: f64,
) -> NamedMaterial {
    NamedMaterial {
        name,
        ka: Rgb::from_array(ka),
        kd: Rgb::from_array(kd),
        ks: Rgb::from_array(ks),
        n: 128.0 * shininess,
    }
}

/// Finds the material of that name.
pub fn find(name: &str) -> Option<&'static NamedMaterial> {
    NAMED.iter().find(|material| material.name == name)
}

/// Finds the named material that equals `material`, if there is one.
pub fn recognise(material: &Material) -> Option<&'static NamedMaterial> {
    let own = Material {
        source: MaterialSource::Model,
        ..material.clone()
    };
    NAMED.iter().find(|named| named.material() == own)
}

impl NamedMaterial {
    /// Returns the title for people.
    pub fn title(&self) -> &'static str {
        text!(&format!("material-{}", self.name))
    }

    /// Returns the material: its colours are in its coefficients, and its roughness is that of its n.
    pub fn material(&self) -> Material {
        let Self { ka, kd, ks, n, .. } = *self;
        Material {
            ka,
            kd,
            ks,
            n,
            roughness: Material::roughness_of(n),
            color: Rgb::ONE,
            ..Material::default()
        }
    }
}
