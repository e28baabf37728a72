//! The bars: on top menus and the shading modes side by side; at the bottom which stages the last change ran, what they cost, and
//! what was left out.

use super::action::Action;
use super::appearance::ViewName;
use super::commands::{MENUS, SECTIONS};
use super::compare::VIEWS;
use super::course::back_ui;
use super::engine::Engine;
use super::equation;
use super::focus::{named, one_stop};
use super::menu::commands_ui;
use super::notice::said_ui;
use super::plan::{grouped, left_out};
use super::state::AppState;
use super::system;
use super::terms;
use super::theme::ThemeChoice;
use crate::analysis::plan_words::stage_words;
use crate::render::StageRun;
use crate::scene::{Choice, ShadingMode};
use crate::text::{Language, text};
use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align, Button, ComboBox, Label, Layout, MenuBar, RichText, Sense, TextWrapMode, Ui, vec2,
};

/// Below this width the menus fold into one, and the modes into a list.
const NARROW: f32 = 860.0;

/// Menus at the left, modes in the middle; the scene's title too where the window is `low`.
pub fn menus_ui(ui: &mut Ui, state: &mut AppState, low: bool) {
    ui.add_space(3.0);
    let narrow = ui.available_width() < NARROW;
    MenuBar::new().ui(ui, |ui| {
        if narrow {
            ui.menu_button(text!("menu"), |ui| each_menu_ui(ui, state));
            mode_list_ui(ui, state);
        } else {
            let menus = ui.horizontal(|ui| each_menu_ui(ui, state));
            one_stop(ui, menus.response.rect);
            ui.separator();
            let modes = ui.horizontal(|ui| modes_ui(ui, state));
            one_stop(ui, modes.response.rect);
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let name = if low {
                scene_buttons_ui(ui, state);
                state.document.title()
            } else {
                state.document.origin.name()
            };
            let text = if state.modified() {
                format!("{name} *")
            } else {
                name
            };
            ui.add(Label::new(RichText::new(text).weak()).truncate());
        });
    });
    ui.add_space(3.0);
}

fn each_menu_ui(ui: &mut Ui, state: &mut AppState) {
    for section in MENUS
        .iter()
        .filter_map(|menu| SECTIONS.iter().find(|section| section.key == *menu))
    {
        ui.menu_button(section.title(), |ui| menu_ui(ui, state, section.key));
    }
}

/// The items of a menu.
fn menu_ui(ui: &mut Ui, state: &mut AppState, menu: &str) {
    commands_ui(ui, state, menu);
    if menu == "file" && !system::PAGE {
        ui.separator();
        ui.add_enabled_ui(!state.appearance.recent.is_empty(), |ui| {
            ui.menu_button(text!("recent"), |ui| recent_ui(ui, state));
        });
    }
    if menu != "view" {
        return;
    }
    ui.separator();
    ui.menu_button(text!("controls-group-compare"), |ui| {
        for (view, name, tip) in VIEWS {
            let present = state.document.scene.compare.view == view;
            let radio = ui.radio(present, text!(name));
            if radio.on_hover_text(text!(tip)).clicked() {
                state.ask(Action::Compare(view));
                ui.close();
            }
        }
        ui.separator();
        commands_ui(ui, state, "compare");
    });
    ui.menu_button(text!("controls-theme"), |ui| {
        let themes = [
            (text!("theme-system"), ThemeChoice::System),
            (text!("theme-dark"), ThemeChoice::Dark),
            (text!("theme-light"), ThemeChoice::Light),
        ];
        for (text, theme) in themes {
            ui.radio_value(&mut state.appearance.theme, theme, text);
        }
    });
    ui.menu_button(text!("language"), |ui| {
        ui.radio_value(
            &mut state.appearance.language,
            None,
            text!("language-system"),
        );
        for language in Language::ALL {
            let chosen = Some(language);
            ui.radio_value(&mut state.appearance.language, chosen, language.name());
        }
    });
}

/// The equation, and a switch for each of its terms.
pub fn equation_ui(ui: &mut Ui, state: &mut AppState) {
    ui.add_space(4.0);
    let wide = ui.available_width() > 640.0;
    if wide {
        ui.horizontal(|ui| {
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                terms::switches_ui(ui, state, true);
                ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                    equation::equation_ui(ui, state);
                });
            });
        });
    } else {
        equation::equation_ui(ui, state);
        ui.horizontal_wrapped(|ui| terms::switches_ui(ui, state, false));
    }
    one_stop(ui, ui.min_rect());
    ui.add_space(3.0);
}

/// The scene's title and sentence; the scenes before and after it, and all of them.
pub fn title_ui(ui: &mut Ui, state: &mut AppState) {
    ui.add_space(2.0);
    ui.horizontal(|ui| {
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            scene_buttons_ui(ui, state);
            ui.with_layout(Layout::top_down(Align::Min), |ui| {
                ui.spacing_mut().item_spacing.y = 1.0;
                let title = RichText::new(state.document.title()).strong();
                ui.add(Label::new(title).truncate());
                let sentence = state.document.sentence();
                if !sentence.is_empty() {
                    ui.add(Label::new(RichText::new(sentence).weak()).wrap());
                }
            });
        });
    });
    ui.add_space(2.0);
}

/// From the right to the left: all scenes, the next one, the one before.
fn scene_buttons_ui(ui: &mut Ui, state: &mut AppState) {
    let all = if ui.available_width() < 480.0 {
        "▦".to_owned()
    } else {
        format!("▦ {}", text!("scenes"))
    };
    let side = ui.spacing().interact_size.y;
    let button = ui.add(Button::new(all).min_size(vec2(side, side)));
    let button = named(button, Role::Button, text!("scenes"));
    if button.on_hover_text(text!("scenes.tip")).clicked() {
        state.ask(Action::Scenes);
    }
    for (sign, step, name) in [
        ("▶", 1, text!("scenes-next")),
        ("◀", -1, text!("scenes-previous")),
    ] {
        let button = ui.add(Button::new(sign).min_size(vec2(side, side)));
        let button = named(button, Role::Button, name);
        if button.on_hover_text(name).clicked() {
            state.ask(Action::NextScene(step));
        }
    }
    // The course's own view has it too.
    if state.has_left_lesson() && !state.shows(ViewName::Course) {
        back_ui(ui, state);
    }
}

/// The files opened or saved last.
fn recent_ui(ui: &mut Ui, state: &mut AppState) {
    for path in state.appearance.recent.clone() {
        let name = path.file_name().unwrap_or(path.as_os_str());
        let button = ui.button(name.to_string_lossy());
        if button.on_hover_text(path.display().to_string()).clicked() {
            state.ask(Action::OpenFile(path));
            ui.close();
        }
    }
    ui.separator();
    if ui.button(text!("recent-clear")).clicked() {
        state.appearance.recent.clear();
        ui.close();
    }
}

/// The shading modes, a button each.
fn modes_ui(ui: &mut Ui, state: &mut AppState) {
    let present = state.shown.scene.shading.mode;
    for (index, mode) in ShadingMode::VALUES.iter().enumerate() {
        let name = format!("{} {}", index + 1, mode.label());
        let button = ui.add(Button::selectable(present == *mode, name));
        if button.on_hover_text(mode.help()).clicked() {
            shade(state, *mode);
        }
    }
}

/// The shading modes as a list, named as large as the room allows.
fn mode_list_ui(ui: &mut Ui, state: &mut AppState) {
    let present = state.shown.scene.shading.mode;
    let list = ComboBox::from_id_salt("modes")
        .selected_text(present.label())
        .show_ui(ui, |ui| {
            for mode in ShadingMode::VALUES {
                let entry = ui.selectable_label(present == *mode, mode.label());
                if entry.on_hover_text(mode.help()).clicked() {
                    shade(state, *mode);
                }
            }
        });
    named(list.response, Role::ComboBox, text!("modes"));
}

fn shade(state: &mut AppState, mode: ShadingMode) {
    state.ask(Action::Shade {
        mode,
        renormalise: true,
    });
}

/// The bar of stages.
pub fn stages_ui(ui: &mut Ui, state: &mut AppState, engine: &Engine) {
    ui.add_space(2.0);
    if state.hides_numbers() {
        // As high as with numbers, so that the picture keeps its size. Other views say it themselves.
        ui.horizontal(|ui| {
            if state.shows(ViewName::Course) {
                ui.label(RichText::new(text!("course-hidden")).weak());
            }
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                said_ui(ui, state, TextWrapMode::Truncate);
            });
        });
        ui.add_space(2.0);
        return;
    }
    ui.horizontal(|ui| {
        let report = engine.report();
        for run in &report.stages {
            stage_ui(ui, run);
        }
        ui.separator();
        let evaluations: u64 = report.stages.iter().map(|run| run.evaluations).sum();
        let ms = engine.nanoseconds() as f64 / 1e6;
        ui.label(RichText::new(format!("{ms:.1} ms")).monospace());
        if engine.coarser() > 1 {
            let text = text!("coarser", share = engine.coarser());
            ui.label(text).on_hover_text(text!("coarser-tip"));
        }
        // A notice takes the room of the counts; so does a narrow window.
        let room = if state.said().is_none() {
            ui.available_width()
        } else {
            0.0
        };
        if room > 250.0 {
            ui.label(text!(
                "evaluations",
                count = evaluations,
                shown = grouped(evaluations)
            ));
        }
        if room > 530.0 {
            ui.label(RichText::new(text!("triangles", count = grouped(report.triangles))).weak());
        }
        if report.overflowing > 0 && room.min(ui.available_width()) > 250.0 {
            ui.label(text!("overflowing", count = grouped(report.overflowing)));
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let omitted = left_out(engine, &state.appearance);
            let tip = text!("left-out-tip");
            if ui
                .link(text!("left-out", count = omitted))
                .on_hover_text(tip)
                .clicked()
            {
                state.show_view(ViewName::Plan);
            }
            said_ui(ui, state, TextWrapMode::Truncate);
        });
    });
    ui.add_space(2.0);
}

fn stage_ui(ui: &mut Ui, run: &StageRun) {
    let (name, what) = stage_words(run.stage);
    let (text, time) = if run.ran {
        let (ms, evaluations) = (run.nanoseconds as f64 / 1e6, grouped(run.evaluations));
        (
            RichText::new(format!("■ {name}")).strong(),
            text!(
                "stage-ran",
                ms = format!("{ms:.2}"),
                evaluations = evaluations
            ),
        )
    } else {
        (
            RichText::new(format!("□ {name}")).weak(),
            text!("stage-kept").to_owned(),
        )
    };
    ui.add(Label::new(text).sense(Sense::hover()))
        .on_hover_text(format!("{what}\n{time}"));
}
