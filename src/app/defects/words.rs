//! What is said of each defect.

use crate::analysis::{Defects, Finding, PlotKind};
use crate::scene::Interpolation;

/// A defect: its name, what it is, where to see it, and its figures.
pub struct Entry {
    pub title: &'static str,
    pub says: &'static str,
    /// The built-in scene about it.
    pub scene: &'static str,
    pub try_this: &'static str,
    pub plot: Option<PlotKind>,
    pub figures: fn(&Defects) -> Finding<Vec<Figure>>,
}

/// A number, and what it is of.
pub struct Figure {
    pub value: String,
    pub of: String,
}

fn figure(value: String, of: impl Into<String>) -> Figure {
    Figure { value, of: of.into() }
}

/// All five, in the order of the textbook.
pub const EACH: [Entry; 5] = [
    Entry {
        title: "Polygonal silhouette",
        says: "However smooth the shading, the outline stays that of the polygons.",
        scene: "silhouette",
        try_this: "raise the segments, and watch the distance fall as their square.",
        plot: None,
        figures: silhouette,
    },
    Entry {
        title: "Perspective distortion",
        says: "Interpolation is done in the picture, where halfway between two vertices is not halfway in space.",
        scene: "perspective-distortion",
        try_this: "turn the floor away, or cut its polygons smaller.",
        plot: None,
        figures: perspective,
    },
    Entry {
        title: "Dependence on orientation",
        says: "Along scan lines the shade of a point changes when its polygon turns; that of a triangle does not.",
        scene: "orientation",
        try_this: "drag the knob on the ring about the picture, and watch the probe's value.",
        plot: Some(PlotKind::Orientation),
        figures: orientation,
    },
    Entry {
        title: "Vertices that are not shared",
        says: "Where one side of an edge has a vertex and the other has none, the two sides interpolate differently.",
        scene: "shared-vertices",
        try_this: "drag the lamp along the edge, or its middle vertex off it.",
        plot: Some(PlotKind::SharedEdge),
        figures: shared,
    },
    Entry {
        title: "Unrepresentative vertex normals",
        says: "Averaged over folds, all normals may be alike: the surface looks flat.",
        scene: "vertex-normals",
        try_this: "set the rings to 2 or more, and the folds come back.",
        plot: None,
        figures: vertex_normals,
    },
];

fn silhouette(defects: &Defects) -> Finding<Vec<Figure>> {
    let measured = defects.silhouette.as_ref().map_err(|why| *why)?;
    Ok(vec![figure(format!("{:.2}", measured.greatest), "pixels from the true outline at most")])
}

fn perspective(defects: &Defects) -> Finding<Vec<Figure>> {
    let measured = defects.perspective.as_ref().map_err(|why| *why)?;
    let rule = match measured.interpolation {
        Interpolation::Scanline => "scan-line",
        Interpolation::Affine | Interpolation::Perspective => "affine",
    };
    Ok(vec![
        figure(
            format!("{:.4}", measured.error.greatest),
            format!("greatest difference, {rule} to perspective-correct"),
        ),
        figure(format!("{:.4}", measured.error.mean), "mean difference"),
    ])
}

fn orientation(defects: &Defects) -> Finding<Vec<Figure>> {
    let measured = defects.orientation.as_ref().map_err(|why| *why)?;
    let [scanline, barycentric] = measured.spread;
    Ok(vec![
        figure(format!("{scanline:.4}"), "change of the probed point, along the scan line"),
        figure(format!("{barycentric:.4}"), "with barycentric weights"),
    ])
}

fn shared(defects: &Defects) -> Finding<Vec<Figure>> {
    let measured = defects.shared_vertices.as_ref().map_err(|why| *why)?;
    let edges = measured.edges_in_words();
    Ok(vec![figure(format!("{:.4}", measured.greatest), format!("greatest jump of the intensity; {edges}"))])
}

fn vertex_normals(defects: &Defects) -> Finding<Vec<Figure>> {
    let measured = defects.vertex_normals.as_ref().map_err(|why| *why)?;
    Ok(vec![
        figure(format!("{:.1}°", measured.greatest_angle), "at most between a polygon and its vertices’ normals"),
        figure(format!("{:.4}", measured.contrast), format!("contrast; the true one is {:.4}", measured.true_contrast)),
    ])
}
