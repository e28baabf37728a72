//! Animations: a scene whose numbers change from one value to another, frame by frame, as an animated PNG or as a GIF.
//! A [`Sweep`] defines the scene of each frame; the caller draws the frames for [`write_film`] one by one.

mod palette;

use crate::picture::Apng;
use crate::render::Frame;
use crate::scene::parameter::{Kind, Parameter};
use crate::scene::{Scene, SceneError};
use crate::text::text;
use gif::Repeat;
use std::ffi::OsStr;
use std::io::{self, Write};
use std::iter;
use std::path::Path;
use toml::Value;

/// Maximum number of frames of a sweep from one end to the other.
pub const MOST_FRAMES: u32 = 10_000;
/// Default number of frames of a sweep.
pub const USUAL_FRAMES: u32 = 60;
/// Default frame rate, frames per second.
pub const USUAL_RATE: f64 = 30.0;
/// Longest duration of a frame, seconds: APNG has 16 bits for the milliseconds.
const LONGEST: f64 = 60.0;

/// Distribution of the frames between the two ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Course {
    /// Number of frames from one end to the other, both included.
    pub frames: u32,
    /// True for equal ratios from frame to frame, false for equal steps.
    pub logarithmic: bool,
    /// True to return to the beginning afterwards.
    pub back_and_forth: bool,
}

/// A scene with numbers that change from frame to frame.
///
/// ```
/// use shading_lab::animation::{Course, Sweep};
/// use shading_lab::scene::Scene;
///
/// let course = Course { frames: 3, logarithmic: false, back_and_forth: false };
/// let sweep = Sweep::new(&Scene::default(), &["material.n=5"], &["material.n=15"], course)?;
/// let exponents: Vec<f64> = sweep.scenes().map(|scene| scene.material.n).collect();
/// assert_eq!(exponents, [5.0, 10.0, 15.0]);
/// # Ok::<(), shading_lab::animation::SweepError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Sweep {
    scene: Scene,
    tracks: Vec<Track>,
    course: Course,
}

/// A key with its numbers at both ends.
#[derive(Clone, Debug)]
struct Track {
    key: String,
    whole: bool,
    ends: Vec<[f64; 2]>,
    /// True if it is written without the brackets of a list.
    single: bool,
}

/// The reason why a sweep cannot be drawn.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
#[expect(missing_docs, reason = "the variants tell what their fields are")]
pub enum SweepError {
    /// An error in the settings of the beginning.
    #[error("{0}")]
    Beginning(SceneError),
    /// An error in the settings of the end.
    #[error("{0}")]
    End(SceneError),
    /// A key that is set at one end only.
    #[error("{}", text!("animation-one-end", key = .0.as_str()))]
    OneEnd(String),
    /// A key that changes but is not a number.
    #[error("{}", text!("animation-no-number", key = .0.as_str()))]
    NoNumber(String),
    /// A key that is infinite at an end.
    #[error("{}", text!("animation-infinite", key = .0.as_str()))]
    Infinite(String),
    /// A key with more numbers at one end.
    #[error("{}", text!("animation-lengths", key = .0.as_str()))]
    Lengths(String),
    /// A key that cannot change in equal ratios.
    #[error("{}", text!("animation-sign", key = .0.as_str()))]
    Sign(String),
    /// No number changes.
    #[error("{}", text!("animation-nothing"))]
    Nothing,
    /// Fewer than two frames, or more than [`MOST_FRAMES`].
    #[error("{}", text!("animation-frames", most = MOST_FRAMES))]
    Frames,
    /// A frame between the ends, by its index from 0, is not a valid scene.
    #[error("{}", text!("animation-frame", frame = .frame, error = .error.to_string()))]
    Frame { frame: u32, error: SceneError },
    /// The duration of a frame would be too short or too long: those of the whole film are from `least` to `most`
    /// seconds.
    #[error("{}", text!("animation-seconds", least = format!("{least:.2}"), most = format!("{most:.0}")))]
    Seconds { least: f64, most: f64 },
}

impl Sweep {
    /// Creates a sweep from a scene with the settings `from` to the same scene with the settings `to`, each `KEY=VALUE`
    /// as in [`Scene::with_overrides`]. Every number that differs changes from frame to frame, also in colours and
    /// points.
    ///
    /// # Errors
    /// See [`SweepError`]; also if any frame is not a valid scene.
    pub fn new(
        scene: &Scene,
        from: &[impl AsRef<str>],
        to: &[impl AsRef<str>],
        course: Course,
    ) -> Result<Self, SweepError> {
        if !(2..=MOST_FRAMES).contains(&course.frames) {
            return Err(SweepError::Frames);
        }
        let (begins, ends) = (keys(from), keys(to));
        let one_sided = |a: &[&str], b: &[&str]| {
            a.iter()
                .find(|key| !b.contains(key))
                .map(|key| (*key).to_owned())
        };
        if let Some(key) = one_sided(&begins, &ends).or_else(|| one_sided(&ends, &begins)) {
            return Err(SweepError::OneEnd(key));
        }
        let first = scene.with_overrides(from).map_err(SweepError::Beginning)?;
        let last = scene.with_overrides(to).map_err(SweepError::End)?;
        let tracks = first
            .differences(&last)
            .map(|(parameter, index)| Track::new(parameter, index, [&first, &last], course))
            .collect::<Result<Vec<Track>, SweepError>>()?;
        if tracks.is_empty() {
            return Err(SweepError::Nothing);
        }
        let sweep = Self {
            scene: first,
            tracks,
            course,
        };
        for frame in 0..course.frames {
            sweep
                .scene_at(frame)
                .map_err(|error| SweepError::Frame { frame, error })?;
        }
        Ok(sweep)
    }

    /// Returns the scene at its beginning.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Returns the total number of frames shown.
    pub fn count(&self) -> u32 {
        let frames = self.course.frames;
        if self.course.back_and_forth {
            2 * frames - 2
        } else {
            frames
        }
    }

    /// Returns the scenes in the order in which they are shown.
    pub fn scenes(&self) -> impl Iterator<Item = Scene> {
        let forth = 0..self.course.frames;
        let back = (1..self.course.frames - 1).rev();
        let back = back.filter(|_| self.course.back_and_forth);
        // Every one of them was valid when the sweep was made.
        forth
            .chain(back)
            .filter_map(|frame| self.scene_at(frame).ok())
    }

    fn scene_at(&self, frame: u32) -> Result<Scene, SceneError> {
        let share = f64::from(frame) / f64::from(self.course.frames - 1);
        let settings: Vec<String> = self
            .tracks
            .iter()
            .map(|track| track.setting(share, self.course.logarithmic))
            .collect();
        self.scene.with_overrides(&settings)
    }
}

impl Track {
    fn new(
        parameter: &'static Parameter,
        index: usize,
        scenes: [&Scene; 2],
        course: Course,
    ) -> Result<Self, SweepError> {
        let key = parameter.key(index);
        if !is_number(parameter) {
            return Err(SweepError::NoNumber(key));
        }
        let [first, last] = scenes.map(|scene| parameter.value(scene, index));
        let (Some(mut first), Some(mut last)) = (numbers(first), numbers(last)) else {
            return Err(SweepError::NoNumber(key));
        };
        let length = first.len().max(last.len());
        for end in [&mut first, &mut last] {
            // One number represents all channels.
            if end.len() == 1 {
                end.resize(length, end[0]);
            }
        }
        if first.len() != last.len() {
            return Err(SweepError::Lengths(key));
        }
        let ends: Vec<[f64; 2]> = first.into_iter().zip(last).map(|(a, b)| [a, b]).collect();
        if !ends.as_flattened().iter().all(|value| value.is_finite()) {
            return Err(SweepError::Infinite(key));
        }
        if course.logarithmic && ends.iter().any(|[a, b]| a != b && a * b <= 0.0) {
            return Err(SweepError::Sign(key));
        }
        Ok(Self {
            key,
            whole: matches!(parameter.kind, Kind::Whole(..)),
            ends,
            single: length == 1,
        })
    }

    fn setting(&self, share: f64, logarithmic: bool) -> String {
        let number = |ends: &[f64; 2]| {
            let value = between(*ends, share, logarithmic);
            if self.whole {
                format!("{:.0}", value.round())
            } else {
                format!("{value:?}")
            }
        };
        let numbers: Vec<String> = self.ends.iter().map(number).collect();
        let numbers = numbers.join(",");
        if self.single {
            format!("{}={numbers}", self.key)
        } else {
            format!("{}=[{numbers}]", self.key)
        }
    }
}

/// Interpolates between two numbers; the ends are exact.
fn between([a, b]: [f64; 2], share: f64, logarithmic: bool) -> f64 {
    if share <= 0.0 || a == b {
        a
    } else if share >= 1.0 {
        b
    } else if logarithmic {
        a.signum() * ((1.0 - share) * a.abs().ln() + share * b.abs().ln()).exp()
    } else {
        (1.0 - share) * a + share * b
    }
}

fn keys(settings: &[impl AsRef<str>]) -> Vec<&str> {
    let texts = settings.iter().map(AsRef::as_ref);
    let key = |text: &'_ str| text.find('=').unwrap_or(text.len());
    texts.map(|text: &str| text[..key(text)].trim()).collect()
}

/// Returns whether a parameter is one or more numbers.
pub fn is_number(parameter: &Parameter) -> bool {
    matches!(
        parameter.kind,
        Kind::Number(..)
            | Kind::Whole(..)
            | Kind::Pair(..)
            | Kind::Coefficient(..)
            | Kind::Channels(..)
            | Kind::Colour(..)
            | Kind::Point(_)
            | Kind::Direction(..)
    )
}

fn numbers(value: Option<Value>) -> Option<Vec<f64>> {
    match value? {
        Value::Float(number) => Some(vec![number]),
        Value::Integer(number) => Some(vec![number as f64]),
        Value::Array(list) => {
            let all: Option<Vec<_>> = list.into_iter().map(|value| numbers(Some(value))).collect();
            Some(all?.concat())
        }
        _ => None,
    }
}

/// The file format of a film.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FilmFormat {
    /// An animated PNG with exact colours.
    Apng,
    /// A GIF with 256 colours, chosen for each frame.
    Gif,
}

impl FilmFormat {
    /// Returns the format of a name's ending.
    pub fn from_path(path: &Path) -> Option<Self> {
        match path.extension().map(OsStr::to_ascii_lowercase)?.to_str()? {
            "png" | "apng" => Some(Self::Apng),
            "gif" => Some(Self::Gif),
            _ => None,
        }
    }

    /// Returns the number of time units per second, and the shortest duration of a frame in seconds: browsers show
    /// shorter ones of a GIF far longer.
    fn timing(self) -> (f64, f64) {
        match self {
            Self::Apng => (1000.0, 0.001),
            Self::Gif => (100.0, 0.02),
        }
    }

    /// Checks the duration of a film of `count` frames; [`SweepError::Seconds`] where each would be too short or too
    /// long.
    pub fn check_seconds(self, count: u32, seconds: f64) -> Result<(), SweepError> {
        let [least, most] = [self.timing().1, LONGEST].map(|each| f64::from(count) * each);
        // A rounding error of the division is accepted.
        if seconds >= least * (1.0 - 1e-9) && seconds <= most {
            Ok(())
        } else {
            Err(SweepError::Seconds { least, most })
        }
    }
}

/// Writes `sweep` as a film of `seconds`, repeated forever; `draw` draws each of its scenes, or returns none to stop.
/// An animated PNG has the scene of its beginning inside.
///
/// # Errors
/// An error of `out`, or [`io::ErrorKind::Interrupted`] if drawing was stopped.
pub fn write_film(
    out: &mut dyn Write,
    format: FilmFormat,
    sweep: &Sweep,
    seconds: f64,
    draw: &mut dyn FnMut(&Scene) -> Option<Frame>,
) -> io::Result<()> {
    let count = sweep.count();
    // Rounded as a whole, so that the film has its full duration.
    let moment = |frame: u32| {
        (seconds * format.timing().0 * f64::from(frame) / f64::from(count)).round() as u32
    };
    let mut drawn = sweep.scenes().zip(0..).map(|(scene, number)| {
        let stopped = || io::Error::from(io::ErrorKind::Interrupted);
        let delay = u16::try_from(moment(number + 1) - moment(number)).unwrap_or(u16::MAX);
        Ok((draw(&scene).ok_or_else(stopped)?, delay))
    });
    match format {
        FilmFormat::Apng => write_apng(out, sweep, &mut drawn),
        FilmFormat::Gif => write_gif(out, &mut drawn),
    }
}

/// Frames, each with its duration.
type Frames<'f> = &'f mut dyn Iterator<Item = io::Result<(Frame, u16)>>;

fn write_apng(out: &mut dyn Write, sweep: &Sweep, frames: Frames<'_>) -> io::Result<()> {
    let Some(first) = frames.next().transpose()? else {
        return Ok(());
    };
    let size = [first.0.width, first.0.height];
    let mut film = Apng::new(out, size, sweep.count(), sweep.scene())?;
    for frame in iter::once(Ok(first)).chain(frames) {
        let (frame, delay) = frame?;
        film.add(&frame, delay)?;
    }
    Ok(film.finish()?)
}

fn write_gif(out: &mut dyn Write, frames: Frames<'_>) -> io::Result<()> {
    let refused = |error| match error {
        gif::EncodingError::Io(error) => error,
        error => io::Error::other(error),
    };
    let Some(first) = frames.next().transpose()? else {
        return Ok(());
    };
    let side = |pixels: u32| u16::try_from(pixels).map_err(io::Error::other);
    let (width, height) = (side(first.0.width)?, side(first.0.height)?);
    let mut film = gif::Encoder::new(out, width, height, &[]).map_err(refused)?;
    film.set_repeat(Repeat::Infinite).map_err(refused)?;
    for frame in iter::once(Ok(first)).chain(frames) {
        let (frame, delay) = frame?;
        let (palette, numbers) = palette::indexed(&frame.pixels);
        let shown = gif::Frame::from_palette_pixels(width, height, numbers, palette, None);
        film.write_frame(&gif::Frame { delay, ..shown })
            .map_err(refused)?;
    }
    film.into_inner()
        .map_err(|error| io::Error::other(error.to_string()))?;
    Ok(())
}
