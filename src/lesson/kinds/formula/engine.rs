//! A term of the engine's own equation as a formula: its text, compared with what the engine computes.

use super::domain::{Name, points};
use super::function::Function;
use super::quantity::Quantity;
use crate::illumination::Equation;
use crate::lesson::read::keys::Term;
use crate::scene::{
    Attenuation, Backfacing, LightKind, PatternKind, ReflectionModel, Rgb, Scene, Viewer,
};
use crate::text::text;
use glam::DVec3;

/// The number of points at which the engine evaluates the term; corners and edges are among them.
const EVALUATED: usize = 2 * 256;
/// The largest difference between the engine and the text: the engine cuts the highlight off where N·L is below 10⁻¹³ and
/// computes with the same precision otherwise.
const TOLERANCE: f64 = 1e-9;

/// Returns a term of the equation as it stands in a scene, over the names that a question allows: what has no name has the
/// value of the scene.
///
/// # Errors
/// A term that has no formula over these names, or that the engine computes otherwise in this scene.
pub fn term_text(term: Term, names: &[Name], scene: &Scene) -> Result<String, String> {
    let text =
        written(term, names, scene).ok_or_else(|| text!("lesson-formula-no-term").to_owned())?;
    let formula = Function::read(&text, names).map_err(|error| error.to_string())?;
    for point in points(names).into_iter().take(EVALUATED) {
        let Some(engine) = evaluate(term, names, &point, scene) else {
            continue;
        };
        let written = formula
            .at(&point)
            .map_or(f64::NAN, |value| value.components()[0]);
        let off = (engine - written).abs();
        if off.is_nan() || off > TOLERANCE * engine.abs().max(1.0) {
            return Err(text!("lesson-formula-other-term", text = text));
        }
    }
    Ok(text)
}

/// Writes a term over the names that there are.
fn written(term: Term, names: &[Name], scene: &Scene) -> Option<String> {
    let has = |name: &str| names.iter().any(|known| known.name == name);
    let factors = |all: &[&str]| -> Vec<String> {
        let there = all.iter().filter(|name| has(name));
        there.map(|name| (*name).to_owned()).collect()
    };
    let flips = scene.reflection.backfacing == Backfacing::Flip;
    let parts = match term {
        Term::Ambient => factors(&["ka", "od", "ia"]),
        Term::Diffuse if has("N·L") => {
            let cosine = if flips { "abs(N·L)" } else { "max(N·L, 0)" };
            let mut parts = factors(&["f", "kd", "od", "ip"]);
            parts.push(cosine.to_owned());
            parts
        }
        Term::Specular => {
            let cosine = match scene.reflection.model {
                ReflectionModel::Phong if has("R·V") => "R·V",
                ReflectionModel::Blinn if has("N·H") => "N·H",
                _ => return None,
            };
            let n = if has("n") {
                "n".to_owned()
            } else {
                scene.material.n.to_string()
            };
            let mut parts = factors(&["f", "ks", "os", "ip"]);
            parts.push(format!("max({cosine}, 0)^{n}"));
            if has("N·L") && !flips {
                parts.insert(0, "(N·L > 0)".to_owned());
            }
            parts
        }
        Term::Attenuation if ["c1", "c2", "c3", "d"].into_iter().all(has) => {
            vec!["min(1, 1/(c1 + c2*d + c3*d^2))".to_owned()]
        }
        _ => return None,
    };
    (!parts.is_empty()).then(|| parts.join(" * "))
}

/// Evaluates a term by the engine at a point of the domain: the surface lies at the origin, and L, N and V in the plane y = 0.
/// Returns nothing where no directions have these cosines.
fn evaluate(term: Term, names: &[Name], point: &[Quantity], scene: &Scene) -> Option<f64> {
    let value = |wanted: &str| {
        let place = names.iter().position(|name| name.name == wanted)?;
        Some(point[place].components()[0])
    };
    let mut scene = scene.clone();
    scene.lights.truncate(1);
    scene.pattern.kind = PatternKind::None;
    set_numbers(&mut scene, &value);
    leave(term, &mut scene);
    let along =
        |degrees: f64| DVec3::new(degrees.to_radians().sin(), 0.0, degrees.to_radians().cos());
    let angle = |name: &str| value(name).map(|cosine| cosine.acos().to_degrees());
    let normal = angle("N·L").unwrap_or(0.0);
    let view = match (angle("R·V"), angle("N·H")) {
        (Some(phi), _) => 2.0 * normal + phi,
        (None, Some(alpha)) if (normal - alpha).abs() < 90.0 => 2.0 * (normal - alpha),
        (None, Some(_)) => return None,
        (None, None) => 0.0,
    };
    let light = scene.lights.first_mut()?;
    light.kind = match value("d") {
        Some(_) => LightKind::Point,
        None => LightKind::Directional,
    };
    light.position = along(0.0) * value("d").unwrap_or(1.0);
    light.direction = -along(0.0);
    scene.camera.viewer = Viewer::Local;
    scene.camera.target = DVec3::ZERO;
    scene.camera.eye = 4.0 * along(view);
    let equation = Equation::<f64>::new(&scene);
    let [red, ..] = equation
        .illuminate_world(DVec3::ZERO, along(normal), None)
        .to_array();
    Some(value("f").unwrap_or(1.0) * red)
}

/// Gives the scene the values of the names that are its numbers, where `value` returns one.
fn set_numbers(scene: &mut Scene, value: &dyn Fn(&str) -> Option<f64>) {
    let set = |colour: &mut Rgb, name: &str| {
        if let Some(value) = value(name) {
            *colour = Rgb::splat(value);
        }
    };
    let material = &mut scene.material;
    set(&mut material.ka, "ka");
    set(&mut material.kd, "kd");
    set(&mut material.ks, "ks");
    set(&mut material.color, "od");
    set(&mut material.specular_color, "os");
    material.n = value("n").unwrap_or(material.n);
    set(&mut scene.ambient.color, "ia");
    for light in &mut scene.lights {
        set(&mut light.color, "ip");
        light.c1 = value("c1").unwrap_or(light.c1);
        light.c2 = value("c2").unwrap_or(light.c2);
        light.c3 = value("c3").unwrap_or(light.c3);
    }
}

/// Leaves one term of the equation; of the attenuation what it makes of a white lamp on a white surface.
fn leave(term: Term, scene: &mut Scene) {
    let material = &mut scene.material;
    let terms = [
        (Term::Ambient, &mut material.ka),
        (Term::Diffuse, &mut material.kd),
        (Term::Specular, &mut material.ks),
    ];
    for (other, coefficient) in terms {
        if other != term {
            *coefficient = Rgb::ZERO;
        }
    }
    if term == Term::Attenuation {
        (material.kd, material.color) = (Rgb::ONE, Rgb::ONE);
        for light in &mut scene.lights {
            light.color = Rgb::ONE;
            light.attenuation = Attenuation::Quadratic;
        }
    }
}
