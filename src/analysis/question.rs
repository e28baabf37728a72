//! How an analysis is asked, and the list of all analyses.

use super::codec::Codec;
use super::report::Answer;
use crate::geometry::Mesh;
use crate::render::Renderer;
use crate::scene::{Scene, choices};
use Format::{Csv, Json, Png, Svg};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::fmt::Debug;
use std::sync::Arc;

/// What is asked of a scene: plain data, so that it can be kept, compared and sent elsewhere.
///
/// ```
/// use shading_lab::analysis::{About, Answer, Question, Subject, unwatched};
/// use shading_lab::analysis::normals::NormalsQuestion;
/// use shading_lab::scene::{Scene, presets};
///
/// let scene = presets::find("vertex-normals").expect("a built-in scene").scene();
/// let question = NormalsQuestion { vertex: Some(0), pixel: None };
/// let subject = Subject::new(scene);
/// let answer = question.answer(&subject, &unwatched)?;
///
/// let about = About { name: "vertex-normals", scene: &subject.scene };
/// println!("{}", answer.text(&about)); // as the command `normals` prints it
/// assert_eq!(answer.object(&about)["vertex"]["vertex"], 0); // as with `--json`
/// # Ok::<(), String>(())
/// ```
pub trait Question:
    Clone + Debug + PartialEq + Serialize + DeserializeOwned + Send + Sync + 'static
{
    /// What it is answered by.
    type Answer: Answer + Clone + 'static;

    /// How the answer comes back from a worker of a web page; without it the page finds it itself.
    const CODEC: Option<Codec<Self::Answer>> = None;

    /// Finds the answer.
    ///
    /// # Errors
    /// Why there is none, in a sentence that says what was expected.
    fn answer(
        &self,
        subject: &Subject,
        watch: &dyn Watch<Self::Answer>,
    ) -> Result<Self::Answer, String>;
}

/// What a question is about.
#[derive(Clone, Debug)]
pub struct Subject {
    /// The scene.
    pub scene: Scene,
    /// The mesh of an object of kind `obj`.
    pub model: Option<Arc<Mesh>>,
    /// Nanoseconds from any fixed moment.
    pub clock: fn() -> u64,
}

impl Subject {
    /// A scene without a model and without a clock: what measures times finds 0.
    pub fn new(scene: Scene) -> Self {
        Self {
            scene,
            model: None,
            clock: || 0,
        }
    }

    /// A renderer that has the model and the clock.
    pub fn renderer(&self) -> Renderer {
        Renderer::with_clock(self.clock).with_model(self.model.clone())
    }
}

/// Whoever waits for an answer. A closure from the share of the work that is done, from 0 to 1, to whether to go on is one.
pub trait Watch<A>: Sync {
    /// Takes how far the work is; returns whether to go on.
    fn at(&self, share: f32) -> bool;

    /// Takes what is known so far.
    fn found(&self, _so_far: &A) {}
}

impl<A, F: Fn(f32) -> bool + Sync> Watch<A> for F {
    fn at(&self, share: f32) -> bool {
        self(share)
    }
}

/// Lets the work go on to its end.
pub fn unwatched(_share: f32) -> bool {
    true
}

choices! {
    /// A way to write an answer; its word is what names of such files end in.
    pub enum Format = "format" {
        /// The figure as pixels.
        Png = "png";
        /// The figure as a vector drawing.
        Svg = "svg";
        /// The table.
        Csv = "csv";
        /// One JSON object.
        Json = "json";
    }
}

/// An analysis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Analysis {
    /// The command.
    pub name: &'static str,
    /// What its answer can be written as.
    pub formats: &'static [Format],
}

impl Analysis {
    /// The analysis of that name.
    pub fn find(name: &str) -> Option<&'static Self> {
        ANALYSES.iter().find(|analysis| analysis.name == name)
    }
}

const fn analysis(name: &'static str, formats: &'static [Format]) -> Analysis {
    Analysis { name, formats }
}

/// All analyses. A new one is a line here, a module with its question and its answer, and its arguments in `cli`.
pub const ANALYSES: [Analysis; 12] = [
    analysis("probe", &[Csv, Json]),
    analysis("curves", &[Png, Svg, Csv, Json]),
    analysis("profile", &[Png, Svg, Csv, Json]),
    analysis("scanline", &[Png, Svg, Csv, Json]),
    analysis("normals", &[Csv, Json]),
    analysis("compare", &[Csv, Json]),
    analysis("defects", &[Png, Svg, Csv, Json]),
    analysis("conditions", &[Csv, Json]),
    analysis("explain", &[Csv, Json]),
    analysis("study", &[Png, Svg, Csv, Json]),
    analysis("stability", &[Png, Csv, Json]),
    analysis("bench", &[Csv, Json]),
];
