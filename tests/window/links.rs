//! Links in the window: copied, pasted, and shown as a QR code.

#[cfg(target_os = "linux")]
use crate::common::alone::{is_alone, limit_memory};
use crate::common::hands::{
    built_in, decoded_code, enter, open_view, picture, press, scene, undo, wait, window,
    window_looking, window_of, window_with,
};
use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, Modifiers, OutputCommand, PointerButton, ViewportId, pos2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use glam::DVec2;
use shading_lab::app::{App, Appearance, ProbePoint, ProfileLine, ViewName};
use shading_lab::document::load_scene;
use shading_lab::link::read;
use shading_lab::scene::presets;
use std::path::Path;

const PAGE: &str = "https://example.org/lab/";

/// Opens a window whose links begin with a page.
fn with_page(scene: &str) -> Harness<'static, App> {
    window_with(scene, |app| app.with_page(Some(PAGE.to_owned())))
}

/// Returns the text that a key copied to the clipboard.
fn copied(harness: &mut Harness<'_, App>) -> String {
    // A frame for each event; a copied text leaves the window in a frame of its own.
    harness.event(Event::Key {
        key: Key::L,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers: Modifiers::COMMAND | Modifiers::SHIFT,
    });
    harness.step();
    let text = |command: &OutputCommand| match command {
        OutputCommand::CopyText(text) => Some(text.clone()),
        _ => None,
    };
    let commands = &harness.output().platform_output.commands;
    let link = commands.iter().find_map(text);
    harness.run();
    link.expect("a link on the clipboard")
}

fn paste(harness: &mut Harness<'_, App>, text: &str) {
    harness.event(Event::Paste(text.to_owned()));
    harness.run();
}

#[test]
fn what_is_seen_is_copied_as_a_link_and_opened_by_pasting_it() {
    let mut first = with_page("sphere");
    enter(&mut first, "material.n", 50.0);
    open_view(&mut first, "view-profile");
    first.key_press_modifiers(Modifiers::NONE, Key::F3);
    first.run();
    for _ in 0..3 {
        first.key_press_modifiers(Modifiers::SHIFT, Key::ArrowLeft);
        first.run();
    }
    let link = copied(&mut first);
    let start = format!("{PAGE}?scene=sphere&set=material.n=50&view=profile&probe=");
    assert!(
        link.starts_with(&start) && link.contains("&line="),
        "{link}"
    );
    first.run();
    assert_eq!(
        first.state().state().session.said(),
        Some(english!("link-copied"))
    );

    let mut second = window("cone");
    paste(&mut second, &format!("  {link}\n"));
    assert_eq!(scene(&second), scene(&first));
    let [a, b] = [&first, &second].map(|window| window.state().state());
    assert_eq!(b.window.appearance.view, ViewName::Profile);
    assert!(
        b.window.appearance.views
            && !b.session.modified()
            && b.session.document().origin.name() == "sphere"
    );
    let size = b.window.room;
    assert_eq!(a.window.probe.pixel(size), b.window.probe.pixel(size));
    assert!((a.window.line.0[0] - b.window.line.0[0]).length() < 1e-4);
    undo(&mut second);
    assert_eq!(
        *scene(&second),
        presets::find("cone").expect("built in").scene()
    );
}

#[test]
fn a_link_that_is_wrong_is_told_and_what_is_open_stays() {
    let mut harness = window("gold");
    paste(&mut harness, "some text");
    assert!(harness.state().state().dialog.is_none());
    paste(&mut harness, "?scene=gold&set=material.n=-1");
    let wrong = read("?scene=gold&set=material.n=-1").expect_err("a wrong link");
    assert!(harness.query_by_label(&wrong.to_string()).is_some());
    assert_eq!(
        *scene(&harness),
        presets::find("gold").expect("built in").scene()
    );
}

#[test]
fn a_window_opens_on_a_link_with_its_view_probe_and_line() {
    let link = "?scene=gold&view=plan&probe=0.25,-0.125&line=-0.5,0,0.5,0.25";
    let harness = window_of(load_scene(Path::new(link)).expect("a link"));
    let state = harness.state().state();
    assert_eq!(
        (state.window.appearance.view, state.window.probe),
        (ViewName::Plan, ProbePoint(DVec2::new(0.25, -0.125)))
    );
    assert_eq!(
        state.window.line,
        ProfileLine([DVec2::new(-0.5, 0.0), DVec2::new(0.5, 0.25)])
    );
    // A view's name in a link is the one that the window knows it by.
    for view in shading_lab::link::VIEWS {
        let known: Result<ViewName, _> = serde_json::from_value(view.into());
        assert!(known.is_ok(), "{view}");
    }
}

#[test]
fn the_code_over_the_window_is_the_link_and_any_key_or_click_closes_it() {
    let mut harness = with_page("highlight");
    let link = copied(&mut harness);
    for closes in [0, 1] {
        harness.key_press(Key::Q);
        harness.run();
        let name = english!("link-code-of", link = &*link);
        assert!(
            harness
                .query_by_role_and_label(Role::Image, &name)
                .is_some()
        );
        assert_eq!(decoded_code(&harness), link);
        assert!(read(&link).is_ok());
        let mode = scene(&harness).shading.mode;
        if closes == 0 {
            harness.key_press(Key::Num5);
        } else {
            let event = |pressed| Event::PointerButton {
                pos: pos2(300.0, 400.0),
                button: PointerButton::Primary,
                pressed,
                modifiers: Modifiers::NONE,
            };
            harness.event(Event::PointerMoved(pos2(300.0, 400.0)));
            harness.event(event(true));
            harness.event(event(false));
        }
        harness.run();
        assert!(harness.state().state().dialog.is_none());
        assert_eq!(
            scene(&harness).shading.mode,
            mode,
            "the key is not for the window"
        );
    }
}

#[test]
fn without_a_page_its_address_is_asked_for() {
    let mut harness = window("gold");
    harness.key_press(Key::Q);
    harness.run();
    let field = |harness: &mut Harness<'_, App>, text: &str| {
        let label = english!("link-page");
        harness
            .get_by_role_and_label(Role::TextInput, label)
            .focus();
        harness.run();
        harness
            .get_by_role_and_label(Role::TextInput, label)
            .type_text(text);
        harness.run();
        press(harness, "link-show-code");
    };
    field(&mut harness, "example.org");
    assert!(
        harness
            .query_by_label_contains(english!("link-no-page"))
            .is_some()
    );
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    field(&mut harness, PAGE);
    assert_eq!(harness.state().state().window.appearance.page, PAGE);
    assert!(decoded_code(&harness).starts_with("https://example.org/lab/?scene=gold&"));
}

#[test]
fn a_notice_goes_after_four_seconds_and_no_frame_is_drawn_for_it_after_that() {
    // Without smooth edges, which would draw frames in the background.
    let appearance = Appearance {
        smooth_edges: false,
        ..Appearance::default()
    };
    let mut harness = window_looking(built_in("gold"), [1280.0, 800.0], &appearance, |app| {
        app.with_page(Some(PAGE.to_owned()))
    });
    let says =
        |harness: &Harness<'_, App>| harness.query_by_label(english!("link-copied")).is_some();
    let waits = |harness: &Harness<'_, App>| {
        harness.output().viewport_output[&ViewportId::ROOT].repaint_delay
    };
    let rests =
        |harness: &mut Harness<'_, App>| wait(harness, |harness| waits(harness).as_secs() > 60);
    assert!(rests(&mut harness), "the picture is finished");
    copied(&mut harness);
    harness.run();
    assert!(says(&harness));
    let left = waits(&harness).as_secs_f64();
    assert!(
        (3.0..=4.0).contains(&left),
        "one frame, when it goes: {left}"
    );
    // A frame of the test is a quarter of a second.
    let frames = (0..40).take_while(|_| {
        harness.step();
        says(&harness)
    });
    let frames = frames.count();
    assert!((10..=18).contains(&frames), "{frames}");
    assert!(rests(&mut harness), "nothing is drawn at rest");
}

#[test]
fn a_notice_goes_with_what_it_speaks_of() {
    let mut harness = with_page("gold");
    copied(&mut harness);
    harness.run();
    press(&mut harness, "scenes-next");
    assert_eq!(harness.state().state().session.said(), None);
    // The notice about an opened link refers to the open scene.
    paste(&mut harness, "?scene=torus");
    assert_eq!(
        harness.state().state().session.said(),
        Some(english!("link-opened"))
    );
    undo(&mut harness);
    assert_eq!(
        harness.state().state().session.said(),
        None,
        "and not about what was before"
    );
}

/// Checks the notice at projector size, where no bar at the bottom reports what was done.
#[test]
fn a_notice_is_told_for_a_while_where_there_is_no_bar_for_it() {
    let mut harness = with_page("gold");
    harness.key_press(Key::F9);
    harness.run();
    copied(&mut harness);
    assert!(harness.query_by_label(english!("link-copied")).is_some());
    for _ in 0..200 {
        harness.step();
    }
    assert!(harness.query_by_label(english!("link-copied")).is_none());
    assert_eq!(harness.state().state().session.said(), None);
}

#[test]
fn a_link_leads_to_a_step_of_a_lesson_and_back() {
    let harness = window("?lesson=mach-bands&step=3");
    let course = |harness: &Harness<'_, App>| {
        let open = harness.state().state().course.open.as_ref();
        open.map(|open| (open.lesson.name.clone(), open.step))
    };
    assert_eq!(course(&harness), Some(("mach-bands".to_owned(), 2)));
    let link = harness.state().state().link().expect("a link").link;
    assert!(link.contains("lesson=mach-bands&step=3"), "{link}");
    let harness = window("?lesson=mach-band");
    assert_eq!(course(&harness), None);
    assert!(harness.state().state().dialog.is_some());
}

/// Runs in a process of its own: memory can be limited for a whole process only.
#[cfg(target_os = "linux")]
#[test]
fn a_scene_that_memory_is_too_short_for_is_refused_with_the_figure() {
    let name = "links::a_scene_that_memory_is_too_short_for_is_refused_with_the_figure";
    if !is_alone(name, |program| limit_memory(program, 3_000_000)) {
        return;
    }
    let mut harness = window("cube");
    let cube = picture(&harness);
    let open = |harness: &mut Harness<'_, App>, link: &str| {
        harness.event(Event::Paste(link.to_owned()));
        harness.run_ok();
    };
    open(
        &mut harness,
        "?scene=teapot&set=object.segments=4096&set=object.rings=4096",
    );
    let needs = english!("render-too-many-triangles", triangles = "", megabytes = "|");
    let (_, memory) = needs.split_once('|').expect("a figure");
    let says = |harness: &Harness<'_, App>| {
        let figure = harness.query_all_by_label_contains(memory).next();
        figure.is_some()
    };
    assert!(wait(&mut harness, says));
    open(&mut harness, "?scene=cube");
    assert!(wait(&mut harness, |harness| picture(harness) == cube));
    assert!(!says(&harness));
}
