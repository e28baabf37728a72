//! The window's export of an animation: what the form offers, what it refuses, and what is written.

use crate::common::hands;
use crate::common::hands::{choose, enter, press, wait, window};
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use shading_lab::app::App;
use std::fs::{self, File};
use std::path::Path;

type Window = Harness<'static, App>;

/// Opens the form for an animation of a small picture, into a file.
fn open_form(window: &mut Window, path: &Path) {
    window.key_press_modifiers(Modifiers::COMMAND, Key::E);
    window.run();
    for (name, value) in [
        ("Width", 40.0),
        ("Height", 30.0),
        ("Samples per pixel", 1.0),
    ] {
        enter(window, name, value);
    }
    window
        .get_by_role_and_label(Role::CheckBox, "Animation")
        .click_accesskit();
    window.run();
    enter(window, "Frames", 3.0);
    fill_in(window, "File", &path.display().to_string());
}

fn fill_in(window: &mut Window, field: &str, text: &str) {
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
    let field = window.get_by_role_and_label(Role::TextInput, field);
    field.accesskit_node().value().unwrap_or_default()
}

#[test]
fn an_animation_is_exported_as_the_form_says() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("film");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder");
    let mut window = window("sphere");
    open_form(&mut window, &folder.join("a.png"));
    // What goes where is there from the start.
    let n = hands::scene(&window).material.n;
    assert_eq!(value(&window, "From"), n.to_string());
    fill_in(&mut window, "From", "5");
    fill_in(&mut window, "To", "500");
    press(&mut window, "GIF");
    assert!(value(&window, "File").ends_with("a.gif"));
    press(&mut window, "Export");
    let exported = |window: &Harness<'_, App>| window.query_by_label_contains("Exported").is_some();
    assert!(wait(&mut window, exported));
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
    // A value that does not change is refused, and the form stays for another try.
    open_form(&mut window, &folder.join("b.png"));
    choose(&mut window, "Value", "Field of view");
    let to = value(&window, "From");
    fill_in(&mut window, "To", &to);
    press(&mut window, "Export");
    assert!(window.query_by_label_contains("nothing changes").is_some());
    fill_in(&mut window, "To", "60");
    press(&mut window, "Export");
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
