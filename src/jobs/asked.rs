//! The question of an analysis about a scene, as work.

use super::{Work, nanoseconds};
use crate::analysis::{Question, Subject, Watch};
use crate::geometry::Mesh;
use crate::scene::Scene;
use std::sync::Arc;

/// A question about a scene in a picture of some size.
#[derive(Clone, Debug)]
pub struct Asked<Q> {
    pub question: Q,
    pub scene: Scene,
    pub model: Option<Arc<Mesh>>,
    size: [u32; 2],
}

impl<Q: PartialEq> Asked<Q> {
    pub fn new(question: Q, scene: &Scene, model: Option<&Arc<Mesh>>, size: [u32; 2]) -> Self {
        Self { question, scene: scene.clone(), model: model.cloned(), size }
    }

    /// Whether this is what [`Self::new`] would make.
    pub fn is(&self, question: &Q, scene: &Scene, model: Option<&Arc<Mesh>>, size: [u32; 2]) -> bool {
        self.question == *question
            && self.size == size
            && self.model.as_ref().map(Arc::as_ptr) == model.map(Arc::as_ptr)
            && self.scene == *scene
    }

    /// The scene, its picture of the size asked for, with the model.
    pub fn subject(&self) -> Subject {
        let mut scene = self.scene.clone();
        scene.image.size = self.size;
        Subject { scene, model: self.model.clone(), clock: nanoseconds }
    }
}

impl<Q: Question> Work for Asked<Q> {
    type Answer = Q::Answer;

    fn run(&self, watch: &dyn Watch<Q::Answer>) -> Result<Q::Answer, String> {
        self.question.answer(&self.subject(), watch)
    }
}
