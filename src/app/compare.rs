//! The tab of comparisons: how panes are shown, what each has of its own, and how far they are from each other.

use super::action::Action;
use super::engine::Engine;
use super::place::ProbePoint;
use super::report::{ReportView, export_ui};
use super::row::parameter;
use super::state::AppState;
use crate::analysis::{self, Answer, Comparison};
use crate::scene::compare::{DIFFERENCE, GAIN};
use crate::scene::shading::{INTERPOLATION, MODE};
use crate::scene::{
    ChoiceOption, Compare, CompareView, Object, Pane, Scene, ShadingMode, setting_words,
};
use eframe::egui::accesskit::Role;
use eframe::egui::{Align, Button, Key, Layout, RichText, TextEdit, Ui, WidgetInfo};

/// The views with their names.
pub const VIEWS: [(CompareView, &str, &str); 4] = [
    (CompareView::Single, "One", "The scene alone"),
    (
        CompareView::Panes,
        "Panes",
        "Side by side, with one camera and one probe",
    ),
    (
        CompareView::Wipe,
        "Wipe",
        "The first pane and the last on either side of a line to drag",
    ),
    (
        CompareView::Difference,
        "Difference",
        "The first pane less the last",
    ),
];

/// What is typed in the tab.
#[derive(Debug, Default)]
pub struct Typed {
    setting: String,
    /// What is wrong with it.
    problem: Option<String>,
}

/// The comparison's tab.
pub fn compare_ui(ui: &mut Ui, typed: &mut Typed, state: &mut AppState, engine: &Engine) {
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        for (view, name, tip) in VIEWS {
            let chosen = state.document.scene.compare.view == view;
            if ui
                .add(Button::selectable(chosen, name))
                .on_hover_text(tip)
                .clicked()
            {
                state.ask(Action::Compare(view));
            }
        }
    });
    if state.document.scene.compare.panes.is_empty() {
        ui.add_space(4.0);
        ui.label("Nothing is compared yet. Choose a view above, or add a pane that shows the scene in another way:");
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
    ui.add_space(6.0);
    if count <= Compare::MAX_PANES {
        ui.menu_button("Add a pane…", |ui| add_ui(ui, typed, state));
    }
    if count > 1 {
        let tip = "Otherwise a change concerns all panes, except for what a pane has of its own";
        ui.checkbox(&mut state.panes.own, "Changes concern the active pane only")
            .on_hover_text(tip);
    }
    ui.add_space(8.0);
    figures_ui(ui, state, engine);
}

/// A pane: its name, which makes it active, and what it has of its own.
fn pane_ui(ui: &mut Ui, state: &mut AppState, engine: &Engine, pane: usize, count: usize) {
    let name = state.document.scene.pane_name(pane);
    let shown = engine.shown.contains(&pane);
    ui.horizontal(|ui| {
        let text = format!("{} {name}", pane + 1);
        let button = ui.add_enabled(
            shown,
            Button::selectable(state.panes.active == pane && shown, text).truncate(),
        );
        if button
            .on_hover_text("The controls show this pane")
            .clicked()
        {
            state.ask(Action::Activate(pane));
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let removed = pane > 0 && {
                let name = format!("Removes pane {}", pane + 1);
                let response = ui.add(Button::new("×").frame(false)).on_hover_text(&name);
                let enabled = ui.is_enabled();
                response.widget_info(|| WidgetInfo::labeled(Role::Button, enabled, &name));
                response.clicked()
            };
            if removed {
                state.document.scene.compare.panes.remove(pane - 1);
                if state.document.scene.compare.panes.is_empty() {
                    state.document.scene.compare.view = CompareView::Single;
                }
            }
            if pane + 1 == count && count > 1 {
                ui.label(RichText::new("reference").weak())
                    .on_hover_text("The others are measured against this pane");
            }
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
        ui.add_space(18.0);
        for (index, setting) in own.set.iter().enumerate() {
            let tip = format!(
                "Lets {} follow the first pane again",
                setting.split('=').next().unwrap_or(setting)
            );
            if ui
                .add(Button::new(format!("{}  ×", setting_words(setting))).small())
                .on_hover_text(tip)
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
    for (parameter, what) in [(&MODE, "shading"), (&INTERPOLATION, "interpolation")] {
        let present = parameter.value(scene, 0);
        for option in parameter.options() {
            let ChoiceOption { word, .. } = option;
            let other = present.as_ref().and_then(toml::Value::as_str) != Some(*word);
            if other && ui.button(format!("{} {what}", option.label())).clicked() {
                chosen = Some(vec![format!("{}={word}", parameter.key)]);
            }
        }
        ui.separator();
    }
    if finer(scene).is_some() && ui.button("Four times as many polygons each way").clicked() {
        chosen = finer(scene);
    }
    if ui
        .button("The same")
        .on_hover_text("To change afterwards, alone")
        .clicked()
    {
        chosen = Some(vec![]);
    }
    ui.separator();
    ui.horizontal(|ui| {
        let field = TextEdit::singleline(&mut typed.setting)
            .hint_text("material.n=1005")
            .desired_width(170.0);
        let entered = ui.add(field).lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        if ui.button("Add").clicked() || entered {
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
        let compare = &mut state.document.scene.compare;
        compare.panes.push(Pane {
            name: String::new(),
            set,
        });
        if compare.view == CompareView::Single {
            compare.view = CompareView::Panes;
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

/// How far each pane is from the last one.
fn figures_ui(ui: &mut Ui, state: &mut AppState, engine: &Engine) {
    let figures = &engine.figures;
    let (Some(reference), true) = (figures.last(), figures.len() > 1) else {
        return;
    };
    ui.label(RichText::new(format!("Against {}", reference.name)).strong());
    let mut view = ReportView::default();
    view.set(Comparison(figures.to_vec()).report(&analysis::About {
        name: "",
        scene: &state.document.scene,
    }));
    view.ui(ui);
    let size = engine.size;
    for one in figures {
        let Some([x, y]) = one.error.and_then(|error| error.at) else {
            continue;
        };
        let tip = format!("Puts the probe where {} differs most", one.name);
        if ui
            .link(format!("pixel {x}, {y}"))
            .on_hover_text(tip)
            .clicked()
        {
            state.probe = ProbePoint::at([x, y], size);
        }
    }
    export_ui(ui, state, "compare", || {
        Some((
            Box::new(Comparison(figures.to_vec())),
            engine.drawn()?.clone(),
        ))
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
        }
        compare.view = view;
    }

    /// The view after the present one.
    pub fn next_view(&self) -> CompareView {
        let present = self.document.scene.compare.view;
        let place = VIEWS
            .iter()
            .position(|(view, ..)| *view == present)
            .unwrap_or(0);
        VIEWS[(place + 1) % VIEWS.len()].0
    }
}
