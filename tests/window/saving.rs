//! Saving without loss: questions before files are replaced and before a changed scene is closed, and work that is kept for the
//! next start.

#[cfg(target_os = "linux")]
use crate::common::alone::is_alone;
use crate::common::hands;
use crate::common::hands::{
    enter, named, open_view, press, scene, undo, wait, window, window_with,
};
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, ViewportCommand, ViewportEvent, ViewportId};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use shading_lab::app::{App, Origin, ViewName};
use shading_lab::document::{load_scene, save_scene};
use std::fs;
use std::path::{Path, PathBuf};

type Window = Harness<'static, App>;

/// A test's own folder, removed when dropped.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("saving-{name}"));
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).expect("a folder");
        Self(path)
    }

    fn path(&self, name: &str) -> String {
        self.0.join(name).display().to_string()
    }

    fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.0)
            .expect("a folder")
            .map(|entry| entry.expect("an entry").file_name());
        let mut names: Vec<String> = entries
            .map(|name| name.to_string_lossy().into_owned())
            .collect();
        names.sort();
        names
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn change(window: &mut Window, n: f64) {
    window
        .get_by_role_and_label(Role::Slider, named("material.n"))
        .set_value_accesskit(n);
    window.run();
}

/// Opens a dialog by its keys, puts a path in its field and presses its button.
fn save_as(window: &mut Window, (modifiers, key): (Modifiers, Key), path: &str, button: &str) {
    window.key_press_modifiers(modifiers, key);
    window.run();
    fill_in(window, path, button);
}

fn fill_in(window: &mut Window, path: &str, button: &str) {
    // Clears the suggestion in the field.
    window.key_press_modifiers(Modifiers::COMMAND, Key::A);
    window.run();
    window
        .get_by_role_and_label(Role::TextInput, english!("file"))
        .type_text(path);
    window.run();
    press(window, button);
}

const SAVE_AS: (Modifiers, Key) = (
    Modifiers {
        shift: true,
        ..Modifiers::COMMAND
    },
    Key::S,
);
const EXPORT: (Modifiers, Key) = (Modifiers::COMMAND, Key::E);

fn asks(window: &Harness<'_, App>, question: &str) -> bool {
    window.query_by_label_contains(named(question)).is_some()
}

#[test]
fn a_name_without_an_ending_is_given_one_that_opens() {
    let folder = Folder::new("ending");
    let mut window = window("sphere");
    save_as(&mut window, SAVE_AS, &folder.path("myscene"), "save");
    save_as(&mut window, SAVE_AS, &folder.path("version.2"), "save");
    save_as(&mut window, EXPORT, &folder.path("picture"), "export");
    assert!(wait(&mut window, |window| asks(
        window,
        &english!("exported", path = "")
    )));
    assert_eq!(
        folder.names(),
        ["myscene.toml", "picture.png", "version.2.toml"]
    );
    for name in folder.names() {
        assert_eq!(
            load_scene(&folder.0.join(&name))
                .expect(&name)
                .scene
                .material,
            scene(&window).material
        );
    }
    assert_eq!(
        window.state().state().session.document().origin,
        Origin::File(folder.0.join("version.2.toml"))
    );
}

#[test]
fn no_file_is_replaced_without_a_question() {
    let folder = Folder::new("replace");
    fs::write(folder.0.join("old.toml"), "old").expect("a file");
    fs::write(folder.0.join("old.png"), "old").expect("a file");
    let old = |name: &str| fs::read(folder.0.join(name)).expect("a file") == b"old";
    let mut window = window("sphere");
    save_as(&mut window, SAVE_AS, &folder.path("old"), "save");
    assert!(asks(&window, "replace-file") && old("old.toml"));
    press(&mut window, "back");
    fill_in(&mut window, &folder.path("new.toml"), "save");
    assert!(old("old.toml") && folder.0.join("new.toml").is_file());
    // Saving to the document's own file replaces no other one.
    save_as(&mut window, SAVE_AS, &folder.path("new.toml"), "save");
    assert!(!asks(&window, "replace-file"));
    save_as(&mut window, EXPORT, &folder.path("old.png"), "export");
    assert!(asks(&window, "replace-file"));
    press(&mut window, "replace");
    assert!(
        wait(&mut window, |window| asks(
            window,
            &english!("exported", path = "")
        )) && !old("old.png")
    );
    save_as(&mut window, SAVE_AS, &folder.path("old"), "save");
    press(&mut window, "replace");
    assert!(!old("old.toml"));
    // Shaders are written to two files; either may exist already.
    fs::write(folder.0.join("old.frag"), "old").expect("a file");
    window.key_press_modifiers(Modifiers::COMMAND, Key::U);
    window.run();
    window
        .get_by_role_and_label(Role::Tab, english!("code-shaders"))
        .click_accesskit();
    window.run();
    assert!(wait(&mut window, |window| asks(
        window,
        &english!("code-lines", count = 2)[1..]
    )));
    press(&mut window, "save-as");
    fill_in(&mut window, &folder.path("old.vert"), "save");
    assert!(asks(&window, &english!("replace-lost", names = "old.frag")) && old("old.frag"));
    press(&mut window, "replace");
    assert!(!old("old.frag"));
}

#[test]
fn an_export_that_is_cancelled_writes_nothing() {
    let folder = Folder::new("cancelled");
    let mut window = window("sphere");
    window.key_press_modifiers(EXPORT.0, EXPORT.1);
    window.run();
    enter(&mut window, "samples", 1024.0);
    fill_in(&mut window, &folder.path("picture.png"), "export");
    let drawing = english!("drawing-file", path = "");
    assert!(asks(&window, &drawing));
    press(&mut window, "cancel");
    assert!(!asks(&window, &drawing));
    std::thread::sleep(std::time::Duration::from_secs(2));
    window.run();
    assert!(folder.names().is_empty() && !asks(&window, &english!("exported", path = "")));
}

#[test]
fn no_shortcut_acts_while_a_file_is_opened() {
    let folder = Folder::new("opening");
    // A model that takes long enough to read for a few frames.
    let large = "v 0 0 0\nv 1 0 0\nv 0 1 0\n".repeat(300_000) + "f 1 2 3\n";
    fs::write(folder.0.join("large.obj"), large).expect("a model");
    let mut window = window("sphere");
    change(&mut window, 7.0);
    let before = scene(&window).clone();
    window.key_press_modifiers(Modifiers::COMMAND, Key::O);
    window.run();
    window
        .get_by_role_and_label(Role::TextInput, english!("file"))
        .type_text(&folder.path("large.obj"));
    window.run();
    window
        .get_by_role_and_label(Role::Button, english!("open"))
        .click_accesskit();
    let opening = |window: &mut Window| {
        window.step();
        asks(window, &english!("opening", path = ""))
    };
    assert!((0..9).any(|_| opening(&mut window)));
    for (modifiers, key) in [
        (Modifiers::NONE, Key::Num1),
        (Modifiers::COMMAND, Key::Z),
        SAVE_AS,
    ] {
        window.key_press_modifiers(modifiers, key);
        window.step();
    }
    assert!(opening(&mut window));
    assert_eq!(scene(&window), &before, "a shortcut has acted");
    assert!(
        !asks(&window, "file-save"),
        "a shortcut has opened a dialog"
    );
    press(&mut window, "cancel");
    assert!(!asks(&window, &english!("opening", path = "")));
    assert_eq!(scene(&window), &before);
}

/// Presses the window's close button; returns whether the window stays open.
fn stays_when_closed(window: &mut Window) -> bool {
    let viewport = window
        .input_mut()
        .viewports
        .entry(ViewportId::ROOT)
        .or_default();
    viewport.events.push(ViewportEvent::Close);
    window.step();
    let stays = commands(window).contains(&ViewportCommand::CancelClose);
    window
        .input_mut()
        .viewports
        .entry(ViewportId::ROOT)
        .or_default()
        .events
        .clear();
    window.run();
    stays
}

fn commands(window: &Window) -> Vec<ViewportCommand> {
    window.output().viewport_output[&ViewportId::ROOT]
        .commands
        .clone()
}

/// Presses a button; returns whether the window closes.
fn closes_by(window: &mut Window, button: &str) -> bool {
    window
        .get_by_role_and_label(Role::Button, named(button))
        .click_accesskit();
    (0..4).any(|_| {
        window.step();
        commands(window).contains(&ViewportCommand::Close)
    })
}

#[test]
fn a_changed_scene_is_not_closed_without_a_question() {
    let folder = Folder::new("close");
    let mut window = window("sphere");
    assert!(!stays_when_closed(&mut window), "nothing is lost by it");
    change(&mut window, 7.0);
    let unsaved = &english!("unsaved", name = "sphere");
    assert!(stays_when_closed(&mut window) && asks(&window, unsaved));
    press(&mut window, "cancel");
    assert!(!asks(&window, unsaved) && scene(&window).material.n == 7.0);
    window.key_press_modifiers(Modifiers::COMMAND, Key::Q);
    window.run();
    assert!(asks(&window, unsaved));
    // Saving asks for a name; cancelling that dialog keeps the window open, too.
    press(&mut window, "save");
    press(&mut window, "cancel");
    save_as(&mut window, SAVE_AS, &folder.path("first"), "save");
    assert!(
        !commands(&window).contains(&ViewportCommand::Close),
        "saving alone does not close"
    );
    change(&mut window, 8.0);
    assert!(stays_when_closed(&mut window));
    assert!(closes_by(&mut window, "save"), "it has a file by now");
    assert_eq!(
        load_scene(&folder.0.join("first.toml"))
            .expect("a scene")
            .scene
            .material
            .n,
        8.0
    );
    assert!(!stays_when_closed(&mut window));
}

#[test]
fn a_changed_scene_can_be_closed_without_saving() {
    let mut window = window("sphere");
    change(&mut window, 7.0);
    assert!(stays_when_closed(&mut window));
    assert!(closes_by(&mut window, "close-unsaved"));
    assert!(!stays_when_closed(&mut window));
}

/// Opens a window that keeps its work in `folder`.
fn keeping(source: &str, folder: &Path) -> Window {
    window_with(source, |app| app.with_recovery(folder))
}

/// Returns the kept scenes, once none is being written.
fn kept(window: &mut Window, folder: &Folder) -> Vec<String> {
    // Five seconds of the window's time.
    window.run_steps(20);
    std::thread::sleep(std::time::Duration::from_millis(300));
    window.run();
    folder
        .names()
        .into_iter()
        .filter(|name| name.ends_with(".toml"))
        .collect()
}

/// Describes what a window looks at: the probe, the line, the active pane and the view.
fn looked_at(window: &Window) -> String {
    let state = window.state().state();
    let (own, active) = (&state.window, state.session.panes.active);
    format!("{:?}", (own.probe, own.line, active, own.appearance.view))
}

/// Changes the scene and what the window looks at, and returns the latter once both are kept.
fn work(window: &mut Window, folder: &Folder) -> String {
    change(window, 7.0);
    open_view(window, "view-profile");
    window.key_press_modifiers(Modifiers::SHIFT, Key::ArrowLeft);
    window.key_press(Key::K);
    window.run();
    window.key_press(Key::N);
    window.run();
    let state = window.state().state();
    assert_eq!(state.session.panes.active, 1);
    assert_eq!(state.window.appearance.view, ViewName::Profile);
    assert_eq!(kept(window, folder), ["0.toml"]);
    looked_at(window)
}

#[test]
fn work_is_offered_again_after_a_window_that_was_not_closed() {
    let folder = Folder::new("crash");
    let mut first = keeping("torus", &folder.0);
    assert!(kept(&mut first, &folder).is_empty(), "nothing has changed");
    let before = work(&mut first, &folder);
    // Another window has its own file and leaves this one's alone.
    let mut second = keeping("sphere", &folder.0);
    assert!(!asks(&second, "restore-work"));
    change(&mut second, 9.0);
    assert_eq!(kept(&mut second, &folder), ["0.toml", "1.toml"]);
    drop(first);
    let mut third = keeping("cube", &folder.0);
    assert!(asks(&third, &english!("restore-kept", name = "torus")));
    press(&mut third, "restore");
    assert!(wait(&mut third, |window| scene(window).material.n == 7.0));
    assert_eq!(looked_at(&third), before);
    let state = third.state().state();
    assert!(
        state.session.modified()
            && state.session.document().origin == Origin::BuiltIn("torus".to_owned())
    );
    assert_eq!(
        kept(&mut third, &folder),
        ["0.toml", "1.toml"],
        "what is restored is as unsaved as before"
    );
    assert!(stays_when_closed(&mut third) && closes_by(&mut third, "close-unsaved"));
    assert!(!stays_when_closed(&mut third));
    assert_eq!(
        kept(&mut third, &folder),
        ["1.toml"],
        "who closes does not want it back"
    );
    drop((second, third));
    let mut fourth = keeping("cube", &folder.0);
    press(&mut fourth, "later");
    drop(fourth);
    let mut fifth = keeping("cube", &folder.0);
    press(&mut fifth, "delete");
    assert!(kept(&mut fifth, &folder).is_empty());
}

#[test]
fn what_is_saved_is_not_kept_and_rest_costs_nothing() {
    let folder = Folder::new("rest");
    let mut window = keeping("sphere", &folder.0);
    change(&mut window, 7.0);
    assert_eq!(kept(&mut window, &folder), ["0.toml"]);
    let waits = |window: &Window| window.output().viewport_output[&ViewportId::ROOT].repaint_delay;
    // The smoother picture may still be on its way.
    wait(&mut window, |window| {
        window.output().viewport_output[&ViewportId::ROOT]
            .repaint_delay
            .as_secs()
            > 60
    });
    assert!(
        waits(&window).as_secs() > 60,
        "no frame is asked for once it is kept: {:?}",
        waits(&window)
    );
    save_as(&mut window, SAVE_AS, &folder.path("saved"), "save");
    assert_eq!(kept(&mut window, &folder), ["saved.toml"]);
}

#[test]
fn a_model_is_restored_from_its_place_or_named_as_missing() {
    let folder = Folder::new("model");
    let model = folder.0.join("triangle.obj");
    fs::write(&model, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").expect("a model");
    let mut first = keeping(&folder.path("triangle.obj"), &folder.0);
    work(&mut first, &folder);
    drop(first);
    fs::rename(&model, folder.0.join("elsewhere.obj")).expect("renamed");
    let mut second = keeping("sphere", &folder.0);
    press(&mut second, "restore");
    let missing = english!(
        "document-no-such-file",
        expected = english!("document-model")
    );
    let missing = format!("triangle.obj: {missing}");
    assert!(wait(&mut second, |window| asks(window, &missing)));
    assert_eq!(
        kept(&mut second, &folder),
        ["0.toml"],
        "it stays where it is"
    );
    drop(second);
    fs::rename(folder.0.join("elsewhere.obj"), &model).expect("renamed");
    let mut third = keeping("sphere", &folder.0);
    press(&mut third, "restore");
    assert!(wait(&mut third, |window| scene(window).material.n == 7.0));
    assert!(third.state().state().session.document().model.is_some());
}

#[test]
fn undo_reaches_across_opening_another_scene() {
    let folder = Folder::new("undo");
    let mut window = window("sphere");
    change(&mut window, 7.0);
    save_as(&mut window, SAVE_AS, &folder.path("ball.toml"), "save");
    change(&mut window, 8.0);
    press(&mut window, "scenes-next");
    let state = |window: &Window| {
        let state = window.state().state();
        (
            state.session.document().origin.name(),
            state.session.modified(),
            state.session.opened().material.n,
        )
    };
    let next = state(&window);
    assert!(next.0 != "ball.toml" && !next.1);
    undo(&mut window);
    assert_eq!(scene(&window).material.n, 8.0);
    assert_eq!(state(&window), ("ball.toml".to_owned(), true, 7.0));
    undo(&mut window);
    assert_eq!(
        state(&window),
        ("ball.toml".to_owned(), false, 7.0),
        "as saved"
    );
    for _ in 0..2 {
        window.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
        window.run();
    }
    assert_eq!(state(&window), next);
    let recent = &window.state().state().window.appearance.recent;
    assert_eq!(
        recent,
        &[folder.0.join("ball.toml")],
        "the file can be opened again"
    );
}

#[test]
fn the_form_of_an_export_has_usual_sizes_and_keeps_proportions() {
    let mut window = window("sphere");
    window.key_press_modifiers(EXPORT.0, EXPORT.1);
    window.run();
    let sides = |window: &Window| {
        ["width", "height"].map(|side| {
            let field = window.get_by_role_and_label(Role::SpinButton, english!(side));
            field.value().expect("a number")
        })
    };
    assert_eq!(sides(&window), ["1920", "1080"]);
    press(&mut window, "4K");
    assert_eq!(sides(&window), ["3840", "2160"]);
    window
        .get_by_role_and_label(Role::CheckBox, english!("keep-shape"))
        .click_accesskit();
    window.run();
    enter(&mut window, "width", 1600.0);
    assert_eq!(sides(&window), ["1600", "900"]);
    enter(&mut window, "height", 1.0);
    assert_eq!(sides(&window), ["2", "1"]);
    press(&mut window, "preset-window");
    let [width, height] = sides(&window).map(|side| side.parse::<u32>().expect("a number"));
    assert_eq!([width, height], window.state().state().window.room);
}

/// Runs in a process without a desktop, since the desktop is found by the environment.
#[cfg(target_os = "linux")]
#[test]
fn browsing_without_a_desktop_says_what_is_missing_and_a_path_can_be_typed() {
    let name = "saving::browsing_without_a_desktop_says_what_is_missing_and_a_path_can_be_typed";
    let alone = is_alone(name, |program| {
        program
            .env("DBUS_SESSION_BUS_ADDRESS", "unix:path=/nowhere")
            .env("PATH", "/nowhere");
    });
    if !alone {
        return;
    }
    let folder = Folder::new("browsing");
    let none = "browse-none";
    let mut window = window("sphere");
    window.key_press_modifiers(Modifiers::COMMAND, Key::O);
    window.run();
    assert!(!asks(&window, none));
    window
        .get_by_role_and_label(Role::Button, english!("browse"))
        .click_accesskit();
    assert!(wait(&mut window, |window| asks(window, none)));
    // The dialog is still there, for a path.
    save_scene(&folder.0.join("cube.toml"), &hands::built_in("cube").scene).expect("a file");
    fill_in(&mut window, &folder.path("cube.toml"), "open");
    let opened = Origin::File(folder.0.join("cube.toml"));
    assert!(wait(&mut window, |window| {
        window.state().state().session.document().origin == opened
    }));
    // The same holds for every dialog that asks for a path.
    window.key_press_modifiers(SAVE_AS.0, SAVE_AS.1);
    window.run();
    assert!(asks(&window, none));
}
