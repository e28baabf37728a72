//! The window as a figure in another page: the picture and the controls that its link names.

use crate::common::hands::{built_in, named, scene, window_looking};
use eframe::egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use shading_lab::app::{App, Appearance};
use shading_lab::link::read;

fn figure(name: &str, size: [f32; 2], controls: &[&str]) -> Harness<'static, App> {
    let controls: Vec<String> = controls.iter().map(|&word| word.to_owned()).collect();
    // The window's own stored state does not affect the figure.
    let appearance = Appearance {
        projector: true,
        controls: false,
        ..Appearance::default()
    };
    window_looking(built_in(name), size, &appearance, |app| {
        app.embedded(&controls)
    })
}

#[test]
fn a_figure_has_its_picture_and_the_controls_named() {
    for size in [[340.0, 360.0], [480.0, 420.0], [900.0, 600.0]] {
        let words = ["n", "material.ks", "light", "mode", "nothing"];
        let mut harness = figure("sphere", size, &words);
        let fields = |key: &str, role: Role| {
            harness
                .query_all_by_role_and_label(role, named(key))
                .count()
        };
        assert_eq!(fields("material.n", Role::Slider), 1, "{size:?}");
        assert_eq!(fields("material.ks", Role::Slider), 1);
        assert_eq!(fields("material.kd", Role::Slider), 0);
        assert_eq!(harness.query_all_by_role(Role::Tab).count(), 0, "no rail");
        assert!(
            harness
                .query_by_label(&english!("embed-unknown", name = "nothing"))
                .is_some()
        );
        let picture = harness.get_by_role(Role::Image).rect();
        assert!(picture.width() >= size[0] - 1.0, "{picture:?}");
        assert!(picture.height() >= 0.3 * size[1], "{picture:?}");
        harness
            .get_by_role_and_label(Role::Slider, named("material.n"))
            .set_value_accesskit(5.0);
        harness.run_ok();
        assert_eq!(scene(&harness).material.n, 5.0);
    }
}

#[test]
fn a_figure_without_controls_is_its_picture() {
    let harness = figure("torus", [400.0, 300.0], &[]);
    let picture = harness.get_by_role(Role::Image).rect();
    assert!(picture.height() > 230.0, "{picture:?}");
    assert_eq!(harness.query_all_by_role(Role::Slider).count(), 0);
}

#[test]
fn the_figures_of_the_example_work() {
    let notes = include_str!("../../docs/embedding.html");
    let links: Vec<String> = notes
        .split("src=\"./")
        .skip(1)
        .filter_map(|rest| rest.split('"').next())
        .map(|link| link.replace("&amp;", "&"))
        .collect();
    assert_eq!(links.len(), 3);
    for link in links {
        let shown = read(&link).expect("a link").shown;
        assert!(shown.embed && !shown.controls.is_empty());
        let words: Vec<&str> = shown.controls.iter().map(String::as_str).collect();
        let harness = figure(&link, [600.0, 432.0], &words);
        for word in words {
            let missing = english!("embed-unknown", name = word);
            assert!(harness.query_by_label(&missing).is_none(), "{link}: {word}");
        }
        let rows = [Role::Slider, Role::ComboBox, Role::SpinButton];
        let rows = rows.map(|role| harness.query_all_by_role(role).count());
        assert!(rows.into_iter().sum::<usize>() > 0, "{link}");
    }
}
