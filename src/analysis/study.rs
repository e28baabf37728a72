//! Error against run time: every way of shading at every tessellation against the exact picture.
//!
//! Errors are of the linear intensity before the display, and nothing is clamped; a code value of the raw encoding is 1/255.
//! They are taken inside, where the picture and the exact one show the object with N·V ≥ 0.2, and for the outline apart.
//! Times are medians of whole frames but for the tessellation, which is kept as a graphics card keeps it. The settings are
//! timed in turn, each once before any is timed again, so that what slows the machine down for a while slows all of them.

mod exact;
mod fit;
mod historic;
mod measure;
mod method;
mod pareto;
mod plot;
mod report;
mod setting;

pub use fit::{Fit, fit_line, order_of, student};
pub use method::{Method, PixelCost};
pub use pareto::pareto_front;
pub use plot::{study_plot, study_point};
pub use setting::{Omission, Setting, StudyQuestion};

use super::{RegionErrors, Watch};
use crate::geometry::Mesh;
use crate::scene::{Interpolation, Scene};
use measure::Bench;
use serde::Serialize;
use std::sync::Arc;

/// What was measured of one setting.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct StudyRow {
    #[serde(flatten)]
    pub setting: Setting,
    /// The longest edge of a polygon, world units: the spacing of the vertices.
    pub spacing: f64,
    /// Inside: root mean square, greatest and 99th percentile, linear intensity before the display: values above 1 count in
    /// full.
    pub error_rms: f64,
    pub error_max: f64,
    pub error_p99: f64,
    /// Inside: root mean square and greatest of the values as shown: where the display clamps, what is above 1 counts as 1, as
    /// in the figures of a comparison.
    pub error_rms_shown: f64,
    pub error_max_shown: f64,
    /// The pixels inside.
    pub interior_pixels: u64,
    /// Pixels that show the object here or in the exact picture, but not in both; the root mean square over them.
    pub outline_pixels: u64,
    pub outline_rms: f64,
    /// Median of a frame in milliseconds, and the width of the middle half of the samples.
    pub time_ms: f64,
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
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Series {
    pub method: Method,
    pub interpolation: Option<Interpolation>,
    pub n: f64,
    /// The order p of the greatest error, which goes as hᵖ with the spacing h; none of fewer than three tessellations.
    pub order: Option<Fit>,
    /// Likewise of the root mean square.
    pub order_rms: Option<Fit>,
}

/// What a study has found.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Study {
    /// Those of one method, interpolation and n together, from coarse to fine.
    pub rows: Vec<StudyRow>,
    pub series: Vec<Series>,
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
        let time = |row: &StudyRow| if row.scalar && engine { f64::NAN } else { row.time_ms };
        let points: Vec<[f64; 2]> = self.rows.iter().map(|row| [time(row), row.error_rms]).collect();
        for (row, on) in self.rows.iter_mut().zip(pareto_front(&points)) {
            row.pareto = on;
        }
        self.series = self
            .rows
            .chunk_by(|a, b| a.setting.is_like(&b.setting))
            .map(|rows| {
                let Setting { method, interpolation, n, .. } = rows[0].setting;
                let order = order_of(rows.iter().map(|row| (row.spacing, row.error_max)));
                let order_rms = order_of(rows.iter().map(|row| (row.spacing, row.error_rms)));
                Series { method, interpolation, n, order, order_rms }
            })
            .collect();
    }

    /// The first series of a method: of the first interpolation and n that were asked for.
    pub fn series_of(&self, method: Method) -> Option<&Series> {
        self.series.iter().find(|series| series.method == method)
    }
}

/// Measures `scene`, whose object of kind `obj` shows `model`. `clock` gives nanoseconds from any fixed moment. `watch` is
/// called after each frame; when it stops the work, what is known by then is returned.
pub fn study(
    scene: &Scene,
    model: Option<Arc<Mesh>>,
    request: &StudyQuestion,
    clock: fn() -> u64,
    watch: &dyn Watch<Study>,
) -> Study {
    let (settings, omitted) = setting::settings(request, scene);
    let repeats = request.repeats.max(1);
    let total = settings.len() as u64 * u64::from(repeats);
    let mut bench = Bench::new(scene, model, clock);
    let mut study = Study { omitted, threads: rayon::current_num_threads(), ..Study::default() };
    let mut samples: Vec<Vec<u64>> = vec![Vec::new(); settings.len()];
    let mut done = 0;
    for repeat in 0..repeats {
        for (index, setting) in settings.iter().enumerate() {
            if repeat == 0 {
                let (errors, spacing) = bench.errors(setting);
                study.rows.push(row(setting, &errors, spacing));
            }
            let (nanoseconds, evaluations) = bench.time(setting);
            samples[index].push(nanoseconds);
            let row = &mut study.rows[index];
            row.evaluations = evaluations;
            row.samples = repeat + 1;
            (row.time_ms, row.spread_ms) = middle(&mut samples[index]);
            done += 1;
            study.conclude();
            watch.found(&study);
            #[expect(clippy::cast_precision_loss, reason = "a share for the eye")]
            if !watch.at(done as f32 / total as f32) && done < total {
                return study;
            }
        }
    }
    study.complete = true;
    study
}

/// `shown` are the errors of the values as shown.
fn row(setting: &Setting, [errors, shown]: &[RegionErrors; 2], spacing: f64) -> StudyRow {
    StudyRow {
        setting: *setting,
        spacing,
        error_rms: errors.interior.rms,
        error_max: errors.interior.greatest,
        error_p99: errors.percentile_99,
        error_rms_shown: shown.interior.rms,
        error_max_shown: shown.interior.greatest,
        interior_pixels: errors.interior.pixels,
        outline_pixels: errors.outline_pixels,
        outline_rms: errors.outline_rms,
        time_ms: 0.0,
        spread_ms: 0.0,
        samples: 0,
        evaluations: 0,
        pareto: false,
        scalar: setting.method.is_scalar(),
    }
}

/// Median and interquartile range of samples in nanoseconds, as milliseconds.
fn middle(samples: &mut [u64]) -> (f64, f64) {
    samples.sort_unstable();
    let quantile = |share: f64| {
        #[expect(clippy::cast_precision_loss, reason = "far fewer than 2⁵³ samples and nanoseconds")]
        let (last, value) = ((samples.len() - 1) as f64, |index: usize| samples[index] as f64 / 1e6);
        let place = share * last;
        let (below, above) = (value(place.floor() as usize), value(place.ceil() as usize));
        below + (above - below) * place.fract()
    };
    if samples.is_empty() { (0.0, 0.0) } else { (quantile(0.5), quantile(0.75) - quantile(0.25)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_middle_of_samples_is_their_median_and_quartiles() {
        assert_eq!(middle(&mut [5_000_000, 1_000_000, 3_000_000, 2_000_000, 4_000_000]), (3.0, 2.0));
        assert_eq!(middle(&mut [2_000_000, 1_000_000]), (1.5, 0.5));
        assert_eq!(middle(&mut []), (0.0, 0.0));
    }
}
