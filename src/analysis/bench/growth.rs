//! Growth of a frame's time with the pixels and with the triangles: pictures of one scene, from few pixels to many, and
//! tessellations in one picture. Those of a series are drawn in turn, so that other load of the machine affects all
//! alike, each once uncounted just before, and slow ones in fewer of the rounds.

use super::{Run, median_ms};
use crate::analysis::report::{Column, Part, Report, as_it_is, fixed, table_of};
use crate::analysis::study::{Fit, order_of};
use crate::geometry::{divisions_for, triangles};
use crate::render::Renderer;
use crate::scene::{Image, Scene};
use crate::text::text;
use serde::{Deserialize, Serialize};

/// Approximate number of pixels of the pictures, each twice the one before, drawn with [`FEW_TRIANGLES`].
const PIXELS: [f64; 8] = [
    65_536.0,
    131_072.0,
    262_144.0,
    524_288.0,
    1_048_576.0,
    2_097_152.0,
    4_194_304.0,
    8_388_608.0,
];
const FEW_TRIANGLES: u64 = 1024;
/// Approximate number of triangles of the tessellations, in a picture of [`FEW_PIXELS`].
const TRIANGLES: [u64; 9] = [
    16_384, 32_768, 65_536, 131_072, 262_144, 524_288, 1_048_576, 2_097_152, 4_194_304,
];
const FEW_PIXELS: f64 = 65_536.0;

/// Time above which a frame takes part in every second round, one twice as long in every third, and so on.
const ROUND_MS: f64 = 15.0;
/// Minimum number of rounds for any frame, unless fewer are requested.
const LEAST_FRAMES: u32 = 5;

/// A picture of a series.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Row {
    pub pixels: u64,
    pub triangles: u64,
    /// Number of frames in the median.
    pub frames: usize,
    pub median_ms: f64,
    /// Minimum time, which other work on the machine has delayed least.
    pub fastest_ms: f64,
}

/// A series of pictures, and the exponents by which the time grows, if enough are known: through all of it, through its
/// upper half, where the fixed cost of a frame counts for less, and through the fastest frames.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Series {
    pub rows: Vec<Row>,
    pub order: Option<Fit>,
    pub order_upper: Option<Fit>,
    pub order_fastest: Option<Fit>,
}

/// Growth of the time.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Growth {
    /// Growth with the pixels of the picture.
    pub pixels: Series,
    /// Growth with the triangles; none for objects whose polygons are given.
    pub triangles: Option<Series>,
}

/// Returns the maximum number of frames that [`measure`] draws.
pub fn most_frames(frames: u32) -> u64 {
    u64::from(frames) * (PIXELS.len() + TRIANGLES.len()) as u64
}

/// Measures the growth with the pixels and with the triangles.
pub fn measure(run: Run<'_>) -> Growth {
    let scene = &run.subject.scene;
    let coarse = divided(scene, FEW_TRIANGLES).unwrap_or_else(|| scene.clone());
    let pictures = PIXELS
        .iter()
        .map(|pixels| sized(&coarse, *pixels))
        .collect();
    let fine: Vec<Scene> = TRIANGLES
        .iter()
        .filter_map(|count| divided(&sized(scene, FEW_PIXELS), *count))
        .collect();
    Growth {
        pixels: series(run, pictures, |row| row.pixels),
        triangles: (!fine.is_empty()).then(|| series(run, fine, |row| row.triangles)),
    }
}

/// Returns the scene with about `pixels` pixels.
fn sized(scene: &Scene, pixels: f64) -> Scene {
    let mut scene = scene.clone();
    let [width, height] = scene.image.size.map(f64::from);
    let factor = (pixels / (width * height)).sqrt();
    let side = |length: f64| ((length * factor).round() as u32).clamp(1, Image::MAX_SIDE);
    scene.image.size = [side(width), side(height)];
    scene
}

/// Returns the scene with about `count` triangles; none where its polygons are given, or it cannot have nearly so many.
fn divided(scene: &Scene, count: u64) -> Option<Scene> {
    let mut scene = scene.clone();
    let object = &mut scene.object;
    if object.kind.is_given() {
        return None;
    }
    [object.segments, object.rings] = divisions_for(object.kind, count);
    // A shape that cannot be tessellated so finely has fewer.
    (triangles(object) * 2 > count).then_some(scene)
}

struct Frame {
    renderer: Renderer,
    clock: fn() -> u64,
    scene: Scene,
    /// Interval of the rounds in which it takes part.
    stride: u32,
    times: Vec<u64>,
}

impl Frame {
    fn new(run: Run<'_>, scene: Scene) -> Self {
        let mut renderer = run.subject.renderer().with_level(run.level);
        renderer.render(&scene);
        let mut frame = Self {
            renderer,
            clock: run.subject.clock,
            scene,
            stride: 1,
            times: Vec::new(),
        };
        let stride = median_ms(&mut [frame.time()]) / ROUND_MS;
        let stride = (stride.ceil() as u32).max(1);
        frame.stride = stride.min((run.frames / LEAST_FRAMES).max(1));
        frame
    }

    /// Measures the time of a frame drawn from scratch.
    fn time(&mut self) -> u64 {
        self.renderer.redraw();
        let began = (self.clock)();
        self.renderer.render(&self.scene);
        (self.clock)() - began
    }

    fn row(mut self) -> Row {
        let [width, height] = self.scene.image.size.map(u64::from);
        let fastest = self.times.iter().min();
        Row {
            pixels: width * height,
            triangles: self.renderer.report().triangles,
            frames: self.times.len(),
            fastest_ms: fastest.map_or(0.0, |fastest| median_ms(&mut [*fastest])),
            median_ms: median_ms(&mut self.times),
        }
    }
}

fn series(run: Run<'_>, scenes: Vec<Scene>, size: fn(&Row) -> u64) -> Series {
    let mut drawn: Vec<Frame> = scenes
        .into_iter()
        .map(|scene| Frame::new(run, scene))
        .collect();
    for round in 0..run.frames {
        for frame in &mut drawn {
            if round.is_multiple_of(frame.stride) {
                frame.time();
                let time = frame.time();
                frame.times.push(time);
            }
            (run.count)();
        }
    }
    let rows: Vec<Row> = drawn.into_iter().map(Frame::row).collect();
    let order = |rows: &[Row], ms: fn(&Row) -> f64| {
        order_of(rows.iter().map(|row| (size(row) as f64, ms(row))))
    };
    let median = |row: &Row| row.median_ms;
    Series {
        order: order(&rows, median),
        order_upper: order(&rows[rows.len() / 2..], median),
        order_fastest: order(&rows, |row| row.fastest_ms),
        rows,
    }
}

impl Growth {
    /// Adds the tables, with the exponents below.
    pub fn describe(&self, report: &mut Report) {
        let series = [
            ("engine-growth-pixels", Some(&self.pixels)),
            ("engine-growth-triangles", self.triangles.as_ref()),
        ];
        for (name, series) in series {
            let Some(series) = series else { continue };
            let table = table_of! { row in &series.rows;
                Column::shown(text!("engine-pixels"), as_it_is) => row.pixels;
                Column::shown(text!("engine-triangles"), as_it_is) => row.triangles;
                Column::shown(text!("engine-frames"), as_it_is) => row.frames;
                Column::shown(text!("engine-median-ms"), fixed::<3>) => row.median_ms;
                Column::shown(text!("engine-fastest-ms"), fixed::<3>) => row.fastest_ms;
            };
            let section = report.section(text!(name));
            section.push(Part::Table(table));
            let fits = [
                ("engine-fit-all", series.order),
                ("engine-fit-upper", series.order_upper),
                ("engine-fit-fastest", series.order_fastest),
            ];
            for (which, fit) in fits {
                let exponent = |fit: Fit| {
                    text!(
                        "engine-fit",
                        slope = format!("{:.3}", fit.slope),
                        spread = format!("{:.3}", fit.confidence),
                        count = fit.points
                    )
                };
                section.quantity(
                    fit.map_or_else(|| text!("engine-fit-too-few").to_owned(), exponent),
                    text!(which),
                );
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Object, ObjectKind};

    #[test]
    fn pictures_and_tessellations_are_as_fine_as_asked_for_or_not_there() {
        let mut scene = Scene::default();
        scene.image.size = [640, 480];
        for pixels in PIXELS {
            let [width, height] = sized(&scene, pixels).image.size.map(f64::from);
            assert!(
                (width * height / pixels - 1.0).abs() < 0.01,
                "{width} × {height}"
            );
            assert!(
                (width / height * 3.0 / 4.0 - 1.0).abs() < 0.01,
                "{width} × {height}"
            );
        }
        for count in TRIANGLES {
            let divided = divided(&scene, count).expect("a sphere of any fineness");
            assert!(
                triangles(&divided.object).abs_diff(count) < count / 50,
                "{count}"
            );
            assert_eq!(divided.validate(), Ok(()));
        }
        let model = Scene {
            object: Object {
                kind: ObjectKind::Obj,
                ..Object::default()
            },
            ..Scene::default()
        };
        assert_eq!(divided(&model, 1000), None);
    }
}
