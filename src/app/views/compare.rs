//! The view of comparisons: the arrangement of the panes, the settings of each, and their differences.

use super::report::{ReportView, export_ui};
use crate::analysis::comparison::Comparison;
use crate::analysis::{self, Answer};
use crate::app::controls::row::parameter;
use crate::app::engine::Engine;
use crate::app::session::Session;
use crate::app::session::action::{Action, Requests};
use crate::app::session::place::ProbePoint;
use crate::app::session::window::WindowState;
use crate::app::widgets::focus;
use crate::app::widgets::theme::text_field;
use crate::scene::compare::{DIFFERENCE, GAIN};
use crate::scene::shading::{INTERPOLATION, MODE};
use crate::scene::{
    Choice as _, ChoiceOption, Compare, CompareView, Object, Pane, Scene, ShadingMode,
    setting_words,
};
use crate::text;
use eframe::egui::accesskit::Role;
use eframe::egui::{Align, Button, Key, Layout, RichText, Ui};

/// The arrangements of panes, with the keys of their names and descriptions.
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

/// Width from which the panes are beside their figures, in points.
const WIDE: f32 = 640.0;

/// Input typed in the view.
#[derive(Debug, Default)]
pub struct Typed {
    setting: String,
    /// Reason why the setting is refused.
    problem: Option<String>,
}

/// Shows the view of comparisons.
pub fn compare_ui(
    ui: &mut Ui,
    typed: &mut Typed,
    session: &mut Session,
    window: &mut WindowState,
    requests: &mut Requests,
    engine: &Engine,
) {
    if ui.available_width() < WIDE {
        views_ui(ui, typed, session, requests, engine);
        ui.add_space(8.0);
        figures_ui(ui, session, window, requests, engine);
        return;
    }
    ui.columns(2, |columns| {
        columns[0].vertical(|ui| views_ui(ui, typed, session, requests, engine));
        columns[1].vertical(|ui| figures_ui(ui, session, window, requests, engine));
    });
}

/// Shows the arrangements of panes to choose from, and the list of panes.
fn views_ui(
    ui: &mut Ui,
    typed: &mut Typed,
    session: &mut Session,
    requests: &mut Requests,
    engine: &Engine,
) {
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        for (view, name, tip) in VIEWS {
            let chosen = session.document().scene.compare.view == view;
            if ui
                .add(Button::selectable(chosen, text!(name)))
                .on_hover_text(text!(tip))
                .clicked()
            {
                requests.ask(Action::Compare(view));
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
            requests.ask(Action::AllModes);
        }
        let full = session.document().scene.compare.panes.len() >= Compare::MAX_PANES;
        let most = text!("picture-panes-full", count = Compare::MAX_PANES + 1);
        ui.add_enabled_ui(!full, |ui| {
            ui.menu_button(text!("picture-add-pane"), |ui| add_ui(ui, typed, session))
                .response
        })
        .inner
        .on_disabled_hover_text(most);
    });
    if session.document().scene.compare.panes.is_empty() {
        ui.add_space(4.0);
        ui.label(text!("picture-compare-empty"));
    }
    if session.document().scene.compare.view == CompareView::Difference {
        ui.add_space(4.0);
        session.edit(|scene, initial| {
            parameter(ui, initial, scene, &DIFFERENCE);
            parameter(ui, initial, scene, &GAIN);
        });
    }
    ui.add_space(6.0);
    let count = session.document().scene.pane_count();
    for pane in 0..count {
        pane_ui(ui, session, requests, engine, pane, count);
    }
    if count > 1 {
        ui.add_space(6.0);
        ui.checkbox(&mut session.panes.own, text!("picture-own-changes"))
            .on_hover_text(text!("picture-own-changes.tip"));
    }
}

/// Shows a pane: whether it is the reference, its name, which makes it active, and its own settings.
fn pane_ui(
    ui: &mut Ui,
    session: &mut Session,
    requests: &mut Requests,
    engine: &Engine,
    pane: usize,
    count: usize,
) {
    let name = session.document().scene.pane_name(pane);
    let (number, shown) = (pane + 1, engine.shown.contains(&pane));
    ui.horizontal(|ui| {
        if count > 1 {
            let reference = session.document().scene.reference_pane() == pane;
            let label = text!("picture-reference-pane", number = number);
            let mark = RichText::new(if reference { "◆" } else { "◇" });
            let mark = Button::selectable(reference, mark.color(ui.visuals().text_color()));
            let response = ui.add(mark.frame(false)).on_hover_text(&label);
            if focus::switch_named(response, Role::RadioButton, reference, &label).clicked() {
                requests.ask(Action::Reference(pane));
            }
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if count > 1 {
                let label = text!("picture-pane-menu", number = number);
                let menu = ui.menu_button("⋯", |ui| menu_ui(ui, session, requests, pane));
                focus::named(menu.response, Role::Button, &label).on_hover_text(&label);
            }
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                let active = session.panes.active == pane && shown;
                let button = Button::selectable(active, format!("{number} {name}"));
                let button = ui.add_enabled(shown, button.truncate());
                if button
                    .on_hover_text(text!("picture-activate-tip"))
                    .clicked()
                {
                    requests.ask(Action::Activate(pane));
                }
            });
        });
    });
    let Some(place) = pane.checked_sub(1) else {
        return;
    };
    let Some(own) = session.document().scene.compare.panes.get(place) else {
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
        session.edit(|scene, _| _ = scene.compare.panes[place].set.remove(index));
    }
}

/// Shows settings that a new pane can have by one click, and a field for any key.
fn add_ui(ui: &mut Ui, typed: &mut Typed, session: &mut Session) {
    ui.set_min_width(250.0);
    let scene = &session.shown.scene;
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
        // The last pane may be the reference only because it is the last.
        session.edit(|scene, _| {
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
        });
        ui.close();
    }
}

/// Returns settings for the same object with more polygons, if they are valid.
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

/// Shows how far each pane is from the reference.
fn figures_ui(
    ui: &mut Ui,
    session: &mut Session,
    window: &mut WindowState,
    requests: &mut Requests,
    engine: &Engine,
) {
    let figures = &engine.figures;
    let reference = figures.iter().find(|one| one.error.is_none());
    let (Some(reference), true) = (reference, figures.len() > 1) else {
        return;
    };
    ui.label(RichText::new(text!("picture-against", name = reference.name.as_str())).strong());
    let mut view = ReportView::default();
    let scene = &session.document().scene;
    view.set(Comparison(figures.to_vec()).report(&analysis::ReportContext { name: "", scene }));
    view.ui(ui);
    let size = engine.size;
    ui.horizontal_wrapped(|ui| {
        for one in figures {
            let Some([x, y]) = one.error.and_then(|error| error.at) else {
                continue;
            };
            let place = text!("picture-greatest", name = one.name.as_str(), x = x, y = y);
            if ui
                .link(place)
                .on_hover_text(text!("picture-greatest.tip"))
                .clicked()
            {
                window.probe = ProbePoint::at([x, y], size);
            }
        }
    });
    let state_scene = session.document().scene.clone();
    export_ui(ui, session, window, requests, "compare", || {
        let image = engine.drawn()?.image.clone();
        let scene = Scene {
            image,
            ..state_scene
        };
        Some((Box::new(Comparison(figures.to_vec())), scene))
    });
}

/// Shows the shading modes of a pane, and the actions for it.
pub fn menu_ui(ui: &mut Ui, session: &Session, requests: &mut Requests, pane: usize) {
    let scene = &session.document().scene;
    let (last, reference) = (scene.pane_count() - 1, scene.reference_pane());
    let present = session.panes.scene(pane).shading.mode;
    for &mode in ShadingMode::VALUES {
        if ui.radio(mode == present, mode.label()).clicked() {
            let renormalise = true;
            requests.ask(Action::Activate(pane));
            requests.ask(Action::Shade { mode, renormalise });
            ui.close();
        }
    }
    ui.separator();
    let mut asked = None;
    let mut item = |enabled: bool, text: &str, action: Action| {
        let button = Button::new(text);
        if ui.add_enabled(enabled, button).clicked() {
            asked = Some(action);
            ui.close();
        }
    };
    item(
        pane != reference,
        text!("picture-make-reference"),
        Action::Reference(pane),
    );
    item(
        pane > 0,
        text!("picture-move-earlier"),
        Action::MovePane(pane, pane.saturating_sub(1)),
    );
    item(
        pane < last,
        text!("picture-move-later"),
        Action::MovePane(pane, pane + 1),
    );
    item(
        last > 0,
        text!("picture-remove-pane"),
        Action::RemovePane(pane),
    );
    requests.extend(asked);
}
