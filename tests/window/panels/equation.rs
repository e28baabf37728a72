//! The equation filled in with the numbers of the probe.

use super::probed;
use crate::common::hands::{enter, folded, named, press, scene, window};
use eframe::egui::Key;
use eframe::egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::{AccessKitNode, NodeT, Queryable};
use shading_lab::app::App;

/// Returns the rest of a line of the filled-in equation that begins with `name`.
fn line_of(harness: &Harness<'_, App>, name: &str) -> String {
    // A screen reader reports the words of a label as its value.
    let text = |node: &AccessKitNode<'_>| node.label().or_else(|| node.value()).unwrap_or_default();
    let node = harness.get_by(|node| text(node).starts_with(name));
    text(&node.accesskit_node())[name.len()..].to_owned()
}

const CHANNELS: [&str; 3] = ["point-red", "point-green", "point-blue"];

fn channels([red, green, blue]: [String; 3]) -> String {
    english!("point-channels", red = red, green = green, blue = blue)
}

fn diffuse(light: u32) -> String {
    format!("{} {light}", english!("point-diffuse"))
}

fn transparency(channel: usize) -> String {
    let transparency = english!("point-transparency");
    format!("{transparency} {}", named(CHANNELS[channel]))
}

/// Returns the beginning of the line that unfolds to the parts of a term.
fn at_probe(name: &str) -> String {
    english!("point-line-at-probe", name = name, value = "")
}

fn light_line(harness: &Harness<'_, App>, light: u32) -> String {
    line_of(harness, &at_probe(&english!("point-light", number = light)))
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
        (english!("point-ambient").to_owned(), hit.ambient),
        (diffuse(1), hit.lights[0].diffuse),
    ];
    for (channel, name) in CHANNELS.map(named).iter().enumerate() {
        for (term, value) in &terms {
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
        channels([r, g, b].map(|value| format!("{value:.4}")))[2..]
    );
    let [r, g, b] = hit.stored;
    assert_eq!(
        line_of(&harness, &format!("{} ", english!("point-stored"))),
        channels([r, g, b].map(|value| value.to_string()))
    );
    assert!(
        harness.query_by_label_contains(&transparency(0)).is_none(),
        "the teapot is opaque"
    );
}

#[test]
fn a_silent_light_is_named_with_the_reason() {
    let mut harness = window("three-lights");
    let says = |harness: &Harness<'_, App>, light: u32| light_line(harness, light);
    let muted = english!("point-zero-muted");
    assert_ne!(says(&harness, 1), muted);
    press(&mut harness, &english!("lights-mute.name", number = 1));
    assert_eq!(says(&harness, 1), muted);
    assert!(
        harness
            .query_by_label_contains(english!("point-zero-muted.why"))
            .is_some(),
        "the chosen light is unfolded"
    );
    press(&mut harness, &english!("lights-number", number = 2));
    press(&mut harness, &english!("lights-solo.name", number = 2));
    assert_eq!(
        (&*says(&harness, 1), &*says(&harness, 3)),
        (muted, english!("point-zero-not-soloed"))
    );
    let [r, g, b] =
        (probed(&harness).lights[1].diffuse + probed(&harness).lights[1].specular).to_array();
    assert_eq!(
        says(&harness, 2),
        channels([r, g, b].map(|value| format!("{value:.4}")))
    );
}

#[test]
fn a_light_that_nothing_reflects_is_not_said_to_be_in_shadow() {
    let mut harness = window("sphere");
    for name in ["material.kd", "material.ks"] {
        enter(&mut harness, name, 0.0);
    }
    let line = light_line(&harness, 1);
    assert!(
        harness
            .query_by_label_contains(english!("point-zero-in-shadow.why"))
            .is_none()
    );
    assert_eq!(line, english!("point-zero-not-reflected"));
}

#[test]
fn the_mixture_with_transmitted_light_is_filled_in_where_there_is_any() {
    let harness = window("glass-ball");
    let hit = probed(&harness);
    let through = hit.transmission.expect("glass");
    let line = line_of(&harness, &format!("{}: ", transparency(1)));
    assert!(
        line.starts_with(&format!("0.15 · {:.3} + 0.85 · ", hit.reflected.y)),
        "{line}"
    );
    assert!(line.ends_with(&format!(" = {:.4}", hit.sum.y)), "{line}");
    assert!(
        line_of(&harness, &at_probe(english!("point-transparency")))
            .starts_with(&through.refractions.to_string())
    );
    for opaque in ["sphere", "gold"] {
        assert!(
            folded(opaque)
                .query_by_label_contains(english!("point-transparency"))
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
            .query_by_label_contains(&format!("{} {}: ", diffuse(light), named(CHANNELS[0])))
            .is_some()
    };
    assert!(
        rows(&harness, 1) && !rows(&harness, 2),
        "the chosen light is unfolded, the others are not"
    );
    harness
        .get_by(|node| {
            node.label().is_some_and(|label| {
                label.starts_with(&at_probe(&english!("point-light", number = 2)))
            })
        })
        .focus();
    harness.run();
    harness.key_press(Key::Enter);
    harness.run();
    assert!(rows(&harness, 1) && rows(&harness, 2));
    let here = english!("point-at-probe");
    let count = harness
        .query_all_by_role_and_label(Role::Button, &format!("Kd {here}"))
        .count();
    assert_eq!(count, 2, "a symbol stands in each light's terms");
    let symbol = format!("Ip {here}");
    let second = harness
        .query_all_by_role_and_label(Role::Button, &symbol)
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
            .query_by_role_and_label(Role::ComboBox, named("light.1.kind"))
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
            .query_by_label_contains(&english!("point-over-samples", count = 64))
            .is_some()
    );
    for key in [Key::Num1, Key::Num2, Key::Num3] {
        harness.key_press(key);
        harness.run();
        let (line, value) = (
            line_of(
                &harness,
                &format!("{} {}: ", diffuse(1), named(CHANNELS[0])),
            ),
            probed(&harness).lights[0].diffuse.x,
        );
        let (_, shown) = line.split_once(" = ").expect("a product");
        assert!((parsed(shown) - value).abs() < 6e-5, "{line}, {value}");
    }
}
