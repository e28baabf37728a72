//! The window within another page, as a figure: the picture, and below it the controls that the link names.

use crate::app::App;
use crate::app::controls::named::{Named, rows_ui};
use crate::app::engine::Engine;
use crate::app::picture::{self, Room};
use crate::app::session::action::Action;
use crate::app::session::appearance::Appearance;
use crate::app::state::AppState;
use crate::app::widgets::focus::keep_in_sight;
use crate::scene::Choice as _;
use crate::text::text;
use eframe::egui::{CentralPanel, Frame, Panel, RichText, ScrollArea, Ui};

/// The picture keeps at least this share of the height.
const PICTURE: f32 = 0.45;

impl App {
    /// The same window as a figure in another page: with the look of a new one, which is not remembered.
    #[must_use]
    pub fn embedded(mut self, controls: &[String]) -> Self {
        let Appearance {
            theme, language, ..
        } = self.state.appearance;
        self.state.appearance = Appearance {
            theme,
            language,
            welcomed: true,
            ..Appearance::default()
        };
        self.state.welcome = false;
        self.state.embedded = Some(controls.to_vec());
        self
    }
}

/// Shows the picture and the controls below it.
pub fn embedded_ui(ui: &mut Ui, state: &mut AppState, engine: &mut Engine) -> Room {
    let words = state.embedded.clone().unwrap_or_default();
    let controls: Vec<Named> = words.iter().filter_map(|word| Named::find(word)).collect();
    let footer = ui.spacing().interact_size.y + 16.0;
    let most = (1.0 - PICTURE) * ui.available_height() - footer;
    Panel::bottom("embedded").show(ui, |ui| {
        ui.add_space(4.0);
        if !controls.is_empty() {
            ScrollArea::vertical()
                .max_height(most)
                .min_scrolled_height(0.0)
                .auto_shrink([false, true])
                .show(ui, |ui| {
                    rows_ui(ui, state, &controls);
                    keep_in_sight(ui);
                });
        }
        for word in words.iter().filter(|word| Named::find(word).is_none()) {
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
