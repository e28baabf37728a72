//! The scan line in slow motion, in the window: buttons, keys, playback, and display.

use crate::common::hands::{enter, open_view, press, scene, window};
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use shading_lab::analysis::scan::{Scan, ScanLevel, scan};
use shading_lab::app::{App, ScanView, ViewName};
use shading_lab::render::Renderer;
use shading_lab::scene::ShadingMode;

/// Opens a window with the tab open, Gouraud shading.
fn opened(name: &str) -> Harness<'static, App> {
    let mut harness = window(name);
    harness.key_press(Key::Num3);
    harness.run();
    open_view(&mut harness, "view-scan-line");
    assert_eq!(
        harness.state().state().window.appearance.view,
        ViewName::ScanLine
    );
    harness
}

fn step(harness: &Harness<'_, App>) -> usize {
    harness
        .state()
        .state()
        .window
        .own
        .get::<ScanView>()
        .expect("the tab is shown")
        .step()
}

fn shown<'h>(harness: &'h Harness<'_, App>) -> &'h Scan {
    harness
        .state()
        .state()
        .window
        .own
        .get::<ScanView>()
        .expect("the tab is shown")
        .ready()
        .expect("a polygon under the probe")
}

fn key(harness: &mut Harness<'_, App>, key: Key) {
    harness.key_press(key);
    harness.run();
}

#[test]
fn buttons_and_keys_walk_by_pixel_edge_and_line() {
    let mut harness = opened("flat-facets");
    let scan = shown(&harness).clone();
    let start = step(&harness);
    assert!(
        scan.at(start).pixel.is_some(),
        "it begins at the pixel under the probe"
    );
    let ways = [
        ("pixel", Key::Comma, Key::Period, ScanLevel::Pixel),
        ("edge", Key::OpenBracket, Key::CloseBracket, ScanLevel::Edge),
        ("line", Key::PageUp, Key::PageDown, ScanLevel::Line),
    ];
    for (name, back, forward, level) in ways {
        key(&mut harness, Key::Home);
        press(&mut harness, &format!("line-scan-{name}-forward"));
        let first = scan.forward(0, level);
        assert_eq!(step(&harness), first, "{name}");
        key(&mut harness, forward);
        assert_eq!(step(&harness), scan.forward(first, level), "{name}");
        press(&mut harness, &format!("line-scan-{name}-back"));
        assert_eq!(step(&harness), first, "{name}");
        key(&mut harness, back);
        assert_eq!(step(&harness), 0, "{name}");
    }
    press(&mut harness, "line-scan-last");
    assert_eq!(step(&harness), scan.last());
    press(&mut harness, "line-scan-first");
    assert_eq!(step(&harness), 0);
    harness
        .get_by_role_and_label(Role::Slider, english!("line-scan-step"))
        .set_value_accesskit(33.0);
    harness.run();
    assert_eq!(step(&harness), 33);
    for _ in 0..3 {
        key(&mut harness, Key::C);
    }
    key(&mut harness, Key::Period);
    assert_eq!(step(&harness), 33, "the keys are the tab's");
}

#[test]
fn it_plays_until_the_end_and_asks_for_frames_only_then() {
    let mut harness = opened("flat-facets");
    key(&mut harness, Key::Home);
    enter(&mut harness, "line-scan-speed.name", 8.0);
    harness.key_press(Key::Space);
    for _ in 0..12 {
        harness.step();
    }
    let reached = step(&harness);
    assert!(
        reached > 3
            && harness
                .state()
                .state()
                .window
                .own
                .get::<ScanView>()
                .expect("the tab is shown")
                .is_playing(),
        "{reached}"
    );
    press(&mut harness, "line-scan-pause");
    let paused = step(&harness);
    for _ in 0..10 {
        harness.step();
    }
    assert_eq!(step(&harness), paused);
    assert!(
        !harness
            .state()
            .state()
            .window
            .own
            .get::<ScanView>()
            .expect("the tab is shown")
            .is_playing()
    );
    press(&mut harness, "line-scan-last");
    for _ in 0..5 {
        key(&mut harness, Key::Comma);
    }
    harness.key_press(Key::Space);
    for _ in 0..60 {
        harness.step();
    }
    assert_eq!(step(&harness), shown(&harness).last());
    // Idle again: a window that goes on asking for frames would not settle.
    harness.run();
    assert!(
        harness
            .query_by_role_and_label(Role::Button, english!("line-scan-play"))
            .is_some()
    );
}

#[test]
fn what_is_shown_is_the_scan_of_the_polygon_under_the_probe() {
    let mut harness = opened("flat-facets");
    let frame = harness.state().frame();
    let mut sized = scene(&harness).clone();
    sized.image.size = [frame.width, frame.height];
    let taken = shown(&harness).clone();
    assert_eq!(
        scan(
            &mut Renderer::default(),
            &sized,
            taken.face,
            Scan::USUAL_ROWS
        )
        .as_ref(),
        Ok(&taken)
    );
    let point = taken.at(step(&harness));
    let (Some(span), Some(pixel)) = (point.span, point.pixel) else {
        panic!("a pixel's step")
    };
    let has = |harness: &Harness<'_, App>, text: &str| {
        harness
            .query_all_by(|node| {
                [node.label(), node.value()]
                    .into_iter()
                    .flatten()
                    .any(|t| t.contains(text))
            })
            .next()
            .is_some()
    };
    let mix = taken.found(step(&harness)).pop().expect("a pixel's step");
    let [r, g, b] = pixel.stored;
    for text in [
        mix.alpha_text(),
        mix.row(0),
        english!("line-scan-stored", r = r, g = g, b = b),
        format!("{:.3}", span.q.value.x),
    ] {
        assert!(has(&harness, &text), "{text}");
    }
    assert!(
        has(&harness, english!("line-scan-edge-table"))
            && has(&harness, &english!("found-corners", count = 4))
    );
    // Another polygon starts another scan; another view of the same polygon keeps the position in it.
    for _ in 0..9 {
        harness.key_press_modifiers(Modifiers::SHIFT, Key::ArrowDown);
        harness.run();
    }
    assert!(shown(&harness).face != taken.face);
    let face = shown(&harness).face;
    let line = shown(&harness).at(step(&harness)).line.y;
    enter(&mut harness, "line-scan-rows.name", 32.0);
    assert_eq!(
        (shown(&harness).grid.rows, shown(&harness).face),
        (32, face)
    );
    assert!(shown(&harness).at(step(&harness)).line.y.abs_diff(2 * line) <= 2);
    for _ in 0..40 {
        harness.key_press_modifiers(Modifiers::SHIFT, Key::ArrowRight);
        harness.run();
    }
    assert!(
        harness
            .state()
            .state()
            .window
            .own
            .get::<ScanView>()
            .expect("the tab is shown")
            .ready()
            .is_none()
    );
    assert!(has(&harness, english!("line-scan-background")));
}

#[test]
fn every_shading_mode_is_shown_without_a_missing_letter() {
    let mut harness = opened("teapot");
    for (mode, wanted) in [
        (Key::Num1, ShadingMode::Flat),
        (Key::Num2, ShadingMode::Interpolated),
        (Key::Num4, ShadingMode::Phong),
        (Key::Num5, ShadingMode::Phong),
        (Key::Num6, ShadingMode::Phong),
    ] {
        key(&mut harness, mode);
        assert_eq!(shown(&harness).mode, wanted);
        for walk in [
            "line-scan-line-back",
            "line-scan-edge-forward",
            "line-scan-edge-forward",
            "line-scan-pixel-forward",
        ] {
            press(&mut harness, walk);
        }
        assert!(shown(&harness).at(step(&harness)).pixel.is_some());
    }
}
