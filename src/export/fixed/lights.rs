//! The lights of fixed-function OpenGL, and their limitations.

use crate::export::limit::{Limit, holding, limit};
use crate::export::sources::{Emitter, EmitterPosition, emitters};
use crate::export::text::{c_float, c_four, c_three, filled, said};
use crate::geometry::VertexMesh;
use crate::scene::{Attenuation, Backfacing, Light, LightKind, Scene, Viewer};
use glam::DVec3;

/// Maximum of `GL_SHININESS` and `GL_SPOT_EXPONENT`.
pub const GREATEST_EXPONENT: f64 = 128.0;

/// Number of lights that every OpenGL has.
const MOST_LIGHTS: usize = 8;

/// Returns the features of the scene's lights that fixed-function OpenGL cannot express.
pub fn light_limits(scene: &Scene, mesh: &VertexMesh) -> Vec<Limit> {
    let emitters = emitters(scene);
    let whole = fits(&emitters);
    let mut limits: Vec<Limit> = emitters
        .iter()
        .flat_map(|emitter| emitter_limits(emitter, mesh, whole))
        .collect();
    if emitters.len() > MOST_LIGHTS {
        limits.push(limit!(
            "export-limit-lights",
            shining = emitters.len(),
            most = MOST_LIGHTS
        ));
    }
    limits
}

fn emitter_limits(emitter: &Emitter<'_>, mesh: &VertexMesh, whole: bool) -> Vec<Limit> {
    let light = emitter.light;
    let spot = light.kind == LightKind::Spot;
    let points = match &emitter.place {
        EmitterPosition::Among(points) if light.kind == LightKind::Area && !whole => points.len(),
        _ => 0,
    };
    let unclamped = match (light.attenuation, emitter.constant, &emitter.place) {
        (Attenuation::Quadratic, None, EmitterPosition::At(place)) => {
            let [inside, outside] = sides(light, *place, mesh);
            inside && outside
        }
        (Attenuation::Quadratic, None, EmitterPosition::Among(_)) => light.c1 < 1.0,
        _ => false,
    };
    let number = emitter.index + 1;
    holding([
        (
            points > 0,
            limit!("export-limit-light-area", light = number, points = points),
        ),
        (
            spot && light.softness > 0.0,
            limit!("export-limit-light-soft", light = number),
        ),
        (
            spot && light.exponent > GREATEST_EXPONENT,
            limit!(
                "export-limit-light-exponent",
                light = number,
                exponent = said(light.exponent)
            ),
        ),
        (
            light.attenuation == Attenuation::Viewer,
            limit!("export-limit-light-viewer", light = number),
        ),
        (
            unclamped,
            limit!("export-limit-light-unclamped", light = number),
        ),
    ])
}

/// Returns whether all points of all area lights fit among the lights that OpenGL has.
fn fits(emitters: &[Emitter<'_>]) -> bool {
    let count = |emitter: &Emitter<'_>| {
        if let EmitterPosition::Among(points) = &emitter.place {
            points.len()
        } else {
            1
        }
    };
    emitters.iter().map(count).sum::<usize>() <= MOST_LIGHTS
}

/// Writes `set_up_lights()`: `glLight*` and `glLightModel*`. An area light becomes its sample points if all of them
/// fit, otherwise the point in its middle.
pub fn lights(scene: &Scene, mesh: &VertexMesh) -> String {
    let emitters = emitters(scene);
    let whole = fits(&emitters);
    let lamps = emitters
        .iter()
        .flat_map(|emitter| lamps(emitter, whole))
        .take(MOST_LIGHTS)
        .enumerate();
    let blocks: String = lamps
        .map(|(index, lamp)| light(index, &lamp, scene, mesh))
        .collect();
    let (local, viewer) = match scene.camera.viewer {
        Viewer::Local => ("GL_TRUE", "V points to the eye, from each point"),
        Viewer::Infinite => ("GL_FALSE", "V is constant: the viewer is at infinity"),
    };
    let (two_sided, sides) = match scene.reflection.backfacing {
        Backfacing::Clamp => ("GL_FALSE", "N.L < 0 counts as 0"),
        Backfacing::Flip => ("GL_TRUE", "N is turned on polygons seen from behind"),
    };
    let black = if blocks.is_empty() {
        ""
    } else {
        "    const GLfloat black[] = {0.0f, 0.0f, 0.0f, 1.0f};"
    };
    filled(
        include_str!("lights.c"),
        &[
            ("black", black),
            ("ambient", &c_four(scene.ambient.color, 1.0)),
            ("local", local),
            ("viewer", viewer),
            ("two_sided", two_sided),
            ("sides", sides),
            ("lights", &blocks),
        ],
    )
}

/// A point that shines.
struct Lamp<'a> {
    emitter: &'a Emitter<'a>,
    title: String,
    place: DVec3,
    /// True if `place` is L instead of the light's position.
    parallel: bool,
    /// Share of the emitter's intensity.
    share: f64,
}

fn lamps<'a>(emitter: &'a Emitter<'a>, whole: bool) -> Vec<Lamp<'a>> {
    let title = emitter.title();
    let lamp = |title, place, parallel, share| Lamp {
        emitter,
        title,
        place,
        parallel,
        share,
    };
    match &emitter.place {
        EmitterPosition::Towards(l) => vec![lamp(title, *l, true, 1.0)],
        EmitterPosition::At(place) => vec![lamp(title, *place, false, 1.0)],
        EmitterPosition::Among(points) if whole => {
            let (count, share) = (points.len(), 1.0 / points.len() as f64);
            let titled = |index: usize| format!("{title}: point {} of {count}", index + 1);
            points
                .iter()
                .enumerate()
                .map(|(index, point)| lamp(titled(index), *point, false, share))
                .collect()
        }
        EmitterPosition::Among(_) => vec![lamp(
            title + ": its middle",
            emitter.light.position,
            false,
            1.0,
        )],
    }
}

/// Writes one `GL_LIGHTi`.
fn light(index: usize, lamp: &Lamp<'_>, scene: &Scene, mesh: &VertexMesh) -> String {
    let Lamp {
        emitter,
        ref title,
        place,
        parallel,
        share,
    } = *lamp;
    let light = emitter.light;
    let (f, [c1, c2, c3]) = falloff(emitter, scene, mesh, parallel, place);
    let (w, means, falloff) = if parallel {
        (0.0, "w = 0: L, the same everywhere", "f: none at infinity")
    } else {
        (
            1.0,
            "w = 1: L = (place - P)/d, d = |place - P|",
            "c1 of f = 1/(c1 + c2*d + c3*d^2)",
        )
    };
    let name = format!("GL_LIGHT{index}");
    let (axis, spot) = if light.kind == LightKind::Spot {
        let axis = format!(
            "        const GLfloat axis[] = {{{}}}; /* D, along the cone */",
            c_three(emitter.axis())
        );
        let exponent = c_float(light.exponent.min(GREATEST_EXPONENT));
        let values: [(&str, &str); 3] = [
            ("light", &name),
            ("cone", &c_float(light.cone)),
            ("exponent", &exponent),
        ];
        (axis, filled(include_str!("spot.c"), &values))
    } else {
        let everywhere = format!(
            "        glLightf({name}, GL_SPOT_CUTOFF, 180.0f); /* it shines in all directions */"
        );
        (String::new(), everywhere)
    };
    filled(
        include_str!("light.c"),
        &[
            ("title", title),
            ("place", &c_four(place, w)),
            ("means", means),
            ("color", &c_four(light.color * share * f, 1.0)),
            ("axis", &axis),
            ("light", &name),
            ("c1", &c_float(c1)),
            ("c2", &c_float(c2)),
            ("c3", &c_float(c3)),
            ("falloff", falloff),
            ("spot", &spot),
        ],
    )
}

/// Returns a constant factor, and OpenGL's three coefficients of `f = 1/(c1 + c2·d + c3·d²)`.
fn falloff(
    emitter: &Emitter<'_>,
    scene: &Scene,
    mesh: &VertexMesh,
    parallel: bool,
    place: DVec3,
) -> (f64, [f64; 3]) {
    const NONE: [f64; 3] = [1.0, 0.0, 0.0];
    let light = emitter.light;
    if let Some(f) = emitter.constant {
        return (f, NONE);
    }
    match light.attenuation {
        // OpenGL has no distance to the viewer: that of the target represents all.
        Attenuation::Viewer => (1.0 / (scene.camera.distance() + light.k), NONE),
        _ if parallel => (1.0, NONE),
        Attenuation::Light => (1.0, [light.k, 1.0, 0.0]),
        Attenuation::InverseSquare => (1.0, [0.0, 0.0, 1.0]),
        Attenuation::Quadratic if sides(light, place, mesh)[1] => {
            (1.0, [light.c1, light.c2, light.c3])
        }
        Attenuation::Quadratic | Attenuation::None => (1.0, NONE),
    }
}

/// Returns whether there are vertices within, and beyond, the distance from a light at `place` up to which the
/// `min(1, …)` of its quadratic attenuation applies.
fn sides(light: &Light, place: DVec3, mesh: &VertexMesh) -> [bool; 2] {
    let mut sides = [false; 2];
    for p in &mesh.positions {
        let d = (mesh.origin + p.as_dvec3() - place).length();
        let sum = light.c1 + light.c2 * d + light.c3 * d * d;
        sides[if sum < 1.0 { 0 } else { 1 }] = true;
    }
    sides
}
