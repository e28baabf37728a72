//! Comparison of two pictures of one scene, and the brightest pixel of one.

mod sheet;

pub use sheet::{
    Captions, DrawnPane, PaneArea, caption, comparison_sheet, difference_picture, difference_scale,
    draw_panes, error_line, pane_areas, pane_figures, panes_on_sheet,
};

use super::perception::pixel_luminance;
use super::report::{
    Answer, Column, Part, Report, ReportContext, Table, as_it_is, fixed, table_of, word,
};
use super::{Question, Subject, Watch};
use crate::scene::Scene;
use crate::text;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

/// Number of pixels per task.
const CHUNK: usize = 1 << 14;

/// A picture before the display: linear red, green, blue, and the share of each pixel that shows the object.
#[derive(Clone, Copy, Debug)]
pub struct LinearPicture<'a> {
    /// Width in pixels.
    pub width: u32,
    /// `[red, green, blue, share]`, row by row from the top.
    pub pixels: &'a [[f32; 4]],
    /// True if the display clamps at 1: differences above are then invisible and not counted.
    pub clamps: bool,
}

impl LinearPicture<'_> {
    pub(crate) fn color(&self, index: usize) -> [f64; 3] {
        let [r, g, b, _] = self.pixels[index].map(f64::from);
        if self.clamps {
            [r, g, b].map(|value| value.min(1.0))
        } else {
            [r, g, b]
        }
    }

    fn shows(&self, index: usize) -> bool {
        self.pixels[index][3] != 0.0
    }

    /// Returns |d| of each channel of a pixel.
    fn differences(&self, reference: &Self, index: usize) -> [f64; 3] {
        let (a, b) = (self.color(index), reference.color(index));
        std::array::from_fn(|channel| (a[channel] - b[channel]).abs())
    }

    fn position(&self, index: usize) -> [u32; 2] {
        let (index, width) = (index as u64, u64::from(self.width.max(1)));
        [(index % width) as u32, (index / width) as u32]
    }
}

/// Difference of one picture from another over the pixels that show the object in either, in linear intensity.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ErrorFigures {
    /// Number of pixels compared.
    pub pixels: u64,
    /// Mean of |d| over pixels and channels.
    pub mean: f64,
    /// Root of the mean of d².
    pub rms: f64,
    /// Maximum |d| of any channel.
    pub greatest: f64,
    /// The first pixel with that maximum; none where nothing differs.
    pub at: Option<[u32; 2]>,
    /// Region of that pixel.
    pub region: Option<ErrorRegion>,
}

/// A region of the pixels that show an object in two pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum ErrorRegion {
    /// Both show the object.
    Inside,
    /// One of them shows it, the other something else.
    Outline,
}

impl ErrorRegion {
    /// Returns its name in the current language.
    pub fn name(self) -> &'static str {
        match self {
            Self::Inside => text!("picture-region-inside"),
            Self::Outline => text!("picture-region-outline"),
        }
    }
}

/// Computes the error of `picture` against `reference` of the same size.
pub fn error_figures(picture: LinearPicture<'_>, reference: LinearPicture<'_>) -> ErrorFigures {
    error_figures_where(picture, reference, |index| {
        picture.shows(index) || reference.shows(index)
    })
}

fn error_figures_where(
    picture: LinearPicture<'_>,
    reference: LinearPicture<'_>,
    counts: impl Fn(usize) -> bool + Sync,
) -> ErrorFigures {
    let count = picture.pixels.len().min(reference.pixels.len());
    let inside = |index| picture.shows(index) == reference.shows(index);
    // For a part, sums in place of the means.
    let part = |chunk: usize| {
        let mut part = ErrorFigures::default();
        for index in (chunk * CHUNK..count.min((chunk + 1) * CHUNK)).filter(|index| counts(*index))
        {
            part.pixels += 1;
            for difference in picture.differences(&reference, index) {
                part.mean += difference;
                part.rms += difference * difference;
                if difference > part.greatest {
                    (part.greatest, part.at) = (difference, Some(picture.position(index)));
                    let region = if inside(index) {
                        ErrorRegion::Inside
                    } else {
                        ErrorRegion::Outline
                    };
                    part.region = Some(region);
                }
            }
        }
        part
    };
    let parts: Vec<ErrorFigures> = (0..count.div_ceil(CHUNK))
        .into_par_iter()
        .map(part)
        .collect();
    // Added in the picture's order, so that the number of threads does not matter.
    let mut total = ErrorFigures::default();
    for part in parts {
        total.pixels += part.pixels;
        total.mean += part.mean;
        total.rms += part.rms;
        if part.greatest > total.greatest {
            (total.greatest, total.at, total.region) = (part.greatest, part.at, part.region);
        }
    }
    let values = (3 * total.pixels).max(1) as f64;
    ErrorFigures {
        mean: total.mean / values,
        rms: (total.rms / values).sqrt(),
        ..total
    }
}

/// Difference of a picture from another, linear intensity, where both show the object and where only one does.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RegionErrors {
    /// Error over the pixels inside.
    pub interior: ErrorFigures,
    /// 99th percentile of the errors inside, by the maximum |d| of a pixel's channels (nearest rank).
    pub percentile_99: f64,
    /// Number of pixels that show the object in one of the pictures only.
    pub outline_pixels: u64,
    /// Root of the mean of d² over those pixels.
    pub outline_rms: f64,
}

/// Computes the errors against a `reference` of the same size; inside is where `inside` says so and both show the
/// object.
pub fn region_errors(
    picture: LinearPicture<'_>,
    reference: LinearPicture<'_>,
    inside: &[bool],
) -> RegionErrors {
    let count = picture
        .pixels
        .len()
        .min(reference.pixels.len())
        .min(inside.len());
    let interior = |index: usize| {
        index < count && inside[index] && picture.shows(index) && reference.shows(index)
    };
    let outline = error_figures_where(picture, reference, |index| {
        picture.shows(index) != reference.shows(index)
    });
    let greatest = |index| {
        picture
            .differences(&reference, index)
            .into_iter()
            .fold(0.0, f64::max)
    };
    let mut greatest: Vec<f64> = (0..count)
        .filter(|index| interior(*index))
        .map(greatest)
        .collect();
    let rank = (0.99 * greatest.len() as f64).ceil() as usize;
    let percentile_99 = match rank.checked_sub(1) {
        Some(index) => *greatest.select_nth_unstable_by(index, f64::total_cmp).1,
        None => 0.0,
    };
    RegionErrors {
        interior: error_figures_where(picture, reference, interior),
        percentile_99,
        outline_pixels: outline.pixels,
        outline_rms: outline.rms,
    }
}

/// The brightest pixel of the object.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Brightest {
    /// Its luminance (Rec. 709), linear and not clamped.
    pub value: f64,
    /// Its column and row, from 0.
    pub at: [u32; 2],
}

/// Finds the brightest pixel that shows the object, the first of equal ones.
pub fn brightest(picture: LinearPicture<'_>) -> Option<Brightest> {
    let seen = picture
        .pixels
        .par_iter()
        .enumerate()
        .with_min_len(CHUNK)
        .filter(|(_, pixel)| pixel[3] > 0.0);
    let values = seen
        .map(|(index, pixel)| (pixel_luminance(pixel), index))
        .filter(|(value, _)| !value.is_nan());
    let brighter = |a: (f64, usize), b: (f64, usize)| {
        if b.0 > a.0 || (b.0 == a.0 && b.1 < a.1) {
            b
        } else {
            a
        }
    };
    values
        .reduce_with(brighter)
        .map(|(value, index)| Brightest {
            value,
            at: picture.position(index),
        })
}

/// The figures in a pane's caption.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PaneFigures {
    /// Index of the pane.
    #[serde(skip)]
    pub pane: usize,
    /// Name of the pane.
    pub name: String,
    /// The brightest pixel; none where no pixel shows the object.
    pub brightest: Option<Brightest>,
    /// Error against the reference; none for the reference itself.
    pub error: Option<ErrorFigures>,
}

/// The question for the difference of the scene's panes from the reference among them. The scene defines its panes.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ComparisonQuestion;

/// The figures of each pane.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison(pub Vec<PaneFigures>);

impl Question for ComparisonQuestion {
    type Answer = Comparison;

    fn answer(
        &self,
        subject: &Subject,
        watch: &dyn Watch<Comparison>,
    ) -> Result<Comparison, String> {
        let scene = &subject.scene;
        if scene.compare.panes.is_empty() {
            return Err(text!("picture-no-panes").to_owned());
        }
        let which: Vec<_> = (0..scene.pane_count())
            .map(|index| (index, scene.image.size))
            .collect();
        let mut progress = |done: u32| watch.progress(done as f32 / which.len() as f32);
        let nothing = |_: &mut _, _: &mut _, _: &_| Ok::<(), String>(());
        let panes = draw_panes(
            &mut subject.renderer(),
            scene,
            &which,
            1,
            &mut progress,
            nothing,
        )?;
        Ok(Comparison(pane_figures(&panes)))
    }
}

impl Comparison {
    fn named(&self, scene: &Scene) -> Vec<PaneFigures> {
        let mut panes = self.0.clone();
        for pane in panes.iter_mut().filter(|one| one.pane < scene.pane_count()) {
            pane.name = scene.pane_name(pane.pane);
        }
        panes
    }
}

/// Returns the table of the figures of all panes.
fn figures(panes: &[PaneFigures]) -> Table {
    table_of! { pane in panes;
        Column::both("pane", text!("picture-column-pane"), as_it_is) => pane.name.as_str();
        Column::both("brightest", text!("picture-column-brightest"), fixed::<4>).extra() => pane.brightest.map(|b| b.value);
        Column::key("brightest_x") => pane.brightest.map(|b| b.at[0]);
        Column::key("brightest_y") => pane.brightest.map(|b| b.at[1]);
        Column::key("pixels") => pane.error.map(|e| e.pixels);
        Column::both("mean", text!("picture-column-mean"), fixed::<4>) => pane.error.map(|e| e.mean);
        Column::both("rms", "RMS", fixed::<4>) => pane.error.map(|e| e.rms);
        Column::both("greatest", text!("picture-column-greatest"), fixed::<4>) => pane.error.map(|e| e.greatest);
        Column::shown(text!("picture-column-at"), as_it_is).extra() => pane.error.and_then(|e| e.at).map(|[x, y]| format!("{x},{y}"));
        Column::key("x") => pane.error.and_then(|e| e.at).map(|at| at[0]);
        Column::key("y") => pane.error.and_then(|e| e.at).map(|at| at[1]);
        Column::shown(text!("picture-column-region"), as_it_is).extra() => pane.error.and_then(|e| e.region).map(ErrorRegion::name);
        Column::key("region") => pane.error.and_then(|e| e.region).as_ref().map(word);
    }
}

impl Answer for Comparison {
    fn report(&self, about: &ReportContext<'_>) -> Report {
        let panes = self.named(about.scene);
        let reference = panes.iter().find(|pane| pane.error.is_none());
        let mut report = Report::new(text!(
            "picture-compared",
            scene = about.heading(),
            reference = reference.map_or("", |pane| pane.name.as_str())
        ));
        report.section("").note(text!("picture-linear"));
        report.section("").push(Part::Table(figures(&panes)));
        report
    }

    fn value(&self, about: &ReportContext<'_>) -> Value {
        let panes = self.named(about.scene);
        json!({ "scene": about.name, "size": about.scene.image.size, "panes": panes })
    }
}
