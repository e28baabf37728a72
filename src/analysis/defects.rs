//! The five defects of interpolated shading, each as a number that measures it in a scene.
//!
//! Foley, van Dam, Feiner and Hughes (1990, section 16.2.6) name them: the polygonal silhouette, the perspective
//! distortion, the dependence on orientation, the problems at shared vertices, and unrepresentative vertex normals.
//! None is contrived here: each is measured on the engine's own pictures.

mod drawing;
mod edges;
mod inside;

pub use drawing::{DefectMark, defect_marks, defect_plots, draw_defects};
pub use edges::{SharedVertices, Silhouette};
pub use inside::{DeepEdge, Orientation, PerspectiveDistortion, VertexNormals};

use super::codec::Codec;
use super::probe::clearest_pixel;
use super::question::Watch;
use super::report::{Answer, Column, Part, Report, ReportContext, Table, cells};
use super::{Question, Subject};
use crate::figure::PlotKind;
use crate::render::Renderer;
use crate::scene::{Compare, Interpolation, Scene, ShadingMode};
use crate::text::{Language, text};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::{Value, json};

/// A measurement, or the key of the sentence that explains why there is none.
pub type Measurement<T> = Result<T, &'static str>;

/// Measurements of the defects in a scene.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Defects {
    /// The outline, which is that of the polygons.
    #[serde(serialize_with = "or_missing", deserialize_with = "found")]
    pub silhouette: Measurement<Silhouette>,
    /// Difference between intensities interpolated in the picture and perspective-correct ones.
    #[serde(serialize_with = "or_missing", deserialize_with = "found")]
    pub perspective: Measurement<PerspectiveDistortion>,
    /// Change of an interpolated intensity while the picture is rotated.
    #[serde(serialize_with = "or_missing", deserialize_with = "found")]
    pub orientation: Measurement<Orientation>,
    /// Discontinuities of intensity at vertices that one side of an edge lacks.
    #[serde(serialize_with = "or_missing", deserialize_with = "found")]
    pub shared_vertices: Measurement<SharedVertices>,
    /// Angles between vertex normals and polygons, and the contrast lost to averaging.
    #[serde(serialize_with = "or_missing", deserialize_with = "found")]
    pub vertex_normals: Measurement<VertexNormals>,
}

/// Serializes a missing measurement as its reason for people and as its key for programs of this kind.
fn or_missing<T: Serialize, S: Serializer>(
    measurement: &Measurement<T>,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    if !serializer.is_human_readable() {
        return measurement.serialize(serializer);
    }
    match measurement {
        Ok(measured) => measured.serialize(serializer),
        Err(missing) => {
            let missing = text::in_language(Language::English, || text!(missing));
            json!({ "missing": missing }).serialize(serializer)
        }
    }
}

/// Deserializes what [`or_missing`] has serialized for programs of this kind.
fn found<'de, T: Deserialize<'de>, D: Deserializer<'de>>(
    deserializer: D,
) -> Result<Measurement<T>, D::Error> {
    let measurement: Result<T, String> = Deserialize::deserialize(deserializer)?;
    Ok(measurement.map_err(|key| text::interned(&key)))
}

/// Continues a measurement unless the caller has cancelled it.
fn goes_on(watch: &dyn Watch<()>, share: f32) -> Measurement<()> {
    if watch.progress(share) {
        Ok(())
    } else {
        Err("picture-missing-stopped")
    }
}

/// Returns the reason why a scene interpolates nothing, if so.
fn interpolates(scene: &Scene) -> Measurement<()> {
    match scene.shading.mode {
        ShadingMode::Flat => Err("picture-missing-flat"),
        ShadingMode::Exact => Err("picture-missing-exact"),
        ShadingMode::Interpolated | ShadingMode::Gouraud | ShadingMode::Phong => Ok(()),
    }
}

/// Measures all five defects in the picture of `scene` with its own size; the dependence on orientation at the point
/// visible in `pixel`. `renderer` holds any model. What is not yet measured when `watch` stops the work is missing.
pub fn defects(
    renderer: &mut Renderer,
    scene: &Scene,
    pixel: [u32; 2],
    watch: &dyn Watch<()>,
) -> Defects {
    let alone = &Scene {
        compare: Compare::default(),
        ..scene.clone()
    };
    let along = |share: f32| watch.progress(0.5 + 0.3 * share);
    let found = Defects {
        silhouette: edges::silhouette(renderer, alone, watch),
        perspective: goes_on(watch, 0.3).and_then(|()| inside::perspective(renderer, alone)),
        orientation: goes_on(watch, 0.4).and_then(|()| inside::orientation(renderer, alone, pixel)),
        shared_vertices: goes_on(&along, 0.0)
            .and_then(|()| edges::shared_vertices(renderer, alone, &along)),
        vertex_normals: goes_on(watch, 0.8).and_then(|()| inside::vertex_normals(renderer, alone)),
    };
    watch.progress(1.0);
    found
}

/// The question for the five defects.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct DefectsQuestion {
    /// The pixel whose point is followed while the picture is rotated; without one, the clearest pixel.
    pub pixel: Option<[u32; 2]>,
}

/// The measured defects, and the pixel whose point was followed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MeasuredDefects {
    /// The pixel whose point was followed while the picture was rotated.
    pub pixel: [u32; 2],
    /// The measurements.
    pub defects: Defects,
}

impl Question for DefectsQuestion {
    type Answer = MeasuredDefects;

    const CODEC: Option<Codec<MeasuredDefects>> = Some(Codec::plain());

    fn answer(
        &self,
        subject: &Subject,
        watch: &dyn Watch<MeasuredDefects>,
    ) -> Result<MeasuredDefects, String> {
        let (mut renderer, scene) = (subject.renderer(), &subject.scene);
        let pixel = self
            .pixel
            .unwrap_or_else(|| clearest_pixel(&mut renderer, scene).pixel);
        let defects = defects(&mut renderer, scene, pixel, &|share| watch.progress(share));
        Ok(MeasuredDefects { pixel, defects })
    }
}

/// A defect's description, scene and plot.
#[derive(Clone, Copy, Debug)]
pub struct Defect {
    /// Keys of its name, of its description and of the suggested experiment.
    keys: [&'static str; 3],
    /// The built-in scene that shows it.
    pub scene: &'static str,
    /// The plot that shows it, if there is one.
    pub plot: Option<PlotKind>,
    figures: fn(&Defects) -> Measurement<Figures>,
}

/// Numbers with their descriptions.
type Figures = Vec<(String, String)>;

impl Defect {
    /// Returns its name in the current language.
    pub fn title(&self) -> &'static str {
        text!(self.keys[0])
    }

    /// Returns the suggested experiment for its scene.
    pub fn try_this(&self) -> &'static str {
        text!(self.keys[2])
    }
}

/// All five defects, in the order of the textbook and of the report's sections.
pub const DEFECTS: [Defect; 5] = [
    Defect {
        keys: [
            "picture-silhouette",
            "picture-silhouette.says",
            "picture-silhouette.try",
        ],
        scene: "silhouette",
        plot: None,
        figures: |defects| {
            let found = defects.silhouette.as_ref().map_err(|why| *why)?;
            let at = place(found.polygon.to_array());
            Ok(vec![(
                format!("{:.2}", found.greatest),
                text!("picture-silhouette-distance", at = at),
            )])
        },
    },
    Defect {
        keys: [
            "picture-perspective",
            "picture-perspective.says",
            "picture-perspective.try",
        ],
        scene: "perspective-distortion",
        plot: None,
        figures: |defects| {
            let found = defects.perspective?;
            let rule = match found.interpolation {
                Interpolation::Scanline => text!("picture-scan-line"),
                Interpolation::Affine | Interpolation::Perspective => text!("picture-affine"),
            };
            let greatest = match found.error.at {
                Some([x, y]) => {
                    let at = place([x, y].map(f64::from));
                    text!("picture-perspective-greatest-at", rule = rule, at = at)
                }
                None => text!("picture-perspective-greatest", rule = rule),
            };
            Ok(vec![
                code(found.error.greatest, greatest),
                code(found.error.mean, text!("picture-perspective-mean")),
            ])
        },
    },
    Defect {
        keys: [
            "picture-orientation",
            "picture-orientation.says",
            "picture-orientation.try",
        ],
        scene: "orientation",
        plot: Some(PlotKind::Orientation),
        figures: |defects| {
            let [scanline, barycentric] = defects.orientation.as_ref().map_err(|why| *why)?.spread;
            Ok(vec![
                code(scanline, text!("picture-orientation-scanline")),
                code(barycentric, text!("picture-orientation-barycentric")),
            ])
        },
    },
    Defect {
        keys: [
            "picture-shared",
            "picture-shared.says",
            "picture-shared.try",
        ],
        scene: "shared-vertices",
        plot: Some(PlotKind::SharedEdge),
        figures: |defects| {
            let SharedVertices {
                edges,
                measured,
                greatest,
                at,
                ..
            } = defects.shared_vertices.as_ref().map_err(|why| *why)?;
            let edges = if measured < edges {
                text!(
                    "picture-shared-edges-measured",
                    edges = *edges,
                    measured = *measured
                )
            } else {
                text!("picture-shared-edges", edges = *edges)
            };
            let at = place(at.to_array());
            Ok(vec![code(
                *greatest,
                text!("picture-shared-jump", at = at, edges = edges),
            )])
        },
    },
    Defect {
        keys: [
            "picture-normals",
            "picture-normals.says",
            "picture-normals.try",
        ],
        scene: "vertex-normals",
        plot: None,
        figures: |defects| {
            let found = defects.vertex_normals?;
            let truth = format!("{:.4}", found.true_contrast);
            Ok(vec![
                (
                    format!("{:.1}°", found.greatest_angle),
                    text!("picture-normals-angle").to_owned(),
                ),
                code(
                    found.contrast,
                    text!("picture-normals-contrast", truth = truth),
                ),
            ])
        },
    },
];

fn place([x, y]: [f64; 2]) -> String {
    format!("{x:.0},{y:.0}")
}

fn code(value: f64, name: impl Into<String>) -> (String, String) {
    (format!("{value:.4}"), name.into())
}

impl Answer for MeasuredDefects {
    fn report(&self, about: &ReportContext<'_>) -> Report {
        let mut report = Report::new(text!("picture-defects-of", scene = about.heading()));
        let plots = defect_plots(&self.defects);
        for defect in DEFECTS {
            let section = report.section(defect.title());
            section.note(text!(defect.keys[1]));
            match (defect.figures)(&self.defects) {
                Ok(figures) => figures
                    .into_iter()
                    .for_each(|(value, name)| _ = section.quantity(value, name)),
                Err(why) => _ = section.note(text!("picture-not-here", why = text!(why))),
            }
            let plot = plots.iter().find(|plot| Some(plot.kind) == defect.plot);
            section
                .parts
                .extend(plot.cloned().map(|plot| Part::Plot(plot.into())));
        }
        report
    }

    fn table(&self) -> Option<Table> {
        let mut table = Table::new(["curve", "x", "first", "second"].map(Column::key));
        if let Ok(orientation) = &self.defects.orientation {
            let turned = orientation.samples.iter();
            table.rows.extend(
                turned.map(|one| cells!["orientation", one.angle, one.scanline, one.barycentric]),
            );
        }
        if let Ok(shared) = &self.defects.shared_vertices {
            let samples = shared.samples.iter();
            table.rows.extend(
                samples.map(|[place, without, with]| {
                    cells!["shared-vertices", *place, *without, *with]
                }),
            );
        }
        Some(table)
    }

    fn figure_size(&self, _: usize) -> [u32; 2] {
        [1600, 900]
    }

    fn value(&self, about: &ReportContext<'_>) -> Value {
        json!({ "scene": about.name, "size": about.scene.image.size, "pixel": self.pixel, "defects": self.defects })
    }
}
