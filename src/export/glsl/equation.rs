//! The terms of the equation: the material's constants, the specular factor, W and the pattern.

use super::super::number::{float, said, vec3};
use crate::illumination::{Index, SpecularForm};
use crate::scene::{Backfacing, Material, ObjectKind, Pattern, PatternKind, Scene, Viewer};

/// Stands for n = ∞.
const MIRROR: f64 = 1e30;

const POWERS: &str = include_str!("power_of_cosine.glsl");
const CHORD: &str = include_str!("power_of_chord.glsl");
const FACET: &str = include_str!("facet.glsl");
const BECKMANN: &str = include_str!("beckmann.glsl");
const GGX: &str = include_str!("ggx.glsl");
const FRESNEL: &str = include_str!("fresnel.glsl");

/// The numbers that do not depend on the point.
pub(super) fn constants(scene: &Scene) -> String {
    let Material { ka, kd, ks, color, specular_color, .. } = scene.material;
    let form = SpecularForm::of(scene);
    let mut text = format!(
        "{}const vec3 Ia = {};
const vec3 Ka = {};
const vec3 Kd = {};
const vec3 Od = {}; // the surface's colour
",
        viewer(scene),
        vec3(scene.ambient.color),
        vec3(ka),
        vec3(kd),
        vec3(color)
    );
    if form != SpecularForm::None {
        text += &format!(
            "const vec3 Ks = {};\nconst vec3 Os = {}; // the highlight's colour\n",
            vec3(ks),
            vec3(specular_color)
        );
        text += &lobe(&scene.material, form);
    }
    text
}

fn viewer(scene: &Scene) -> String {
    let eye = format!("uniform vec3 eye = {}; // world\n", vec3(scene.camera.eye));
    match scene.camera.viewer {
        Viewer::Local => eye,
        Viewer::Infinite => {
            let v = (scene.camera.eye - scene.camera.target).normalize_or_zero();
            format!("{eye}uniform vec3 towards_viewer = {}; // V, constant: the viewer is at infinity\n", vec3(v))
        }
    }
}

fn lobe(material: &Material, form: SpecularForm) -> String {
    match form {
        SpecularForm::None => String::new(),
        SpecularForm::Beckmann | SpecularForm::Ggx => {
            let means = if form == SpecularForm::Ggx { "alpha" } else { "the microfacets' root mean square slope" };
            format!("const float m = {}; // roughness: {means}\n", float(material.roughness))
        }
        _ if material.n > MIRROR => format!("const float n = {}; // a mirror\n", float(MIRROR)),
        _ => format!("const float n = {};\n", float(material.n)),
    }
}

/// The functions that the lights' contributions are made of, and `reflected`, which puts them together.
pub(super) fn terms(scene: &Scene) -> String {
    let form = SpecularForm::of(scene);
    let index = Index::of(&scene.material).filter(|_| form != SpecularForm::None);
    let mut text = String::new();
    if scene.pattern.kind != PatternKind::None {
        text += &pattern(&scene.pattern, scene.object.kind);
    }
    text += &specular(form);
    if let Some(index) = index {
        let (eta, k) = (vec3(index.eta), vec3(index.k));
        text += &format!(
            "// The complex index of refraction, per channel.\nconst vec3 eta = {eta}, kappa = {k};\n\n{FRESNEL}\n"
        );
    }
    text + &reflected(scene, form, index.is_some())
}

/// `specular_factor`, the S of the equation.
fn specular(form: SpecularForm) -> String {
    let (helpers, doc, body) = match form {
        SpecularForm::None => return String::new(),
        SpecularForm::PhongCosine => {
            (POWERS.to_owned(), "S = (R.V)^n with R = 2N(N.L) - L (Phong)", "power(2.0 * NL * dot(N, V) - dot(L, V))")
        }
        SpecularForm::PhongChord => {
            (CHORD.to_owned(), "S = (R.V)^n with R = 2N(N.L) - L (Phong)", "power(2.0 * NL * N - L, V)")
        }
        SpecularForm::BlinnCosine => {
            (POWERS.to_owned(), "S = (N.H)^n with H = (L + V)/|L + V| (Blinn)", "power(dot(N, normalize(L + V)))")
        }
        SpecularForm::BlinnChord => {
            (CHORD.to_owned(), "S = (N.H)^n with H = (L + V)/|L + V| (Blinn)", "power(N, normalize(L + V))")
        }
        SpecularForm::Beckmann => (
            format!("{FACET}\n{BECKMANN}"),
            "S = pi*D*G/(4*(N.V)) (Cook and Torrance, Beckmann)",
            "facets(N, L, V, NL)",
        ),
        SpecularForm::Ggx => (
            format!("{FACET}\n{GGX}"),
            "S = pi*D*G/(4*(N.V)) (Cook and Torrance, Walter et al.)",
            "facets(N, L, V, NL)",
        ),
    };
    format!(
        "{helpers}\n// {doc}.\nfloat specular_factor(vec3 N, vec3 L, vec3 V, float NL) {{\n    return {body};\n}}\n\n"
    )
}

fn reflected(scene: &Scene, form: SpecularForm, fresnel: bool) -> String {
    let turn = match scene.reflection.backfacing {
        Backfacing::Clamp => "",
        Backfacing::Flip => {
            "    if (NL < 0.0) {
        // The surface has two sides: N is turned towards the light.
        N = -N;
        NL = -NL;
    }
"
        }
    };
    let (incidence, w) = match (fresnel, form.at_halfway()) {
        (false, _) => ("", ""),
        // |L + V|/2 is the cosine of half the angle between them.
        (true, true) => ("    vec3 W = reflectance(0.5 * length(L + V));\n", " * W"),
        (true, false) => ("    vec3 W = reflectance(NL);\n", " * W"),
    };
    let specular = match form {
        SpecularForm::None => String::new(),
        _ => format!(" + Ks * Os{w} * specular_factor(N, L, V, NL)"),
    };
    format!(
        "// What light of the intensity E = f*Ip from the direction L adds to I.
vec3 reflected(vec3 N, vec3 L, vec3 V, vec3 color, vec3 E) {{
    float NL = dot(N, L);
{turn}    if (NL <= 0.0) return vec3(0.0);
{incidence}    return E * (Kd * color * NL{specular});
}}
"
    )
}

/// `surface_color`, Od at a point.
fn pattern(pattern: &Pattern, object: ObjectKind) -> String {
    let around = if object.faces_viewer() { "xy" } else { "xz" };
    let count = match pattern.kind {
        PatternKind::None => return String::new(),
        PatternKind::Checker => "floor(p.x + 0.5) + floor(p.y + 0.5) + floor(p.z + 0.5)".to_owned(),
        PatternKind::Stripes => "floor(p.y + 0.5)".to_owned(),
        PatternKind::Rings => format!("floor(length(p.{around}) + 0.5)"),
    };
    format!(
        "// Od at P: fields {} wide, counted from the origin, every other one in the pattern's colour.
vec3 surface_color(vec3 P) {{
    const vec3 pattern = {};
    vec3 p = P / {};
    float count = {count};
    return mod(count, 2.0) > 0.5 ? pattern : Od;
}}

",
        said(pattern.scale),
        vec3(pattern.color),
        float(pattern.scale)
    )
}
