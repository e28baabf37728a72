//! Takes profiles beside the window: the interface never waits for one.

use super::super::document::{Document, same_model};
use super::super::engine::image_of;
use super::super::errand::Errand;
use super::super::state::AppState;
use crate::analysis::{
    About, Format, PERCEIVED_WIDTH, Plot, Profile, ProfileQuestion, TakenProfile, perceived_picture, profile,
    profile_plots,
};
use crate::document::save_answer;
use crate::figure::{Drawing, Paper, PlotStyle};
use crate::geometry::Mesh;
use crate::render::{Frame, Renderer};
use crate::scene::Scene;
use eframe::egui::{Context, TextureHandle, TextureOptions};
use std::fmt::{self, Debug, Formatter};
use std::path::Path;
use std::sync::Arc;

/// The profile last taken, its plots, and the one that is being taken.
#[derive(Debug, Default)]
pub struct Profiles {
    known: Option<(Question, Answer)>,
    work: Option<Errand<Question, Answer>>,
    plots: Vec<Plot>,
    drawings: Vec<Drawing>,
    /// The style and the width of what is laid out.
    style: Option<(PlotStyle, f32)>,
    seen: Seen,
}

/// The picture as it is perceived, as last worked out.
#[derive(Default)]
struct Seen {
    known: Option<Question>,
    work: Option<Errand<Question, Result<Frame, String>>>,
    texture: Option<TextureHandle>,
    /// Why there is none.
    problem: Option<String>,
}

impl Debug for Seen {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.debug_struct("Seen").field("known", &self.known).field("problem", &self.problem).finish_non_exhaustive()
    }
}

type Answer = Result<Profile, String>;

#[derive(Clone, Debug)]
struct Question {
    scene: Scene,
    model: Option<Arc<Mesh>>,
    size: [u32; 2],
    request: ProfileQuestion,
}

impl Question {
    fn is(&self, document: &Document, size: [u32; 2], request: &ProfileQuestion) -> bool {
        same_model(self.model.as_ref(), document.model.as_ref())
            && self.size == size
            && self.request == *request
            && self.scene == document.scene
    }

    fn sized(&self) -> Scene {
        let mut scene = self.scene.clone();
        scene.image.size = self.size;
        scene
    }

    fn perceived(&self) -> Result<Frame, String> {
        let ProfileQuestion { viewing, perception, .. } = &self.request;
        let [_, widest] = perception.widths(viewing.pixels_per_degree());
        if widest > PERCEIVED_WIDTH {
            return Err(format!("σs is {widest:.0} pixels, expected at most {PERCEIVED_WIDTH} for a whole picture"));
        }
        let mut renderer = Renderer::default();
        renderer.set_model(self.model.clone());
        Ok(perceived_picture(&mut renderer, &self.sized(), viewing, perception))
    }

    fn answer(&self) -> Answer {
        let mut renderer = Renderer::default();
        renderer.set_model(self.model.clone());
        profile(&mut renderer, &self.sized(), &self.request).map_err(|error| error.to_string())
    }
}

impl Profiles {
    /// Sees to it that the profile asked for is taken, one at a time; until then the last one is shown.
    pub fn ask(&mut self, ctx: &Context, document: &Document, size: [u32; 2], request: ProfileQuestion) {
        self.take();
        let known = self.known.as_ref().is_some_and(|(known, _)| known.is(document, size, &request));
        if known || self.work.is_some() {
            return;
        }
        let (scene, model) = (document.scene.clone(), document.model.clone());
        let question = Question { scene, model, size, request };
        self.work = Some(Errand::new(ctx, question.clone(), move || question.answer()));
    }

    /// Sees to it that the picture is worked out as it is perceived; until then the last one is shown.
    pub fn ask_perceived(&mut self, ctx: &Context, document: &Document, size: [u32; 2], request: &ProfileQuestion) {
        let seen = &mut self.seen;
        if let Some((question, answer)) = Errand::take(&mut seen.work) {
            seen.known = Some(question);
            let answer = answer.unwrap_or_else(|| Err("it ended without a result".to_owned()));
            seen.problem = answer.as_ref().err().cloned();
            match (answer, &mut seen.texture) {
                (Ok(frame), Some(texture)) => texture.set(image_of(&frame), TextureOptions::NEAREST),
                (Ok(frame), texture) => {
                    *texture = Some(ctx.load_texture("perceived", image_of(&frame), TextureOptions::NEAREST));
                }
                (Err(_), texture) => *texture = None,
            }
            ctx.request_repaint();
        }
        // The line does not matter to the whole picture.
        let same = |known: &Question| {
            let request = ProfileQuestion { from: known.request.from, to: known.request.to, ..request.clone() };
            known.is(document, size, &ProfileQuestion { modes: known.request.modes.clone(), ..request })
        };
        if seen.work.is_some() || seen.known.as_ref().is_some_and(same) {
            return;
        }
        let (scene, model) = (document.scene.clone(), document.model.clone());
        let question = Question { scene, model, size, request: request.clone() };
        seen.work = Some(Errand::new(ctx, question.clone(), move || question.perceived()));
    }

    /// The picture as it is perceived.
    pub fn perceived(&self) -> Option<&TextureHandle> {
        self.seen.texture.as_ref()
    }

    /// Why there is no such picture.
    pub fn not_perceived(&self) -> Option<&str> {
        self.seen.problem.as_deref()
    }

    /// Takes what the thread has brought.
    fn take(&mut self) {
        let Some((question, answer)) = Errand::take(&mut self.work) else { return };
        let answer = answer.unwrap_or_else(|| Err("taking it ended without a result".to_owned()));
        self.plots = answer.as_ref().map(|taken| profile_plots(taken, &question.request)).unwrap_or_default();
        self.style = None;
        self.known = Some((question, answer));
    }

    /// The profile last taken.
    pub fn profile(&self) -> Option<&Profile> {
        self.known.as_ref().and_then(|(_, answer)| answer.as_ref().ok())
    }

    /// Why there is none.
    pub fn missing(&self) -> Option<String> {
        match &self.known {
            None => Some("…".to_owned()),
            Some((_, Err(error))) => Some(error.to_string()),
            Some((_, Ok(_))) => None,
        }
    }

    /// Lays the plots out anew where they, the style or the width have changed.
    pub fn lay_out(&mut self, style: (PlotStyle, f32), of: impl Fn(&Plot) -> Drawing) {
        if self.style != Some(style) {
            self.style = Some(style);
            self.drawings = self.plots.iter().map(of).collect();
        }
    }

    /// The plots as laid out.
    pub fn laid_out(&self) -> impl Iterator<Item = (&Plot, &Drawing)> {
        self.plots.iter().zip(&self.drawings)
    }

    fn save(&self, path: &Path) -> Result<(), String> {
        let Some((question, Ok(taken))) = &self.known else { return Err("there is no profile".to_owned()) };
        let format = Format::from_path(path).ok_or("expected a name that ends in .csv, .png or .svg")?;
        let answer = TakenProfile { profile: taken.clone(), question: question.request.clone() };
        let about = About { name: "", scene: &question.sized() };
        save_answer(path, format, &answer, &about, (None, Paper::LIGHT)).map_err(|error| error.to_string())
    }
}

/// Writes the profile or its plots, as the path's ending says.
pub fn save(state: &mut AppState, path: &Path) -> Result<(), String> {
    let profiles = state.own.get::<Profiles>().ok_or("there is no profile")?;
    profiles.save(path)?;
    state.notice = Some(format!("saved {}", path.display()));
    Ok(())
}
