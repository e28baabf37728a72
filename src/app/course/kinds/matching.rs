//! A picture to be matched: the target beside the student's own, and the distance between them.

use super::widget::{Widget, WidgetContext, set_ui};
use crate::analysis::Watch;
use crate::analysis::codec::Codec;
use crate::app::course::parts::waiting_ui;
use crate::app::engine::image_of;
use crate::app::session::Session;
use crate::app::widgets::background::{PICTURES, wake};
use crate::app::widgets::focus::named;
use crate::app::widgets::meter::meter_ui;
use crate::app::widgets::palette::vector_text;
use crate::app::widgets::tile::picture_ui;
use crate::figure::palette::Vector;
use crate::figure::short;
use crate::geometry::Mesh;
use crate::jobs::{Background, Work, model_from_bytes, model_to_bytes};
use crate::lesson::{
    Answer, Kind, Match, Question, Solution, control_name, picture_distance, value_of,
};
use crate::render::Renderer;
use crate::scene::Scene;
use crate::text::text;
use eframe::egui::accesskit::Role;
use eframe::egui::{ColorImage, Context, Grid, RichText, TextureHandle, TextureOptions, Ui, vec2};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// The longer side of the target's picture and of the compared pictures, in pixels.
const SIDE: u32 = 360;
/// The maximum height of the target on the screen, in points, so that it fits in with the controls and the
/// meter.
const HIGHEST: f32 = 190.0;
/// The height of the meter, in points.
const METER: f32 = 10.0;

/// The target's picture.
#[derive(Serialize, Deserialize)]
pub struct Target {
    scene: Scene,
    #[serde(
        serialize_with = "model_to_bytes",
        deserialize_with = "model_from_bytes"
    )]
    model: Option<Arc<Mesh>>,
}

impl Work for Target {
    type Answer = Vec<ColorImage>;

    const CODECS: Option<(Codec<Self>, Codec<Self::Answer>)> = Some((Codec::plain(), PICTURES));

    fn run(&self, _: &dyn Watch<Self::Answer>) -> Result<Self::Answer, String> {
        let mut renderer = Renderer::default().with_model(self.model.clone());
        let frame = renderer.render_supersampled(&self.scene, 4, &mut |_| true);
        Ok(vec![image_of(&frame)])
    }
}

/// A measurement of the distance of two scenes: the root mean square of the difference of their pictures.
#[derive(Serialize, Deserialize)]
pub struct Likeness {
    scenes: [Scene; 2],
    #[serde(
        serialize_with = "model_to_bytes",
        deserialize_with = "model_from_bytes"
    )]
    model: Option<Arc<Mesh>>,
}

impl Work for Likeness {
    type Answer = f64;

    const CODECS: Option<(Codec<Self>, Codec<f64>)> = Some((Codec::plain(), Codec::plain()));

    fn run(&self, _: &dyn Watch<f64>) -> Result<f64, String> {
        let mut renderer = Renderer::default().with_model(self.model.clone());
        let [a, b] = [0, 1].map(|index| renderer.linear_picture(&self.scenes[index]));
        Ok(picture_distance(self.scenes[0].image.size[0], &a, &b))
    }
}

/// The state of a match.
#[derive(Default)]
struct Matching {
    of: Option<(u64, usize)>,
    target: Background<Target>,
    picture: Option<TextureHandle>,
    likeness: Background<Likeness>,
    /// The distances at first, before the last change, and now.
    distances: [Option<f64>; 3],
    changes: u32,
    began: f64,
}

impl Matching {
    /// Starts to draw the target's picture.
    fn draw_target(&mut self, ctx: &Context, target: &Scene, model: Option<&Arc<Mesh>>) {
        let work = || Target {
            scene: target.clone(),
            model: model.cloned(),
        };
        self.target
            .ask(wake(ctx), |known| known.scene == *target, work);
        if let (None, Some([image, ..])) = (&self.picture, self.target.answer().map(Vec::as_slice))
        {
            let texture = ctx.load_texture("target", image.clone(), TextureOptions::LINEAR);
            self.picture = Some(texture);
        }
    }

    /// Starts to measure the distance of two scenes.
    fn measure(&mut self, ctx: &Context, scenes: [Scene; 2], model: Option<&Arc<Mesh>>) {
        let work = || Likeness {
            scenes: scenes.clone(),
            model: model.cloned(),
        };
        let new = self
            .likeness
            .ask(wake(ctx), |known| known.scenes == scenes, work);
        if new && let Some(distance) = self.likeness.answer() {
            let [first, _, last] = self.distances;
            if last != Some(*distance) {
                self.distances = [first.or(Some(*distance)), last, Some(*distance)];
                self.changes += u32::from(last.is_some());
            }
        }
    }
}

/// The target beside the student's own picture. Its state outlives the step.
pub struct MatchWidget;

impl Widget for MatchWidget {
    /// Shows the target, the distance, and a meter that says whether the last change reduced it.
    fn ui(&mut self, ui: &mut Ui, asked: &mut WidgetContext<'_>) -> bool {
        if let Kind::Match(kind) = &asked.question.kind {
            match_ui(ui, asked, kind);
        }
        false
    }

    fn answer(&self, question: &Question, scene: &Scene) -> Option<Answer> {
        let controls = question.kind.asks().controls().iter();
        let values = controls.map(|key| value_of(scene, key).ok());
        values.collect::<Option<_>>().map(Answer::Match)
    }

    fn right_ui(
        &self,
        ui: &mut Ui,
        question: &Question,
        right: &Solution,
        given: &Answer,
        session: &mut Session,
    ) {
        let (Kind::Match(kind), Solution::Match(right)) = (&question.kind, right) else {
            return;
        };
        let own = match given {
            Answer::Match(own) => &**own,
            _ => &[],
        };
        Grid::new("parameters")
            .num_columns(3)
            .spacing([16.0, 4.0])
            .show(ui, |ui| {
                ui.label("");
                ui.label(RichText::new(text!("course-yours")).weak());
                ui.label(RichText::new(text!("course-target")).weak());
                ui.end_row();
                for ((key, own), right) in kind.controls.iter().zip(own).zip(right) {
                    ui.label(control_name(key));
                    ui.monospace(short(*own));
                    ui.monospace(short(*right));
                    ui.end_row();
                }
            });
        set_ui(ui, session, &kind.settings(right));
    }
}

fn match_ui(ui: &mut Ui, asked: &mut WidgetContext<'_>, kind: &Match) {
    let (Some(staged), Some(Solution::Match(values))) = (asked.staged, asked.solution) else {
        return waiting_ui(ui, text!("course-preparing"));
    };
    let mut own: Matching = asked.window.own.take();
    let now = ui.input(|input| input.time);
    if own.of != Some(asked.step) {
        own = Matching {
            of: Some(asked.step),
            began: now,
            ..Matching::default()
        };
    }
    let mut settings = asked.question.set.clone();
    settings.extend(kind.settings(values));
    let Ok(mut target) = staged.scene.with_overrides(&settings) else {
        return;
    };
    let mut present = asked.scene.clone();
    // The student may change the view, but the pictures are compared in the target's.
    present.camera = target.camera.clone();
    let [width, height] = target.image.size;
    let scale = f64::from(SIDE) / f64::from(width.max(height).max(1));
    let size = [width, height].map(|side| ((f64::from(side) * scale) as u32).max(1));
    (target.image.size, present.image.size) = (size, size);
    own.draw_target(ui.ctx(), &target, staged.model.as_ref());
    own.measure(ui.ctx(), [present, target], staged.model.as_ref());
    ui.label(RichText::new(text!("course-target")).weak());
    target_ui(ui, &own, size);
    ui.add_space(4.0);
    distance_ui(ui, &own, kind.tolerance);
    if !asked.revealed {
        let seconds = (now - own.began).max(0.0) as u64;
        let time = format!("{}:{:02}", seconds / 60, seconds % 60);
        let words = text!("course-match-tries", count = own.changes, time = time);
        ui.label(RichText::new(words).weak());
    }
    asked.window.own.put(own);
}

fn target_ui(ui: &mut Ui, own: &Matching, [width, height]: [u32; 2]) {
    let aspect = height as f32 / width as f32;
    let wide = ui.available_width().min(HIGHEST / aspect);
    let response = picture_ui(ui, own.picture.as_ref(), vec2(wide, wide * aspect));
    named(response, Role::Image, text!("course-target"));
}

/// Shows the distance on a logarithmic scale from its value at first to the tolerance. The meter is empty until the distance is
/// known, so that nothing below it moves then.
fn distance_ui(ui: &mut Ui, own: &Matching, tolerance: f64) {
    let [first, before, distance] = own.distances;
    let start = first.unwrap_or(tolerance).max(4.0 * tolerance);
    let share = distance.map_or(0.0, |distance| {
        let near = (start / distance.max(1e-9)).ln() / (start / tolerance).ln();
        near.clamp(0.0, 1.0) as f32
    });
    let words = match (distance, before) {
        (Some(distance), _) if distance <= tolerance => text!("course-match-same"),
        (Some(distance), Some(before)) if distance < before => text!("course-warmer"),
        (Some(distance), Some(before)) if distance > before => text!("course-colder"),
        _ => "",
    };
    let rms = distance.map_or_else(|| "…".to_owned(), |distance| format!("{distance:.4}"));
    let colour = vector_text(ui.visuals(), Vector::L);
    let response = meter_ui(ui, vec2(ui.available_width(), METER), share, colour);
    let name = text!("course-match-meter");
    named(response, Role::ProgressIndicator, name);
    ui.horizontal(|ui| {
        ui.label(text!("course-match-distance", rms = rms));
        ui.label(RichText::new(words).strong());
    });
}
