//! The equation filled in with the numbers of the probe.

use super::probed;
use crate::common::hands::{enter, folded, press, scene, window};
use eframe::egui::Key;
use eframe::egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::{AccessKitNode, NodeT, Queryable};
use shading_lab::app::App;

/// A line of the filled-in equation that begins with `name`, without it.
fn line_of(harness: &Harness<'_, App>, name: &str) -> String {
    // A screen reader has the words of a label as its value.
    let text = |node: &AccessKitNode<'_>| node.label().or_else(|| node.value()).unwrap_or_default();
    let node = harness.get_by(|node| text(node).starts_with(name));
    text(&node.accesskit_node())[name.len()..].to_owned()
}

fn parsed(text: &str) -> f64 {
    text.trim()
        .replace('−', "-")
        .replace("×10⁻⁵", "e-5")
        .parse()
        .expect("a number")
}

#[test]
fn the_equation_is_filled_in_with_the_numbers_of_the_probe() {
    let harness = window("teapot");
    let (hit, material) = (probed(&harness), &scene(&harness).material);
    let terms = [
        ("ambient", hit.ambient),
        ("diffuse 1", hit.lights[0].diffuse),
    ];
    for (channel, name) in ["red", "green", "blue"].into_iter().enumerate() {
        for (term, value) in terms {
            let line = line_of(&harness, &format!("{term} {name}: "));
            let (product, shown) = line.split_once(" = ").expect("a product");
            assert!(
                (parsed(shown) - value[channel]).abs() < 6e-5,
                "{term} {name}: {line}"
            );
            let multiplied: f64 = product.split(" · ").map(parsed).product();
            assert!(
                (multiplied / value[channel] - 1.0).abs() < 2e-3,
                "{term} {name}: {line}"
            );
            assert!(
                product.contains(&format!("{:.2}", material.color[channel])),
                "Od stands in {line}"
            );
        }
    }
    let [r, g, b] = hit.sum.to_array();
    assert_eq!(
        line_of(&harness, "I 0."),
        format!("{r:.4} red, {g:.4} green, {b:.4} blue")[2..]
    );
    let [r, g, b] = hit.stored;
    assert_eq!(
        line_of(&harness, "stored "),
        format!("{r} red, {g} green, {b} blue")
    );
    assert!(
        harness
            .query_by_label_contains("transparency red")
            .is_none(),
        "the teapot is opaque"
    );
}

#[test]
fn a_silent_light_is_named_with_the_reason() {
    let mut harness = window("three-lights");
    let says = |harness: &Harness<'_, App>, light: &str| {
        line_of(harness, &format!("light {light} at the probe: "))
    };
    assert!(says(&harness, "1").ends_with("blue"));
    press(&mut harness, "Mute light 1");
    assert_eq!(says(&harness, "1"), "muted");
    assert!(
        harness
            .query_by_label_contains("It adds nothing: it is muted")
            .is_some(),
        "the chosen light is unfolded"
    );
    press(&mut harness, "Light 2");
    press(&mut harness, "Solo light 2");
    assert_eq!(
        (says(&harness, "1"), says(&harness, "3")),
        ("muted".into(), "not soloed".into())
    );
    let [r, g, b] =
        (probed(&harness).lights[1].diffuse + probed(&harness).lights[1].specular).to_array();
    assert_eq!(
        says(&harness, "2"),
        format!("{r:.4} red, {g:.4} green, {b:.4} blue")
    );
}

#[test]
fn a_light_that_nothing_reflects_is_not_said_to_be_in_shadow() {
    let mut harness = window("sphere");
    for name in ["Kd diffuse coefficient", "Ks specular coefficient"] {
        enter(&mut harness, name, 0.0);
    }
    let line = line_of(&harness, "light 1 at the probe: ");
    assert!(!line.contains("shadow"), "{line}");
    assert!(
        harness
            .query_by_label_contains("blocks the light")
            .is_none()
    );
    assert_eq!(line, "not reflected");
}

#[test]
fn the_mixture_with_transmitted_light_is_filled_in_where_there_is_any() {
    let harness = window("glass-ball");
    let hit = probed(&harness);
    let through = hit.transmission.expect("glass");
    let line = line_of(&harness, "transparency green: ");
    assert!(
        line.starts_with(&format!("0.15 · {:.3} + 0.85 · ", hit.reflected.y)),
        "{line}"
    );
    assert!(line.ends_with(&format!(" = {:.4}", hit.sum.y)), "{line}");
    assert!(
        line_of(&harness, "transparency at the probe: ")
            .starts_with(&through.refractions.to_string())
    );
    for opaque in ["sphere", "gold"] {
        assert!(
            folded(opaque)
                .query_by_label_contains("transparency")
                .is_none(),
            "{opaque}"
        );
    }
}

#[test]
fn lights_unfold_by_keyboard_and_their_symbols_lead_to_their_controls() {
    let mut harness = window("three-lights");
    let rows = |harness: &Harness<'_, App>, light: u32| {
        harness
            .query_by_label_contains(&format!("diffuse {light} red: "))
            .is_some()
    };
    assert!(
        rows(&harness, 1) && !rows(&harness, 2),
        "the chosen light is unfolded, the others are not"
    );
    harness
        .get_by(|node| {
            node.label()
                .is_some_and(|label| label.starts_with("light 2 at the"))
        })
        .focus();
    harness.run();
    harness.key_press(Key::Enter);
    harness.run();
    assert!(rows(&harness, 1) && rows(&harness, 2));
    let count = harness
        .query_all_by_role_and_label(Role::Button, "Kd at the probe")
        .count();
    assert_eq!(count, 2, "a symbol stands in each light's terms");
    let second = harness
        .query_all_by_role_and_label(Role::Button, "Ip at the probe")
        .nth(2)
        .expect("light 2");
    second.click_accesskit();
    harness.run();
    assert_eq!(
        harness.state().state().session.light,
        1,
        "Ip of light 2 leads to the controls of light 2"
    );
    assert!(
        harness
            .query_by_role_and_label(Role::ComboBox, "Light 2 kind")
            .is_some()
    );
    assert!(
        rows(&harness, 2) && !rows(&harness, 1),
        "another light has been chosen"
    );
}

#[test]
fn every_way_of_evaluating_fills_the_equation_in() {
    let mut harness = window("soft-shadow");
    assert!(
        harness
            .query_by_label_contains("Evaluated at 64 points of the light")
            .is_some()
    );
    for key in [Key::Num1, Key::Num2, Key::Num3] {
        harness.key_press(key);
        harness.run();
        let (line, value) = (
            line_of(&harness, "diffuse 1 red: "),
            probed(&harness).lights[0].diffuse.x,
        );
        let (_, shown) = line.split_once(" = ").expect("a product");
        assert!((parsed(shown) - value).abs() < 6e-5, "{line}, {value}");
    }
}
