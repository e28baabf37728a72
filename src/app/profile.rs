//! The profile along the line in the picture: what is compared, who looks from where, and the plots.

pub mod look;

use super::background::{ask, wake};
use super::document::Document;
use super::engine::{Engine, image_of};
use super::look::NumbersTab;
use super::report::{ReportView, export_ui};
use super::row::{About, NumberRow, SliderRange, number};
use super::state::AppState;
use crate::analysis::{
    self, Answer, PERCEIVED_WIDTH, Perception, Profile, ProfileQuestion, ResponseModel, Viewing, Watch,
    perceived_picture,
};
use crate::jobs::{Asked, Background, Work};
use crate::render::Frame;
use crate::scene::{Scene, ShadingMode};
use eframe::egui::{Button, Context, RichText, TextureHandle, TextureOptions, Ui};
use glam::DVec2;
use look::MODES;
use std::fmt::{self, Debug, Formatter};

/// The profile's tab.
pub fn profile_ui(ui: &mut Ui, profiles: &mut Profiles, state: &mut AppState, engine: &Engine) {
    ui.label("Drag the line's ends in the picture.");
    modes_ui(ui, &mut state.look.profile.modes);
    eye_ui(ui, state);
    let size = engine.size;
    if size.contains(&0) {
        return;
    }
    ui.checkbox(&mut state.look.profile.perceived, "Show the picture as it is perceived");
    let request = state.look.profile.request(state.line.pixels(size));
    let AppState { shown, look, .. } = state;
    if look.profile.perceived {
        profiles.ask_perceived(ui.ctx(), shown, size, &request);
        if let Some(Err(why)) = profiles.seen.known() {
            ui.label(RichText::new(why).weak());
        }
    }
    profiles.ask(ui.ctx(), shown, size, &request);
    ui.add_space(4.0);
    export_ui(ui, state, "profile", || profiles.answer());
    ui.separator();
    match profiles.taken.known() {
        None => _ = ui.label("…"),
        Some(Err(why)) => _ = ui.label(why),
        Some(Ok(_)) => profiles.view.ui(ui),
    }
}

/// The profile last taken with its plots, and the picture as it is perceived.
#[derive(Default)]
pub struct Profiles {
    taken: Background<Asked<ProfileQuestion>>,
    view: ReportView,
    seen: Background<Perceived>,
    texture: Option<TextureHandle>,
}

impl Debug for Profiles {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.debug_struct("Profiles").field("taken", &self.taken).finish_non_exhaustive()
    }
}

/// The whole picture as it is perceived.
struct Perceived(Asked<ProfileQuestion>);

impl Work for Perceived {
    type Answer = Frame;

    fn run(&self, _: &dyn Watch<Frame>) -> Result<Frame, String> {
        let ProfileQuestion { viewing, perception, .. } = &self.0.question;
        let [_, widest] = perception.widths(viewing.pixels_per_degree());
        if widest > PERCEIVED_WIDTH {
            return Err(format!("σs is {widest:.0} pixels, expected at most {PERCEIVED_WIDTH} for a whole picture"));
        }
        let subject = self.0.subject();
        Ok(perceived_picture(&mut subject.renderer(), &subject.scene, viewing, perception))
    }
}

impl Profiles {
    /// Takes this profile in the background; until then the last one is shown.
    fn ask(&mut self, ctx: &Context, document: &Document, size: [u32; 2], question: &ProfileQuestion) {
        let new = ask(&mut self.taken, ctx, document, size, question);
        if let Some(taken) = self.taken.answer().filter(|_| new) {
            self.view.set(taken.report(&analysis::About { name: "", scene: &document.scene }));
        }
    }

    /// Computes the picture as it is perceived in the background; until then the last one is shown.
    fn ask_perceived(&mut self, ctx: &Context, document: &Document, size: [u32; 2], question: &ProfileQuestion) {
        // The line does not matter to the whole picture.
        let question = ProfileQuestion { from: DVec2::ZERO, to: DVec2::ZERO, modes: vec![], ..question.clone() };
        let (scene, model) = (&document.scene, document.model.as_ref());
        let same = |seen: &Perceived| seen.0.is(&question, scene, model, size);
        let work = || Perceived(Asked::new(question.clone(), scene, model, size));
        if self.seen.ask(wake(ctx), same, work) {
            match (self.seen.answer().map(image_of), &mut self.texture) {
                (Some(image), Some(texture)) => texture.set(image, TextureOptions::NEAREST),
                (Some(image), texture) => {
                    *texture = Some(ctx.load_texture("perceived", image, TextureOptions::NEAREST));
                }
                (None, texture) => *texture = None,
            }
            ctx.request_repaint();
        }
    }

    /// The picture as it is perceived.
    pub fn perceived(&self) -> Option<&TextureHandle> {
        self.texture.as_ref()
    }

    /// The profile last taken.
    pub fn profile(&self) -> Option<&Profile> {
        self.taken.answer().map(|taken| &taken.profile)
    }

    fn answer(&self) -> Option<(Box<dyn Answer>, Scene)> {
        Some((Box::new(self.taken.answer()?.clone()), self.taken.answered()?.subject().scene))
    }
}

fn modes_ui(ui: &mut Ui, modes: &mut Vec<ShadingMode>) {
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        for (mode, name) in MODES {
            let shown = modes.contains(&mode);
            if ui.add(Button::selectable(shown, name)).on_hover_text("Shows the profile of this shading").clicked() {
                let kept = |other: ShadingMode| if other == mode { !shown } else { modes.contains(&other) };
                *modes = MODES.into_iter().map(|(mode, _)| mode).filter(|other| kept(*other)).collect();
            }
        }
    });
}

fn eye_ui(ui: &mut Ui, state: &mut AppState) {
    let AppState { look, lit, .. } = state;
    let (viewing, perception) = (&mut look.profile.viewing, &mut look.profile.perception);
    ui.collapsing("The eye and the screen", |ui| {
        ui.horizontal(|ui| {
            let names = ["Lateral inhibition", "Normalisation"];
            for (model, name) in ResponseModel::ALL.into_iter().zip(names) {
                ui.selectable_value(&mut perception.model, model, name);
            }
        });
        let mut row = |label, tip, [low, high]: [f64; 2], default, value: &mut f64| {
            let about = About { label, tip, ..About::default() };
            let range = SliderRange { limits: low..=high, ..SliderRange::logarithmic(low..=high) };
            number(ui, lit, &NumberRow { about, range, default }, value);
        };
        let (usual, eye) = (Viewing::default(), Perception::default());
        row(
            "distance",
            "From the eye to the screen, millimetres.",
            Viewing::DISTANCE,
            usual.distance,
            &mut viewing.distance,
        );
        row(
            "density",
            "Pixels of the screen to a millimetre; 3.78 are 96 to an inch.",
            Viewing::DENSITY,
            usual.density,
            &mut viewing.density,
        );
        row("centre", "σc, degrees of visual angle.", Perception::WIDTH, eye.centre, &mut perception.centre);
        row("surround", "σs, degrees of visual angle.", Perception::WIDTH, eye.surround, &mut perception.surround);
        let weight = [0.01, Perception::WEIGHT[1]];
        row("strength", "w, the strength of the inhibition.", weight, eye.weight, &mut perception.weight);
    });
}

/// Whether the picture is to be shown as it is perceived.
pub fn shows_perceived(state: &AppState) -> bool {
    state.shows(NumbersTab::Profile) && state.look.profile.perceived
}
