//! The window within another page, as a figure: the picture, and below it the controls that the link names.

use super::App;
use super::action::Action;
use super::engine::Engine;
use super::look::Look;
use super::picture::{self, Room};
use super::row::{View, parameter_with};
use super::state::AppState;
use crate::scene::parameter::Parameter;
use crate::scene::{Choice as _, LightKind, light};
use crate::text::text;
use eframe::egui::{CentralPanel, Frame, Panel, RichText, ScrollArea, Ui};

/// Least width of a column of controls, points, and the most columns.
const COLUMN: f32 = 290.0;
const MOST_COLUMNS: usize = 3;
/// The picture keeps at least this share of the height.
const PICTURE: f32 = 0.45;

/// What a word names.
#[derive(Clone, Copy, Debug)]
enum Named {
    Row(&'static Parameter),
    /// Where the chosen light is, or which way it shines.
    Light,
}

/// The control of a parameter by its key, as in `material.n`, or by the last word of that, as in `n`; `light` is where the light is.
fn named(word: &str) -> Option<Named> {
    if word == "light" {
        return Some(Named::Light);
    }
    Parameter::by_word(word).map(Named::Row)
}

impl App {
    /// The same window as a figure in another page: with the look of a new one, which is not remembered.
    #[must_use]
    pub fn embedded(mut self, controls: &[String]) -> Self {
        let Look {
            theme, language, ..
        } = self.state.look;
        self.state.look = Look {
            theme,
            language,
            welcomed: true,
            ..Look::default()
        };
        self.state.welcome = false;
        self.state.embedded = Some(controls.to_vec());
        self
    }
}

/// Shows the picture and the controls below it.
pub fn embedded_ui(ui: &mut Ui, state: &mut AppState, engine: &mut Engine) -> Room {
    let words = state.embedded.clone().unwrap_or_default();
    let controls: Vec<Named> = words.iter().filter_map(|word| named(word)).collect();
    let footer = ui.spacing().interact_size.y + 16.0;
    let most = (1.0 - PICTURE) * ui.available_height() - footer;
    Panel::bottom("embedded").show(ui, |ui| {
        ui.add_space(4.0);
        if !controls.is_empty() {
            ScrollArea::vertical()
                .max_height(most)
                .min_scrolled_height(0.0)
                .auto_shrink([false, true])
                .show(ui, |ui| rows_ui(ui, state, &controls));
        }
        for word in words.iter().filter(|word| named(word).is_none()) {
            let words = text!("embed-unknown", name = word.as_str());
            ui.label(RichText::new(words).color(ui.visuals().error_fg_color));
        }
        ui.horizontal(|ui| {
            ui.label(RichText::new(state.shown.scene.shading.mode.label()).weak());
            if ui
                .link(text!("embed-open"))
                .on_hover_text(text!("embed-open.tip"))
                .clicked()
            {
                state.ask(Action::OpenPage);
            }
        });
        ui.add_space(2.0);
    });
    let shown = CentralPanel::default()
        .frame(Frame::NONE)
        .show(ui, |ui| picture::picture_ui(ui, state, engine));
    shown.inner
}

fn rows_ui(ui: &mut Ui, state: &mut AppState, controls: &[Named]) {
    let count = ((ui.available_width() / COLUMN) as usize)
        .min(controls.len())
        .clamp(1, MOST_COLUMNS);
    ui.columns(count, |columns| {
        for (index, control) in controls.iter().enumerate() {
            row_ui(&mut columns[index % count], state, *control);
        }
    });
}

fn row_ui(ui: &mut Ui, state: &mut AppState, control: Named) {
    let AppState {
        lit, shown, light, ..
    } = state;
    let index = (*light).min(shown.scene.lights.len().saturating_sub(1));
    let kind = shown.scene.lights.get(index).map(|light| light.kind);
    let parameter = match control {
        Named::Row(parameter) => parameter,
        Named::Light if kind == Some(LightKind::Directional) => &light::DIRECTION,
        Named::Light => &light::POSITION,
    };
    let view = View {
        index,
        ..View::default()
    };
    parameter_with(ui, lit, &mut shown.scene, parameter, &view);
}
