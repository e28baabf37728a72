//! The pictures of a step, as large as a phone's share of the room's network allows.

use crate::document::picture_bytes;
use crate::lesson::{
    Budget, Element, FilledStep, Kind, Lab, LabPlace, LessonError, Solution, Staged, Step, digest,
    element, stage_picture,
};
use crate::link::base64;
use crate::render::Frame;

/// The most bytes of a step's pictures, all together.
const MOST_BYTES: usize = 40_000;
/// The shorter side of a picture that is drawn whatever bytes it takes, in pixels.
const LEAST_SIDE: u32 = 96;
/// Samples per pixel.
const SAMPLES: u32 = 4;

/// The pictures of a step with the lab that drew them.
pub struct Pictures {
    lab: Lab,
    staged: Staged,
    /// The picture of the step and, for a match, the target.
    frames: Vec<Frame>,
    bytes: Vec<Vec<u8>>,
}

impl Pictures {
    /// Draws the pictures of a step, smaller and smaller until they fit.
    pub fn fitting(step: &Step, staged: &Staged, filled: &FilledStep) -> Result<Self, LessonError> {
        let mut side = Lab::SIDE;
        loop {
            let drawn = Self::draw(step, at_side(staged, side), filled);
            let drawn = drawn.map_err(|words| LessonError::one(step.line, words))?;
            let bytes: usize = drawn.bytes.iter().map(Vec::len).sum();
            if bytes <= MOST_BYTES || side <= LEAST_SIDE {
                return Ok(drawn);
            }
            // Bytes grow with the area, of smooth pictures a little less.
            let share = (MOST_BYTES as f64 / bytes as f64).sqrt().min(0.95);
            side = ((f64::from(side) * share) as u32).max(LEAST_SIDE);
        }
    }

    fn draw(step: &Step, staged: Staged, filled: &FilledStep) -> Result<Self, String> {
        let lab = Lab::within(&staged, &Budget::of_file());
        let mut frames = vec![stage_picture(&lab, step, &staged, SAMPLES, filled.probed)?];
        if let Some(question) = &step.question
            && let (Kind::Match(asked), Some(Solution::Match(right))) =
                (&question.kind, &filled.right)
        {
            let place = lab.place(&staged).under(&question.set)?;
            frames.push(place.under(&asked.settings(right))?.counted_picture()?);
        }
        let bytes = frames.iter().map(|frame| picture_bytes(frame, None));
        let bytes = bytes.collect::<Result<_, _>>();
        Ok(Self {
            bytes: bytes.map_err(|error| error.to_string())?,
            lab,
            staged,
            frames,
        })
    }

    /// Returns the step's scene in the size of the pictures.
    pub fn place(&self) -> LabPlace<'_> {
        self.lab.place(&self.staged)
    }

    /// Returns the picture of the step.
    pub fn frame(&self) -> &Frame {
        &self.frames[0]
    }

    /// Returns the address of a picture of the step with this index, which changes with the picture.
    pub fn address(&self, index: usize, number: usize) -> String {
        let bytes = self.bytes.get(number).map_or(&[][..], |bytes| bytes);
        let version = digest([&base64(bytes)]);
        format!("steps/{}/{}.png?{version}", index + 1, number + 1)
    }

    /// Returns a picture as a figure; `words` describes it.
    pub fn figure(&self, index: usize, number: usize, words: &str) -> Element {
        let [width, height] = self
            .frames
            .get(number)
            .map_or([0; 2], |frame| [frame.width, frame.height]);
        let image = element("img")
            .attribute("src", self.address(index, number))
            .attribute("width", width)
            .attribute("height", height)
            .attribute("alt", words);
        element("figure").with(image)
    }

    /// Returns the files.
    pub fn into_bytes(self) -> Vec<Vec<u8>> {
        self.bytes
    }
}

/// Returns the scene of a step with another shorter side of its picture, in pixels, if that is smaller.
fn at_side(staged: &Staged, side: u32) -> Staged {
    let mut staged = staged.clone();
    let [width, height] = staged.scene.image.size;
    let shorter = width.min(height).max(1);
    if shorter > side {
        let scaled = |length: u32| {
            let scaled = u64::from(length) * u64::from(side) / u64::from(shorter);
            u32::try_from(scaled).unwrap_or(side).max(1)
        };
        staged.scene.image.size = [scaled(width), scaled(height)];
    }
    staged
}
