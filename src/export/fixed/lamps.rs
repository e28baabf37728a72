//! The lights as OpenGL has them: at most eight points, some at infinity.

use super::super::emitter::{Emitter, Place, emitters};
use crate::geometry::VertexMesh;
use crate::scene::{Attenuation, Light, LightKind, Rgb, Scene};
use glam::DVec3;

/// Lights that every OpenGL has.
pub(in super::super) const MOST: usize = 8;

/// One `GL_LIGHTi`.
pub(in super::super) struct Lamp {
    pub title: String,
    pub place: DVec3,
    /// `place` is L, not where the light stands.
    pub parallel: bool,
    /// Ip, f included where that is constant.
    pub color: Rgb,
    /// c1, c2, c3 of `f = 1/(c1 + c2·d + c3·d²)`.
    pub attenuation: [f64; 3],
    pub spot: Option<Spot>,
}

pub(in super::super) struct Spot {
    /// D, unit.
    pub axis: DVec3,
    /// Degrees.
    pub cone: f64,
    pub exponent: f64,
}

/// All that shines in `scene`: of more than [`MOST`] only the first count. An area light is its sample points where
/// these fit, otherwise the point in its middle.
pub(in super::super) fn lamps(scene: &Scene, mesh: &VertexMesh) -> Vec<Lamp> {
    let emitters = emitters(scene);
    let whole = fits(&emitters);
    emitters.iter().flat_map(|emitter| lamps_of(emitter, scene, mesh, whole)).collect()
}

/// Whether all points of all area lights are among the lights that OpenGL has.
pub(in super::super) fn fits(emitters: &[Emitter<'_>]) -> bool {
    let count = |emitter: &Emitter<'_>| match &emitter.place {
        Place::Among(points) => points.len(),
        _ => 1,
    };
    emitters.iter().map(count).sum::<usize>() <= MOST
}

fn lamps_of(emitter: &Emitter<'_>, scene: &Scene, mesh: &VertexMesh, whole: bool) -> Vec<Lamp> {
    let lamp = |title: String, place, parallel, share: f64| {
        let light = emitter.light;
        let (axis, exponent) = (emitter.axis(), light.exponent.min(128.0));
        let spot = (light.kind == LightKind::Spot).then_some(Spot { axis, cone: light.cone, exponent });
        let (factor, attenuation) = falloff(emitter, scene, mesh, parallel, place);
        Lamp { title, place, parallel, color: light.color * share * factor, attenuation, spot }
    };
    match &emitter.place {
        Place::Towards(l) => vec![lamp(emitter.title(), *l, true, 1.0)],
        Place::At(place) => vec![lamp(emitter.title(), *place, false, 1.0)],
        Place::Among(points) if whole => {
            let (count, share) = (points.len(), 1.0 / points.len().max(1) as f64);
            let titled = |i: usize| format!("{}: point {} of {count}", emitter.title(), i + 1);
            points.iter().enumerate().map(|(i, &point)| lamp(titled(i), point, false, share)).collect()
        }
        Place::Among(_) => vec![lamp(emitter.title() + ": its middle", emitter.light.position, false, 1.0)],
    }
}

/// A constant factor, and OpenGL's three coefficients.
fn falloff(emitter: &Emitter<'_>, scene: &Scene, mesh: &VertexMesh, parallel: bool, place: DVec3) -> (f64, [f64; 3]) {
    const NONE: [f64; 3] = [1.0, 0.0, 0.0];
    let light = emitter.light;
    if let Some(f) = emitter.constant {
        return (f, NONE);
    }
    match light.attenuation {
        // OpenGL knows no distance to the viewer: that of the target stands for all.
        Attenuation::Viewer => (1.0 / (scene.camera.distance() + light.k), NONE),
        _ if parallel => (1.0, NONE),
        Attenuation::Light => (1.0, [light.k, 1.0, 0.0]),
        Attenuation::InverseSquare => (1.0, [0.0, 0.0, 1.0]),
        Attenuation::Quadratic if !reaches(light, place, mesh).outside => (1.0, NONE),
        Attenuation::Quadratic => (1.0, [light.c1, light.c2, light.c3]),
        Attenuation::None => (1.0, NONE),
    }
}

/// On which sides of the distance at which `min(1, …)` begins to matter there are vertices.
pub(in super::super) struct Sides {
    pub inside: bool,
    pub outside: bool,
}

/// Where the vertices of `mesh` are, seen from a light with quadratic attenuation at `place`.
pub(in super::super) fn reaches(light: &Light, place: DVec3, mesh: &VertexMesh) -> Sides {
    let mut sides = Sides { inside: false, outside: false };
    for p in &mesh.positions {
        let d = (mesh.origin + p.as_dvec3() - place).length();
        let sum = light.c1 + light.c2 * d + light.c3 * d * d;
        if sum < 1.0 { sides.inside = true } else { sides.outside = true }
    }
    sides
}
