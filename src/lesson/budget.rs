//! The work that a lesson may cause, counted before it is done: a file from anybody ends soon, and at the same place on every machine.

use crate::geometry::{Mesh, triangles};
use crate::render::{FrameReport, Plan, Stage, TooLarge, check_memory_for, transmits};
use crate::scene::{AmbientSource, ObjectKind, Scene};
use crate::text::text;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

/// Work for a pixel besides its lights: it is covered, interpolated and displayed.
const PIXEL: u64 = 8;
/// Work for a triangle: it is made, placed and covered.
const TRIANGLE: u64 = 200;
/// Work for a ray that looks for a light, and for what is seen through the object or beside it.
const SHADOW: u64 = 16;
const THROUGH: u64 = 320;
const BESIDE: u64 = 200;
/// Work for the directions that one bounce looks into, and for meeting a true surface.
const BOUNCE: u64 = 500;
const SURFACE: u64 = 60;

/// The work that may still be done. Clones share it.
///
/// It is counted in evaluations of the equation for one light at one point; what takes as long as several counts as so many.
#[derive(Clone, Debug)]
pub struct Budget(Arc<AtomicU64>);

impl Budget {
    /// The most work for a step: filling in its numbers, finding its question's answer and drawing its pictures.
    pub const STEP: u64 = 20_000_000_000;
    /// The most work for the file of a lesson, and for grading the answers of a file that was handed in.
    pub const FILE: u64 = 2 * Self::STEP;

    /// The most triangles of a scene.
    pub const TRIANGLES: u64 = 1 << 22;

    /// Returns the work that a file may cause, none of it done yet.
    pub fn of_file() -> Self {
        Self(Arc::new(AtomicU64::new(Self::FILE)))
    }

    fn left(&self) -> u64 {
        self.0.load(Ordering::Relaxed)
    }

    /// Returns whether work was refused.
    pub(super) fn is_spent(&self) -> bool {
        self.left() == 0
    }

    /// Takes some away; where there was less, nothing is left.
    fn take(&self, work: u64) -> bool {
        let rest = |left: u64| Some(left.saturating_sub(work));
        let before = self
            .0
            .fetch_update(Ordering::Relaxed, Ordering::Relaxed, rest);
        before.is_ok_and(|before| before > work)
    }
}

/// The reason why a step is refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum TooHeavy {
    /// Its work is more than [`Budget::STEP`].
    #[error("{}", text!("lesson-step-too-heavy", most = Budget::STEP / 1_000_000))]
    Step,
    /// The work of the file up to this step is more than [`Budget::FILE`].
    #[error("{}", text!("lesson-file-too-heavy", most = Budget::FILE / 1_000_000))]
    File,
    /// A scene has more triangles than [`Budget::TRIANGLES`].
    #[error("{}", text!("lesson-many-triangles", most = Budget::TRIANGLES, triangles = .0))]
    Triangles(u64),
    /// The memory for a picture cannot be had.
    #[error(transparent)]
    Memory(#[from] TooLarge),
}

/// The work of one step, with what the whole file may still cause.
#[derive(Debug)]
pub(super) struct Account {
    file: Budget,
    spent: u64,
    refused: Option<TooHeavy>,
}

impl Account {
    pub fn new(file: Budget) -> Self {
        Self {
            file,
            spent: 0,
            refused: None,
        }
    }

    /// Counts work that is about to be done. After a refusal everything is refused.
    pub fn spend(&mut self, work: u64) -> Result<(), TooHeavy> {
        let spent = self.spent.saturating_add(work);
        let refusal = match self.refused {
            Some(refused) => Some(refused),
            None if spent > Budget::STEP => Some(TooHeavy::Step),
            None if !self.file.take(work) => Some(TooHeavy::File),
            None => None,
        };
        self.refused = refusal;
        self.spent = spent;
        refusal.map_or(Ok(()), Err)
    }

    /// Counts `times` pictures of a scene and refuses those whose memory cannot be had.
    pub fn spend_pictures(
        &mut self,
        scene: &Scene,
        model: Option<&Mesh>,
        times: u64,
    ) -> Result<(), TooHeavy> {
        self.spend(picture(scene, model, |_| true).saturating_mul(times))?;
        let triangles = triangles_of(scene, model);
        let fits = if triangles > Budget::TRIANGLES {
            Err(TooHeavy::Triangles(triangles))
        } else {
            check_memory_for(scene, model, 1).map_err(TooHeavy::Memory)
        };
        self.refused = fits.err();
        fits
    }

    /// Refuses a picture that would be too much. What is drawn of it anew is to be counted by [`Self::spend_drawn`].
    pub fn afford(&mut self, scene: &Scene, model: Option<&Mesh>) -> Result<(), TooHeavy> {
        let (spent, left) = (self.spent, self.file.left());
        self.spend_pictures(scene, model, 1)?;
        self.spent = spent;
        self.file.0.store(left, Ordering::Relaxed);
        Ok(())
    }

    /// Counts those stages of a picture that have run.
    pub fn spend_drawn(
        &mut self,
        scene: &Scene,
        model: Option<&Mesh>,
        report: &FrameReport,
    ) -> Result<(), TooHeavy> {
        let ran = |stage| {
            report
                .stages
                .iter()
                .any(|run| run.ran && run.stage == stage)
        };
        self.spend(picture(scene, model, ran))
    }

    pub fn spent(&self) -> u64 {
        self.spent
    }

    pub fn refused(&self) -> Option<TooHeavy> {
        self.refused
    }
}

/// Returns the work of those stages of a picture that run.
fn picture(scene: &Scene, model: Option<&Mesh>, runs: impl Fn(Stage) -> bool) -> u64 {
    let [width, height] = scene.image.size.map(u64::from);
    let points: u64 = scene
        .lights
        .iter()
        .map(|light| u64::from(light.sample_count()))
        .sum();
    let mut rays = 0;
    if scene.shading.shadows {
        rays += SHADOW * points;
    }
    if transmits(scene, model) {
        rays += THROUGH;
    } else if scene.ground.visible {
        rays += BESIDE;
    }
    if scene.ambient.source != AmbientSource::Constant {
        rays += BOUNCE;
    }
    let surface = if Plan::shows_surface(scene) {
        SURFACE
    } else {
        0
    };
    let only = |stage, work| if runs(stage) { work } else { 0 };
    let pixel = PIXEL + points + surface + only(Stage::Rays, rays);
    width * height * pixel + only(Stage::Geometry, triangles_of(scene, model) * TRIANGLE)
}

/// Triangles of what a scene shows.
pub(super) fn triangles_of(scene: &Scene, model: Option<&Mesh>) -> u64 {
    match model {
        Some(model) if scene.object.kind == ObjectKind::Obj => model.triangle_count() as u64,
        _ => triangles(&scene.object),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_step_and_a_file_end_at_their_bounds() {
        let file = Budget::of_file();
        let mut step = Account::new(file.clone());
        assert_eq!(step.spend(Budget::STEP), Ok(()));
        assert_eq!(step.spend(1), Err(TooHeavy::Step));
        assert_eq!(step.spend(0), Err(TooHeavy::Step), "nothing goes on");
        assert!(!file.is_spent());
        // What was refused was not done, and others may do it.
        let mut others = 0;
        while others < 100 && Account::new(file.clone()).spend(Budget::STEP / 2).is_ok() {
            others += 1;
        }
        assert_eq!(others, 1, "another takes the last of the file");
        assert!(file.is_spent());
        let mut last = Account::new(file);
        assert_eq!(last.spend(0), Err(TooHeavy::File));
        assert_eq!(last.refused(), Some(TooHeavy::File));
        assert_eq!(
            Account::new(Budget::of_file()).spend(u64::MAX),
            Err(TooHeavy::Step)
        );
    }

    #[test]
    fn a_picture_takes_more_with_all_that_makes_it_slower() {
        let plain = Scene::default();
        let work = |change: &dyn Fn(&mut Scene)| {
            let mut scene = plain.clone();
            change(&mut scene);
            picture(&scene, None, |_| true)
        };
        let changes: [&dyn Fn(&mut Scene); 6] = [
            &|scene| scene.image.size[0] *= 2,
            &|scene| scene.object.segments *= 2,
            &|scene| scene.lights.push(Default::default()),
            &|scene| scene.shading.shadows = true,
            &|scene| scene.transparency.kt = 0.5,
            &|scene| scene.ambient.source = AmbientSource::Bounce,
        ];
        for (index, change) in changes.into_iter().enumerate() {
            assert!(work(change) > work(&|_| ()), "{index}");
        }
    }
}
