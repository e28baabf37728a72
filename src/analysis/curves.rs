//! The curves of local illumination, sampled in double precision: the family cosⁿ φ, the attenuation f(d), the reflectance
//! W(θ) and the polar lobe.
//!
//! A scene and what was probed in it come in; out go [`Plot`]s, plain data with the scene's own values marked.

mod attenuation;
mod exponent;
mod polar;
mod reflectance;
mod report;

pub use attenuation::{Distances, attenuation_plot};
pub use exponent::{COURSE, exponent_plot, highlight_half_width};
pub use polar::lobe_plot;
pub use reflectance::{READ_AT, reflectance_plot};
pub use report::{Curves, CurvesQuestion};

use super::{Plot, PlotKind, Probe};
pub(crate) use crate::figure::short;
use crate::render::Renderer;
use crate::scene::{Attenuation, Light, Reflectance, Scene};

/// The plot of that kind for `probe`, of a picture of `scene` that `renderer` has drawn, and the light of index `light`.
/// Nothing where there is nothing to plot: no such light, or for the lobe a light that does not reach the point.
pub fn plot(kind: PlotKind, renderer: &Renderer, scene: &Scene, probe: &Probe, light: usize) -> Option<Plot> {
    let hit = probe.hit.as_ref();
    let terms = hit.and_then(|hit| hit.lights.get(light));
    match kind {
        PlotKind::Exponent => Some(exponent_plot(scene, terms.map(|terms| terms.phi))),
        PlotKind::Reflectance => Some(reflectance_plot(scene, terms.map(|terms| terms.incidence))),
        PlotKind::Attenuation => {
            let light = scene.lights.get(light)?;
            let distances = Distances::seen(renderer, scene, light, hit.map(|hit| hit.position));
            Some(attenuation_plot(light, &distances))
        }
        PlotKind::Lobe => lobe_plot(scene, hit?, light),
        _ => None,
    }
}

/// The kinds of plot that have more to say than that nothing varies: W and f only where they do.
pub fn shown_kinds(scene: &Scene, light: usize) -> Vec<PlotKind> {
    let varies = |kind: &PlotKind| match kind {
        PlotKind::Attenuation => scene.lights.get(light).is_some_and(|light| effective(light) != Attenuation::None),
        PlotKind::Reflectance => scene.material.reflectance != Reflectance::Constant,
        PlotKind::Exponent | PlotKind::Lobe => true,
        _ => false,
    };
    PlotKind::ALL.into_iter().filter(varies).collect()
}

/// The law by which a light weakens: a directional one is equally far from everything, so that only the distance to the
/// viewer counts.
fn effective(light: &Light) -> Attenuation {
    let counts = light.kind.has_position() || light.attenuation == Attenuation::Viewer;
    if counts { light.attenuation } else { Attenuation::None }
}

/// An angle in degrees with one decimal.
fn degrees(radians: f64) -> String {
    format!("{:.1}°", radians.to_degrees()).replace('-', "−")
}
