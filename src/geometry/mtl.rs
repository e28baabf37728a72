//! The materials of a model, as its MTL file gives them.

use crate::scene::{FaceMaterial, Material, Rgb, Transparency};
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
    /// True if a texture (`map_d`) has the opacity.
    pub masked: bool,
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

    /// Returns the numbers of the equation, and those of the light that passes: Kt = 1 − `d`, in every illumination model, and
    /// η = `Ni`.
    ///
    /// `illum` does not decide: Maya writes 4, glass, for whatever is opaque, and Blender `d` below 1 with its 6 and 9. Old
    /// Blender writes `d 0` where a texture has the opacity; that is opaque without the texture. Without `Ni`, or with 0 for
    /// none, light is not bent.
    pub fn face_material(&self) -> FaceMaterial {
        let hidden = |d: &f64| self.masked && *d == 0.0;
        let dissolve = self.dissolve.filter(|d| !hidden(d)).unwrap_or(1.0);
        let ior = self.ior.filter(|ior| *ior > 0.0).unwrap_or(1.0);
        FaceMaterial {
            material: self.material(),
            kt: 1.0 - dissolve,
            relative_ior: ior.clamp(*Transparency::IOR.start(), *Transparency::IOR.end()),
        }
    }

    /// Returns whether its makers mean light to pass by `Ks` and `Tf`, as Wavefront's models 6 and 7 have it, without a `d`.
    pub fn refracts_by_model(&self) -> bool {
        matches!(self.illum, Some(6 | 7)) && self.face_material().kt == 0.0
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
