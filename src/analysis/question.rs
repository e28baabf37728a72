//! The interface of questions and answers, and the list of all analyses.

use super::codec::Codec;
use super::report::Answer;
use crate::geometry::{Mesh, NO_MATERIAL, built_in};
use crate::render::Renderer;
use crate::scene::{MaterialSource, ObjectKind, Scene, choices};
use Format::{Csv, Json, Png, Svg};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::fmt::Debug;
use std::sync::Arc;

/// A question about a scene: plain data, so that it can be stored, compared and sent elsewhere.
///
/// ```
/// use shading_lab::analysis::{Answer, Question, ReportContext, Subject, unwatched};
/// use shading_lab::analysis::normals::NormalsQuestion;
/// use shading_lab::scene::{Scene, presets};
///
/// let scene = presets::find("vertex-normals").expect("a built-in scene").scene();
/// let question = NormalsQuestion { vertex: Some(0), pixel: None };
/// let subject = Subject::new(scene);
/// let answer = question.answer(&subject, &unwatched)?;
///
/// let about = ReportContext { name: "vertex-normals", scene: &subject.scene };
/// println!("{}", answer.text(&about)); // as the command `normals` prints it
/// assert_eq!(answer.object(&about)["vertex"]["vertex"], 0); // as with `--json`
/// # Ok::<(), String>(())
/// ```
pub trait Question:
    Clone + Debug + PartialEq + Serialize + DeserializeOwned + Send + Sync + 'static
{
    /// The type of the answer.
    type Answer: Answer + Clone + 'static;

    /// Encoding of the answer for its way back from a worker; without one, a web page computes the answer itself.
    const CODEC: Option<Codec<Self::Answer>> = None;

    /// Computes the answer; the error is a sentence with the reason why there is none and what was expected.
    fn answer(
        &self,
        subject: &Subject,
        watch: &dyn Watch<Self::Answer>,
    ) -> Result<Self::Answer, String>;
}

/// The subject of a question.
#[derive(Clone, Debug)]
pub struct Subject {
    /// The scene.
    pub scene: Scene,
    /// The mesh of an object of kind `obj`.
    pub model: Option<Arc<Mesh>>,
    /// Clock in nanoseconds since any fixed moment.
    pub clock: fn() -> u64,
}

impl Subject {
    /// Creates a subject without a model and without a clock: time measurements find 0.
    pub fn new(scene: Scene) -> Self {
        Self {
            scene,
            model: None,
            clock: || 0,
        }
    }

    /// Returns whether faces of its model have materials of the model.
    pub fn has_own_materials(&self) -> bool {
        let Scene {
            object, material, ..
        } = &self.scene;
        let model = if object.kind == ObjectKind::Obj {
            self.model.as_deref()
        } else {
            built_in(object.kind).map(|mesh| &**mesh)
        };
        let model = model.filter(|_| material.source == MaterialSource::Model);
        model.is_some_and(|mesh| mesh.face_materials.iter().any(|own| *own != NO_MATERIAL))
    }

    /// Returns a renderer that has the model and the clock.
    pub fn renderer(&self) -> Renderer {
        Renderer::with_clock(self.clock).with_model(self.model.clone())
    }
}

/// The caller waiting for an answer; also a closure that takes the share of the work done and returns whether to
/// continue.
pub trait Watch<A>: Sync {
    /// Takes the share of the work done; returns whether to continue.
    fn progress(&self, share: f32) -> bool;

    /// Takes the part of the answer that is known so far.
    fn found(&self, _so_far: &A) {}
}

impl<A, F: Fn(f32) -> bool + Sync> Watch<A> for F {
    fn progress(&self, share: f32) -> bool {
        self(share)
    }
}

/// Lets the work continue to its end.
pub fn unwatched(_share: f32) -> bool {
    true
}

choices! {
    /// Output format of an answer; its word is the file name extension.
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
    /// Name of the command.
    pub name: &'static str,
    /// Formats in which its answer can be written.
    pub formats: &'static [Format],
}

impl Analysis {
    /// Returns the analysis of that name.
    pub fn find(name: &str) -> Option<&'static Self> {
        ANALYSES.iter().find(|analysis| analysis.name == name)
    }
}

const fn analysis(name: &'static str, formats: &'static [Format]) -> Analysis {
    Analysis { name, formats }
}

/// All analyses. A new one is a line here, a module with its question and its answer, and its arguments in `cli`.
pub const ANALYSES: [Analysis; 12] = [
    analysis("probe", &[Png, Svg, Csv, Json]),
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
