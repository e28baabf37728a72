//! Error against run time: every way of shading at every tessellation against the exact picture.
//!
//! Errors are of the linear intensity before the display, and nothing is clamped; a code value of the raw encoding is 1/255.
//! They are taken inside, where the picture and the exact one show the object with N·V ≥ 0.2, and for the outline apart.
//! Times are medians of whole frames but for the tessellation, which is kept as a graphics card keeps it. The settings are
//! timed in turn, each once before any is timed again, so that what slows the machine down for a while slows all of them.

mod historic;
mod jet;
mod measure;
mod report;
mod statistics;

pub use measure::study;
pub use report::{study_plot, study_point};
pub use statistics::{Fit, fit_line, median_and_spread, order_of, pareto_front, student};

use crate::scene::{Choice, FlatAt, Interpolation, Scene, ShadingMode, choices};
use crate::text::{Message, text};
use serde::{Deserialize, Serialize};

choices! {
    /// A way of shading: one of the engine's modes, or one of the historic ones, in scalar code.
    pub enum Method = "method" {
        /// Flat, at the centre of each polygon.
        Flat = "flat";
        /// Flat, by the mean of the vertices.
        FlatVertexMean = "flat-vertex-mean";
        /// With the polygon's own normal at the vertices.
        Interpolated = "interpolated";
        /// Gouraud 1971.
        Gouraud = "gouraud";
        /// Phong 1975, normals scaled to unit length at each pixel.
        Phong = "phong";
        /// Normals interpolated and left as they are.
        PhongUnnormalised = "phong-unnormalised";
        /// Phong shading in the same scalar code as the two below.
        PhongScalar = "phong-scalar";
        /// Bishop and Weimer 1986: the cosines by Taylor expansion over each triangle.
        Taylor = "taylor";
        /// Kuijk and Blake 1989: normals turn by equal angles along edges and spans.
        Angular = "angular";
    }
}

impl Method {
    /// Whether it is drawn by scalar code in one thread, and not by the engine.
    pub fn is_scalar(self) -> bool {
        matches!(self, Self::PhongScalar | Self::Taylor | Self::Angular)
    }

    /// What a pixel costs inside a span, under one white light at infinity and a viewer there: additions, multiplications,
    /// divisions and roots, and powers (which the papers look up in a table) of the method's text here, without coverage and
    /// depth.
    ///
    /// Phong's normal takes 3 additions to carry, 6 multiplications, 2 additions, a root and a division to make unit; N·L and
    /// N·V 3 multiplications and 2 additions each; R·V = 2(N·L)(N·V) − L·V 2 and 1; the sum with kd and ks 2 and 2. Taylor's two
    /// cosines take 2 additions each by forward differences, kd and ks being part of them and of the table; their sum is
    /// the fifth. The normal of angular interpolation takes 3 multiplications and 3 additions and is unit by construction.
    pub fn pixel_cost(self) -> [u32; 4] {
        match self {
            Self::Flat | Self::FlatVertexMean => [0, 0, 0, 0],
            Self::Interpolated | Self::Gouraud => [1, 0, 0, 0],
            Self::Phong | Self::PhongScalar => [12, 16, 2, 1],
            Self::PhongUnnormalised => [10, 10, 0, 1],
            Self::Taylor => [5, 0, 0, 1],
            Self::Angular => [10, 13, 0, 1],
        }
    }

    /// Puts the method into a scene; scalar ones leave it as it is.
    fn apply(self, scene: &mut Scene) {
        let shading = &mut scene.shading;
        shading.mode = match self {
            Self::Flat | Self::FlatVertexMean => ShadingMode::Flat,
            Self::Interpolated => ShadingMode::Interpolated,
            Self::Gouraud => ShadingMode::Gouraud,
            Self::Phong | Self::PhongUnnormalised => ShadingMode::Phong,
            Self::PhongScalar | Self::Taylor | Self::Angular => return,
        };
        match self {
            Self::Flat => shading.flat_at = FlatAt::Centre,
            Self::FlatVertexMean => shading.flat_at = FlatAt::VertexMean,
            _ => {}
        }
        shading.renormalise = self != Self::PhongUnnormalised;
    }
}

/// What a study compares.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StudyQuestion {
    /// The methods.
    pub methods: Vec<Method>,
    /// Polygons round the axis; those along it go with them as the scene has it. Of a shape that is not divided by number
    /// only its own polygons are measured.
    pub segments: Vec<u32>,
    /// How values are interpolated, where it makes a difference.
    pub interpolations: Vec<Interpolation>,
    /// Exponents; none is the scene's own.
    pub n: Vec<f64>,
    /// Frames timed for each setting, at least 1.
    pub repeats: u32,
}

impl Default for StudyQuestion {
    fn default() -> Self {
        Self {
            methods: Method::VALUES.to_vec(),
            segments: vec![8, 16, 32, 64, 128, 256],
            interpolations: vec![Interpolation::Perspective, Interpolation::Affine],
            n: Vec::new(),
            repeats: 9,
        }
    }
}

impl StudyQuestion {
    /// Whether two scenes differ in nothing but what a study sets itself, so that what it finds in one holds in the other.
    pub fn same(&self, a: &Scene, b: &Scene) -> bool {
        let plain = |scene: &Scene| {
            let mut plain = scene.clone();
            let n = if self.n.is_empty() {
                scene.material.n
            } else {
                1.0
            };
            let setting = Setting {
                method: Method::Flat,
                segments: 8,
                rings: 8,
                interpolation: Some(Interpolation::Perspective),
                n,
            };
            setting.apply(&mut plain);
            plain
        };
        plain(a) == plain(b)
    }
}

/// One way to draw the scene.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Setting {
    /// The method.
    pub method: Method,
    /// Polygons round the axis.
    pub segments: u32,
    /// Polygons along the axis.
    pub rings: u32,
    /// None where it makes no difference.
    pub interpolation: Option<Interpolation>,
    /// The specular exponent.
    pub n: f64,
}

impl Setting {
    fn apply(&self, scene: &mut Scene) {
        (scene.object.segments, scene.object.rings) = (self.segments, self.rings);
        scene.material.n = self.n;
        scene.shading.interpolation = self.interpolation.unwrap_or(scene.shading.interpolation);
        self.method.apply(scene);
    }

    /// Puts the setting into a scene and returns true, unless it is one of the scalar methods, which no scene has.
    pub fn load(&self, scene: &mut Scene) -> bool {
        if !self.method.is_scalar() {
            self.apply(scene);
        }
        !self.method.is_scalar()
    }

    /// Whether it belongs to the same row of tessellations.
    fn is_like(&self, other: &Self) -> bool {
        (self.method, self.interpolation, self.n.to_bits())
            == (other.method, other.interpolation, other.n.to_bits())
    }

    /// The setting in words.
    pub fn title(&self) -> String {
        format!(
            "{} {}×{}",
            title(self.method, self.interpolation),
            self.segments,
            self.rings
        )
    }
}

/// A method with the interpolation that it goes by, in words.
fn title(method: Method, interpolation: Option<Interpolation>) -> String {
    let method = method.label();
    match interpolation {
        Some(Interpolation::Affine) => text!("engine-method-affine", method = method),
        Some(Interpolation::Scanline) => text!("engine-method-scanline", method = method),
        Some(Interpolation::Perspective) | None => method.to_owned(),
    }
}

/// What is not measured, and why.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Omission {
    /// The method.
    pub method: Method,
    /// The interpolation; none where it makes no difference.
    pub interpolation: Option<Interpolation>,
    /// Why it is not measured.
    pub reason: Message,
}

/// What was measured of one setting.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StudyRow {
    /// How the scene was drawn.
    pub setting: Setting,
    /// The longest edge of a polygon, world units: the spacing of the vertices.
    pub spacing: f64,
    /// Inside: root mean square, greatest and 99th percentile, linear intensity before the display: values above 1 count in
    /// full.
    pub error_rms: f64,
    /// Inside: the greatest error.
    pub error_max: f64,
    /// Inside: the error that 99 % of the pixels do not exceed.
    pub error_p99: f64,
    /// Inside: root mean square and greatest of the values as shown: where the display clamps, what is above 1 counts as 1, as
    /// in the figures of a comparison.
    pub error_rms_shown: f64,
    /// The greatest of them.
    pub error_max_shown: f64,
    /// The pixels inside.
    pub interior_pixels: u64,
    /// Pixels that show the object here or in the exact picture, but not in both; the root mean square over them.
    pub outline_pixels: u64,
    /// The root mean square over them.
    pub outline_rms: f64,
    /// Median of a frame in milliseconds, and the width of the middle half of the samples.
    pub time_ms: f64,
    /// Width of the middle half of the samples, milliseconds.
    pub spread_ms: f64,
    /// Frames timed.
    pub samples: u32,
    /// Evaluations of the equation in a frame, which no machine changes; of Taylor's method the triangles expanded.
    pub evaluations: u64,
    /// Whether nothing else is both faster and nearer to the exact picture, among those that the engine draws.
    pub pareto: bool,
    /// Whether the time is that of a scalar code in one thread, and not of the engine.
    pub scalar: bool,
}

/// How the errors of one method go with the tessellation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Series {
    /// The method.
    pub method: Method,
    /// The interpolation; none where it makes no difference.
    pub interpolation: Option<Interpolation>,
    /// The specular exponent.
    pub n: f64,
    /// The order p of the greatest error, which goes as hᵖ with the spacing h; none of fewer than three tessellations.
    pub order: Option<Fit>,
    /// Likewise of the root mean square.
    pub order_rms: Option<Fit>,
}

/// What a study has found.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Study {
    /// Those of one method, interpolation and n together, from coarse to fine.
    pub rows: Vec<StudyRow>,
    /// The orders of convergence.
    pub series: Vec<Series>,
    /// What was left out.
    pub omitted: Vec<Omission>,
    /// Whether nothing was cut short.
    pub complete: bool,
    /// Threads of the engine.
    pub threads: usize,
}

impl Study {
    /// Fits the orders and finds the front anew.
    fn conclude(&mut self) {
        // Times of the two texts are not of one kind: the scalar one's count only where there is no other.
        let engine = self.rows.iter().any(|row| !row.scalar);
        let time = |row: &StudyRow| {
            if row.scalar && engine {
                f64::NAN
            } else {
                row.time_ms
            }
        };
        let points: Vec<[f64; 2]> = self
            .rows
            .iter()
            .map(|row| [time(row), row.error_rms])
            .collect();
        for (row, on) in self.rows.iter_mut().zip(pareto_front(&points)) {
            row.pareto = on;
        }
        self.series = self
            .rows
            .chunk_by(|a, b| a.setting.is_like(&b.setting))
            .map(|rows| {
                let Setting {
                    method,
                    interpolation,
                    n,
                    ..
                } = rows[0].setting;
                let order = order_of(rows.iter().map(|row| (row.spacing, row.error_max)));
                let order_rms = order_of(rows.iter().map(|row| (row.spacing, row.error_rms)));
                Series {
                    method,
                    interpolation,
                    n,
                    order,
                    order_rms,
                }
            })
            .collect();
    }

    /// The first series of a method: of the first interpolation and n that were asked for.
    pub fn series_of(&self, method: Method) -> Option<&Series> {
        self.series.iter().find(|series| series.method == method)
    }
}
