//! The profile along the line in the picture: what is compared, who looks from where, and the plots.

pub mod look;

use super::background::wake;
use super::document::Document;
use super::engine::{Engine, image_of, upload};
use super::look::NumbersTab;
use super::report::{Asking, export_ui};
use super::row::{About, NumberRow, SliderRange, number};
use super::state::AppState;
use crate::analysis::{
    PERCEIVED_WIDTH, Perception, Profile, ProfileQuestion, ResponseModel, Viewing, Watch,
    perceived_picture,
};
use crate::jobs::{Asked, Background, Work};
use crate::render::Frame;
use crate::scene::{Choice, ShadingMode};
use eframe::egui::{Button, Context, RichText, TextureHandle, TextureOptions, Ui};
use glam::DVec2;

/// The profile's tab.
pub fn profile_ui(ui: &mut Ui, profiles: &mut Profiles, state: &mut AppState, engine: &Engine) {
    ui.label("Drag the line's ends in the picture.");
    modes_ui(ui, &mut state.look.profile.modes);
    eye_ui(ui, state);
    let size = engine.size;
    if size.contains(&0) {
        return;
    }
    ui.checkbox(
        &mut state.look.profile.perceived,
        "Show the picture as it is perceived",
    );
    let question = state.look.profile.request(state.line.pixels(size));
    if state.look.profile.perceived {
        profiles.ask_perceived(ui.ctx(), &state.shown, size, &question);
        if let Some(Err(why)) = profiles.seen.known() {
            ui.label(RichText::new(why).weak());
        }
    }
    profiles.taken.ask(ui.ctx(), &state.shown, size, &question);
    ui.add_space(4.0);
    export_ui(ui, state, "profile", || profiles.taken.latest());
    ui.separator();
    match profiles.taken.work.known() {
        None => _ = ui.label("…"),
        Some(Err(why)) => _ = ui.label(why),
        Some(Ok(_)) => profiles.taken.view.ui(ui),
    }
}

/// The profile last taken with its plots, and the picture as it is perceived.
#[derive(Default)]
pub struct Profiles {
    taken: Asking<ProfileQuestion>,
    seen: Background<Perceived>,
    /// The whole picture as it is perceived.
    pub perceived: Option<TextureHandle>,
}

struct Perceived(Asked<ProfileQuestion>);

impl Work for Perceived {
    type Answer = Frame;

    fn run(&self, _: &dyn Watch<Frame>) -> Result<Frame, String> {
        let ProfileQuestion {
            viewing,
            perception,
            ..
        } = &self.0.question;
        let [_, widest] = perception.widths(viewing.pixels_per_degree());
        if widest > PERCEIVED_WIDTH {
            return Err(format!(
                "σs is {widest:.0} pixels, expected at most {PERCEIVED_WIDTH} for a whole picture"
            ));
        }
        let subject = self.0.subject();
        Ok(perceived_picture(
            &mut subject.renderer(),
            &subject.scene,
            viewing,
            perception,
        ))
    }
}

impl Profiles {
    /// Computes the picture as it is perceived in the background; until then the last one is shown.
    fn ask_perceived(
        &mut self,
        ctx: &Context,
        document: &Document,
        size: [u32; 2],
        question: &ProfileQuestion,
    ) {
        // The line does not matter to the whole picture.
        let question = ProfileQuestion {
            from: DVec2::ZERO,
            to: DVec2::ZERO,
            modes: vec![],
            ..question.clone()
        };
        let (scene, model) = (&document.scene, document.model.as_ref());
        let same = |seen: &Perceived| seen.0.is(&question, scene, model, size);
        let work = || Perceived(Asked::new(question.clone(), scene, model, size));
        if self.seen.ask(wake(ctx), same, work) {
            match self.seen.answer().map(image_of) {
                Some(image) => upload(
                    ctx,
                    &mut self.perceived,
                    "perceived",
                    image,
                    TextureOptions::NEAREST,
                ),
                None => self.perceived = None,
            }
            ctx.request_repaint();
        }
    }

    /// The profile last taken.
    pub fn profile(&self) -> Option<&Profile> {
        self.taken.work.answer().map(|taken| &taken.profile)
    }
}

fn modes_ui(ui: &mut Ui, modes: &mut Vec<ShadingMode>) {
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        for &mode in ShadingMode::VALUES {
            let shown = modes.contains(&mode);
            let name = if mode == ShadingMode::Interpolated {
                "Interp."
            } else {
                mode.label()
            };
            if ui
                .add(Button::selectable(shown, name))
                .on_hover_text("Shows the profile of this shading")
                .clicked()
            {
                let kept = |other: &ShadingMode| {
                    if *other == mode {
                        !shown
                    } else {
                        modes.contains(other)
                    }
                };
                *modes = ShadingMode::VALUES.iter().copied().filter(kept).collect();
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
        let (usual, eye) = (Viewing::default(), Perception::default());
        let far = "From the eye to the screen, millimetres.";
        let dense = "Pixels of the screen to a millimetre; 3.78 are 96 to an inch.";
        let (centre, surround) = (
            "σc, degrees of visual angle.",
            "σs, degrees of visual angle.",
        );
        let (strong, weight) = (
            "w, the strength of the inhibition.",
            [0.01, Perception::WEIGHT[1]],
        );
        for (label, tip, [low, high], default, value) in [
            (
                "distance",
                far,
                Viewing::DISTANCE,
                usual.distance,
                &mut viewing.distance,
            ),
            (
                "density",
                dense,
                Viewing::DENSITY,
                usual.density,
                &mut viewing.density,
            ),
            (
                "centre",
                centre,
                Perception::WIDTH,
                eye.centre,
                &mut perception.centre,
            ),
            (
                "surround",
                surround,
                Perception::WIDTH,
                eye.surround,
                &mut perception.surround,
            ),
            (
                "strength",
                strong,
                weight,
                eye.weight,
                &mut perception.weight,
            ),
        ] {
            let about = About {
                label,
                tip,
                ..About::default()
            };
            let range = SliderRange {
                limits: low..=high,
                ..SliderRange::logarithmic(low..=high)
            };
            number(
                ui,
                lit,
                &NumberRow {
                    about,
                    range,
                    default,
                },
                value,
            );
        }
    });
}

/// Whether the picture is to be shown as it is perceived.
pub fn shows_perceived(state: &AppState) -> bool {
    state.shows(NumbersTab::Profile) && state.look.profile.perceived
}
