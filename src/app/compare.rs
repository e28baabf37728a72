//! The tab of comparisons: how panes are shown, what each has of its own, and how far they are from each other.

use super::action::Action;
use super::engine::Engine;
use super::focus;
use super::panes::menu_ui;
use super::place::ProbePoint;
use super::report::{ReportView, export_ui};
use super::row::parameter;
use super::state::AppState;
use super::theme::text_field;
use crate::analysis::{self, Answer, Comparison};
use crate::scene::compare::{DIFFERENCE, GAIN};
use crate::scene::shading::{INTERPOLATION, MODE};
use crate::scene::{
    ChoiceOption, Compare, CompareView, Object, Pane, Scene, SceneError, ShadingMode, setting_words,
};
use crate::text;
use eframe::egui::accesskit::Role;
use eframe::egui::{Align, Button, Key, Layout, RichText, Ui};

/// The views with the keys of their names and of what they show.
pub const VIEWS: [(CompareView, &str, &str); 4] = [
    (
        CompareView::Single,
        "picture-view-single",
        "picture-view-single.tip",
    ),
    (
        CompareView::Panes,
        "picture-view-panes",
        "picture-view-panes.tip",
    ),
    (
        CompareView::Wipe,
        "picture-view-wipe",
        "picture-view-wipe.tip",
    ),
    (
        CompareView::Difference,
        "picture-view-difference",
        "picture-view-difference.tip",
    ),
];

/// From this width on the panes stand beside their figures, points.
const WIDE: f32 = 640.0;

/// What is typed in the tab.
#[derive(Debug, Default)]
pub struct Typed {
    setting: String,
    /// What is wrong with it.
    problem: Option<String>,
}

/// The comparison's tab.
pub fn compare_ui(ui: &mut Ui, typed: &mut Typed, state: &mut AppState, engine: &Engine) {
    if ui.available_width() < WIDE {
        views_ui(ui, typed, state, engine);
        ui.add_space(8.0);
        figures_ui(ui, state, engine);
        return;
    }
    ui.columns(2, |columns| {
        columns[0].vertical(|ui| views_ui(ui, typed, state, engine));
        columns[1].vertical(|ui| figures_ui(ui, state, engine));
    });
}

/// How panes are shown, and which there are.
fn views_ui(ui: &mut Ui, typed: &mut Typed, state: &mut AppState, engine: &Engine) {
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        for (view, name, tip) in VIEWS {
            let chosen = state.document.scene.compare.view == view;
            if ui
                .add(Button::selectable(chosen, text!(name)))
                .on_hover_text(text!(tip))
                .clicked()
            {
                state.ask(Action::Compare(view));
            }
        }
    });
    ui.add_space(4.0);
    ui.horizontal_wrapped(|ui| {
        if ui
            .button(text!("picture-all-modes"))
            .on_hover_text(text!("picture-all-modes.tip"))
            .clicked()
        {
            state.ask(Action::AllModes);
        }
        let full = state.document.scene.compare.panes.len() >= Compare::MAX_PANES;
        let most = text!("picture-panes-full", count = Compare::MAX_PANES + 1);
        ui.add_enabled_ui(!full, |ui| {
            ui.menu_button(text!("picture-add-pane"), |ui| add_ui(ui, typed, state))
                .response
        })
        .inner
        .on_disabled_hover_text(most);
    });
    if state.document.scene.compare.panes.is_empty() {
        ui.add_space(4.0);
        ui.label(text!("picture-compare-empty"));
    }
    if state.document.scene.compare.view == CompareView::Difference {
        ui.add_space(4.0);
        let AppState { document, lit, .. } = &mut *state;
        parameter(ui, lit, &mut document.scene, &DIFFERENCE);
        parameter(ui, lit, &mut document.scene, &GAIN);
    }
    ui.add_space(6.0);
    let count = state.document.scene.pane_count();
    for pane in 0..count {
        pane_ui(ui, state, engine, pane, count);
    }
    if count > 1 {
        ui.add_space(6.0);
        ui.checkbox(&mut state.panes.own, text!("picture-own-changes"))
            .on_hover_text(text!("picture-own-changes.tip"));
    }
}

/// A pane: whether it is the reference, its name, which makes it active, and what it has of its own.
fn pane_ui(ui: &mut Ui, state: &mut AppState, engine: &Engine, pane: usize, count: usize) {
    let name = state.document.scene.pane_name(pane);
    let (number, shown) = (pane + 1, engine.shown.contains(&pane));
    ui.horizontal(|ui| {
        if count > 1 {
            let reference = state.document.scene.reference_pane() == pane;
            let label = text!("picture-reference-pane", number = number);
            let mark = Button::selectable(reference, if reference { "◆" } else { "◇" });
            let response = ui.add(mark.frame(false)).on_hover_text(&label);
            if focus::switch_named(response, Role::RadioButton, reference, &label).clicked() {
                state.ask(Action::Reference(pane));
            }
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if count > 1 {
                let label = text!("picture-pane-menu", number = number);
                let menu = ui.menu_button("⋯", |ui| menu_ui(ui, state, pane));
                focus::named(menu.response, Role::Button, &label).on_hover_text(&label);
            }
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                let button = ui.add_enabled(
                    shown,
                    Button::selectable(
                        state.panes.active == pane && shown,
                        format!("{number} {name}"),
                    )
                    .truncate(),
                );
                if button
                    .on_hover_text(text!("picture-activate-tip"))
                    .clicked()
                {
                    state.ask(Action::Activate(pane));
                }
            });
        });
    });
    let Some(own) = pane
        .checked_sub(1)
        .and_then(|index| state.document.scene.compare.panes.get_mut(index))
    else {
        return;
    };
    let mut released = None;
    ui.horizontal_wrapped(|ui| {
        ui.add_space(26.0);
        for (index, setting) in own.set.iter().enumerate() {
            let key = setting.split('=').next().unwrap_or(setting);
            if ui
                .add(Button::new(format!("{}  ×", setting_words(setting))).small())
                .on_hover_text(text!("picture-release-setting", key = key))
                .clicked()
            {
                released = Some(index);
            }
        }
    });
    if let Some(index) = released {
        own.set.remove(index);
    }
}

/// What a new pane may be, by one click, and any key by typing.
fn add_ui(ui: &mut Ui, typed: &mut Typed, state: &mut AppState) {
    ui.set_min_width(250.0);
    let scene = &state.shown.scene;
    let mut chosen = None;
    for (parameter, key) in [
        (&MODE, "picture-add-shading"),
        (&INTERPOLATION, "picture-add-interpolation"),
    ] {
        let present = parameter.value(scene, 0);
        for option in parameter.options() {
            let ChoiceOption { word, .. } = option;
            let other = present.as_ref().and_then(toml::Value::as_str) != Some(*word);
            if other && ui.button(text!(key, name = option.label())).clicked() {
                chosen = Some(vec![format!("{}={word}", parameter.key)]);
            }
        }
        ui.separator();
    }
    if finer(scene).is_some() && ui.button(text!("picture-add-finer")).clicked() {
        chosen = finer(scene);
    }
    if ui
        .button(text!("picture-add-same"))
        .on_hover_text(text!("picture-add-same.tip"))
        .clicked()
    {
        chosen = Some(vec![]);
    }
    ui.separator();
    ui.label(text!("picture-add-setting"));
    ui.horizontal(|ui| {
        let field = text_field(&mut typed.setting)
            .hint_text("material.n=1005")
            .desired_width(170.0);
        let entered = ui.add(field).lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        if ui.button(text!("picture-add")).clicked() || entered {
            let setting = typed.setting.trim().to_owned();
            match scene.with_override(&setting) {
                Ok(_) => chosen = Some(vec![setting]),
                Err(error) => typed.problem = Some(error.to_string()),
            }
        }
    });
    if let Some(problem) = &typed.problem {
        ui.label(RichText::new(problem).color(ui.visuals().error_fg_color));
    }
    if let Some(set) = chosen {
        *typed = Typed::default();
        // The last pane may be the reference because it is the last.
        let scene = &mut state.document.scene;
        let (alone, reference) = (scene.compare.panes.is_empty(), scene.reference_pane());
        scene.compare.panes.push(Pane {
            name: String::new(),
            set,
        });
        if !alone {
            scene.set_reference(reference);
        }
        if scene.compare.view == CompareView::Single {
            scene.compare.view = CompareView::Panes;
        }
        ui.close();
    }
}

/// The same object of more polygons, where that is possible.
fn finer(scene: &Scene) -> Option<Vec<String>> {
    let Object {
        segments, rings, ..
    } = scene.object;
    let settings = vec![
        format!("object.segments={}", 4 * segments),
        format!("object.rings={}", 4 * rings),
    ];
    scene.with_overrides(&settings).is_ok().then_some(settings)
}

/// How far each pane is from the reference.
fn figures_ui(ui: &mut Ui, state: &mut AppState, engine: &Engine) {
    let figures = &engine.figures;
    let reference = figures.iter().find(|one| one.error.is_none());
    let (Some(reference), true) = (reference, figures.len() > 1) else {
        return;
    };
    ui.label(RichText::new(text!("picture-against", name = reference.name.as_str())).strong());
    let mut view = ReportView::default();
    let scene = &state.document.scene;
    view.set(Comparison(figures.to_vec()).report(&analysis::ReportContext { name: "", scene }));
    view.ui(ui);
    let size = engine.size;
    ui.horizontal_wrapped(|ui| {
        for one in figures {
            let Some([x, y]) = one.error.and_then(|error| error.at) else {
                continue;
            };
            let tip = text!("picture-greatest-tip", name = one.name.as_str());
            if ui
                .link(text!("picture-pixel", x = x, y = y))
                .on_hover_text(tip)
                .clicked()
            {
                state.probe = ProbePoint::at([x, y], size);
            }
        }
    });
    let state_scene = state.document.scene.clone();
    export_ui(ui, state, "compare", || {
        let image = engine.drawn()?.image.clone();
        let scene = Scene {
            image,
            ..state_scene
        };
        Some((Box::new(Comparison(figures.to_vec())), scene))
    });
}

impl AppState {
    /// Shows the panes in another way; where there are none, beside the exact picture.
    pub fn compare(&mut self, view: CompareView) {
        let exact = self.shown.scene.shading.mode == ShadingMode::Exact;
        let compare = &mut self.document.scene.compare;
        if view != CompareView::Single && compare.panes.is_empty() {
            let other = if exact {
                "shading.mode=phong"
            } else {
                "shading.mode=exact"
            };
            compare.panes.push(Pane::of(&[other]));
            compare.reference = 0;
        }
        compare.view = view;
    }

    /// Changes which panes there are; pane `active` is the active one afterwards.
    pub fn rearrange(
        &mut self,
        active: usize,
        change: impl Fn(&mut Scene) -> Result<(), SceneError>,
    ) {
        self.commit();
        match change(&mut self.document.scene) {
            Ok(()) => {
                self.panes.active = active;
                // What resetting returns to goes with its pane.
                let count = self.document.scene.pane_count();
                let mut opened = self.opened.clone();
                if change(&mut opened).is_ok() && opened.pane_count() == count {
                    self.opened = opened;
                }
                self.derive();
                self.take_opened();
            }
            Err(error) => self.notice = error.problems().first().map(ToString::to_string),
        }
    }

    /// The way to compare after the present one.
    pub fn next_comparison(&self) -> CompareView {
        let present = self.document.scene.compare.view;
        let place = VIEWS
            .iter()
            .position(|(view, ..)| *view == present)
            .unwrap_or(0);
        VIEWS[(place + 1) % VIEWS.len()].0
    }
}
