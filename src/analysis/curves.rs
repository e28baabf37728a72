//! The curves of local illumination, sampled in double precision: the family cosⁿ φ or the scene's own law, the attenuation f(d),
//! the reflectance W(θ) and the polar lobe, as [`Plot`]s with the scene's own values marked.

mod attenuation;
mod highlight;
mod law;
mod reflectance;

pub use attenuation::{Distances, attenuation_plot};
pub use highlight::{COURSE, exponent_plot, highlight_half_width, lobe_half_width, lobe_plot};
pub use law::law_plot;
pub use reflectance::{READ_AT, reflectance_plot};

use super::lobe::ReflectionLobe;
use super::probe::{Probe, ProbeHit, clearest_pixel, probe};
use super::report::{Answer, Part, Report, ReportContext};
use super::{Question, Subject, Watch};
use crate::figure::{Plot, PlotKind};
use crate::render::Renderer;
use crate::scene::Scene;
use crate::text;
use attenuation::has_distance;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

/// The question for the curves of local illumination.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct CurvesQuestion {
    /// The plot; without one, all that the scene has.
    pub kind: Option<PlotKind>,
    /// The pixel whose values are marked; without one, the clearest pixel.
    pub pixel: Option<[u32; 2]>,
    /// Index of the light whose attenuation and lobe are plotted; without one, the first that the point faces.
    pub light: Option<usize>,
}

/// The subject of the curves. The plots are made on request, in the current language.
#[derive(Clone, Debug, Default)]
pub struct Curves {
    /// The pixel whose point the curves belong to.
    pub pixel: [u32; 2],
    /// Index of the light whose attenuation is plotted.
    pub light: usize,
    /// The kinds of plot available.
    pub kinds: Vec<PlotKind>,
    hit: Option<ProbeHit>,
    distances: Distances,
}

impl Curves {
    /// Returns the curves that apply to `probe`, of a picture of `scene` that `renderer` has drawn, and a light.
    pub fn new(renderer: &Renderer, scene: &Scene, probe: &Probe, light: usize) -> Self {
        let mut curves = Self {
            pixel: probe.pixel,
            light,
            kinds: vec![],
            hit: probe.hit.clone(),
            distances: Distances::default(),
        };
        if let Some(source) = scene.lights.get(light) {
            let position = probe.hit.as_ref().map(|hit| hit.position);
            curves.distances = Distances::seen(renderer, scene, source, position);
        }
        curves.kinds = shown_kinds(scene, light);
        let hit = curves.hit.as_ref();
        let has_lobe = hit.is_some_and(|hit| ReflectionLobe::at(scene, hit, light).is_some());
        let needs_lobe = |kind| match kind {
            PlotKind::Lobe => true,
            PlotKind::Exponent => scene.reflection.is_own_law(),
            _ => false,
        };
        curves.kinds.retain(|kind| has_lobe || !needs_lobe(*kind));
        curves
    }

    /// Returns the plots.
    pub fn plots(&self, scene: &Scene) -> Vec<Plot> {
        let several = scene.lights.len() > 1;
        let plot = |kind: &PlotKind| {
            let mut plot = self.plot(*kind, scene)?;
            if several && matches!(kind, PlotKind::Attenuation | PlotKind::Lobe) {
                let light = self.light + 1;
                plot.title = text!("point-plot-of-light", title = plot.title, light = light);
            }
            Some(plot)
        };
        self.kinds.iter().filter_map(plot).collect()
    }

    /// Returns the plot of a kind; none if there is nothing to plot: no such light, or for the lobe a light that does
    /// not reach the point.
    pub fn plot(&self, kind: PlotKind, scene: &Scene) -> Option<Plot> {
        let hit = self.hit.as_ref();
        let own = hit.map(|hit| hit.scene_of(scene));
        let scene = own.as_deref().unwrap_or(scene);
        let terms = hit.and_then(|hit| hit.lights.get(self.light));
        match kind {
            PlotKind::Exponent if scene.reflection.is_own_law() => {
                law_plot(scene, hit?, self.light)
            }
            PlotKind::Exponent => {
                let angle = terms.map(|terms| terms.lobe_angle(scene.reflection.model).1);
                exponent_plot(scene, angle)
            }
            PlotKind::Reflectance => {
                Some(reflectance_plot(scene, terms.map(|terms| terms.incidence)))
            }
            PlotKind::Attenuation => {
                let light = scene.lights.get(self.light)?;
                Some(attenuation_plot(light, &self.distances))
            }
            PlotKind::Lobe => lobe_plot(scene, hit?, self.light),
            _ => None,
        }
    }
}

impl Question for CurvesQuestion {
    type Answer = Curves;

    fn answer(&self, subject: &Subject, _: &dyn Watch<Curves>) -> Result<Curves, String> {
        let (mut renderer, scene) = (subject.renderer(), &subject.scene);
        let probed = match self.pixel {
            Some([x, y]) => probe(&mut renderer, scene, x, y),
            None => clearest_pixel(&mut renderer, scene),
        };
        let count = scene.lights.len();
        let light = match self.light {
            Some(light) if count == 0 => {
                return Err(text!("point-error-no-lights", light = light + 1));
            }
            Some(light) if light >= count => {
                return Err(text!(
                    "point-error-no-such-light",
                    light = light + 1,
                    last = count
                ));
            }
            Some(light) => light,
            None => {
                let hit = probed.hit.as_ref();
                hit.and_then(|hit| hit.lights.iter().position(|terms| terms.n_dot_l > 0.0))
                    .unwrap_or(0)
            }
        };
        let mut curves = Curves::new(&renderer, scene, &probed, light);
        let Some(kind) = self.kind else {
            return Ok(curves);
        };
        curves.kinds = vec![kind];
        if curves.plot(kind, scene).is_some() {
            return Ok(curves);
        }
        let [x, y] = probed.pixel;
        Err(match (kind, &probed.hit) {
            (PlotKind::Lobe | PlotKind::Exponent, None) => {
                text!("point-error-background", x = x, y = y)
            }
            (PlotKind::Lobe | PlotKind::Exponent, Some(_)) if light < count => {
                text!("point-error-behind", light = light + 1, x = x, y = y)
            }
            _ => text!("point-error-no-light").to_owned(),
        })
    }
}

impl Answer for Curves {
    fn report(&self, about: &ReportContext<'_>) -> Report {
        let [x, y] = self.pixel;
        let mut report = Report::new(text!(
            "point-curves-title",
            scene = about.name,
            x = x,
            y = y
        ));
        for plot in self.plots(about.scene) {
            report.section("").push(Part::Plot(plot.into()));
        }
        report
    }

    fn value(&self, about: &ReportContext<'_>) -> Value {
        json!({ "pixel": self.pixel, "light": self.light, "plots": self.plots(about.scene) })
    }
}

/// Returns the kinds of plot that apply: f only where it has a distance to depend on, W not beside a law of the scene's own.
pub fn shown_kinds(scene: &Scene, light: usize) -> Vec<PlotKind> {
    let shown = |kind: &PlotKind| match kind {
        PlotKind::Attenuation => scene.lights.get(light).is_some_and(has_distance),
        PlotKind::Reflectance => !scene.reflection.is_own_law(),
        PlotKind::Exponent | PlotKind::Lobe => true,
        _ => false,
    };
    PlotKind::ALL.into_iter().filter(shown).collect()
}
