//! The equation in letters.
//!
//! A formula is a string with its letters in braces: `{Kd}` is a letter, `{n}` a superscript one, `{^40}` makes a
//! number a superscript and `{=0.61}` is a result.

use crate::figure::palette::Vector;
use crate::figure::short;
use crate::scene::{
    Attenuation, CuedBy, Light, LightKind, Reflectance, ReflectionModel, Rgb, Scene,
};
use crate::text;

/// The colour of a piece of text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tone {
    /// The colour of text.
    Plain,
    /// The colour of remarks.
    Weak,
    /// The colour of headings.
    Strong,
    /// The colour of a vector, and of the term that it determines.
    Of(Vector),
}

/// A part of the equation: its formula, its colour, and whether the scene omits it.
pub type Letters = (String, Tone, bool);

/// Returns the equation with the factors that a scene has, in parts that stay on one line.
pub fn equation_letters(scene: &Scene) -> Vec<Vec<Letters>> {
    let Scene {
        material,
        reflection,
        lights,
        ..
    } = scene;
    let letters = |formula: &str, tone: Tone, absent: bool| (formula.to_owned(), tone, absent);
    let plain = |formula: &str, absent: bool| letters(formula, Tone::Plain, absent);
    let (dark, sky) = (lights.is_empty(), Tone::Of(Vector::T));
    let no_ambient = material.ka == Rgb::ZERO || scene.ambient.color == Rgb::ZERO;
    let steady = lights
        .iter()
        .all(|light| light.attenuation == Attenuation::None);
    let spot = lights.iter().any(|light| light.kind == LightKind::Spot);
    let os = if material.specular_color == Rgb::ONE {
        ""
    } else {
        "{Os}"
    };
    let w = if material.reflectance == Reflectance::Constant {
        ""
    } else {
        " {W}(θ) "
    };
    let lobe = match reflection.model {
        ReflectionModel::Phong => "({R}·{V})^n]",
        ReflectionModel::Blinn => "({N}·{H})^n]",
        ReflectionModel::CookTorrance => " π {D}{G}",
        ReflectionModel::Formula => "",
    };
    let own = reflection.model == ReflectionModel::Formula;
    let specular = |formula: &str| {
        let tone = Tone::Of(specular_vector(reflection.model));
        vec![letters(formula, tone, dark || material.ks == Rgb::ZERO)]
    };
    let transparent = scene.transparency.kt > 0.0;
    let opaque = letters(if transparent { "(1 − {Kt}) ( " } else { "" }, sky, false);
    let mut parts = vec![
        vec![
            letters("{I} = ", Tone::Strong, false),
            opaque,
            plain("{Ka}{Od}{Ia}", no_ambient),
        ],
        vec![
            plain(" + {Σ}", dark),
            plain("{f}", steady),
            plain(if spot { "{spot}" } else { "" }, dark),
            plain(if scene.shading.shadows { "{lit}" } else { "" }, dark),
            plain(if own { "{Ip}" } else { "{Ip} [" }, dark),
        ],
    ];
    if own {
        parts.push(vec![letters("{law}", Tone::Of(Vector::L), dark)]);
    } else {
        parts.push(vec![letters(
            "{Kd}{Od}({N}·{L})",
            Tone::Of(Vector::L),
            dark || material.kd == Rgb::ZERO,
        )]);
        parts.push(specular(&format!(" + {{Ks}}{os}{w}{lobe}")));
    }
    if reflection.model == ReflectionModel::CookTorrance {
        parts.push(specular(" / (4 {N}·{V})]"));
    }
    if transparent {
        parts.push(vec![letters(" ) + {Kt}{It}", sky, false)]);
    }
    if scene.depth_cueing.by != CuedBy::Off {
        parts.push(vec![plain(
            &format!(
                "   {}: {{s0}} I + (1 − {{s0}}) {{Idc}}",
                text!("point-seen")
            ),
            false,
        )]);
    }
    parts
}

/// Returns a formula as plain text, with a dot between adjacent letters.
pub fn plain_formula(formula: &str) -> String {
    let text = formula
        .replace("}(θ) ", "(θ)}")
        .replace("} {", "}{")
        .replace("{Σ}", "Σ ")
        .replace("{=", "");
    text.replace("}{", "}·{")
        .replace("}(", "}·(")
        .replace(['{', '}'], "")
}

/// Returns the law by which a light is attenuated, with its constants filled in.
pub fn attenuation_law(light: &Light) -> String {
    let [k, c1, c2, c3] = [light.k, light.c1, light.c2, light.c3].map(short);
    let to = |law: String| text!("point-law", law = law);
    match light.attenuation {
        Attenuation::Viewer => text!("point-law-viewer", k = k),
        _ if !light.kind.has_position() => text!("point-law-directional").to_owned(),
        Attenuation::None => text!("point-law-none").to_owned(),
        Attenuation::Light => text!("point-law-light", k = k),
        Attenuation::InverseSquare => to("f = 1/d²".to_owned()),
        Attenuation::Quadratic => to(format!("f = min(1, 1/({c1} + {c2} d + {c3} d²))")),
    }
}

/// Returns the vector whose colour the specular term has.
pub fn specular_vector(model: ReflectionModel) -> Vector {
    if model == ReflectionModel::Blinn {
        Vector::H
    } else {
        Vector::R
    }
}

/// Formats n, without decimals if it is whole.
pub fn exponent(n: f64) -> String {
    match n {
        f64::INFINITY => "∞".into(),
        n if n.fract() == 0.0 && n < 1e6 => n.to_string(),
        n => short(n),
    }
}
