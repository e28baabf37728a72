//! The five defects of interpolated shading, each as a number that measures it in a scene.
//!
//! Foley, van Dam, Feiner and Hughes (1990, section 16.2.6) name them: the polygonal silhouette, the perspective distortion,
//! the dependence on orientation, the problems at shared vertices, and unrepresentative vertex normals. None is made up here:
//! each is measured on what the engine draws.

mod drawing;
mod edges;
mod inside;

pub use drawing::{DefectMark, defect_marks, defect_plots, draw_defects};
pub use edges::{SharedVertices, Silhouette};
pub use inside::{Orientation, PerspectiveDistortion, VertexNormals};

use super::question::{Watch, unwatched};
use super::report::{About, Answer, Column, Part, Report, Table, cells};
use super::{PlotKind, Question, Subject, clearest_pixel};
use crate::render::Renderer;
use crate::scene::{Compare, Interpolation, Scene, ShadingMode};
use serde::{Deserialize, Serialize, Serializer};
use serde_json::{Value, json};

/// A measurement, or why there is nothing to measure.
pub type Finding<T> = Result<T, &'static str>;

/// What was measured in a scene.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Defects {
    #[serde(serialize_with = "or_missing")]
    pub silhouette: Finding<Silhouette>,
    #[serde(serialize_with = "or_missing")]
    pub perspective: Finding<PerspectiveDistortion>,
    #[serde(serialize_with = "or_missing")]
    pub orientation: Finding<Orientation>,
    #[serde(serialize_with = "or_missing")]
    pub shared_vertices: Finding<SharedVertices>,
    #[serde(serialize_with = "or_missing")]
    pub vertex_normals: Finding<VertexNormals>,
}

/// A missing measurement is written as the reason.
fn or_missing<T: Serialize, S: Serializer>(
    finding: &Finding<T>,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    match finding {
        Ok(measured) => measured.serialize(serializer),
        Err(missing) => json!({ "missing": missing }).serialize(serializer),
    }
}

/// Goes on with a measurement, unless whoever waits has stopped.
fn goes_on(watch: &dyn Watch<()>, share: f32) -> Finding<()> {
    if watch.at(share) {
        Ok(())
    } else {
        Err("stopped")
    }
}

/// Why nothing is interpolated in a scene, where nothing is.
fn interpolates(scene: &Scene) -> Finding<()> {
    match scene.shading.mode {
        ShadingMode::Flat => Err("flat shading interpolates nothing"),
        ShadingMode::Exact => Err("exact shading interpolates nothing"),
        ShadingMode::Interpolated | ShadingMode::Gouraud | ShadingMode::Phong => Ok(()),
    }
}

/// Measures all five in `scene`, as its picture of `scene.image.size` has them; the dependence on orientation at what `pixel`
/// sees. `renderer` holds the model, if there is one, and draws other pictures in between.
pub fn defects(renderer: &mut Renderer, scene: &Scene, pixel: [u32; 2]) -> Defects {
    defects_with_progress(renderer, scene, pixel, &unwatched)
}

/// The same with somebody who waits; what is not measured when they stop stays missing.
pub fn defects_with_progress(
    renderer: &mut Renderer,
    scene: &Scene,
    pixel: [u32; 2],
    watch: &dyn Watch<()>,
) -> Defects {
    let alone = &Scene {
        compare: Compare::default(),
        ..scene.clone()
    };
    let along = |share: f32| watch.at(0.5 + 0.3 * share);
    let found = Defects {
        silhouette: edges::silhouette(renderer, alone, watch),
        perspective: goes_on(watch, 0.3).and_then(|()| inside::perspective(renderer, alone)),
        orientation: goes_on(watch, 0.4).and_then(|()| inside::orientation(renderer, alone, pixel)),
        shared_vertices: goes_on(&along, 0.0)
            .and_then(|()| edges::shared_vertices(renderer, alone, &along)),
        vertex_normals: goes_on(watch, 0.8).and_then(|()| inside::vertex_normals(renderer, alone)),
    };
    watch.at(1.0);
    found
}

/// The five defects.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct DefectsQuestion {
    /// The pixel whose point is followed while the picture turns; otherwise the clearest one.
    pub pixel: Option<[u32; 2]>,
}

/// The defects, and the pixel whose point was followed.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredDefects {
    pub pixel: [u32; 2],
    pub defects: Defects,
}

impl Question for DefectsQuestion {
    type Answer = MeasuredDefects;

    fn answer(
        &self,
        subject: &Subject,
        watch: &dyn Watch<MeasuredDefects>,
    ) -> Result<MeasuredDefects, String> {
        let (mut renderer, scene) = (subject.renderer(), &subject.scene);
        let pixel = self
            .pixel
            .unwrap_or_else(|| clearest_pixel(&mut renderer, scene).pixel);
        let defects = defects_with_progress(&mut renderer, scene, pixel, &|share| watch.at(share));
        Ok(MeasuredDefects { pixel, defects })
    }
}

/// A defect: its name, what it is, and where to see it.
#[derive(Clone, Copy, Debug)]
pub struct Defect {
    pub title: &'static str,
    says: &'static str,
    /// The built-in scene about it.
    pub scene: &'static str,
    pub try_this: &'static str,
    plot: Option<PlotKind>,
    figures: fn(&Defects) -> Finding<Figures>,
}

/// Numbers, each with what it is.
type Figures = Vec<(String, String)>;

/// All five, in the order of the textbook and of the report's sections.
pub const DEFECTS: [Defect; 5] = [
    Defect {
        title: "Polygonal silhouette",
        says: "However smooth the shading, the outline stays that of the polygons.",
        scene: "silhouette",
        try_this: "raise the segments, and watch the distance fall as their square.",
        plot: None,
        figures: |defects| {
            let found = defects.silhouette.as_ref().map_err(|why| *why)?;
            let at = format!(
                "pixels from the true outline, at {:.0},{:.0}",
                found.polygon.x, found.polygon.y
            );
            Ok(vec![(format!("{:.2}", found.greatest), at)])
        },
    },
    Defect {
        title: "Perspective distortion",
        says: "Interpolation is done in the picture, where halfway between two vertices is not halfway in space.",
        scene: "perspective-distortion",
        try_this: "turn the floor away, or cut its polygons smaller.",
        plot: None,
        figures: |defects| {
            let found = defects.perspective?;
            let rule = match found.interpolation {
                Interpolation::Scanline => "scan-line",
                Interpolation::Affine | Interpolation::Perspective => "affine",
            };
            let at = found
                .error
                .at
                .map_or_else(String::new, |[x, y]| format!(", at {x},{y}"));
            let greatest = format!("greatest difference, {rule} to perspective-correct{at}");
            Ok(vec![
                code(found.error.greatest, greatest),
                code(found.error.mean, "mean difference"),
            ])
        },
    },
    Defect {
        title: "Dependence on orientation",
        says: "Along scan lines the shade of a point changes when its polygon turns; that of a triangle does not.",
        scene: "orientation",
        try_this: "drag the knob on the ring about the picture, and watch the probe's value.",
        plot: Some(PlotKind::Orientation),
        figures: |defects| {
            let [scanline, barycentric] = defects.orientation.as_ref().map_err(|why| *why)?.spread;
            let change = code(scanline, "change of the probed point, along the scan line");
            Ok(vec![change, code(barycentric, "with barycentric weights")])
        },
    },
    Defect {
        title: "Vertices that are not shared",
        says: "Where one side of an edge has a vertex and the other has none, the two sides interpolate differently.",
        scene: "shared-vertices",
        try_this: "drag the lamp along the edge, or its middle vertex off it.",
        plot: Some(PlotKind::SharedEdge),
        figures: |defects| {
            let SharedVertices {
                edges,
                measured,
                greatest,
                at,
                ..
            } = defects.shared_vertices.as_ref().map_err(|why| *why)?;
            let edges = match (edges, measured) {
                (1, _) => "1 edge".to_owned(),
                (edges, measured) if measured < edges => {
                    format!("{edges} edges, {measured} of them measured")
                }
                (edges, _) => format!("{edges} edges"),
            };
            let words = format!(
                "greatest jump of the intensity, at {:.0},{:.0}; {edges}",
                at.x, at.y
            );
            Ok(vec![code(*greatest, words)])
        },
    },
    Defect {
        title: "Unrepresentative vertex normals",
        says: "Averaged over folds, all normals may be alike: the surface looks flat.",
        scene: "vertex-normals",
        try_this: "set the rings to 2 or more, and the folds come back.",
        plot: None,
        figures: |defects| {
            let found = defects.vertex_normals?;
            let angle = format!("{:.1}°", found.greatest_angle);
            let contrast = format!("contrast; the true one is {:.4}", found.true_contrast);
            let most = "at most between a polygon and its vertices’ normals".to_owned();
            Ok(vec![(angle, most), code(found.contrast, contrast)])
        },
    },
];

fn code(value: f64, name: impl Into<String>) -> (String, String) {
    (format!("{value:.4}"), name.into())
}

impl Answer for MeasuredDefects {
    fn report(&self, about: &About<'_>) -> Report {
        let mut report = Report::new(format!("{}; linear intensity, 1 is white", about.heading()));
        let plots = defect_plots(&self.defects);
        for defect in DEFECTS {
            let section = report.section(defect.title);
            match (defect.figures)(&self.defects) {
                Ok(figures) => figures
                    .into_iter()
                    .for_each(|(value, name)| _ = section.quantity(value, name)),
                Err(why) => _ = section.note(format!("Not here: {why}.")),
            }
            let plot = plots.iter().find(|plot| Some(plot.kind) == defect.plot);
            section
                .parts
                .extend(plot.cloned().map(|plot| Part::Plot(plot.into())));
            section.note(defect.says);
        }
        report
    }

    /// The samples of the two curves, one below the other.
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

    fn json(&self, about: &About<'_>) -> Value {
        json!({ "scene": about.name, "size": about.scene.image.size, "pixel": self.pixel, "defects": self.defects })
    }
}
