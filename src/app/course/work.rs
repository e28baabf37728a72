//! The results that a step needs from the engine, found in the background: its numbers, and the answer to its
//! question.

use crate::analysis::Watch;
use crate::analysis::codec::Codec;
use crate::jobs::Work;
use crate::lesson::{AnswerKey, Lab, Lesson, Prose, Solution};
use crate::text::text;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

/// The task of preparing a step of a lesson.
#[derive(Serialize, Deserialize)]
pub struct Prepare {
    /// The number of the lesson's opening.
    pub opening: u64,
    pub step: usize,
    pub seed: u64,
    /// The text of the lesson's file, which the worker reads again, since only text is sent to it.
    pub source: String,
    pub folder: Option<PathBuf>,
}

/// The texts of a step with their numbers filled in, and the answer once it is known.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Prepared {
    pub text: String,
    pub ask: String,
    pub why: String,
    /// The text that follows the answered question.
    pub after: String,
    /// The texts of options and items, or of the axes of a curve.
    pub names: Vec<String>,
    /// The explanation of each wrong model, or of each option of a choice.
    pub says: Vec<String>,
    /// The right answer and those of the wrong models.
    pub key: Option<Result<AnswerKey, String>>,
    /// True if the step's numbers or its answer are taken at the probe.
    pub at_probe: bool,
}

impl Prepared {
    /// Returns the right answer, once it is known.
    pub fn right(&self) -> Option<&Solution> {
        self.key().map(|key| &key.right)
    }

    /// Returns the answer of a wrong model.
    pub fn wrong(&self, model: Option<usize>) -> Option<&Solution> {
        self.key()?.wrong.get(model?)
    }

    /// Returns the right answer and those of the wrong models, once they are known.
    pub fn key(&self) -> Option<&AnswerKey> {
        self.key.as_ref()?.as_ref().ok()
    }
}

impl Work for Prepare {
    type Answer = Prepared;

    const CODECS: Option<(Codec<Self>, Codec<Prepared>)> = Some((Codec::plain(), Codec::plain()));

    fn run(&self, watch: &dyn Watch<Prepared>) -> Result<Prepared, String> {
        let folder = self.folder.as_deref();
        let lesson = Lesson::read(&self.source, folder).map_err(|error| error.to_string())?;
        let missing = || text!("course-no-step").to_owned();
        let step = lesson.steps.get(self.step).ok_or_else(missing)?;
        let staged = step.stage.load(folder).map_err(|error| error.to_string())?;
        let lab = Lab::new(&staged);
        let place = lab.place(&staged);
        let fill = |prose: &Prose| {
            let filled = prose.filled(&place);
            filled.map_err(|problem| format!("{}: {}", problem.line, problem.words))
        };
        let mut prepared = Prepared {
            text: fill(&step.text)?,
            ask: String::new(),
            why: String::new(),
            after: String::new(),
            names: Vec::new(),
            says: Vec::new(),
            key: None,
            at_probe: lab.probe_measured(),
        };
        let Some(question) = &step.question else {
            return Ok(prepared);
        };
        prepared.ask = fill(&question.ask)?;
        prepared.why = fill(&question.why)?;
        prepared.after = fill(&step.after)?;
        let names = question.names().into_iter();
        prepared.names = names.map(fill).collect::<Result<_, _>>()?;
        let says = question.says().into_iter();
        prepared.says = says.map(fill).collect::<Result<_, _>>()?;
        prepared.at_probe = lab.probe_measured();
        // The student can read the text while the answer is computed.
        watch.found(&prepared);
        prepared.key = Some(question.solve_all(place, self.seed));
        prepared.at_probe = lab.probe_measured();
        Ok(prepared)
    }
}
