//! Takes profiles beside the window: the interface never waits for one.

use super::super::document::{Document, same_model};
use super::super::errand::Errand;
use super::super::state::AppState;
use crate::analysis::{Plot, Profile, ProfileRequest, profile, profile_plots};
use crate::document::{WriteError, save_picture, write_whole};
use crate::figure::{Drawing, Paper, PlotStyle, lay_out_sheet};
use crate::geometry::Mesh;
use crate::render::Renderer;
use crate::scene::Scene;
use eframe::egui::Context;
use glam::DVec2;
use std::path::Path;
use std::sync::Arc;

/// Pixels of an exported sheet of plots.
const SHEET: [u32; 2] = [1600, 1200];

/// The profile last taken, its plots, and the one that is being taken.
#[derive(Debug, Default)]
pub struct Profiles {
    known: Option<(Question, Answer)>,
    work: Option<Errand<Question, Answer>>,
    plots: Vec<Plot>,
    drawings: Vec<Drawing>,
    /// The style and the width of what is laid out.
    style: Option<(PlotStyle, f32)>,
}

type Answer = Result<Profile, String>;

#[derive(Clone, Debug)]
struct Question {
    scene: Scene,
    model: Option<Arc<Mesh>>,
    size: [u32; 2],
    request: ProfileRequest,
}

impl Question {
    fn is(&self, document: &Document, size: [u32; 2], request: &ProfileRequest) -> bool {
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

    fn answer(&self) -> Answer {
        let mut renderer = Renderer::default();
        renderer.set_model(self.model.clone());
        profile(&mut renderer, &self.sized(), &self.request).map_err(|error| error.to_string())
    }
}

impl Profiles {
    /// Sees to it that the profile asked for is taken, one at a time; until then the last one is shown.
    pub fn ask(&mut self, ctx: &Context, document: &Document, size: [u32; 2], request: ProfileRequest) {
        self.take();
        let known = self.known.as_ref().is_some_and(|(known, _)| known.is(document, size, &request));
        if known || self.work.is_some() {
            return;
        }
        let (scene, model) = (document.scene.clone(), document.model.clone());
        let question = Question { scene, model, size, request };
        self.work = Some(Errand::new(ctx, question.clone(), move || question.answer()));
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
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase()).unwrap_or_default();
        let text = |text: String| {
            write_whole(path, |out| out.write_all(text.as_bytes()).map_err(WriteError::Io)).map_err(|e| e.to_string())
        };
        let style = PlotStyle::of(SHEET, self.plots.len(), Paper::LIGHT);
        let sheet = || lay_out_sheet(&self.plots, DVec2::from_array(SHEET.map(f64::from)), &style);
        match ending.as_str() {
            "csv" => text(taken.to_csv()),
            "svg" => text(sheet().to_svg("Intensity along a line")),
            "png" => {
                let frame = sheet().to_frame().ok_or("the figure is too large")?;
                save_picture(path, &frame, &question.sized()).map_err(|error| error.to_string())
            }
            _ => Err("expected a name that ends in .csv, .png or .svg".to_owned()),
        }
    }
}

/// Writes the profile or its plots, as the path's ending says.
pub fn save(state: &mut AppState, path: &Path) -> Result<(), String> {
    state.profiles.save(path)?;
    state.notice = Some(format!("saved {}", path.display()));
    Ok(())
}
