//! The curves at one pixel: how they are asked, and what they say.

use super::{plot, shown_kinds};
use crate::analysis::report::{About, Answer, Part, Report};
use crate::analysis::{Plot, PlotKind, Probe, Question, Subject, Watch, clearest_pixel, probe};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

/// The curves of local illumination.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct CurvesQuestion {
    /// One plot; otherwise all that the scene has.
    pub kind: Option<PlotKind>,
    /// The pixel whose values are marked; otherwise the clearest one.
    pub pixel: Option<[u32; 2]>,
    /// The light whose attenuation and lobe are plotted; otherwise the first that the point faces.
    pub light: Option<usize>,
}

/// The plots.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Curves {
    pub pixel: [u32; 2],
    pub light: usize,
    pub plots: Vec<Plot>,
}

impl Question for CurvesQuestion {
    type Answer = Curves;

    fn answer(&self, subject: &Subject, _: &dyn Watch<Curves>) -> Result<Curves, String> {
        let (mut renderer, scene) = (subject.renderer(), &subject.scene);
        let probed = match self.pixel {
            Some([x, y]) => probe(&mut renderer, scene, x, y),
            None => clearest_pixel(&mut renderer, scene),
        };
        let (pixel, count) = (probed.pixel, scene.lights.len());
        let light = match self.light {
            Some(light) if light >= count => {
                let expected = if count == 0 { "no light at all".into() } else { format!("0 to {}", count - 1) };
                return Err(format!("--light {light}: no such light in the scene, which has {expected}"));
            }
            Some(light) => light,
            None => first_faced(&probed),
        };
        let plot = |kind| plot(kind, &renderer, scene, &probed, light);
        let Some(kind) = self.kind else {
            return Ok(Curves {
                pixel,
                light,
                plots: shown_kinds(scene, light).into_iter().filter_map(plot).collect(),
            });
        };
        let [x, y] = pixel;
        let missing = match (kind, &probed.hit) {
            (PlotKind::Lobe, None) => format!("pixel {x},{y} shows the background, expected one that shows the object"),
            (PlotKind::Lobe, Some(_)) if light < count => {
                format!("light {light} does not reach pixel {x},{y} from the front, expected one that does")
            }
            _ => "the scene has no light, expected one".to_owned(),
        };
        plot(kind).map(|plot| Curves { pixel, light, plots: vec![plot] }).ok_or(missing)
    }
}

/// The first light that the point faces.
fn first_faced(probed: &Probe) -> usize {
    let hit = probed.hit.as_ref();
    hit.and_then(|hit| hit.lights.iter().position(|terms| terms.n_dot_l > 0.0)).unwrap_or(0)
}

impl Answer for Curves {
    fn report(&self, about: &About<'_>) -> Report {
        let [x, y] = self.pixel;
        let mut report = Report::new(format!("{}, at pixel ({x}, {y})", about.name));
        for plot in &self.plots {
            report.section("").push(Part::Plot(plot.clone().into()));
        }
        report
    }

    fn json(&self, _: &About<'_>) -> Value {
        json!({ "pixel": self.pixel, "light": self.light, "plots": self.plots })
    }
}
