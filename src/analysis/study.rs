//! Error against run time: every shading method at every tessellation against the exact picture.
//!
//! A scene's own law is compared with a reference law, Phong's unless another is requested: both are measured against the
//! exact picture of the reference.
//!
//! Errors are of the linear intensity before the display, and nothing is clamped; a code value of the raw encoding is
//! 1/255. They are measured inside, where the picture and the exact one show the object with N·V ≥ 0.2, and
//! separately for the outline. Times are medians of whole frames without the tessellation, which is kept as a
//! graphics card keeps it. The settings are timed in turn, each once before any is timed again, so that a temporary
//! slowdown of the machine affects all of them.

mod historic;
mod jet;
mod measure;
mod report;
mod statistics;

pub use measure::study;
pub use report::{study_plot, study_point};
pub use statistics::{Fit, fit_line, median_and_spread, order_of, pareto_front, student};

use crate::illumination::law_operations;
use crate::scene::{
    Choice, FlatAt, Interpolation, ReflectionModel, Scene, ShadingMode, choices, presets,
};
use crate::text::{Message, text};
use serde::{Deserialize, Serialize};

choices! {
    /// A shading method: one of the engine's modes, or one of the historic methods, in scalar code.
    pub enum Method = "method" {
        /// Flat shading, evaluated at the centre of each polygon.
        Flat = "flat";
        /// Flat shading by the mean of the vertices.
        FlatVertexMean = "flat-vertex-mean";
        /// Interpolated shading with the polygon's own normal at the vertices.
        Interpolated = "interpolated";
        /// Gouraud shading (Gouraud 1971).
        Gouraud = "gouraud";
        /// Phong shading (Phong 1975), normals scaled to unit length at each pixel.
        Phong = "phong";
        /// Phong shading with interpolated normals that are not normalised.
        PhongUnnormalised = "phong-unnormalised";
        /// Phong shading in the same scalar code as Taylor's and the angular method.
        PhongScalar = "phong-scalar";
        /// Taylor expansion of the cosines over each triangle (Bishop and Weimer 1986).
        Taylor = "taylor";
        /// Angular interpolation (Kuijk and Blake 1989): normals turn by equal angles along edges and spans.
        Angular = "angular";
    }
}

impl Method {
    /// Returns whether scalar code in one thread draws it instead of the engine.
    pub fn is_scalar(self) -> bool {
        matches!(self, Self::PhongScalar | Self::Taylor | Self::Angular)
    }

    /// Returns the cost of a pixel inside a span without coverage and depth, under one white light and a viewer at
    /// infinity: additions, multiplications, divisions and roots, and powers, which the papers look up in a table.
    ///
    /// Phong's normal takes 3 additions to interpolate, and 6 multiplications, 2 additions, a root and a division to
    /// normalise; N·L and N·V 3 multiplications and 2 additions each; R·V = 2(N·L)(N·V) − L·V 2 and 1; the sum with kd
    /// and ks 2 and 2. Taylor's two cosines take 2 additions each by forward differences, their sum the fifth. The
    /// normal of angular interpolation takes 3 multiplications and 3 additions and has unit length by construction.
    pub fn pixel_cost(self) -> [u32; 4] {
        self.pixel_cost_of(PHONG_COST)
    }

    /// Returns the cost of a pixel likewise, with a law that costs `law` where it is evaluated at each pixel.
    pub fn pixel_cost_of(self, law: [u32; 4]) -> [u32; 4] {
        let normal = match self {
            Self::Flat | Self::FlatVertexMean => return [0, 0, 0, 0],
            Self::Interpolated | Self::Gouraud => return [1, 0, 0, 0],
            Self::Taylor => return [5, 0, 0, 1],
            Self::Phong | Self::PhongScalar => [5, 6, 2, 0],
            Self::PhongUnnormalised => [3, 0, 0, 0],
            Self::Angular => [3, 3, 0, 0],
        };
        std::array::from_fn(|kind| normal[kind] + law[kind])
    }

    /// Applies the method to a scene; scalar ones leave it unchanged.
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

/// The cost of Phong's law with unit vectors N and V: see [`Method::pixel_cost`].
const PHONG_COST: [u32; 4] = [7, 10, 0, 1];

/// Returns the cost of the scene's law, as in [`Method::pixel_cost`]; of its own the operations of its code and the addition of
/// the ambient term. None for Cook and Torrance's, which no paper counts.
fn law_cost(scene: &Scene) -> Option<[u32; 4]> {
    match scene.reflection.model {
        ReflectionModel::Phong => Some(PHONG_COST),
        // N·L and N·H, H being the same everywhere, and the sum.
        ReflectionModel::Blinn => Some([6, 8, 0, 1]),
        ReflectionModel::CookTorrance => None,
        ReflectionModel::Formula => {
            let [additions, rest @ ..] = law_operations(scene).ok()?;
            let [multiplications, divisions, powers] = rest;
            Some([additions + 1, multiplications, divisions, powers])
        }
    }
}

/// The settings that a study compares.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StudyQuestion {
    /// The methods.
    pub methods: Vec<Method>,
    /// Numbers of polygons around the axis, with those along it in proportion; an object whose polygons are given keeps them.
    pub segments: Vec<u32>,
    /// Interpolations, where they make a difference.
    pub interpolations: Vec<Interpolation>,
    /// Exponents; none stands for the scene's own.
    pub n: Vec<f64>,
    /// Number of frames timed for each setting, at least 1.
    pub repeats: u32,
    /// The law whose exact picture errors are measured against; none stands for Phong's where the scene has a law of its own, and
    /// elsewhere for the scene's. If it is not the scene's, both laws are measured.
    pub reference: Option<ReflectionModel>,
}

impl Default for StudyQuestion {
    fn default() -> Self {
        Self {
            methods: Method::VALUES.to_vec(),
            segments: vec![8, 16, 32, 64, 128, 256],
            interpolations: vec![Interpolation::Perspective, Interpolation::Affine],
            n: Vec::new(),
            repeats: 9,
            reference: None,
        }
    }
}

impl StudyQuestion {
    /// Returns the law whose exact picture errors are measured against.
    pub fn reference(&self, scene: &Scene) -> ReflectionModel {
        let own = match scene.reflection.model {
            ReflectionModel::Formula => ReflectionModel::Phong,
            built_in => built_in,
        };
        self.reference.unwrap_or(own)
    }

    /// Returns the laws to measure, the scene's first; a single one needs no name.
    fn laws(&self, scene: &Scene) -> Vec<Option<ReflectionModel>> {
        let (own, reference) = (scene.reflection.model, self.reference(scene));
        if own == reference {
            vec![None]
        } else {
            vec![Some(own), Some(reference)]
        }
    }

    /// Returns whether scene `b` differs from `a`, which was measured, only in what a study sets itself, so that both have the same
    /// results.
    pub fn same(&self, a: &Scene, b: &Scene) -> bool {
        let laws = self.laws(a);
        let plain = |scene: &Scene| {
            let mut plain = scene.clone();
            let measured = laws.contains(&Some(scene.reflection.model));
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
                law: measured.then_some(a.reflection.model),
            };
            setting.apply(&mut plain);
            plain
        };
        plain(a) == plain(b)
    }
}

/// A setting with which the scene is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Setting {
    /// The method.
    pub method: Method,
    /// Number of polygons round the axis.
    pub segments: u32,
    /// Number of polygons along the axis.
    pub rings: u32,
    /// The interpolation; none where it makes no difference.
    pub interpolation: Option<Interpolation>,
    /// The specular exponent.
    pub n: f64,
    /// The law of reflection, where two are compared; none stands for the scene's.
    pub law: Option<ReflectionModel>,
}

impl Setting {
    fn apply(&self, scene: &mut Scene) {
        (scene.object.segments, scene.object.rings) = (self.segments, self.rings);
        scene.material.n = self.n;
        scene.shading.interpolation = self.interpolation.unwrap_or(scene.shading.interpolation);
        scene.reflection.model = self.law.unwrap_or(scene.reflection.model);
        self.method.apply(scene);
    }

    /// Applies the setting to a scene and returns true, unless it is one of the scalar methods, which no scene has.
    pub fn load(&self, scene: &mut Scene) -> bool {
        let drawn = !self.method.is_scalar();
        if drawn {
            self.apply(scene);
        }
        drawn
    }

    /// Returns whether it belongs to the same series of tessellations.
    fn is_like(&self, other: &Self) -> bool {
        let series = |of: &Self| (of.method, of.interpolation, of.n.to_bits(), of.law);
        series(self) == series(other)
    }
}

/// Returns the title of a method, with the interpolation unless it is the usual one.
fn title(method: Method, interpolation: Option<Interpolation>) -> String {
    let method = method.label();
    match interpolation {
        Some(Interpolation::Affine) => text!("engine-method-affine", method = method),
        Some(Interpolation::Scanline) => text!("engine-method-scanline", method = method),
        Some(Interpolation::Perspective) | None => method.to_owned(),
    }
}

/// Returns the name of a scene's own law: the scene's title, unless that is a built-in scene's which has another law; may be empty.
fn own_law(scene: &Scene) -> String {
    let title = &scene.about.title;
    let another = presets::ALL.iter().any(|preset| {
        let built_in = preset.scene();
        built_in.about.title == *title && built_in.reflection != scene.reflection
    });
    if another {
        String::new()
    } else {
        title.clone()
    }
}

/// An omitted setting, with the reason.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Omission {
    /// The method.
    pub method: Method,
    /// The interpolation; none where it makes no difference.
    pub interpolation: Option<Interpolation>,
    /// The law, where two are compared.
    pub law: Option<ReflectionModel>,
    /// The reason why it is not measured.
    pub reason: Message,
}

/// Measurements of one setting.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StudyRow {
    /// The setting with which the scene was drawn.
    pub setting: Setting,
    /// Longest edge of a polygon, world units: the spacing of the vertices.
    pub spacing: f64,
    /// Root mean square error inside, linear intensity before the display: values above 1 count in full.
    pub error_rms: f64,
    /// Maximum error inside, likewise.
    pub error_max: f64,
    /// 99th percentile of the error inside, likewise.
    pub error_p99: f64,
    /// Root mean square error inside of the values as shown, clamped where the display clamps, as in a comparison.
    pub error_rms_shown: f64,
    /// Maximum error inside of the values as shown.
    pub error_max_shown: f64,
    /// Number of pixels inside.
    pub interior_pixels: u64,
    /// Number of pixels that show the object here or in the exact picture, but not in both.
    pub outline_pixels: u64,
    /// Root mean square error over those pixels.
    pub outline_rms: f64,
    /// Median time of a frame, milliseconds.
    pub time_ms: f64,
    /// Width of the middle half of the samples, milliseconds.
    pub spread_ms: f64,
    /// Number of frames timed.
    pub samples: u32,
    /// Number of evaluations of the equation in a frame; of Taylor's method the triangles expanded.
    pub evaluations: u64,
    /// True if no other setting that the engine draws is both faster and nearer to the exact picture.
    pub pareto: bool,
    /// True if the time is that of scalar code in one thread instead of the engine.
    pub scalar: bool,
    /// Root mean square difference inside from the same setting with the reference law, linear intensity before the display; none
    /// where the law is the reference.
    pub law_rms: Option<f64>,
    /// Operations at a pixel, as in [`Method::pixel_cost`], with the setting's law; none where the law has no count.
    pub operations: Option<[u32; 4]>,
}

/// Dependence of one method's errors on the tessellation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Series {
    /// The method.
    pub method: Method,
    /// The interpolation; none where it makes no difference.
    pub interpolation: Option<Interpolation>,
    /// The specular exponent.
    pub n: f64,
    /// The law, where two are compared.
    pub law: Option<ReflectionModel>,
    /// Order p of the maximum error, proportional to hᵖ with the spacing h; none for fewer than three tessellations.
    pub order: Option<Fit>,
    /// Order of the root mean square error, likewise.
    pub order_rms: Option<Fit>,
}

/// The results of a study.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Study {
    /// Rows, those of one method, interpolation and n together, from coarse to fine.
    pub rows: Vec<StudyRow>,
    /// The orders of convergence.
    pub series: Vec<Series>,
    /// The settings that were omitted.
    pub omitted: Vec<Omission>,
    /// True if the study was not cut short.
    pub complete: bool,
    /// Number of threads of the engine.
    pub threads: usize,
    /// The law whose exact picture errors are measured against, where two laws are compared.
    pub reference: Option<ReflectionModel>,
    /// The name of the scene's own law; empty if it has none.
    pub own_law: String,
}

impl Study {
    /// Returns the name of a law.
    fn law_name(&self, law: ReflectionModel) -> String {
        match law {
            ReflectionModel::Formula if self.own_law.is_empty() => text!("engine-law-own").into(),
            ReflectionModel::Formula => self.own_law.clone(),
            ReflectionModel::Phong => text!("engine-law", name = "Phong"),
            ReflectionModel::Blinn => text!("engine-law", name = "Blinn"),
            ReflectionModel::CookTorrance => text!("engine-law", name = "Cook–Torrance"),
        }
    }

    /// Returns the title of a method, with the law where two are compared.
    fn method_title(
        &self,
        method: Method,
        interpolation: Option<Interpolation>,
        law: Option<ReflectionModel>,
    ) -> String {
        let method = title(method, interpolation);
        match law {
            Some(law) => text!(
                "engine-law-method",
                law = self.law_name(law),
                method = method
            ),
            None => method,
        }
    }

    /// Returns a setting's title.
    pub fn title(&self, setting: &Setting) -> String {
        let Setting {
            method,
            interpolation,
            law,
            segments,
            rings,
            ..
        } = *setting;
        let method = self.method_title(method, interpolation, law);
        format!("{method} {segments}×{rings}")
    }

    /// Marks the Pareto front and fits the orders of convergence.
    fn conclude(&mut self) {
        // Times of engine and scalar code are not comparable: the scalar ones count only where there are no others.
        let engine = self.rows.iter().any(|row| !row.scalar);
        let time = |row: &StudyRow| {
            if row.scalar && engine {
                f64::NAN
            } else {
                row.time_ms
            }
        };
        let points = self.rows.iter().map(|row| [time(row), row.error_rms]);
        let points: Vec<[f64; 2]> = points.collect();
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
                    law,
                    ..
                } = rows[0].setting;
                Series {
                    method,
                    interpolation,
                    n,
                    law,
                    order: order_of(rows.iter().map(|row| (row.spacing, row.error_max))),
                    order_rms: order_of(rows.iter().map(|row| (row.spacing, row.error_rms))),
                }
            })
            .collect();
    }

    /// Returns the first series of a method: of the first interpolation and n requested, and of the scene's law.
    pub fn series_of(&self, method: Method) -> Option<&Series> {
        self.series.iter().find(|series| series.method == method)
    }
}
