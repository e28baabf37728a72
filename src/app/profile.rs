//! The profile along the line in the picture: what is compared, who looks from where, and the plots.

pub mod look;
mod worker;

pub use worker::{Profiles, save};

use super::action::Action;
use super::curves::{LETTERS, height, paper, plot_ui};
use super::dialog::Dialog;
use super::engine::Engine;
use super::look::NumbersTab;
use super::row::{About, NumberRow, Rail, number};
use super::state::AppState;
use super::theme::TEXT;
use crate::analysis::{Perception, ResponseModel, Viewing};
use crate::figure::{PlotStyle, lay_out};
use crate::scene::ShadingMode;
use eframe::egui::{Button, RichText, Ui};
use glam::DVec2;
use look::MODES;

/// The profile's tab.
pub fn profile_ui(ui: &mut Ui, profiles: &mut Profiles, state: &mut AppState, engine: &Engine) {
    ui.label("Drag the line's ends in the picture.");
    modes_ui(ui, &mut state.look.profile.modes);
    eye_ui(ui, state);
    let size = engine.size();
    if size.contains(&0) {
        return;
    }
    ui.checkbox(&mut state.look.profile.perceived, "Show the picture as it is perceived");
    let request = state.look.profile.request(state.line.pixels(size));
    let AppState { shown, look, .. } = state;
    if look.profile.perceived {
        profiles.ask_perceived(ui.ctx(), shown, size, &request);
        if let Some(why) = profiles.not_perceived() {
            ui.label(RichText::new(why).weak());
        }
    }
    profiles.ask(ui.ctx(), shown, size, request);
    ui.add_space(4.0);
    save_ui(ui, profiles, state);
    ui.separator();
    plots_ui(ui, profiles);
    ui.label(
        RichText::new(
            "Phong shading weakens Mach bands, it does not abolish them: its slope still jumps, only by less.",
        )
        .weak(),
    );
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
            let rail = Rail { limits: low..=high, ..Rail::logarithmic(low..=high) };
            number(ui, lit, &NumberRow { about, rail, default }, value);
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

fn save_ui(ui: &mut Ui, profiles: &Profiles, state: &mut AppState) {
    let ready = profiles.profile().is_some();
    ui.horizontal(|ui| {
        for (ending, tip) in [("csv", "The samples as a table"), ("png", "The plots"), ("svg", "The plots, to edit")] {
            let button = ui.add_enabled(ready, Button::new(format!("{}…", ending.to_uppercase())));
            if button.on_hover_text(tip).clicked() {
                state.ask(Action::SaveProfile(ending));
            }
        }
    });
}

/// Whether the picture is to be shown as it is perceived.
pub fn shows_perceived(state: &AppState) -> bool {
    state.shows(NumbersTab::Profile) && state.look.profile.perceived
}

/// The dialog that asks where to.
pub fn save_dialog(ending: &'static str) -> Dialog {
    Dialog::SaveProfile { path: format!("profile.{ending}"), ending }
}

fn plots_ui(ui: &mut Ui, profiles: &mut Profiles) {
    if let Some(why) = profiles.missing() {
        ui.label(why);
        return;
    }
    let style = PlotStyle { paper: paper(ui), text: LETTERS * f64::from(TEXT), titled: false };
    let width = f64::from(ui.available_width());
    let room = |plot: &_| DVec2::new(width, height(plot, width, style.text));
    profiles.lay_out((style, ui.available_width()), |plot| lay_out(plot, room(plot), &style));
    for (plot, drawing) in profiles.laid_out() {
        ui.label(RichText::new(&plot.title).strong());
        plot_ui(ui, plot, drawing, &style);
        ui.add_space(12.0);
    }
}
