//! The materials of a model, as its MTL file gives them.

use crate::scene::{Material, Rgb};
use serde::{Deserialize, Serialize};

/// The number of a face whose material the model does not define: the scene's is used there.
pub const NO_MATERIAL: u16 = u16::MAX;

/// A material of a model's MTL file, with the statements that the file has.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ModelMaterial {
    /// The name after `newmtl`.
    pub name: String,
    /// `Ka`, the ambient coefficient per channel.
    pub ka: Option<Rgb>,
    /// `Kd`, the diffuse coefficient times the colour, Kd·Od, per channel.
    pub kd: Option<Rgb>,
    /// `Ks`, the specular coefficient per channel.
    pub ks: Option<Rgb>,
    /// `Ns`, the specular exponent n.
    pub n: Option<f64>,
    /// `d`, or 1 − `Tr`: the part that is not transparent.
    pub dissolve: Option<f64>,
    /// `Ni`, the index of refraction.
    pub ior: Option<f64>,
    /// `illum`, the number of the illumination model: 0 and 1 have no highlight.
    pub illum: Option<u32>,
    /// The textures' files, without their folders, which are not drawn.
    pub maps: Vec<String>,
}

impl ModelMaterial {
    /// The most materials of a model.
    pub const MAX: usize = 512;

    /// Returns the numbers of the equation.
    ///
    /// The colour is white and the coefficients carry the channels, as with the named materials of OpenGL: an MTL file has one
    /// `Kd` for Kd·Od, and its `Ka` and `Ks` are not tinted by it. A statement that is missing has the value that Wavefront's
    /// format gives it (`Ka` 0.2, `Kd` 0.8, `Ks` 1, `Ns` 0), and without both `illum` and `Ks` there is no highlight.
    /// There is none with `Ns` 0 either, which Blender and MeshLab write for a surface without gloss.
    pub fn material(&self) -> Material {
        const KA: f64 = 0.2;
        const KD: f64 = 0.8;
        const KS: f64 = 1.0;
        let coefficient = |given: Option<Rgb>, default: f64| {
            let most = Rgb::splat(Material::MAX_COEFFICIENT);
            given.unwrap_or(Rgb::splat(default)).clamp(Rgb::ZERO, most)
        };
        let n = self.n.unwrap_or(0.0).max(0.0);
        let highlight = n > 0.0 && self.illum.map_or(self.ks.is_some(), |model| model > 1);
        Material {
            ka: coefficient(self.ka, KA),
            kd: coefficient(self.kd, KD),
            ks: if highlight {
                coefficient(self.ks, KS)
            } else {
                Rgb::ZERO
            },
            n,
            color: Rgb::ONE,
            roughness: Material::roughness_of(n),
            ..Material::default()
        }
    }
}

/// A sentence about the materials of a model, and its place in the files.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Remark {
    /// The library; none for the model's own file.
    pub library: Option<String>,
    /// The line, counted from 1.
    pub line: u64,
    /// The sentence, in the language in which the model was read.
    pub words: String,
}
