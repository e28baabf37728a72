//! What is said of the five defects, and how they are asked for.

use super::{Defects, Finding, defect_plots, defects_with_progress};
use crate::analysis::report::{About, Answer, Column, Part, Report, Table, cells};
use crate::analysis::{PlotKind, Question, Subject, Watch, clearest_pixel};
use crate::scene::Interpolation;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

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

    fn answer(&self, subject: &Subject, watch: &dyn Watch<MeasuredDefects>) -> Result<MeasuredDefects, String> {
        let (mut renderer, scene) = (subject.renderer(), &subject.scene);
        let pixel = self.pixel.unwrap_or_else(|| clearest_pixel(&mut renderer, scene).pixel);
        let defects = defects_with_progress(&mut renderer, scene, pixel, &|share| watch.at(share));
        Ok(MeasuredDefects { pixel, defects })
    }
}

/// Numbers, each with what it is; or why there are none.
type Figures = Finding<Vec<(String, String)>>;

/// A defect: its name, what it is, and where to see it.
#[derive(Clone, Copy, Debug)]
pub struct Defect {
    pub title: &'static str,
    says: &'static str,
    /// The built-in scene about it.
    pub scene: &'static str,
    pub try_this: &'static str,
    plot: Option<PlotKind>,
    figures: fn(&Defects) -> Figures,
}

/// All five, in the order of the textbook and of the report's sections.
pub const DEFECTS: [Defect; 5] = [
    Defect {
        title: "Polygonal silhouette",
        says: "However smooth the shading, the outline stays that of the polygons.",
        scene: "silhouette",
        try_this: "raise the segments, and watch the distance fall as their square.",
        plot: None,
        figures: silhouette,
    },
    Defect {
        title: "Perspective distortion",
        says: "Interpolation is done in the picture, where halfway between two vertices is not halfway in space.",
        scene: "perspective-distortion",
        try_this: "turn the floor away, or cut its polygons smaller.",
        plot: None,
        figures: perspective,
    },
    Defect {
        title: "Dependence on orientation",
        says: "Along scan lines the shade of a point changes when its polygon turns; that of a triangle does not.",
        scene: "orientation",
        try_this: "drag the knob on the ring about the picture, and watch the probe's value.",
        plot: Some(PlotKind::Orientation),
        figures: orientation,
    },
    Defect {
        title: "Vertices that are not shared",
        says: "Where one side of an edge has a vertex and the other has none, the two sides interpolate differently.",
        scene: "shared-vertices",
        try_this: "drag the lamp along the edge, or its middle vertex off it.",
        plot: Some(PlotKind::SharedEdge),
        figures: shared,
    },
    Defect {
        title: "Unrepresentative vertex normals",
        says: "Averaged over folds, all normals may be alike: the surface looks flat.",
        scene: "vertex-normals",
        try_this: "set the rings to 2 or more, and the folds come back.",
        plot: None,
        figures: vertex_normals,
    },
];

impl Answer for MeasuredDefects {
    fn report(&self, about: &About<'_>) -> Report {
        let mut report = Report::new(format!("{}; linear intensity, 1 is white", about.heading()));
        let plots = defect_plots(&self.defects);
        for defect in DEFECTS {
            let section = report.section(defect.title);
            match (defect.figures)(&self.defects) {
                Ok(figures) => figures.into_iter().for_each(|(value, name)| _ = section.quantity(value, name)),
                Err(why) => _ = section.note(format!("Not here: {why}.")),
            }
            let plot = plots.iter().find(|plot| Some(plot.kind) == defect.plot);
            section.parts.extend(plot.cloned().map(|plot| Part::Plot(plot.into())));
            section.note(defect.says);
        }
        report
    }

    /// The samples of the two curves, one below the other.
    fn table(&self) -> Option<Table> {
        let mut table = Table::new(["curve", "x", "first", "second"].map(Column::key));
        if let Ok(orientation) = &self.defects.orientation {
            let turned = orientation.samples.iter();
            table.rows.extend(turned.map(|one| cells!["orientation", one.angle, one.scanline, one.barycentric]));
        }
        if let Ok(shared) = &self.defects.shared_vertices {
            let samples = shared.samples.iter();
            table.rows.extend(samples.map(|[place, without, with]| cells!["shared-vertices", *place, *without, *with]));
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

fn silhouette(defects: &Defects) -> Figures {
    let found = defects.silhouette.as_ref().map_err(|why| *why)?;
    let at = format!("pixels from the true outline, at {:.0},{:.0}", found.polygon.x, found.polygon.y);
    Ok(vec![(format!("{:.2}", found.greatest), at)])
}

fn perspective(defects: &Defects) -> Figures {
    let found = defects.perspective.as_ref().map_err(|why| *why)?;
    let rule = match found.interpolation {
        Interpolation::Scanline => "scan-line",
        Interpolation::Affine | Interpolation::Perspective => "affine",
    };
    let at = found.error.at.map_or_else(String::new, |[x, y]| format!(", at {x},{y}"));
    let greatest = format!("greatest difference, {rule} to perspective-correct{at}");
    Ok(vec![code(found.error.greatest, greatest), code(found.error.mean, "mean difference")])
}

fn orientation(defects: &Defects) -> Figures {
    let [scanline, barycentric] = defects.orientation.as_ref().map_err(|why| *why)?.spread;
    let change = code(scanline, "change of the probed point, along the scan line");
    Ok(vec![change, code(barycentric, "with barycentric weights")])
}

fn shared(defects: &Defects) -> Figures {
    let found = defects.shared_vertices.as_ref().map_err(|why| *why)?;
    let (edges, at) = (found.edges_in_words(), found.at);
    Ok(vec![code(found.greatest, format!("greatest jump of the intensity, at {:.0},{:.0}; {edges}", at.x, at.y))])
}

fn vertex_normals(defects: &Defects) -> Figures {
    let found = defects.vertex_normals.as_ref().map_err(|why| *why)?;
    let angle =
        (format!("{:.1}°", found.greatest_angle), "at most between a polygon and its vertices’ normals".to_owned());
    Ok(vec![angle, code(found.contrast, format!("contrast; the true one is {:.4}", found.true_contrast))])
}

fn code(value: f64, name: impl Into<String>) -> (String, String) {
    (format!("{value:.4}"), name.into())
}
