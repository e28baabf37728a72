//! The window without a screen, and helpers that operate it: controls are found by role and name.

use eframe::egui::accesskit::Role;
use eframe::egui::{
    Color32, Event, Key, Modifiers, PointerButton, Pos2, Rect, Shape, TexturesDelta, pos2, vec2,
};
use egui_kittest::kittest::{NodeT, Queryable};
use egui_kittest::{Harness, TestRenderer};
use glam::DVec3;
use serde::Serialize;
use shading_lab::app::{App, Appearance, SavedProgress};
use shading_lab::document::{Loaded, load_scene};
use shading_lab::scene::parameter::Parameter;
use shading_lab::scene::{Choice, Scene, View};
use shading_lab::text::{Language, has, in_language, interned};
use std::collections::BTreeMap;
use std::path::Path;
use std::time::{Duration, Instant};

pub fn built_in(scene: &str) -> Loaded {
    load_scene(Path::new(scene)).expect("a scene")
}

pub fn window(scene: &str) -> Harness<'static, App> {
    window_with(scene, |app| app)
}

/// Opens a window whose controls are all in reach, on a file or a built-in scene; `set_up` changes it before its first frame.
pub fn window_with(scene: &str, set_up: impl FnOnce(App) -> App) -> Harness<'static, App> {
    opened(built_in(scene), Nowhere, set_up)
}

/// Opens a window whose sections are folded as the scene has them.
pub fn folded(scene: &str) -> Harness<'static, App> {
    let loaded = built_in(scene);
    built(loaded, Nowhere, |app| app)
}

/// Opens a window whose textures go to `card`.
pub fn window_on(scene: &str, card: impl TestRenderer + 'static) -> Harness<'static, App> {
    opened(built_in(scene), card, |app| app)
}

/// Opens a window on any scene.
pub fn window_of(loaded: Loaded) -> Harness<'static, App> {
    opened(loaded, Nowhere, |app| app)
}

/// In-memory storage in place of the one that persists between sessions.
#[derive(Default)]
struct Storage(BTreeMap<String, String>);

impl eframe::Storage for Storage {
    fn get_string(&self, key: &str) -> Option<String> {
        self.0.get(key).cloned()
    }

    fn set_string(&mut self, key: &str, value: String) {
        self.0.insert(key.to_owned(), value);
    }

    fn remove_string(&mut self, key: &str) {
        self.0.remove(key);
    }

    fn flush(&mut self) {}
}

/// The stored state of a window.
#[derive(Serialize)]
struct Stored<'a> {
    #[serde(rename = "look")]
    appearance: &'a Appearance,
    course: &'a SavedProgress,
}

/// Opens a window of a given size, in points, with a stored appearance.
pub fn window_looking(
    loaded: Loaded,
    size: [f32; 2],
    appearance: &Appearance,
    set_up: impl FnOnce(App) -> App,
) -> Harness<'static, App> {
    window_storing(loaded, size, appearance, &SavedProgress::default(), set_up)
}

/// Opens a window with a stored appearance and stored answers to lessons.
pub fn window_storing(
    loaded: Loaded,
    size: [f32; 2],
    appearance: &Appearance,
    course: &SavedProgress,
    set_up: impl FnOnce(App) -> App,
) -> Harness<'static, App> {
    let mut storage = Storage::default();
    eframe::set_value(&mut storage, "look", &Stored { appearance, course });
    // A window's storage lives as long as the window.
    let storage: &'static Storage = Box::leak(Box::new(storage));
    let mut harness = Harness::builder()
        .with_size(size)
        .with_max_steps(60)
        .renderer(Nowhere)
        .build_eframe(|cc| {
            cc.storage = Some(storage);
            set_up(App::new(cc, loaded))
        });
    harness.run_ok();
    harness
}

fn opened(
    loaded: Loaded,
    card: impl TestRenderer + 'static,
    set_up: impl FnOnce(App) -> App,
) -> Harness<'static, App> {
    let mut harness = built(loaded, card, set_up);
    unfold_all(&mut harness);
    harness
}

fn built(
    loaded: Loaded,
    card: impl TestRenderer + 'static,
    set_up: impl FnOnce(App) -> App,
) -> Harness<'static, App> {
    let builder = Harness::builder()
        .with_size([1280.0, 800.0])
        .with_max_steps(40)
        .renderer(card);
    let mut harness = builder.build_eframe(|cc| set_up(App::new(cc, loaded)));
    settle(&mut harness);
    harness
}

/// Decodes the QR code in the window: the black squares that are painted over white.
pub fn decoded_code(harness: &Harness<'_, App>) -> String {
    let shapes = harness.output().shapes.iter();
    let mesh = shapes.filter_map(|clipped| match &clipped.shape {
        Shape::Mesh(mesh) => mesh
            .vertices
            .iter()
            .all(|vertex| vertex.color == Color32::BLACK)
            .then_some(mesh),
        _ => None,
    });
    let mesh = mesh.max_by_key(|mesh| mesh.vertices.len()).expect("a code");
    let mut pixels = vec![255u8; 1280 * 800];
    for corners in mesh.vertices.as_chunks::<4>().0 {
        let (min, max) = corners
            .iter()
            .fold((pos2(1e9, 1e9), Pos2::ZERO), |(min, max), vertex| {
                (min.min(vertex.pos), max.max(vertex.pos))
            });
        for y in min.y.round() as usize..max.y.round() as usize {
            pixels[y * 1280 + min.x.round() as usize..y * 1280 + max.x.round() as usize].fill(0);
        }
    }
    let mut image =
        rqrr::PreparedImage::prepare_from_greyscale(1280, 800, |x, y| pixels[y * 1280 + x]);
    let [code] = &image.detect_grids()[..] else {
        panic!("one code")
    };
    code.decode().expect("a readable code").1
}

/// Runs frames until nothing asks for another. What other threads work out may take its time: a lesson shows a spinner meanwhile.
pub fn settle(harness: &mut Harness<'_, App>) {
    let begun = Instant::now();
    while let Err(unsettled) = harness.try_run() {
        assert!(begun.elapsed().as_secs() < 60, "{unsettled}");
        std::thread::sleep(Duration::from_millis(10));
    }
}

/// A graphics card that takes textures and discards them, like one that has copied them.
pub struct Nowhere;

impl TestRenderer for Nowhere {
    fn handle_delta(&mut self, delta: &mut TexturesDelta) {
        delta.clear();
    }
}

pub fn picture(harness: &Harness<'_, App>) -> Vec<[u8; 4]> {
    harness.state().frame().pixels.clone()
}

pub fn scene<'h>(harness: &'h Harness<'_, App>) -> &'h Scene {
    &harness.state().state().session.document().scene
}

/// Returns the English name for a key: of a parameter, of a message, or of a part of them, as in `light.0.position.x`. Any other
/// text is returned unchanged.
pub fn named(key: &str) -> &'static str {
    let parameter = Parameter::of_key(key);
    let whole = parameter
        .map(|(it, index)| in_language(Language::English, || it.full_name(index.unwrap_or(0))));
    let part = || {
        let (of, part) = key.rsplit_once('.')?;
        let part = format!("controls-{part}");
        has(&part).then(|| format!("{} {}", named(of), english!(&part)))
    };
    let name = whole.or_else(part);
    name.map_or_else(|| english!(key), |name| interned(&name))
}

/// Chooses an entry of a list. Both are given by the keys of their messages, or as a parameter and its value in a scene file.
pub fn choose(harness: &mut Harness<'_, App>, list: &str, entry: &str) {
    let options = Parameter::of_key(list).map_or(&[][..], |(parameter, _)| parameter.options());
    let option = options.iter().find(|option| option.word == entry);
    let entry = named(option.map_or(entry, |option| option.messages[0]));
    let list = named(list);
    harness
        .get_by_role_and_label(Role::ComboBox, list)
        .scroll_to_me();
    settle(harness);
    harness
        .get_by_role_and_label(Role::ComboBox, list)
        .click_accesskit();
    settle(harness);
    press(harness, entry);
}

/// Opens a view by the key of its name, by way of its group on the rail.
pub fn open_view(harness: &mut Harness<'_, App>, name: &str) {
    let name = named(name);
    for group in [
        "view-point",
        "view-line",
        "view-picture",
        "view-engine",
        "course",
    ] {
        if harness.query_by_role_and_label(Role::Tab, name).is_some() {
            break;
        }
        press_rail(harness, group);
    }
    harness
        .get_by_role_and_label(Role::Tab, name)
        .click_accesskit();
    settle(harness);
}

/// Returns the rectangle of the picture.
pub fn picture_place(harness: &Harness<'_, App>) -> Rect {
    let mode = harness.state().state().session.shown.scene.shading.mode;
    let name = english!("picture-name", mode = mode.label());
    harness.get_by_role_and_label(Role::Image, &name).rect()
}

/// Returns the position in the window at which a point of the world appears, if that is before the eye.
pub fn seen(harness: &Harness<'_, App>, at: DVec3) -> Option<Pos2> {
    let frame = harness.state().frame();
    let size = [frame.width, frame.height];
    let (pixel, _) = View::new(&scene(harness).camera, size).project(at)?;
    Some(picture_place(harness).min + vec2(pixel.x as f32, pixel.y as f32))
}

/// Clicks a button, given by its name or the key of its name.
pub fn press(harness: &mut Harness<'_, App>, key: &str) {
    harness
        .get_by_role_and_label(Role::Button, named(key))
        .click_accesskit();
    settle(harness);
}

/// Clicks a button of the rail: of several of a name the last one, behind the menus.
pub fn press_rail(harness: &mut Harness<'_, App>, key: &str) {
    let buttons = harness.query_all_by_role_and_label(Role::Button, named(key));
    buttons.last().expect("a button").click_accesskit();
    settle(harness);
}

/// Opens the menu of a right click.
pub fn right_click(harness: &mut Harness<'_, App>, at: Pos2) {
    harness.hover_at(at);
    harness.run_ok();
    for pressed in [true, false] {
        harness.event(Event::PointerButton {
            pos: at,
            button: PointerButton::Secondary,
            pressed,
            modifiers: Modifiers::NONE,
        });
        // One step, a quarter of a second: what is held down longer is no click.
        harness.step();
    }
    harness.run_ok();
}

/// Opens a section of the panel of controls.
pub fn unfold(harness: &mut Harness<'_, App>, title: &str) {
    let section = harness.get_by_role_and_label(Role::DisclosureTriangle, named(title));
    if section.accesskit_node().data().is_expanded() != Some(true) {
        section.click_accesskit();
        settle(harness);
    }
}

/// The keys of the sections of the panel of controls.
pub const TITLES: [&str; 8] = [
    "controls-material",
    "controls-lights",
    "controls-shading",
    "controls-object",
    "controls-surroundings",
    "controls-transparency",
    "controls-camera",
    "controls-display",
];

/// Opens every section of the panel of controls, whatever the scene is about.
pub fn unfold_all(harness: &mut Harness<'_, App>) {
    for title in TITLES {
        let section = harness.query_by_role_and_label(Role::DisclosureTriangle, named(title));
        if section.is_some() {
            unfold(harness, title);
        }
    }
}

/// Types a number into a field by the key of its parameter or name.
pub fn enter(harness: &mut Harness<'_, App>, key: &str, value: f64) {
    harness
        .get_by_role_and_label(Role::SpinButton, named(key))
        .set_value_accesskit(value);
    settle(harness);
}

pub fn undo(harness: &mut Harness<'_, App>) {
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    settle(harness);
}

/// Runs the window until `condition` holds; returns `false` after 3000 attempts.
pub fn wait(harness: &mut Harness<'_, App>, condition: impl Fn(&Harness<'_, App>) -> bool) -> bool {
    for _ in 0..3000 {
        harness.run_ok();
        if condition(harness) {
            return true;
        }
        std::thread::sleep(Duration::from_millis(20));
    }
    false
}

/// Drags from one position in the window to another.
pub fn drag(harness: &mut Harness<'_, App>, from: Pos2, to: Pos2) {
    harness.drag_at(from);
    settle(harness);
    harness.hover_at(to);
    settle(harness);
    harness.drop_at(to);
    settle(harness);
}
