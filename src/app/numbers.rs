//! The picture's meaning in numbers at the probe: vectors, angles, and the equation filled in.

use super::compare::compare_ui;
use super::curves::curves_ui;
use super::defects::defects_ui;
use super::engine::Engine;
use super::look::NumbersTab;
use super::plan::plan_ui;
use super::point::point_ui;
use super::profile::profile_ui;
use super::scan::scan_ui;
use super::stability::stability_ui;
use super::state::AppState;
use super::study::study_ui;
use eframe::egui::accesskit::Role;
use eframe::egui::{Button, ScrollArea, Ui, WidgetInfo, vec2};

/// A tab of the panel of numbers.
#[derive(Clone, Copy)]
pub struct Tab {
    pub key: NumbersTab,
    title: &'static str,
    show: fn(&mut Ui, &mut AppState, &Engine),
}

/// Every tab, in the order in which they are shown.
pub const TABS: [Tab; 9] = [
    Tab {
        key: NumbersTab::Equation,
        title: "Equation",
        show: point_ui,
    },
    Tab {
        key: NumbersTab::Curves,
        title: "Curves",
        show: |ui, state, engine| with(ui, state, engine, curves_ui),
    },
    Tab {
        key: NumbersTab::Profile,
        title: "Profile",
        show: |ui, state, engine| with(ui, state, engine, profile_ui),
    },
    Tab {
        key: NumbersTab::ScanLine,
        title: "Scan line",
        show: |ui, state, engine| with(ui, state, engine, scan_ui),
    },
    Tab {
        key: NumbersTab::Compare,
        title: "Compare",
        show: |ui, state, engine| with(ui, state, engine, compare_ui),
    },
    Tab {
        key: NumbersTab::Defects,
        title: "Defects",
        show: |ui, state, engine| with(ui, state, engine, defects_ui),
    },
    Tab {
        key: NumbersTab::Plan,
        title: "Plan",
        show: |ui, state, engine| with(ui, state, engine, plan_ui),
    },
    Tab {
        key: NumbersTab::Study,
        title: "Study",
        show: |ui, state, engine| with(ui, state, engine, study_ui),
    },
    Tab {
        key: NumbersTab::Stability,
        title: "Stability",
        show: |ui, state, engine| with(ui, state, engine, stability_ui),
    },
];

/// Shows a tab with what it remembers.
fn with<T: Default + 'static>(
    ui: &mut Ui,
    state: &mut AppState,
    engine: &Engine,
    show: fn(&mut Ui, &mut T, &mut AppState, &Engine),
) {
    let mut own = state.own.take();
    show(ui, &mut own, state, engine);
    state.own.put(own);
}

/// The panel of numbers: a tab for each way of reading the picture.
pub fn numbers_ui(ui: &mut Ui, state: &mut AppState, engine: &Engine) {
    ui.add_space(6.0);
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = vec2(4.0, 4.0);
        for Tab { key, title, .. } in TABS {
            let selected = state.look.tab == key;
            let response = ui.add(Button::selectable(selected, title));
            let enabled = ui.is_enabled();
            response.widget_info(|| WidgetInfo::selected(Role::Tab, enabled, selected, title));
            if response.clicked() {
                state.look.tab = key;
            }
        }
    });
    ui.add_space(4.0);
    let Some(tab) = TABS.iter().find(|tab| tab.key == state.look.tab) else {
        return;
    };
    ScrollArea::vertical()
        .id_salt(tab.title)
        .auto_shrink(false)
        .show(ui, |ui| (tab.show)(ui, state, engine));
}
