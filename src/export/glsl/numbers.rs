//! The numbers of the equation that do not depend on the point, in GLSL.

use super::own_law::OwnLaw;
use crate::export::sources::Materials;
use crate::export::text::{filled, float, vec3};
use crate::illumination::SpecularForm;
use crate::scene::{Distribution, Material, Scene, Viewer};

/// Value that stands for n = ∞.
const MIRROR: f64 = 1e30;

/// Declares a number of the material: a constant, or that of the material that the uniform chooses where they differ.
pub fn own(kind: &str, name: &str, values: &[String]) -> String {
    let (first, count) = (&values[0], values.len());
    if values.iter().all(|value| value == first) {
        return format!("const {kind} {name} = {first};");
    }
    let values = values.join(", ");
    format!(
        "const {kind} all_{name}[{count}] = {kind}[]({values});\n{kind} {name} = all_{name}[material];"
    )
}

/// Writes the numbers that do not depend on the point; of the material's those that the equation, or the scene's own law, has.
pub fn constants(scene: &Scene, materials: &Materials, law: Option<&OwnLaw>) -> String {
    let (camera, forms) = (&scene.camera, materials.each(scene, SpecularForm::of));
    let towards_viewer = match camera.viewer {
        Viewer::Local => String::new(),
        Viewer::Infinite => {
            let v = vec3((camera.eye - camera.target).normalize_or_zero());
            format!("uniform vec3 towards_viewer = {v}; // V, constant: the viewer is at infinity")
        }
    };
    let numbers = |kind, name, value: fn(&Material) -> String| {
        let all = materials.all.iter().map(|own| value(&own.material));
        let values: Vec<String> = all.collect();
        own(kind, name, &values)
    };
    let colors = |name, value: fn(&Material) -> String| numbers("vec3", name, value);
    let has = |name| law.is_none_or(|law| law.uses(name));
    let if_has = |name, declared: String| if has(name) { declared } else { String::new() };
    let exponent = || {
        let n = numbers("float", "n", |material| float(material.n.min(MIRROR)));
        let mirror = materials.all.iter().all(|own| own.material.n > MIRROR);
        n + if mirror { " // a mirror" } else { "" }
    };
    let ks = if_has("ks", colors("Ks", |material| vec3(material.ks)));
    let os = colors("Os", |material| vec3(material.specular_color)) + " // the highlight's colour";
    let os = if_has("os", os);
    let form = forms.iter().find(|form| **form != SpecularForm::None);
    let lobe = match form {
        Some(form) if form.has_microfacets() => {
            let means = if scene.reflection.distribution == Distribution::Ggx {
                "alpha"
            } else {
                "the microfacets' root mean square slope"
            };
            let m = numbers("float", "m", |material| float(material.roughness));
            format!("{m} // roughness: {means}")
        }
        Some(SpecularForm::Formula) => {
            let m = numbers("float", "m", |material| float(material.roughness));
            let eta = colors("eta", |material| vec3(material.ior));
            let all = [
                if_has("n", exponent()),
                if_has("m", m + " // the roughness"),
                if_has("eta", eta + " // the index of refraction"),
            ];
            lines(&all)
        }
        _ => exponent(),
    };
    let specular = match form {
        None => String::new(),
        Some(_) => lines(&[ks, os, lobe]),
    };
    let chosen = match materials.all.len() {
        1 => "",
        _ => "uniform int material = 0; // its number",
    };
    filled(
        include_str!("constants.glsl"),
        &[
            ("eye", &vec3(camera.eye)),
            ("towards_viewer", &towards_viewer),
            ("material", chosen),
            ("Ia", &vec3(scene.ambient.color)),
            ("Ka", &colors("Ka", |material| vec3(material.ka))),
            (
                "Kd",
                &if_has("kd", colors("Kd", |material| vec3(material.kd))),
            ),
            ("Od", &colors("Od", |material| vec3(material.color))),
            ("specular", &specular),
        ],
    )
}

/// Joins lines, without those that are empty.
fn lines(all: &[String]) -> String {
    let filled: Vec<&str> = (all.iter())
        .map(|line| line.as_str())
        .filter(|line| !line.is_empty())
        .collect();
    filled.join("\n")
}
