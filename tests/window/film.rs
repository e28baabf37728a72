//! The window's export of an animation: the form's choices, its refusals, and the written files.

use crate::common::hands;
use crate::common::hands::{choose, enter, named, press, wait, window};
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use shading_lab::app::App;
use std::fs::{self, File};
use std::path::Path;

type Window = Harness<'static, App>;

/// Opens the form for an animation of a small picture, to be written to a file.
fn open_form(window: &mut Window, path: &Path) {
    window.key_press_modifiers(Modifiers::COMMAND, Key::E);
    window.run();
    for (name, value) in [("width", 40.0), ("height", 30.0), ("samples", 1.0)] {
        enter(window, name, value);
    }
    window
        .get_by_role_and_label(Role::CheckBox, english!("animation"))
        .click_accesskit();
    window.run();
    enter(window, "animation-frame-count", 3.0);
    fill_in(window, "file", &path.display().to_string());
}

fn fill_in(window: &mut Window, field: &str, text: &str) {
    let field = named(field);
    window.get_by_role_and_label(Role::TextInput, field).focus();
    window.run();
    window.key_press_modifiers(Modifiers::COMMAND, Key::A);
    window.run();
    window
        .get_by_role_and_label(Role::TextInput, field)
        .type_text(text);
    window.run();
}

fn value(window: &Window, field: &str) -> String {
    let field = window.get_by_role_and_label(Role::TextInput, named(field));
    field.accesskit_node().value().unwrap_or_default()
}

#[test]
fn an_animation_is_exported_as_the_form_says() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("film");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder");
    let mut window = window("sphere");
    open_form(&mut window, &folder.join("a.png"));
    // The form starts with the scene's present values.
    let n = hands::scene(&window).material.n;
    assert_eq!(value(&window, "animation-from"), n.to_string());
    fill_in(&mut window, "animation-from", "5");
    fill_in(&mut window, "animation-to", "500");
    press(&mut window, "GIF");
    assert!(value(&window, "file").ends_with("a.gif"));
    press(&mut window, "export");
    let exported = english!("exported", path = "");
    assert!(wait(&mut window, |window| window
        .query_by_label_contains(&exported)
        .is_some()));
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    let file = File::open(folder.join("a.gif")).expect("a film");
    let mut decoder = options.read_info(file).expect("a GIF");
    let mut pictures = Vec::new();
    while let Some(frame) = decoder.read_next_frame().expect("a frame") {
        assert_eq!((frame.width, frame.height), (40, 30));
        pictures.push(frame.buffer.to_vec());
    }
    assert_eq!(pictures.len(), 3);
    assert_ne!(pictures[0], pictures[2]);
    // A value that does not change is refused, and the form stays open for another try.
    open_form(&mut window, &folder.join("b.png"));
    choose(&mut window, "animation-key", "camera.fov_y");
    let to = value(&window, "animation-from");
    fill_in(&mut window, "animation-to", &to);
    press(&mut window, "export");
    assert!(
        window
            .query_by_label_contains(english!("animation-nothing"))
            .is_some()
    );
    fill_in(&mut window, "animation-to", "60");
    press(&mut window, "export");
    assert!(wait(&mut window, |_| folder.join("b.png").is_file()));
    let file = std::io::BufReader::new(File::open(folder.join("b.png")).expect("a film"));
    let reader = png::Decoder::new(file).read_info().expect("a header");
    let frames = reader
        .info()
        .animation_control()
        .map(|control| control.num_frames);
    assert_eq!(frames, Some(3));
    let _ = fs::remove_dir_all(&folder);
}
