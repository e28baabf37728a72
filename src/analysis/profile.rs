//! The intensity along a line through the picture for each shading mode, with its slope and its perceived brightness.
//!
//! Gouraud shading makes the intensity continuous but leaves corners in it, where its slope jumps: Mach bands appear
//! there. Phong shading weakens them but does not remove them.
//!
//! Intensities are linear and before the display: neither clamped nor rounded, as Rec. 709 luminance. The equation is
//! evaluated at the places of the line themselves, in double precision, where the shading mode evaluates it; only the
//! contributions of rays (a ground, objects seen through glass, light from other surfaces) are taken from the pixels,
//! linear between their centres.

mod line;
mod picture;
mod plots;

pub use line::Sample;
pub use picture::{
    PERCEIVED_WIDTH, ProfileCurves, draw_profile, lay_out_profile, perceived_picture,
};
pub use plots::{Abscissa, Compared, compared_plots, mode_dash};

use super::codec::Codec;
use super::perception::{Perception, Viewing, blur_line};
use super::report::{Answer, Cell, Column, Part, Report, ReportContext, Table, cells};
use super::{Question, Subject, Watch};
use crate::render::{Piece, Renderer};
use crate::scene::{Choice, Scene, ShadingMode};
use crate::text::text;
use glam::DVec2;
use line::{Line, Source};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use thiserror::Error;

/// The line, modes and viewing conditions of a profile.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ProfileQuestion {
    /// Start of the line in pixels, inside the picture; pixel centres are at +0.5.
    pub from: DVec2,
    /// End of the line in pixels, likewise.
    pub to: DVec2,
    /// The modes to compare, at least one.
    pub modes: Vec<ShadingMode>,
    /// Viewing conditions, which give a pixel's size for the eye.
    pub viewing: Viewing,
    /// The model of the eye.
    pub perception: Perception,
}

impl ProfileQuestion {
    /// The modes that are compared by default.
    pub const MODES: [ShadingMode; 4] = [
        ShadingMode::Flat,
        ShadingMode::Gouraud,
        ShadingMode::Phong,
        ShadingMode::Exact,
    ];

    /// Returns a question for the line between two places, with everything else at its default.
    pub fn new(from: DVec2, to: DVec2) -> Self {
        let (viewing, perception) = Default::default();
        Self {
            from,
            to,
            modes: Self::MODES.to_vec(),
            viewing,
            perception,
        }
    }

    /// Checks whether the profile exists in a picture of `size`; the error is the reason why it does not.
    pub fn check(&self, size: [u32; 2]) -> Result<(), ProfileError> {
        self.line(size).map(|_| ())
    }

    fn line(&self, size: [u32; 2]) -> Result<Line, ProfileError> {
        let inside = |p: DVec2| {
            p.cmpge(DVec2::ZERO).all() && p.cmple(DVec2::from_array(size.map(f64::from))).all()
        };
        if !inside(self.from) || !inside(self.to) {
            return Err(ProfileError::Outside { size });
        }
        if self.modes.is_empty() {
            return Err(ProfileError::NoMode);
        }
        let [_, surround] = self.perception.widths(self.viewing.pixels_per_degree());
        Line::new(self.from, self.to, size, surround).ok_or(ProfileError::NoLength)
    }
}

/// The reason why there is no profile.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum ProfileError {
    /// An end lies outside the picture.
    #[error("{}", text!("line-error-outside", width = .size[0], height = .size[1]))]
    Outside {
        /// Width and height of the picture.
        size: [u32; 2],
    },
    /// Both ends are the same point.
    #[error("{}", text!("line-error-no-length"))]
    NoLength,
    /// No mode is requested.
    #[error("{}", text!("line-error-no-mode"))]
    NoMode,
}

/// The profile along a line.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Profile {
    /// Places along the line, evenly spaced: pixel centres, and places between them on short lines.
    pub samples: Vec<Sample>,
    /// One trace per mode, in the order requested.
    pub traces: Vec<Trace>,
    /// Crossings of the line from one polygon to another or to the background. The true surface has none.
    pub borders: Vec<Border>,
    /// Length of the line, pixels.
    pub length: f64,
    /// σc and σs, pixels.
    pub widths: [f64; 2],
}

/// The values of one mode, one per sample.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Trace {
    /// The shading mode.
    pub mode: ShadingMode,
    /// Luminance, linear and before the display.
    pub intensity: Vec<f64>,
    /// Slope per pixel along the line, within the polygon that the sample sees, so that a corner stays a jump.
    pub slope: Vec<f64>,
    /// Perceived brightness, by the question's model.
    pub perceived: Vec<f64>,
    /// Intensities at each border; none where the mode knows no polygons.
    pub corners: Vec<Option<Discontinuity>>,
}

/// A border between polygons on the line.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Border {
    /// Pixels from the picture's left.
    pub x: f64,
    /// Pixels from the picture's top.
    pub y: f64,
    /// Parameter along the line, 0 at its start and 1 at its end.
    pub t: f64,
    /// The faces before and after the border; none is the background; the same twice is a diagonal of a cut polygon.
    pub faces: [Option<u32>; 2],
}

/// The discontinuity of the intensity and its slope at a border.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Discontinuity {
    /// Jump of the intensity.
    pub step: f64,
    /// One-sided slopes before and after, per pixel.
    pub slopes: [f64; 2],
    /// Difference of the slopes.
    pub jump: f64,
}

/// Computes the profile of `scene`, which is drawn once for each mode.
///
/// The samples are at most a quarter of a pixel apart (a pixel, on lines beyond 4096) and include the place of every
/// pixel's centre that lies on the line: the longer of its sides runs over multiples of a quarter. The perceived
/// brightness also depends on the picture past the line's ends; there it is followed to its edge, beyond which its
/// last value continues.
///
/// # Errors
/// A line without length or with an end outside the picture, or no mode.
pub fn profile(
    renderer: &mut Renderer,
    scene: &Scene,
    request: &ProfileQuestion,
) -> Result<Profile, ProfileError> {
    let line = request.line(scene.image.size)?;
    let per_degree = request.viewing.pixels_per_degree();
    let widths = request.perception.widths(per_degree);
    let (mut traces, mut borders) = (Vec::new(), Vec::new());
    for &mode in &request.modes {
        let mut drawn = scene.clone();
        drawn.shading.mode = mode;
        let source = Source::new(renderer, &drawn, &line);
        let joints = source.joints();
        if borders.is_empty() {
            let border = |&(t, sides): &(f64, [Option<&Piece>; 2])| {
                let DVec2 { x, y } = line.place(t);
                Border {
                    x,
                    y,
                    t,
                    faces: sides.map(|piece| Some(piece?.face)),
                }
            };
            borders = joints.iter().map(border).collect();
        }
        let corner = |(t, sides)| {
            let [before, after] = source.sides(t, sides);
            Some(Discontinuity {
                step: after.0 - before.0,
                slopes: [before.1, after.1],
                jump: after.1 - before.1,
            })
        };
        let corners = joints.into_iter().map(corner).collect();
        let (intensity, slope): (Vec<f64>, Vec<f64>) = source.values().into_iter().unzip();
        let blur = |values: &[f64], sigma: f64| blur_line(values, sigma / line.spacing());
        let perceived = request.perception.respond(&intensity, per_degree, &blur);
        let ends = [0.0, 1.0].map(|t| source.value(t));
        traces.push(Trace {
            mode,
            intensity: line.within(&intensity, ends.map(|end| Some(end.0))),
            slope: line.within(&slope, ends.map(|end| Some(end.1))),
            perceived: line.within(&perceived, [None; 2]),
            corners,
        });
    }
    for trace in &mut traces {
        trace.corners.resize(borders.len(), None);
    }
    Ok(Profile {
        samples: line.samples(),
        traces,
        borders,
        length: request.from.distance(request.to),
        widths,
    })
}

/// A profile with its question.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TakenProfile {
    /// The profile.
    pub profile: Profile,
    /// The question that it answers.
    pub question: ProfileQuestion,
}

impl Question for ProfileQuestion {
    type Answer = TakenProfile;

    const CODEC: Option<Codec<TakenProfile>> = Some(Codec::plain());

    fn answer(
        &self,
        subject: &Subject,
        _: &dyn Watch<TakenProfile>,
    ) -> Result<TakenProfile, String> {
        let profile = profile(&mut subject.renderer(), &subject.scene, self)
            .map_err(|error| error.to_string())?;
        Ok(TakenProfile {
            profile,
            question: self.clone(),
        })
    }
}

impl TakenProfile {
    /// Returns the table of all samples: their places, and the values of each mode.
    fn samples(&self) -> Table {
        let Profile {
            samples, traces, ..
        } = &self.profile;
        let of_mode = |mode: &str| {
            [
                mode.to_owned(),
                format!("{mode}_slope"),
                format!("{mode}_perceived"),
            ]
        };
        let modes = traces.iter().flat_map(|trace| of_mode(trace.mode.word()));
        let places = ["x", "y", "t", "distance"].map(Column::key);
        let mut table = Table::new(places.into_iter().chain(modes.map(Column::key)));
        for (i, sample) in samples.iter().enumerate() {
            let mut row = cells![sample.x, sample.y, sample.t, sample.t * self.profile.length];
            for trace in traces {
                row.extend(cells![
                    trace.intensity[i],
                    trace.slope[i],
                    trace.perceived[i]
                ]);
            }
            table.rows.push(row);
        }
        table
    }
}

impl Answer for TakenProfile {
    fn report(&self, about: &ReportContext<'_>) -> Report {
        let mut report = Report::default();
        let (own, modes) = (about.scene.shading.mode, &self.question.modes);
        let first = modes.first().copied().unwrap_or(own);
        let view = Compared {
            own: if modes.contains(&own) { own } else { first },
            abscissa: Abscissa::Distance,
            edges: true,
            perceived: true,
        };
        for plot in compared_plots(&self.profile, &self.question, view) {
            report.section("").push(Part::Plot(plot.into()));
        }
        report.section("").note(text!("line-phong-bands"));
        report
    }

    fn table(&self) -> Option<Table> {
        Some(self.samples())
    }

    fn figure_size(&self, _: usize) -> [u32; 2] {
        [1600, 1200]
    }

    fn value(&self, _: &ReportContext<'_>) -> Value {
        let Self { profile, question } = self;
        let table = self.samples();
        let keys = || {
            table
                .columns
                .iter()
                .map(|column| column.key.as_deref().unwrap_or_default().to_owned())
        };
        let number = |cell: &Cell| match cell {
            Cell::Number(value) => json!(value),
            _ => Value::Null,
        };
        let samples = table
            .rows
            .iter()
            .map(|row| Value::Object(keys().zip(row.iter().map(number)).collect()));
        let borders = profile.borders.iter().enumerate().map(|(i, border)| {
            let mut row = json!(border);
            for trace in &profile.traces {
                row[trace.mode.word()] = json!(trace.corners[i]);
            }
            row
        });
        json!({
            "from": question.from.to_array(),
            "to": question.to.to_array(),
            "length": profile.length,
            "modes": question.modes,
            "viewing": question.viewing,
            "perception": question.perception,
            "widths": profile.widths,
            "borders": borders.collect::<Vec<_>>(),
            "samples": samples.collect::<Vec<_>>(),
        })
    }
}
