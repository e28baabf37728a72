//! Every claim of the window is true at every moment: after random commands, with undo and redo among them, the text on the
//! screen is compared with the scene.

use crate::common::dice::Dice;
use crate::common::hands::{built_in, named, settle, window_looking};
use eframe::egui::accesskit::{Role, Toggled};
use eframe::egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use shading_lab::app::{App, Appearance, ViewName};
use shading_lab::geometry::built_in as built_in_model;
use shading_lab::scene::parameter::Parameter;
use shading_lab::scene::{Choice, CompareView, Scene};
use std::collections::BTreeSet;

/// Seeds, and commands of each.
const RUNS: u64 = 6;
const COMMANDS: u32 = 60;
/// Settings whose rows have a reset button while they differ from the scene as it was opened.
const RESET: [&str; 6] = [
    "shading.mode",
    "shading.shadows",
    "material.n",
    "material.kd",
    "ambient.color",
    "object.segments",
];

/// Returns the labels of all widgets of a role that are on.
fn labels(harness: &Harness<'_, App>, role: Role, on: bool) -> Vec<String> {
    let nodes = harness.query_all_by_role(role);
    let nodes = nodes.filter(|node| !on || node.accesskit_node().toggled() == Some(Toggled::True));
    nodes
        .filter_map(|node| node.accesskit_node().label())
        .collect()
}

/// Clicks a button, if there is one of this name that is enabled.
fn press(harness: &mut Harness<'_, App>, name: &str) {
    for button in harness.query_all_by_role(Role::Button) {
        let node = button.accesskit_node();
        if node.label().as_deref() == Some(name) && !node.is_disabled() {
            button.click_accesskit();
            break;
        }
    }
    harness.run_ok();
}

/// Does something at random, and returns what.
fn act(harness: &mut Harness<'_, App>, dice: &mut Dice) -> String {
    let key = |harness: &mut Harness<'_, App>, modifiers: Modifiers, key: Key| {
        harness.key_press_modifiers(modifiers, key);
        harness.run_ok();
        format!("{modifiers:?} {key:?}")
    };
    let (none, command) = (Modifiers::NONE, Modifiers::COMMAND);
    let lights = harness.state().state().session.shown.scene.lights.len();
    let light = 1 + (dice.unit() * lights as f64) as usize;
    match dice.unit() {
        p if p < 0.25 => key(harness, command, Key::Z),
        p if p < 0.35 => key(harness, command | Modifiers::SHIFT, Key::Z),
        p if p < 0.45 => {
            let digits = [Key::Num1, Key::Num2, Key::Num3, Key::Num4, Key::Num5];
            key(harness, none, dice.of(&digits))
        }
        p if p < 0.50 => key(harness, none, dice.of(&[Key::K, Key::K, Key::N])),
        p if p < 0.53 => key(harness, none, dice.of(&[Key::PageDown, Key::PageUp])),
        p if p < 0.57 => key(harness, none, Key::C),
        p if p < 0.67 => {
            let (name, value) = dice.of(&[
                ("material.n", 3.0),
                ("material.n", 200.0),
                ("material.kd", 0.3),
                ("object.segments", 12.0),
            ]);
            for field in harness.query_all_by_role(Role::SpinButton) {
                if field.accesskit_node().label().as_deref() == Some(named(name)) {
                    field.set_value_accesskit(value);
                    break;
                }
            }
            harness.run_ok();
            format!("{name} = {value}")
        }
        p => {
            let reset = english!("controls-reset", name = named(dice.of(&RESET)));
            let name = match p {
                p if p < 0.77 => english!("lights-add").to_owned(),
                p if p < 0.82 => english!("lights-duplicate").to_owned(),
                p if p < 0.90 => english!("lights-remove", number = light),
                p if p < 0.95 => english!("lights-number", number = light),
                _ => reset,
            };
            press(harness, &name);
            name
        }
    }
}

/// Returns a scene with the material whose rows are shown in place of its own: that of the model whose line is on.
fn as_edited(scene: &Scene, on: &[String]) -> Scene {
    let mut edited = scene.clone();
    let materials = built_in_model(scene.object.kind).map_or(&[][..], |model| &model.materials);
    if let Some(own) = materials.iter().find(|own| on.contains(&own.name)) {
        let shown = scene.object.material(&own.name, &own.face_material());
        shown.replace_in(&mut edited);
    }
    edited
}

/// Returns the claims on the screen that do not hold.
fn wrong(harness: &Harness<'_, App>) -> Vec<String> {
    let state = harness.state().state();
    let session = &state.session;
    let (shown, document) = (&session.shown.scene, &session.document().scene);
    let mut wrong = Vec::new();
    let mut claim = |holds: bool, what: String| {
        if !holds {
            wrong.push(what);
        }
    };
    let buttons = labels(harness, Role::Button, false);
    let on = labels(harness, Role::Button, true);
    let has = |name: &str| buttons.iter().any(|label| label == name);

    // The list of lights, and which of them is chosen.
    let count = shown.lights.len();
    for number in 1..=count + 3 {
        let listed = has(&english!("lights-remove", number = number));
        claim(
            listed == (number <= count),
            format!("light {number} is listed: {listed} of {count}"),
        );
        let chosen = shown.lights.get(number - 1).is_some_and(|light| {
            let name = match light.name.trim() {
                "" => english!("lights-number", number = number),
                name => english!("lights-named", number = number, name = name),
            };
            on.contains(&name)
        });
        let is_chosen = number <= count && session.light == number - 1;
        claim(
            chosen == is_chosen,
            format!("light {number} is chosen: {chosen}"),
        );
    }
    let says = |text: &str| harness.query_all_by_label(text).next().is_some();
    let none = says(english!("lights-none"));
    claim(none == (count == 0), format!("“there is no light”: {none}"));
    let duplicates = harness
        .query_all_by_role(Role::Button)
        .filter(|node| {
            node.accesskit_node().label().as_deref() == Some(english!("lights-duplicate"))
        })
        .any(|node| !node.accesskit_node().is_disabled());
    claim(
        duplicates == (count > 0),
        format!("duplicate: {duplicates}"),
    );

    // Which values differ from the scene as it was opened; of a model with materials, those of the chosen one.
    let (rows, opened) = (as_edited(shown, &on), as_edited(&session.initial, &on));
    for key in RESET {
        let Some((parameter, _)) = Parameter::of_key(key) else {
            panic!("{key}");
        };
        let differs = parameter.value(&rows, 0) != parameter.value(&opened, 0);
        let reset = has(&english!("controls-reset", name = named(key)));
        claim(reset == differs, format!("↺ at {key}: {reset}"));
    }

    // The shading mode, the titles and the names of panes.
    for (index, mode) in shading_lab::scene::ShadingMode::VALUES.iter().enumerate() {
        let lit = on.contains(&format!("{} {}", index + 1, mode.label()));
        claim(
            lit == (shown.shading.mode == *mode),
            format!("{mode:?} is lit: {lit}"),
        );
    }
    let picture = english!("picture-name", mode = shown.shading.mode.label());
    claim(
        labels(harness, Role::Image, false).contains(&picture),
        picture,
    );
    let title = session.document().title();
    claim(says(&title), format!("the title is {title}"));
    let name = session.document().origin.name();
    let starred = says(&format!("{name} *"));
    let differs = session.document() != session.saved();
    claim(starred == differs, format!("{name} is changed: {starred}"));
    if document.compare.view == CompareView::Panes {
        for pane in document.shown_panes() {
            let caption = english!(
                "picture-caption",
                number = pane + 1,
                name = document.pane_name(pane)
            );
            claim(has(&caption), caption);
        }
    }
    if state.window.shows(ViewName::Equation) && count > 1 {
        for light in 1..=count + 3 {
            let title = says(&english!("point-vectors-of", light = light));
            let chosen = session.light + 1 == light;
            claim(!title || chosen, format!("vectors of light {light}"));
        }
    }
    wrong
}

#[test]
fn every_claim_of_the_window_is_true_after_random_commands_with_undo_and_redo() {
    let stored = Appearance::default();
    let mut found = BTreeSet::new();
    for seed in 0..RUNS {
        let scene = ["three-lights", "sphere", "shading-modes"][seed as usize % 3];
        // High enough that every section is drawn.
        let size = [1280.0, 2100.0];
        let mut harness = window_looking(built_in(scene), size, &stored, |app| app);
        crate::common::hands::unfold_all(&mut harness);
        let mut dice = Dice(seed);
        let mut done = Vec::new();
        for _ in 0..COMMANDS {
            done.push(act(&mut harness, &mut dice));
            crate::common::hands::unfold_all(&mut harness);
            // Pictures that take long are waited for: their captions stand beside them.
            settle(&mut harness);
            for fault in wrong(&harness) {
                let last = done.iter().rev().take(4).cloned().collect::<Vec<_>>();
                found.insert(format!(
                    "{seed} {scene}: {fault}; after {}",
                    last.join(" ← ")
                ));
            }
        }
    }
    let list: Vec<_> = found.iter().take(20).cloned().collect();
    assert!(
        found.is_empty(),
        "{} false claims:\n{}",
        found.len(),
        list.join("\n")
    );
}
